#pragma once

#include "core/optics/contour.h"
#include "renderer/plan/render_plan.h"

#include <glm/vec3.hpp>

namespace limner::reference {

/// The fields that every backend draws, in double. Positions in voxel coordinates (voxel centres at integers). A
/// position past the last centre of an axis is moved onto it; before the first centre the border voxel repeats (see
/// BrickLayout).

/// Value of the plan's field in the data's unit: the trilinear interpolant of the voxels, or the cubic B-spline, whose
/// overshoots are cut: there are no values outside the data's range.
double valueAt(const RenderPlan& plan, const glm::dvec3& positionVoxel);

/// Gradient by the plan's estimator, in stored units of the plan's volume per voxel along the index axes; 0 along an
/// axis with a single voxel. Central and fourth-order differences are those of the trilinear interpolant; Sobel's and
/// Neumann's are taken at the voxels and interpolated trilinearly; the B-spline's is its own derivative.
glm::dvec3 indexGradient(const RenderPlan& plan, const glm::dvec3& positionVoxel);

/// Gradient by the plan's estimator in eye space, data's unit per mm.
glm::dvec3 eyeGradient(const RenderPlan& plan, const glm::dvec3& positionVoxel);

/// First and second derivatives of a field along the index axes.
struct Derivatives {
    glm::dvec3 gradient;
    optics::Hessian<double> hessian;
};

/// Of the cubic B-spline that the plan's bend field steers, in its stored units per voxel and per voxel squared.
Derivatives indexBend(const RenderPlan& plan, const glm::dvec3& positionVoxel);

/// Trilinear value of any volume in its unit, and the derivative of that interpolant along the index axes.
double trilinearAt(const Volume& volume, const glm::dvec3& positionVoxel);
glm::dvec3 trilinearSlope(const Volume& volume, const glm::dvec3& positionVoxel);

} // namespace limner::reference
