#include "core/figure/layer_edits.h"
#include "core/figure/plane_view.h"
#include "core/figure/transfer_edits.h"
#include "core/style/transfer_function.h"
#include "widgets/style_mime.h"
#include "widgets/tissue_hints.h"
#include "widgets/transfer_canvas_2d.h"

#include <QContextMenuEvent>
#include <QLineF>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <utility>

/// What mouse, keys and dragged styles do to the plane.

namespace limner {

void TransferCanvas2d::mousePressEvent(QMouseEvent* event) {
    if (!transfer() || drag_ != Drag::none || shifting())
        return;
    dragStart_ = event->position();
    dragMoved_ = false;
    if (event->button() == Qt::MiddleButton) {
        beginShift(event->position());
        return;
    }
    if (event->button() == Qt::RightButton) {
        select(handleAt(event->position()));
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    if (const TissueHint* hint = hintAt(event->position())) {
        showValues(tissueView(*hint));
        return;
    }
    if (tool_ != PlaneTool::select && plot().contains(event->position())) {
        beginDrawing(event->position());
        return;
    }
    select(handleAt(event->position()));
    if (!selected_)
        return;
    drag_ = Drag::handle;
    dragTransfer_ = *transfer();
    key_.begin("transfer2d/handle");
}

void TransferCanvas2d::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->position();
    if (paints())
        update();
    if (shifting()) {
        shiftTo(event->position());
        return;
    }
    if (drag_ == Drag::none) {
        const bool grabs = handleAt(event->position()) || hintAt(event->position());
        setCursor(tool_ != PlaneTool::select ? Qt::CrossCursor : grabs ? Qt::PointingHandCursor : Qt::ArrowCursor);
        return;
    }
    if (!transfer() || (drag_ == Drag::handle && !selected_)) { // an undo took it away under the pointer
        drag_ = Drag::none;
        return;
    }
    if (!dragMoved_ && QLineF(dragStart_, event->position()).length() < kStillAClick)
        return;
    dragMoved_ = true;
    if (drag_ == Drag::brush)
        brushTo(event->position());
    else if (drag_ == Drag::draw)
        drawTo(event->position(), true);
    else
        dragTo(event->position(), event->modifiers());
}

void TransferCanvas2d::dragTo(QPointF position, Qt::KeyboardModifiers modifiers) {
    QPointF by = position - dragStart_;
    if (modifiers & Qt::ShiftModifier) { // keeps to the main direction of the drag
        const bool sideways = std::abs(by.x()) > std::abs(by.y());
        sideways ? by.setY(0) : by.setX(0);
    }
    const auto start = placeIn(dragTransfer_, *selected_);
    if (!start)
        return;
    const glm::dvec2 off(by.x() / plot().width() * x_.width(), -by.y() / plot().height() * y_.width());
    emitTransfer(moved(dragTransfer_, *selected_, *start + off),
                 selected_->kind == HandleKind::node ? tr("Move style") : tr("Move opacity shape"),
                 key_.during("transfer2d/handle"), true);
}

void TransferCanvas2d::mouseReleaseEvent(QMouseEvent* event) {
    endShift();
    const Drag was = std::exchange(drag_, Drag::none);
    if (!transfer() || was == Drag::none)
        return;
    if (was == Drag::draw) {
        if (dragMoved_)
            drawTo(event->position(), false);
        setTool(PlaneTool::select);
        Q_EMIT toolChanged(tool_);
        return;
    }
    if (!dragMoved_)
        return;
    const bool brushed = was == Drag::brush;
    const QString label = !brushed                    ? tr("Move opacity shape")
                          : tool_ == PlaneTool::paint ? tr("Paint opacity")
                                                      : tr("Erase opacity");
    emitTransfer(*transfer(), label, key_.during(brushed ? "transfer2d/brush" : "transfer2d/handle"), false);
}

void TransferCanvas2d::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!transfer() || event->button() != Qt::LeftButton)
        return;
    drag_ = Drag::none;
    if (!plot().contains(event->position())) {
        if (!hintAt(event->position()))
            showAll();
        return;
    }
    const auto handle = handleAt(event->position());
    if (tool_ != PlaneTool::select || !handle || handle->kind != HandleKind::shape)
        return;
    const OpacityShape& shape = transfer()->opacity2d[handle->index];
    if (shape.shape != "polygon")
        return;
    // Measured as it is seen.
    const glm::dvec2 scale(x_.width() / plot().width(), y_.width() / plot().height());
    const AddedCorner added = withCornerAdded(shape, placeAt(event->position()), scale);
    Transfer changed = *transfer();
    changed.opacity2d[handle->index] = added.shape;
    emitTransfer(changed, tr("Add polygon point"), {}, false);
    select(Handle{HandleKind::corner, handle->index, added.index});
}

void TransferCanvas2d::contextMenuEvent(QContextMenuEvent* event) {
    if (!transfer())
        return;
    QMenu menu(this);
    if (selectedShape()) {
        menu.addAction(tr("Duplicate"), this, &TransferCanvas2d::duplicateSelected);
        menu.addAction(selected_->kind == HandleKind::corner ? tr("Remove point") : tr("Remove shape"), this,
                       &TransferCanvas2d::removeSelected);
    }
    menu.addAction(tr("Add a column of styles"), this, &TransferCanvas2d::addColumn);
    menu.addAction(tr("Add a row of styles"), this, &TransferCanvas2d::addRow);
    if (selectedNode()) {
        menu.addAction(tr("Remove this column"), this, &TransferCanvas2d::removeColumn);
        menu.addAction(tr("Remove this row"), this, &TransferCanvas2d::removeRow);
    }
    menu.addSeparator();
    menu.addAction(tr("Fit to the data (Home)"), this, &TransferCanvas2d::showAll);
    if (isHounsfield()) {
        QMenu* tissues = menu.addMenu(tr("Zoom to"));
        for (const TissueHint& hint : tissueHints())
            tissues->addAction(tissueWords(hint), this, [this, &hint] { showValues(tissueView(hint)); });
    }
    menu.exec(event->globalPos());
}

void TransferCanvas2d::stepSelection(int by) {
    const std::vector<Handle> all = allHandles();
    if (all.empty())
        return;
    const int count = static_cast<int>(all.size());
    int place = by > 0 ? 0 : count - 1;
    if (selected_) {
        const auto now = std::find(all.begin(), all.end(), *selected_);
        place = (static_cast<int>(now - all.begin()) + by + count) % count;
    }
    select(all[static_cast<std::size_t>(place)]);
}

void TransferCanvas2d::nudge(const QKeyEvent& event) {
    const double amount = event.modifiers() & Qt::ShiftModifier ? 10 : 1;
    const auto step = [&](TransferAxis axis, double width) { // about a pixel, on labels the next one
        constexpr double kSteps = 400;
        return axis == TransferAxis::label ? 1 : amount * width / kSteps;
    };
    const double sideways = step(firstAxis(*transfer()), x_.width());
    const double up = step(*secondAxis(*transfer()), y_.width());
    glm::dvec2 to = *placeOf(*selected_);
    to.x += event.key() == Qt::Key_Left ? -sideways : event.key() == Qt::Key_Right ? sideways : 0;
    to.y += event.key() == Qt::Key_Down ? -up : event.key() == Qt::Key_Up ? up : 0;
    moveSelected(to);
}

void TransferCanvas2d::keyPressEvent(QKeyEvent* event) {
    const bool control = event->modifiers() & Qt::ControlModifier;
    switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace: removeSelected(); return;
    case Qt::Key_Insert: addShape(); return;
    case Qt::Key_D:
        if (control) {
            duplicateSelected();
            return;
        }
        break;
    case Qt::Key_Escape:
        if (tool_ != PlaneTool::select) {
            setTool(PlaneTool::select);
            Q_EMIT toolChanged(tool_);
            return;
        }
        break;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
        if (control) {
            stepSelection(event->key() == Qt::Key_Left || event->key() == Qt::Key_Up ? -1 : 1);
            return;
        }
        if (selected_ && transfer()) {
            nudge(*event);
            return;
        }
        break;
    default:
        if (transfer() && zoomKey(*event))
            return;
        break;
    }
    QWidget::keyPressEvent(event);
}

void TransferCanvas2d::dragEnterEvent(QDragEnterEvent* event) {
    if (styles_ && transfer() && mayChange(*figure_, layer_) && event->mimeData()->hasFormat(kStyleMime))
        event->acceptProposedAction();
}

std::optional<TransferCanvas2d::Handle> TransferCanvas2d::nearestNode(QPointF position) const {
    std::optional<Handle> best;
    double nearest = 0;
    for (const Handle& handle : allHandles()) {
        if (handle.kind != HandleKind::node)
            continue;
        const double distance = QLineF(*positionOf(handle), position).length();
        if (!best || distance < nearest) {
            best = handle;
            nearest = distance;
        }
    }
    return best;
}

void TransferCanvas2d::dragMoveEvent(QDragMoveEvent* event) {
    dropNode_ = nearestNode(event->position());
    update();
    event->acceptProposedAction();
}

void TransferCanvas2d::dropEvent(QDropEvent* event) {
    dropNode_.reset();
    const auto node = nearestNode(event->position());
    update();
    const std::shared_ptr<const Style> style = droppedStyle(*event);
    if (!style)
        return;
    event->acceptProposedAction();
    const auto cell = node ? std::optional(node->index) : std::nullopt;
    Q_EMIT edited({withStyle(*figure_, layer_, cell, *style), tr("Replace style").toStdString(), {}, false});
    select(node);
}

QString TransferCanvas2d::handleTip(QPointF position) const {
    const auto handle = handleAt(position);
    return handle ? describe(*handle) : QString();
}

QString TransferCanvas2d::advice() const {
    return tr(
        "Draw shapes with the tools, drag them and their handles. A double click on a polygon adds a point. Balls "
        "are the styles: one moves its column and its row. The wheel zooms, the middle button moves the plane.");
}

bool TransferCanvas2d::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
        tool_ != PlaneTool::select) {
        event->accept(); // not the window's
        return true;
    }
    if (event->type() == QEvent::PaletteChange)
        counts_ = QImage(); // they are drawn in the text's colour
    if (event->type() == QEvent::DragLeave || event->type() == QEvent::Leave) {
        dropNode_.reset();
        pointer_ = QPointF(-1, -1); // no brush is in the hand
        update();
    }
    return TransferPlane::event(event);
}

QString TransferCanvas2d::describe(const Handle& handle) const {
    const glm::dvec2 place = *placeOf(handle);
    const auto with = [](const QString& number, const QString& unit) {
        return unit.isEmpty() ? number : number + " " + unit;
    };
    const QString x = with(valueText(place.x, x_.width() / std::max(1.0, plot().width())), unit());
    const QString y = with(valueText(place.y, y_.width() / std::max(1.0, plot().height())), secondUnit());
    if (handle.kind == HandleKind::node) {
        const TransferNode node = nodeOf(handle.index);
        const StyleEntry* entry = figure_->findStyle(node.style);
        const QString name = node.rgb ? tr("Plain colour") : QString::fromStdString(entry ? entry->name : node.style);
        return tr("%1 at %2, %3").arg(name, x, y);
    }
    if (handle.kind == HandleKind::corner)
        return tr("Handle at %1, %2").arg(x, y);
    const OpacityShape& shape = transfer()->opacity2d[handle.index];
    return tr("Shape of %1 % opacity, softness %2 %")
        .arg(shape.opacity * 100, 0, 'f', 0)
        .arg(shape.soft * 100, 0, 'f', 0);
}

} // namespace limner
