#pragma once

#include <QColor>
#include <QString>

class QPainter;
class QPalette;
class QRectF;

namespace limner {

/// Small painting helpers of widgets that show pictures.

/// A neutral grey between light and dark themes' extremes: colours on the sheet are judged against it.
QColor deskColour(const QPalette& palette);
/// The soft shadow of a sheet of paper.
void paintShadow(QPainter& painter, const QRectF& sheet);
/// What shows through a transparent picture.
void paintChecks(QPainter& painter, const QRectF& sheet);
/// Dark text in a light halo, readable on any picture. `flags`: Qt::Alignment.
void drawHaloText(QPainter& painter, const QRectF& area, int flags, const QString& text);
/// A word on a dark rounded plate in the area's lower left corner.
void drawBadge(QPainter& painter, const QRectF& area, const QString& text);

} // namespace limner
