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

/// An arm of the orientation mark, as long as the camera sees it, 1 at the most.
struct Arm {
    glm::dvec2 seen{0}; ///< to the right, downwards
    std::string letters;
};

/// The patient's axes as the camera sees them; where letters would lie on each other, what lies towards the four edges.
std::vector<Arm> armsOf(const Camera& camera) {
    // LPS: x to the patient's left, y to the back, z to the head.
    const std::array<std::array<const char*, 2>, 3> names{{{"L", "R"}, {"P", "A"}, {"S", "I"}}};
    const CameraFrame frame = cameraFrame(camera);
    std::vector<Arm> arms;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec2 seen(frame.right[axis], -frame.up[axis]);
        constexpr double kShortest = 0.3; // an axis that comes nearly straight at the viewer has no letter on paper
        if (glm::length(seen) >= kShortest) {
            arms.push_back({seen, names[static_cast<std::size_t>(axis)][0]});
            arms.push_back({-seen, names[static_cast<std::size_t>(axis)][1]});
        }
    }
    constexpr double kNearest = 0.6; // between letters' middles, of an arm's length: they are as wide as that
    const auto end = [](const Arm& arm) { return arm.seen + 0.44 * glm::normalize(arm.seen); };
    bool clash = false;
    for (std::size_t i = 0; i < arms.size(); ++i) {
        for (std::size_t k = i + 1; k < arms.size(); ++k) {
            clash = clash || glm::distance(end(arms[i]), end(arms[k])) < kNearest;
        }
    }
    if (clash) {
        const EdgeLetters edges = edgeLetters(camera);
        arms = {{{-1, 0}, edges.left}, {{1, 0}, edges.right}, {{0, -1}, edges.top}, {{0, 1}, edges.bottom}};
    }
    return arms;
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
    TextStyle style = context.style();
    style.align = TextAlign::centre;
    const double em = setText("M", style).emMm;
    const double radius = 1.7 * em;
    const double reach = radius + 0.75 * em; // of the letters' middles
    PaperBlock block;
    block.sizeMm = glm::dvec2(2 * reach + 1.1 * em);
    block.handleMm = block.sizeMm / 2.0;
    for (const Arm& arm : armsOf(context.figure.camera)) {
        addLine(block.lines, block.handleMm, block.handleMm + arm.seen * radius, 1.4 * kLineMm, context.ink);
        const glm::dvec2 along = glm::normalize(arm.seen);
        const glm::dvec2 middle = block.handleMm + arm.seen * radius + along * (reach - radius);
        TextBlock letters = setText(arm.letters, style);
        const glm::dvec2 ink(letters.sizeMm.x / 2,
                             letters.baselinesMm[0] - letters.runs[0].face->metrics().capHeight / 2 * em);
        block.texts.push_back({std::move(letters), middle - ink, context.ink});
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
