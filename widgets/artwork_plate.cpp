#include "widgets/artwork_plate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr int kSmallest = 256; // a level below is never nearer to what a canvas shows

uchar byteOf(float value) { return static_cast<uchar>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255)); }

} // namespace

ArtworkPlate::ArtworkPlate(std::shared_ptr<const Artwork> opened) : artwork(std::move(opened)) {
    levels.push_back(imageOf(artwork->reduced().picture));
    while (std::max(levels.back().width(), levels.back().height()) > 2 * kSmallest) {
        const QSize half = (levels.back().size() / 2).expandedTo({1, 1});
        levels.push_back(levels.back().scaled(half, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
}

QImage imageOf(const ArtPixels& pixels) {
    QImage image(pixels.width, pixels.height, QImage::Format_RGBA8888);
    for (int y = 0; y < pixels.height; ++y) {
        uchar* row = image.scanLine(y);
        for (int x = 0; x < pixels.width; ++x, row += 4) {
            const Rgba& c = pixels.at(x, y);
            row[0] = byteOf(c.r);
            row[1] = byteOf(c.g);
            row[2] = byteOf(c.b);
            row[3] = byteOf(c.a);
        }
    }
    return image;
}

ArtPixels pixelsOf(const QImage& image) {
    const QImage straight = image.convertToFormat(QImage::Format_RGBA8888);
    ArtPixels pixels;
    pixels.width = straight.width();
    pixels.height = straight.height();
    pixels.pixels.resize(pixels.offset(0, pixels.height));
    for (int y = 0; y < pixels.height; ++y) {
        const uchar* row = straight.constScanLine(y);
        for (int x = 0; x < pixels.width; ++x, row += 4)
            pixels.at(x, y) = {row[0] / 255.0F, row[1] / 255.0F, row[2] / 255.0F, row[3] / 255.0F};
    }
    return pixels;
}

} // namespace limner
