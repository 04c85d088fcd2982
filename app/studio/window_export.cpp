#include "app/studio/window_export.h"

#include "app/studio/action_table.h"
#include "app/studio/export_queue.h"
#include "widgets/job.h"
#include "widgets/notice_bar.h"
#include "widgets/output_list.h"
#include "widgets/progress_strip.h"
#include "widgets/viewport.h"

#include <QAction>
#include <QCloseEvent>
#include <QDesktopServices>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QUrl>

#include <algorithm>

namespace limner {

WindowExport::WindowExport(const Workplace& place)
    : QObject(place.window), place_(place), queue_(new ExportQueue(place.engine, this)), list_(new OutputList),
      panel_(place_.addDock("dock.output", tr("Output"), list_, Qt::RightDockWidgetArea)) {
    askAboutLeaving = [this] {
        return QMessageBox::question(place_.window, tr("Pictures are being written"),
                                     tr("Leave now and stop them? What is drawn is kept: the same export goes on there "
                                        "later.")) == QMessageBox::Yes;
    };
    connect(place_.actions->at("file.export"), &QAction::triggered, this, &WindowExport::chooseAndExport);
    connect(queue_, &ExportQueue::changed, this, &WindowExport::showRows);
    connect(queue_, &ExportQueue::started, place_.progress, &ProgressStrip::follow);
    connect(queue_, &ExportQueue::written, this, [this](const QString& path) {
        place_.tell(tr("Exported %1").arg(path));
        Q_EMIT pictureExported(path);
    });
    connect(queue_, &ExportQueue::failed, this, [this](int id, const Error& error) {
        place_.notices->offer(QString::fromUtf8(error.what()), tr("Go on"), [this, id] { queue_->retry(id); });
    });
    connect(list_, &OutputList::cancelWanted, queue_, &ExportQueue::cancel);
    connect(list_, &OutputList::retryWanted, queue_, &ExportQueue::retry);
    connect(list_, &OutputList::removeWanted, queue_, &ExportQueue::remove);
    const auto open = [](const std::filesystem::path& path) {
        QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(path.string())));
    };
    connect(list_, &OutputList::showWanted, this, [this, open](int id) { open(queue_->pathOf(id)); });
    connect(list_, &OutputList::folderWanted, this, [this, open](int id) { open(queue_->pathOf(id).parent_path()); });
    place_.window->installEventFilter(this);
    showRows();
}

bool WindowExport::busy() const { return queue_->busy(); }

void WindowExport::showRows() { list_->setRows(queue_->rows()); }

double WindowExport::secondsPerMegaPixel() const {
    const auto& picture = place_.viewport->picture();
    if (!picture)
        return 0;
    const double rays = picture->image.width() * 1e-6 * picture->image.height();
    const int perPixel = std::max(1, picture->facts.coarseness.subPixels * picture->facts.coarseness.subPixels);
    // A draft's longer steps are as many fewer.
    return picture->facts.renderMs * 1e-3 * picture->facts.coarseness.stepScale / std::max(rays * perPixel, 1e-9);
}

void WindowExport::chooseAndExport() {
    if (place_.document->empty())
        return;
    ExportDialog dialog(*place_.document->figure(), secondsPerMegaPixel(), place_.window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const ExportDialog::Choice choice = dialog.choice();
    const QString suggested = QFileInfo(place_.document->name()).completeBaseName() + "." + choice.ending;
    QString path = QFileDialog::getSaveFileName(place_.window, tr("Export picture"), suggested,
                                                tr("%1 picture (*.%2)").arg(choice.ending.toUpper(), choice.ending));
    if (path.isEmpty())
        return;
    if (QFileInfo(path).suffix().isEmpty())
        path += "." + choice.ending;
    exportPath(path.toStdString(), choice);
    panel_->show();
    panel_->raise();
}

void WindowExport::exportPath(const std::filesystem::path& path, const ExportDialog::Choice& choice) {
    if (place_.document->empty())
        return;
    Edit edit{*place_.document->figure(), tr("Change output size").toStdString(), {}, false};
    edit.figure.output = choice.output;
    place_.document->apply(edit);
    auto figure = std::make_shared<Figure>(*place_.document->figure());
    figure->quality.samplesPerPixel = choice.samplesPerPixel;
    PictureOptions options = pictureOptions(*figure);
    options.depth = choice.depth;
    leaving_ = false;
    queue_->add({std::move(figure), path, options});
}

bool WindowExport::eventFilter(QObject* watched, QEvent* event) {
    if (watched == place_.window && event->type() == QEvent::Close && queue_->busy() && !leaving_) {
        leaving_ = askAboutLeaving();
        if (!leaving_) {
            event->ignore();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace limner
