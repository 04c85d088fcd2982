#pragma once

#include "renderer/interactive/render_thread.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>

#include <memory>
#include <mutex>
#include <optional>

namespace limner {

/// A picture ready for a screen, laid over the figure's background.
struct ScreenPicture {
    QImage image;                           ///< has an alpha channel where the figure's output is transparent
    std::shared_ptr<const RenderPlan> plan; ///< with the figure it shows
    PictureFacts facts;
};

/// Brings the render thread's pictures to the interface's thread. Only the newest one waits: a busy window skips
/// pictures, it never queues them.
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
    void pass();

    std::mutex mutex_;
    std::optional<ScreenPicture> newest_;
    bool posted_ = false;
    std::unique_ptr<RenderThread> thread_; ///< last: it calls back into this object
};

} // namespace limner
