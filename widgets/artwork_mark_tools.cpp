#include "widgets/artwork_mark_tools.h"

#include "widgets/artwork_painting.h"
#include "widgets/draft_edits.h"

#include <QLineF>
#include <QPainter>
#include <QPalette>

#include <cmath>
#include <utility>

namespace limner {
namespace {

std::ptrdiff_t offset(std::size_t place) { return static_cast<std::ptrdiff_t>(place); }

template <typename Mark>
std::optional<std::size_t> heldTo(std::optional<std::size_t> selected, const std::vector<Mark>& marks) {
    return selected && *selected < marks.size() ? selected : std::nullopt; // an undo may have taken it away
}

QPointF onScreen(glm::dvec2 direction) { return {direction.x, direction.y}; }

/// Of a crease's middle, in the canvas.
struct Middle {
    QPointF place;
    QPointF direction;
};
Middle middleIn(const ArtworkView& view, const ArtPath& path) {
    const PathMiddle middle = middleOf(path);
    return {view.toWidget(middle.place), onScreen(middle.direction)};
}

} // namespace

std::optional<std::size_t> NormalTool::selected() const { return heldTo(selected_, draft().marks.normals); }

ExtractionDraft NormalTool::with(const NormalMark& mark) const {
    ExtractionDraft changed = draft();
    changed.form = FormKind::region;
    if (selected())
        changed.marks.normals[*selected()] = mark;
    return changed;
}

void NormalTool::press(const ToolPointer& pointer) {
    if (!canMark())
        return;
    const auto& marks = draft().marks.normals;
    const bool moves = pointer.modifiers.testFlag(Qt::ControlModifier);
    moved_ = false;
    fresh_ = false;
    way_ = Way::none;
    begin("normal");
    for (std::size_t i = marks.size(); i-- > 0 && way_ == Way::none;) {
        const QPointF base = toWidget(marks[i].at);
        const bool onTip = QLineF(needleTip(base, marks[i].normal), pointer.position).length() <= kMarkGrab;
        const bool onBase = away(marks[i].at, pointer) <= kMarkGrab;
        if (!onTip && !onBase)
            continue;
        selected_ = i;
        start_ = marks[i];
        way_ = onTip && !(moves && onBase) ? Way::turning : Way::moving;
    }
    if (way_ != Way::none) {
        host().refresh();
        return;
    }
    start_ = {pointer.place, {0, 0}};
    way_ = Way::turning;
    fresh_ = true;
    selected_ = marks.size();
    ExtractionDraft changed = draft();
    changed.form = FormKind::region;
    changed.marks.normals.push_back(start_);
    during(std::move(changed), tr("Mark a normal"), true);
}

NormalMark NormalTool::changedBy(const ToolPointer& pointer) const {
    NormalMark mark = start_;
    if (way_ == Way::moving)
        mark.at = pointer.place;
    else
        mark.normal = normalOfNeedle(toWidget(start_.at), pointer.position);
    return mark;
}

void NormalTool::drag(const ToolPointer& pointer) {
    if (way_ == Way::none || !selected())
        return;
    moved_ = true;
    during(with(changedBy(pointer)), way_ == Way::moving ? tr("Move normal") : tr("Turn normal"), true);
}

void NormalTool::release(const ToolPointer& pointer) {
    const Way was = way_;
    if (was != Way::none && selected() && (moved_ || fresh_))
        during(with(moved_ ? changedBy(pointer) : start_), was == Way::moving ? tr("Move normal") : tr("Turn normal"),
               false);
    way_ = Way::none;
}

void NormalTool::cancel() {
    if (way_ != Way::none && moved_ && selected() && !fresh_)
        during(with(start_), tr("Turn normal"), false);
    way_ = Way::none;
    selected_.reset();
    host().refresh();
}

bool NormalTool::nudge(glm::dvec2 by) {
    if (!selected())
        return false;
    NormalMark mark = draft().marks.normals[*selected()];
    mark.at += by;
    again("normal/nudge", with(mark), tr("Move normal"));
    return true;
}

void NormalTool::remove() {
    if (!selected())
        return;
    ExtractionDraft changed = draft();
    changed.marks.normals.erase(changed.marks.normals.begin() + offset(*selected()));
    selected_.reset();
    once(std::move(changed), tr("Remove normal"));
}

void NormalTool::paint(QPainter& painter) const {
    if (selected() && draft().form == FormKind::region) {
        const NormalMark& mark = draft().marks.normals[*selected()];
        drawNormal(painter, toWidget(mark.at), mark.normal, host().colours().color(QPalette::Highlight));
    }
}

QString NormalTool::hint() const {
    if (!canMark())
        return tr("Outline a form first (Region), then tell its normals here");
    if (selected())
        return tr("Drag the needle to turn and tilt it; Ctrl+drag or arrow keys move, Delete removes");
    return tr("Press where you know how the form faces, and drag the needle the way it leans");
}

std::optional<std::size_t> CreaseTool::selected() const { return heldTo(selected_, draft().marks.creases); }

std::optional<QPointF> CreaseTool::handle() const {
    if (!selected())
        return std::nullopt;
    const Crease& crease = draft().marks.creases[*selected()];
    const Middle middle = middleIn(host().view(), crease.path);
    return tiltHandle(middle.place, middle.direction, crease.tiltDegrees);
}

ExtractionDraft CreaseTool::with(const Crease& crease) const {
    ExtractionDraft changed = draft();
    changed.form = FormKind::region;
    if (selected())
        changed.marks.creases[*selected()] = crease;
    return changed;
}

std::optional<std::size_t> CreaseTool::creaseAt(const ToolPointer& pointer) const {
    const auto& creases = draft().marks.creases;
    for (std::size_t i = creases.size(); i-- > 0;)
        if (distanceTo(creases[i].path, pointer.place) * host().view().scale() <= kMarkGrab)
            return i;
    return std::nullopt;
}

/// Of the chosen one's handle, or of a crease's corner.
bool CreaseTool::takeHold(const ToolPointer& pointer) {
    moved_ = false;
    if (const auto at = handle(); at && QLineF(*at, pointer.position).length() <= kMarkGrab) {
        way_ = Way::tilting;
        begin("crease/tilt");
        return true;
    }
    selected_ = creaseAt(pointer);
    if (!selected_)
        return false;
    const ArtPath& path = draft().marks.creases[*selected_].path;
    for (std::size_t i = 0; i < path.size(); ++i)
        if (away(path[i], pointer) <= kMarkGrab) {
            way_ = Way::moving;
            corner_ = i;
            begin("crease/corner");
        }
    return true;
}

void CreaseTool::press(const ToolPointer& pointer) {
    if (!draft().region)
        return;
    last_ = pointer;
    way_ = Way::none;
    if (begun_.empty() && takeHold(pointer)) {
        host().refresh();
        return;
    }
    constexpr double kSamePlace = 2; // logical pixels: the second press of a double click
    if (begun_.empty() || away(begun_.back(), pointer) > kSamePlace)
        begun_.push_back(pointer.place);
    host().refresh();
}

void CreaseTool::drag(const ToolPointer& pointer) {
    if (way_ == Way::none || !selected())
        return;
    Crease crease = draft().marks.creases[*selected()];
    if (way_ == Way::tilting) {
        const Middle middle = middleIn(host().view(), crease.path);
        crease.tiltDegrees = std::round(tiltOfHandle(middle.place, middle.direction, pointer.position));
    } else if (corner_ < crease.path.size()) {
        crease.path[corner_] = pointer.place;
    }
    moved_ = true;
    during(with(crease), way_ == Way::tilting ? tr("Tilt crease") : tr("Move crease"), true);
}

void CreaseTool::release(const ToolPointer&) {
    const Way was = std::exchange(way_, Way::none);
    if (was != Way::none && std::exchange(moved_, false) && selected())
        during(with(draft().marks.creases[*selected()]), tr("Change crease"), false);
}

void CreaseTool::hover(const ToolPointer& pointer) {
    last_ = pointer;
    if (!begun_.empty())
        host().refresh();
}

void CreaseTool::finish() {
    const ArtPath path = std::exchange(begun_, {});
    host().refresh();
    if (path.size() < 2)
        return;
    ExtractionDraft changed = draft();
    changed.form = FormKind::region;
    changed.marks.creases.push_back({path});
    selected_ = changed.marks.creases.size() - 1;
    once(std::move(changed), tr("Draw crease"));
}

void CreaseTool::cancel() {
    way_ = Way::none;
    if (begun_.empty())
        selected_.reset();
    begun_.clear();
    host().refresh();
}

bool CreaseTool::nudge(glm::dvec2 by) {
    if (!selected())
        return false;
    Crease crease = draft().marks.creases[*selected()];
    for (glm::dvec2& place : crease.path)
        place += by;
    again("crease/nudge", with(crease), tr("Move crease"));
    return true;
}

void CreaseTool::remove() {
    if (!begun_.empty()) {
        begun_.pop_back();
        host().refresh();
    } else if (selected()) {
        ExtractionDraft changed = draft();
        changed.marks.creases.erase(changed.marks.creases.begin() + offset(*selected()));
        selected_.reset();
        once(std::move(changed), tr("Remove crease"));
    }
}

void CreaseTool::paint(QPainter& painter) const {
    const QColor accent = host().colours().color(QPalette::Highlight);
    if (!begun_.empty()) {
        QPolygonF line = outlineOf(begun_, host().view());
        line << last_.position;
        drawHaloLine(painter, line, accent, 2);
        for (const glm::dvec2& place : begun_)
            drawSquareHandle(painter, toWidget(place), accent);
    }
    if (!selected() || draft().form != FormKind::region)
        return;
    const Crease& crease = draft().marks.creases[*selected()];
    drawHaloLine(painter, outlineOf(crease.path, host().view()), accent, 2.4);
    for (const glm::dvec2& place : crease.path)
        drawSquareHandle(painter, toWidget(place), accent);
    const Middle middle = middleIn(host().view(), crease.path);
    drawHaloLine(painter, QPolygonF({middle.place, *handle()}), accent, 1.4);
    drawRoundHandle(painter, *handle(), accent, true);
    const QString word = crease.tiltDegrees < 0 ? tr("valley %1°") : tr("ridge %1°");
    drawTag(painter, *handle() + QPointF(kMarkHandle + 6, 0), word.arg(std::abs(crease.tiltDegrees), 0, 'f', 0));
}

QString CreaseTool::hint() const {
    if (!draft().region)
        return tr("Outline a form first (Region), then draw its creases here");
    if (!begun_.empty())
        return tr(
            "Click for the next corner; Enter, a double click or the right button ends; Backspace takes one back");
    if (selected())
        return tr(
            "Drag the round handle: up for a ridge, down for a valley; drag corners to move them; Delete removes");
    return tr("Click along a ridge or a valley of the form");
}

void OpenOutlineTool::press(const ToolPointer& pointer) {
    if (draft().region)
        begun_ = {pointer.place};
}

void OpenOutlineTool::drag(const ToolPointer& pointer) {
    constexpr double kLeastStep = 3; // logical pixels
    if (begun_.empty() || away(begun_.back(), pointer) < kLeastStep)
        return;
    begun_.push_back(pointer.place);
    host().refresh();
}

void OpenOutlineTool::release(const ToolPointer& pointer) {
    const ArtPath path = std::exchange(begun_, {});
    if (path.empty())
        return;
    if (path.size() > 1) {
        ExtractionDraft changed = draft();
        changed.form = FormKind::region;
        changed.marks.open.push_back(path);
        selected_ = changed.marks.open.size() - 1;
        once(std::move(changed), tr("Open the outline"));
        return;
    }
    selected_.reset();
    const auto& open = draft().marks.open;
    for (std::size_t i = 0; i < open.size(); ++i)
        if (distanceTo(open[i], pointer.place) * host().view().scale() <= kMarkGrab)
            selected_ = i;
    host().refresh();
}

void OpenOutlineTool::cancel() {
    if (begun_.empty())
        selected_.reset();
    begun_.clear();
    host().refresh();
}

void OpenOutlineTool::remove() {
    const auto chosen = heldTo(selected_, draft().marks.open);
    if (!chosen)
        return;
    ExtractionDraft changed = draft();
    changed.marks.open.erase(changed.marks.open.begin() + offset(*chosen));
    selected_.reset();
    once(std::move(changed), tr("Close the outline"));
}

void OpenOutlineTool::paint(QPainter& painter) const {
    const QColor accent = host().colours().color(QPalette::Highlight);
    if (!begun_.empty())
        drawHaloLine(painter, outlineOf(begun_, host().view()), accent, 3);
    if (const auto chosen = heldTo(selected_, draft().marks.open))
        drawHaloLine(painter, outlineOf(draft().marks.open[*chosen], host().view()), accent, 3);
}

QString OpenOutlineTool::hint() const {
    if (!draft().region)
        return tr("Outline a form first (Region), then tell where its outline is no edge");
    return tr("Drag along the outline where the form goes on, hidden or cut off; click one and Delete to remove it");
}

} // namespace limner
