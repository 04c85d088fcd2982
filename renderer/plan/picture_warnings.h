#pragma once

#include "renderer/plan/render_plan.h"

#include <string>
#include <vector>

namespace limner {

/// What a user should know of a picture before printing it, one plain sentence each: opacity that rises within less
/// than the scan changes between two samples (accuracy.md 1.9), layers bounded by labels much coarser than the scan, a
/// scan whose file mirrors its axes, voxels far from cubes, more memory than the machine comfortably has. Reads some
/// thousand voxels: a few milliseconds. Thread-safe.
std::vector<std::string> pictureWarnings(const RenderPlan& plan);

/// The largest change of value over a millimetre along the axes, of all but a thousandth of the places where the scan
/// changes at all; data's unit per mm. By voxels spread evenly over the volume.
double steepestChange(const Volume& volume);

} // namespace limner
