#include "widgets/widen_overlay.h"

#include "core/figure/layer_edits.h"
#include "core/figure/plane_view.h"
#include "core/figure/transfer_kinds.h"
#include "widgets/newest_job.h"
#include "widgets/viewport.h"

#include <QLineF>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace limner {
namespace {

constexpr double kStepPixels = 4;  // from one reading to the next
constexpr double kReachVoxels = 6; // a structure's surface bends, and noise moves it

/// What the transfer shows once it holds a place of the data.
Transfer widened(const Figure& figure, const Transfer& transfer, const Pick& pick) {
    const auto second = secondAxis(transfer);
    if (!second)
        return withValueShown(transfer, pick.value);
    const auto onAxis = [&](TransferAxis axis) { return axis == TransferAxis::value ? pick.value : pick.gradient; };
    const PlaneBox shown = shownPlane(figure, transfer);
    return withPlaceShown(transfer, {onAxis(firstAxis(transfer)), onAxis(*second)}, shown.high - shown.low);
}

/// Whether all axes are known under a pointer.
bool isReadable(const Transfer& transfer) {
    const auto readable = [](TransferAxis axis) {
        return axis == TransferAxis::value || axis == TransferAxis::gradient;
    };
    const auto second = secondAxis(transfer);
    return second ? readable(firstAxis(transfer)) && readable(*second) : firstAxis(transfer) == TransferAxis::value;
}

} // namespace

ValueRange valuesThatShow(const Transfer& transfer, ValueRange range) {
    constexpr int kSteps = 1000;
    constexpr double kSome = 0.01;
    ValueRange shows{range.high, range.low};
    for (int i = 0; i <= kSteps; ++i) {
        const double value = range.low + (range.high - range.low) * i / kSteps;
        if (curveOpacityAt(transfer, value) > kSome) {
            shows.low = std::min(shows.low, value);
            shows.high = std::max(shows.high, value);
        }
    }
    return shows.low <= shows.high ? shows : range;
}

WidenOverlay::WidenOverlay(Viewport* viewport)
    : ToolOverlay(viewport, tr("Widen range")), job_(new NewestJob(tr("Reading the values under the pointer"), this)) {
    const auto goOn = [this] { QMetaObject::invokeMethod(this, &WidenOverlay::readMore, Qt::QueuedConnection); };
    connect(job_, &NewestJob::failed, this, goOn);
    connect(job_, &NewestJob::stopped, this, goOn);
}

WidenOverlay::~WidenOverlay() = default;

void WidenOverlay::setLayer(std::size_t layer) {
    if (layer_ == layer)
        return;
    layer_ = layer;
    reset();
}

bool WidenOverlay::busy() const { return job_->busy() || !waiting_.empty(); }

bool WidenOverlay::mayWiden() const {
    return figure() && mayChange(*figure(), layer_) && isReadable(figure()->layers[layer_].transfer);
}

QString WidenOverlay::hint() const {
    if (figure() && layer_ < figure()->layers.size() && !mayChange(*figure(), layer_))
        return tr("The layer is locked · choose another one · Esc: leave");
    if (figure() && layer_ < figure()->layers.size() && !isReadable(figure()->layers[layer_].transfer))
        return tr("This works over the axes value and gradient · choose another layer · Esc: leave");
    return missed_ ? tr("There was nothing to read there · drag over the structure · Esc: leave")
                   : tr("Drag over what the chosen layer is to show too · Esc: leave");
}

void WidenOverlay::reset() {
    job_->drop();
    if (changed_)
        finish(); // what has changed by now stays, as one step
    dragging_ = released_ = missed_ = false;
    path_.clear();
    waiting_.clear();
    plan_.reset();
    update();
}

void WidenOverlay::mousePressEvent(QMouseEvent* event) {
    const auto& shown = viewport().picture();
    if (event->button() != Qt::LeftButton || !shown || !mayWiden() || released_) {
        event->ignore(); // to the viewport
        return;
    }
    reset();
    dragging_ = true;
    plan_ = shown->plan;
    trail_ = std::make_shared<PickTrail>();
    trail_->wanted = valuesThatShow(figure()->layers[layer_].transfer, plan_->volume->range());
    trail_->reachMm = kReachVoxels * plan_->volume->grid().smallestSpacingMm();
    key_.begin("transfer/widen");
    follow(event->position());
}

void WidenOverlay::follow(QPointF position) {
    const QPointF from = path_.isEmpty() ? position : path_.last();
    const QLineF way(from, position);
    const int steps = std::max(1, static_cast<int>(way.length() / kStepPixels));
    for (int i = 1; i <= steps; ++i)
        waiting_.push_back(onFigure(way.pointAt(static_cast<double>(i) / steps)) * glm::dvec2(plan_->size));
    path_ << position;
    update();
    readMore();
}

void WidenOverlay::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging_) {
        event->ignore();
        return;
    }
    if (QLineF(path_.last(), event->position()).length() >= kStepPixels)
        follow(event->position());
}

void WidenOverlay::mouseReleaseEvent(QMouseEvent* event) {
    if (!dragging_) {
        event->ignore();
        return;
    }
    dragging_ = false;
    released_ = true;
    if (!busy())
        finish();
}

void WidenOverlay::readMore() {
    if (job_->busy() || waiting_.empty()) {
        if (!job_->busy() && released_)
            finish();
        return;
    }
    auto pixels = std::make_shared<std::vector<glm::dvec2>>(std::exchange(waiting_, {}));
    auto picks = std::make_shared<std::vector<Pick>>();
    job_->want(
        [pixels, picks, plan = plan_, trail = trail_](Task& task) {
            for (const glm::dvec2& pixel : *pixels) {
                task.throwIfCancelled();
                if (const auto pick = followMatter(*plan, pixel, *trail))
                    picks->push_back(*pick);
            }
        },
        [this, picks] {
            widen(*picks);
            // The job counts as busy until this has run.
            QMetaObject::invokeMethod(this, &WidenOverlay::readMore, Qt::QueuedConnection);
        });
}

void WidenOverlay::widen(const std::vector<Pick>& picks) {
    if (!mayWiden())
        return;
    const Transfer& before = figure()->layers[layer_].transfer;
    Transfer after = before;
    for (const Pick& pick : picks)
        after = widened(*figure(), after, pick);
    if (after == before)
        return;
    changed_ = true;
    Edit edit{*figure(), tr("Widen range").toStdString(), key_.during("transfer/widen"), true};
    edit.figure.layers[layer_].transfer = after;
    Q_EMIT edited(edit);
}

void WidenOverlay::finish() {
    released_ = false;
    missed_ = trail_ && !trail_->last;
    path_.clear();
    update();
    if (std::exchange(changed_, false) && figure()) // the same once more: the gesture is over
        Q_EMIT edited({*figure(), tr("Widen range").toStdString(), key_.during("transfer/widen"), false});
}

void WidenOverlay::paintTool(QPainter& painter) {
    if (path_.isEmpty())
        return;
    painter.setPen(QPen(QColor(255, 255, 255, 170), 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(path_);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(path_);
}

} // namespace limner
