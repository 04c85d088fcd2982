#include "widgets/lens_overlay.h"

#include "renderer/plan/lenses.h"
#include "widgets/lens_place.h"
#include "widgets/viewport.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace limner {
namespace {

constexpr double kHandle = 5; // radius, pixels
constexpr double kGrab = 10;
constexpr double kLeastRadius = 0.01; // a smaller lens could hardly be grabbed again
constexpr double kMostRadius = 10;
constexpr double kFarthest = 1000; // legal middle, in figures
constexpr double kStepPerKey = 0.01;
constexpr double kFineStepPerKey = 0.001;
constexpr double kGrowthPerKey = 1.05;

/// From the middle to the edge handle, in heights of the figure: along a lens' own horizontal axis.
glm::dvec2 edgeOffset(const Lens& lens) {
    const double turn = lens.shape == "circle" ? 0 : glm::radians(lens.angleDeg);
    const glm::dvec2 direction(std::cos(turn), -std::sin(turn));
    return direction / lensDistance(lens, direction);
}

} // namespace

LensOverlay::LensOverlay(Viewport* viewport) : QWidget(viewport), viewport_(viewport) {
    setFocusPolicy(Qt::TabFocus); // a click beside the handles is meant for the viewport
    setMouseTracking(true);
    setAccessibleName(tr("Lens"));
    setAccessibleDescription(
        tr("The chosen lens. Arrow keys move it, plus and minus resize it, Delete removes it, Escape leaves it."));
    viewport->installEventFilter(this);
    setGeometry(viewport->rect());
    hide();
}

void LensOverlay::setFigure(std::shared_ptr<const Figure> figure, std::optional<std::size_t> lens) {
    figure_ = std::move(figure);
    lens_ = lens;
    if (!this->lens()) {
        drag_ = Drag::none;
        if (hasFocus())
            viewport_->setFocus();
    }
    setVisible(this->lens() != nullptr);
    update();
}

const Lens* LensOverlay::lens() const {
    const bool any = figure_ && figure_->importance && lens_ && *lens_ < figure_->importance->lenses.size();
    return any ? &figure_->importance->lenses[*lens_] : nullptr;
}

QPointF LensOverlay::toWidget(const glm::dvec2& onSheet) const {
    const QRectF sheet = viewport_->sheet();
    return sheet.topLeft() + QPointF(onSheet.x, onSheet.y) * sheet.height();
}

glm::dvec2 LensOverlay::toSheet(QPointF position) const {
    const QRectF sheet = viewport_->sheet();
    const QPointF offset = (position - sheet.topLeft()) / sheet.height();
    return {offset.x(), offset.y()};
}

std::optional<glm::dvec2> LensOverlay::place() const {
    if (!lens())
        return std::nullopt;
    return lensOnSheet(*figure_, *lens());
}

std::optional<QPointF> LensOverlay::middle() const {
    const auto at = place();
    return at ? std::optional(toWidget(*at)) : std::nullopt;
}

std::optional<QPointF> LensOverlay::edge() const {
    const auto at = place();
    return at ? std::optional(toWidget(*at + edgeOffset(*lens()))) : std::nullopt;
}

LensOverlay::Drag LensOverlay::handleAt(QPointF position) const {
    const auto near = [&](const std::optional<QPointF>& handle) {
        return handle && QLineF(*handle, position).length() <= kGrab;
    };
    return near(edge()) ? Drag::edge : near(middle()) ? Drag::middle : Drag::none;
}

void LensOverlay::paintEvent(QPaintEvent*) {
    const auto at = place();
    if (!at)
        return;
    constexpr int kCorners = 180;
    QPolygonF outline;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        const glm::dvec2 direction(std::cos(angle), std::sin(angle));
        outline << toWidget(*at + direction / lensDistance(*lens(), direction));
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor light(255, 255, 255, 220); // a light line around a dark one is seen on any picture
    const QColor dark = hasFocus() ? palette().color(QPalette::Highlight) : QColor(0x1d, 0x2b, 0x45);
    painter.setPen(QPen(light, 3.5));
    painter.drawPolygon(outline);
    painter.setPen(QPen(dark, 1.5));
    painter.drawPolygon(outline);
    painter.setBrush(light);
    painter.drawEllipse(*middle(), kHandle, kHandle);
    painter.drawRect(QRectF(*edge() - QPointF(kHandle, kHandle), QSizeF(2 * kHandle, 2 * kHandle)));
}

void LensOverlay::mousePressEvent(QMouseEvent* event) {
    const Drag handle = event->button() == Qt::LeftButton && drag_ == Drag::none ? handleAt(event->position()) : drag_;
    if (handle == Drag::none || drag_ != Drag::none) {
        event->setAccepted(drag_ != Drag::none);
        return;
    }
    setFocus(Qt::MouseFocusReason);
    drag_ = handle;
    dragMoved_ = false;
    grab_ = (handle == Drag::edge ? *edge() : *middle()) - event->position();
    key_.begin(handle == Drag::edge ? "lens/radius" : "lens/center");
}

void LensOverlay::mouseMoveEvent(QMouseEvent* event) {
    if (drag_ == Drag::none) {
        switch (handleAt(event->position())) {
        case Drag::none: unsetCursor(); break;
        case Drag::middle: setCursor(Qt::SizeAllCursor); break;
        case Drag::edge: setCursor(Qt::SizeHorCursor); break;
        }
        event->ignore();
        return;
    }
    const auto at = place();
    if (!at) { // an undo took it away under the pointer
        drag_ = Drag::none;
        return;
    }
    dragMoved_ = true;
    const glm::dvec2 to = toSheet(event->position() + grab_);
    if (drag_ == Drag::middle)
        moveTo(to, key_.during("lens/center"), true);
    else
        resizeTo(lens()->radius * lensDistance(*lens(), to - *at), key_.during("lens/radius"), true);
}

void LensOverlay::mouseReleaseEvent(QMouseEvent* event) {
    const Drag was = std::exchange(drag_, Drag::none);
    if (was == Drag::none) {
        event->ignore();
        return;
    }
    if (dragMoved_ && lens())
        emitLens(*lens(), was == Drag::edge ? tr("Resize lens") : tr("Move lens"),
                 key_.again(was == Drag::edge ? "lens/radius" : "lens/center"), false);
}

void LensOverlay::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers() & Qt::ShiftModifier ? kFineStepPerKey : kStepPerKey;
    const auto move = [&](double right, double down) {
        if (const auto from = place())
            moveTo(*from + glm::dvec2(right, down), key_.again("lens/center"), false);
    };
    const auto grow = [&](double factor) {
        if (lens())
            resizeTo(lens()->radius * factor, key_.again("lens/radius"), false);
    };
    switch (event->key()) {
    case Qt::Key_Left: move(-step, 0); break;
    case Qt::Key_Right: move(step, 0); break;
    case Qt::Key_Up: move(0, -step); break;
    case Qt::Key_Down: move(0, step); break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: grow(kGrowthPerKey); break;
    case Qt::Key_Minus: grow(1 / kGrowthPerKey); break;
    case Qt::Key_Delete:
    case Qt::Key_Backspace: removeLens(); break;
    case Qt::Key_Escape: Q_EMIT left(); break;
    default: QWidget::keyPressEvent(event);
    }
}

void LensOverlay::focusInEvent(QFocusEvent*) { update(); }

void LensOverlay::focusOutEvent(QFocusEvent*) { update(); }

bool LensOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == viewport_ && event->type() == QEvent::Resize)
        setGeometry(viewport_->rect());
    return QWidget::eventFilter(watched, event);
}

void LensOverlay::moveTo(const glm::dvec2& to, const std::string& key, bool ongoing) {
    const double aspect = sheetAspect(*figure_);
    const glm::dvec2 legal(std::clamp(to.x, -kFarthest * aspect, kFarthest * aspect),
                           std::clamp(to.y, -kFarthest, kFarthest));
    emitLens(lensMovedTo(*figure_, *lens(), legal), tr("Move lens"), key, ongoing);
}

void LensOverlay::resizeTo(double radius, const std::string& key, bool ongoing) {
    Lens changed = *lens();
    changed.radius = std::clamp(radius, kLeastRadius, kMostRadius);
    emitLens(changed, tr("Resize lens"), key, ongoing);
}

void LensOverlay::removeLens() {
    if (!lens())
        return;
    Edit edit{*figure_, tr("Remove lens").toStdString(), {}, false};
    auto& others = edit.figure.importance->lenses;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(*lens_));
    Q_EMIT edited(edit);
}

void LensOverlay::emitLens(const Lens& changed, const QString& label, const std::string& key, bool ongoing) {
    Edit edit{*figure_, label.toStdString(), key, ongoing};
    edit.figure.importance->lenses[*lens_] = changed;
    Q_EMIT edited(edit);
}

} // namespace limner
