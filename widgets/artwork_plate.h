#pragma once

#include "core/style/extraction/artwork.h"

#include <QImage>
#include <QSize>

#include <memory>
#include <vector>

namespace limner {

/// Pixels of an artwork, a cut of it or a region shaded again.
using ArtPixels = decltype(ArtCut::picture);

/// An artwork with its pictures for the screen. Immutable; made off the interface's thread.
struct ArtworkPlate {
    explicit ArtworkPlate(std::shared_ptr<const Artwork> opened);

    std::shared_ptr<const Artwork> artwork;
    std::vector<QImage> levels; ///< of the reduced copy; the first has its pixels, each next one half as many a side

    [[nodiscard]] QSize size() const { return {artwork->width(), artwork->height()}; }
    /// Artwork pixels per pixel of the reduced copy. Masks of a draft are as large as that copy.
    [[nodiscard]] double reduction() const { return artwork->reduced().scale; }
    [[nodiscard]] QSize reducedSize() const { return levels.front().size(); }
};

using PlatePtr = std::shared_ptr<const ArtworkPlate>;

/// 8 bits a channel, alpha not premultiplied.
QImage imageOf(const ArtPixels& pixels);
ArtPixels pixelsOf(const QImage& image);

} // namespace limner
