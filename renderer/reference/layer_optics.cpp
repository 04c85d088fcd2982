#include "renderer/reference/layer_optics.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace limner::reference {

namespace {

glm::dvec4 fromRgba(const Rgba& c) { return {c.r, c.g, c.b, c.a}; }

/// One style at a normal: its mean where the normal means nothing.
glm::dvec4 lookUp(const StyleIndex::Entry& style, const optics::DiskPoint<double>& point, double definedness) {
    if (!style.sphere) {
        return {style.rgb, 1};
    }
    const glm::dvec4 mean = fromRgba(style.sphere->mean());
    return mean + (fromRgba(style.sphere->at(point.x, point.y)) - mean) * definedness;
}

/// Interpolates whole styles, or plain colours, between the two nodes around a value.
template <typename Look>
glm::dvec4 betweenNodes(const PlanLayer& layer, double value, const Look& look) {
    const auto& nodeToStyle = layer.styles.nodeToStyle;
    if (nodeToStyle.empty()) {
        return {0.5, 0.5, 0.5, 1}; // no node: mid grey, as for an unknown style
    }
    const int last = static_cast<int>(nodeToStyle.size()) - 1;
    const double index = std::clamp(nodeIndexAt(layer.source->transfer.nodes, value), 0.0, static_cast<double>(last));
    const int i0 = static_cast<int>(std::floor(index));
    const double w = index - i0;
    const auto at = [&](int i) { return look(layer.styles.styles[static_cast<std::size_t>(nodeToStyle[i])]); };
    const glm::dvec4 first = at(i0);
    return w > 0 ? first + (at(std::min(i0 + 1, last)) - first) * w : first;
}

} // namespace

SurfaceSample surfaceSample(const RenderPlan& plan, const glm::dvec3& gradientIndex, const glm::dvec3& rayEye) {
    const glm::dvec3 g = plan.rays.eyeFromGradient * gradientIndex;
    const auto normalEye = optics::normalFromGradient<double>({g.x, g.y, g.z});
    SurfaceSample sample;
    sample.normalRay = optics::normalInRayFrame<double>(normalEye, {rayEye.x, rayEye.y, rayEye.z});
    sample.definedness = optics::normalDefinedness(std::hypot(g.x, g.y, g.z), plan.gradientFloor);
    return sample;
}

bool readsNormal(const PlanLayer& layer) {
    if (layer.shading == Shading::phong) {
        return true;
    }
    return layer.shading == Shading::style && std::any_of(layer.styles.styles.begin(), layer.styles.styles.end(),
                                                          [](const auto& entry) { return entry.sphere != nullptr; });
}

double opacityOf(const PlanLayer& layer, double value) {
    return std::clamp(opacityAt(layer.source->transfer.opacity, value) * layer.source->opacity, 0.0, 1.0);
}

LayerSample shadeLayer(const PlanLayer& layer, double value, double opacity, const SurfaceSample& surface) {
    if (layer.shading == Shading::style) {
        const auto normal = layer.twoSided ? optics::facingViewer(surface.normalRay) : surface.normalRay;
        const auto point = optics::litSpherePoint(normal);
        const glm::dvec4 c = betweenNodes(
            layer, value, [&](const StyleIndex::Entry& style) { return lookUp(style, point, surface.definedness); });
        return {{c.r, c.g, c.b}, optics::uniformOpacity(c.a, opacity)};
    }
    const glm::dvec4 c =
        betweenNodes(layer, value, [](const StyleIndex::Entry& style) { return glm::dvec4(style.rgb, 1); });
    const optics::Colour<double> plain{c.r, c.g, c.b};
    if (layer.shading == Shading::flat) {
        return {plain, opacity};
    }
    const optics::PhongTerms<double> terms{layer.specular.strength, layer.specular.exponent};
    return {optics::phong(plain, optics::facing(surface.normalRay.z, layer.twoSided), terms), opacity};
}

} // namespace limner::reference
