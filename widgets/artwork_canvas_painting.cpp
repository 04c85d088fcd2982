// How the artwork canvas looks.
#include "widgets/artwork_canvas.h"

#include "widgets/artwork_painting.h"
#include "widgets/artwork_picker_tool.h"
#include "widgets/sheet_painting.h"

#include <QPainter>

#include <utility>
#include <vector>

namespace limner {
namespace {

const QColor kInk(0x1d, 0x2b, 0x45);

/// From clear to the colour, as strongly as a mask marks; of the rest where `outside`.
QVector<QRgb> shades(const QColor& colour, bool outside) {
    QVector<QRgb> table(256);
    for (int i = 0; i < 256; ++i) {
        const int share = outside ? 255 - i : i;
        table[i] = qRgba(colour.red(), colour.green(), colour.blue(), colour.alpha() * share / 255);
    }
    return table;
}

} // namespace

QVector<QLineF> borderOf(const Mask& mask) {
    QVector<QLineF> lines;
    const auto marked = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < mask.width && y < mask.height && mask.has(x, y);
    };
    // Runs of pixels' sides, gathered row by row, as the mask lies in memory; those going down are open until they end.
    std::vector<int> downFrom(static_cast<std::size_t>(mask.width) + 1, -1);
    for (int y = 0; y <= mask.height; ++y) {
        int from = -1;
        bool before = false; // the pixel to the left
        for (int x = 0; x <= mask.width; ++x) {
            const bool here = marked(x, y);
            const bool across = x < mask.width && here != marked(x, y - 1);
            if (across && from < 0)
                from = x;
            if (!across && from >= 0)
                lines << QLineF(std::exchange(from, -1), y, x, y);
            int& down = downFrom[static_cast<std::size_t>(x)];
            if (here != before && down < 0)
                down = y;
            if (here == before && down >= 0)
                lines << QLineF(x, std::exchange(down, -1), x, y);
            before = here;
        }
    }
    return lines;
}

void ArtworkCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), deskColour(palette()));
    if (draft_.plate) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        paintArtwork(painter);
        painter.setRenderHint(QPainter::Antialiasing);
        paintForm(painter);
        paintMarks(painter);
        tool_->paint(painter);
        drawBadge(painter, QRectF(rect()).adjusted(10, 10, -10, -10), hint());
    }
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void ArtworkCanvas::paintArtwork(QPainter& painter) const {
    const QRectF sheet = view_.sheet();
    paintShadow(painter, sheet);
    const ArtworkPlate& plate = *draft_.plate;
    if (plate.levels.front().hasAlphaChannel())
        paintChecks(painter, sheet & QRectF(rect()));
    // The smallest level that still has a pixel for each of the screen's.
    const double wanted = sheet.width() * devicePixelRatioF();
    const QImage* level = &plate.levels.front();
    for (const QImage& smaller : plate.levels)
        if (smaller.width() >= wanted)
            level = &smaller;
    if (view_.scale() * devicePixelRatioF() * plate.reduction() > 3)
        painter.setRenderHint(QPainter::SmoothPixmapTransform, false); // so large, pixels are better seen as they are
    painter.drawImage(sheet, *level);
    if (!sharper_.picture.isNull() && view_.scale() * devicePixelRatioF() * plate.reduction() > 1) {
        const QRectF part = sharper_.part;
        painter.drawImage(
            QRectF(view_.toWidget({part.left(), part.top()}), view_.toWidget({part.right(), part.bottom()})),
            sharper_.picture);
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
}

void ArtworkCanvas::paintMask(QPainter& painter, const Mask& mask, const QVector<QRgb>& colours) const {
    const QRectF sheet = view_.sheet();
    const QRectF seen = sheet & QRectF(rect());
    if (seen.isEmpty() || mask.empty())
        return;
    QImage all(mask.values.data(), mask.width, mask.height, mask.width, QImage::Format_Indexed8); // no copy
    all.setColorTable(colours);
    const double perPixel = sheet.width() / mask.width;
    const QRect part =
        QRectF((seen.topLeft() - sheet.topLeft()) / perPixel, seen.size() / perPixel).toAlignedRect() & all.rect();
    const QRectF target(sheet.topLeft() + QPointF(part.topLeft()) * perPixel, QSizeF(part.size()) * perPixel);
    painter.drawImage(target, all.copy(part).convertToFormat(QImage::Format_ARGB32_Premultiplied));
}

void ArtworkCanvas::paintForm(QPainter& painter) {
    if (draft_.form == FormKind::region && draft_.region) {
        static const QVector<QRgb> kVeil = shades(QColor(96, 100, 108, 150), true);
        paintMask(painter, *draft_.region, kVeil);
        if (!regionBorder_)
            regionBorder_ = borderOf(*draft_.region);
        painter.save();
        const QRectF sheet = view_.sheet();
        painter.translate(sheet.topLeft());
        const double perPixel = sheet.width() / draft_.region->width;
        painter.scale(perPixel, perPixel);
        const auto cosmetic = [&](const QColor& colour, double width) {
            QPen pen(colour, width, Qt::SolidLine, Qt::RoundCap);
            pen.setCosmetic(true);
            painter.setPen(pen);
            painter.drawLines(*regionBorder_);
        };
        cosmetic(QColor(255, 255, 255, 225), 3.6);
        cosmetic(palette().color(QPalette::Highlight), 1.6);
        painter.restore();
    }
    if (draft_.ignored && draft_.form != FormKind::swatches) {
        static const QVector<QRgb> kIgnored = shades(QColor(214, 40, 90, 150), false);
        paintMask(painter, *draft_.ignored, kIgnored);
    }
    if (draft_.form == FormKind::ellipse && draft_.ellipse)
        drawHaloOutline(painter, outlineOf(*draft_.ellipse, view_), palette().color(QPalette::Highlight), 1.8);
}

void ArtworkCanvas::paintMarks(QPainter& painter) const {
    if (draft_.form == FormKind::region) {
        for (const ArtPath& path : draft_.marks.open) {
            drawHaloLine(painter, outlineOf(path, view_), kInk, 2.4);
            QPen dots(Qt::white, 2.4, Qt::DotLine);
            painter.setPen(dots);
            painter.drawPolyline(outlineOf(path, view_));
        }
        for (const Crease& crease : draft_.marks.creases)
            drawHaloLine(painter, outlineOf(crease.path, view_), kInk, 2);
        for (const NormalMark& mark : draft_.marks.normals)
            drawNormal(painter, view_.toWidget(mark.at), mark.normal, kInk);
    }
    if (draft_.form != FormKind::swatches)
        return;
    for (std::size_t i = 0; i < kSwatchRoles; ++i) {
        const auto& swatch = draft_.swatches.picked[i];
        if (!swatch)
            continue;
        const QPointF at = view_.toWidget(swatch->at);
        drawRoundHandle(painter, at, kInk);
        drawTag(painter, at + QPointF(kMarkHandle + 5, 0), roleName(static_cast<SwatchRole>(i)));
    }
}

} // namespace limner
