#include "widgets/viewport.h"

#include "core/figure/view_frame.h"
#include "widgets/sheet_painting.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QPinchGesture>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr double kDeskMargin = 18;          // room around the sheet
constexpr double kZoomPerWheelClick = 0.85; // four clicks halve the view
constexpr double kDegreesPerKey = 5;
constexpr double kFineDegreesPerKey = 1;
constexpr double kZoomPerKey = 0.9;
constexpr double kStillAClick = 2; // pixels
constexpr int kSettleMs = 180;     // a wheel's clicks come faster; people wait longer before they look

} // namespace

Viewport::Viewport(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Picture"));
    setAccessibleDescription(tr("The figure. Arrow keys turn it, plus and minus zoom."));
    setWhatsThis(tr("Drag to turn, drag with the middle button or Shift to move, wheel to zoom, double click to fit."));
    grabGesture(Qt::PinchGesture);
    settle_.setSingleShot(true);
    settle_.setInterval(kSettleMs);
    connect(&settle_, &QTimer::timeout, this, &Viewport::settle);
}

void Viewport::setFigure(std::shared_ptr<const Figure> figure) {
    const QSize before = picturePixels();
    figure_ = std::move(figure);
    if (!editable())
        picture_.reset();
    setCursor(editable() ? Qt::OpenHandCursor : Qt::ArrowCursor);
    update();
    if (picturePixels() != before)
        Q_EMIT picturePixelsChanged();
}

void Viewport::setPicture(const ScreenPicture& picture) {
    if (!editable())
        return;
    picture_ = picture;
    update();
}

QRectF Viewport::sheet() const {
    const double aspect = figure_ ? figure_->output.widthMm / std::max(figure_->output.heightMm, 1e-6) : 1;
    const QRectF room = QRectF(rect()).adjusted(kDeskMargin, kDeskMargin, -kDeskMargin, -kDeskMargin);
    QSizeF size(room.height() * aspect, room.height());
    if (size.width() > room.width())
        size = {room.width(), room.width() / aspect};
    const QPointF corner = room.center() - QPointF(size.width(), size.height()) / 2;
    return {std::round(corner.x()), std::round(corner.y()), std::max(1.0, std::floor(size.width())),
            std::max(1.0, std::floor(size.height()))};
}

glm::dvec2 Viewport::onFigure(QPointF position) const {
    const QRectF area = sheet();
    return {(position.x() - area.left()) / area.width(), (position.y() - area.top()) / area.height()};
}

QPointF Viewport::onScreen(const glm::dvec2& place) const {
    const QRectF area = sheet();
    return {area.left() + place.x * area.width(), area.top() + place.y * area.height()};
}

std::optional<QPointF> Viewport::onScreen(const Figure& figure, const glm::dvec3& pointMm) const {
    const glm::dvec3 at = ViewFrame(figure.camera, figure.output.aspect()).project(pointMm);
    return at.z > 0 ? std::optional(onScreen(glm::dvec2(at) / at.z)) : std::nullopt;
}

std::optional<Pick> Viewport::pickAt(QPointF position) const {
    if (!picture_)
        return std::nullopt;
    const RenderPlan& plan = *picture_->plan;
    return pickMatter(plan, onFigure(position) * glm::dvec2(plan.size));
}

QSize Viewport::picturePixels() const {
    const QSizeF size = sheet().size() * devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(size.width()))),
            std::max(1, static_cast<int>(std::lround(size.height())))};
}

EdgeLetters Viewport::letters() const {
    if (picture_)
        return edgeLetters(picture_->plan->figure->camera);
    return figure_ ? edgeLetters(figure_->camera) : EdgeLetters{};
}

void Viewport::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), deskColour(palette()));
    if (!editable())
        return;
    const QRectF area = sheet();
    paintSheet(painter, area);
    paintLetters(painter, area);
    paintBadge(painter, area);
}

void Viewport::paintSheet(QPainter& painter, const QRectF& area) const {
    paintShadow(painter, area);
    if (!picture_) {
        painter.fillRect(area, Qt::white);
        return;
    }
    if (picture_->image.hasAlphaChannel())
        paintChecks(painter, area);
    const bool exact = picture_->image.size() == picturePixels();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !exact);
    painter.drawImage(area, picture_->image);
}

void Viewport::paintLetters(QPainter& painter, const QRectF& area) const {
    const auto says = [this](const AnnotationPlace& place) {
        return place.drawn && picture_->plan->figure->annotations[place.index].kind == "orientation";
    };
    if (picture_ && std::any_of(picture_->annotations.begin(), picture_->annotations.end(), says))
        return; // the figure says it itself; a second time would lie over its lettering
    const EdgeLetters shown = letters();
    constexpr double kInset = 6;
    const QRectF inside = area.adjusted(kInset, kInset, -kInset, -kInset);
    QFont bold = font();
    bold.setBold(true);
    bold.setPointSizeF(font().pointSizeF() + 2);
    painter.setFont(bold);
    drawHaloText(painter, inside, Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(shown.left));
    drawHaloText(painter, inside, Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(shown.right));
    drawHaloText(painter, inside, Qt::AlignHCenter | Qt::AlignTop, QString::fromStdString(shown.top));
    drawHaloText(painter, inside, Qt::AlignHCenter | Qt::AlignBottom, QString::fromStdString(shown.bottom));
}

void Viewport::paintBadge(QPainter& painter, const QRectF& area) const {
    const bool pending = !picture_ || !picture_->facts.final;
    if (!pending)
        return;
    painter.setFont(font());
    constexpr double kInset = 8;
    drawBadge(painter, area.adjusted(kInset, kInset, -kInset, -kInset), picture_ ? tr("Draft") : tr("Drawing…"));
}

void Viewport::resizeEvent(QResizeEvent*) { Q_EMIT picturePixelsChanged(); }

glm::dvec2 Viewport::onSheet(QPointF position) const {
    const QRectF area = sheet();
    const QPointF offset = position - area.center();
    return {offset.x() / area.height(), offset.y() / area.height()};
}

void Viewport::emitCamera(const Camera& camera, const QString& label, const std::string& key, bool ongoing) {
    Edit edit{*figure_, label.toStdString(), key, ongoing};
    edit.figure.camera = camera;
    Q_EMIT edited(edit);
}

void Viewport::emitPassing(const Camera& camera, const QString& label, const std::string& name) {
    passingKey_ = key_.again(name);
    passingLabel_ = label;
    settle_.start();
    emitCamera(camera, label, passingKey_, true);
}

void Viewport::settle() {
    settle_.stop();
    if (editable() && drag_ == Drag::none)
        emitCamera(figure_->camera, passingLabel_, passingKey_, false);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    if (!editable() || drag_ != Drag::none)
        return;
    const bool pan = event->button() == Qt::MiddleButton ||
                     (event->button() == Qt::LeftButton && event->modifiers() & Qt::ShiftModifier);
    if (!pan && event->button() != Qt::LeftButton)
        return;
    settle_.stop();
    drag_ = pan ? Drag::pan : Drag::turn;
    dragCamera_ = figure_->camera;
    dragStart_ = event->position();
    dragMoved_ = false;
    key_.begin(pan ? "camera/pan" : "camera/turn");
    setCursor(pan ? Qt::SizeAllCursor : Qt::ClosedHandCursor);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    if (drag_ == Drag::none || !editable())
        return;
    if (!dragMoved_ && QLineF(dragStart_, event->position()).length() < kStillAClick)
        return;
    const glm::dvec2 from = onSheet(dragStart_);
    const glm::dvec2 to = onSheet(event->position());
    dragMoved_ = true;
    if (drag_ == Drag::pan)
        emitCamera(panned(dragCamera_, to - from), tr("Move view"), key_.again("camera/pan"), true);
    else
        emitCamera(turned(dragCamera_, turnMode_, from, to), tr("Turn view"), key_.again("camera/turn"), true);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (drag_ == Drag::none)
        return;
    if (!dragMoved_ && drag_ == Drag::turn && sheet().contains(event->position()))
        Q_EMIT clicked(event->position());
    const bool pan = std::exchange(drag_, Drag::none) == Drag::pan;
    setCursor(editable() ? Qt::OpenHandCursor : Qt::ArrowCursor);
    if (dragMoved_ && editable())
        emitCamera(figure_->camera, pan ? tr("Move view") : tr("Turn view"),
                   key_.again(pan ? "camera/pan" : "camera/turn"), false);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        fit();
}

void Viewport::wheelEvent(QWheelEvent* event) {
    if (!editable() || drag_ != Drag::none)
        return;
    event->accept();
    const bool touchpad = event->device() && event->device()->type() == QInputDevice::DeviceType::TouchPad;
    if (touchpad && !(event->modifiers() & Qt::ControlModifier) && !event->pixelDelta().isNull()) {
        const QPointF by = QPointF(event->pixelDelta()) / sheet().height();
        emitPassing(panned(figure_->camera, {by.x(), by.y()}), tr("Move view"), "camera/scroll");
        return;
    }
    const double clicks = event->angleDelta().y() / 120.0; // Qt counts eighths of a degree, a click is 15 degrees
    if (clicks != 0)
        emitPassing(zoomed(figure_->camera, std::pow(kZoomPerWheelClick, clicks), onSheet(event->position())),
                    tr("Zoom"), "camera/zoom");
}

bool Viewport::nativeGesture(QNativeGestureEvent* event) {
    if (!editable() || event->gestureType() != Qt::ZoomNativeGesture)
        return false;
    emitPassing(zoomed(figure_->camera, 1 / std::max(0.1, 1 + event->value()), onSheet(event->position())), tr("Zoom"),
                "camera/zoom");
    return true;
}

bool Viewport::pinch(QPinchGesture* gesture) {
    if (!editable() || !(gesture->changeFlags() & QPinchGesture::ScaleFactorChanged))
        return false;
    const QPointF centre = mapFromGlobal(gesture->centerPoint());
    emitPassing(zoomed(figure_->camera, 1 / std::clamp(gesture->scaleFactor(), 0.1, 10.0), onSheet(centre)), tr("Zoom"),
                "camera/zoom");
    return true;
}

bool Viewport::event(QEvent* event) {
    if (event->type() == QEvent::NativeGesture && nativeGesture(static_cast<QNativeGestureEvent*>(event)))
        return true;
    if (event->type() == QEvent::Gesture)
        if (QGesture* gesture = static_cast<QGestureEvent*>(event)->gesture(Qt::PinchGesture))
            return pinch(static_cast<QPinchGesture*>(gesture));
    return QWidget::event(event);
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    const double angle = event->modifiers() & Qt::ShiftModifier ? kFineDegreesPerKey : kDegreesPerKey;
    switch (event->key()) {
    case Qt::Key_Left: turnBy(-angle, 0); break;
    case Qt::Key_Right: turnBy(angle, 0); break;
    case Qt::Key_Up: turnBy(0, -angle); break;
    case Qt::Key_Down: turnBy(0, angle); break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomBy(kZoomPerKey); break;
    case Qt::Key_Minus: zoomBy(1 / kZoomPerKey); break;
    default: QWidget::keyPressEvent(event);
    }
}

void Viewport::turnBy(double sideways, double down) {
    if (!editable())
        return;
    const glm::dvec2 by(sideways / 180, down / 180); // a sheet's height is half a turn
    emitPassing(turned(figure_->camera, TurnMode::turntable, {0, 0}, by), tr("Turn view"), "camera/keys");
}

void Viewport::zoomBy(double factor) {
    if (editable())
        emitPassing(zoomed(figure_->camera, factor, {0, 0}), tr("Zoom"), "camera/zoom");
}

void Viewport::fit() {
    if (!editable())
        return;
    // The plan's volume is the cleaned one: a removed table must not count.
    const bool current = picture_ && picture_->plan->figure->volume == figure_->volume && picture_->plan->volume;
    const Volume& volume = current ? *picture_->plan->volume : *figure_->volume->data;
    const QRectF area = sheet();
    emitCamera(fitted(figure_->camera, volume, figure_->layers, area.width() / area.height()), tr("Fit view"), {},
               false);
}

void Viewport::showSide(StandardView side) {
    if (!editable())
        return;
    Camera camera = standardView(*figure_->volume->data, side);
    camera.projection = figure_->camera.projection;
    camera.fovDeg = figure_->camera.fovDeg;
    const bool current = picture_ && picture_->plan->figure->volume == figure_->volume && picture_->plan->volume;
    const Volume& volume = current ? *picture_->plan->volume : *figure_->volume->data;
    const QRectF area = sheet();
    emitCamera(fitted(camera, volume, figure_->layers, area.width() / area.height()), tr("Standard view"), {}, false);
}

} // namespace limner
