#include "renderer/annotations/paper_drawing.h"

#include "core/figure/camera_moves.h"
#include "core/figure/layer_edits.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

/// Titles, captions, scale bars, orientation marks and legends, each measured and drawn by itself.

namespace limner {
namespace {

PaperBlock textBlock(const BlockContext& context, const std::string& text, const TextStyle& style) {
    PaperBlock block;
    TextBlock set = setText(text, style);
    block.sizeMm = set.sizeMm;
    block.handleMm = set.sizeMm / 2.0;
    if (set.runs.empty()) {
        block.note = "it says nothing";
    } else {
        block.texts.push_back({std::move(set), {0, 0}, context.ink});
    }
    return block;
}

/// What a style or a colour of the figure is called.
struct LegendRow {
    std::string name;
    std::shared_ptr<const LitSphere> sphere;
    InkColour rgb{0};
};

std::vector<LegendRow> legendRows(const Figure& figure) {
    std::vector<LegendRow> rows;
    std::set<std::string> seen;
    for (const Layer& layer : figure.layers) {
        if (!figure.draws(layer)) {
            continue;
        }
        const std::set<std::string> styles = stylesOf(layer);
        for (const StyleEntry& entry : figure.styles) { // in the figure's order
            if (styles.count(entry.id) > 0 && seen.insert(entry.id).second) {
                rows.push_back({entry.name.empty() ? entry.id : entry.name, entry.sphere, InkColour(128)});
            }
        }
        const auto plain = std::find_if(layer.transfer.nodes.begin(), layer.transfer.nodes.end(),
                                        [](const TransferNode& node) { return node.style.empty() && node.rgb; });
        if (plain != layer.transfer.nodes.end() && styles.empty()) {
            rows.push_back({layer.name.empty() ? "Layer" : layer.name, nullptr, inkColour(*plain->rgb)});
        }
    }
    return rows;
}

} // namespace

TextStyle BlockContext::style() const {
    TextStyle style;
    style.family = annotation.font;
    style.sizePt = sizePtOf(annotation);
    return style;
}

PaperBlock titleBlock(const BlockContext& context) {
    TextStyle style = context.style();
    style.bold = true;
    style.align = TextAlign::centre;
    style.wrapMm = context.paperMm.x - 2 * kMarginMm;
    const std::string& own = context.annotation.text;
    return textBlock(context, own.empty() ? context.figure.title : own, style);
}

PaperBlock captionBlock(const BlockContext& context) {
    TextStyle style = context.style();
    style.wrapMm = context.paperMm.x - 2 * kMarginMm;
    return textBlock(context, context.annotation.text, style);
}

PaperBlock scaleBarBlock(const BlockContext& context) {
    const double scale = paperPerPatient(context.figure.camera, context.figure.output);
    const double length = context.annotation.lengthMm.value_or(roundBarMm(context.paperMm.x / scale));
    const std::string& own = context.annotation.text;
    TextStyle style = context.style();
    style.align = TextAlign::centre;
    TextBlock text = setText(own.empty() ? lengthText(length) : own, style);
    constexpr double kThick = 0.2; // of the letters' size: as heavy as a bold stem
    constexpr double kGap = 0.1;
    const double thick = kThick * text.emMm;
    const double barMm = length * scale;
    PaperBlock block;
    block.sizeMm = {std::max(barMm, text.sizeMm.x), text.sizeMm.y + kGap * text.emMm + thick};
    const double left = (block.sizeMm.x - barMm) / 2;
    block.handleMm = {left, block.sizeMm.y - thick / 2};
    block.bars.push_back({{{left, block.sizeMm.y - thick}, {left + barMm, block.sizeMm.y}}, context.ink});
    block.texts.push_back({text, {(block.sizeMm.x - text.sizeMm.x) / 2, 0}, context.ink});
    if (barMm > context.paperMm.x) {
        block.note = "the bar is longer than the sheet is wide; give it a smaller length_mm";
    } else if (context.figure.camera.projection == Projection::perspective) {
        block.note = "true in the plane through the camera's target only: the view is a perspective";
    }
    return block;
}

PaperBlock orientationBlock(const BlockContext& context) {
    struct Axis {
        glm::dvec3 direction;
        const char *towards, *away;
    };
    // LPS: x to the patient's left, y to the back, z to the head.
    const std::array<Axis, 3> axes{Axis{{1, 0, 0}, "L", "R"}, Axis{{0, 1, 0}, "P", "A"}, Axis{{0, 0, 1}, "S", "I"}};
    const CameraFrame frame = cameraFrame(context.figure.camera);
    TextStyle style = context.style();
    style.align = TextAlign::centre;
    const TextBlock measure = setText("M", style);
    const double em = measure.emMm;
    const double radius = 1.7 * em;
    const double reach = radius + 0.75 * em; // of the letters' middles
    PaperBlock block;
    block.sizeMm = glm::dvec2(2 * reach + 1.1 * em);
    block.handleMm = block.sizeMm / 2.0;
    for (const Axis& axis : axes) {
        const glm::dvec2 seen(glm::dot(axis.direction, frame.right), -glm::dot(axis.direction, frame.up));
        constexpr double kShortest = 0.3; // an axis that comes nearly straight at the viewer has no letter on paper
        if (glm::length(seen) < kShortest) {
            continue;
        }
        addLine(block.lines, block.handleMm - seen * radius, block.handleMm + seen * radius, 1.4 * kLineMm,
                context.ink);
        for (const double sign : {1.0, -1.0}) {
            const glm::dvec2 along = glm::normalize(seen) * sign;
            const glm::dvec2 middle = block.handleMm + seen * sign * radius + along * (reach - radius);
            TextBlock letter = setText(sign > 0 ? axis.towards : axis.away, style);
            const glm::dvec2 ink(letter.sizeMm.x / 2,
                                 letter.baselinesMm[0] - letter.runs[0].face->metrics().capHeight / 2 * em);
            block.texts.push_back({std::move(letter), middle - ink, context.ink});
        }
    }
    return block;
}

PaperBlock legendBlock(const BlockContext& context) {
    TextStyle style = context.style();
    PaperBlock block;
    double y = 0;
    if (!context.annotation.text.empty()) {
        style.bold = true;
        TextBlock heading = setText(context.annotation.text, style);
        style.bold = false;
        block.sizeMm.x = heading.sizeMm.x;
        y = heading.sizeMm.y;
        if (!heading.runs.empty()) {
            block.texts.push_back({std::move(heading), {0, 0}, context.ink});
        }
    }
    for (const LegendRow& row : legendRows(context.figure)) {
        TextBlock name = setText(row.name, style);
        const double em = name.emMm;
        const double radius = 0.75 * em;
        const double height = std::max(name.sizeMm.y, 1.8 * em);
        block.balls.push_back({{radius, y + height / 2}, radius, row.sphere, row.rgb});
        const glm::dvec2 at(2 * radius + 0.6 * em, y + height / 2 - name.firstMiddleMm);
        block.sizeMm.x = std::max(block.sizeMm.x, at.x + name.sizeMm.x);
        block.texts.push_back({std::move(name), at, context.ink});
        y += height;
    }
    block.sizeMm.y = y;
    block.handleMm = block.sizeMm / 2.0;
    if (block.texts.empty()) {
        block.note = "no layer that is drawn has a style";
    }
    return block;
}

} // namespace limner
