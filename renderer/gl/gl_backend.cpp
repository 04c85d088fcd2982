#include "renderer/gl/gl_backend.h"

#include "core/base/error.h"
#include "renderer/gl/casting.h"

#include <mutex>

namespace limner {

namespace {

class ContextBackend : public GlBackend {
  public:
    explicit ContextBackend(gl::ContextFactory contexts) : contexts_(std::move(contexts)) {
        open();
        facts_ = device_->facts();
        device_->release();
    }
    ~ContextBackend() override { close(); }
    ContextBackend(const ContextBackend&) = delete;
    ContextBackend& operator=(const ContextBackend&) = delete;

    [[nodiscard]] std::string name() const override { return "gl"; }
    [[nodiscard]] gl::ContextFacts facts() const override { return facts_; }

    void loseContext() override {
        const std::lock_guard lock(mutex_);
        device_->lose();
    }
    [[nodiscard]] std::vector<std::string> complaints() const override {
        const std::lock_guard lock(mutex_);
        return complaints_;
    }
    void setRoom(std::uint64_t bytes) override {
        const std::lock_guard lock(mutex_);
        room_ = bytes;
        device_->setRoom(bytes);
    }

    RenderResult render(const RenderPlan& plan, const Tile& tile, Task& task) const override {
        const std::lock_guard lock(mutex_);
        constexpr int kAttempts = 3; // a card that is reset by this very picture must not be asked for ever
        for (int attempt = 1;; ++attempt) {
            if (!device_ || !device_->makeCurrent()) {
                close();
                open();
            }
            try {
                RenderResult result = gl::castTile(*device_, *memory_, plan, tile, task);
                const bool lost = device_->isLost();
                keepComplaints();
                if (!lost) {
                    device_->release();
                    return result;
                }
            } catch (...) {
                const bool lost = device_->isLost();
                keepComplaints();
                if (!lost || attempt == kAttempts) {
                    device_->release();
                    throw;
                }
            }
            if (attempt == kAttempts) {
                throw Error(ErrorKind::noOpenGl, {"the graphics card was reset while drawing", "", "",
                                                  "render with the backend cpu, or at a smaller size"});
            }
        }
    }

  private:
    void open() const {
        device_ = std::make_unique<gl::Device>(contexts_());
        kept_ = 0;
        memory_ = std::make_unique<gl::CastingMemory>();
        if (room_ > 0) {
            device_->setRoom(room_);
        }
    }
    void close() const {
        if (device_ && !device_->makeCurrent()) {
            device_->lose();
        }
        memory_.reset();
        device_.reset();
    }
    void keepComplaints() const {
        complaints_.insert(complaints_.end(), device_->complaints().begin() + kept_, device_->complaints().end());
        kept_ = static_cast<std::ptrdiff_t>(device_->complaints().size());
    }

    gl::ContextFactory contexts_;
    gl::ContextFacts facts_;
    std::uint64_t room_ = 0;
    mutable std::mutex mutex_;
    mutable std::unique_ptr<gl::Device> device_;
    mutable std::unique_ptr<gl::CastingMemory> memory_; // goes before its device
    mutable std::vector<std::string> complaints_;
    mutable std::ptrdiff_t kept_ = 0;
};

} // namespace

std::unique_ptr<GlBackend> makeGlBackend(gl::ContextFactory contexts) {
    return std::make_unique<ContextBackend>(std::move(contexts));
}

} // namespace limner
