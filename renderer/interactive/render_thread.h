#pragma once

#include "core/base/error.h"
#include "renderer/backend.h"
#include "renderer/interactive/draft_pace.h"
#include "renderer/plan/planner.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace limner {

/// What the window wants to see.
struct ViewRequest {
    std::shared_ptr<const Figure> figure; ///< its volume resolved
    glm::ivec2 size{0};                   ///< pixels of the still
    bool draftsOnly = false;              ///< a drag is going on: no refinement
};

/// What a delivered picture is; for a status line.
struct PictureFacts {
    std::uint64_t request = 0; ///< the number `request` gave
    bool final = false;        ///< nothing finer of this request follows
    Coarseness coarseness;     ///< how it was made
    double planMs = 0;         ///< spent on planning
    double renderMs = 0;       ///< spent on rendering
    double sinceRequestMs = 0; ///< from the request to the delivery
    std::uint64_t samples = 0;
    std::uint64_t shaded = 0;
    std::uint64_t dots = 0; ///< marks of ink
    std::uint64_t strokes = 0;
    std::string backend;
    std::vector<std::string> warnings; ///< what the plan or the renderer has to say, one line each
};

struct DeliveredPicture {
    std::shared_ptr<const Picture> picture; ///< premultiplied, without the background
    std::shared_ptr<const RenderPlan> plan; ///< what it was made of
    PictureFacts facts;
};

/// Called on the worker thread; they must return soon and not call back into the RenderThread's destructor.
struct RenderCallbacks {
    std::function<void(DeliveredPicture)> delivered;
    std::function<void(std::uint64_t request, const Error& error)> failed;
    /// Preparing a figure (clean-up, fields) can take seconds the first time.
    std::function<void(const std::string& phase, double fraction)> progressed;
};

/// One worker that turns the newest request into pictures: a draft in time, then finer ones up to the still. A newer
/// request stops the running job; only a draft of the same drag may finish, or a fast hand would never see one, and
/// only preparations that the newer request needs as well go on. All members may be called from any thread.
class RenderThread {
  public:
    using PlanFunction = std::function<std::shared_ptr<const RenderPlan>(const Figure&, const PlanRequest&, Task&)>;

    struct Options {
        double draftBudgetMs = 45; ///< two of them, one to be replaced and the next, stay under 100 ms
    };

    /// With a planner of its own.
    RenderThread(std::unique_ptr<const Backend> backend, RenderCallbacks callbacks, Options options);
    RenderThread(std::unique_ptr<const Backend> backend, RenderCallbacks callbacks);
    /// With another way of planning.
    RenderThread(PlanFunction plan, std::unique_ptr<const Backend> backend, RenderCallbacks callbacks, Options options);
    /// Stops the running job and waits for it: at most the backend's 20 ms, or the planner's.
    ~RenderThread();
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    /// Replaces whatever was asked before. Returns at once, with the request's number.
    std::uint64_t request(ViewRequest request);
    /// Forgets the newest request and stops the running job.
    void clear();
    /// Waits until nothing is asked for or under way. For tests and tidy ends.
    void waitIdle();

  private:
    using Clock = std::chrono::steady_clock;
    struct Numbered {
        ViewRequest view;
        std::uint64_t number = 0;
        Clock::time_point since;
    };
    enum class Stage { idle, planning, draft, refining };
    class Progress;

    void run();
    void serve(const Numbered& job);
    [[nodiscard]] std::vector<Coarseness> stages(const ViewRequest& view) const;
    bool renderStage(const Numbered& job, const Coarseness& coarseness, bool last);
    [[nodiscard]] bool mustStop(const ViewRequest& newer) const;
    /// Makes `task` the running one, unless a newer request came.
    bool enter(Stage stage, const Numbered& job, const std::shared_ptr<Task>& task);

    PlanFunction plan_;
    std::unique_ptr<const Backend> backend_;
    RenderCallbacks callbacks_;
    Options options_;
    DraftPace pace_; ///< of the worker alone

    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Numbered> next_;
    std::optional<ViewRequest> current_; ///< being served
    std::shared_ptr<Task> task_;         ///< the running stage's
    Stage stage_ = Stage::idle;
    Clock::time_point stageStart_;
    std::uint64_t numbers_ = 0;
    bool stopping_ = false;
    std::thread thread_; ///< last: starts when all else stands
};

} // namespace limner
