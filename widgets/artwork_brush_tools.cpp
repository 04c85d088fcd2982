#include "widgets/artwork_brush_tools.h"

#include "widgets/artwork_painting.h"
#include "widgets/draft_edits.h"

#include <QPainter>
#include <QPalette>

#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr double kLeastStep = 2;  // logical pixels between two places of a lasso
constexpr double kLeastArea = 40; // logical pixels squared: less is a slip of the hand

double areaOf(const QPolygonF& outline) {
    double twice = 0;
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const QPointF a = outline[i];
        const QPointF b = outline[(i + 1) % outline.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice) / 2;
}

OutlineMode modeOf(Qt::KeyboardModifiers modifiers) {
    return modifiers.testFlag(Qt::AltModifier)     ? OutlineMode::subtract
           : modifiers.testFlag(Qt::ShiftModifier) ? OutlineMode::add
                                                   : OutlineMode::replace;
}

} // namespace

ExtractionDraft withRegion(const ExtractionDraft& draft, MaskPtr region, OutlineMode mode) {
    ExtractionDraft changed = draft;
    changed.form = FormKind::region;
    changed.region = std::move(region);
    if (mode == OutlineMode::replace)
        changed.marks = {};
    if (changed.region && !marksAnything(*changed.region)) { // all of it was taken away
        changed.region.reset();
        changed.marks = {};
        changed.form = FormKind::none;
    }
    return changed;
}

ExtractionDraft withOutline(const ExtractionDraft& draft, const ArtPath& outline, OutlineMode mode) {
    const ArtworkPlate& plate = *draft.plate;
    const bool fresh = mode == OutlineMode::replace || !draft.region;
    ArtPath inMask;
    for (const glm::dvec2& place : outline)
        inMask.push_back(place / plate.reduction());
    const Mask base = fresh ? blankMask(plate) : *draft.region;
    return withRegion(draft, withEnclosed(base, inMask, mode == OutlineMode::subtract), mode);
}

void OutlineTool::press(const ToolPointer& pointer) {
    if (!draft().plate)
        return;
    mode_ = modeOf(pointer.modifiers);
    path_ = {pointer.place};
}

void OutlineTool::drag(const ToolPointer& pointer) {
    if (path_.empty() || away(path_.back(), pointer) < kLeastStep)
        return;
    path_.push_back(pointer.place);
    host().refresh();
}

void OutlineTool::release(const ToolPointer&) {
    const ArtPath path = std::exchange(path_, {});
    host().refresh();
    if (path.size() < 3 || areaOf(outlineOf(path, host().view())) < kLeastArea)
        return;
    if (mode_ != OutlineMode::subtract && host().options().findEdge)
        host().refine(path, mode_);
    else
        once(withOutline(draft(), path, mode_),
             mode_ == OutlineMode::subtract ? tr("Take away from the form") : tr("Outline form"));
}

void OutlineTool::cancel() {
    path_.clear();
    host().refresh();
}

void OutlineTool::remove() {
    if (draft().form == FormKind::region)
        once(withRegion(draft(), std::make_shared<const Mask>(), OutlineMode::replace), tr("Remove form"));
}

void OutlineTool::paint(QPainter& painter) const {
    if (!path_.empty())
        drawHaloOutline(painter, outlineOf(path_, host().view()), host().colours().color(QPalette::Highlight));
}

QString OutlineTool::hint() const {
    if (draft().form == FormKind::region)
        return tr("Drag around a new form; Shift adds to this one, Alt takes away from it");
    return host().options().findEdge ? tr("Drag roughly around a shaded form: its edge will be found")
                                     : tr("Drag around a shaded form, along its edge");
}

const MaskPtr& BrushTool::mask() const { return on_ == On::region ? draft().region : draft().ignored; }

QString BrushTool::label() const {
    if (on_ == On::region)
        return erases_ ? tr("Erase form") : tr("Paint form");
    return erases_ ? tr("Look here again") : tr("Ignore here");
}

void BrushTool::strokeTo(const ToolPointer& pointer, bool ongoing) {
    const ArtworkPlate& plate = *draft().plate;
    const double radius = host().options().brushRadius / host().view().scale() / plate.reduction();
    const BrushStroke stroke{last_.place / plate.reduction(), pointer.place / plate.reduction(), radius, erases_};
    MaskPtr painted = withStroke(mask() ? *mask() : blankMask(plate), stroke);
    last_ = pointer;
    ExtractionDraft changed = draft();
    if (on_ == On::region) {
        // A stroke that has taken all away ends with no form, not in the middle of it.
        changed = ongoing ? draft() : withRegion(draft(), painted, OutlineMode::add);
        if (ongoing) {
            changed.form = FormKind::region;
            changed.region = std::move(painted);
        }
    } else {
        changed.ignored = std::move(painted);
    }
    during(std::move(changed), label(), ongoing);
}

void BrushTool::press(const ToolPointer& pointer) {
    if (!draft().plate)
        return;
    painting_ = true;
    erases_ = pointer.modifiers.testFlag(Qt::AltModifier);
    last_ = pointer;
    begin(on_ == On::region ? "brush/region" : "brush/ignored");
    strokeTo(pointer, true);
}

void BrushTool::drag(const ToolPointer& pointer) {
    if (painting_)
        strokeTo(pointer, true);
}

void BrushTool::release(const ToolPointer& pointer) {
    if (std::exchange(painting_, false))
        strokeTo(pointer, false);
}

void BrushTool::hover(const ToolPointer& pointer) {
    last_ = pointer;
    over_ = true;
    host().refresh();
}

void BrushTool::remove() {
    if (on_ == On::region && draft().form == FormKind::region) {
        once(withRegion(draft(), std::make_shared<const Mask>(), OutlineMode::replace), tr("Remove form"));
    } else if (on_ == On::ignored && draft().ignored) {
        ExtractionDraft changed = draft();
        changed.ignored.reset();
        once(std::move(changed), tr("Look everywhere"));
    }
}

void BrushTool::paint(QPainter& painter) const {
    if (!over_ && !painting_)
        return;
    const double radius = host().options().brushRadius;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 230), 2.8));
    painter.drawEllipse(last_.position, radius, radius);
    painter.setPen(QPen(QColor(0x1d, 0x2b, 0x45), 1.2));
    painter.drawEllipse(last_.position, radius, radius);
}

QString BrushTool::hint() const {
    return on_ == On::region ? tr("Paint the form; Alt erases; [ and ] change the brush")
                             : tr("Paint over letters and lines that are not the form's; Alt erases; [ and ] change "
                                  "the brush");
}

} // namespace limner
