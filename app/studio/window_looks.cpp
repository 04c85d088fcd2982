#include "app/studio/window_looks.h"

#include "app/studio/action_table.h"
#include "app/studio/studio_document.h"
#include "app/studio/variant_dialog.h"
#include "core/figure/look.h"
#include "widgets/job.h"
#include "widgets/notice_bar.h"
#include "widgets/progress_strip.h"

#include <QAction>
#include <QFileDialog>
#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <QPixmap>

#include <utility>

namespace limner {
namespace {

QIcon iconOf(const LookCard& card) {
    QPixmap picture;
    picture.loadFromData(reinterpret_cast<const uchar*>(card.thumbnailPng.data()),
                         static_cast<uint>(card.thumbnailPng.size()), "PNG");
    return QIcon(picture);
}

} // namespace

WindowLooks::WindowLooks(const Workplace& place, std::function<std::vector<std::byte>()> thumbnail)
    : QObject(place.window), place_(place), thumbnail_(std::move(thumbnail)), library_(LookLibrary::standardFolder()),
      mine_(new QMenu(place.window)), removal_(new QMenu(place.window)) {
    place_.actions->at("looks.mine")->setMenu(mine_);
    place_.actions->at("looks.remove")->setMenu(removal_);
    const auto on = [this](const char* id, auto handler) {
        connect(place_.actions->at(id), &QAction::triggered, this, handler);
    };
    on("looks.variants", [this] { showVariants(); });
    on("looks.keep", [this] {
        const QString name = QInputDialog::getText(place_.window, tr("Keep this look"), tr("Name of the look"));
        if (!name.trimmed().isEmpty())
            keep(name.trimmed());
    });
    on("looks.import", [this] {
        const QString file = QFileDialog::getOpenFileName(place_.window, tr("Import look"), {},
                                                          tr("Looks and projects (*.limner *.json);;Everything (*)"));
        if (!file.isEmpty())
            import(file.toStdString());
    });
    connect(place_.document, &StudioDocument::changed, this, &WindowLooks::enable);
    enable();
    read();
}

void WindowLooks::enable() {
    const auto figure = place_.document->figure();
    const bool drawable = figure && figure->volume && figure->volume->data;
    for (const char* id : {"looks.variants", "looks.keep"})
        place_.actions->at(id)->setEnabled(drawable);
    place_.actions->at("looks.mine")->setEnabled(drawable && !cards_.empty());
    place_.actions->at("looks.remove")->setEnabled(!cards_.empty());
}

void WindowLooks::read() {
    auto listing = std::make_shared<LookLibrary::Listing>();
    Job* job = place_.makeJob(readJob_, tr("Reading looks"),
                              [listing, library = library_](Task&) { *listing = library.list(); });
    connect(job, &Job::finished, this, [this, listing] {
        cards_ = listing->cards;
        QStringList problems;
        for (const std::string& problem : listing->problems)
            problems << QString::fromStdString(problem);
        if (!problems.isEmpty())
            place_.notices->setNotices(problems, NoticeBar::Kind::problem);
        showCards();
        Q_EMIT changed();
    });
    job->start();
}

void WindowLooks::showCards() {
    mine_->clear();
    removal_->clear();
    for (const LookCard& card : cards_) {
        const QString name = QString::fromStdString(card.name);
        const QIcon icon = iconOf(card);
        mine_->addAction(icon, name, this, [this, id = card.id, name] { use(id, name); });
        removal_->addAction(icon, name, this, [this, id = card.id] { remove(id); });
    }
    enable();
}

void WindowLooks::keep(const QString& name) {
    const auto figure = place_.document->figure();
    if (!figure)
        return;
    Job* job = place_.makeJob(writeJob_, tr("Keeping the look"),
                              [figure, name = name.toStdString(), picture = thumbnail_(),
                               library = library_](Task& task) { library.add(*figure, name, picture, task); });
    connect(job, &Job::finished, this, [this, name] {
        place_.tell(tr("The look “%1” is kept: Looks, Mine").arg(name));
        read();
    });
    place_.progress->follow(job);
    job->start();
}

void WindowLooks::import(const std::filesystem::path& file) {
    Job* job = place_.makeJob(writeJob_, tr("Importing the look"),
                              [file, library = library_](Task& task) { library.import(file, task); });
    connect(job, &Job::finished, this, &WindowLooks::read);
    place_.progress->follow(job);
    job->start();
}

void WindowLooks::remove(const std::string& id) {
    Job* job =
        place_.makeJob(writeJob_, tr("Removing the look"), [id, library = library_](Task&) { library.remove(id); });
    connect(job, &Job::finished, this, &WindowLooks::read);
    job->start();
}

void WindowLooks::use(const std::string& id, const QString& name) {
    const auto figure = place_.document->figure();
    if (!figure)
        return;
    struct Laid {
        Figure figure;
        std::vector<std::string> notes;
    };
    auto laid = std::make_shared<Laid>();
    const unsigned generation = place_.document->generation();
    Job* job = place_.makeJob(useJob_, tr("Look %1").arg(name), [laid, figure, id, library = library_](Task& task) {
        laid->figure = withLook(*figure, library.load(id, task), laid->notes);
    });
    connect(job, &Job::finished, this, [=, this] {
        if (generation != place_.document->generation())
            return;
        Edit edit{laid->figure, tr("Look %1").arg(name).toStdString(), {}, false};
        edit.figure.camera = place_.document->figure()->camera; // it may have been turned meanwhile
        edit.figure.output = place_.document->figure()->output;
        place_.document->apply(edit);
        QStringList lines;
        for (const std::string& note : laid->notes)
            lines << QString::fromStdString(note);
        place_.notices->setNotices(lines, NoticeBar::Kind::information);
        Q_EMIT used();
    });
    place_.progress->follow(job);
    job->start();
}

VariantDialog* WindowLooks::showVariants() {
    auto* dialog = new VariantDialog(place_);
    dialog->show(); // beside the window: one goes on working
    return dialog;
}

} // namespace limner
