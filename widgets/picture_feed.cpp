#include "widgets/picture_feed.h"

#include "core/figure/figure_json.h"
#include "renderer/export/picture_file.h"

#include <utility>

namespace limner {
namespace {

QImage imageOf(const Picture& picture, const PictureOptions& options) {
    auto* bytes = new std::vector<std::uint8_t>(toRgba8(picture, options));
    const glm::ivec2 size = picture.size();
    // The image owns the bytes: no copy.
    return QImage(
        bytes->data(), size.x, size.y, 4 * size.x,
        options.transparent ? QImage::Format_RGBA8888 : QImage::Format_RGBX8888,
        [](void* owned) { delete static_cast<std::vector<std::uint8_t>*>(owned); }, bytes);
}

/// A figure without what is written over it.
Figure unlettered(const Figure& figure) {
    Figure rest = figure;
    rest.annotations.clear();
    rest.annotationLayout.clear();
    return rest;
}

/// The plan as if it had been made for another figure that differs in its annotations alone.
std::shared_ptr<const RenderPlan> planFor(const std::shared_ptr<const RenderPlan>& plan,
                                          const std::shared_ptr<const Figure>& figure) {
    auto again = std::make_shared<RenderPlan>(*plan);
    // The plan's layers point into the old figure: it lives as long as the new one.
    again->figure = std::shared_ptr<const Figure>(figure.get(), [figure, old = plan->figure](const Figure*) {});
    return again;
}

} // namespace

PictureFeed::PictureFeed(RenderThread::PlanFunction plan, std::unique_ptr<const Backend> backend, QObject* parent)
    : QObject(parent) {
    letterer_.setMaxThreadCount(1);
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

PictureFeed::~PictureFeed() {
    letterer_.clear();
    letterer_.waitForDone();
}

void PictureFeed::want(std::shared_ptr<const Figure> figure, QSize pixels, bool draftsOnly) {
    if (!figure || !figure->volume || !figure->volume->data || pixels.isEmpty()) {
        clear();
        return;
    }
    if (letterAgain(figure, pixels))
        return;
    const std::uint64_t number = thread_->request({std::move(figure), {pixels.width(), pixels.height()}, draftsOnly});
    const std::lock_guard lock(mutex_);
    asked_ = number;
    ++lettering_;
}

void PictureFeed::clear() {
    thread_->clear();
    const std::lock_guard lock(mutex_);
    ++lettering_;
    still_.reset();
    newest_.reset();
}

bool PictureFeed::letterAgain(const std::shared_ptr<const Figure>& figure, QSize pixels) {
    std::optional<DeliveredPicture> still;
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(mutex_);
        if (!still_ || still_->picture->size() != glm::ivec2(pixels.width(), pixels.height()))
            return false;
        if (diff(unlettered(*still_->plan->figure), unlettered(*figure)) != ChangeCost::none)
            return false;
        still = still_;
        passedOver_ = asked_;
        number = ++lettering_;
    }
    thread_->clear();
    letterer_.clear();
    letterer_.start([this, number, figure, still = std::move(*still)]() mutable {
        const auto outdated = [&] {
            const std::lock_guard lock(mutex_);
            return lettering_ != number;
        };
        if (outdated())
            return;
        still.plan = planFor(still.plan, figure);
        ScreenPicture picture = compose(still);
        if (!outdated())
            post(std::move(picture));
    });
    return true;
}

ScreenPicture PictureFeed::compose(const DeliveredPicture& delivered) {
    PictureOptions options = pictureOptions(*delivered.plan->figure);
    ScreenPicture picture{{}, delivered.plan, delivered.facts, {}};
    const auto tell = [this](const Error& error) {
        QMetaObject::invokeMethod(
            this, [this, error] { Q_EMIT failed(error); }, Qt::QueuedConnection);
    };
    std::shared_ptr<const Picture> lettered = delivered.picture;
    try {
        DrawnAnnotations annotations = annotationsOf(*delivered.plan, options);
        if (!annotations.empty()) {
            auto copy = std::make_shared<Picture>(*delivered.picture);
            layAnnotations(annotations, copy->size(), {{0, 0}, copy->size()}, *copy);
            lettered = std::move(copy);
        }
        picture.annotations = std::move(annotations.places);
    } catch (const Error& error) { // no font: the figure itself is there
        tell(error);
    }
    try {
        picture.image = imageOf(*lettered, options);
    } catch (const Error& error) { // of the picture behind the figure
        options.backgroundPicture = nullptr;
        picture.image = imageOf(*lettered, options);
        tell(error);
    }
    return picture;
}

void PictureFeed::deliver(DeliveredPicture delivered) {
    ScreenPicture picture = compose(delivered);
    {
        const std::lock_guard lock(mutex_);
        if (delivered.facts.request <= passedOver_)
            return;
        if (delivered.facts.final)
            still_ = std::move(delivered);
    }
    post(std::move(picture));
}

void PictureFeed::post(ScreenPicture picture) {
    bool first = false;
    {
        const std::lock_guard lock(mutex_);
        newest_ = std::move(picture);
        first = !std::exchange(posted_, true);
    }
    if (first)
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
