#pragma once

#include "core/base/task.h"
#include "core/figure/effects.h"
#include "core/volume/grid.h"
#include "renderer/plan/render_plan.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace limner {

/// What marks are made of: a volume's surfaces, once per volume and settings, for every view (paper 004, 4).

/// A voxel of the marks' own grid with enough gradient to have marks.
struct MarkVoxel {
    glm::u16vec3 cell{0};
    std::uint8_t layer = 0; ///< of MarkField::layerNames
    glm::vec3 normalMm{0};  ///< unit, patient coordinates, out of the denser matter
    float value = 0;        ///< v, in [0, 1]
    float gradient = 0;     ///< |g| over its 99.9th percentile, at most 1
    /// Area of the surface that the voxel draws, in faces of a cube of its volume. Of a surface some voxels thick one
    /// draws, where it is strongest in its column along the axis that crosses it most squarely; the others have 0.
    float share = 0;
    float edge = 0;         ///< Laplacian of Gaussian of v, per voxel squared
    float edgeOffsetMm = 0; ///< along the normal to where the surface is, the same place for all of a column
    float dataValue = 0;    ///< in the data's unit: what styles read
};

/// How the surface bends at a mark voxel, 1/mm; positive: bulging outwards.
struct MarkCurvature {
    glm::vec3 directionMm{0}; ///< of `most`, unit, in the tangent plane; 0: not known
    float most = 0;           ///< the principal curvature of larger size
    float least = 0;
};

/// The part of a surface that a mark voxel draws: its tangent plane over the face that the surface crosses most
/// squarely.
struct MarkFace {
    int axis = 0;           ///< of the grid, across the face
    int across[2]{1, 2};    ///< the other two
    bool rising = false;    ///< whether the normal runs up that axis
    glm::dvec3 middleMm{0}; ///< moved onto the surface along the axis, so that the faces still fill the plane
    glm::dvec3 edgeMm[2]{}; ///< a cell along each of `across`, in the tangent plane
};

/// The axis of the grid that a plane crosses most squarely; `risesMm`: along its normal for a cell along each axis.
int crossingAxis(const glm::dvec3& risesMm);

/// Immutable, thread-safe.
struct MarkField {
    Grid grid;            ///< of the marks' voxels, in the same space as the volume's
    glm::dmat3 stepMm{1}; ///< columns: a cell along the grid's axes
    glm::ivec3 voxelsPerCell{1};
    std::vector<MarkVoxel> voxels; ///< x fastest
    /// Parallel to `voxels` where inner lines or hatching read them; else empty.
    std::vector<MarkCurvature> curvatures;
    std::vector<std::string> layerNames; ///< "": the data themselves
    double mmPerVoxel = 1;               ///< cube root of a cell's volume
    double paperPerMm = 1;               ///< mm on paper per mm of the volume in the view that just shows all of it
    double zoom = 1;                     ///< factor on that for which the field is fine enough
    std::vector<std::string> warnings;   ///< what was given up, one line each

    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] glm::dvec3 placeMm(const MarkVoxel& voxel) const {
        const glm::dvec3 cell(voxel.cell);
        return grid.originMm + cell.x * stepMm[0] + cell.y * stepMm[1] + cell.z * stepMm[2];
    }
    [[nodiscard]] MarkFace faceOf(const MarkVoxel& voxel) const;
    /// "Stipples", or "Stipples - Bone" where marks belong to layers.
    [[nodiscard]] std::string groupName(const std::string& family, std::size_t layer) const;
    /// Index of the mark voxel at a cell, or -1.
    [[nodiscard]] std::int64_t find(const glm::ivec3& cell) const;

    std::vector<std::uint32_t> rowStart; ///< first voxel of every row (y + dims.y z), one more at the end
};

/// Factor on the scale of the view that just shows the whole volume, a power of two of at least 1: views from nearer
/// have finer fields.
double markZoom(const RenderPlan& plan);

struct MarkDetail {
    double zoom = 1;     ///< as `markZoom` gives it
    bool moving = false; ///< coarser voxels, a fraction of the time
    friend bool operator==(const MarkDetail&, const MarkDetail&) = default;
};

/// Computes the field for a plan whose layers are there. Some seconds for 256^3 at most; parallel, deterministic.
/// Throws Error(cancelled).
std::shared_ptr<const MarkField> computeMarkField(const RenderPlan& plan, const MarkDetail& detail, Task& task);

struct SurfaceLine; // renderer/marks/inner_lines.h

/// A plan's marks: absent where the figure has none.
struct PlanMarks {
    std::shared_ptr<const MarkField> field;
    std::shared_ptr<const std::vector<SurfaceLine>> innerLines; ///< null: none are drawn
    bool moving = false;      ///< a drag: dots stay on the volume, lines are not joined
    bool layersDrawn = false; ///< the backend draws the layers too
};

} // namespace limner
