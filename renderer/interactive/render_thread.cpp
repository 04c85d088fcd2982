#include "renderer/interactive/render_thread.h"

#include "renderer/marks/marked_picture.h"
#include "renderer/plan/picture_warnings.h"

#include <utility>

namespace limner {
namespace {

double millisecondsBetween(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

/// Whether preparations for one figure serve the other: they read the same cleaned volume.
bool samePreparations(const Figure& a, const Figure& b) {
    const auto data = [](const Figure& figure) { return figure.volume ? figure.volume->data.get() : nullptr; };
    return data(a) == data(b) && a.labels == b.labels && a.cleanup == b.cleanup &&
           a.quality.gradient == b.quality.gradient;
}

} // namespace

/// Hands the preparations' progress on.
class RenderThread::Progress : public TaskListener {
  public:
    explicit Progress(const RenderCallbacks& callbacks) : callbacks_(callbacks) {}
    void progressed(const std::string& phase, double fraction) override {
        if (callbacks_.progressed)
            callbacks_.progressed(phase, fraction);
    }
    void warned(const std::string&) override {} // the task keeps them for the facts

  private:
    const RenderCallbacks& callbacks_;
};

RenderThread::RenderThread(PlanFunction plan, std::unique_ptr<const Backend> backend, RenderCallbacks callbacks,
                           Options options)
    : plan_(std::move(plan)), backend_(std::move(backend)), callbacks_(std::move(callbacks)), options_(options),
      pace_(options.draftBudgetMs), thread_([this] { run(); }) {}

RenderThread::~RenderThread() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        next_.reset();
        if (task_)
            task_->cancel();
    }
    changed_.notify_all();
    thread_.join();
}

bool RenderThread::mustStop(const ViewRequest& newer) const {
    switch (stage_) {
    case Stage::idle: return false;
    case Stage::planning: return !samePreparations(*current_->figure, *newer.figure);
    case Stage::draft: {
        const bool sameDrag = current_->draftsOnly && newer.draftsOnly;
        // A draft that takes three times its budget was chosen wrongly; the next is coarser.
        return !sameDrag || millisecondsBetween(stageStart_, Clock::now()) > 3 * options_.draftBudgetMs;
    }
    case Stage::refining: return true;
    }
    return true;
}

std::uint64_t RenderThread::request(ViewRequest request) {
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(mutex_);
        if (task_ && mustStop(request))
            task_->cancel();
        number = ++numbers_;
        next_ = Numbered{std::move(request), number, Clock::now()};
    }
    changed_.notify_all();
    return number;
}

void RenderThread::clear() {
    {
        const std::lock_guard lock(mutex_);
        next_.reset();
        ++numbers_;
        if (task_)
            task_->cancel();
    }
    changed_.notify_all();
}

void RenderThread::waitIdle() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopping_ || (!next_ && !current_); });
}

void RenderThread::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return stopping_ || next_; });
        if (stopping_)
            return;
        const Numbered job = *std::exchange(next_, std::nullopt);
        current_ = job.view;
        lock.unlock();
        try {
            serve(job);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::cancelled && callbacks_.failed)
                callbacks_.failed(job.number, error);
        } catch (const std::exception& error) { // memory, threads: the window must live on and say so
            if (callbacks_.failed)
                callbacks_.failed(job.number, Error(ErrorKind::noResources, {"cannot draw the figure", "", error.what(),
                                                                             "close other programs or crop"}));
        }
        lock.lock();
        current_.reset();
        task_.reset();
        stage_ = Stage::idle;
        changed_.notify_all();
    }
}

std::vector<Coarseness> RenderThread::stages(const ViewRequest& view) const {
    Coarseness still{1, 1, 1};
    while (still.subPixels < 4 && still.subPixels * still.subPixels < view.figure->quality.samplesPerPixel)
        still.subPixels *= 2;
    const Coarseness draft = pace_.draft(view.size);
    std::vector<Coarseness> list{draft};
    if (view.draftsOnly)
        return list;
    const Coarseness sharp{1, 1, 1};
    if (draft != sharp && still != sharp)
        list.push_back(sharp);
    if (draft != still)
        list.push_back(still);
    return list;
}

bool RenderThread::enter(Stage stage, const Numbered& job, const std::shared_ptr<Task>& task) {
    const std::lock_guard lock(mutex_);
    // A draft of the same drag is still worth finishing when something newer waits.
    const bool overtaken = numbers_ != job.number && !(next_ && next_->view.draftsOnly && job.view.draftsOnly);
    if (stopping_ || overtaken)
        return false;
    stage_ = stage;
    stageStart_ = Clock::now();
    task_ = task;
    return true;
}

void RenderThread::serve(const Numbered& job) {
    const std::vector<Coarseness> list = stages(job.view);
    for (std::size_t i = 0; i < list.size(); ++i)
        if (!renderStage(job, list[i], i + 1 == list.size()))
            return;
}

bool RenderThread::renderStage(const Numbered& job, const Coarseness& coarseness, bool last) {
    Progress progress(callbacks_);
    const auto planning = std::make_shared<Task>(progress);
    if (!enter(Stage::planning, job, planning))
        return false;
    const Clock::time_point start = Clock::now();
    PlanRequest wish;
    wish.size = DraftPace::pixels(job.view.size, coarseness);
    wish.stepScale = coarseness.stepScale;
    wish.subPixels = coarseness.subPixels;
    wish.moving = !last || job.view.draftsOnly;
    const std::shared_ptr<const RenderPlan> plan = plan_(*job.view.figure, wish, *planning);
    const Clock::time_point planned = Clock::now();
    pace_.prepared(millisecondsBetween(start, planned));

    const auto rendering = std::make_shared<Task>();
    const bool draft = coarseness != Coarseness{1, 1, coarseness.subPixels} || job.view.draftsOnly;
    if (!enter(draft ? Stage::draft : Stage::refining, job, rendering))
        return false;
    RenderResult result;
    PictureFacts facts;
    try {
        const MarkedPicture picture(*plan, *backend_, *rendering);
        result = picture.render({{0, 0}, plan->size}, *rendering);
        facts.dots = picture.dots();
        facts.strokes = picture.strokes();
    } catch (const Error&) {
        if (rendering->cancelled())
            pace_.measured(job.view.size, coarseness, millisecondsBetween(planned, Clock::now()), false);
        throw;
    }
    const Clock::time_point rendered = Clock::now();
    pace_.measured(job.view.size, coarseness, millisecondsBetween(planned, rendered), true);

    DeliveredPicture delivered;
    delivered.picture = std::make_shared<const Picture>(std::move(result.picture));
    delivered.plan = plan;
    facts.request = job.number;
    facts.final = last && !job.view.draftsOnly;
    facts.coarseness = coarseness;
    facts.planMs = millisecondsBetween(start, planned);
    facts.renderMs = millisecondsBetween(planned, rendered);
    facts.sinceRequestMs = millisecondsBetween(job.since, rendered);
    facts.samples = result.samples;
    facts.shaded = result.shaded;
    facts.backend = backend_->name();
    if (facts.final)
        for (std::string& warning : pictureWarnings(*plan))
            facts.warnings.push_back(std::move(warning));
    for (const Task* task : {planning.get(), rendering.get()})
        for (const std::string& warning : task->warnings())
            facts.warnings.push_back(warning);
    delivered.facts = std::move(facts);
    if (callbacks_.delivered)
        callbacks_.delivered(std::move(delivered));
    return true;
}

} // namespace limner
