#include "widgets/picture_handle.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>

namespace limner {
namespace {

constexpr int kEdge = 18; // of the widget: a grip that a hand meets without aiming
constexpr double kRadius = 5;
constexpr double kStillAClick = 2; // pixels
constexpr double kFine = 0.1;

} // namespace

PictureHandle::PictureHandle(QWidget* over, Look look, const QString& name) : QWidget(over), look_(look) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(name);
    setToolTip(name);
    setCursor(Qt::SizeAllCursor);
    resize(kEdge, kEdge);
}

void PictureHandle::moveMiddle(QPointF middle) {
    move(static_cast<int>(std::lround(middle.x() - kEdge / 2.0)),
         static_cast<int>(std::lround(middle.y() - kEdge / 2.0)));
}

void PictureHandle::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool chosen = hasFocus() || dragging_ || underMouse();
    // A light ring around a dark one is seen on any picture.
    painter.setPen(QPen(QColor(255, 255, 255, 230), 3.5));
    painter.setBrush(chosen ? palette().color(QPalette::Highlight) : QColor(255, 255, 255));
    const QRectF shape(kEdge / 2.0 - kRadius, kEdge / 2.0 - kRadius, 2 * kRadius, 2 * kRadius);
    for (int pass = 0; pass < 2; ++pass) {
        look_ == Look::round ? painter.drawEllipse(shape) : painter.drawRect(shape);
        painter.setPen(QPen(QColor(0x1d, 0x2b, 0x45), 1.5));
    }
}

void PictureHandle::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    dragging_ = true;
    moved_ = false;
    press_ = event->globalPosition();
    gesture_.begin("handle");
    update();
    Q_EMIT pressed();
}

void PictureHandle::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging_)
        return;
    const QPointF by = event->globalPosition() - press_;
    if (!moved_ && QLineF(QPointF(), by).length() < kStillAClick)
        return;
    moved_ = true;
    Q_EMIT dragged(by, gesture_.during("handle"), true);
}

void PictureHandle::mouseReleaseEvent(QMouseEvent* event) {
    if (!dragging_)
        return;
    dragging_ = false;
    update();
    if (moved_)
        Q_EMIT dragged(event->globalPosition() - press_, gesture_.again("handle"), false);
}

void PictureHandle::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers() & Qt::ShiftModifier ? kFine : 1;
    switch (event->key()) {
    case Qt::Key_Right:
    case Qt::Key_Up: Q_EMIT nudged(step, gesture_.again("nudge")); break;
    case Qt::Key_Left:
    case Qt::Key_Down: Q_EMIT nudged(-step, gesture_.again("nudge")); break;
    case Qt::Key_Delete:
    case Qt::Key_Backspace: Q_EMIT removeWanted(); break;
    default: QWidget::keyPressEvent(event);
    }
}

void PictureHandle::enterEvent(QEnterEvent*) { update(); }

void PictureHandle::leaveEvent(QEvent*) { update(); }

} // namespace limner
