#pragma once

#include "core/volume/volume.h"

#include <glm/vec3.hpp>

namespace limner::reference {

/// The field that every backend draws, in double. Positions in voxel coordinates (voxel centres at integers). A
/// position past the last centre of an axis is moved onto it; before the first centre the border voxel repeats (see
/// BrickLayout).

/// Trilinear interpolant in stored units.
double storedAt(const Volume& volume, const glm::dvec3& positionVoxel);

/// Central differences of the trilinear interpolant over one voxel to either side: stored units per voxel along the
/// index axes. 0 along an axis with a single voxel.
glm::dvec3 indexGradient(const Volume& volume, const glm::dvec3& positionVoxel);

} // namespace limner::reference
