#include "app/studio/main_window.h"

#include "widgets/stipple_form.h"

#include <QAction>
#include <QCheckBox>
#include <QDockWidget>

/// The window's stipple panel.

namespace limner {

void MainWindow::buildStipple() {
    stipple_ = new StippleForm;
    QDockWidget* panel = dock(this, "dock.stipple", tr("Stipple"), stipple_, Qt::RightDockWidgetArea);
    tabifyDockWidget(findChild<QDockWidget*>("dock.cleanup"), panel);
    findChild<QDockWidget*>("dock.transfer")->raise();
    QAction* action = actions_->at("edit.stipple");
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, panel](bool on) {
        stipple_->inked()->click();
        if (!on)
            return;
        panel->show(); // where the dots can be changed
        panel->raise();
        stipple_->inked()->setFocus();
    });
    connect(stipple_, &StippleForm::edited, this, [this](const Edit& edit) { document_->apply(edit); });
}

void MainWindow::showStipple() {
    const std::shared_ptr<const Figure> figure = document_->figure();
    stipple_->setFigure(figure);
    QAction* action = actions_->at("edit.stipple");
    action->setEnabled(figure != nullptr);
    action->setChecked(figure && figure->stipple);
}

} // namespace limner
