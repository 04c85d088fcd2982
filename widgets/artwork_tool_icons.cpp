#include "widgets/artwork_tool_icons.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

#include <tuple>

namespace limner {
namespace {

/// Drawn on a square of 20 units.
void drawTool(QPainter& painter, ToolKind kind) {
    const QColor ink = painter.pen().color();
    switch (kind) {
    case ToolKind::circle:
        painter.drawEllipse(QPointF(10, 10), 7, 7);
        painter.drawPoint(QPointF(10, 10));
        break;
    case ToolKind::ellipse:
        painter.translate(10, 10);
        painter.rotate(-28);
        painter.drawEllipse(QPointF(0, 0), 8, 5);
        painter.drawLine(QPointF(-8, 0), QPointF(8, 0));
        break;
    case ToolKind::region: {
        QPainterPath lasso(QPointF(5, 14));
        lasso.cubicTo(-1, 4, 9, 1, 14, 4);
        lasso.cubicTo(21, 8, 16, 16, 8, 14.5);
        lasso.cubicTo(5, 14, 4, 17, 7, 18);
        painter.drawPath(lasso);
        break;
    }
    case ToolKind::brush:
    case ToolKind::ignore:
        painter.drawLine(QPointF(16.5, 3.5), QPointF(9.5, 10.5));
        painter.setBrush(ink);
        painter.drawEllipse(QPointF(6.5, 13.5), 3.2, 3.2);
        if (kind == ToolKind::ignore)
            painter.drawLine(QPointF(3, 3), QPointF(17, 17));
        break;
    case ToolKind::normal:
        painter.drawArc(QRectF(3, 8, 12, 12), 0, 180 * 16);
        painter.drawLine(QPointF(2, 14), QPointF(16, 14));
        painter.drawLine(QPointF(9, 14), QPointF(16, 4));
        painter.setBrush(ink);
        painter.drawEllipse(QPointF(16, 4), 1.6, 1.6);
        break;
    case ToolKind::crease:
        painter.drawPolyline(QPolygonF({QPointF(2, 16), QPointF(10, 5), QPointF(18, 16)}));
        painter.drawLine(QPointF(10, 5), QPointF(10, 17));
        break;
    case ToolKind::open:
        painter.drawArc(QRectF(3, 3, 14, 14), 60 * 16, 260 * 16);
        painter.setPen(QPen(ink, 1.6, Qt::DotLine, Qt::FlatCap));
        painter.drawArc(QRectF(3, 3, 14, 14), -40 * 16, 100 * 16);
        break;
    case ToolKind::picker:
        painter.drawLine(QPointF(3, 17), QPointF(11, 9));
        painter.drawLine(QPointF(9, 6.5), QPointF(13.5, 11));
        painter.setBrush(ink);
        painter.drawEllipse(QPointF(14.4, 5.6), 2.6, 2.6);
        break;
    }
}

} // namespace

QIcon toolIcon(ToolKind kind, const QPalette& palette, int side, double pixelRatio) {
    QIcon icon;
    const std::tuple<QIcon::Mode, QIcon::State, QColor> looks[] = {
        {QIcon::Normal, QIcon::Off, palette.color(QPalette::Active, QPalette::ButtonText)},
        {QIcon::Normal, QIcon::On, palette.color(QPalette::Active, QPalette::HighlightedText)},
        {QIcon::Disabled, QIcon::Off, palette.color(QPalette::Disabled, QPalette::ButtonText)},
        {QIcon::Disabled, QIcon::On, palette.color(QPalette::Disabled, QPalette::ButtonText)}};
    for (const auto& [mode, state, ink] : looks) {
        QPixmap pixmap(QSize(side, side) * pixelRatio);
        pixmap.setDevicePixelRatio(pixelRatio);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(side / 20.0, side / 20.0);
        painter.setPen(QPen(ink, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        drawTool(painter, kind);
        painter.end();
        icon.addPixmap(pixmap, mode, state);
    }
    return icon;
}

} // namespace limner
