#pragma once

#include "core/style/extraction/forms.h"

#include <QColor>
#include <QPointF>
#include <QPolygonF>

class QPainter;
class QString;

namespace limner {

class ArtworkView;

/// How marks look on an artwork of any colour: a dark or coloured line within a light halo. In the canvas's pixels.

constexpr double kMarkHandle = 4.5; ///< radius of a handle
constexpr double kMarkGrab = 10;    ///< how near a press must be to it
constexpr double kNeedle = 38;      ///< length of the needle of a normal that lies in the picture's plane
constexpr double kTiltReach = 44;   ///< how far from its crease the handle of a tilt of 90 degrees stands
constexpr double kTurnKnob = 24;    ///< how far beyond its axis the knob stands that turns an ellipse

QPolygonF outlineOf(const Ellipse& ellipse, const ArtworkView& view);
QPolygonF outlineOf(const ArtPath& path, const ArtworkView& view);

void drawHaloLine(QPainter& painter, const QPolygonF& line, const QColor& colour, double width = 1.6);
/// As above, from the last point back to the first.
void drawHaloOutline(QPainter& painter, const QPolygonF& outline, const QColor& colour, double width = 1.6);
void drawRoundHandle(QPainter& painter, QPointF at, const QColor& colour, bool filled = false);
void drawSquareHandle(QPainter& painter, QPointF at, const QColor& colour);

/// Where the needle of a normal ends, and the normal whose needle ends there (the longest there is where it is longer).
QPointF needleTip(QPointF base, glm::dvec2 normal);
glm::dvec2 normalOfNeedle(QPointF base, QPointF tip);
/// A small hemisphere under its tangent plane's circle, and the needle.
void drawNormal(QPainter& painter, QPointF base, glm::dvec2 normal, const QColor& colour);

/// The handle of a crease's tilt stands across its middle: above the line (or to the right of it) for a ridge.
QPointF tiltHandle(QPointF middle, QPointF direction, double degrees);
double tiltOfHandle(QPointF middle, QPointF direction, QPointF handle);

/// A short word on a dark plate beside a point.
void drawTag(QPainter& painter, QPointF at, const QString& text);

} // namespace limner
