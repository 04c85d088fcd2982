#include "core/volume/gradient_statistics.h"

#include "core/volume/brick_rows.h"

#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace limner {

namespace {

constexpr std::size_t kMostSamples = 1'000'000; // the 99.9th percentile then rests on up to 1000 voxels: 3 % of it

/// What the lattice reads of one voxel; magnitudes in stored units per mm.
struct Sample {
    float value = 0;
    float gradient = 0;
    float lowestNear = 0; ///< of the voxel and the six around it
    float roughness = -1; ///< gradient magnitude as noise alone would give it; < 0: not measured here
    float fourth = 0;     ///< the same from fourth differences, which smooth matter hardly has; where roughness is
    float variation = 0;  ///< sum over the axes of |after - before|, in stored units
    float steps = 0;      ///< the part of it where the voxel equals one of the two
};

constexpr double kStrong = 1.0 / 8; ///< of p999: gradients of surfaces, down to those of weak contrast

int latticeStride(const Grid& grid) {
    int stride = 1;
    const auto samples = [&](int s) {
        const glm::ivec3 n = (grid.dims + s - 1) / s;
        return static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z);
    };
    while (samples(stride) > kMostSamples) {
        ++stride;
    }
    return stride;
}

/// How stored numbers are turned into magnitudes.
struct Measure {
    glm::vec3 halfPerMm{0.5F}; ///< per axis: 1 / (2 * spacing)
    float sign = 1;            ///< -1 where values fall as stored numbers rise
    glm::ivec3 dims{1};        ///< of the volume
};

/// What lies around a voxel.
struct Surroundings {
    bool wide = false;       ///< voxels two away may be read on every side
    glm::bvec3 within{true}; ///< by axis: both neighbours are voxels of their own, not the border's repeated
};

/// `p`: the voxel in its brick.
template <typename T>
Sample sampleAt(const T* p, const Measure& measure, const Surroundings& around) {
    constexpr std::array<int, 3> offsets = {1, BrickLayout::kRow, BrickLayout::kSlice};
    const glm::vec3& halfPerMm = measure.halfPerMm;
    const float centre = measure.sign * static_cast<float>(*p);
    Sample sample;
    sample.value = centre;
    sample.lowestNear = centre;
    float squared = 0;
    float roughness = 0;
    float fourth = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float before = measure.sign * static_cast<float>(p[-offsets[axis]]);
        const float after = measure.sign * static_cast<float>(p[offsets[axis]]);
        const float g = (after - before) * halfPerMm[axis];
        squared += g * g;
        sample.lowestNear = std::min({sample.lowestNear, before, after});
        const float variation = around.within[axis] ? std::abs(after - before) : 0;
        sample.variation += variation;
        sample.steps += centre == before || centre == after ? variation : 0;
        if (around.wide) {
            const float outer = static_cast<float>(p[-2 * offsets[axis]]) + static_cast<float>(p[2 * offsets[axis]]);
            const float d = (measure.sign * outer - 2 * centre) * halfPerMm[axis];
            roughness += d * d / 3; // variance 6 of white noise against 2 of a central difference
            const float f = (measure.sign * outer - 4 * (before + after) + 6 * centre) * halfPerMm[axis];
            fourth += f * f / 35; // variance 70 of white noise
        }
    }
    sample.gradient = std::sqrt(squared);
    sample.roughness = around.wide ? std::sqrt(roughness) : -1;
    sample.fourth = std::sqrt(fourth);
    return sample;
}

template <typename T>
void sampleBrick(const OwnedBrick<T>& brick, int stride, const Measure& measure, std::vector<Sample>& out) {
    constexpr int kLast = BrickLayout::kBrickCells - 1; // the apron after it is one voxel wide
    const glm::ivec3 last = measure.dims - 1;
    const auto firstAtOrAfter = [&](int origin) { return (stride - origin % stride) % stride; };
    for (int z = firstAtOrAfter(brick.origin.z); z < brick.size.z; z += stride) {
        for (int y = firstAtOrAfter(brick.origin.y); y < brick.size.y; y += stride) {
            const T* row = brick.row(y, z);
            for (int x = firstAtOrAfter(brick.origin.x); x < brick.size.x; x += stride) {
                const glm::ivec3 voxel = brick.origin + glm::ivec3(x, y, z);
                const Surroundings around{x < kLast && y < kLast && z < kLast,
                                          glm::bvec3(voxel.x > 0 && voxel.x<last.x, voxel.y> 0 &&
                                                     voxel.y<last.y, voxel.z> 0 && voxel.z < last.z)};
                out.push_back(sampleAt(row + x, measure, around));
            }
        }
    }
}

template <typename T>
std::vector<std::vector<Sample>> sampleVolume(const Volume& volume) {
    const int stride = latticeStride(volume.grid());
    const Measure measure{glm::vec3(0.5 / volume.grid().spacingMm), volume.contents().slope < 0 ? -1.0F : 1.0F,
                          volume.grid().dims};
    const std::size_t bricks = volume.layout().brickCount();
    std::vector<std::vector<Sample>> samples(bricks);
    tbb::parallel_for(std::size_t{0}, bricks, [&](std::size_t b) {
        const OwnedBrick<T> brick = ownedBrick<T>(volume, b);
        const glm::ivec3 n = brick.size / stride + 1;
        samples[b].reserve(static_cast<std::size_t>(n.x * n.y * n.z));
        sampleBrick(brick, stride, measure, samples[b]);
    });
    return samples;
}

/// Value that parts the samples into two classes of least variance (Otsu 1979).
float otsuThreshold(const std::vector<std::vector<Sample>>& samples, float low, float high) {
    constexpr int kBins = 256; // finer than any gap between two classes that matter
    std::array<double, kBins> counts{};
    const float scale = high > low ? (kBins - 1) / (high - low) : 0;
    double total = 0;
    double sum = 0;
    for (const auto& brick : samples) {
        for (const Sample& s : brick) {
            const int bin = std::clamp(static_cast<int>((s.value - low) * scale), 0, kBins - 1);
            counts[bin] += 1;
            sum += bin;
        }
        total += static_cast<double>(brick.size());
    }
    double below = 0;
    double sumBelow = 0;
    double best = -1;
    int threshold = 0;
    for (int i = 0; i + 1 < kBins; ++i) {
        below += counts[i];
        sumBelow += i * counts[i];
        const double above = total - below;
        if (below == 0 || above == 0) {
            continue;
        }
        const double apart = sumBelow / below - (sum - sumBelow) / above;
        if (below * above * apart * apart > best) {
            best = below * above * apart * apart;
            threshold = i + 1;
        }
    }
    return scale > 0 ? low + static_cast<float>(threshold) / scale : low;
}

float quantile(std::vector<float>& values, double fraction) {
    if (values.empty()) {
        return 0;
    }
    const auto n = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + n, values.end());
    return values[static_cast<std::size_t>(n)];
}

GradientStatistics statisticsOf(const std::vector<std::vector<Sample>>& samples, float threshold) {
    std::vector<float> gradients;
    std::vector<float> roughness;
    float largest = 0;
    std::size_t count = 0;
    for (const auto& brick : samples) {
        count += brick.size();
        for (const Sample& s : brick) {
            largest = std::max(largest, s.gradient);
            if (s.roughness >= 0 && s.lowestNear > threshold) {
                roughness.push_back(s.roughness);
            }
        }
    }
    // Only the largest magnitudes can hold the percentile: drop the mass of zeros that air brings before sorting.
    for (const float floor : {largest / 64, 0.0F}) {
        gradients.clear();
        for (const auto& brick : samples) {
            for (const Sample& s : brick) {
                if (s.gradient >= floor) {
                    gradients.push_back(s.gradient);
                }
            }
        }
        if (static_cast<double>(gradients.size()) > 0.001 * static_cast<double>(count) + 1) {
            break;
        }
    }
    GradientStatistics statistics;
    if (!gradients.empty()) {
        const double outside = 0.001 * static_cast<double>(count - 1) / static_cast<double>(gradients.size());
        statistics.p999 = quantile(gradients, std::clamp(1 - outside, 0.0, 1.0));
    }
    if (!(statistics.p999 > 0)) {
        statistics.p999 = largest; // so sparse that the percentile falls into nothing
    }
    statistics.noise = quantile(roughness, 0.5);
    return statistics;
}

double noiseToSignalOf(const std::vector<std::vector<Sample>>& samples, double p999) {
    std::vector<float> ratios;
    for (const auto& brick : samples) {
        for (const Sample& s : brick) {
            if (s.roughness >= 0 && s.gradient > 0 && s.gradient >= kStrong * p999) {
                ratios.push_back(s.fourth / s.gradient);
            }
        }
    }
    return quantile(ratios, 0.5);
}

double stepShareOf(const std::vector<std::vector<Sample>>& samples) {
    double variation = 0;
    double steps = 0;
    for (const auto& brick : samples) {
        for (const Sample& s : brick) {
            variation += s.variation;
            steps += s.steps;
        }
    }
    return variation > 0 ? steps / variation : 0;
}

} // namespace

GradientStatistics computeGradientStatistics(const Volume& volume) {
    const auto samples = withVoxelType(
        volume.type(), [&](auto* none) { return sampleVolume<std::remove_cvref_t<decltype(*none)>>(volume); });
    const double sign = volume.contents().slope < 0 ? -1 : 1;
    const auto low = static_cast<float>(sign * volume.storedFromValue(volume.range().low));
    const auto high = static_cast<float>(sign * volume.storedFromValue(volume.range().high));
    GradientStatistics statistics = statisticsOf(samples, otsuThreshold(samples, low, high));
    statistics.noiseToSignal = noiseToSignalOf(samples, statistics.p999);
    statistics.stepShare = stepShareOf(samples);
    const double unit = std::abs(volume.contents().slope);
    statistics.p999 *= unit;
    statistics.noise *= unit;
    return statistics;
}

} // namespace limner
