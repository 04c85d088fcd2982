#include "widgets/artwork_painting.h"

#include "widgets/artwork_view.h"
#include "widgets/draft_edits.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRadialGradient>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limner {
namespace {

const QColor kHalo(255, 255, 255, 225);
constexpr double kHaloWidth = 1.1; // to either side of a line
constexpr double kDome = 11;       // radius of a normal's hemisphere

QPen roundPen(const QColor& colour, double width) {
    return {QBrush(colour), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

/// Unit vector across a direction, upwards on the screen (of an upright line: to the right).
QPointF across(QPointF direction) {
    const QPointF left(direction.y(), -direction.x());
    const bool up = left.y() < 0 || (left.y() == 0 && left.x() > 0);
    return up ? left : -left;
}

} // namespace

QPolygonF outlineOf(const Ellipse& ellipse, const ArtworkView& view) {
    constexpr int kCorners = 144; // a chord of the largest circle on a screen leaves it by a quarter of a pixel
    QPolygonF outline;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        outline << view.toWidget(ellipse.centre + firstAxis(ellipse) * (ellipse.semiAxes.x * std::cos(angle)) +
                                 secondAxis(ellipse) * (ellipse.semiAxes.y * std::sin(angle)));
    }
    return outline;
}

QPolygonF outlineOf(const ArtPath& path, const ArtworkView& view) {
    QPolygonF line;
    for (const glm::dvec2& place : path)
        line << view.toWidget(place);
    return line;
}

void drawHaloLine(QPainter& painter, const QPolygonF& line, const QColor& colour, double width) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(roundPen(kHalo, width + 2 * kHaloWidth));
    painter.drawPolyline(line);
    painter.setPen(roundPen(colour, width));
    painter.drawPolyline(line);
}

void drawHaloOutline(QPainter& painter, const QPolygonF& outline, const QColor& colour, double width) {
    QPolygonF closed = outline;
    if (!closed.isEmpty())
        closed << closed.front();
    drawHaloLine(painter, closed, colour, width);
}

void drawRoundHandle(QPainter& painter, QPointF at, const QColor& colour, bool filled) {
    painter.setPen(QPen(kHalo, 3.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, kMarkHandle, kMarkHandle);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(filled ? colour : QColor(Qt::white));
    painter.drawEllipse(at, kMarkHandle, kMarkHandle);
}

void drawSquareHandle(QPainter& painter, QPointF at, const QColor& colour) {
    const QRectF square(at - QPointF(kMarkHandle, kMarkHandle), QSizeF(2 * kMarkHandle, 2 * kMarkHandle));
    painter.setPen(QPen(kHalo, 3.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(square);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(Qt::white);
    painter.drawRect(square);
}

QPointF needleTip(QPointF base, glm::dvec2 normal) { return base + QPointF(normal.x, -normal.y) * kNeedle; }

glm::dvec2 normalOfNeedle(QPointF base, QPointF tip) {
    const QPointF needle = (tip - base) / kNeedle;
    const double length = std::hypot(needle.x(), needle.y());
    const double longest = std::max(1.0, length);
    return {needle.x() / longest, -needle.y() / longest};
}

void drawNormal(QPainter& painter, QPointF base, glm::dvec2 normal, const QColor& colour) {
    const double flat = std::min(1.0, std::hypot(normal.x, normal.y));
    const double facing = std::sqrt(1 - flat * flat);
    QRadialGradient dome(base + QPointF(normal.x, -normal.y) * kDome * 0.7, 1.6 * kDome);
    dome.setColorAt(0, QColor(255, 255, 255, 235));
    dome.setColorAt(1, QColor(70, 80, 95, 235));
    painter.setPen(QPen(kHalo, 3.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(base, kDome, kDome);
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(dome);
    painter.drawEllipse(base, kDome, kDome);
    painter.save(); // the tangent plane's circle, seen along the line of sight
    painter.translate(base);
    painter.rotate(-std::atan2(normal.y, normal.x) * 180 / std::numbers::pi);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, 1));
    const double radius = kDome * 0.62;
    painter.drawEllipse(QPointF(flat * kDome * 0.62, 0), std::max(0.5, radius * facing), radius);
    painter.restore();
    const QPointF tip = needleTip(base, normal);
    drawHaloLine(painter, QPolygonF({base, tip}), colour, 2);
    drawRoundHandle(painter, tip, colour, true);
}

QPointF tiltHandle(QPointF middle, QPointF direction, double degrees) {
    return middle + across(direction) * (degrees / 90 * kTiltReach);
}

double tiltOfHandle(QPointF middle, QPointF direction, QPointF handle) {
    return std::clamp(QPointF::dotProduct(handle - middle, across(direction)) / kTiltReach * 90, -90.0, 90.0);
}

void drawTag(QPainter& painter, QPointF at, const QString& text) {
    const QFontMetricsF metrics(painter.font());
    const QRectF plate(at.x(), at.y() - metrics.height() / 2 - 2, metrics.horizontalAdvance(text) + 12,
                       metrics.height() + 4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(30, 34, 42, 210));
    painter.drawRoundedRect(plate, 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(plate, Qt::AlignCenter, text);
}

} // namespace limner
