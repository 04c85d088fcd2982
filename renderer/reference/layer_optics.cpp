#include "renderer/reference/layer_optics.h"

#include "core/optics/contour.h"
#include "core/optics/mip.h"
#include "core/optics/texture.h"
#include "core/optics/transparency.h"
#include "renderer/reference/field.h"
#include "renderer/reference/importance.h"
#include "renderer/reference/layer_parts.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limner::reference {

namespace {

using Normal = optics::Vector3<double>;

glm::dvec4 fromRgba(const Rgba& c) { return {c.r, c.g, c.b, c.a}; }

bool anyLayer(const RenderPlan& plan, bool (*reads)(const PlanLayer&)) {
    return std::any_of(plan.layers.begin(), plan.layers.end(), reads);
}

Normal unitNormal(const glm::dvec3& gradientEye) {
    return optics::normalFromGradient<double>({gradientEye.x, gradientEye.y, gradientEye.z});
}

/// Curvature along the view from the second derivatives (core/optics/contour.h). Gradient and tangent plane are those
/// of the field that the second derivatives are of: another field's would be another surface.
double bendAt(const RenderPlan& plan, const glm::dvec3& positionVoxel, const glm::dvec3& viewEye) {
    // A curvature has nothing of the data's unit: the field counts in its own.
    const glm::dmat3 eyeFromIndex = plan.rays.eyeFromGradient / plan.volume->contents().slope;
    const Derivatives field = indexBend(plan, positionVoxel);
    const glm::dvec3 g = eyeFromIndex * field.gradient;
    const Normal normal = unitNormal(g);
    const glm::dvec3 n(normal.x, normal.y, normal.z);
    const glm::dvec3 tangent = viewEye - glm::dot(n, viewEye) * n;
    // With the gradient A g in eye space the Hessian there is A H A^T.
    const glm::dvec3 u = glm::transpose(eyeFromIndex) * tangent;
    const double second = optics::quadraticForm<double>(field.hessian, {u.x, u.y, u.z});
    return optics::curvatureAlongView(second, glm::dot(tangent, tangent), std::hypot(g.x, g.y, g.z));
}

/// Curvature by this normal and the one `probeMm` before; 0 where one of them means nothing.
double turnAt(const RenderPlan& plan, const Ray& ray, const glm::dvec3& positionVoxel, double probeMm) {
    const glm::dvec3 here = eyeGradient(plan, positionVoxel);
    const glm::dvec3 before = eyeGradient(plan, positionVoxel - probeMm * ray.directionVoxel);
    const auto trust = [&](const glm::dvec3& g) {
        return optics::normalDefinedness(std::hypot(g.x, g.y, g.z), plan.gradientFloor);
    };
    return trust(here) * trust(before) * optics::curvatureOfNormals(unitNormal(before), unitNormal(here), probeMm);
}

bool readsTurn(const PlanLayer& layer) {
    return layer.contours && layer.contours->curvatureControlled &&
           layer.contours->curvature == CurvatureEstimator::normals;
}

SurfaceSample surfaceSample(const RenderPlan& plan, const Ray& ray, double positionMm) {
    const glm::dvec3 position = ray.positionVoxel(positionMm);
    SurfaceSample sample = surfaceOf(plan, ray.directionEye, eyeGradient(plan, position));
    if (anyLayer(plan, readsSecondDerivatives)) {
        sample.bend = sample.definedness * bendAt(plan, position, -ray.directionEye);
    }
    return sample;
}

/// Slots of the eight voxels around a position, merged, with their trilinear weights.
std::vector<std::pair<int, double>> membershipAt(const Volume& slots, const glm::dvec3& positionVoxel) {
    const glm::dvec3 p = glm::min(positionVoxel, glm::dvec3(slots.grid().dims - 1));
    const glm::ivec3 cell(glm::floor(p));
    const glm::dvec3 f = p - glm::floor(p);
    std::vector<std::pair<int, double>> members;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 at(corner & 1, corner >> 1 & 1, corner >> 2);
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) {
            weight *= at[axis] == 1 ? f[axis] : 1 - f[axis];
        }
        const int slot = static_cast<int>(slots.storedAt(cell + at));
        const auto known =
            std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.first == slot; });
        if (known != members.end()) {
            known->second += weight;
        } else if (weight > 0) {
            members.emplace_back(slot, weight);
        }
    }
    return members;
}

double turnOf(const SampleFacts& facts, double probeMm) {
    const auto found =
        std::find_if(facts.turns.begin(), facts.turns.end(), [&](const auto& turn) { return turn.first == probeMm; });
    return found->second;
}

/// Where a layer's contours end at this sample, |n.v|; 0: it has none.
double contourWidthAt(const PlanLayer& layer, const SampleFacts& facts) {
    if (!layer.contours) {
        return 0;
    }
    const PlanContours& contours = *layer.contours;
    if (!contours.curvatureControlled) {
        return contours.fixedWidth * facts.surface.definedness;
    }
    const double curvature = readsTurn(layer) ? turnOf(facts, contours.probeMm) : facts.surface.bend;
    return optics::contourWidth(contours.thicknessMm * facts.depth * curvature);
}

/// Position on an axis of the layer's transfer function; label axes go by rows.
double axisPosition(const RenderPlan& plan, const PlanLayer& layer, TransferAxis axis, const SampleFacts& facts) {
    switch (axis) {
    case TransferAxis::gradient: return std::min(facts.surface.magnitude, 1.0);
    case TransferAxis::curvature: return facts.surface.bend;
    case TransferAxis::second: return trilinearAt(*plan.secondVolume, facts.positionVoxel);
    case TransferAxis::distance:
        return layer.distance ? trilinearAt(*layer.distance, facts.positionVoxel)
                              : glm::distance(plan.volume->grid().mmFromVoxel(facts.positionVoxel),
                                              layer.distanceFromMm.value_or(glm::dvec3(0)));
    case TransferAxis::importance: return importanceOfPlace(plan, *plan.axisMeasures, facts);
    case TransferAxis::value:
    case TransferAxis::label: break;
    }
    return facts.value;
}

/// `tft`: opacity and the nodes around a place, with weights.
struct TransferSample {
    double opacity = 0;
    struct Node {
        int node;
        double weight;
    };
    std::vector<Node> nodes;
};

struct NodeAxis {
    double index;
    int count;
    int stride;
};

void addNodes(const NodeAxis& x, const NodeAxis& y, TransferSample& sample) {
    const auto split = [](const NodeAxis& axis) {
        const double index = std::clamp(axis.index, 0.0, axis.count - 1.0);
        const int low = static_cast<int>(std::floor(index));
        return std::pair(low, index - low);
    };
    const auto [x0, wx] = split(x);
    const auto [y0, wy] = split(y);
    for (int corner = 0; corner < 4; ++corner) {
        const double weight = ((corner & 1) != 0 ? wx : 1 - wx) * (corner > 1 ? wy : 1 - wy);
        if (weight > 0) {
            const int column = std::min(x0 + (corner & 1), x.count - 1);
            const int row = std::min(y0 + (corner >> 1), y.count - 1);
            sample.nodes.push_back({column * x.stride + row * y.stride, weight});
        }
    }
}

/// Of one layer at one place; `row`: of the table, where an axis is the label.
TransferSample transferAt(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts, int row) {
    const Transfer& transfer = layer.source->transfer;
    const TransferTable& table = layer.table;
    TransferSample sample;
    const auto at = [&](TransferAxis axis) {
        return axis == TransferAxis::label ? table.labels[static_cast<std::size_t>(row)]
                                           : axisPosition(plan, layer, axis, facts);
    };
    const double first = at(firstAxis(transfer));
    if (transfer.kind == TransferKind::oneDimensional) {
        sample.opacity = opacity2dAt(transfer, first, 0); // a label without a node of its own may be invisible
        const bool labelled = firstAxis(transfer) == TransferAxis::label;
        const double index =
            labelled ? table.rowIndex[static_cast<std::size_t>(row)] : nodeIndexAt(transfer.nodes, first);
        addNodes({index, static_cast<int>(layer.styles.nodeToStyle.size()), 1}, {0, 1, 0}, sample);
    } else {
        const double second = at(*secondAxis(transfer));
        sample.opacity = opacity2dAt(transfer, first, second);
        const TransferGrid grid = transfer.grid.value_or(TransferGrid{});
        const int columns = std::max(1, static_cast<int>(grid.x.size()));
        addNodes({gridIndexAt(grid.x, first, firstAxis(transfer) == TransferAxis::label), columns, 1},
                 {gridIndexAt(grid.y, second, *secondAxis(transfer) == TransferAxis::label),
                  std::max(1, static_cast<int>(grid.y.size())), columns},
                 sample);
    }
    sample.opacity = std::clamp(sample.opacity * layer.source->opacity, 0.0, 1.0);
    return sample;
}

/// A slot of the atlas between the two mip levels around a wanted one.
glm::dvec4 atLevel(const StyleAtlas& atlas, std::size_t slot, const optics::DiskPoint<double>& point, double wanted) {
    const double last = static_cast<double>(atlas.pictures.size() - 1);
    const double level = std::min(wanted, last);
    const auto at = [&](double whole) {
        const auto& pictures = atlas.pictures[static_cast<std::size_t>(std::min(whole, last))];
        return fromRgba(pictures[slot]->at(point.x, point.y));
    };
    return glm::mix(at(std::floor(level)), at(std::floor(level) + 1), level - std::floor(level));
}

/// Mip level for a layer whose contours end at `width`; 0 where the plan has no other.
double mipLevelAt(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts, double width) {
    if (!plan.mipLevels) {
        return 0;
    }
    const PlanMipLevels& levels = *plan.mipLevels;
    double curvature = 0;
    if (readsSecondDerivatives(layer)) { // contours read the rim, however the surface turns
        curvature = levels.voxelMm * facts.surface.bend *
                    (1 - optics::contourCoverage(std::abs(facts.surface.normalRay.z), width));
    }
    return optics::mipLevel(levels.radiusTexels, levels.footprintVoxels * facts.depth, curvature);
}

/// Where a layer's spheres are read.
struct SphereQuery {
    optics::DiskPoint<double> point;
    double level;
    double definedness; ///< of the normal
};

/// One style of a layer: its mean where the normal means nothing.
glm::dvec4 lookUp(const RenderPlan& plan, const PlanLayer& layer, std::size_t style, const SphereQuery& query) {
    const StyleIndex::Entry& entry = layer.styles.styles[style];
    if (!entry.sphere) {
        return {entry.rgb, 1};
    }
    const glm::dvec4 there = plan.mipLevels ? atLevel(*plan.atlas, static_cast<std::size_t>(layer.atlasSlots[style]),
                                                      query.point, query.level)
                                            : fromRgba(entry.sphere->at(query.point.x, query.point.y));
    return glm::mix(fromRgba(entry.sphere->mean()), there, query.definedness);
}

/// What `look` gives for every style, blended by the nodes' weights.
template <typename Look>
glm::dvec4 blended(const PlanLayer& layer, const TransferSample& sample, const Look& look) {
    glm::dvec4 sum(0);
    for (const TransferSample::Node& node : sample.nodes) {
        sum +=
            node.weight * look(static_cast<std::size_t>(layer.styles.nodeToStyle[static_cast<std::size_t>(node.node)]));
    }
    return sum;
}

/// The textures of the blended styles as one factor of the colour.
glm::dvec3 textureAt(const RenderPlan& plan, const PlanLayer& layer, const TransferSample& transfer,
                     const SampleFacts& facts) {
    const glm::dvec3 p = plan.volume->grid().mmFromVoxel(facts.positionVoxel);
    const glm::dvec3& n = facts.surface.normalMm;
    const auto weights = optics::projectionWeights<double>({n.x, n.y, n.z});
    const auto tiled = [&](const PlanTexture& texture, double u, double v) {
        const Rgba factor = texture.tile->at(u * texture.perMm, v * texture.perMm);
        return glm::dvec3(factor.r, factor.g, factor.b);
    };
    glm::dvec3 sum(0);
    for (const TransferSample::Node& node : transfer.nodes) {
        const int style = layer.styles.nodeToStyle[static_cast<std::size_t>(node.node)];
        const PlanTexture& texture = layer.textures[static_cast<std::size_t>(style)];
        glm::dvec3 factor(1);
        if (texture.tile) {
            const glm::dvec3 laid = weights.x * tiled(texture, p.y, -p.z) + weights.y * tiled(texture, p.x, -p.z) +
                                    weights.z * tiled(texture, p.x, p.y);
            const double seen = texture.strength * facts.surface.definedness * (weights.x + weights.y + weights.z);
            factor += seen * (laid - factor);
        }
        sum += node.weight * factor;
    }
    return sum;
}

/// Colour with the directional opacity as alpha.
glm::dvec4 colourOf(const RenderPlan& plan, const PlanLayer& layer, const TransferSample& transfer,
                    const SampleFacts& facts, double width) {
    const SurfaceSample& surface = facts.surface;
    if (layer.shading == Shading::style) {
        const auto normal = layer.twoSided ? optics::facingViewer(surface.normalRay) : surface.normalRay;
        const auto inside = optics::litSpherePoint(normal);
        const double radius = std::hypot(inside.x, inside.y);
        const double pushed = optics::contourPush(radius, std::abs(normal.z), width);
        const double stretch = radius > 0 ? pushed / radius : 1;
        const SphereQuery query{
            {inside.x * stretch, inside.y * stretch}, mipLevelAt(plan, layer, facts, width), surface.definedness};
        const glm::dvec4 lit =
            blended(layer, transfer, [&](std::size_t style) { return lookUp(plan, layer, style, query); });
        return layer.textures.empty()
                   ? lit
                   : glm::dvec4(glm::min(glm::dvec3(lit) * textureAt(plan, layer, transfer, facts), 1.0), lit.a);
    }
    const glm::dvec4 plain =
        blended(layer, transfer, [&](std::size_t style) { return glm::dvec4(layer.styles.styles[style].rgb, 1); });
    const double ink = 1 - optics::contourCoverage(std::abs(surface.normalRay.z), width);
    if (layer.shading == Shading::flat) {
        return {glm::dvec3(plain) * ink, 1};
    }
    const optics::PhongTerms<double> terms{layer.light.ambient, layer.light.diffuse, layer.specular.strength,
                                           layer.specular.exponent};
    const auto lit =
        optics::phong<double>({plain.r, plain.g, plain.b}, optics::facing(surface.normalRay.z, layer.twoSided), terms);
    return {glm::dvec3(lit.r, lit.g, lit.b) * ink, 1};
}

/// One label's part, or the whole where the layer's transfer function has no label axis.
LayerSample shadeRow(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts, int row) {
    const TransferSample transfer = transferAt(plan, layer, facts, row);
    const double width = contourWidthAt(layer, facts);
    const glm::dvec4 c = colourOf(plan, layer, transfer, facts, width);
    const double opacity = layer.illustrative
                               ? optics::illustrativeOpacity(c.a, transfer.opacity, std::abs(facts.surface.normalRay.z),
                                                             width, facts.surface.magnitude)
                               : optics::uniformOpacity(c.a, transfer.opacity);
    return {{c.r, c.g, c.b}, opacity};
}

} // namespace

SurfaceSample surfaceOf(const RenderPlan& plan, const glm::dvec3& directionEye, const glm::dvec3& gradientEye) {
    const Normal normalEye = unitNormal(gradientEye);
    const double magnitude = std::hypot(gradientEye.x, gradientEye.y, gradientEye.z);
    SurfaceSample sample;
    sample.normalRay = optics::normalInRayFrame<double>(normalEye, {directionEye.x, directionEye.y, directionEye.z});
    sample.normalMm = glm::transpose(plan.rays.eyeFromMm) * glm::dvec3(normalEye.x, normalEye.y, normalEye.z);
    sample.definedness = optics::normalDefinedness(magnitude, plan.gradientFloor);
    sample.magnitude = magnitude / plan.gradientMax;
    return sample;
}

SampleFacts sampleFacts(const RenderPlan& plan, const Ray& ray, const Segment& segment, double value) {
    SampleFacts facts;
    const double positionMm = segment.positionMm;
    facts.value = value;
    facts.directionEye = ray.directionEye;
    facts.directionMm = plan.rays.mmFromVoxel * ray.directionVoxel;
    facts.lengthMm = segment.lengthMm;
    facts.positionVoxel = glm::min(ray.positionVoxel(positionMm), glm::dvec3(plan.volume->grid().dims - 1));
    if (plan.rays.perspective) {
        // Along the view's middle; 1 at the target plane, where a pixel is as wide as planned.
        const glm::dvec3 fromEye = plan.rays.mmFromVoxel * (facts.positionVoxel - plan.rays.originVoxel);
        const glm::dvec3 toPlane = plan.rays.mmFromVoxel * plan.rays.forwardVoxel;
        facts.depth = (plan.rays.eyeFromMm * fromEye).z / (plan.rays.eyeFromMm * toPlane).z;
    }
    if (readsNormal(plan)) {
        facts.surface = surfaceSample(plan, ray, positionMm);
    }
    for (const PlanLayer& layer : plan.layers) {
        if (readsTurn(layer)) {
            facts.turns.emplace_back(layer.contours->probeMm,
                                     turnAt(plan, ray, facts.positionVoxel, layer.contours->probeMm));
        }
    }
    if (plan.labels) {
        facts.membership = membershipAt(*plan.labels, facts.positionVoxel);
    }
    if (plan.faces) {
        layOntoFace(plan, *plan.faces, facts);
    }
    return facts;
}

double opacityOf(const PlanLayer& layer, double value) {
    return std::clamp(curveOpacityAt(layer.source->transfer, value) * layer.source->opacity, 0.0, 1.0);
}

namespace {

/// Rows of the layer's table that a sample reads, with their weights: of the labels around it that show.
std::vector<std::pair<int, double>> rowsAt(const PlanLayer& layer, const SampleFacts& facts) {
    std::vector<std::pair<int, double>> rows;
    for (const auto& [slot, weight] : facts.membership) {
        const bool shown = layer.shownSlots.empty() || layer.shownSlots[static_cast<std::size_t>(slot)] != 0;
        const int row = layer.rowOfSlot.empty() ? 0 : layer.rowOfSlot[static_cast<std::size_t>(slot)];
        if (shown && row >= 0) {
            rows.emplace_back(row, weight);
        }
    }
    return rows;
}

/// What the transfer function, contours and transparency make of a sample.
LayerSample classified(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts) {
    if (!readsLabels(layer)) {
        return shadeRow(plan, layer, facts, 0);
    }
    LayerSample sum;
    for (const auto& [row, weight] : rowsAt(layer, facts)) {
        // An invisible neighbour's colour must not bleed: colours are weighted by opacity.
        const LayerSample part = shadeRow(plan, layer, facts, row);
        const double share = weight * part.opacity;
        sum.colour = {sum.colour.r + share * part.colour.r, sum.colour.g + share * part.colour.g,
                      sum.colour.b + share * part.colour.b};
        sum.opacity += share;
    }
    if (sum.opacity > 0) {
        sum.colour = {sum.colour.r / sum.opacity, sum.colour.g / sum.opacity, sum.colour.b / sum.opacity};
    }
    return sum;
}

} // namespace

std::vector<std::pair<int, double>> nodesAt(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts) {
    std::vector<double> sums(layer.styles.nodeToStyle.size(), 0.0);
    const auto add = [&](int row, double weight) {
        const TransferSample transfer = transferAt(plan, layer, facts, row);
        for (const TransferSample::Node& node : transfer.nodes) {
            sums[static_cast<std::size_t>(node.node)] += weight * transfer.opacity * node.weight;
        }
    };
    if (!readsLabels(layer)) {
        add(0, 1);
    } else {
        for (const auto& [row, weight] : rowsAt(layer, facts)) {
            add(row, weight);
        }
    }
    const double all = std::accumulate(sums.begin(), sums.end(), 0.0);
    std::vector<std::pair<int, double>> nodes;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (sums[i] > 0) {
            nodes.emplace_back(static_cast<int>(i), sums[i] / all);
        }
    }
    return nodes;
}

LayerSample shadeLayer(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts) {
    const bool cutFaces = layer.cut && layer.cut->faces;
    if (!layer.focus && !cutFaces) {
        return withCues(plan, facts, withParts(plan, layer, facts, classified(plan, layer, facts)));
    }
    SampleFacts own = facts;
    if (layer.focus) {
        blur(plan, *layer.focus, own);
        if (plan.faces) { // blurred is what is inside
            own.faces.clear();
            layOntoFace(plan, *plan.faces, own);
        }
    }
    if (cutFaces) {
        layOntoFace(plan, *layer.cut, own);
    }
    return withCues(plan, own, withParts(plan, layer, own, classified(plan, layer, own)));
}

} // namespace limner::reference
