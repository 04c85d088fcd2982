#include "app/studio/window_transfer.h"

#include "app/studio/action_table.h"
#include "app/studio/studio_document.h"
#include "core/figure/plane_view.h"
#include "renderer/pick.h"
#include "widgets/layer_list.h"
#include "widgets/newest_job.h"
#include "widgets/transfer_editor.h"
#include "widgets/viewport.h"
#include "widgets/widen_overlay.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QSettings>

#include <algorithm>

namespace limner {
namespace {

constexpr const char* kCountScale = "transfer/countScale";

/// Where a pick lies on an axis; nothing where it says nothing about it.
std::optional<double> placeOn(TransferAxis axis, const Pick& pick) {
    switch (axis) {
    case TransferAxis::value: return pick.value;
    case TransferAxis::gradient: return pick.gradient;
    default: return std::nullopt;
    }
}

} // namespace

WindowTransfer::WindowTransfer(const Workplace& place)
    : QObject(place.window), place_(place), editor_(new TransferEditor(place.transfer)),
      widen_(new WidenOverlay(place.viewport)), counting_(new NewestJob(tr("Counting voxels over two axes"), this)),
      picking_(new NewestJob(tr("Reading the value under the pointer"), this)) {
    putIntoDock();
    connectWiden();
    editor_->plane()->canvas()->setStyleSource([line = place.transfer](const std::string& key) {
        return line->canvas()->styleSource() ? line->canvas()->styleSource()(key) : nullptr;
    });
    connect(editor_, &TransferEditor::edited, place_.document, &StudioDocument::apply);
    connect(place_.document, &StudioDocument::changed, this, [this] {
        showFigure();
        const std::size_t shown = place_.layers->selectedLayer();
        const auto again = [this, shown] { // the list of layers may hear of the change after this one
            if (place_.layers->selectedLayer() != shown)
                showFigure();
        };
        QMetaObject::invokeMethod(this, again, Qt::QueuedConnection);
    });
    connect(place_.layers, &LayerList::layerSelected, this, &WindowTransfer::showFigure);
    QComboBox* counts = place_.transfer->counts();
    counts->setCurrentIndex(std::clamp(QSettings().value(kCountScale, 0).toInt(), 0, counts->count() - 1));
    connect(counts, &QComboBox::activated, this, [](int index) { QSettings().setValue(kCountScale, index); });
    place_.viewport->setMouseTracking(true);
    place_.viewport->installEventFilter(this);
    connect(place_.viewport, &Viewport::clicked, this, &WindowTransfer::pickAt);
    showFigure();
}

WindowTransfer::~WindowTransfer() = default;

bool WindowTransfer::busy() const { return counting_->busy() || picking_->busy() || widen_->busy(); }

void WindowTransfer::putIntoDock() {
    auto* dock = place_.window->findChild<QDockWidget*>("dock.transfer");
    dock->setWidget(editor_);
    // A plane needs height; the form of the layer scrolls.
    place_.window->resizeDocks({place_.window->findChild<QDockWidget*>("dock.layers"), dock}, {380, 400}, Qt::Vertical);
}

void WindowTransfer::connectWiden() {
    QAction* action = place_.actions->at("edit.widen-range");
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, action](bool on) {
        for (ToolOverlay* other : place_.viewport->findChildren<ToolOverlay*>())
            if (other != widen_)
                other->layDown(); // one tool has the mouse
        on ? widen_->take() : widen_->layDown();
        action->setChecked(widen_->taken());
    });
    connect(widen_, &ToolOverlay::takenChanged, action, &QAction::setChecked);
    connect(widen_, &ToolOverlay::edited, place_.document, &StudioDocument::apply);
    for (ToolOverlay* other : place_.viewport->findChildren<ToolOverlay*>())
        if (other != widen_)
            connect(other, &ToolOverlay::takenChanged, widen_, [this](bool taken) {
                if (taken)
                    widen_->layDown();
            });
}

void WindowTransfer::showFigure() {
    const std::shared_ptr<const Figure> figure = place_.document->figure();
    const std::size_t layer = place_.layers->selectedLayer();
    place_.actions->at("edit.widen-range")->setEnabled(figure != nullptr);
    widen_->setFigure(figure);
    widen_->setLayer(layer);
    editor_->setFigure(figure, layer);
    const bool plane = editor_->showsPlane();
    if (!figure || !plane) {
        counting_->drop();
        counted_.reset();
        histogram_.reset();
        return;
    }
    count(figure, figure->layers[layer].transfer);
}

void WindowTransfer::count(const std::shared_ptr<const Figure>& figure, const Transfer& transfer) {
    Counted wanted;
    wanted.volume = figure->volume ? figure->volume->data : nullptr;
    wanted.labels = figure->labels ? figure->labels->data : nullptr;
    wanted.second = figure->secondVolume ? figure->secondVolume->data : nullptr;
    wanted.axes = transfer.axes;
    wanted.distance = transfer.distance;
    if (counted_ == wanted) {
        editor_->plane()->canvas()->setHistogram(histogram_);
        return;
    }
    counted_ = std::move(wanted);
    histogram_.reset();
    editor_->plane()->setNote({});
    auto found = std::make_shared<std::optional<JointHistogram>>();
    counting_->want([found, figure, transfer](Task& task) { *found = planeHistogram(*figure, transfer, task); },
                    [this, found] {
                        if (*found)
                            histogram_ = std::make_shared<const JointHistogram>(std::move(**found));
                        else if (editor_->note().isEmpty())
                            editor_->plane()->setNote(
                                tr("How the voxels lie over these axes is not shown: it depends on the view "
                                   "or on other measures."));
                        editor_->plane()->canvas()->setHistogram(histogram_);
                    });
}

bool WindowTransfer::eventFilter(QObject* watched, QEvent* event) {
    if (watched == place_.viewport && event->type() == QEvent::MouseMove) {
        const auto* move = static_cast<QMouseEvent*>(event);
        if (move->buttons() == Qt::NoButton)
            pickAt(move->position());
    }
    return QObject::eventFilter(watched, event);
}

void WindowTransfer::pickAt(QPointF position) {
    const auto& picture = place_.viewport->picture();
    if (!picture)
        return;
    const glm::dvec2 pixel = place_.viewport->onFigure(position) * glm::dvec2(picture->plan->size);
    auto found = std::make_shared<std::optional<Pick>>();
    picking_->want([found, pixel, plan = picture->plan](Task&) { *found = pickMatter(*plan, pixel); },
                   [this, found] { mark(*found); }, NewestJob::Running::complete);
}

void WindowTransfer::mark(const std::optional<Pick>& pick) {
    const auto figure = place_.document->figure();
    const std::size_t layer = place_.layers->selectedLayer();
    if (!pick || !figure || layer >= figure->layers.size()) {
        editor_->setMark(std::nullopt);
        return;
    }
    const Transfer& transfer = figure->layers[layer].transfer;
    const auto second = secondAxis(transfer);
    const auto x = placeOn(firstAxis(transfer), *pick);
    if (x)
        editor_->setMark(TransferPlane::Mark{*x, second ? placeOn(*second, *pick) : std::nullopt});
    else
        editor_->setMark(std::nullopt);
}

} // namespace limner
