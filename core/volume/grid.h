#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>

namespace limner {

/// Where a volume's voxels lie in space. Physical space is LPS (x to the patient's left, y to posterior, z to
/// superior) in mm. Voxel (i, j, k) has its centre at `originMm + direction * (spacingMm * (i, j, k))`; i runs fastest.
/// Voxels are boxes around their centres, so the volume reaches half a voxel past the outer centres
/// (a one-voxel axis is `spacing` thick).
struct Grid {
    glm::ivec3 dims{0};
    glm::dvec3 spacingMm{1}; ///< > 0 and finite
    glm::dmat3 direction{1}; ///< columns: unit directions of the i, j, k axes, orthogonal; may be left-handed
    glm::dvec3 originMm{0};  ///< centre of voxel (0, 0, 0)

    friend bool operator==(const Grid&, const Grid&) = default;

    [[nodiscard]] std::size_t voxelCount() const {
        return static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z);
    }
    [[nodiscard]] double smallestSpacingMm() const;
    /// Columns: step in mm for one voxel along i, j, k.
    [[nodiscard]] glm::dmat3 voxelToMmMatrix() const;
    [[nodiscard]] glm::dmat3 mmToVoxelMatrix() const;
    [[nodiscard]] glm::dvec3 mmFromVoxel(const glm::dvec3& voxel) const;
    [[nodiscard]] glm::dvec3 voxelFromMm(const glm::dvec3& mm) const;
    /// Middle of the volume's box.
    [[nodiscard]] glm::dvec3 centreMm() const;
    /// Extent of the box along its own axes: dims * spacing.
    [[nodiscard]] glm::dvec3 sizeMm() const;
    /// Length of the box's diagonal.
    [[nodiscard]] double diagonalMm() const;
};

} // namespace limner
