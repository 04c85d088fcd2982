// What the window does with files: every long part of it is a job.
#include "app/studio/main_window.h"

#include "app/studio/extraction_dialog.h"
#include "app/studio/scan_histogram.h"
#include "app/studio/welcome_page.h"
#include "app/studio/window_gallery.h"
#include "core/figure/presets.h"
#include "core/figure/themes.h"
#include "core/project/label_volume.h"
#include "core/project/project_lock.h"
#include "core/style/lit_sphere.h"
#include "core/volume/phantom.h"
#include "widgets/job.h"
#include "widgets/notice_bar.h"
#include "widgets/picture_feed.h"
#include "widgets/picture_words.h"
#include "widgets/preset_menu.h"
#include "widgets/progress_strip.h"
#include "widgets/theme_menu.h"
#include "widgets/transfer_editor_1d.h"
#include "widgets/viewport.h"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QSettings>
#include <QStatusBar>

#include <utility>

namespace limner {
namespace {

constexpr int kSampleSize = 192; // voxels per side: smooth on paper, made in about a second
constexpr int kRecent = 8;
constexpr int kMessageMs = 6000;

QString toText(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

QStringList toLines(const std::vector<std::string>& lines) {
    QStringList result;
    for (const std::string& line : lines)
        result << QString::fromStdString(line);
    return result;
}

QStringList recentPaths() { return QSettings().value("recent").toStringList(); }

/// What a loading job leaves behind.
struct Loaded {
    Document document;
    std::shared_ptr<const Histogram> histogram;
};

} // namespace

Job* MainWindow::startJob(QPointer<Job>& slot, const QString& name, std::function<void(Task&)> work) {
    if (slot) {
        slot->disconnect(this); // its outcome is nobody's business any more
        slot->cancel();
    }
    auto* job = new Job(name, std::move(work), this);
    slot = job;
    for (const auto end : {&Job::finished, &Job::cancelled})
        connect(job, end, job, &QObject::deleteLater);
    connect(job, &Job::failed, job, &QObject::deleteLater);
    connect(job, &Job::failed, this, &MainWindow::showError);
    return job;
}

bool MainWindow::busy() const { return openJob_ || labelJob_ || saveJob_ || lookJob_; }

void MainWindow::loadResources() {
    struct Resources {
        std::vector<Style> styles;
        std::vector<PresetCard> presets;
        std::vector<ThemeCard> themes;
    };
    auto read = std::make_shared<Resources>();
    Job* job = startJob(resourceJob_, tr("Reading styles, presets and themes"), [read](Task&) {
        *read = {bundledStyles(), bundledPresets(), bundledThemes()};
    });
    connect(job, &Job::finished, this, [this, read] {
        styles_->shelf().setBundled(read->styles);
        presets_->setPresets(read->presets);
        themes_->setThemes(read->themes);
    });
    job->start();
}

void MainWindow::startOpening(const QString& name, std::function<Document(Task&)> load, Opened how) {
    auto loaded = std::make_shared<Loaded>();
    Job* job = startJob(openJob_, name, [loaded, load = std::move(load)](Task& task) {
        loaded->document = load(task);
        task.throwIfCancelled();
        loaded->histogram = scanHistogram(loaded->document.figure);
    });
    connect(job, &Job::finished, this, [this, loaded, job, how] {
        openJob_.clear();
        QStringList lines = toLines(loaded->document.notes);
        lines += toLines(loaded->document.volumeReport.warnings);
        lines += toLines(job->warnings());
        document_->open(std::move(loaded->document), loaded->histogram, how);
        transfer_->setHistogram(document_->histogram());
        notices_->setNotices(lines, NoticeBar::Kind::information);
        facts_->setScanWords(lines);
        remember(document_->source().path);
        viewport_->setFocus();
        Q_EMIT documentOpened();
    });
    progress_->follow(job);
    job->start();
}

void MainWindow::openPath(const std::filesystem::path& path) {
    afterChangesAreSafe([this, path] {
        const std::filesystem::path last = path.has_filename() ? path.filename() : path.parent_path().filename();
        startOpening(tr("Opening %1").arg(toText(last)), [path](Task& task) {
            Document document = openDocument(path, "auto", {}, task);
            document.path = path;
            return document;
        });
    });
}

void MainWindow::openSample() {
    afterChangesAreSafe([this] {
        startOpening(tr("Making the sample head"), [](Task& task) {
            const std::shared_ptr<const Volume> volume = makeHeadPhantom(kSampleSize);
            task.throwIfCancelled();
            Document document;
            document.figure = figureFromPreset("auto", volume, document.notes);
            return document;
        });
    });
}

void MainWindow::chooseAndOpen() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open"), {},
        tr("Scans and projects (*.limner *.json *.dcm *.nii *.nii.gz *.hdr *.img *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk "
           "*.tif *.tiff *.png *.inv3 *.inv3.gz);;Everything (*)"));
    if (!path.isEmpty())
        openPath(path.toStdString());
}

void MainWindow::chooseFolderAndOpen() {
    const QString path = QFileDialog::getExistingDirectory(this, tr("Open folder of slices"));
    if (!path.isEmpty())
        openPath(path.toStdString());
}

void MainWindow::chooseAndOpenLabels() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open labels"), {},
        tr("Label volumes (*.nii *.nii.gz *.hdr *.img *.nrrd *.nhdr *.mha *.mhd *.vti *.vtk *.tif *.tiff);;"
           "Everything (*)"));
    if (!path.isEmpty())
        openLabelsPath(path.toStdString());
}

void MainWindow::openLabelsPath(const std::filesystem::path& path) {
    const std::shared_ptr<const Figure> figure = document_->figure();
    if (!figure || !figure->volume || !figure->volume->data)
        return;
    struct Read {
        LabelReference labels;
        std::vector<std::string> notes;
    };
    auto opened = std::make_shared<Read>();
    const unsigned generation = document_->generation();
    Job* job = startJob(labelJob_, tr("Opening %1").arg(toText(path.filename())),
                        [opened, path, scan = figure->volume->data](Task& task) {
                            opened->labels = openLabels(path, {scan, 0}, opened->notes, task);
                        });
    connect(job, &Job::finished, this, [this, opened, job, generation] {
        labelJob_.clear();
        if (generation != document_->generation())
            return;
        Edit edit{*document_->figure(), tr("Open labels").toStdString(), {}, false};
        edit.figure.labels = opened->labels;
        document_->apply(edit);
        notices_->setNotices(toLines(opened->notes) + toLines(job->warnings()), NoticeBar::Kind::information);
        statusBar()->showMessage(tr("The preset “Labelled” draws each label in a colour of its own"), kMessageMs);
        Q_EMIT labelsOpened();
    });
    progress_->follow(job);
    job->start();
}

void MainWindow::save() {
    if (document_->projectPath().empty() || !document_->holder().isEmpty())
        saveAs();
    else
        savePath(document_->projectPath());
}

void MainWindow::saveAs() {
    const QString suggested = QFileInfo(document_->name()).completeBaseName() + ".limner";
    QString path = QFileDialog::getSaveFileName(this, tr("Save project"), suggested,
                                                tr("Limner project (*.limner);;Bare figure (*.json)"));
    if (path.isEmpty()) {
        afterSave_ = nullptr;
        return;
    }
    if (!isProject(path.toStdString()))
        path += ".limner";
    savePath(path.toStdString());
}

void MainWindow::savePath(const std::filesystem::path& path) {
    if (document_->empty())
        return;
    const bool own = path == document_->projectPath() && document_->holder().isEmpty();
    if (const auto holder = own ? std::nullopt : projectHolder(path)) {
        afterSave_ = nullptr;
        showError({ErrorKind::usage,
                   {"cannot save the project", path.string(), "another Limner has it open (" + *holder + ")",
                    "use another name"}});
        return;
    }
    const Document snapshot = document_->snapshot();
    const History::StateId state = document_->history().stateId();
    const unsigned generation = document_->generation();
    SaveOptions options;
    options.thumbnailPng = thumbnail();
    const auto& volume = snapshot.figure.volume;
    // What came from no file would be lost otherwise.
    options.embedVolume = volume && volume->data && (volume->embedded || volume->path.empty());
    Job* job = startJob(saveJob_, tr("Saving %1").arg(toText(path.filename())),
                        [snapshot, path, options](Task& task) { saveDocument(snapshot, path, options, task); });
    connect(job, &Job::finished, this, [this, path, state, generation] {
        saveJob_.clear();
        if (generation == document_->generation())
            document_->setSaved(path, state);
        remember(path);
        statusBar()->showMessage(tr("Saved %1").arg(toText(path.filename())), kMessageMs);
        Q_EMIT documentSaved();
        if (const auto then = std::exchange(afterSave_, nullptr))
            then();
    });
    connect(job, &Job::failed, this, [this] { afterSave_ = nullptr; });
    connect(job, &Job::cancelled, this, [this] { afterSave_ = nullptr; });
    progress_->follow(job);
    job->start();
}

std::vector<std::byte> MainWindow::thumbnail() const {
    const auto& picture = viewport_->picture();
    if (!picture)
        return {};
    constexpr int kThumbnail = 256; // the project file's size for it
    QImage square(kThumbnail, kThumbnail, QImage::Format_ARGB32);
    square.fill(Qt::transparent);
    const QImage small = picture->image.scaled(square.size(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPainter painter(&square);
    painter.drawImage((kThumbnail - small.width()) / 2, (kThumbnail - small.height()) / 2, small);
    painter.end();
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    square.save(&buffer, "PNG");
    const auto* bytes = reinterpret_cast<const std::byte*>(png.constData());
    return {bytes, bytes + png.size()};
}

void MainWindow::usePreset(const QString& id, const QString& name) {
    const std::shared_ptr<const Figure> figure = document_->figure();
    if (!figure)
        return;
    const unsigned generation = document_->generation();
    struct Look {
        Figure figure;
        std::vector<std::string> notes;
    };
    auto look = std::make_shared<Look>();
    Job* job = startJob(lookJob_, tr("Preset %1").arg(name), [look, figure, id = id.toStdString()](Task&) {
        look->figure = withPreset(*figure, id, look->notes);
    });
    connect(job, &Job::finished, this, [=, this] {
        lookJob_.clear();
        if (generation != document_->generation())
            return;
        look->figure.camera = document_->figure()->camera; // it may have been turned meanwhile
        look->figure.output = document_->figure()->output;
        document_->apply({look->figure, tr("Preset %1").arg(name).toStdString(), {}, false});
        notices_->setNotices(toLines(look->notes), NoticeBar::Kind::information);
    });
    progress_->follow(job);
    job->start();
}

void MainWindow::useTheme(const QString& id, const QString& name) {
    const std::shared_ptr<const Figure> figure = document_->figure();
    if (!figure)
        return;
    const unsigned generation = document_->generation();
    // The job reads the styles' pictures; after it, the exchange takes no time.
    Job* job = startJob(lookJob_, tr("Theme %1").arg(name), [figure, id = id.toStdString()](Task&) {
        std::vector<std::string> notes;
        static_cast<void>(withTheme(*figure, id, notes));
    });
    connect(job, &Job::finished, this, [=, this] {
        lookJob_.clear();
        if (generation != document_->generation())
            return;
        std::vector<std::string> notes;
        const Figure themed = withTheme(*document_->figure(), id.toStdString(), notes);
        document_->apply({themed, tr("Theme %1").arg(name).toStdString(), {}, false});
        notices_->setNotices(toLines(notes), NoticeBar::Kind::information);
    });
    progress_->follow(job);
    job->start();
}

void MainWindow::copyPicture() {
    if (const auto& picture = viewport_->picture()) {
        QApplication::clipboard()->setImage(picture->image.copy());
        statusBar()->showMessage(tr("Copied %1 × %2 pixels").arg(picture->image.width()).arg(picture->image.height()),
                                 kMessageMs);
    }
}

void MainWindow::showError(const Error& error) {
    const ErrorText& text = error.text();
    const QString what = QString::fromStdString(text.what);
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Limner Studio"), what.left(1).toUpper() + what.mid(1) + ".",
                                QMessageBox::Ok, this);
    QStringList lines;
    if (!text.why.empty())
        lines << QString::fromStdString(text.why);
    if (!text.remedy.empty())
        lines << tr("What to do: %1").arg(QString::fromStdString(text.remedy));
    box->setInformativeText(lines.join("\n\n"));
    box->setDetailedText(QString::fromUtf8(error.what()));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open(); // the program goes on behind it
}

void MainWindow::afterChangesAreSafe(std::function<void()> then) {
    if (!document_->dirty()) {
        then();
        return;
    }
    Answer answer = Answer::cancel;
    if (askAboutChanges) {
        answer = askAboutChanges();
    } else {
        const auto button = QMessageBox::question(
            this, tr("Unsaved changes"), tr("Save the changes to “%1” first?").arg(document_->name()),
            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
        answer = button == QMessageBox::Save      ? Answer::save
                 : button == QMessageBox::Discard ? Answer::discard
                                                  : Answer::cancel;
    }
    if (answer == Answer::discard)
        then();
    if (answer != Answer::save)
        return;
    afterSave_ = std::move(then);
    save();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (extraction_ && !extraction_->close()) { // it holds a style that has not been added
        event->ignore();
        return;
    }
    if (!document_->dirty()) {
        event->accept();
        return;
    }
    event->ignore();
    afterChangesAreSafe([this] {
        document_->close();
        // Not at once: this may still be within the closing that was put off, which a second one would not get past.
        QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
    });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().front().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.isEmpty())
        return;
    event->acceptProposedAction();
    openPath(urls.front().toLocalFile().toStdString());
}

void MainWindow::remember(const std::filesystem::path& path) {
    if (path.empty())
        return;
    QStringList paths = recentPaths();
    const QString absolute = QFileInfo(toText(path)).absoluteFilePath();
    paths.removeAll(absolute);
    paths.prepend(absolute);
    while (paths.size() > kRecent)
        paths.removeLast();
    QSettings().setValue("recent", paths);
    showRecent();
}

void MainWindow::showRecent() {
    QStringList there;
    for (const QString& path : recentPaths())
        if (QFileInfo::exists(path))
            there << path;
    recent_->clear();
    for (const QString& path : there)
        recent_->addAction(QFileInfo(path).fileName(), this, [this, path] { openPath(path.toStdString()); })
            ->setToolTip(path);
    recent_->setToolTipsVisible(true);
    actions_->at("file.recent")->setEnabled(!there.isEmpty());
    welcome_->setRecent(there);
}

void MainWindow::showAbout() {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Limner"),
                                tr("<b>Limner %1</b><br>From CT and MR scans to print-ready illustrations.")
                                    .arg(QApplication::applicationVersion()),
                                QMessageBox::Ok, this);
    box->setInformativeText(tr("Free software under the Apache License 2.0. A figure shows what is in the scan; it is "
                               "not a medical device and not for diagnosis."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace limner
