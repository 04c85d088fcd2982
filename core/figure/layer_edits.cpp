#include "core/figure/layer_edits.h"

#include <algorithm>
#include <cassert>
#include <filesystem>

namespace limner {
namespace {

bool isKeptElsewhere(const StyleEntry& entry) {
    return entry.file.starts_with("bundled:") || std::filesystem::path(entry.file).is_absolute();
}

std::string nameOfItsOwn(const Figure& figure, const std::string& wanted) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(figure.layers.begin(), figure.layers.end(), [&](const Layer& l) { return l.name == name; });
    };
    std::string name = wanted;
    for (int n = 2; taken(name); ++n) {
        name = wanted + " " + std::to_string(n);
    }
    return name;
}

std::ptrdiff_t offset(std::size_t place) { return static_cast<std::ptrdiff_t>(place); }

} // namespace

bool mayChange(const Figure& figure, std::size_t layer) {
    return layer < figure.layers.size() && !figure.layers[layer].locked;
}

std::set<std::string> stylesOf(const Layer& layer) {
    std::set<std::string> used;
    for (const TransferNode& node : layer.transfer.nodes) {
        used.insert(node.style);
    }
    if (layer.transfer.grid) {
        for (const auto& row : layer.transfer.grid->styles) {
            used.insert(row.begin(), row.end());
        }
    }
    if (layer.clip && layer.clip->face) {
        used.insert(layer.clip->face->style);
    }
    used.erase("");
    return used;
}

void exchangeStyle(Layer& layer, const std::string& from, const std::string& to) {
    const auto exchange = [&](std::string& style) {
        if (style == from) {
            style = to;
        }
    };
    for (TransferNode& node : layer.transfer.nodes) {
        exchange(node.style);
    }
    if (layer.transfer.grid) {
        for (auto& row : layer.transfer.grid->styles) {
            std::for_each(row.begin(), row.end(), exchange);
        }
    }
    if (layer.clip && layer.clip->face) {
        exchange(layer.clip->face->style);
    }
}

void dropUnusedStyles(Figure& figure) {
    std::set<std::string> used;
    for (const Layer& layer : figure.layers) {
        used.merge(stylesOf(layer));
    }
    if (figure.clip.face) {
        used.insert(figure.clip.face->style);
    }
    std::erase_if(figure.styles,
                  [&](const StyleEntry& entry) { return isKeptElsewhere(entry) && !used.contains(entry.id); });
}

Layer freshLayer(const Figure& figure) {
    const bool scan = figure.volume && figure.volume->data;
    const ValueRange range = scan ? figure.volume->data->range() : ValueRange{0, 1};
    const auto at = [&](double share) { return range.low + share * (range.high - range.low); };
    Layer layer;
    layer.name = "Layer";
    layer.transfer.opacity = {{at(0.5), 0}, {at(0.6), 0.8}, {at(1), 0.8}};
    if (figure.styles.empty()) {
        layer.shading = Shading::phong;
        layer.transfer.nodes = {{at(0.6), "", glm::dvec3(0.85, 0.8, 0.72)}};
    } else {
        layer.transfer.nodes = {{at(0.6), figure.styles.front().id, std::nullopt}};
    }
    return layer;
}

Figure withLayerAdded(const Figure& figure, std::size_t place, Layer layer) {
    Figure result = figure;
    layer.name = nameOfItsOwn(figure, layer.name);
    result.layers.insert(result.layers.begin() + offset(std::min(place, figure.layers.size())), std::move(layer));
    return result;
}

Figure withLayerDuplicated(const Figure& figure, std::size_t layer) {
    assert(layer < figure.layers.size());
    Layer copy = figure.layers[layer];
    copy.locked = false;
    copy.solo = false;
    return withLayerAdded(figure, layer + 1, std::move(copy));
}

Figure withLayerRemoved(const Figure& figure, std::size_t layer) {
    assert(layer < figure.layers.size());
    Figure result = figure;
    result.layers.erase(result.layers.begin() + offset(layer));
    dropUnusedStyles(result);
    return result;
}

Figure withLayerMoved(const Figure& figure, std::size_t from, std::size_t to) {
    assert(from < figure.layers.size() && to < figure.layers.size());
    Figure result = figure;
    const auto first = result.layers.begin();
    if (from < to) {
        std::rotate(first + offset(from), first + offset(from) + 1, first + offset(to) + 1);
    } else {
        std::rotate(first + offset(to), first + offset(from), first + offset(from) + 1);
    }
    return result;
}

} // namespace limner
