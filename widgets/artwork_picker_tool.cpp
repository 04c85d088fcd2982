#include "widgets/artwork_picker_tool.h"

#include "widgets/artwork_painting.h"
#include "widgets/core_words.h"
#include "widgets/draft_edits.h"

#include <QPainter>

#include <array>
#include <utility>

namespace limner {
namespace {

constexpr double kPickRadius = 3; // logical pixels: a few strokes of grain or hatching

QColor colourOf(const Rgba& c) { return QColor::fromRgbF(c.r, c.g, c.b); }

std::size_t indexOf(SwatchRole role) { return static_cast<std::size_t>(role); }

/// The first that has no colour yet; where all have one, the same again.
SwatchRole nextRole(const PickedSwatches& swatches, SwatchRole current) {
    // Light and shadow are what no sphere can do without.
    constexpr std::array kOrder{SwatchRole::light, SwatchRole::shadow, SwatchRole::mid, SwatchRole::rim,
                                SwatchRole::highlight};
    for (const SwatchRole role : kOrder)
        if (!swatches.of(role))
            return role;
    return current;
}

} // namespace

QString roleName(SwatchRole role) {
    switch (role) {
    case SwatchRole::light: return PickerTool::tr("Light");
    case SwatchRole::mid: return PickerTool::tr("Mid");
    case SwatchRole::shadow: return PickerTool::tr("Shadow");
    case SwatchRole::rim: return PickerTool::tr("Rim");
    case SwatchRole::highlight: return PickerTool::tr("Highlight");
    }
    return {};
}

std::optional<Rgba> PickerTool::colourUnder(glm::dvec2 place) const {
    return draft().plate ? colourAt(*draft().plate, place, kPickRadius / host().view().scale()) : std::nullopt;
}

void PickerTool::pick(glm::dvec2 place, bool ongoing) {
    const auto colour = colourUnder(place);
    if (!colour && ongoing)
        return;
    ExtractionDraft changed = draft();
    changed.form = FormKind::swatches;
    if (colour)
        changed.swatches.picked[indexOf(host().options().role)] = PickedSwatch{*colour, place};
    during(std::move(changed), tr("Pick %1").arg(inSentence(roleName(host().options().role))), ongoing);
}

void PickerTool::press(const ToolPointer& pointer) {
    picking_ = colourUnder(pointer.place).has_value();
    begin("swatch");
    if (picking_)
        pick(pointer.place, true);
}

void PickerTool::drag(const ToolPointer& pointer) {
    over_ = pointer;
    if (picking_)
        pick(pointer.place, true);
}

void PickerTool::release(const ToolPointer& pointer) {
    if (!std::exchange(picking_, false))
        return;
    pick(pointer.place, false);
    ToolOptions options = host().options();
    options.role = nextRole(draft().swatches, options.role);
    host().changeOptions(options);
}

void PickerTool::hover(const ToolPointer& pointer) {
    over_ = pointer;
    host().refresh();
}

bool PickerTool::nudge(glm::dvec2 by) {
    const auto& swatch = draft().swatches.of(host().options().role);
    if (!swatch || !draft().plate)
        return false;
    begin("swatch/nudge");
    pick(swatch->at + by, false);
    return true;
}

void PickerTool::remove() {
    ExtractionDraft changed = draft();
    changed.swatches.picked[indexOf(host().options().role)].reset();
    once(std::move(changed), tr("Remove %1").arg(inSentence(roleName(host().options().role))));
}

void PickerTool::paint(QPainter& painter) const {
    if (!over_)
        return;
    const auto colour = colourUnder(over_->place);
    if (!colour)
        return;
    const QRectF chip(over_->position + QPointF(14, 14), QSizeF(34, 34)); // beside the pointer, not under it
    painter.setPen(QPen(QColor(0x1d, 0x2b, 0x45), 1));
    painter.setBrush(Qt::white);
    painter.drawRoundedRect(chip, 5, 5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colourOf(*colour));
    painter.drawRoundedRect(chip.adjusted(3, 3, -3, -3), 3, 3);
}

QString PickerTool::hint() const {
    return tr("Click the colour of “%1”; light and shadow are enough, drag on the ball to turn the light")
        .arg(roleName(host().options().role));
}

} // namespace limner
