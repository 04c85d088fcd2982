#include "widgets/transfer_canvas.h"

#include "core/figure/layer_edits.h"
#include "core/figure/plane_view.h"
#include "core/figure/transfer_edits.h"
#include "core/style/transfer_function.h"
#include "widgets/style_mime.h"
#include "widgets/tissue_hints.h"

#include <QContextMenuEvent>
#include <QLineF>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr double kGrabLine = 5; // how far from the curve a press still takes it

} // namespace

TransferCanvas::TransferCanvas(QWidget* parent) : TransferPlane(parent) {
    setAccessibleName(tr("Transfer function"));
    setAccessibleDescription(
        tr("Opacity and style over the data value. Control with arrow keys goes from handle to "
           "handle, arrow keys move the handle, Insert adds a point, Delete removes; plus, minus and "
           "Home zoom."));
}

void TransferCanvas::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) {
    const auto volumeOf = [](const std::shared_ptr<const Figure>& f) {
        return f && f->volume ? f->volume->data.get() : nullptr;
    };
    const bool otherVolume = volumeOf(figure_) != volumeOf(figure);
    if (layer != layer_ || otherVolume)
        selected_.reset();
    const auto axisOf = [this] { return anyTransfer() ? firstAxis(*anyTransfer()) : TransferAxis::value; };
    const TransferAxis before = axisOf();
    TransferPlane::setFigure(std::move(figure), layer);
    keepSelectionLegal();
    if (otherVolume || axisOf() != before)
        showAll();
    Q_EMIT selectionChanged(); // its place may be another one
}

void TransferCanvas::setHistogram(std::shared_ptr<const Histogram> histogram) {
    histogram_ = std::move(histogram);
    showAll();
}

void TransferCanvas::keepSelectionLegal() {
    const Transfer* t = transfer();
    const auto count = [&](HandleKind kind) {
        return !t ? 0 : kind == HandleKind::point ? t->opacity.size() : t->nodes.size();
    };
    if (selected_ && selected_->index >= count(selected_->kind))
        selected_.reset();
}

void TransferCanvas::setCountScale(CountScale scale) {
    countScale_ = scale;
    update();
}

const Transfer* TransferCanvas::transfer() const {
    const Transfer* t = anyTransfer();
    return t && t->kind == TransferKind::oneDimensional ? t : nullptr;
}

void TransferCanvas::showAll() {
    if (!volume() || !anyTransfer())
        return;
    const bool values = firstAxis(*anyTransfer()) == TransferAxis::value;
    const ValueRange range = shownRange(*figure_, *anyTransfer(), firstAxis(*anyTransfer()));
    ValueRange shown = range;
    if (values && histogram_ && !histogram_->counts.empty()) {
        // Padding and a few metal voxels must not squeeze the tissue into a corner.
        shown.low = std::max(shown.low, histogram_->percentile(0.0005));
        shown.high = std::min(shown.high, histogram_->percentile(0.9999));
    }
    if (const Transfer* t = transfer(); t && !t->opacity.empty()) {
        shown.low = std::min(shown.low, std::max(range.low, t->opacity.front().x));
        shown.high = std::max(shown.high, std::min(range.high, t->opacity.back().x));
    }
    showValues(shown);
}

void TransferCanvas::select(std::optional<Handle> handle) {
    selected_ = handle;
    keepSelectionLegal();
    update();
    Q_EMIT selectionChanged();
}

std::optional<TransferCanvas::Handle> TransferCanvas::handleAt(QPointF position) const {
    const Transfer* t = transfer();
    if (!t)
        return std::nullopt;
    std::optional<Handle> best;
    double nearest = 1;
    const auto consider = [&](const Handle& handle, double reach) {
        const auto at = positionOf(handle);
        const double distance = at ? QLineF(*at, position).length() / reach : 2;
        if (distance < nearest) {
            nearest = distance;
            best = handle;
        }
    };
    for (std::size_t i = 0; i < t->opacity.size(); ++i)
        consider({HandleKind::point, i}, kGrab);
    for (std::size_t i = 0; i < t->nodes.size(); ++i)
        consider({HandleKind::node, i}, kGrabBall);
    return best;
}

std::optional<std::size_t> TransferCanvas::segmentAt(QPointF position) const {
    const Transfer* t = transfer();
    if (!t || !plot().contains(position))
        return std::nullopt;
    for (std::size_t i = 0; i + 1 < t->opacity.size(); ++i) {
        const QPointF a(xOf(t->opacity[i].x), yOf(t->opacity[i].y));
        const QPointF b(xOf(t->opacity[i + 1].x), yOf(t->opacity[i + 1].y));
        const double length = QLineF(a, b).length();
        if (length < 1)
            continue;
        if (t->curve != OpacityCurve::linear) {
            const double at = yOf(curveOpacityAt(*t, valueOf(position.x())));
            if (position.x() > a.x() && position.x() < b.x() && std::abs(position.y() - at) < kGrabLine)
                return i;
            continue;
        }
        const QPointF d = (b - a) / length;
        const QPointF p = position - a;
        const double along = QPointF::dotProduct(p, d);
        const double beside = std::abs(p.x() * d.y() - p.y() * d.x());
        if (along >= 0 && along <= length && beside < kGrabLine)
            return i;
    }
    return std::nullopt;
}

void TransferCanvas::mousePressEvent(QMouseEvent* event) {
    if (!transfer() || drag_ != Drag::none || shifting())
        return;
    dragStart_ = event->position();
    dragTransfer_ = *transfer();
    dragMoved_ = false;
    if (event->button() == Qt::MiddleButton) {
        beginShift(event->position());
        return;
    }
    if (const TissueHint* hint = hintAt(event->position()); hint && event->button() == Qt::LeftButton) {
        showValues(tissueView(*hint));
        return;
    }
    const auto handle = handleAt(event->position());
    if (event->button() == Qt::RightButton) {
        select(handle);
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    select(handle);
    if (handle) {
        drag_ = Drag::handle;
        key_.begin("transfer/handle");
    } else if (const auto segment = segmentAt(event->position())) {
        drag_ = Drag::segment;
        dragSegment_ = *segment;
        key_.begin("transfer/segment");
    }
}

void TransferCanvas::dragTo(QPointF position, Qt::KeyboardModifiers modifiers) {
    const double by = valueOf(position.x()) - valueOf(dragStart_.x());
    const double rise = opacityOf(position.y()) - opacityOf(dragStart_.y());
    const bool sideways = std::abs(position.x() - dragStart_.x()) > std::abs(position.y() - dragStart_.y());
    const bool straight = modifiers & Qt::ShiftModifier; // keeps to the main direction of the drag
    Transfer changed = dragTransfer_;
    QString label = tr("Move opacity point");
    if (drag_ == Drag::segment) { // the whole line between two points goes up and down, or sideways
        const auto move = [&](std::size_t i) {
            const glm::dvec2 p = dragTransfer_.opacity[i];
            changed.opacity = withPointMoved(
                changed.opacity, i, {p.x + (straight && !sideways ? 0 : by), p.y + (straight && sideways ? 0 : rise)});
        };
        const std::size_t first = by > 0 ? dragSegment_ + 1 : dragSegment_; // the leading end makes room
        move(first);
        move(2 * dragSegment_ + 1 - first);
        label = tr("Move opacity line");
    } else if (selected_->kind == HandleKind::point) {
        const glm::dvec2 p = dragTransfer_.opacity[selected_->index];
        changed.opacity =
            withPointMoved(changed.opacity, selected_->index,
                           {p.x + (straight && !sideways ? 0 : by), p.y + (straight && sideways ? 0 : rise)});
    } else {
        changed.nodes = withNodeMoved(changed.nodes, selected_->index, dragTransfer_.nodes[selected_->index].at + by);
        label = tr("Move style");
    }
    const std::string key = key_.during(drag_ == Drag::segment ? "transfer/segment" : "transfer/handle");
    emitTransfer(changed, label, key, true);
}

void TransferCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (shifting()) {
        shiftTo(event->position());
        return;
    }
    switch (drag_) {
    case Drag::none: {
        const bool grabs = handleAt(event->position()) || segmentAt(event->position()) || hintAt(event->position());
        setCursor(grabs ? Qt::PointingHandCursor : Qt::ArrowCursor);
        return;
    }
    case Drag::handle:
    case Drag::segment:
        if (!transfer() || (drag_ == Drag::handle && !selected_)) { // an undo took it away under the pointer
            drag_ = Drag::none;
            return;
        }
        if (!dragMoved_ && QLineF(dragStart_, event->position()).length() < kStillAClick)
            return;
        dragMoved_ = true;
        dragTo(event->position(), event->modifiers());
    }
}

void TransferCanvas::mouseReleaseEvent(QMouseEvent*) {
    endShift();
    const Drag was = std::exchange(drag_, Drag::none);
    if (dragMoved_ && transfer() && (was == Drag::handle || was == Drag::segment))
        emitTransfer(*transfer(), tr("Move opacity point"),
                     key_.again(was == Drag::segment ? "transfer/segment" : "transfer/handle"), false);
}

void TransferCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    const Transfer* t = transfer();
    if (!t || event->button() != Qt::LeftButton)
        return;
    drag_ = Drag::none;
    if (!plot().contains(event->position())) {
        if (event->position().y() > railY() && !hintAt(event->position()))
            showAll();
        return;
    }
    if (handleAt(event->position()))
        return;
    Transfer changed = *t;
    const auto added = withPointAdded(t->opacity, {valueOf(event->position().x()), opacityOf(event->position().y())});
    changed.opacity = added.points;
    emitTransfer(changed, tr("Add opacity point"), {}, false);
    select(Handle{HandleKind::point, added.index});
}

void TransferCanvas::contextMenuEvent(QContextMenuEvent* event) {
    if (!transfer())
        return;
    QMenu menu(this);
    if (selected_ && selected_->kind == HandleKind::point)
        menu.addAction(tr("Make a step here"), this, &TransferCanvas::makeStepAtSelected);
    if (selected_)
        menu.addAction(tr("Remove"), this, &TransferCanvas::removeSelected);
    menu.addAction(tr("Fit to the data (Home)"), this, &TransferCanvas::showAll);
    menu.addAction(tr("Show all values"), this, &TransferCanvas::showWhole);
    if (isHounsfield()) {
        QMenu* tissues = menu.addMenu(tr("Zoom to"));
        for (const TissueHint& hint : tissueHints())
            tissues->addAction(tissueWords(hint), this, [this, &hint] { showValues(tissueView(hint)); });
    }
    menu.exec(event->globalPos());
}

void TransferCanvas::moveSelected(double value, std::optional<double> opacity, bool ongoing) {
    const Transfer* t = transfer();
    if (!t || !selected_)
        return;
    Transfer changed = *t;
    const std::string key = key_.again("transfer/nudge" + std::to_string(static_cast<int>(selected_->kind)) + "/" +
                                       std::to_string(selected_->index));
    if (selected_->kind == HandleKind::point) {
        const glm::dvec2 now = t->opacity[selected_->index];
        changed.opacity = withPointMoved(changed.opacity, selected_->index, {value, opacity.value_or(now.y)});
        emitTransfer(changed, tr("Move opacity point"), key, ongoing);
    } else {
        changed.nodes = withNodeMoved(changed.nodes, selected_->index, value);
        emitTransfer(changed, tr("Move style"), key, ongoing);
    }
}

void TransferCanvas::addPointAfterSelected() {
    const Transfer* t = transfer();
    if (!t)
        return;
    glm::dvec2 point(x_.valueOf(0.5), 0.5);
    if (selected_ && selected_->kind == HandleKind::point) {
        const glm::dvec2 here = t->opacity[selected_->index];
        const bool last = selected_->index + 1 == t->opacity.size();
        const glm::dvec2 next = last ? glm::dvec2((here.x + x_.high()) / 2, here.y) : t->opacity[selected_->index + 1];
        point = (here + next) * 0.5;
    } else if (!t->opacity.empty()) {
        point.y = curveOpacityAt(*t, point.x);
    }
    Transfer changed = *t;
    const auto added = withPointAdded(t->opacity, point);
    changed.opacity = added.points;
    emitTransfer(changed, tr("Add opacity point"), {}, false);
    select(Handle{HandleKind::point, added.index});
}

void TransferCanvas::makeStepAtSelected() {
    const Transfer* t = transfer();
    if (!t || !selected_ || selected_->kind != HandleKind::point)
        return;
    Transfer changed = *t;
    changed.opacity = withStepAt(t->opacity, selected_->index);
    emitTransfer(changed, tr("Make opacity step"), {}, false);
}

void TransferCanvas::setCurve(OpacityCurve curve) {
    const Transfer* t = transfer();
    if (!t || t->curve == curve)
        return;
    Transfer changed = *t;
    changed.curve = curve;
    emitTransfer(changed, tr("Change the curve's course"), {}, false);
}

void TransferCanvas::removeSelected() {
    const Transfer* t = transfer();
    if (!t || !selected_)
        return;
    Transfer changed = *t;
    if (selected_->kind == HandleKind::point) {
        changed.opacity = withPointRemoved(t->opacity, selected_->index);
        emitTransfer(changed, tr("Remove opacity point"), {}, false);
    } else if (t->nodes.size() > 1) { // a layer without a style has no colour
        changed.nodes.erase(changed.nodes.begin() + static_cast<std::ptrdiff_t>(selected_->index));
        emitTransfer(changed, tr("Remove style"), {}, false);
    }
}

void TransferCanvas::stepSelection(int by) {
    const Transfer* t = transfer();
    if (!t)
        return;
    const int points = static_cast<int>(t->opacity.size());
    const int all = points + static_cast<int>(t->nodes.size());
    if (all == 0)
        return;
    int place = by > 0 ? 0 : all - 1;
    if (selected_) {
        const int now = static_cast<int>(selected_->index) + (selected_->kind == HandleKind::node ? points : 0);
        place = (now + by + all) % all;
    }
    select(place < points ? Handle{HandleKind::point, static_cast<std::size_t>(place)}
                          : Handle{HandleKind::node, static_cast<std::size_t>(place - points)});
}

void TransferCanvas::nudge(QKeyEvent* event) {
    const Transfer* t = transfer();
    const double amount = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    const double step = amount * x_.width() / 400; // about a pixel
    const double rise = amount * 0.01;
    const double sideways = event->key() == Qt::Key_Left ? -step : event->key() == Qt::Key_Right ? step : 0;
    const double up = event->key() == Qt::Key_Down ? -rise : event->key() == Qt::Key_Up ? rise : 0;
    if (selected_->kind == HandleKind::point) {
        const glm::dvec2 p = t->opacity[selected_->index];
        moveSelected(p.x + sideways, p.y + up);
    } else {
        moveSelected(t->nodes[selected_->index].at + sideways, std::nullopt);
    }
}

void TransferCanvas::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace: removeSelected(); return;
    case Qt::Key_Insert: addPointAfterSelected(); return;
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (event->modifiers() & Qt::ControlModifier) {
            stepSelection(event->key() == Qt::Key_Left ? -1 : 1);
            return;
        }
        [[fallthrough]];
    case Qt::Key_Up:
    case Qt::Key_Down:
        if (selected_ && transfer()) {
            nudge(event);
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

void TransferCanvas::dragEnterEvent(QDragEnterEvent* event) {
    if (styles_ && transfer() && mayChange(*figure_, layer_) && event->mimeData()->hasFormat(kStyleMime))
        event->acceptProposedAction();
}

void TransferCanvas::dragMoveEvent(QDragMoveEvent* event) {
    const auto handle = handleAt(event->position());
    const bool onBall = handle && handle->kind == HandleKind::node;
    dropValue_ = onBall ? transfer()->nodes[handle->index].at : valueOf(event->position().x());
    update();
    event->acceptProposedAction();
}

void TransferCanvas::dropEvent(QDropEvent* event) {
    dropValue_.reset();
    update();
    const std::shared_ptr<const Style> style = droppedStyle(*event);
    if (!style)
        return;
    const auto handle = handleAt(event->position());
    Edit edit{*figure_, {}, {}, false};
    Handle chosen{HandleKind::node, 0};
    if (handle && handle->kind == HandleKind::node) {
        chosen = *handle;
        edit.figure = withStyle(*figure_, layer_, handle->index, *style);
        edit.label = tr("Replace style").toStdString();
    } else {
        const double at = valueOf(event->position().x());
        chosen.index = nodePlace(transfer()->nodes, at);
        edit.figure = withStyleNode(*figure_, layer_, at, *style);
        edit.label = tr("Add style").toStdString();
    }
    event->acceptProposedAction();
    Q_EMIT edited(edit);
    select(chosen);
}

QString TransferCanvas::handleTip(QPointF position) const {
    const auto handle = handleAt(position);
    return handle ? describe(*handle) : QString();
}

QString TransferCanvas::advice() const {
    return tr("Drag points and styles. Double click adds a point, Delete or the right button removes. The wheel zooms, "
              "the middle button moves the ruler; a double click on the ruler fits it to the data.");
}

bool TransferCanvas::event(QEvent* event) {
    if (event->type() == QEvent::DragLeave || event->type() == QEvent::Leave) {
        dropValue_.reset();
        update();
    }
    return TransferPlane::event(event);
}

QString TransferCanvas::describe(const Handle& handle) const {
    const double resolution = x_.width() / std::max(1.0, plot().width());
    const QString end = unit().isEmpty() ? QString() : " " + unit();
    const Transfer& t = *transfer();
    if (handle.kind == HandleKind::point)
        return tr("%1%2, opacity %3 %")
            .arg(valueText(t.opacity[handle.index].x, resolution), end)
            .arg(t.opacity[handle.index].y * 100, 0, 'f', 0);
    const TransferNode& node = t.nodes[handle.index];
    const StyleEntry* entry = figure_->findStyle(node.style);
    const QString name = node.rgb ? tr("Plain colour") : QString::fromStdString(entry ? entry->name : node.style);
    return tr("%1 at %2%3").arg(name, valueText(node.at, resolution), end);
}

} // namespace limner
