#include "renderer/marks/coarse_values.h"

#include "core/volume/brick_rows.h"

#include <glm/common.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace limner {

namespace {

constexpr int kLogReach = 3; // cells: what a Gaussian of one cell has beyond is a thousandth

/// Weights of the Laplacian of Gaussian in a cube; their sum is 0 and their second moments along every axis are 2.
struct LogKernel {
    static constexpr int kEdge = 2 * kLogReach + 1;
    std::array<float, kEdge * kEdge * kEdge> weights{};

    LogKernel() {
        std::array<double, kEdge> gauss{};
        std::array<double, kEdge> second{};
        for (int i = 0; i < kEdge; ++i) {
            const double d = i - kLogReach;
            gauss[static_cast<std::size_t>(i)] = std::exp(-0.5 * d * d);
        }
        normalise(
            gauss, [](double) { return 1.0; }, 1);
        double mean = 0;
        for (int i = 0; i < kEdge; ++i) {
            const double d = i - kLogReach;
            second[static_cast<std::size_t>(i)] = (d * d - 1) * std::exp(-0.5 * d * d);
            mean += second[static_cast<std::size_t>(i)] / kEdge;
        }
        for (double& w : second) {
            w -= mean;
        }
        normalise(
            second, [](double d) { return d * d; }, 2);
        std::size_t at = 0;
        for (std::size_t z = 0; z < kEdge; ++z)
            for (std::size_t y = 0; y < kEdge; ++y)
                for (std::size_t x = 0; x < kEdge; ++x) {
                    weights[at++] =
                        static_cast<float>(second[x] * gauss[y] * gauss[z] + gauss[x] * second[y] * gauss[z] +
                                           gauss[x] * gauss[y] * second[z]);
                }
    }

    template <typename Moment>
    static void normalise(std::array<double, kEdge>& weights, const Moment& moment, double wanted) {
        double sum = 0;
        for (int i = 0; i < kEdge; ++i) {
            sum += weights[static_cast<std::size_t>(i)] * moment(i - kLogReach);
        }
        for (double& w : weights) {
            w *= wanted / sum;
        }
    }
};

} // namespace

CoarseValues::CoarseValues(const glm::ivec3& dims)
    : dims_(dims),
      values_(static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z)) {}

std::size_t CoarseValues::index(const glm::ivec3& cell) const {
    return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(dims_.y) + static_cast<std::size_t>(cell.y)) *
               static_cast<std::size_t>(dims_.x) +
           static_cast<std::size_t>(cell.x);
}

float CoarseValues::at(int x, int y, int z) const {
    return values_[index(glm::clamp(glm::ivec3(x, y, z), glm::ivec3(0), dims_ - 1))];
}

float CoarseValues::at(const glm::vec3& place) const {
    const glm::vec3 inside = glm::clamp(place, glm::vec3(0), glm::vec3(dims_ - 1));
    const glm::ivec3 c(inside);
    const glm::vec3 f = inside - glm::vec3(c);
    const auto alongX = [&](int dy, int dz) {
        return glm::mix(at(c.x, c.y + dy, c.z + dz), at(c.x + 1, c.y + dy, c.z + dz), f.x);
    };
    return glm::mix(glm::mix(alongX(0, 0), alongX(1, 0), f.y), glm::mix(alongX(0, 1), alongX(1, 1), f.y), f.z);
}

Grid coarseGrid(const Grid& grid, const glm::ivec3& n) {
    Grid coarse = grid;
    coarse.dims = (grid.dims + n - 1) / n;
    coarse.spacingMm = grid.spacingMm * glm::dvec3(n);
    coarse.originMm = grid.mmFromVoxel(0.5 * glm::dvec3(n - 1));
    return coarse;
}

CoarseValues boxFiltered(const Volume& volume, const glm::ivec3& n, Task& task) {
    const glm::ivec3 dims = volume.grid().dims;
    CoarseValues coarse((dims + n - 1) / n);
    const ValueRange range = volume.range();
    const double span = range.high - range.low;
    if (!(span > 0)) {
        return coarse;
    }
    tbb::parallel_for(0, coarse.dims().z, [&](int cz) {
        if (task.cancelled()) {
            return;
        }
        std::vector<std::byte> stored(static_cast<std::size_t>(dims.x) * bytesPerVoxel(volume.type()));
        std::vector<double> sums(static_cast<std::size_t>(coarse.dims().x));
        for (int cy = 0; cy < coarse.dims().y; ++cy) {
            std::fill(sums.begin(), sums.end(), 0.0);
            const int z1 = std::min((cz + 1) * n.z, dims.z);
            const int y1 = std::min((cy + 1) * n.y, dims.y);
            for (int z = cz * n.z; z < z1; ++z) {
                for (int y = cy * n.y; y < y1; ++y) {
                    volume.copyRow(y, z, stored.data());
                    withVoxelType(volume.type(), [&](auto* none) {
                        const auto* numbers = reinterpret_cast<decltype(none)>(stored.data());
                        for (int x = 0; x < dims.x; ++x) {
                            sums[static_cast<std::size_t>(x / n.x)] += static_cast<double>(numbers[x]);
                        }
                    });
                }
            }
            const int boxYz = (z1 - cz * n.z) * (y1 - cy * n.y);
            float* out = coarse.row(cy, cz);
            for (int cx = 0; cx < coarse.dims().x; ++cx) {
                const int count = boxYz * (std::min((cx + 1) * n.x, dims.x) - cx * n.x);
                const double value = volume.valueFromStored(sums[static_cast<std::size_t>(cx)] / count);
                out[cx] = static_cast<float>(std::clamp((value - range.low) / span, 0.0, 1.0));
            }
        }
    });
    task.throwIfCancelled();
    return coarse;
}

CellSlope neumannSlope(const CoarseValues& values, const glm::ivec3& c) {
    CellSlope slope;
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            const float low = values.at(c.x - 1, c.y + y, c.z + z);
            const float mid = values.at(c.x, c.y + y, c.z + z);
            const float high = values.at(c.x + 1, c.y + y, c.z + z);
            const float sum = low + mid + high;
            slope.value += sum;
            slope.gradient += glm::vec3(high - low, static_cast<float>(y) * sum, static_cast<float>(z) * sum);
        }
    }
    slope.value /= 27;
    slope.gradient /= 18.0F;
    return slope;
}

CellSlope centralSlope(const CoarseValues& values, const glm::ivec3& c) {
    return {0.5F * glm::vec3(values.at(c.x + 1, c.y, c.z) - values.at(c.x - 1, c.y, c.z),
                             values.at(c.x, c.y + 1, c.z) - values.at(c.x, c.y - 1, c.z),
                             values.at(c.x, c.y, c.z + 1) - values.at(c.x, c.y, c.z - 1)),
            values.at(c.x, c.y, c.z)};
}

float laplacianOfGaussian(const CoarseValues& values, const glm::ivec3& c) {
    static const LogKernel kernel;
    double sum = 0;
    std::size_t at = 0;
    for (int z = -kLogReach; z <= kLogReach; ++z)
        for (int y = -kLogReach; y <= kLogReach; ++y)
            for (int x = -kLogReach; x <= kLogReach; ++x) {
                sum += static_cast<double>(kernel.weights[at++]) *
                       static_cast<double>(values.at(c.x + x, c.y + y, c.z + z));
            }
    return static_cast<float>(sum);
}

} // namespace limner
