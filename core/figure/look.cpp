#include "core/figure/look.h"

#include "core/volume/histogram.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace limner {
namespace {

constexpr const char* kLookPointer = "/look"; // of a member that figures at large do not have
constexpr int kBins = 4096;

void copyLook(const Figure& from, Figure& to) {
    to.styles = from.styles;
    to.layers = from.layers;
    to.importance = from.importance;
    to.depthCues = from.depthCues;
    to.stipple = from.stipple;
    to.background = from.background;
}

/// What a scan's values are like: enough to carry positions over to another scan.
struct Values {
    std::string unit;
    double low = 0; ///< below it lies a hundredth of the voxels
    double high = 1;
};

std::optional<Values> valuesOf(const Figure& figure) {
    if (!figure.volume || !figure.volume->data)
        return std::nullopt;
    const Volume& volume = *figure.volume->data;
    const Histogram histogram = computeHistogram(volume, kBins);
    return Values{volume.contents().unit, histogram.percentile(0.01), histogram.percentile(0.99)};
}

std::optional<Values> notedValues(const Figure& look) {
    const auto found = look.unknown.find(kLookPointer);
    if (found == look.unknown.end())
        return std::nullopt;
    const nlohmann::json noted = nlohmann::json::parse(found->second, nullptr, false);
    const auto number = [&](const char* name) {
        return noted.is_object() && noted.contains(name) && noted[name].is_number();
    };
    if (!number("low") || !number("high"))
        return std::nullopt;
    return Values{noted.value("unit", std::string()), noted["low"], noted["high"]};
}

/// Applies `place` to every position on the axis of values.
template <class Place>
void movePositions(Transfer& transfer, const Place& place) {
    const bool flat = transfer.kind == TransferKind::oneDimensional;
    const auto isValue = [&](std::size_t axis) {
        return flat ? transfer.axis == "value" : axis < transfer.axes.size() && transfer.axes[axis] == "value";
    };
    if (isValue(0)) {
        for (TransferNode& node : transfer.nodes)
            node.at = place(node.at);
        for (glm::dvec2& point : transfer.opacity)
            point.x = place(point.x);
    }
    for (std::size_t axis = 0; axis < 2 && !flat; ++axis) {
        if (!isValue(axis))
            continue;
        if (transfer.grid)
            for (double& at : axis == 0 ? transfer.grid->x : transfer.grid->y)
                at = place(at);
        for (OpacityShape& shape : transfer.opacity2d)
            for (double& at : axis == 0 ? shape.x : shape.y)
                at = place(at);
    }
}

void carryOver(Figure& result, const Figure& look, std::vector<std::string>& notes) {
    const auto from = notedValues(look);
    const auto to = valuesOf(result);
    if (!to)
        return;
    if (!from) {
        notes.emplace_back("nothing is known of the scan that the look was made on: its values are taken as they are");
        return;
    }
    if (!to->unit.empty() && from->unit == to->unit)
        return;
    const double scale = (to->high - to->low) / std::max(from->high - from->low, 1e-300);
    if (from->low == to->low && from->high == to->high)
        return;
    for (Layer& layer : result.layers)
        movePositions(layer.transfer, [&](double at) { return to->low + (at - from->low) * scale; });
    notes.emplace_back("the look was made on a scan with other values: its values were fitted to this one's");
}

} // namespace

Figure lookOf(const Figure& figure) {
    Figure look;
    look.title = figure.title;
    copyLook(figure, look);
    for (Layer& layer : look.layers) {
        layer.clip.reset();
        layer.solo = layer.locked = false;
    }
    if (look.importance)
        std::erase_if(look.importance->lenses, [](const Lens& lens) { return lens.anchorMm.has_value(); });
    if (const auto values = valuesOf(figure))
        look.unknown[kLookPointer] =
            nlohmann::json{{"unit", values->unit}, {"low", values->low}, {"high", values->high}}.dump();
    return look;
}

Figure withLook(const Figure& figure, const Figure& look, std::vector<std::string>& notes) {
    Figure result = figure;
    copyLook(look, result);
    carryOver(result, look, notes);
    return result;
}

} // namespace limner
