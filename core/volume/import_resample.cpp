#include "core/base/error.h"
#include "core/volume/import_parts.h"

#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace limner::importing {

namespace {

/// A straight frame laid along a volume's rows, and where its slices lie in it.
struct Frame {
    glm::dmat3 direction{1}; ///< orthonormal
    glm::dvec3 spacingMm{1};
    double rowShear = 0;             ///< columns lean: voxels along i for one step along j
    std::vector<glm::dvec3> offsets; ///< of voxel (0, 0, k): voxels along i and j, mm along k
};

/// How slices stray from an even, straight stack around their common middle.
struct Deviation {
    double inPlaneVoxels = 0;
    double alongVoxels = 0;
};

glm::dvec3 sliceOrigin(const StoredVolume& stored, int k) {
    return stored.sliceOrigins.empty() ? stored.originMm + static_cast<double>(k) * stored.axesMm[2]
                                       : stored.sliceOrigins[static_cast<std::size_t>(k)];
}

Frame frameOf(const StoredVolume& stored) {
    Frame frame;
    const glm::dvec3 a = stored.axesMm[0];
    const glm::dvec3 x = glm::normalize(a);
    const glm::dvec3 lean = glm::dot(stored.axesMm[1], x) * x;
    const glm::dvec3 y = glm::normalize(stored.axesMm[1] - lean);
    glm::dvec3 z = glm::cross(x, y);
    const int last = stored.dims.z - 1;
    const glm::dvec3 along = last > 0 ? sliceOrigin(stored, last) - sliceOrigin(stored, 0) : stored.axesMm[2];
    if (glm::dot(along, z) < 0) {
        z = -z;
    }
    frame.direction = glm::dmat3(x, y, z);
    frame.spacingMm = {glm::length(a), glm::dot(stored.axesMm[1], y), std::abs(glm::dot(stored.axesMm[2], z))};
    frame.rowShear = glm::dot(stored.axesMm[1], x) / frame.spacingMm.x;
    for (int k = 0; k <= last; ++k) {
        const glm::dvec3 step = sliceOrigin(stored, k) - sliceOrigin(stored, 0);
        frame.offsets.emplace_back(glm::dot(step, x) / frame.spacingMm.x, glm::dot(step, y) / frame.spacingMm.y,
                                   glm::dot(step, z));
    }
    if (last > 0) {
        frame.spacingMm.z = frame.offsets.back().z / last;
    }
    return frame;
}

Deviation deviationOf(const Frame& frame, const StoredVolume& stored) {
    glm::dvec3 low(0);
    glm::dvec3 high(0);
    for (std::size_t k = 0; k < frame.offsets.size(); ++k) {
        glm::dvec3 stray = frame.offsets[k];
        stray.z = stray.z / frame.spacingMm.z - static_cast<double>(k);
        low = glm::min(low, stray);
        high = glm::max(high, stray);
    }
    const glm::dvec3 half = (high - low) / 2.0;
    const double leaning = std::abs(frame.rowShear) * (stored.dims.y - 1) / 2;
    return {std::max(half.x + leaning, half.y), half.z};
}

/// The step of the even grid that replaces uneven slices: the smallest that a tenth of the gaps have, so that the finer
/// part of a scan keeps its detail and one stray pair of slices does not blow the volume up.
double evenStep(const Frame& frame) {
    std::vector<double> gaps;
    for (std::size_t k = 1; k < frame.offsets.size(); ++k) {
        gaps.push_back(frame.offsets[k].z - frame.offsets[k - 1].z);
    }
    std::sort(gaps.begin(), gaps.end());
    const double mean = frame.spacingMm.z;
    constexpr double kAlike = 0.05; // gaps within 5 % of each other are one gap with rounding
    if (gaps.back() - gaps.front() < kAlike * mean) {
        return mean;
    }
    constexpr double kMostSlices = 8; // times as many as were scanned
    return std::max(gaps[gaps.size() / 10], mean / kMostSlices);
}

/// One output slice: which input slices it lies between and how they are shifted.
struct SliceSource {
    int k = 0;
    double share = 0; ///< of slice k + 1
};

SliceSource sourceAt(const Frame& frame, double along) {
    const auto above = std::upper_bound(frame.offsets.begin(), frame.offsets.end(), along,
                                        [](double w, const glm::dvec3& offset) { return w < offset.z; });
    const auto k = std::max<std::ptrdiff_t>(0, above - frame.offsets.begin() - 1);
    if (static_cast<std::size_t>(k) + 1 >= frame.offsets.size()) {
        return {static_cast<int>(frame.offsets.size()) - 1, 0};
    }
    const double below = frame.offsets[static_cast<std::size_t>(k)].z;
    const double gap = frame.offsets[static_cast<std::size_t>(k) + 1].z - below;
    double share = std::clamp((along - below) / gap, 0.0, 1.0);
    constexpr double kOnSlice = 1e-6; // rounding must not mix in a neighbour
    share = share < kOnSlice ? 0 : share > 1 - kOnSlice ? 1 : share;
    return share == 1 ? SliceSource{static_cast<int>(k) + 1, 0} : SliceSource{static_cast<int>(k), share};
}

template <typename T>
class Sampler {
  public:
    Sampler(const StoredVolume& stored, const Frame& frame, const Resampling& rule)
        : values_(stored.values.as<T>()), dims_(stored.dims), frame_(frame), rule_(rule) {}

    /// The stored number at a place of the straight frame on slice k, in voxels along i and j.
    [[nodiscard]] double at(double i, double j, int k) const {
        const glm::dvec3& offset = frame_.offsets[static_cast<std::size_t>(k)];
        const double y = j - offset.y;
        const double x = i - offset.x - frame_.rowShear * y;
        constexpr double kEdge = 0.5; // a voxel reaches half its width past its centre
        if (!(x > -kEdge && y > -kEdge && x < dims_.x - kEdge && y < dims_.y - kEdge)) {
            return rule_.fill;
        }
        const double cx = std::clamp(x, 0.0, dims_.x - 1.0);
        const double cy = std::clamp(y, 0.0, dims_.y - 1.0);
        if (rule_.nearest) {
            return voxel(static_cast<int>(std::lround(cx)), static_cast<int>(std::lround(cy)), k);
        }
        const int x0 = static_cast<int>(cx);
        const int y0 = static_cast<int>(cy);
        const double fx = cx - x0;
        const double fy = cy - y0;
        const int x1 = std::min(x0 + 1, dims_.x - 1);
        const int y1 = std::min(y0 + 1, dims_.y - 1);
        const double low = (1 - fx) * voxel(x0, y0, k) + fx * voxel(x1, y0, k);
        const double high = (1 - fx) * voxel(x0, y1, k) + fx * voxel(x1, y1, k);
        return (1 - fy) * low + fy * high;
    }

  private:
    [[nodiscard]] double voxel(int x, int y, int k) const {
        return static_cast<double>(
            values_[(static_cast<std::size_t>(k) * static_cast<std::size_t>(dims_.y) + static_cast<std::size_t>(y)) *
                        static_cast<std::size_t>(dims_.x) +
                    static_cast<std::size_t>(x)]);
    }

    std::span<const T> values_;
    glm::ivec3 dims_;
    const Frame& frame_;
    Resampling rule_;
};

struct StraightBox {
    glm::ivec3 dims{1};
    glm::dvec2 low{0}; ///< first voxel along i and j, in voxels of the frame
    double stepMm = 1;
};

StraightBox boxOf(const Frame& frame, const StoredVolume& stored, double stepMm, const Context& context) {
    StraightBox box;
    glm::dvec2 low(0);
    glm::dvec2 high(0);
    const double lean = frame.rowShear * (stored.dims.y - 1);
    for (const glm::dvec3& offset : frame.offsets) {
        low = glm::min(low, glm::dvec2(offset.x + std::min(0.0, lean), offset.y));
        high = glm::max(high, glm::dvec2(offset.x + std::max(0.0, lean), offset.y));
    }
    constexpr double kSliver = 0.05; // less than a twentieth of a voxel is not worth another row
    low = glm::floor(low + kSliver);
    high = glm::ceil(high - kSliver);
    box.low = low;
    box.stepMm = stepMm;
    const double slices = frame.offsets.back().z / stepMm;
    const std::int64_t dims[3] = {stored.dims.x + static_cast<std::int64_t>(std::min(high.x - low.x, 1e6)),
                                  stored.dims.y + static_cast<std::int64_t>(std::min(high.y - low.y, 1e6)),
                                  static_cast<std::int64_t>(std::min(std::floor(slices + 0.5), 1e6)) + 1};
    box.dims = checkedDims(context, dims, stored.type);
    return box;
}

template <typename T>
void resampleSlice(const Sampler<T>& sampler, const Frame& frame, const StraightBox& box, const Resampling& rule, int z,
                   T* out) {
    SliceSource source = sourceAt(frame, z * box.stepMm);
    if (rule.nearest && source.share > 0) {
        source = {source.share > 0.5 ? source.k + 1 : source.k, 0};
    }
    for (int y = 0; y < box.dims.y; ++y) {
        for (int x = 0; x < box.dims.x; ++x) {
            double value = sampler.at(x + box.low.x, y + box.low.y, source.k);
            if (source.share > 0) {
                value += source.share * (sampler.at(x + box.low.x, y + box.low.y, source.k + 1) - value);
            }
            *out++ = static_cast<T>(rule.rounded ? std::round(value) : value);
        }
    }
}

void resample(StoredVolume& stored, const Frame& frame, const StraightBox& box, const Resampling& rule) {
    const std::size_t slice = static_cast<std::size_t>(box.dims.x) * static_cast<std::size_t>(box.dims.y);
    ByteBuffer straight(slice * static_cast<std::size_t>(box.dims.z) * bytesPerScalar(stored.type));
    withScalar(stored.type, [&](auto zero) {
        using T = decltype(zero);
        const Sampler<T> sampler(stored, frame, rule);
        T* out = straight.as<T>().data();
        tbb::parallel_for(0, box.dims.z, [&](int z) {
            resampleSlice(sampler, frame, box, rule, z, out + static_cast<std::size_t>(z) * slice);
        });
    });
    stored.values = std::move(straight);
    stored.dims = box.dims;
    const glm::dvec3 spacing(frame.spacingMm.x, frame.spacingMm.y, box.stepMm);
    stored.originMm += frame.direction * glm::dvec3(box.low.x * spacing.x, box.low.y * spacing.y, 0);
    stored.axesMm =
        glm::dmat3(frame.direction[0] * spacing.x, frame.direction[1] * spacing.y, frame.direction[2] * spacing.z);
}

/// Takes slices that stray by less than half a voxel as straight: every voxel's true centre stays inside its own box.
void takeAsStraight(StoredVolume& stored, const Frame& frame) {
    glm::dvec3 low(0);
    glm::dvec3 high(0);
    for (std::size_t k = 0; k < frame.offsets.size(); ++k) {
        const glm::dvec3 stray = frame.offsets[k] - glm::dvec3(0, 0, frame.spacingMm.z * static_cast<double>(k));
        low = glm::min(low, stray);
        high = glm::max(high, stray);
    }
    glm::dvec3 middle = (low + high) / 2.0 * glm::dvec3(frame.spacingMm.x, frame.spacingMm.y, 1);
    middle.x += frame.rowShear * (stored.dims.y - 1) / 2 * frame.spacingMm.x;
    stored.originMm += frame.direction * middle;
    stored.axesMm = glm::dmat3(frame.direction[0] * frame.spacingMm.x, frame.direction[1] * frame.spacingMm.y,
                               frame.direction[2] * frame.spacingMm.z);
}

std::string inWords(double value) {
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
}

} // namespace

void straighten(StoredVolume& stored, const Resampling& resampling, Context& context) {
    if (!stored.sliceOrigins.empty()) {
        stored.originMm = stored.sliceOrigins.front();
    }
    const Frame frame = frameOf(stored);
    const Deviation deviation = deviationOf(frame, stored);
    constexpr double kRounding = 1e-3; // voxels: what headers in single precision and short text leave
    constexpr double kHalfVoxel = 0.5;
    if (deviation.inPlaneVoxels < kRounding && deviation.alongVoxels < kRounding) {
        if (!stored.sliceOrigins.empty()) { // else the header's own numbers stay as they are, to the last bit
            takeAsStraight(stored, frame);
        }
        return;
    }
    const double worst = std::max(deviation.inPlaneVoxels, deviation.alongVoxels);
    if (worst <= kHalfVoxel) {
        takeAsStraight(stored, frame);
        constexpr double kWorthAWord = 0.1;
        if (worst > kWorthAWord) {
            context.warn("the slices stray from a straight, even stack by up to " + inWords(worst) +
                         " voxels; taken as straight");
        }
        return;
    }
    const bool uneven = deviation.alongVoxels > kHalfVoxel;
    const double step = uneven ? evenStep(frame) : frame.spacingMm.z;
    const StraightBox box = boxOf(frame, stored, step, context);
    std::string why = uneven ? "the slices are unevenly spaced" : "";
    if (deviation.inPlaneVoxels > kHalfVoxel) {
        why += std::string(uneven ? " and" : "the slices are") + " sheared (gantry tilt)";
    }
    resample(stored, frame, box, resampling);
    context.warn(why + "; resampled to a straight grid with a step of " + inWords(step) + " mm");
}

Grid gridOf(const StoredVolume& stored) {
    Grid grid;
    grid.dims = stored.dims;
    for (int axis = 0; axis < 3; ++axis) {
        grid.spacingMm[axis] = glm::length(stored.axesMm[axis]);
        grid.direction[axis] = stored.axesMm[axis] / grid.spacingMm[axis];
    }
    grid.originMm = stored.originMm;
    return grid;
}

} // namespace limner::importing
