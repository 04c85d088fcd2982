#include "app/studio/window_documents.h"

#include "app/studio/action_table.h"
#include "app/studio/missing_parts.h"
#include "core/figure/figure_json.h"
#include "core/project/embedded_volume.h"
#include "core/project/figure_text.h"
#include "core/project/find_volume.h"
#include "core/project/project_lock.h"
#include "widgets/job.h"
#include "widgets/missing_bar.h"
#include "widgets/notice_bar.h"
#include "widgets/progress_strip.h"
#include "widgets/transfer_editor_1d.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <QVBoxLayout>

#include <utility>

namespace limner {
namespace {

namespace fs = std::filesystem;

QString toText(const fs::path& path) { return QString::fromStdString(path.string()); }

QStringList toLines(const std::vector<std::string>& lines) {
    QStringList result;
    for (const std::string& line : lines)
        result << QString::fromStdString(line);
    return result;
}

/// The project as it lies on the disk. What the open figure holds of the same files is not read again.
Document savedDocument(const fs::path& path, const Figure& open, Task& task) {
    Document saved;
    saved.path = path;
    Figure& figure = saved.figure;
    figure = readFigure(readFigureText(path), path.string());
    const auto share = [](auto& to, const auto& from) {
        if (to && from && !to->data && to->sha256 == from->sha256 && !to->sha256.empty()) {
            to->data = from->data;
            to->absolutePath = from->absolutePath;
        }
    };
    share(figure.volume, open.volume);
    share(figure.secondVolume, open.secondVolume);
    if (figure.volume && figure.volume->embedded && open.volume && open.volume->embedded)
        figure.volume->data = open.volume->data;
    resolveFigure(saved, path.parent_path(), {}, task);
    return saved;
}

} // namespace

WindowDocuments::WindowDocuments(const Workplace& place) : QObject(place.window), place_(place), bar_(new MissingBar) {
    if (auto* centre = qobject_cast<QVBoxLayout*>(place_.window->centralWidget()->layout()))
        centre->insertWidget(0, bar_);
    const auto on = [this](const char* id, auto handler) {
        connect(place_.actions->at(id), &QAction::triggered, this, handler);
    };
    on("file.revert", [this] { revert(); });
    on("file.save-copy", [this] {
        const QString suggested = tr("%1 copy.limner").arg(QFileInfo(place_.document->name()).completeBaseName());
        QString path = QFileDialog::getSaveFileName(place_.window, tr("Save a copy"), suggested,
                                                    tr("Limner project (*.limner);;Bare figure (*.json)"));
        if (!path.isEmpty() && !isProject(path.toStdString()))
            path += ".limner";
        if (!path.isEmpty())
            saveCopy(path.toStdString());
    });
    place_.actions->at("file.pack")->setCheckable(true);
    on("file.pack", [this](bool packed) { packToggled(packed); });
    connect(bar_, &MissingBar::findWanted, this, &WindowDocuments::chooseFile);
    connect(bar_, &MissingBar::findFolderWanted, this, &WindowDocuments::chooseFolder);
    connect(bar_, &MissingBar::searchWanted, this, &WindowDocuments::search);
    connect(bar_, &MissingBar::stopWanted, this, [this] {
        if (searchJob_)
            searchJob_->cancel();
    });
    connect(place_.document, &StudioDocument::changed, this, &WindowDocuments::documentChanged);
    documentChanged();
}

void WindowDocuments::documentChanged() {
    const StudioDocument& document = *place_.document;
    const bool project = !document.projectPath().empty();
    place_.actions->at("file.revert")->setEnabled(project && document.dirty());
    place_.actions->at("file.save-copy")->setEnabled(!document.empty());
    showPacked();
    if (held_ != document.projectPath())
        hold();
    showMissing();
    if (generation_ != document.generation()) {
        generation_ = document.generation();
        if (searchJob_)
            searchJob_->cancel();
        if (!document.empty() && !missingParts(*document.figure()).empty()) // once it is open for everybody
            QMetaObject::invokeMethod(this, &WindowDocuments::search, Qt::QueuedConnection);
    }
}

void WindowDocuments::hold() {
    lock_.reset();
    held_ = place_.document->projectPath();
    QString holder;
    if (!held_.empty()) {
        try {
            lock_ = lockProject(held_);
            if (!lock_)
                holder = QString::fromStdString(projectHolder(held_).value_or(std::string()));
        } catch (const Error&) { // a folder that cannot be written: nobody saves there
            lock_.reset();
        }
    }
    place_.document->setHolder(holder);
    if (!holder.isEmpty())
        QMetaObject::invokeMethod(
            this,
            [this, holder] { // after the notices of opening
                place_.notices->setNotices(
                    {tr("“%1” is open in another Limner (%2). You can work on it here; saving asks for another name.")
                         .arg(place_.document->name(), holder)},
                    NoticeBar::Kind::problem);
            },
            Qt::QueuedConnection);
}

void WindowDocuments::revert() {
    const fs::path path = place_.document->projectPath();
    if (path.empty())
        return;
    auto saved = std::make_shared<Document>();
    const unsigned generation = place_.document->generation();
    Job* job = place_.makeJob(
        job_, tr("Reading %1").arg(toText(path.filename())),
        [saved, path, open = place_.document->figure()](Task& task) { *saved = savedDocument(path, *open, task); });
    connect(job, &Job::finished, this, [this, saved, generation, path] {
        if (generation != place_.document->generation())
            return;
        place_.document->apply({saved->figure, tr("Revert to saved").toStdString(), {}, false});
        place_.document->setSaved(path, place_.document->history().stateId());
        place_.notices->setNotices(toLines(saved->notes), NoticeBar::Kind::information);
        place_.tell(tr("As it was saved; Undo brings your changes back"));
        Q_EMIT reverted();
    });
    place_.progress->follow(job);
    job->start();
}

void WindowDocuments::saveCopy(const fs::path& path) {
    if (place_.document->empty())
        return;
    SaveOptions options;
    options.thumbnailPng = place_.thumbnail();
    const Document snapshot = place_.document->snapshot();
    const auto& volume = snapshot.figure.volume;
    options.embedVolume = volume && volume->data && (volume->embedded || volume->path.empty());
    const auto holder = projectHolder(path);
    if (holder) {
        place_.showError({ErrorKind::usage,
                          {"cannot save the copy", path.string(), "a Limner has that project open (" + *holder + ")",
                           "use another name"}});
        return;
    }
    Job* job = place_.makeJob(job_, tr("Saving %1").arg(toText(path.filename())),
                              [snapshot, path, options](Task& task) { saveDocument(snapshot, path, options, task); });
    connect(job, &Job::finished, this, [this, path] {
        place_.tell(tr("Saved a copy as %1").arg(toText(path.filename())));
        Q_EMIT copySaved();
    });
    place_.progress->follow(job);
    job->start();
}

void WindowDocuments::showPacked() {
    const auto figure = place_.document->figure();
    const bool scan = figure && figure->volume && figure->volume->data;
    QAction* pack = place_.actions->at("file.pack");
    pack->setEnabled(scan);
    // A scan that came from no file is always packed.
    pack->setChecked(scan && (figure->volume->embedded || figure->volume->path.empty()));
}

void WindowDocuments::packToggled(bool on) {
    if (on) {
        pack();
        return;
    }
    const auto figure = place_.document->figure();
    std::error_code ignored;
    if (figure && figure->volume && fs::exists(figure->volume->absolutePath, ignored)) {
        unpack({});
        return;
    }
    QString path = QFileDialog::getSaveFileName(place_.window, tr("Take the scan out into a file"), "scan.nrrd",
                                                tr("NRRD volume (*.nrrd)"));
    if (!path.isEmpty() && QFileInfo(path).suffix() != "nrrd")
        path += ".nrrd";
    if (!path.isEmpty())
        unpack(path.toStdString());
    showPacked();
}

void WindowDocuments::pack() {
    const auto figure = place_.document->figure();
    if (!figure || !figure->volume || !figure->volume->data)
        return;
    Edit edit{*figure, tr("Pack the scan into the project").toStdString(), {}, false};
    edit.figure.volume->embedded = true;
    place_.document->apply(edit);
    place_.tell(tr("The scan goes into the project at the next save"));
}

void WindowDocuments::unpack(const fs::path& to) {
    const auto figure = place_.document->figure();
    if (!figure || !figure->volume || !figure->volume->data)
        return;
    const auto apply = [this](const Figure& now) {
        place_.document->apply({now, tr("Take the scan out of the project").toStdString(), {}, false});
        place_.tell(tr("The project refers to the scan's file from the next save on"));
    };
    if (to.empty()) {
        Figure now = *figure;
        now.volume->embedded = false;
        now.volume->path = now.volume->absolutePath;
        apply(now);
        return;
    }
    auto sum = std::make_shared<std::string>();
    const unsigned generation = place_.document->generation();
    Job* job = place_.makeJob(job_, tr("Writing %1").arg(toText(to.filename())),
                              [sum, to, data = figure->volume->data](Task& task) {
                                  const fs::path part = to.string() + ".part.nrrd";
                                  try {
                                      *sum = writeNrrd(*data, part, task);
                                      fs::rename(part, to);
                                  } catch (...) {
                                      std::error_code ignored;
                                      fs::remove(part, ignored);
                                      throw;
                                  }
                              });
    connect(job, &Job::finished, this, [this, sum, to, generation, apply] {
        if (generation != place_.document->generation())
            return;
        Figure now = *place_.document->figure();
        std::error_code ignored;
        now.volume->embedded = false;
        now.volume->path = now.volume->absolutePath = fs::weakly_canonical(to, ignored).string();
        now.volume->sha256 = *sum;
        now.volume->bytes = static_cast<std::int64_t>(fs::file_size(to, ignored));
        place_.document->setScan(place_.document->histogram(), {});
        apply(now);
    });
    place_.progress->follow(job);
    job->start();
}

void WindowDocuments::showMissing() {
    const auto figure = place_.document->figure();
    const auto missing = figure ? missingParts(*figure) : std::vector<MissingPart>();
    if (missing.empty()) {
        bar_->setMissing({});
        return;
    }
    const QString name = QString::fromStdString(pathOf(*figure, missing.front()));
    const QString text = missing.front() == MissingPart::scan         ? tr("The scan “%1” is not where it was.")
                         : missing.front() == MissingPart::secondScan ? tr("The second scan “%1” is not where it was.")
                                                                      : tr("The labels “%1” are not where they were.");
    bar_->setMissing(text.arg(name));
}

void WindowDocuments::search() { bring({}); }

void WindowDocuments::useFile(const fs::path& path) { bring(path); }

QString WindowDocuments::missingName() const {
    const auto figure = place_.document->figure();
    if (!figure || missingParts(*figure).empty())
        return {};
    return QFileInfo(QString::fromStdString(pathOf(*figure, missingParts(*figure).front()))).fileName();
}

void WindowDocuments::chooseFolder() {
    const QString name = missingName();
    if (name.isEmpty())
        return;
    const QString path = QFileDialog::getExistingDirectory(place_.window, tr("Where is “%1”?").arg(name));
    if (!path.isEmpty())
        useFile(path.toStdString());
}

void WindowDocuments::chooseFile() {
    const QString name = missingName();
    if (name.isEmpty())
        return;
    const QString path = QFileDialog::getOpenFileName(place_.window, tr("Where is “%1”?").arg(name), {},
                                                      tr("That file (%1);;Everything (*)").arg(name));
    if (!path.isEmpty())
        useFile(path.toStdString());
}

void WindowDocuments::bring(const fs::path& file) {
    const auto figure = place_.document->figure();
    if (!figure || missingParts(*figure).empty())
        return;
    std::vector<fs::path> recent;
    for (const QString& path : QSettings().value("recent").toStringList())
        recent.emplace_back(path.toStdString());
    const auto folders = searchFolders(place_.document->projectPath(), recent);
    auto found = std::make_shared<FoundParts>();
    const unsigned generation = place_.document->generation();
    Job* job =
        place_.makeJob(searchJob_, tr("Looking for what is missing"), [found, figure, folders, file](Task& task) {
            *found = file.empty() ? findParts(*figure, folders, task)
                                  : takePart(*figure, missingParts(*figure).front(), file, task);
        });
    const auto ended = [this] {
        if (!searchJob_) // else it has given way to the next one
            bar_->setSearching(false);
    };
    connect(job, &QObject::destroyed, this, ended);
    connect(job, &Job::finished, this, [this, found, generation] {
        bar_->setSearching(false);
        if (generation != place_.document->generation())
            return;
        if (found->any()) {
            if (found->scan)
                place_.document->setScan(found->histogram, found->report);
            place_.document->apply(
                {found->in(*place_.document->figure()), tr("Find what was missing").toStdString(), {}, false});
            place_.transfer->setHistogram(place_.document->histogram());
            QStringList lines = toLines(found->notes);
            if (found->scan)
                lines.prepend(tr("The scan was found at %1").arg(QString::fromStdString(found->scan->path)));
            place_.notices->setNotices(lines, NoticeBar::Kind::information);
        }
        Q_EMIT searched(found->any());
    });
    bar_->setSearching(true);
    place_.progress->follow(job);
    job->start();
}

} // namespace limner
