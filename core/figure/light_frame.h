#pragma once

#include "core/figure/camera.h"
#include "core/figure/layer.h"

namespace limner {

/// Where a light stands for the viewer: unit direction towards it, x right, y up, z towards the viewer. A light
/// without direction stands at the eye.
glm::dvec3 lightSeen(const Light& light, const Camera& camera);

/// A light of that kind ("head" moves with the viewer, "object" with the scan) that the viewer sees in that direction.
Light lightToBeSeen(const std::string& kind, const glm::dvec3& seen, const Camera& camera);

} // namespace limner
