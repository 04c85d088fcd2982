#include "renderer/style_target.h"

#include "core/figure/transfer_edits.h"
#include "core/style/transfer_function.h"
#include "renderer/reference/field.h"
#include "renderer/reference/layer_optics.h"
#include "renderer/reference/ray_parts.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace limner {

namespace {

constexpr double kHardlySeen = 0.04; ///< share of a pixel: fog that nobody aims at

using Values = std::vector<std::pair<double, double>>; ///< (value, weight)

/// Index of the layer of the plan that makes most of the pixel, and how much it makes.
std::pair<std::size_t, double> heaviestLayer(const std::vector<reference::RayPart>& parts, std::size_t layers) {
    std::vector<double> sums(layers, 0.0);
    for (const reference::RayPart& part : parts) {
        sums[part.layer] += part.weight;
    }
    const auto most = std::max_element(sums.begin(), sums.end());
    return {static_cast<std::size_t>(most - sums.begin()), most == sums.end() ? 0 : *most};
}

/// What is seen of each node of a layer along a ray.
std::vector<Values> valuesOfNodes(const RenderPlan& plan, std::size_t layer, const glm::dvec2& positionPixel,
                                  const std::vector<reference::RayPart>& parts) {
    constexpr double kTelling = 0.02; // of the heaviest sample: the rest changes no decision and is most of the work
    double least = 0;
    for (const reference::RayPart& part : parts) {
        least = part.layer == layer ? std::max(least, kTelling * part.weight) : least;
    }
    const PlanLayer& planned = plan.layers[layer];
    const auto ray = reference::rayThrough(plan, positionPixel);
    std::vector<Values> nodes(planned.styles.nodeToStyle.size());
    for (const reference::RayPart& part : parts) {
        if (part.layer != layer || part.weight < least) {
            continue;
        }
        const reference::Segment segment = reference::segmentOf(*ray, plan.lattice, part.sample);
        const reference::SampleFacts facts = reference::sampleFacts(plan, *ray, segment, part.value);
        for (const auto& [node, share] : reference::nodesAt(plan, planned, facts)) {
            nodes[static_cast<std::size_t>(node)].emplace_back(part.value, part.weight * share);
        }
    }
    return nodes;
}

double weightOf(const Values& values) {
    double sum = 0;
    for (const auto& [value, weight] : values) {
        sum += weight;
    }
    return sum;
}

double medianOf(Values values) {
    std::sort(values.begin(), values.end());
    double left = weightOf(values) / 2;
    for (const auto& [value, weight] : values) {
        left -= weight;
        if (left <= 0) {
            return value;
        }
    }
    return values.back().first;
}

/// From the first value with some opacity to the last one.
ValueRange visibleValues(const std::vector<glm::dvec2>& points) {
    constexpr double kEverywhere = std::numeric_limits<double>::infinity();
    ValueRange range{kEverywhere, -kEverywhere};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].y > 0) { // up to the clear points beside it
            range.low = std::min(range.low, i > 0 ? points[i - 1].x : -kEverywhere);
            range.high = std::max(range.high, i + 1 < points.size() ? points[i + 1].x : kEverywhere);
        }
    }
    return range;
}

ValueRange rangeOfNode(const RenderPlan& plan, const Transfer& transfer, std::size_t node) {
    const ValueRange data = plan.volume->range();
    const ValueRange visible = visibleValues(transfer.opacity);
    ValueRange range{std::max(data.low, visible.low), std::min(data.high, visible.high)};
    const auto& nodes = transfer.nodes;
    if (node > 0 && node < nodes.size()) {
        range.low = std::max(range.low, (nodes[node - 1].at + nodes[node].at) / 2);
    }
    if (node + 1 < nodes.size()) {
        range.high = std::min(range.high, (nodes[node].at + nodes[node + 1].at) / 2);
    }
    return range;
}

ValueRange rangeOfValues(const Values& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {low->first, high->first};
}

/// Makes a layer show where it is, in one of two colours.
class MapLook {
  public:
    explicit MapLook(Layer& layer) : layer_(layer) {
        layer.shading = Shading::flat;
        layer.tone.reset();
        layer.specular.reset();
        layer.position.reset();
        if (layer.clip && layer.clip->face) {
            layer.clip->face = CutFace{};
        }
        if (secondAxis(layer.transfer)) {
            TransferGrid grid = layer.transfer.grid.value_or(wholePlane(layer.transfer));
            grid.styles.assign(std::max<std::size_t>(1, grid.y.size()),
                               std::vector<std::string>(std::max<std::size_t>(1, grid.x.size())));
            layer.transfer.grid = std::move(grid);
        } else if (layer.transfer.nodes.empty()) {
            layer.transfer.nodes.emplace_back();
        }
    }

    void set(bool meant, std::optional<std::size_t> node) const {
        const auto ofNode = [&](std::size_t i) { return meant && (!node || i == *node); };
        if (layer_.silhouette) {
            layer_.silhouette->rgb = rgbOf(meant);
        }
        if (secondAxis(layer_.transfer)) {
            std::size_t cell = 0;
            for (auto& row : layer_.transfer.grid->styles) {
                for (std::string& look : row) {
                    look = ofNode(cell++) ? "#ff0000" : "#00ff00";
                }
            }
            return;
        }
        for (std::size_t i = 0; i < layer_.transfer.nodes.size(); ++i) {
            layer_.transfer.nodes[i].style.clear();
            layer_.transfer.nodes[i].rgb = rgbOf(ofNode(i));
        }
    }

  private:
    static glm::dvec3 rgbOf(bool meant) { return meant ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0); }

    Layer& layer_;
};

} // namespace

std::size_t styleNodes(const Transfer& transfer) {
    if (!secondAxis(transfer)) {
        return transfer.nodes.size();
    }
    return transfer.grid
               ? std::max<std::size_t>(1, transfer.grid->x.size()) * std::max<std::size_t>(1, transfer.grid->y.size())
               : 0;
}

std::optional<StyleTarget> styleTarget(const RenderPlan& plan, const glm::dvec2& positionPixel) {
    const std::vector<reference::RayPart> parts = reference::rayParts(plan, positionPixel);
    const auto [layer, share] = heaviestLayer(parts, plan.layers.size());
    if (share < kHardlySeen) {
        return std::nullopt;
    }
    const std::vector<Values> nodes = valuesOfNodes(plan, layer, positionPixel, parts);
    const auto most = std::max_element(nodes.begin(), nodes.end(),
                                       [](const Values& a, const Values& b) { return weightOf(a) < weightOf(b); });
    if (most == nodes.end() || most->empty()) {
        return std::nullopt;
    }
    const Layer& source = *plan.layers[layer].source;
    StyleTarget target;
    target.layer = static_cast<std::size_t>(&source - plan.figure->layers.data());
    target.value = medianOf(*most);
    target.share = share;
    const auto node = static_cast<std::size_t>(most - nodes.begin());
    if (node < styleNodes(source.transfer)) {
        target.node = node;
    }
    const bool overValue = !secondAxis(source.transfer) && firstAxis(source.transfer) == TransferAxis::value;
    target.range = overValue ? rangeOfNode(plan, source.transfer, node) : rangeOfValues(*most);
    return target;
}

Figure targetMap(const Figure& figure, std::size_t layer, std::optional<std::size_t> node) {
    Figure map = figure;
    for (std::size_t i = 0; i < map.layers.size(); ++i) {
        MapLook(map.layers[i]).set(i == layer, node);
    }
    if (map.clip.face) {
        map.clip.face = CutFace{};
    }
    map.styles.clear();
    map.depthCues.reset();
    map.stipple.reset();
    map.background = Background{};
    map.annotations.clear();
    return map;
}

} // namespace limner
