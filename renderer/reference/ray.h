#pragma once

#include "renderer/plan/render_plan.h"

#include <optional>

namespace limner::reference {

/// A stretch of a ray, mm from the ray's origin.
struct Stretch {
    double inMm = 0;
    double outMm = 0;
    [[nodiscard]] double lengthMm() const { return outMm - inMm; }
};

/// One ray of a plan's picture, cut to what there is to see.
struct Ray {
    glm::dvec3 originVoxel{0};
    glm::dvec3 directionVoxel{0}; ///< voxels per mm
    glm::dvec3 directionEye{0};   ///< unit
    Stretch box;                  ///< inside the volume's box and in front of the eye: starts the sample lattice
    Stretch visible;              ///< of that, what the clip box and the clip planes leave

    [[nodiscard]] glm::dvec3 positionVoxel(double mm) const { return originVoxel + mm * directionVoxel; }
};

/// The ray through a point of the picture, in pixels from its top left corner; nothing where it misses the volume or
/// everything on it is cut away.
std::optional<Ray> rayThrough(const RenderPlan& plan, const glm::dvec2& positionPixel);

/// Sample k of a ray's lattice (see SampleLattice).
struct Segment {
    double positionMm = 0; ///< where the sample is taken
    double lengthMm = 0;   ///< what it stands for; 0: nothing
};
Segment segmentOf(const Ray& ray, const SampleLattice& lattice, long k);

/// Samples [first, end) touch the ray's visible stretch.
struct SampleSpan {
    long first = 0;
    long end = 0;
};
SampleSpan samplesOf(const Ray& ray, const SampleLattice& lattice);

} // namespace limner::reference
