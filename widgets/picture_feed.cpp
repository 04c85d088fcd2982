#include "widgets/picture_feed.h"

#include "renderer/export/picture_file.h"

#include <utility>

namespace limner {
namespace {

QImage imageOf(const DeliveredPicture& delivered, const PictureOptions& options) {
    auto* bytes = new std::vector<std::uint8_t>(toRgba8(*delivered.picture, options));
    const glm::ivec2 size = delivered.picture->size();
    // The image owns the bytes: no copy.
    return QImage(
        bytes->data(), size.x, size.y, 4 * size.x,
        options.transparent ? QImage::Format_RGBA8888 : QImage::Format_RGBX8888,
        [](void* owned) { delete static_cast<std::vector<std::uint8_t>*>(owned); }, bytes);
}

} // namespace

PictureFeed::PictureFeed(RenderThread::PlanFunction plan, std::unique_ptr<const Backend> backend, QObject* parent)
    : QObject(parent) {
    RenderCallbacks callbacks;
    callbacks.delivered = [this](DeliveredPicture picture) { deliver(std::move(picture)); };
    callbacks.failed = [this](std::uint64_t, const Error& error) {
        QMetaObject::invokeMethod(
            this, [this, error] { Q_EMIT failed(error); }, Qt::QueuedConnection);
    };
    callbacks.progressed = [this](const std::string& phase, double fraction) {
        const QString text = QString::fromStdString(phase);
        QMetaObject::invokeMethod(
            this, [=, this] { Q_EMIT preparing(text, fraction); }, Qt::QueuedConnection);
    };
    thread_ = std::make_unique<RenderThread>(std::move(plan), std::move(backend), std::move(callbacks),
                                             RenderThread::Options{});
}

PictureFeed::~PictureFeed() = default;

void PictureFeed::want(std::shared_ptr<const Figure> figure, QSize pixels, bool draftsOnly) {
    if (!figure || !figure->volume || !figure->volume->data || pixels.isEmpty()) {
        clear();
        return;
    }
    thread_->request({std::move(figure), {pixels.width(), pixels.height()}, draftsOnly});
}

void PictureFeed::clear() {
    thread_->clear();
    const std::lock_guard lock(mutex_);
    newest_.reset();
}

void PictureFeed::deliver(DeliveredPicture delivered) {
    PictureOptions options = pictureOptions(*delivered.plan->figure);
    ScreenPicture picture{{}, delivered.plan, delivered.facts};
    try {
        picture.image = imageOf(delivered, options);
    } catch (const Error& error) { // of the picture behind the figure: the figure itself is there
        options.backgroundPicture = nullptr;
        picture.image = imageOf(delivered, options);
        QMetaObject::invokeMethod(
            this, [this, error] { Q_EMIT failed(error); }, Qt::QueuedConnection);
    }
    bool post = false;
    {
        const std::lock_guard lock(mutex_);
        newest_ = std::move(picture);
        post = !std::exchange(posted_, true);
    }
    if (post)
        QMetaObject::invokeMethod(
            this, [this] { pass(); }, Qt::QueuedConnection);
}

void PictureFeed::pass() {
    std::optional<ScreenPicture> picture;
    {
        const std::lock_guard lock(mutex_);
        posted_ = false;
        picture = std::exchange(newest_, std::nullopt);
    }
    if (picture)
        Q_EMIT arrived(*picture);
}

} // namespace limner
