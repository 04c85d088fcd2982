#include "core/volume/grid_cover.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>

namespace limner {

namespace {

/// Half a box's extent along a direction.
double reach(const Grid& grid, const glm::dvec3& direction) {
    const glm::dvec3 half = grid.sizeMm() / 2.0;
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        sum += half[axis] * std::abs(glm::dot(grid.direction[axis], direction));
    }
    return sum;
}

} // namespace

bool boxesOverlap(const Grid& a, const Grid& b) {
    // Two boxes are apart where their shadows on a face's normal of one of them, or on a direction across an edge of
    // each, are (Gottschalk, Lin and Manocha 1996, section 5).
    const glm::dvec3 between = b.centreMm() - a.centreMm();
    const double slack = 1e-9 * (a.diagonalMm() + b.diagonalMm());
    const auto apart = [&](const glm::dvec3& direction) {
        const double length = glm::length(direction);
        constexpr double kParallel = 1e-9; // edges along each other part nothing that the faces do not
        return length > kParallel &&
               std::abs(glm::dot(between, direction)) + slack * length >= reach(a, direction) + reach(b, direction);
    };
    for (int i = 0; i < 3; ++i) {
        if (apart(a.direction[i]) || apart(b.direction[i])) {
            return false;
        }
        for (int j = 0; j < 3; ++j) {
            if (apart(glm::cross(a.direction[i], b.direction[j]))) {
                return false;
            }
        }
    }
    return true;
}

double coveredShare(const Grid& box, const Grid& cover) {
    constexpr int kPoints = 32; // along each axis
    const glm::dmat3 toCover = cover.mmToVoxelMatrix();
    const glm::dvec3 high = glm::dvec3(cover.dims) - 0.5;
    int inside = 0;
    for (int i = 0; i < kPoints * kPoints * kPoints; ++i) {
        const glm::dvec3 share =
            (glm::dvec3(i % kPoints, i / kPoints % kPoints, i / kPoints / kPoints) + 0.5) / double{kPoints};
        const glm::dvec3 mm = box.mmFromVoxel(share * glm::dvec3(box.dims) - 0.5);
        const glm::dvec3 voxel = toCover * (mm - cover.originMm);
        const bool in =
            glm::all(glm::greaterThanEqual(voxel, glm::dvec3(-0.5))) && glm::all(glm::lessThan(voxel, high));
        inside += in ? 1 : 0;
    }
    return inside / static_cast<double>(kPoints * kPoints * kPoints);
}

} // namespace limner
