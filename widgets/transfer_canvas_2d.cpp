#include "widgets/transfer_canvas_2d.h"

#include "core/figure/layer_edits.h"
#include "core/figure/plane_view.h"
#include "core/figure/transfer_edits.h"
#include "core/style/transfer_function.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

const char* kindOf(PlaneTool tool) {
    switch (tool) {
    case PlaneTool::trapezoid: return "trapezoid";
    case PlaneTool::ellipse: return "ellipse";
    case PlaneTool::polygon: return "polygon";
    case PlaneTool::paint:
    case PlaneTool::erase: return "mask";
    case PlaneTool::select:
    case PlaneTool::rectangle: break;
    }
    return "rectangle";
}

} // namespace

TransferCanvas2d::TransferCanvas2d(QWidget* parent) : TransferPlane(parent) {
    setAccessibleName(tr("Transfer function over two axes"));
    setAccessibleDescription(tr("Opacity shapes and a grid of styles over two measures of the data. Control with arrow "
                                "keys goes from handle to handle, arrow keys move, Insert adds a shape, Control D "
                                "duplicates, Delete removes; plus, minus and Home zoom."));
}

void TransferCanvas2d::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) {
    const Volume* before = volume();
    const auto axesOf = [this] { return transfer() ? transfer()->axes : std::vector<std::string>(); };
    const std::vector<std::string> axes = axesOf();
    const bool otherLayer = layer != layer_;
    TransferPlane::setFigure(std::move(figure), layer);
    const bool others = otherLayer || before != volume() || axes != axesOf();
    if (others && drag_ == Drag::none)
        selected_.reset();
    if (before != volume() || axes != axesOf()) {
        setHistogram(nullptr);
        showAll();
    }
    if (selected_ && !isLegal(*selected_))
        selected_.reset();
    Q_EMIT selectionChanged(); // its place may be another one
}

void TransferCanvas2d::setHistogram(std::shared_ptr<const JointHistogram> histogram) {
    if (histogram == histogram_)
        return;
    histogram_ = std::move(histogram);
    counts_ = QImage();
    update();
}

void TransferCanvas2d::setTool(PlaneTool tool) {
    tool_ = tool;
    setCursor(tool == PlaneTool::select ? Qt::ArrowCursor : Qt::CrossCursor);
    update();
}

void TransferCanvas2d::setBrush(const Brush& brush) {
    brush_ = brush;
    update();
}

const Transfer* TransferCanvas2d::transfer() const {
    const Transfer* t = anyTransfer();
    return t && secondAxis(*t) ? t : nullptr;
}

void TransferCanvas2d::showAll() {
    if (!transfer())
        return;
    PlaneBox box = shownPlane(*figure_, *transfer());
    for (const OpacityShape& shape : transfer()->opacity2d) {
        const PlaneBox own = boxOf(shape);
        box.low = glm::min(box.low, glm::max(own.low, box.low - (box.high - box.low))); // not what is lost far outside
        box.high = glm::max(box.high, glm::min(own.high, box.high + (box.high - box.low)));
    }
    constexpr double kMargin = 0.03;
    y_ = AxisView({box.low.y, box.high.y}).widened(kMargin);
    showValues({box.low.x, box.high.x});
}

void TransferCanvas2d::zoomAt(QPointF position, double factor) {
    if (!transfer())
        return;
    const ValueRange whole = shownRange(*figure_, *transfer(), *secondAxis(*transfer()));
    y_.zoom(secondOf(position.y()), factor, whole.high - whole.low);
    TransferPlane::zoomAt(position, factor);
}

void TransferCanvas2d::beginShift(QPointF position) {
    shiftedY_ = y_;
    TransferPlane::beginShift(position);
}

void TransferCanvas2d::shiftTo(QPointF position) {
    y_ = shiftedY_;
    y_.shift((position.y() - shiftFrom().y()) / plot().height() * y_.width());
    TransferPlane::shiftTo(position);
}

glm::dvec2 TransferCanvas2d::placeAt(QPointF position) const { return {valueOf(position.x()), secondOf(position.y())}; }

QPointF TransferCanvas2d::positionAt(const glm::dvec2& place) const { return {xOf(place.x), yOf(place.y)}; }

bool TransferCanvas2d::isLegal(const Handle& handle) const { return placeOf(handle).has_value(); }

std::optional<glm::dvec2> TransferCanvas2d::placeIn(const Transfer& transfer, const Handle& handle) {
    if (handle.kind == HandleKind::node) {
        const std::size_t columns = transfer.grid ? transfer.grid->x.size() : 0;
        if (columns == 0 || handle.index / columns >= transfer.grid->y.size())
            return std::nullopt;
        return glm::dvec2(transfer.grid->x[handle.index % columns], transfer.grid->y[handle.index / columns]);
    }
    if (handle.index >= transfer.opacity2d.size())
        return std::nullopt;
    const OpacityShape& shape = transfer.opacity2d[handle.index];
    if (handle.kind == HandleKind::shape) {
        const PlaneBox box = boxOf(shape);
        return (box.low + box.high) * 0.5;
    }
    const auto handles = handlesOf(shape);
    return handle.part < handles.size() ? std::optional(handles[handle.part].at) : std::nullopt;
}

std::optional<glm::dvec2> TransferCanvas2d::placeOf(const Handle& handle) const {
    return transfer() ? placeIn(*transfer(), handle) : std::nullopt;
}

std::optional<QPointF> TransferCanvas2d::positionOf(const Handle& handle) const {
    const auto place = placeOf(handle);
    if (!place)
        return std::nullopt;
    QPointF position = positionAt(*place);
    if (handle.kind == HandleKind::node) { // balls of far columns and rows wait at the border
        position.setX(std::clamp(position.x(), plot().left(), plot().right()));
        position.setY(std::clamp(position.y(), plot().top(), plot().bottom()));
    }
    return position;
}

std::vector<TransferCanvas2d::Handle> TransferCanvas2d::allHandles() const {
    std::vector<Handle> all;
    const Transfer* t = transfer();
    if (!t)
        return all;
    for (std::size_t i = 0; i < t->opacity2d.size(); ++i) {
        all.push_back({HandleKind::shape, i, 0});
        if (selectedShape() == i)
            for (std::size_t k = 0; k < handlesOf(t->opacity2d[i]).size(); ++k)
                all.push_back({HandleKind::corner, i, k});
    }
    for (std::size_t i = 0; t->grid && i < t->grid->x.size() * t->grid->y.size(); ++i)
        all.push_back({HandleKind::node, i, 0});
    return all;
}

std::optional<TransferCanvas2d::Handle> TransferCanvas2d::handleAt(QPointF position) const {
    const Transfer* t = transfer();
    if (!t)
        return std::nullopt;
    std::optional<Handle> best;
    double nearest = 1;
    for (const Handle& handle : allHandles()) {
        if (handle.kind == HandleKind::shape)
            continue;
        const double reach = handle.kind == HandleKind::node ? kGrabBall : kGrab;
        const double distance = QLineF(*positionOf(handle), position).length() / reach;
        if (distance < nearest) {
            nearest = distance;
            best = handle;
        }
    }
    if (best || !plot().contains(position))
        return best;
    const glm::dvec2 place = placeAt(position);
    const auto holds = [&](std::size_t i) {
        const PlaneBox box = boxOf(t->opacity2d[i]);
        const bool inBox =
            place.x >= box.low.x && place.x <= box.high.x && place.y >= box.low.y && place.y <= box.high.y;
        return inBox &&
               (t->opacity2d[i].shape == "mask" ? selectedShape() == i || membershipAt(t->opacity2d[i], place) > 0
                                                : membershipAt(t->opacity2d[i], place) > 0);
    };
    if (selectedShape() && holds(*selectedShape()))
        return Handle{HandleKind::shape, *selectedShape(), 0};
    for (std::size_t i = t->opacity2d.size(); i-- > 0;)
        if (holds(i))
            return Handle{HandleKind::shape, i, 0};
    return std::nullopt;
}

void TransferCanvas2d::select(std::optional<Handle> handle) {
    selected_ = handle && isLegal(*handle) ? handle : std::nullopt;
    update();
    Q_EMIT selectionChanged();
}

std::optional<std::size_t> TransferCanvas2d::selectedShape() const {
    return selected_ && selected_->kind != HandleKind::node ? std::optional(selected_->index) : std::nullopt;
}

std::optional<std::size_t> TransferCanvas2d::selectedNode() const {
    return selected_ && selected_->kind == HandleKind::node ? std::optional(selected_->index) : std::nullopt;
}

TransferNode TransferCanvas2d::nodeOf(std::size_t cell) const { return nodeOfCell(*transfer()->grid, cell); }

glm::dvec2 TransferCanvas2d::snapped(glm::dvec2 place) const {
    if (firstAxis(*transfer()) == TransferAxis::label)
        place.x = std::round(place.x);
    if (secondAxis(*transfer()) == TransferAxis::label)
        place.y = std::round(place.y);
    return place;
}

Transfer TransferCanvas2d::moved(const Transfer& from, const Handle& handle, const glm::dvec2& to) const {
    Transfer changed = from;
    if (handle.kind == HandleKind::node) {
        const glm::dvec2 place = snapped(to);
        const std::size_t columns = from.grid->x.size();
        const std::size_t column = handle.index % columns;
        const std::size_t row = handle.index / columns;
        if (place.x != from.grid->x[column])
            changed.grid = withColumnMoved(*changed.grid, column, place.x);
        if (place.y != from.grid->y[row])
            changed.grid = withRowMoved(*changed.grid, row, place.y);
        return changed;
    }
    OpacityShape& shape = changed.opacity2d[handle.index];
    if (handle.kind == HandleKind::corner) {
        shape = withHandleMoved(shape, handle.part, to);
    } else {
        const PlaneBox box = boxOf(shape);
        shape = withShapeMoved(shape, to - (box.low + box.high) * 0.5);
    }
    return changed;
}

void TransferCanvas2d::moveSelected(const glm::dvec2& to, bool ongoing) {
    if (!transfer() || !selected_)
        return;
    const std::string name = "transfer2d/nudge" + std::to_string(static_cast<int>(selected_->kind)) + "/" +
                             std::to_string(selected_->index) + "/" + std::to_string(selected_->part);
    emitTransfer(moved(*transfer(), *selected_, to),
                 selected_->kind == HandleKind::node ? tr("Move style") : tr("Move opacity shape"), key_.again(name),
                 ongoing);
}

void TransferCanvas2d::emitShape(const OpacityShape& shape, const QString& label) {
    Transfer changed = *transfer();
    OpacityShape& own = changed.opacity2d[*selectedShape()];
    if (own == shape)
        return;
    own = shape;
    emitTransfer(changed, label, key_.again("transfer2d/" + label.toStdString()), false);
}

void TransferCanvas2d::setOpacity(double opacity) {
    if (!transfer() || !selectedShape())
        return;
    OpacityShape shape = transfer()->opacity2d[*selectedShape()];
    shape.opacity = std::clamp(opacity, 0.0, 1.0);
    emitShape(shape, tr("Change the shape's opacity"));
}

void TransferCanvas2d::setSoftness(double softness) {
    if (!transfer() || !selectedShape())
        return;
    OpacityShape shape = transfer()->opacity2d[*selectedShape()];
    shape.soft = std::clamp(softness, 0.0, 1.0);
    emitShape(shape, tr("Change the shape's softness"));
}

void TransferCanvas2d::addShape() {
    if (!transfer() || !mayChange(*figure_, layer_))
        return;
    const PlaneBox all = shown();
    const glm::dvec2 size = all.high - all.low;
    const PlaneBox middle{all.low + size * 0.35, all.high - size * 0.35};
    const PlaneBox box = paints() ? shownPlane(*figure_, *transfer()) : middle;
    const Transfer changed = withShapeAdded(*transfer(), freshShape(kindOf(tool_), box));
    emitTransfer(changed, tr("Add opacity shape"), {}, false);
    select(Handle{HandleKind::shape, changed.opacity2d.size() - 1, 0});
}

void TransferCanvas2d::duplicateSelected() {
    if (!transfer() || !selectedShape() || !mayChange(*figure_, layer_))
        return;
    Transfer changed = *transfer();
    constexpr double kAside = 0.04; // of what is shown: beside the original, to be seen and grabbed
    changed.opacity2d.push_back(
        withShapeMoved(changed.opacity2d[*selectedShape()], {kAside * x_.width(), kAside * y_.width()}));
    emitTransfer(changed, tr("Duplicate opacity shape"), {}, false);
    select(Handle{HandleKind::shape, changed.opacity2d.size() - 1, 0});
}

void TransferCanvas2d::removeSelected() {
    if (!transfer() || !selected_)
        return;
    Transfer changed = *transfer();
    if (selected_->kind == HandleKind::node) {
        if (changed.grid->x.size() > 1)
            removeColumn();
        else
            removeRow();
        return;
    }
    OpacityShape& shape = changed.opacity2d[selected_->index];
    constexpr std::size_t kTriangle = 3;
    if (selected_->kind == HandleKind::corner && shape.shape == "polygon" && shape.x.size() > kTriangle) {
        shape = withCornerRemoved(shape, selected_->part);
        emitTransfer(changed, tr("Remove polygon point"), {}, false);
        return;
    }
    changed = withShapeRemoved(changed, selected_->index);
    emitTransfer(changed, tr("Remove opacity shape"), {}, false);
}

void TransferCanvas2d::emitGrid(const TransferGrid& grid, const QString& label) {
    Transfer changed = *transfer();
    if (changed.grid == grid)
        return;
    changed.grid = grid;
    emitTransfer(changed, label, {}, false);
}

void TransferCanvas2d::addColumn() {
    if (!transfer() || !transfer()->grid)
        return;
    const TransferGrid& grid = *transfer()->grid;
    const std::size_t column = selectedNode().value_or(0) % grid.x.size();
    const bool between = selectedNode() && column + 1 < grid.x.size();
    const double at = between          ? (grid.x[column] + grid.x[column + 1]) / 2
                      : selectedNode() ? (grid.x[column] + x_.high()) / 2
                                       : x_.valueOf(0.5);
    emitGrid(withColumnAdded(grid, snapped({at, 0}).x), tr("Add a column of styles"));
}

void TransferCanvas2d::addRow() {
    if (!transfer() || !transfer()->grid)
        return;
    const TransferGrid& grid = *transfer()->grid;
    const std::size_t row = selectedNode().value_or(0) / grid.x.size();
    const bool between = selectedNode() && row + 1 < grid.y.size();
    const double at = between          ? (grid.y[row] + grid.y[row + 1]) / 2
                      : selectedNode() ? (grid.y[row] + y_.high()) / 2
                                       : y_.valueOf(0.75);
    double place = snapped({0, at}).y;
    if (secondAxis(*transfer()) == TransferAxis::label) // the next label without a row
        for (place = std::max(1.0, grid.y[row] + 1); std::find(grid.y.begin(), grid.y.end(), place) != grid.y.end();)
            ++place;
    emitGrid(withRowAdded(grid, place), tr("Add a row of styles"));
}

void TransferCanvas2d::removeColumn() {
    if (transfer() && transfer()->grid && selectedNode())
        emitGrid(withColumnRemoved(*transfer()->grid, *selectedNode() % transfer()->grid->x.size()),
                 tr("Remove a column of styles"));
}

void TransferCanvas2d::removeRow() {
    if (transfer() && transfer()->grid && selectedNode())
        emitGrid(withRowRemoved(*transfer()->grid, *selectedNode() / transfer()->grid->x.size()),
                 tr("Remove a row of styles"));
}

void TransferCanvas2d::beginDrawing(QPointF position) {
    if (!mayChange(*figure_, layer_))
        return;
    dragTransfer_ = *transfer();
    if (!paints()) {
        drag_ = Drag::draw;
        key_.begin("transfer2d/draw");
        return;
    }
    const auto shape = selectedShape();
    const bool onMask = shape && dragTransfer_.opacity2d[*shape].shape == "mask";
    if (!onMask && tool_ == PlaneTool::erase)
        return;
    if (!onMask) { // a new mask over all of the plane, begun with this stroke
        dragTransfer_ = withShapeAdded(dragTransfer_, freshShape("mask", shownPlane(*figure_, dragTransfer_)));
        selected_ = Handle{HandleKind::shape, dragTransfer_.opacity2d.size() - 1, 0};
    }
    drag_ = Drag::brush;
    key_.begin("transfer2d/brush");
    dragLast_ = position;
    brushTo(position);
}

void TransferCanvas2d::brushTo(QPointF position) {
    OpacityShape& mask = dragTransfer_.opacity2d[*selectedShape()];
    const glm::dvec2 radius(brush_.radius / plot().width() * x_.width(), brush_.radius / plot().height() * y_.width());
    const QLineF way(dragLast_, position);
    const int steps = std::max(1, static_cast<int>(std::ceil(way.length() / std::max(1.0, brush_.radius / 3))));
    for (int i = 1; i <= steps; ++i)
        mask = withMaskPainted(mask, {placeAt(way.pointAt(static_cast<double>(i) / steps)), radius,
                                      tool_ == PlaneTool::paint ? 1.0 : 0.0, brush_.softness});
    dragLast_ = position;
    dragMoved_ = true;
    const QString label = tool_ == PlaneTool::paint ? tr("Paint opacity") : tr("Erase opacity");
    const std::optional<Handle> painted = selected_;
    emitTransfer(dragTransfer_, label, key_.during("transfer2d/brush"), true);
    select(painted); // a mask that was not there before
}

void TransferCanvas2d::drawTo(QPointF position, bool ongoing) {
    const glm::dvec2 a = placeAt(dragStart_);
    const glm::dvec2 b = placeAt(position);
    const Transfer changed = withShapeAdded(dragTransfer_, freshShape(kindOf(tool_), {glm::min(a, b), glm::max(a, b)}));
    emitTransfer(changed, tr("Add opacity shape"), key_.during("transfer2d/draw"), ongoing);
    select(Handle{HandleKind::shape, changed.opacity2d.size() - 1, 0});
}

} // namespace limner
