#pragma once

#include "renderer/reference/layer_optics.h"

#include <vector>

namespace limner::reference {

/// What one layer shows in a slab (core/optics/preintegration.h): its shading where its matter is seen on average.
struct SlabPart {
    const PlanLayer* layer = nullptr;
    double opacity = 0; ///< of the slab, above 0
    optics::Colour<double> colour{0, 0, 0};
    glm::dvec3 positionVoxel{0};
    double value = 0; ///< there, by the line between the slab's ends
};

/// The layers that show in the slab of sample k of a pre-integrated plan's ray, in drawing order. Integrals are over
/// the transfer functions themselves, by Gauss rules between their knots.
std::vector<SlabPart> slabAt(const RenderPlan& plan, const Ray& ray, long k);

} // namespace limner::reference
