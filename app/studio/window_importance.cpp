#include "app/studio/main_window.h"

#include "core/figure/figure_json.h"
#include "widgets/importance_form.h"
#include "widgets/job.h"
#include "widgets/lens_form.h"
#include "widgets/lens_overlay.h"
#include "widgets/measure_pictures.h"
#include "widgets/parameter_row.h"
#include "widgets/picture_feed.h"
#include "widgets/viewport.h"

#include <QDockWidget>
#include <QTimer>

/// The window's importance panel: lenses over the picture, and small pictures of the measures.

namespace limner {

void MainWindow::addLens() {
    importanceDock_->show();
    importanceDock_->raise();
    importance_->lenses()->addLens();
    lens_->setFocus();
}

void MainWindow::showLens() {
    lens_->setFigure(document_->figure(), importanceSeen_ ? importance_->lenses()->selected() : std::nullopt);
}

void MainWindow::wantMeasures() {
    constexpr int kRestMs = 700; // a hand that turns the figure has stopped
    if (importanceSeen_)
        measuresRest_->start(kRestMs);
}

void MainWindow::pictureMeasures() {
    const auto shown = viewport_->picture();
    if (!importanceSeen_ || !shown || !document_->figure())
        return;
    Figure rest = *shown->plan->figure;
    rest.importance.reset(); // each picture has a weight of its own
    if (measured_ && diff(*measured_, rest) == ChangeCost::none)
        return;
    auto pictures = std::make_shared<std::vector<std::pair<std::string, QImage>>>();
    const int edge = static_cast<int>(56 * devicePixelRatioF());
    Job* job = startJob(measuresJob_, tr("Small pictures"), [pictures, edge, plan = shown->plan](Task& task) {
        *pictures = measurePictures(*plan, edge, task);
    });
    disconnect(job, &Job::failed, this, &MainWindow::showError); // the large picture says what is wrong
    connect(job, &Job::finished, this, [this, pictures, rest = std::make_shared<const Figure>(rest)] {
        measured_ = rest;
        for (auto& [pointer, picture] : *pictures) {
            picture.setDevicePixelRatio(devicePixelRatioF());
            importance_->row(pointer)->setPicture(picture);
        }
    });
    job->start();
}

} // namespace limner
