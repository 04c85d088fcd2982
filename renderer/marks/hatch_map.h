#pragma once

#include "renderer/marks/line_scene.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace limner {

/// What hatching needs to know at a place of the paper, of the nearest surface there.
struct HatchPlace {
    float tone = 0;            ///< share of inked paper
    glm::vec2 direction{1, 0}; ///< of strokes, unit, of either sign
    float depthMm = 0;
    std::uint32_t voxel = 0; ///< one that is there
};

/// The nearest inked surface at every place of the paper, with strokes' directions that are smooth where the surface
/// has none of its own. Independent of the picture's pixels; immutable, thread-safe.
class HatchMap {
  public:
    /// `tone`: parallel to the field's voxels, 0 where nothing is drawn.
    HatchMap(const LineScene& scene, std::span<const float> tone);

    /// Along the larger curvature, or across it.
    enum class Family { along, across };
    /// Nothing where no surface is, or none within some voxels of the depth `near`.
    [[nodiscard]] std::optional<HatchPlace> at(const glm::vec2& mm, Family family,
                                               std::optional<float> near = {}) const;
    [[nodiscard]] float toneAt(const glm::vec2& mm) const;
    [[nodiscard]] float cellMm() const { return cellMm_; }

  private:
    struct Cell {
        float weight = 0; ///< 0: no surface
        float tone = 0;
        float depthMm = 0;
        std::uint32_t voxel = 0;
    };
    template <typename Use>
    void forDisc(const LineScene& scene, std::size_t voxel, const Use& use) const;
    [[nodiscard]] std::vector<float> nearestOf(const LineScene& scene, const std::vector<std::uint32_t>& surface) const;
    void gather(const LineScene& scene, std::span<const float> tone, const std::vector<std::uint32_t>& surface,
                const std::vector<float>& nearest);
    void settleBorder();
    [[nodiscard]] std::size_t indexOf(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
    }

    float cellMm_ = 1;
    float jumpMm_ = 1; ///< of depth between neighbouring cells of one surface
    glm::ivec2 size_{0};
    std::vector<Cell> cells_;
    std::vector<glm::vec2> along_; ///< twice the angles of directions
    std::vector<glm::vec2> across_;
};

} // namespace limner
