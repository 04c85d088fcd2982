#include "widgets/point_mark.h"

#include "widgets/viewport.h"

#include <QEvent>
#include <QPainter>

namespace limner {

PointMark::PointMark(Viewport* viewport) : QWidget(viewport), viewport_(viewport) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    viewport->installEventFilter(this);
    setGeometry(viewport->rect());
    hide();
}

void PointMark::setPoint(std::shared_ptr<const Figure> figure, std::optional<glm::dvec3> pointMm) {
    figure_ = std::move(figure);
    pointMm_ = pointMm;
    setVisible(figure_ && pointMm_);
    update();
}

std::optional<QPointF> PointMark::place() const {
    if (!figure_ || !pointMm_)
        return std::nullopt;
    return viewport_->onScreen(*figure_, *pointMm_);
}

void PointMark::paintEvent(QPaintEvent*) {
    const auto at = place();
    if (!at)
        return;
    constexpr double kGap = 4, kArm = 12; // pixels
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& pen : {QPen(QColor(255, 255, 255, 220), 3.5), QPen(QColor(0xc0, 0x6a, 0x00), 1.5)}) {
        painter.setPen(pen);
        for (const QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(*at + way * kGap, *at + way * kArm);
    }
}

bool PointMark::eventFilter(QObject* watched, QEvent* event) {
    if (watched == viewport_ && event->type() == QEvent::Resize)
        setGeometry(viewport_->rect());
    return QWidget::eventFilter(watched, event);
}

} // namespace limner
