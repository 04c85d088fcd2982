#pragma once

#include "renderer/marks/dot_pattern.h"
#include "renderer/marks/ink.h"
#include "renderer/marks/mixed_bits.h"

#include <cmath>

namespace limner {

// Dots that lie on the volume and turn with it.

/// A drawing is of dots, not of greys: most of them are whole. A dot fades over the last unit of N, or over this part
/// of a smaller N: the mean ink stays N.
inline constexpr float kFadingPart = 0.3F;
/// |n.e| at which a dot on the edge of a form is whole: none comes or goes all at once as the form turns.
inline constexpr float kWholeFacing = 0.03F;
inline constexpr float kFaintest = 0.02F; ///< opacity that nobody sees

/// A point of a voxel's face.
struct FacePoint {
    glm::vec2 onFace{0}; ///< in edges of the face from its middle
    float rank = 0;      ///< share of the pattern's points that are drawn before it
    std::uint16_t random = 0;
    /// How far before the surface it lies, in spreads: in [-1, 1).
    [[nodiscard]] float chance() const { return static_cast<float>(random) * 0x1p-15F - 1; }
};

/// The voxels' points: those of the pattern over the face of the voxel that its surface crosses most squarely.
/// Neighbours share the plane's pattern, so that there is no seam between them.
class FacePoints {
  public:
    FacePoints(const MarkField& field, const Stipple& stipple)
        : seed_(seedBits(stipple)), spreadMm_(static_cast<float>(stipple.spreadVoxels * field.mmPerVoxel)) {
        const double dot = largestDotArea(stipple);
        const double scale = field.paperPerMm * field.zoom * kZoomHeadroom;
        const double densest = DotPattern::kMostDensity / static_cast<double>(kSmallestDot * kSmallestDot);
        capacity_ = field.mmPerVoxel * field.mmPerVoxel * scale * scale / dot * densest;
        edge_ = std::sqrt(capacity_);
    }
    /// Points of a whole face.
    [[nodiscard]] double capacity() const { return capacity_; }
    /// Of dots before and behind the surface.
    [[nodiscard]] float spreadMm() const { return spreadMm_; }

    /// Calls `use(FacePoint)` for the points of a voxel whose rank is below `end`. `face`: the voxel's.
    template <typename Use>
    void forEachOf(const MarkVoxel& voxel, const MarkFace& face, float end, const Use& use) const {
        const auto perEdge = static_cast<float>(1 / edge_);
        // A body's front and back have patterns of their own: they may lie behind one another.
        const auto side = static_cast<std::uint32_t>(2 * face.axis + (face.rising ? 1 : 0));
        const glm::dvec2 offset = DotPattern::offsetOf(mixedBits(seed_ + side));
        const glm::dvec2 low(static_cast<double>(voxel.cell[face.across[0]]) * edge_ + offset.x,
                             static_cast<double>(voxel.cell[face.across[1]]) * edge_ + offset.y);
        dotPattern().forEachIn(low, low + edge_, end, [&](const glm::vec2& place, float rank, std::uint32_t number) {
            use(FacePoint{place * perEdge - 0.5F, rank, static_cast<std::uint16_t>(number >> 16)});
        });
    }

  private:
    static constexpr double kZoomHeadroom = 1.5; ///< a field serves views up to the square root of 2 nearer

    std::uint32_t seed_;
    float spreadMm_;
    double capacity_ = 1;
    double edge_ = 1; ///< of the face in the pattern's plane
};

} // namespace limner
