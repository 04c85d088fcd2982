#include "widgets/tool_overlay.h"

#include "widgets/sheet_painting.h"
#include "widgets/viewport.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <utility>

namespace limner {

ToolOverlay::ToolOverlay(Viewport* viewport, const QString& name) : QWidget(viewport), viewport_(viewport) {
    setFocusPolicy(Qt::ClickFocus); // by its own command, or by a click on it
    setMouseTracking(true);
    setCursor(Qt::CrossCursor);
    setAccessibleName(name);
    viewport->installEventFilter(this);
    hide();
}

void ToolOverlay::setFigure(std::shared_ptr<const Figure> figure) {
    figure_ = std::move(figure);
    if (!figure_ || !figure_->volume || !figure_->volume->data)
        layDown();
    update();
}

void ToolOverlay::take() {
    if (!figure_ || !figure_->volume || !figure_->volume->data || taken())
        return;
    for (ToolOverlay* other : viewport_->findChildren<ToolOverlay*>()) // a hand holds one tool
        other->layDown();
    reset();
    setGeometry(viewport_->rect());
    setAccessibleDescription(hint());
    show();
    raise();
    setFocus(Qt::OtherFocusReason);
    Q_EMIT takenChanged(true);
}

void ToolOverlay::layDown() {
    if (!taken())
        return;
    const bool focused = hasFocus();
    reset();
    hide();
    if (focused)
        viewport_->setFocus();
    Q_EMIT takenChanged(false);
}

glm::dvec2 ToolOverlay::onFigure(QPointF position) const { return viewport_->onFigure(position); }

QPointF ToolOverlay::onScreen(const glm::dvec2& place) const { return viewport_->onScreen(place); }

void ToolOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintTool(painter);
    constexpr double kInset = 8;
    drawBadge(painter, viewport_->sheet().adjusted(kInset, kInset, -kInset, -kInset), hint());
}

void ToolOverlay::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        layDown();
    else
        event->ignore(); // to the viewport: arrows turn the figure
}

void ToolOverlay::wheelEvent(QWheelEvent* event) { event->setAccepted(begun()); }

bool ToolOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == viewport_ && event->type() == QEvent::Resize)
        setGeometry(viewport_->rect());
    return QWidget::eventFilter(watched, event);
}

} // namespace limner
