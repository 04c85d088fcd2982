#include "core/volume/grid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace limner {

double Grid::smallestSpacingMm() const { return std::min({spacingMm.x, spacingMm.y, spacingMm.z}); }

glm::dmat3 Grid::voxelToMmMatrix() const {
    return {direction[0] * spacingMm.x, direction[1] * spacingMm.y, direction[2] * spacingMm.z};
}

glm::dmat3 Grid::mmToVoxelMatrix() const { return glm::inverse(voxelToMmMatrix()); }

glm::dvec3 Grid::mmFromVoxel(const glm::dvec3& voxel) const { return originMm + voxelToMmMatrix() * voxel; }

glm::dvec3 Grid::voxelFromMm(const glm::dvec3& mm) const { return mmToVoxelMatrix() * (mm - originMm); }

glm::dvec3 Grid::centreMm() const { return mmFromVoxel((glm::dvec3(dims) - 1.0) * 0.5); }

glm::dvec3 Grid::sizeMm() const { return glm::dvec3(dims) * spacingMm; }

double Grid::diagonalMm() const { return glm::length(sizeMm()); }

} // namespace limner
