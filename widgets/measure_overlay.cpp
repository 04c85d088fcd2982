#include "widgets/measure_overlay.h"

#include "widgets/sheet_painting.h"
#include "widgets/viewport.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limner {

MeasureOverlay::MeasureOverlay(Viewport* viewport) : ToolOverlay(viewport, tr("Measure")) {}

void MeasureOverlay::reset() {
    pointsMm_.clear();
    missed_ = false;
}

QString MeasureOverlay::hint() const {
    if (missed_)
        return tr("There is too little to see here to measure · click on the figure · Esc: leave");
    switch (pointsMm_.size()) {
    case 0: return tr("Click on the first place · Esc: leave");
    case 1: return tr("Click on the second place · Backspace: take it back · Esc: leave");
    case 2: return tr("Click on a third place for the angle · Backspace: take it back · Esc: leave");
    default: return tr("Click to measure anew · Esc: leave");
    }
}

std::optional<double> MeasureOverlay::distanceMm() const {
    if (pointsMm_.size() < 2)
        return std::nullopt;
    return glm::length(pointsMm_[1] - pointsMm_[0]);
}

std::optional<double> MeasureOverlay::angleDeg() const {
    if (pointsMm_.size() < 3)
        return std::nullopt;
    const glm::dvec3 a = pointsMm_[0] - pointsMm_[1];
    const glm::dvec3 b = pointsMm_[2] - pointsMm_[1];
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b))); // exact for small angles too
}

void MeasureOverlay::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !viewport().picture()) {
        event->ignore();
        return;
    }
    const auto pick = viewport().pickAt(event->position());
    missed_ = !pick;
    if (pick) {
        if (pointsMm_.size() == 3)
            pointsMm_.clear();
        pointsMm_.push_back(pick->pointMm);
    }
    setAccessibleDescription(hint());
    update();
}

void MeasureOverlay::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->position();
    update();
}

void MeasureOverlay::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Backspace && !pointsMm_.empty()) {
        pointsMm_.pop_back();
        update();
    } else {
        ToolOverlay::keyPressEvent(event);
    }
}

std::optional<QPointF> MeasureOverlay::onPicture(const glm::dvec3& pointMm) const {
    return viewport().onScreen(*figure(), pointMm);
}

void MeasureOverlay::paintTool(QPainter& painter) {
    constexpr double kDot = 3.5;
    QPolygonF line;
    for (const glm::dvec3& point : pointsMm_)
        if (const auto at = onPicture(point))
            line << *at;
    const QPolygonF marks = line;
    if (pointsMm_.size() == 1 && underMouse())
        line << pointer_;
    for (const auto& pen : {QPen(QColor(255, 255, 255, 220), 3.5), QPen(QColor(0x1d, 0x2b, 0x45), 1.5)}) {
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(line);
        painter.setBrush(pen.color());
        for (const QPointF& mark : marks)
            painter.drawEllipse(mark, kDot, kDot);
    }
    const auto say = [&](QPointF at, const QString& text) {
        drawHaloText(painter, QRectF(at - QPointF(90, 26), QSizeF(180, 22)), Qt::AlignCenter, text);
    };
    if (const auto mm = distanceMm(); mm && marks.size() >= 2)
        say((marks[0] + marks[1]) / 2, tr("%1 mm").arg(QLocale().toString(*mm, 'f', 1)));
    if (const auto degrees = angleDeg(); degrees && marks.size() == 3)
        say(marks[1] - QPointF(0, 8), tr("%1°").arg(QLocale().toString(*degrees, 'f', 1)));
}

} // namespace limner
