#include "renderer/backend_choice.h"

#include "core/base/error.h"
#include "renderer/cpu/kernel.h"
#include "renderer/gl/gl_backend.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace limner {

namespace {

/// By the processor what the card cannot draw.
template <typename Draw>
auto drawnByEither(const Backend& card, const Backend& processor, Task& task, const Draw& draw) {
    try {
        return draw(card);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::noOpenGl && error.kind() != ErrorKind::noResources) {
            throw;
        }
        task.warn("Drawn by the processor: " + error.text().what + ", " + error.text().why + ".");
    }
    return draw(processor);
}

/// The card, and the processor for what the card cannot draw.
class WithFallback : public Backend {
  public:
    explicit WithFallback(std::unique_ptr<GlBackend> card) : card_(std::move(card)), processor_(makeCpuBackend()) {}

    [[nodiscard]] std::string name() const override { return card_->name(); }
    [[nodiscard]] const GlBackend& card() const { return *card_; }

    RenderResult render(const RenderPlan& plan, const Tile& tile, Task& task) const override {
        return drawnByEither(*card_, *processor_, task,
                             [&](const Backend& backend) { return backend.render(plan, tile, task); });
    }
    [[nodiscard]] bool laysDots(const RenderPlan& plan) const override { return card_->laysDots(plan); }
    void layDots(const RenderPlan& plan, const Tile& tile, Picture& picture, Task& task) const override {
        drawnByEither(*card_, *processor_, task,
                      [&](const Backend& backend) { backend.layDots(plan, tile, picture, task); });
    }

  private:
    std::unique_ptr<GlBackend> card_;
    std::unique_ptr<Backend> processor_;
};

BackendChoice choose(const std::string& glLibrary) {
    if (!gl::hasGraphicsDevice()) {
        return {"cpu", "no graphics device"};
    }
    try {
        const gl::ContextFacts facts = gl::probe(gl::contextFactory(glLibrary));
        if (facts.software) {
            return {"cpu", "OpenGL is drawn by the processor: " + facts.renderer};
        }
        return {"gl", facts.renderer};
    } catch (const Error& error) {
        return {"cpu", "no OpenGL: " + error.text().why};
    }
}

void checkName(const std::vector<std::string>& known, const std::string& name, const char* what) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
        std::string all;
        for (const std::string& one : known) {
            all += (all.empty() ? "" : &one == &known.back() ? " or " : ", ") + one;
        }
        throw Error(ErrorKind::usage, {std::string("there is no such ") + what, name, "", "use " + all});
    }
}

} // namespace

const std::vector<std::string>& backendNames() {
    static const std::vector<std::string> names{"auto", "cpu", "gl", "reference"};
    return names;
}

const std::vector<std::string>& glLibraryNames() { return gl::contextLibraries(); }

const BackendChoice& automaticBackend(const std::string& glLibrary) {
    static std::mutex mutex;
    static std::map<std::string, BackendChoice> known;
    const std::lock_guard lock(mutex);
    const auto found = known.find(glLibrary);
    return found != known.end() ? found->second : known.emplace(glLibrary, choose(glLibrary)).first->second;
}

std::unique_ptr<Backend> makeBackend(const std::string& name, const std::string& glLibrary) {
    checkName(backendNames(), name, "backend");
    checkName(glLibraryNames(), glLibrary, "OpenGL library");
    if (name == "gl") {
        return makeGlBackend(gl::contextFactory(glLibrary));
    }
    if (name == "auto" && automaticBackend(glLibrary).name == "gl") {
        return std::make_unique<WithFallback>(makeGlBackend(gl::contextFactory(glLibrary)));
    }
    return name == "reference" ? makeReferenceBackend() : makeCpuBackend();
}

std::string backendDetail(const Backend& backend) {
    if (const auto* both = dynamic_cast<const WithFallback*>(&backend)) {
        return backendDetail(both->card());
    }
    if (const auto* card = dynamic_cast<const GlBackend*>(&backend)) {
        return card->facts().renderer;
    }
    return backend.name() == "cpu" ? kernelTargets().front() : "";
}

} // namespace limner
