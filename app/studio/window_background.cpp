#include "app/studio/window_background.h"

#include "app/studio/action_table.h"
#include "app/studio/studio_document.h"
#include "core/style/background_picture.h"
#include "widgets/colour_button.h"
#include "widgets/job.h"

#include <QAction>
#include <QColorDialog>
#include <QFileDialog>
#include <QMainWindow>

namespace limner {

WindowBackground::WindowBackground(const Workplace& place) : QObject(place.window), place_(place) {
    QAction* paper = place_.actions->at("background.paper");
    QAction* picture = place_.actions->at("background.picture");
    connect(paper, &QAction::triggered, this, &WindowBackground::choosePaper);
    connect(picture, &QAction::triggered, this, &WindowBackground::choosePicture);
    const auto enable = [this, paper, picture] {
        paper->setEnabled(!place_.document->empty());
        picture->setEnabled(!place_.document->empty());
    };
    connect(place_.document, &StudioDocument::changed, this, enable);
    enable();
}

void WindowBackground::choosePaper() {
    if (place_.document->empty())
        return;
    const QColor colour = QColorDialog::getColor(colourOf(glm::dvec3(place_.document->figure()->background.rgba)),
                                                 place_.window, tr("Paper colour"));
    if (colour.isValid())
        usePaper(colour);
}

void WindowBackground::usePaper(const QColor& colour) {
    if (place_.document->empty())
        return;
    Edit edit{*place_.document->figure(), tr("Paper colour").toStdString(), {}, false};
    edit.figure.background = {};
    edit.figure.background.rgba = glm::dvec4(rgbOf(colour), 1);
    place_.document->apply(edit);
}

void WindowBackground::choosePicture() {
    if (place_.document->empty())
        return;
    const QString path =
        QFileDialog::getOpenFileName(place_.window, tr("Picture behind the figure"), {},
                                     tr("Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr);;Everything (*)"));
    if (!path.isEmpty())
        usePicture(path.toStdString());
}

void WindowBackground::usePicture(const std::filesystem::path& path) {
    if (place_.document->empty())
        return;
    const unsigned generation = place_.document->generation();
    auto picture = std::make_shared<std::shared_ptr<const BackgroundPicture>>();
    Job* job = place_.makeJob(job_, tr("Opening %1").arg(QString::fromStdString(path.filename().string())),
                              [picture, path](Task&) { *picture = std::make_shared<const BackgroundPicture>(path); });
    connect(job, &Job::finished, this, [this, picture, path, generation] {
        job_.clear();
        if (generation != place_.document->generation())
            return;
        Edit edit{*place_.document->figure(), tr("Background picture").toStdString(), {}, false};
        Background& background = edit.figure.background; // its colour stays: it shows where the picture is clear
        background.kind = "image";
        background.file = path.string();
        background.picture = *picture;
        place_.document->apply(edit);
    });
    job->start();
}

} // namespace limner
