#include "renderer/gl/gl_backend.h"

#include "core/base/error.h"
#include "renderer/gl/casting.h"
#include "renderer/gl/dots.h"
#include "renderer/marks/draw_marks.h"
#include "renderer/marks/ink.h"
#include "renderer/marks/lay_marks.h"

#include <mutex>
#include <optional>

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
        RenderResult result;
        withDevice([&] { result = gl::castTile(*device_, memory_->casting, plan, tile, task); });
        return result;
    }

    [[nodiscard]] bool laysDots(const RenderPlan& plan) const override { return gl::canDrawDots(facts_, plan); }
    void layDots(const RenderPlan& plan, const Tile& tile, Picture& picture, Task& task) const override {
        std::optional<std::vector<float>> through;
        if (laysDots(plan)) {
            withDevice([&] { through = gl::DotDrawing(*device_, memory_->dots, plan, task).drawTile(tile); });
        }
        if (!through) {
            return Backend::layDots(plan, tile, picture, task); // more than the card holds
        }
        layInk(*through, plainInk(*plan.figure->stipple), orderOf(*plan.figure->stipple), picture);
    }
    [[nodiscard]] std::vector<Dot> dotsOf(const RenderPlan& plan, Task& task) const override {
        std::vector<Dot> dots;
        if (laysDots(plan)) {
            withDevice([&] { dots = gl::DotDrawing(*device_, memory_->dots, plan, task).list(); });
        }
        return dots;
    }

  private:
    /// Draws with a device that is current, again with a new one where it was lost.
    template <typename Draw>
    void withDevice(const Draw& draw) const {
        const std::lock_guard lock(mutex_);
        constexpr int kAttempts = 3; // a card that is reset by this very picture must not be asked for ever
        for (int attempt = 1;; ++attempt) {
            if (!device_ || !device_->makeCurrent()) {
                close();
                open();
            }
            try {
                draw();
                const bool lost = device_->isLost();
                keepComplaints();
                if (!lost) {
                    device_->release();
                    return;
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

    void open() const {
        device_ = std::make_unique<gl::Device>(contexts_());
        kept_ = 0;
        memory_ = std::make_unique<Memory>();
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
    struct Memory {
        gl::CastingMemory casting;
        gl::DotMemory dots;
    };
    mutable std::unique_ptr<Memory> memory_; // goes before its device
    mutable std::vector<std::string> complaints_;
    mutable std::ptrdiff_t kept_ = 0;
};

} // namespace

std::unique_ptr<GlBackend> makeGlBackend(gl::ContextFactory contexts) {
    return std::make_unique<ContextBackend>(std::move(contexts));
}

} // namespace limner
