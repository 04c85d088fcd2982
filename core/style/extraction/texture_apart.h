#pragma once

#include "core/style/extraction/artwork.h"
#include "core/style/extraction/normals.h"
#include "core/style/texture_tile.h"

#include <memory>

namespace limner {

/// What the lighting does not explain, as a tile (paper 000's open problem): the artwork divided by the region shaded
/// again, over the largest square of the region that faces the viewer, with mean 1 and made to repeat without a seam.
/// Null where that square has fewer than 24 pixels a side. `looked`: pixels that count, over the cut.
std::shared_ptr<const TextureTile> textureApart(const ArtPicture& art, const NormalField& normals,
                                                const ArtPicture& reshaded, const Mask& looked);

} // namespace limner
