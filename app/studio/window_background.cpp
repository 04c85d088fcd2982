// What the window does with the figure's background.
#include "app/studio/main_window.h"

#include "core/style/background_picture.h"
#include "widgets/colour_button.h"
#include "widgets/job.h"

#include <QColorDialog>
#include <QFileDialog>

namespace limner {

void MainWindow::choosePaper() {
    if (document_->empty())
        return;
    const QColor colour =
        QColorDialog::getColor(colourOf(glm::dvec3(document_->figure()->background.rgba)), this, tr("Paper colour"));
    if (colour.isValid())
        usePaper(colour);
}

void MainWindow::usePaper(const QColor& colour) {
    if (document_->empty())
        return;
    Edit edit{*document_->figure(), tr("Paper colour").toStdString(), {}, false};
    edit.figure.background = {};
    edit.figure.background.rgba = glm::dvec4(rgbOf(colour), 1);
    document_->apply(edit);
}

void MainWindow::chooseBackgroundPicture() {
    if (document_->empty())
        return;
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Picture behind the figure"), {},
                                     tr("Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr);;Everything (*)"));
    if (!path.isEmpty())
        useBackgroundPicture(path.toStdString());
}

void MainWindow::useBackgroundPicture(const std::filesystem::path& path) {
    if (document_->empty())
        return;
    const unsigned generation = document_->generation();
    auto picture = std::make_shared<std::shared_ptr<const BackgroundPicture>>();
    Job* job = startJob(backgroundJob_, tr("Opening %1").arg(QString::fromStdString(path.filename().string())),
                        [picture, path](Task&) { *picture = std::make_shared<const BackgroundPicture>(path); });
    connect(job, &Job::finished, this, [this, picture, path, generation] {
        backgroundJob_.clear();
        if (generation != document_->generation())
            return;
        Edit edit{*document_->figure(), tr("Background picture").toStdString(), {}, false};
        Background& background = edit.figure.background; // its colour stays: it shows where the picture is clear
        background.kind = "image";
        background.file = path.string();
        background.picture = *picture;
        document_->apply(edit);
    });
    job->start();
}

} // namespace limner
