#include "app/studio/main_window.h"

#include "app/studio/window_accuracy.h"
#include "app/studio/window_annotations.h"
#include "app/studio/window_background.h"
#include "app/studio/window_documents.h"
#include "app/studio/window_export.h"
#include "app/studio/window_history.h"
#include "app/studio/window_looks.h"
#include "app/studio/window_recovery.h"
#include "app/studio/window_slices.h"
#include "app/studio/window_stipple.h"
#include "app/studio/window_transfer.h"
#include "app/studio/window_view.h"
#include "app/studio/window_workspace.h"
#include "widgets/job.h"
#include "widgets/layer_list.h"
#include "widgets/progress_strip.h"

#include <QDockWidget>
#include <QStatusBar>

/// The window's features, one line each: their order is the order of their panels.

namespace limner {

Workplace MainWindow::workplace() {
    constexpr int kMessageMs = 6000;
    return {.window = this,
            .document = document_,
            .actions = actions_,
            .viewport = viewport_,
            .layers = layers_,
            .transfer = transfer_,
            .notices = notices_,
            .progress = progress_,
            .engine = engine_,
            .addDock =
                [this](const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
                    QDockWidget* panel = dock(this, name, title, content, area);
                    if (area == Qt::RightDockWidgetArea) {
                        auto* transfer = findChild<QDockWidget*>("dock.transfer");
                        tabifyDockWidget(transfer, panel);
                        transfer->raise();
                    }
                    return panel;
                },
            .makeJob = [this](QPointer<Job>& slot, const QString& name,
                              std::function<void(Task&)> work) { return startJob(slot, name, std::move(work)); },
            .showError = [this](const Error& error) { showError(error); },
            .openDocument = [this](const QString& name, const std::function<Document(Task&)>& load,
                                   Opened how) { afterChangesAreSafe([=, this] { startOpening(name, load, how); }); },
            .thumbnail = [this] { return thumbnail(); },
            .tell = [this](const QString& message) { statusBar()->showMessage(message, kMessageMs); }};
}

void MainWindow::arrangePanels() {
    constexpr int kGalleryWidth = 264; // a card with its two pictures side by side
    constexpr int kPanelWidth = 390;
    constexpr int kLayersHeight = 440, kTransferHeight = 400;
    const auto panel = [this](const char* name) { return findChild<QDockWidget*>(name); };
    setTabPosition(Qt::RightDockWidgetArea, QTabWidget::East); // upright there is room for all their names
    QDockWidget* layers = panel("dock.layers");
    QDockWidget* transfer = panel("dock.transfer");
    for (const char* name :
         {"dock.view", "dock.cleanup", "dock.annotations", "dock.accuracy", "dock.history"}) // about the whole figure
        if (QDockWidget* other = panel(name))
            tabifyDockWidget(layers, other);
    layers->raise();
    transfer->raise();
    resizeDocks({panel("dock.styles"), layers}, {kGalleryWidth, kPanelWidth}, Qt::Horizontal);
    resizeDocks({layers, transfer}, {kLayersHeight, kTransferHeight}, Qt::Vertical);
}

void MainWindow::buildFeatures() {
    const Workplace place = workplace();
    new WindowStipple(place); // the window owns them, by their parent
    new WindowBackground(place);
    new WindowTransfer(place);
    new WindowAnnotations(place);
    new WindowView(place);
    new WindowSlices(place);
    new WindowLooks(place, [this] { return thumbnail(); });
    new WindowHistory(place);
    new WindowAccuracy(place);
    new WindowExport(place);
    new WindowDocuments(place);
    new WindowRecovery(place);
    new WindowWorkspace(place);
    arrangePanels();
}

} // namespace limner
