#include "renderer/reference/field.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace limner::reference {

namespace {

glm::dvec3 movedOntoLastCentre(const Volume& volume, const glm::dvec3& positionVoxel) {
    return glm::min(positionVoxel, glm::dvec3(volume.grid().dims - 1));
}

/// Stored units.
double interpolate(const Volume& volume, const glm::dvec3& positionVoxel) {
    const glm::dvec3 low = glm::floor(positionVoxel);
    const glm::dvec3 f = positionVoxel - low;
    const glm::ivec3 i(low);
    const auto at = [&](int x, int y, int z) { return volume.storedAt(i + glm::ivec3(x, y, z)); };
    const auto row = [&](int y, int z) {
        const double a = at(0, y, z);
        return a + (at(1, y, z) - a) * f.x;
    };
    const auto slice = [&](int z) {
        const double a = row(0, z);
        return a + (row(1, z) - a) * f.y;
    };
    const double a = slice(0);
    return a + (slice(1) - a) * f.z;
}

/// Weights of the four voxels around a position, from one before its cell to one behind.
using Taps = std::array<double, 4>;

Taps splineTaps(double f) {
    const double g = 1 - f;
    return {g * g * g / 6, 2.0 / 3 - f * f * (2 - f) / 2, 2.0 / 3 - g * g * (2 - g) / 2, f * f * f / 6};
}

Taps splineSlopeTaps(double f) {
    const double g = 1 - f;
    return {-g * g / 2, f * (3 * f - 4) / 2, -g * (3 * g - 4) / 2, f * f / 2};
}

Taps splineBendTaps(double f) { return {1 - f, 3 * f - 2, 1 - 3 * f, f}; }

/// A central difference at each corner of the cell, interpolated.
Taps differenceTaps(double f) { return {(f - 1) / 2, -f / 2, (1 - f) / 2, f / 2}; }

/// (1, centre, 1) / (2 + centre) at each corner of the cell, interpolated: Sobel's smoothing for 2, Neumann's for 1.
Taps smoothingTaps(double f, double centre) {
    const double share = 1 / (2 + centre);
    return {(1 - f) * share, ((1 - f) * centre + f) * share, ((1 - f) + f * centre) * share, f * share};
}

/// Stored units.
double weighted(const Volume& volume, const glm::ivec3& cell, const std::array<Taps, 3>& taps) {
    double sum = 0;
    for (int z = 0; z < 4; ++z) {
        for (int y = 0; y < 4; ++y) {
            double row = 0;
            for (int x = 0; x < 4; ++x) {
                row += taps[0][x] * volume.storedAt(cell + glm::ivec3(x - 1, y - 1, z - 1));
            }
            sum += taps[1][y] * taps[2][z] * row;
        }
    }
    return sum;
}

/// A cell and the place inside it.
struct CellPlace {
    glm::ivec3 cell;
    glm::dvec3 f;
    CellPlace(const Volume& volume, const glm::dvec3& positionVoxel) {
        const glm::dvec3 p = movedOntoLastCentre(volume, positionVoxel);
        cell = glm::ivec3(glm::floor(p));
        f = p - glm::floor(p);
    }
};

glm::dvec3 separableGradient(const RenderPlan& plan, const glm::dvec3& positionVoxel) {
    const Volume& volume = *plan.gradientField;
    const GradientEstimator estimator = plan.gradient;
    const CellPlace place(volume, positionVoxel);
    std::array<Taps, 3> smooth{};
    std::array<Taps, 3> slope{};
    for (int axis = 0; axis < 3; ++axis) {
        const double f = place.f[axis];
        const bool spline = estimator == GradientEstimator::bspline;
        smooth[axis] = spline ? splineTaps(f) : smoothingTaps(f, estimator == GradientEstimator::sobel ? 2 : 1);
        slope[axis] = spline ? splineSlopeTaps(f) : differenceTaps(f);
    }
    const auto along = [&](const Taps& x, const Taps& y, const Taps& z) {
        const double component = weighted(volume, place.cell, {x, y, z});
        return std::abs(component) > plan.gradientRounding ? component : 0;
    };
    return {along(slope[0], smooth[1], smooth[2]), along(smooth[0], slope[1], smooth[2]),
            along(smooth[0], smooth[1], slope[2])};
}

glm::dvec3 differences(const Volume& volume, const glm::dvec3& positionVoxel, bool fourthOrder) {
    const glm::dvec3 p = movedOntoLastCentre(volume, positionVoxel);
    glm::dvec3 gradient(0);
    for (int axis = 0; axis < 3; ++axis) {
        const auto over = [&](double voxels) {
            glm::dvec3 step(0);
            step[axis] = voxels;
            return interpolate(volume, p + step) - interpolate(volume, p - step);
        };
        gradient[axis] = fourthOrder ? (8 * over(1) - over(2)) / 12 : over(1) / 2;
    }
    return gradient;
}

/// From stored units of the gradient field to those of the volume.
double volumeUnits(const RenderPlan& plan) {
    return plan.gradientField->contents().slope / plan.volume->contents().slope;
}

} // namespace

double trilinearAt(const Volume& volume, const glm::dvec3& positionVoxel) {
    return volume.valueFromStored(interpolate(volume, movedOntoLastCentre(volume, positionVoxel)));
}

glm::dvec3 trilinearSlope(const Volume& volume, const glm::dvec3& positionVoxel) {
    const glm::dvec3 p = movedOntoLastCentre(volume, positionVoxel);
    const glm::ivec3 cell = glm::min(glm::ivec3(glm::floor(p)), volume.grid().dims - 2); // the last centre has one
    const glm::dvec3 f = p - glm::dvec3(cell);
    glm::dvec3 slope(0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 at(corner & 1, corner >> 1 & 1, corner >> 2);
        const double stored = volume.storedAt(cell + at);
        for (int axis = 0; axis < 3; ++axis) {
            double weight = at[axis] == 1 ? 1 : -1;
            for (int other = 0; other < 3; ++other) {
                weight *= other == axis ? 1 : at[other] == 1 ? f[other] : 1 - f[other];
            }
            slope[axis] += weight * stored;
        }
    }
    return volume.contents().slope * slope;
}

double valueAt(const RenderPlan& plan, const glm::dvec3& positionVoxel) {
    if (plan.interpolation == Interpolation::linear) {
        return trilinearAt(*plan.field, positionVoxel);
    }
    const CellPlace place(*plan.field, positionVoxel);
    const double value = plan.field->valueFromStored(
        weighted(*plan.field, place.cell, {splineTaps(place.f.x), splineTaps(place.f.y), splineTaps(place.f.z)}));
    return std::clamp(value, plan.volume->range().low, plan.volume->range().high);
}

glm::dvec3 indexGradient(const RenderPlan& plan, const glm::dvec3& positionVoxel) {
    const Volume& field = *plan.gradientField;
    switch (plan.gradient) {
    case GradientEstimator::sobel:
    case GradientEstimator::neumann:
    case GradientEstimator::bspline: return volumeUnits(plan) * separableGradient(plan, positionVoxel);
    case GradientEstimator::fourthOrder: return volumeUnits(plan) * differences(field, positionVoxel, true);
    case GradientEstimator::automatic:
    case GradientEstimator::central: break;
    }
    return volumeUnits(plan) * differences(field, positionVoxel, false);
}

glm::dvec3 eyeGradient(const RenderPlan& plan, const glm::dvec3& positionVoxel) {
    return plan.rays.eyeFromGradient * indexGradient(plan, positionVoxel);
}

Derivatives indexBend(const RenderPlan& plan, const glm::dvec3& positionVoxel) {
    const Volume& field = *plan.bendField;
    const CellPlace place(field, positionVoxel);
    std::array<Taps, 3> value{};
    std::array<Taps, 3> slope{};
    std::array<Taps, 3> bend{};
    for (int axis = 0; axis < 3; ++axis) {
        value[axis] = splineTaps(place.f[axis]);
        slope[axis] = splineSlopeTaps(place.f[axis]);
        bend[axis] = splineBendTaps(place.f[axis]);
    }
    const auto of = [&](const Taps& x, const Taps& y, const Taps& z) { return weighted(field, place.cell, {x, y, z}); };
    return {{of(slope[0], value[1], value[2]), of(value[0], slope[1], value[2]), of(value[0], value[1], slope[2])},
            {of(bend[0], value[1], value[2]), of(value[0], bend[1], value[2]), of(value[0], value[1], bend[2]),
             of(slope[0], slope[1], value[2]), of(slope[0], value[1], slope[2]), of(value[0], slope[1], slope[2])}};
}

} // namespace limner::reference
