#include "widgets/artwork_ellipse_tool.h"

#include "widgets/artwork_painting.h"

#include <QLineF>
#include <QPainter>
#include <QPalette>

#include <array>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr double kClickReach = 4; // logical pixels: a hand that clicks moves that much

constexpr std::array kHandles{EllipseHandle::turn,           EllipseHandle::first,  EllipseHandle::firstOpposite,
                              EllipseHandle::secondOpposite, EllipseHandle::second, EllipseHandle::centre};

bool isRound(const Ellipse& ellipse) {
    return std::abs(ellipse.semiAxes.x - ellipse.semiAxes.y) <= 1e-9 * ellipse.semiAxes.x; // but for rounding
}

} // namespace

const Ellipse* EllipseTool::shown() const {
    return draft().form == FormKind::ellipse && draft().ellipse ? &*draft().ellipse : nullptr;
}

glm::dvec2 EllipseTool::placeOf(EllipseHandle handle) const {
    return handlePlace(*shown(), handle, kTurnKnob / host().view().scale());
}

std::optional<EllipseHandle> EllipseTool::handleAt(const ToolPointer& pointer) const {
    if (!shown())
        return std::nullopt;
    for (const EllipseHandle handle : kHandles)
        if (away(placeOf(handle), pointer) <= kMarkGrab)
            return handle;
    return std::nullopt;
}

std::optional<std::size_t> EllipseTool::proposalAt(glm::dvec2 place) const {
    std::optional<std::size_t> best;
    const auto& things = host().roundThings();
    const auto area = [&](std::size_t i) { return things[i].ellipse.semiAxes.x * things[i].ellipse.semiAxes.y; };
    for (std::size_t i = 0; i < things.size(); ++i)
        if (contains(things[i].ellipse, place) && (!best || area(i) < area(*best)))
            best = i;
    return best;
}

ExtractionDraft EllipseTool::with(const Ellipse& ellipse) const {
    ExtractionDraft changed = draft();
    changed.form = FormKind::ellipse;
    changed.ellipse = ellipse;
    return changed;
}

Ellipse EllipseTool::drawnTo(const ToolPointer& pointer) const {
    EllipseDrag how;
    how.circle = circle_ || pointer.modifiers.testFlag(Qt::ShiftModifier);
    how.fromCentre = host().options().fromCentre != pointer.modifiers.testFlag(Qt::AltModifier);
    return drawnEllipse(from_.place, pointer.place, how);
}

void EllipseTool::press(const ToolPointer& pointer) {
    from_ = pointer;
    moved_ = false;
    const auto handle = handleAt(pointer);
    way_ = handle ? Way::holding : Way::pressed;
    if (handle) {
        held_ = *handle;
        start_ = *shown();
        grab_ = placeOf(held_) - pointer.place;
        begin("ellipse/hold");
    } else {
        begin("ellipse/draw");
    }
}

void EllipseTool::drag(const ToolPointer& pointer) {
    if (way_ == Way::holding) {
        const bool round = (circle_ && isRound(start_)) || pointer.modifiers.testFlag(Qt::ShiftModifier);
        moved_ = true;
        const QString label = held_ == EllipseHandle::centre ? tr("Move outline")
                              : held_ == EllipseHandle::turn ? tr("Turn outline")
                                                             : tr("Resize outline");
        during(with(withHandleAt(start_, held_, pointer.place + grab_, round)), label, true);
        return;
    }
    if (way_ == Way::pressed && QLineF(from_.position, pointer.position).length() >= kClickReach)
        way_ = Way::drawing;
    if (way_ == Way::drawing)
        during(with(drawnTo(pointer)), circle_ ? tr("Draw circle") : tr("Draw ellipse"), true);
}

void EllipseTool::release(const ToolPointer& pointer) {
    const Way was = std::exchange(way_, Way::none);
    if (was == Way::holding && moved_ && shown()) {
        during(with(*shown()), tr("Change outline"), false);
    } else if (was == Way::drawing) {
        during(with(drawnTo(pointer)), circle_ ? tr("Draw circle") : tr("Draw ellipse"), false);
    } else if (was == Way::pressed) {
        if (const auto proposal = proposalAt(pointer.place))
            once(with(host().roundThings()[*proposal].ellipse), tr("Take the round thing"));
    }
}

void EllipseTool::hover(const ToolPointer& pointer) {
    const auto handle = handleAt(pointer);
    const auto proposal = handle ? std::nullopt : proposalAt(pointer.place);
    if (std::exchange(hovered_, proposal) != proposal || std::exchange(hoveredHandle_, handle) != handle)
        host().refresh();
}

void EllipseTool::cancel() {
    if (std::exchange(way_, Way::none) == Way::holding && shown())
        during(with(start_), tr("Change outline"), false);
}

bool EllipseTool::nudge(glm::dvec2 by) {
    if (!shown())
        return false;
    Ellipse moved = *shown();
    moved.centre += by;
    again("ellipse/nudge", with(moved), tr("Move outline"));
    return true;
}

void EllipseTool::remove() {
    if (!shown())
        return;
    ExtractionDraft changed = draft();
    changed.form = FormKind::none;
    changed.ellipse.reset();
    once(std::move(changed), tr("Remove outline"));
}

void EllipseTool::paint(QPainter& painter) const {
    const auto& things = host().roundThings();
    for (std::size_t i = 0; i < things.size(); ++i) {
        if (shown() && things[i].ellipse == *shown())
            continue;
        const bool under = hovered_ == i && way_ == Way::none;
        const QPolygonF outline = outlineOf(things[i].ellipse, host().view());
        painter.setBrush(under ? QColor(255, 255, 255, 60) : Qt::transparent);
        painter.setPen(QPen(QColor(255, 255, 255, under ? 235 : 185), under ? 3.4 : 2.8));
        painter.drawPolygon(outline);
        QPen dashes(under ? host().colours().color(QPalette::Highlight) : QColor(0x1d, 0x2b, 0x45, 190),
                    under ? 1.8 : 1.2);
        dashes.setDashPattern({4, 3});
        painter.setBrush(Qt::NoBrush);
        painter.setPen(dashes);
        painter.drawPolygon(outline);
    }
    if (!shown() || way_ == Way::drawing)
        return;
    const QColor accent = host().colours().color(QPalette::Highlight);
    if (!circle_ || !isRound(*shown())) {
        drawHaloLine(painter,
                     QPolygonF({toWidget(placeOf(EllipseHandle::first)), toWidget(placeOf(EllipseHandle::turn))}),
                     accent, 1.2);
        drawRoundHandle(painter, toWidget(placeOf(EllipseHandle::turn)), accent);
    }
    for (const EllipseHandle handle :
         {EllipseHandle::first, EllipseHandle::firstOpposite, EllipseHandle::second, EllipseHandle::secondOpposite})
        drawSquareHandle(painter, toWidget(placeOf(handle)), accent);
    drawRoundHandle(painter, toWidget(placeOf(EllipseHandle::centre)), accent);
}

Qt::CursorShape EllipseTool::cursor() const {
    if (hoveredHandle_)
        return *hoveredHandle_ == EllipseHandle::centre ? Qt::SizeAllCursor : Qt::PointingHandCursor;
    return hovered_ ? Qt::PointingHandCursor : Qt::CrossCursor;
}

QString EllipseTool::hint() const {
    if (hovered_)
        return tr("Click to take this round thing, or drag to draw");
    if (shown())
        return tr("Drag the handles; arrow keys move, Delete removes; drag elsewhere to draw anew");
    const bool centre = host().options().fromCentre;
    if (circle_)
        return centre ? tr("Drag from a ball's centre to its edge (Alt: from edge to edge)")
                      : tr("Drag from edge to edge across a ball (Alt: from its centre)");
    return centre ? tr("Drag from a ball's centre (Alt: from corner to corner, Shift: a circle)")
                  : tr("Drag the box around a ball (Alt: from its centre, Shift: a circle)");
}

} // namespace limner
