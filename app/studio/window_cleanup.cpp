#include "app/studio/main_window.h"

#include "widgets/cleanup_form.h"
#include "widgets/island_overlay.h"
#include "widgets/scissors_overlay.h"
#include "widgets/viewport.h"

#include <QAction>
#include <QDockWidget>

/// The window's clean-up panel, and the tools over the picture that give it steps.

namespace limner {

void MainWindow::buildCleanup() {
    cleanup_ = new CleanupForm;
    scissors_ = new ScissorsOverlay(viewport_);
    island_ = new IslandOverlay(viewport_);
    QDockWidget* panel = dock(this, "dock.cleanup", tr("Clean-up"), cleanup_, Qt::RightDockWidgetArea);
    tabifyDockWidget(importanceDock_, panel);
    findChild<QDockWidget*>("dock.transfer")->raise();
}

void MainWindow::connectCleanup() {
    struct Tool {
        QAction* action;
        ToolOverlay* overlay;
    };
    for (const Tool& tool :
         {Tool{actions_->at("edit.scissors"), scissors_}, Tool{actions_->at("edit.keep-island"), island_}}) {
        tool.action->setCheckable(true);
        connect(tool.action, &QAction::triggered, this, [tool](bool on) {
            on ? tool.overlay->take() : tool.overlay->layDown();
            tool.action->setChecked(tool.overlay->taken());
        });
        connect(tool.overlay, &ToolOverlay::takenChanged, tool.action, &QAction::setChecked);
        connect(tool.overlay, &ToolOverlay::edited, this, [this](const Edit& edit) {
            document_->apply(edit);
            QDockWidget* panel = findChild<QDockWidget*>("dock.cleanup");
            panel->show(); // where the step can be seen, changed and deleted
            panel->raise();
        });
    }
    connect(cleanup_, &CleanupForm::edited, this, [this](const Edit& edit) { document_->apply(edit); });
    connect(cleanup_, &CleanupForm::scissorsWanted, actions_->at("edit.scissors"), &QAction::trigger);
    connect(cleanup_, &CleanupForm::islandWanted, actions_->at("edit.keep-island"), &QAction::trigger);
}

void MainWindow::showCleanup() {
    cleanup_->setFigure(document_->figure(), document_->histogram());
    scissors_->setFigure(document_->figure());
    island_->setFigure(document_->figure());
}

} // namespace limner
