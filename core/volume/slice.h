#pragma once

#include "core/base/task.h"
#include "core/volume/volume.h"

#include <glm/vec2.hpp>

#include <vector>

namespace limner {

/// A flat picture through a volume, upright as radiologists hold it.
enum class SlicePlane {
    axial,    ///< seen from the feet: the patient's right on the left, front above
    coronal,  ///< seen from the front: the patient's right on the left, head above
    sagittal, ///< seen from the patient's left: front on the left, head above
};

/// Unit steps of a slice's picture in the patient (LPS): along its rows, down its columns, and from slice to slice
/// towards the patient's left, back or head.
struct SliceAxes {
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 down{0, 1, 0};
    glm::dvec3 through{0, 0, 1};
};
SliceAxes sliceAxes(SlicePlane plane);

/// Where a slice lies and how it is cut into pixels.
struct SliceRequest {
    SlicePlane plane = SlicePlane::axial;
    glm::dvec3 middleMm{0}; ///< what the middle of the picture shows
    double mmPerPixel = 1;
    glm::ivec2 pixels{0};
};

/// Trilinear values in the data's unit, rows from the top; NaN outside the volume. Parallel over rows. Throws
/// Error(cancelled) through the task.
std::vector<float> sliceThrough(const Volume& volume, const SliceRequest& request, Task& task);

} // namespace limner
