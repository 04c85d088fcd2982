#pragma once

#include "renderer/backend.h"
#include "renderer/plan/planner.h"

#include <vector>

namespace limner::accuracy {

/// Places of a picture that stand for all of it (spec accuracy.md 1.8): tiles of 8 x 8 pixels, one at a place of its
/// own in each of 8 x 8 strata, and a tenth as many where the picture varies most. Tiles, not single pixels, so that
/// what they cost is what rays that march together cost. Half of them are searched, the other half only verifies.
struct Probe {
    static constexpr int kEdge = 8; ///< of a tile, in pixels
    std::vector<Tile> searched;
    std::vector<Tile> heldOut;
    [[nodiscard]] double pixels() const; ///< of all its tiles
};

/// The same for the same plan. Draws a small picture of the figure to see where it varies.
Probe chooseProbe(const Figure& figure, const RenderPlan& plan, const Backend& backend, Planner& planner, Task& task);

/// What the tiles look like, one below the other, and how long that takes.
struct ProbePicture {
    Picture picture;
    double seconds = 0; ///< the least of the repeats; 0 without repeats
    double median = 0;
    double spread = 0; ///< between the quartiles
    std::uint64_t samples = 0;
};

/// How often a measurement is repeated: until `most` times or `seconds` are up, whichever is first. One more goes
/// before, untimed.
struct Repeats {
    int most = 0; ///< 0: not timed
    double seconds = 0;
};

ProbePicture drawProbe(const RenderPlan& plan, const std::vector<Tile>& tiles, const Backend& backend,
                       const Repeats& repeats, Task& task);

} // namespace limner::accuracy
