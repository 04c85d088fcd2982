#pragma once

#include "core/style/extraction/picture.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace limner {

class Task;

/// One pixel's word for the colour of its normal.
struct Vote {
    float x = 0; ///< of the normal, in the unit disk
    float y = 0; ///< n_y UP
    float r = 0; ///< sRGB-encoded
    float g = 0;
    float b = 0;
    float weight = 1;      ///< 0..1
    std::uint8_t half = 0; ///< 0 or 1: which half of the region it belongs to
};

/// Colours over the disk of normals, gathered from votes.
struct Gathered {
    ArtPicture picture; ///< square; alpha 1 where there were votes, else 0 and the colour is undefined
    /// A vote's distance from the gathered colour at its normal, by the sphere of the OTHER half's votes: RMS.
    std::optional<double> heldOutRmse; ///< where it was asked for: it costs two fits more
};

/// The side of the picture that so many votes fill: two thirds of one a texel, or up to four times as many. 32..512.
int gatheredSide(std::size_t votes);

/// A robust local-linear fit of the votes around each texel: planes through weighted votes, on a pyramid; the finest
/// level with votes enough counts, more where they disagree. Up to a quarter of the votes at a place may be outliers
/// (letters, grain) and are left out; more than that is taken for texture or hatching and averaged. A texel further
/// than 2 % of the disk's width from votes enough is a hole. Throws Error(cancelled).
enum class HeldOut { measured, left };
Gathered gatherVotes(std::vector<Vote> votes, HeldOut heldOut, Task& task);

} // namespace limner
