#include "widgets/clip_overlay.h"

#include "widgets/picture_handle.h"
#include "widgets/viewport.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <QEvent>
#include <QPainter>

#include <algorithm>

namespace limner {
namespace {

constexpr std::size_t kSides = 6;
constexpr double kThinnestMm = 0.1;         // a box always has a volume
constexpr double kLeastPixelsPerMm2 = 0.01; // squared: below it a drag across the screen would move a side by metres
constexpr double kMmPerKey = 1;

glm::dvec3 axisOf(std::size_t side) {
    glm::dvec3 axis(0);
    axis[static_cast<glm::length_t>(side / 2)] = side % 2 ? 1 : -1;
    return axis;
}

} // namespace

ClipOverlay::ClipOverlay(Viewport* viewport) : QWidget(viewport), viewport_(viewport) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    viewport->installEventFilter(this);
    setGeometry(viewport->rect());
    hide();
}

void ClipOverlay::setFigure(std::shared_ptr<const Figure> figure) {
    figure_ = std::move(figure);
    setVisible(figure_ && gripCount() > 0);
    placeGrips();
    update();
}

std::size_t ClipOverlay::gripCount() const {
    if (!figure_)
        return 0;
    const Clip& clip = figure_->clip;
    return clip.planes.empty() && !clip.boxMm ? 0 : kSides + clip.planes.size();
}

PictureHandle* ClipOverlay::boxGrip(std::size_t side) const {
    const auto found = std::ranges::find(grips_, side, &Grip::index);
    return found == grips_.end() || found->handle->isHidden() ? nullptr : found->handle;
}

PictureHandle* ClipOverlay::planeGrip(std::size_t plane) const { return boxGrip(kSides + plane); }

std::optional<QPointF> ClipOverlay::onScreen(const glm::dvec3& pointMm) const {
    return viewport_->onScreen(*figure_, pointMm);
}

glm::dvec3 ClipOverlay::outward(std::size_t index, const Clip& clip) {
    return index < kSides ? axisOf(index) : clip.planes.at(index - kSides).normal;
}

std::optional<glm::dvec3> ClipOverlay::anchor(std::size_t index, const Clip& clip) const {
    if (index < kSides) {
        if (!clip.boxMm)
            return std::nullopt;
        glm::dvec3 middle = (clip.boxMm->low + clip.boxMm->high) / 2.0;
        const auto axis = static_cast<glm::length_t>(index / 2);
        middle[axis] = index % 2 ? clip.boxMm->high[axis] : clip.boxMm->low[axis];
        return middle;
    }
    // The point of the plane that is nearest to what the picture's middle shows.
    const ClipPlane& plane = clip.planes.at(index - kSides);
    const double squared = glm::dot(plane.normal, plane.normal);
    if (squared <= 0)
        return std::nullopt;
    const glm::dvec3& target = figure_->camera.targetMm;
    return target + plane.normal * ((plane.offsetMm - glm::dot(plane.normal, target)) / squared);
}

QPointF ClipOverlay::pixelsPerMm(std::size_t index, const Clip& clip) const {
    const auto from = anchor(index, clip);
    if (!from)
        return {};
    const auto a = onScreen(*from);
    const auto b = onScreen(*from + glm::normalize(outward(index, clip)));
    return a && b ? *b - *a : QPointF();
}

void ClipOverlay::makeGrip(std::size_t index) {
    static const char* const kNames[] = {QT_TR_NOOP("Crop box: the patient's right side"),
                                         QT_TR_NOOP("Crop box: the patient's left side"),
                                         QT_TR_NOOP("Crop box: front"),
                                         QT_TR_NOOP("Crop box: back"),
                                         QT_TR_NOOP("Crop box: bottom"),
                                         QT_TR_NOOP("Crop box: top")};
    const QString name = index < kSides ? tr(kNames[index]) : tr("Clip plane %1").arg(index - kSides + 1);
    auto* handle =
        new PictureHandle(viewport_, index < kSides ? PictureHandle::Look::square : PictureHandle::Look::round,
                          tr("%1. Drag it, or use the arrow keys: 1 mm, with Shift 0.1 mm").arg(name));
    grips_.push_back({index, handle});
    connect(handle, &PictureHandle::pressed, this, [this] { pressed_ = figure_ ? figure_->clip : Clip{}; });
    connect(handle, &PictureHandle::dragged, this, [this, index](QPointF by, const std::string& key, bool ongoing) {
        if (index >= kSides + pressed_.planes.size()) // an undo took it away under the pointer
            return;
        const QPointF along = pixelsPerMm(index, pressed_);
        const double squared = QPointF::dotProduct(along, along);
        if (squared >= kLeastPixelsPerMm2)
            moveBy(index, QPointF::dotProduct(by, along) / squared, key, ongoing);
    });
    connect(handle, &PictureHandle::nudged, this, [this, index](double steps, const std::string& key) {
        pressed_ = figure_->clip;
        const QPointF along = pixelsPerMm(index, pressed_);
        const bool rightOrUp = along.x() - along.y() >= 0; // the arrow goes where the side goes on the screen
        moveBy(index, (rightOrUp ? steps : -steps) * kMmPerKey, key, false);
    });
    connect(handle, &PictureHandle::removeWanted, this, [this, index] {
        Edit edit{*figure_, tr("Remove cut").toStdString(), {}, false};
        if (index < kSides)
            edit.figure.clip.boxMm.reset();
        else
            edit.figure.clip.planes.erase(edit.figure.clip.planes.begin() +
                                          static_cast<std::ptrdiff_t>(index - kSides));
        Q_EMIT edited(edit);
    });
}

void ClipOverlay::placeGrips() {
    const std::size_t count = gripCount();
    for (std::size_t index = grips_.size(); index < count; ++index)
        makeGrip(index);
    for (const Grip& grip : grips_) {
        const auto at = grip.index < count ? anchor(grip.index, figure_->clip) : std::nullopt;
        const QPointF along = at ? pixelsPerMm(grip.index, figure_->clip) : QPointF();
        const auto middle = at ? onScreen(*at) : std::nullopt;
        const bool seen = isVisibleTo(viewport_) && middle && QPointF::dotProduct(along, along) >= kLeastPixelsPerMm2;
        // A grip under the hand stays: the view may turn it away while a key is held.
        grip.handle->setVisible(seen || grip.handle->dragging());
        if (middle)
            grip.handle->moveMiddle(*middle);
        grip.handle->raise();
    }
}

void ClipOverlay::moveBy(std::size_t index, double mm, const std::string& key, bool ongoing) {
    if (!figure_)
        return;
    Edit edit{*figure_, tr("Move cut").toStdString(), key + "/clip" + std::to_string(index), ongoing};
    if (index < kSides && pressed_.boxMm && edit.figure.clip.boxMm) {
        const auto axis = static_cast<glm::length_t>(index / 2);
        BoxMm& box = *edit.figure.clip.boxMm;
        if (index % 2)
            box.high[axis] = std::max(pressed_.boxMm->high[axis] + mm, box.low[axis] + kThinnestMm);
        else
            box.low[axis] = std::min(pressed_.boxMm->low[axis] - mm, box.high[axis] - kThinnestMm);
    } else if (index >= kSides && index - kSides < edit.figure.clip.planes.size()) {
        ClipPlane& plane = edit.figure.clip.planes[index - kSides];
        // Of a normal that is not unit, a millimetre counts as its length.
        plane.offsetMm = pressed_.planes.at(index - kSides).offsetMm + mm * glm::length(plane.normal);
    } else {
        return;
    }
    Q_EMIT edited(edit);
}

void ClipOverlay::paintEvent(QPaintEvent*) {
    if (!figure_ || !figure_->clip.boxMm)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const BoxMm& box = *figure_->clip.boxMm;
    const auto corner = [&](int i) {
        return onScreen(glm::mix(box.low, box.high, glm::dvec3(i & 1, i >> 1 & 1, i >> 2)));
    };
    for (int pass = 0; pass < 2; ++pass) {
        painter.setPen(pass == 0 ? QPen(QColor(255, 255, 255, 200), 3) : QPen(QColor(0x1d, 0x2b, 0x45, 220), 1));
        for (int from = 0; from < 8; ++from)
            for (int axis = 0; axis < 3; ++axis) {
                const auto a = corner(from);
                const auto b = corner(from | 1 << axis);
                if (!(from & 1 << axis) && a && b)
                    painter.drawLine(*a, *b);
            }
    }
}

bool ClipOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == viewport_ && event->type() == QEvent::Resize) {
        setGeometry(viewport_->rect());
        placeGrips();
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace limner
