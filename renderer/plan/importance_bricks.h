#pragma once

#include "renderer/plan/render_plan.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <memory>
#include <vector>

namespace limner {

/// For bricks of 16^3 cells: the greatest weighted sum of measures that a sample in one can have, before the global
/// weight and without unocclusion; below 0 where nothing shows. An upper bound: what it cannot tell cheaply it takes
/// for the greatest possible.
struct ImportanceBricks {
    static constexpr int kBlocks = 4; ///< blocks of the skip grid along an edge
    glm::ivec3 bricks{0};
    std::vector<float> greatest; ///< x fastest
};

std::shared_ptr<const ImportanceBricks> computeImportanceBricks(const RenderPlan& plan, const MinMaxGrid& lowHigh);

/// What still lies ahead on the rays of a rectangle of the picture (spec importance-composition.md: Emax_rest). The
/// volume's depth along the view is cut into slabs.
class ImportanceAhead {
  public:
    static constexpr int kSlabs = 64;
    /// For each slab the greatest of ImportanceBricks in it and behind it, never below 0.
    using Table = std::array<float, kSlabs>;

    explicit ImportanceAhead(const RenderPlan& plan);

    /// Slab of a place: dot(slabFromVoxel, (voxel, 1)), cut to 0..kSlabs - 1.
    [[nodiscard]] const std::array<double, 4>& slabFromVoxel() const { return slabFromVoxel_; }

    /// For the rays between two corners, in pixels. Thread-safe.
    [[nodiscard]] Table behind(glm::dvec2 low, glm::dvec2 high) const;

  private:
    /// A brick as the picture sees it.
    struct Seen {
        glm::dvec2 low, high; ///< pixels
        int lastSlab;
        float greatest;
    };
    std::array<double, 4> slabFromVoxel_{};
    std::vector<Seen> seen_;
};

} // namespace limner
