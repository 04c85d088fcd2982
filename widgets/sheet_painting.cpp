#include "widgets/sheet_painting.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace limner {

QColor deskColour(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() > 127 ? QColor(0xc4, 0xc7, 0xcb) : QColor(0x3a, 0x3c, 0x40);
}

void paintShadow(QPainter& painter, const QRectF& sheet) {
    constexpr int kReach = 5;
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = kReach; i > 0; --i) {
        painter.setBrush(QColor(0, 0, 0, 10));
        painter.drawRoundedRect(sheet.adjusted(-i, -i + 1, i, i + 1), i, i);
    }
    painter.restore();
}

void paintChecks(QPainter& painter, const QRectF& sheet) {
    constexpr int kCheck = 8;
    QPixmap tile(2 * kCheck, 2 * kCheck);
    tile.fill(Qt::white);
    QPainter tilePainter(&tile);
    tilePainter.fillRect(0, 0, kCheck, kCheck, QColor(0xdd, 0xdd, 0xdd));
    tilePainter.fillRect(kCheck, kCheck, kCheck, kCheck, QColor(0xdd, 0xdd, 0xdd));
    tilePainter.end();
    painter.drawTiledPixmap(sheet, tile);
}

void drawHaloText(QPainter& painter, const QRectF& area, int flags, const QString& text) {
    if (text.isEmpty())
        return;
    const QFontMetricsF metrics(painter.font());
    const QRectF box = metrics.boundingRect(area, flags, text);
    QPainterPath path;
    path.addText(box.left(), box.top() + metrics.ascent(), painter.font(), text);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(255, 255, 255, 215), 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.fillPath(path, QColor(0x1d, 0x2b, 0x45));
    painter.restore();
}

void drawBadge(QPainter& painter, const QRectF& area, const QString& text) {
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(text) + 14, metrics.height() + 4);
    const QRectF plate(area.left(), area.bottom() - size.height(), size.width(), size.height());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(30, 34, 42, 190));
    painter.drawRoundedRect(plate, 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(plate, Qt::AlignCenter, text);
    painter.restore();
}

} // namespace limner
