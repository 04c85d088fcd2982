#include "renderer/marks/coarse_values.h"

#include "core/volume/brick_rows.h"

#include <glm/common.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace limner {

namespace {

constexpr int kLogReach = CoarseValues::kApron; // cells: what a Gaussian of one cell has beyond is a thousandth

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
    : dims_(dims), pitch_(dims + 2 * kApron),
      values_(static_cast<std::size_t>(pitch_.x) * static_cast<std::size_t>(pitch_.y) *
              static_cast<std::size_t>(pitch_.z)) {}

void CoarseValues::fillApron() {
    const auto nearest = [&](int i, int axis) { return std::clamp(i, 0, dims_[axis] - 1); };
    tbb::parallel_for(0, dims_.z, [&](int z) {
        for (int y = 0; y < dims_.y; ++y) {
            float* cells = row(y, z);
            std::fill(cells - kApron, cells, cells[0]);
            std::fill(cells + dims_.x, cells + dims_.x + kApron, cells[dims_.x - 1]);
        }
    });
    tbb::parallel_for(-kApron, dims_.z + kApron, [&](int z) {
        for (int y = -kApron; y < dims_.y + kApron; ++y) {
            if (z != nearest(z, 2) || y != nearest(y, 1)) {
                const float* from = row(nearest(y, 1), nearest(z, 2)) - kApron;
                std::copy(from, from + pitch_.x, row(y, z) - kApron);
            }
        }
    });
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
    coarse.fillApron();
    return coarse;
}

CellSlope neumannSlope(const CoarseValues& values, const glm::ivec3& c) {
    CellSlope slope;
    const float* middle = values.place(c);
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            const float* v = middle + z * values.sliceStep() + y * values.rowStep();
            const float sum = v[-1] + v[0] + v[1];
            slope.value += sum;
            slope.gradient += glm::vec3(v[1] - v[-1], static_cast<float>(y) * sum, static_cast<float>(z) * sum);
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
    float sum = 0;
    const float* weights = kernel.weights.data();
    const float* middle = values.place(c);
    for (int z = -kLogReach; z <= kLogReach; ++z)
        for (int y = -kLogReach; y <= kLogReach; ++y) {
            const float* v = middle + z * values.sliceStep() + y * values.rowStep() - kLogReach;
            for (int x = 0; x < LogKernel::kEdge; ++x) {
                sum += *weights++ * (v[x] - middle[0]); // the weights' sum is 0: nothing is lost on a high value
            }
        }
    return sum;
}

} // namespace limner
