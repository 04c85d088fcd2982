#include "core/volume/slice.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <tbb/parallel_for.h>

#include <limits>

namespace limner {

SliceAxes sliceAxes(SlicePlane plane) {
    switch (plane) {
    case SlicePlane::axial: return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    case SlicePlane::coronal: return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    case SlicePlane::sagittal: break;
    }
    return {{0, 1, 0}, {0, 0, -1}, {1, 0, 0}};
}

std::vector<float> sliceThrough(const Volume& volume, const SliceRequest& request, Task& task) {
    const Grid& grid = volume.grid();
    const SliceAxes axes = sliceAxes(request.plane);
    const glm::dvec2 half = glm::dvec2(request.pixels - 1) / 2.0;
    const glm::dvec3 corner = request.middleMm - (axes.right * half.x + axes.down * half.y) * request.mmPerPixel;
    const glm::dvec3 start = grid.voxelFromMm(corner);
    const glm::dvec3 across = grid.mmToVoxelMatrix() * (axes.right * request.mmPerPixel);
    const glm::dvec3 downwards = grid.mmToVoxelMatrix() * (axes.down * request.mmPerPixel);
    const glm::dvec3 end = glm::dvec3(grid.dims) - 0.5; // voxels reach half a step past their centres
    std::vector<float> values(static_cast<std::size_t>(request.pixels.x) * static_cast<std::size_t>(request.pixels.y),
                              std::numeric_limits<float>::quiet_NaN());
    tbb::parallel_for(0, request.pixels.y, [&](int y) {
        if (task.cancelled())
            return;
        float* row = values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(request.pixels.x);
        for (int x = 0; x < request.pixels.x; ++x) {
            const glm::dvec3 at = start + across * static_cast<double>(x) + downwards * static_cast<double>(y);
            if (glm::all(glm::greaterThanEqual(at, glm::dvec3(-0.5))) && glm::all(glm::lessThanEqual(at, end)))
                row[x] = static_cast<float>(trilinear(volume, at));
        }
    });
    task.throwIfCancelled();
    return values;
}

} // namespace limner
