#include "core/figure/label_look.h"

#include "core/base/error.h"
#include "core/volume/derived_fields.h"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>

namespace limner {

namespace {

struct LightAndChroma {
    double lightness;
    double chroma;
};

/// Linear sRGB of OKLCH (bottosson.github.io/posts/oklab).
glm::dvec3 linearRgb(const LightAndChroma& tone, double hue) {
    const double a = tone.chroma * std::cos(hue);
    const double b = tone.chroma * std::sin(hue);
    const glm::dvec3 root = {tone.lightness + 0.3963377774 * a + 0.2158037573 * b,
                             tone.lightness - 0.1055613458 * a - 0.0638541728 * b,
                             tone.lightness - 0.0894841775 * a - 1.2914855480 * b};
    const glm::dvec3 lms = root * root * root;
    return {4.0767416621 * lms.x - 3.3077115913 * lms.y + 0.2309699292 * lms.z,
            -1.2684380046 * lms.x + 2.6097574011 * lms.y - 0.3413193965 * lms.z,
            -0.0041960863 * lms.x - 0.7034186147 * lms.y + 1.7076147010 * lms.z};
}

double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

std::string colourOf(LightAndChroma tone, double hue) {
    glm::dvec3 rgb = linearRgb(tone, hue);
    constexpr double kLess = 0.97;
    while (glm::any(glm::lessThan(rgb, glm::dvec3(0))) || glm::any(glm::greaterThan(rgb, glm::dvec3(1)))) {
        tone.chroma *= kLess; // grey is always inside
        rgb = linearRgb(tone, hue);
    }
    char text[8];
    const auto part = [&](int i) { return static_cast<unsigned>(std::lround(255 * encoded(rgb[i]))); };
    std::snprintf(text, sizeof text, "#%02x%02x%02x", part(0) & 0xffU, part(1) & 0xffU, part(2) & 0xffU);
    return text;
}

bool isPlainColour(const std::string& text) {
    constexpr std::size_t kLength = 7;
    return text.size() == kLength && text.front() == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

/// Labels that get a row, rising.
std::vector<int> rowsFor(const LabelReference& labels, std::vector<std::string>& notes) {
    const auto counts = labels.data ? labelCounts(*labels.data) : std::nullopt;
    std::vector<std::pair<std::size_t, int>> found; // voxels, label
    for (const auto& [label, voxels] : counts.value_or(std::map<int, std::size_t>())) {
        if (label > 0) {
            found.emplace_back(voxels, label);
        }
    }
    if (found.empty()) {
        throw Error(ErrorKind::badInput, {"cannot draw the labels", labels.path,
                                          labels.data ? "no voxel has a label above 0" : "their volume is not loaded",
                                          labels.data ? "take another label volume" : "find the label volume first"});
    }
    if (found.size() > kMostLabelRows) {
        notes.push_back("The " + std::to_string(kMostLabelRows) + " largest of " + std::to_string(found.size()) +
                        " labels are drawn.");
        std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
        found.resize(kMostLabelRows);
    }
    std::vector<int> rows;
    for (const auto& [voxels, label] : found) {
        rows.push_back(label);
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

} // namespace

std::vector<std::string> distinctColours(std::size_t count) {
    constexpr LightAndChroma kTones[] = {{0.74, 0.115}, {0.60, 0.115}, {0.84, 0.095}};
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    constexpr double kFirstHue = 0.75; // a warm clay, as bone and skin are
    std::vector<std::string> colours;
    for (std::size_t i = 0; i < count; ++i) {
        colours.push_back(colourOf(kTones[i % std::size(kTones)], kFirstHue + golden * static_cast<double>(i)));
    }
    return colours;
}

Figure withLabels(const Figure& figure, const LabelReference& labels, std::vector<std::string>& notes) {
    const std::vector<int> rows = rowsFor(labels, notes);
    const std::vector<std::string> palette = distinctColours(rows.size());
    TransferGrid grid;
    grid.x = {0}; // one column: the value does not matter
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto own = labels.colours.find(std::to_string(rows[i]));
        grid.y.push_back(rows[i]);
        const bool known = own != labels.colours.end() && isPlainColour(own->second);
        grid.styles.push_back({known ? own->second : palette[i]});
    }
    constexpr double kContourMm = 0.3;
    Layer layer;
    layer.name = "Labels";
    layer.transfer.kind = TransferKind::twoDimensional;
    layer.transfer.axes = {"value", "label"};
    layer.transfer.grid = std::move(grid);
    layer.shading = Shading::phong;
    layer.contours.emplace().thicknessMm = kContourMm;
    Figure changed = figure;
    changed.labels = labels;
    changed.layers = {std::move(layer)};
    return changed;
}

bool drawsByLabel(const Figure& figure) {
    return std::any_of(figure.layers.begin(), figure.layers.end(), [](const Layer& layer) {
        const auto& axes = layer.transfer.axes;
        return layer.visible && layer.transfer.kind == TransferKind::twoDimensional &&
               std::find(axes.begin(), axes.end(), "label") != axes.end();
    });
}

} // namespace limner
