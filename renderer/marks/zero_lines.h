#pragma once

#include "renderer/marks/mark_field.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace limner {

/// Lines on a field's surface, between its voxels: where a number of the voxels passes through zero. Silhouettes are
/// the zero of n.e, ridges that of the curvature's change along its own direction.

/// The surface as the voxels around each voxel agree on it: noise of single ones would tear lines.
struct SmoothSurface {
    std::vector<glm::vec3> normals; ///< unit; 0 where not asked for
    std::vector<float> distances;   ///< mm from the surface, positive outside
};
SmoothSurface smoothSurface(const MarkField& field, std::span<const std::uint8_t> use);

/// All spans are parallel to the field's voxels.
struct ZeroLineRequest {
    std::span<const std::uint8_t> use; ///< voxels that take part
    const SmoothSurface& surface;
    std::span<const float> number;
    /// Not empty: the number belongs to a direction and changes its sign with it; only its falling zeros along it are
    /// wanted.
    std::span<const glm::vec3> axis;
    std::span<const float> strength;      ///< of a line there
    float least = 0;                      ///< strength below which there is no line
    std::span<const std::uint8_t> strong; ///< a line has enough of these near it
};

struct LinePoint {
    glm::dvec3 mm{0};
    glm::vec3 normalMm{0};
    glm::vec3 slope{0}; ///< of the number, per mm
    float strength = 0;
    bool strong = false;
};

/// Points along a line some third of a voxel apart.
struct SurfaceLine {
    std::vector<LinePoint> points;
    bool closed = false; ///< the last point's neighbour is the first
    std::uint8_t layer = 0;
};

/// Joined over small gaps where directions agree; without crumbs of less than `leastVoxels`. In the same order on every
/// machine.
std::vector<SurfaceLine> zeroLines(const MarkField& field, const ZeroLineRequest& request, double leastVoxels);

} // namespace limner
