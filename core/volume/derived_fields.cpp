#include "core/volume/derived_fields.h"

#include "core/volume/field_parts.h"

#include <algorithm>
#include <array>
#include <utility>

namespace limner {

namespace {

using fields::LineBundle;
using fields::LineFilter;

/// Step of a line mirrored at the outer faces of its border voxels: -1 is 0, count is count - 1.
int mirrored(int step, int count) {
    const int period = 2 * count;
    const int within = ((step % period) + period) % period;
    return within < count ? within : period - 1 - within;
}

/// From voxels to coefficients of the cubic B-spline: the inverse of (1, 4, 1) / 6 as a causal and an anticausal
/// recursion (Unser 1999, box 2). A backend repeats the border's coefficient outside the volume, c[-1] = c[0] and
/// c[n] = c[n-1]. Coefficients have that very symmetry where the data are mirrored at the border voxels' faces,
/// f[-1-k] = f[k] (not at their centres, as is usual), so both recursions start as that mirroring has it and the spline
/// passes through the border's voxels too.
void prefilter(const LineBundle& lines) {
    constexpr float kPole = -0.26794919243F; // sqrt(3) - 2
    constexpr float kGain = 6;
    constexpr int kReach = 16; // kPole^16 < 1e-9
    float* before = lines.outAt(0);
    std::fill_n(before, lines.width, 0.0F);
    for (int k = kReach; k >= 1; --k) { // the causal recursion over the mirrored voxels -kReach .. -1
        const float* f = lines.inAt(mirrored(-k, lines.count));
        for (int i = 0; i < lines.width; ++i) {
            before[i] = f[i] + kPole * before[i];
        }
    }
    for (int k = 0; k < lines.count; ++k) {
        const float* previous = lines.outAt(std::max(0, k - 1));
        const float* f = lines.inAt(k);
        float* causal = lines.outAt(k);
        for (int i = 0; i < lines.width; ++i) {
            causal[i] = f[i] + kPole * previous[i];
        }
    }
    // c[n] = c[n-1] in c[k] = kPole * (c[k+1] - causal[k])
    float* last = lines.outAt(lines.count - 1);
    for (int i = 0; i < lines.width; ++i) {
        last[i] *= kGain * kPole / (kPole - 1);
    }
    for (int k = lines.count - 2; k >= 0; --k) {
        const float* next = lines.outAt(k + 1);
        float* c = lines.outAt(k);
        for (int i = 0; i < lines.width; ++i) {
            c[i] = kPole * (next[i] - kGain * c[i]);
        }
    }
}

std::shared_ptr<const Volume> separableField(const Volume& source, const std::array<LineFilter, 3>& filters,
                                             Task& task) {
    return fields::withinMemory([&] {
        const float base = fields::storedBase(source);
        auto field = fields::filtered(source, {.base = base}, filters, task);
        task.throwIfCancelled();
        auto kept = fields::keptLike(source, std::move(field), base);
        task.progress(1);
        return kept;
    });
}

} // namespace

std::shared_ptr<const Volume> splineCoefficients(const Volume& source, Task& task) {
    std::array<LineFilter, 3> filters;
    for (int axis = 0; axis < 3; ++axis) {
        if (source.grid().dims[axis] > 1) {
            filters[static_cast<std::size_t>(axis)] = prefilter;
        }
    }
    return separableField(source, filters, task);
}

std::shared_ptr<const Volume> gaussianBlurred(const Volume& source, const glm::dvec3& sigmaVoxels, Task& task) {
    return separableField(source, fields::gaussianFilters(source.grid().dims, sigmaVoxels), task);
}

} // namespace limner
