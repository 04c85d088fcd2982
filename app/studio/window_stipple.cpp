#include "app/studio/window_stipple.h"

#include "app/studio/action_table.h"
#include "app/studio/studio_document.h"
#include "widgets/stipple_form.h"

#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QMainWindow>

namespace limner {

WindowStipple::WindowStipple(const Workplace& place) : QObject(place.window), place_(place), form_(new StippleForm) {
    panel_ = place_.addDock("dock.stipple", tr("Stipple"), form_, Qt::RightDockWidgetArea);
    QAction* action = place_.actions->at("edit.stipple");
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this](bool on) {
        form_->inked()->click();
        if (!on)
            return;
        panel_->show(); // where the dots can be changed
        panel_->raise();
        form_->inked()->setFocus();
    });
    connect(form_, &StippleForm::edited, place_.document, &StudioDocument::apply);
    connect(place_.document, &StudioDocument::changed, this, &WindowStipple::showFigure);
    showFigure();
}

void WindowStipple::showFigure() {
    const std::shared_ptr<const Figure> figure = place_.document->figure();
    form_->setFigure(figure);
    QAction* action = place_.actions->at("edit.stipple");
    action->setEnabled(figure != nullptr);
    action->setChecked(figure && figure->stipple);
}

} // namespace limner
