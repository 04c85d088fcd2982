#include "app/studio/window_slices.h"

#include "app/studio/action_table.h"
#include "app/studio/studio_document.h"
#include "widgets/measure_overlay.h"
#include "widgets/point_mark.h"
#include "widgets/slices_panel.h"
#include "widgets/viewport.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

namespace limner {
namespace {

/// Values from black to white: without the outermost thousandths, which a few bright voxels would take.
ValueRange greyWindow(const StudioDocument& document) {
    constexpr double kCutOff = 0.002;
    if (const auto& histogram = document.histogram(); histogram && !histogram->counts.empty())
        return {histogram->percentile(kCutOff), histogram->percentile(1 - kCutOff)};
    const auto figure = document.figure();
    return figure && figure->volume && figure->volume->data ? figure->volume->data->range() : ValueRange{0, 1};
}

} // namespace

WindowSlices::WindowSlices(const Workplace& place)
    : QObject(place.window), place_(place), panel_(new SlicesPanel), mark_(new PointMark(place.viewport)),
      measure_(new MeasureOverlay(place.viewport)) {
    QDockWidget* dock = place_.addDock("dock.slices", tr("Slices"), panel_, Qt::LeftDockWidgetArea);
    if (auto* styles = place_.window->findChild<QDockWidget*>("dock.styles")) {
        place_.window->tabifyDockWidget(styles, dock);
        styles->raise();
    }
    connect(dock, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        seen_ = seen; // isVisible would be true behind another tab
        showFigure();
    });
    connect(panel_, &SlicesPanel::edited, place_.document, &StudioDocument::apply);
    connect(panel_, &SlicesPanel::pointMoved, this, &WindowSlices::showMark);
    connect(place_.viewport, &Viewport::clicked, this, &WindowSlices::pickAt);
    QAction* action = place_.actions->at("view.measure");
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, action](bool on) {
        on ? measure_->take() : measure_->layDown();
        action->setChecked(measure_->taken());
    });
    connect(measure_, &ToolOverlay::takenChanged, action, &QAction::setChecked);
    connect(place_.document, &StudioDocument::changed, this, &WindowSlices::showFigure);
    showFigure();
}

void WindowSlices::showFigure() {
    const std::shared_ptr<const Figure> figure = place_.document->figure();
    place_.actions->at("view.measure")->setEnabled(figure && figure->volume && figure->volume->data);
    measure_->setFigure(figure);
    if (seen_)
        panel_->setFigure(figure, greyWindow(*place_.document));
    showMark();
}

void WindowSlices::showMark() {
    const bool shown = seen_ && panel_->isEnabled();
    mark_->setPoint(shown ? place_.document->figure() : nullptr, panel_->point());
}

void WindowSlices::pickAt(QPointF position) {
    if (!seen_)
        return;
    if (const auto pick = place_.viewport->pickAt(position)) {
        panel_->setPoint(pick->pointMm);
        showMark();
    }
}

} // namespace limner
