#include "renderer/reference/field.h"

#include <glm/common.hpp>

namespace limner::reference {

namespace {

glm::dvec3 movedOntoLastCentre(const Volume& volume, const glm::dvec3& positionVoxel) {
    return glm::min(positionVoxel, glm::dvec3(volume.grid().dims - 1));
}

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

} // namespace

double storedAt(const Volume& volume, const glm::dvec3& positionVoxel) {
    return interpolate(volume, movedOntoLastCentre(volume, positionVoxel));
}

glm::dvec3 indexGradient(const Volume& volume, const glm::dvec3& positionVoxel) {
    const glm::dvec3 p = movedOntoLastCentre(volume, positionVoxel);
    glm::dvec3 gradient(0);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0);
        step[axis] = 1;
        gradient[axis] = (interpolate(volume, p + step) - interpolate(volume, p - step)) / 2;
    }
    return gradient;
}

} // namespace limner::reference
