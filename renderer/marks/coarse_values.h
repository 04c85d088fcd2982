#pragma once

#include "core/base/task.h"
#include "core/volume/grid.h"
#include "core/volume/volume.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace limner {

/// Numbers on a grid, x fastest; outside the border repeats. Internal to marks.
class CoarseValues {
  public:
    static constexpr int kApron = 3; ///< cells around the grid that may be read

    CoarseValues() = default;
    explicit CoarseValues(const glm::ivec3& dims);

    [[nodiscard]] const glm::ivec3& dims() const { return dims_; }
    [[nodiscard]] float* row(int y, int z) { return values_.data() + index({0, y, z}); }
    [[nodiscard]] const float* row(int y, int z) const { return values_.data() + index({0, y, z}); }
    /// A cell, or one of the apron's.
    [[nodiscard]] float at(int x, int y, int z) const { return values_[index({x, y, z})]; }
    /// Where a cell is; its neighbours are 1, `rowStep` and `sliceStep` away.
    [[nodiscard]] const float* place(const glm::ivec3& cell) const { return values_.data() + index(cell); }
    [[nodiscard]] std::ptrdiff_t rowStep() const { return pitch_.x; }
    [[nodiscard]] std::ptrdiff_t sliceStep() const { return static_cast<std::ptrdiff_t>(pitch_.x) * pitch_.y; }
    /// Copies the border into the apron, when all cells are written.
    void fillApron();

  private:
    [[nodiscard]] std::size_t index(const glm::ivec3& cell) const {
        return (static_cast<std::size_t>(cell.z + kApron) * static_cast<std::size_t>(pitch_.y) +
                static_cast<std::size_t>(cell.y + kApron)) *
                   static_cast<std::size_t>(pitch_.x) +
               static_cast<std::size_t>(cell.x + kApron);
    }

    glm::ivec3 dims_{0};
    glm::ivec3 pitch_{0}; ///< cells of a row, rows of a slice, slices, with the apron
    std::vector<float> values_;
};

/// The volume's values over its range, 0 to 1, as means over boxes of voxels (paper 004, 4.2). A constant volume is 0.
CoarseValues boxFiltered(const Volume& volume, const glm::ivec3& voxelsPerCell, Task& task);

/// Where the cells of boxes lie: a box at the far end that is cut keeps its place.
Grid coarseGrid(const Grid& grid, const glm::ivec3& voxelsPerCell);

/// Value and gradient at a cell.
struct CellSlope {
    glm::vec3 gradient{0}; ///< per cell along the axes
    float value = 0;
};

/// Neumann et al.'s regression: the hyperplane that fits 27 cells best (paper 004, 4.1).
CellSlope neumannSlope(const CoarseValues& values, const glm::ivec3& cell);
/// Central differences.
CellSlope centralSlope(const CoarseValues& values, const glm::ivec3& cell);

/// Laplacian of Gaussian with a standard deviation of one cell, per cell squared: 0 on linear data and 2 a on a x^2.
float laplacianOfGaussian(const CoarseValues& values, const glm::ivec3& cell);

} // namespace limner
