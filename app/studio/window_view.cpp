#include "app/studio/window_view.h"

#include "app/studio/studio_document.h"
#include "widgets/clip_overlay.h"
#include "widgets/view_form.h"
#include "widgets/viewport.h"

#include <QDockWidget>
#include <QMainWindow>

namespace limner {

WindowView::WindowView(const Workplace& place)
    : QObject(place.window), place_(place), form_(new ViewForm), overlay_(new ClipOverlay(place.viewport)) {
    QDockWidget* panel = place_.addDock("dock.view", tr("View"), form_, Qt::RightDockWidgetArea);
    connect(panel, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        seen_ = seen; // isVisible would be true behind another tab
        showFigure();
    });
    connect(form_, &ViewForm::edited, place_.document, &StudioDocument::apply);
    connect(overlay_, &ClipOverlay::edited, place_.document, &StudioDocument::apply);
    connect(form_, &ViewForm::sideWanted, place_.viewport, &Viewport::showSide);
    connect(form_, &ViewForm::fitWanted, place_.viewport, &Viewport::fit);
    connect(place_.document, &StudioDocument::changed, this, &WindowView::showFigure);
    showFigure();
}

void WindowView::showFigure() {
    form_->setFigure(place_.document->figure());
    overlay_->setFigure(seen_ ? place_.document->figure() : nullptr);
}

} // namespace limner
