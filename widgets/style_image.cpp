#include "widgets/style_image.h"

#include "core/figure/figure.h"

#include <QColor>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

const QColor kMissing(128, 128, 128);

int byteOf(double value) { return static_cast<int>(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

QColor colourOf(const glm::dvec3& rgb) { return {byteOf(rgb.x), byteOf(rgb.y), byteOf(rgb.z)}; }

/// Calls `colour(x, y)` for normals over the disk; the rim is softened over one pixel.
template <typename Colour>
QImage ball(int pixels, const Colour& colour) {
    QImage image(pixels, pixels, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    const double radius = pixels / 2.0;
    for (int row = 0; row < pixels; ++row)
        for (int column = 0; column < pixels; ++column) {
            const double x = (column + 0.5) / radius - 1;
            const double y = 1 - (row + 0.5) / radius;
            const double coverage = std::clamp((1 - std::hypot(x, y)) * radius + 0.5, 0.0, 1.0);
            if (coverage <= 0)
                continue;
            QColor c = colour(x, y);
            c.setAlphaF(static_cast<float>(c.alphaF() * coverage));
            image.setPixelColor(column, row, c);
        }
    return image;
}

} // namespace

QImage styleBall(const LitSphere& sphere, int pixels) {
    return ball(pixels, [&](double x, double y) {
        const Rgba c = sphere.at(x, y);
        return QColor(byteOf(c.r), byteOf(c.g), byteOf(c.b), byteOf(c.a));
    });
}

QImage colourBall(const QColor& colour, int pixels) {
    return ball(pixels, [&](double, double) { return colour; });
}

QImage nodeBall(const Figure& figure, const TransferNode& node, int pixels) {
    const StyleEntry* entry = node.rgb ? nullptr : figure.findStyle(node.style);
    if (entry && entry->sphere) {
        QImage image = colourBall(Qt::white, pixels);
        QPainter(&image).drawImage(0, 0, styleBall(*entry->sphere, pixels));
        return image;
    }
    return colourBall(nodeColour(figure, node), pixels);
}

QColor nodeColour(const Figure& figure, const TransferNode& node) {
    if (node.rgb)
        return colourOf(*node.rgb);
    const StyleEntry* entry = figure.findStyle(node.style);
    if (!entry || !entry->sphere)
        return kMissing;
    const Rgba mean = entry->sphere->mean();
    return colourOf({mean.r, mean.g, mean.b});
}

} // namespace limner
