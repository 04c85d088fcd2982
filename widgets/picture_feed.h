#pragma once

#include "renderer/annotations.h"
#include "renderer/interactive/render_thread.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>
#include <QThreadPool>

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace limner {

/// A picture ready for a screen: laid over the figure's background, its annotations over it, as an export has them.
struct ScreenPicture {
    QImage image;                           ///< has an alpha channel where the figure's output is transparent
    std::shared_ptr<const RenderPlan> plan; ///< with the figure it shows
    PictureFacts facts;
    std::vector<AnnotationPlace> annotations; ///< where the figure's annotations stand
};

/// Brings the render thread's pictures to the interface's thread. Only the newest one waits: a busy window skips
/// pictures, it never queues them. A figure that differs from the shown still in its annotations alone is lettered anew
/// without rendering.
class PictureFeed : public QObject {
    Q_OBJECT

  public:
    PictureFeed(RenderThread::PlanFunction plan, std::unique_ptr<const Backend> backend, QObject* parent = nullptr);
    ~PictureFeed() override;

    /// Asks for pictures of a figure; `draftsOnly` while a gesture is going on. A figure without volume data, or an
    /// empty size, clears.
    void want(std::shared_ptr<const Figure> figure, QSize pixels, bool draftsOnly);
    void clear();
    /// Waits for the still; for tests.
    void waitIdle() { thread_->waitIdle(); }

  Q_SIGNALS:
    void arrived(const limner::ScreenPicture& picture);
    void failed(const limner::Error& error);
    void preparing(const QString& phase, double fraction);

  private:
    void deliver(DeliveredPicture delivered);
    /// Background and annotations; off the interface's thread.
    ScreenPicture compose(const DeliveredPicture& delivered);
    void post(ScreenPicture picture);
    void pass();
    /// Letters the kept still anew where that is all the figure asks for.
    bool letterAgain(const std::shared_ptr<const Figure>& figure, QSize pixels);

    std::mutex mutex_;
    std::optional<ScreenPicture> newest_;
    bool posted_ = false;
    std::optional<DeliveredPicture> still_; ///< the newest final one, without annotations
    std::uint64_t asked_ = 0;               ///< number of the render thread's newest request
    std::uint64_t passedOver_ = 0;          ///< requests up to this one have nothing more to say
    std::uint64_t lettering_ = 0;           ///< of the newest lettering; older ones stop
    QThreadPool letterer_;                  ///< one thread
    std::unique_ptr<RenderThread> thread_;  ///< last: it calls back into this object
};

} // namespace limner
