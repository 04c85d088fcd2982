#include "app/studio/window_accuracy.h"

#include "app/studio/action_table.h"
#include "app/studio/studio_document.h"
#include "core/style/png_writing.h"
#include "renderer/accuracy/savings.h"
#include "widgets/accuracy_panel.h"
#include "widgets/accuracy_words.h"
#include "widgets/error_overlay.h"
#include "widgets/job.h"
#include "widgets/progress_strip.h"
#include "widgets/viewport.h"

#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace limner {
namespace {

constexpr double kLongestEdge = 512; // pixels; a study of that takes less than a minute

enum class Qualities { matter, doNot };

/// Whether two figures have the same picture, but for what is written over it.
bool sameDrawing(const Figure& a, const Figure& b, Qualities qualities) {
    Figure other = b;
    other.title = a.title;
    other.annotations = a.annotations;
    other.annotationLayout = a.annotationLayout;
    other.unknown = a.unknown;
    other.quality.tolerance = a.quality.tolerance;
    other.quality.toleranceMetric = a.quality.toleranceMetric;
    if (qualities == Qualities::doNot)
        other.quality = a.quality;
    return other == a;
}

std::string reportText(const std::string& ending, const accuracy::Study& study, const Figure& figure) {
    return ending == ".csv"    ? accuracy::reportCsv(study)
           : ending == ".json" ? accuracy::reportJson(study)
                               : accuracy::reportHtml(study, figure);
}

/// The CIEDE2000 that is black on the map: a round number that all but a hundredth of the pixels stay below, so that
/// one sees where the error is, however small.
double worstShown(std::vector<float> errors) {
    constexpr std::size_t kHundred = 100;
    const std::size_t below = errors.size() - 1 - errors.size() / kHundred;
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(below), errors.end());
    for (const double worst : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0})
        if (errors[below] <= worst)
            return worst;
    return 100;
}

/// A figure as it is, and with everything at its best.
struct Pair {
    Picture picture;
    Picture best;
};

Pair drawPair(const Figure& figure, const Quality& model, const PlanRequest& request, const Backend& backend,
              Task& task) {
    constexpr double kKnown = 0.1, kDrawn = 0.3; // of the progress
    Figure modelled = figure;
    modelled.quality = model;
    accuracy::Bench bench(std::move(modelled), request, backend, task);
    task.progress(kKnown);
    Pair pair;
    pair.picture = bench.draw(figure.quality);
    task.progress(kDrawn);
    pair.best = bench.draw(bench.best());
    return pair;
}

ToleranceAnswer findAnswer(const Figure& figure, const PlanRequest& request, const Backend& backend,
                           const accuracy::Tolerance& tolerance, Task& task) {
    constexpr double kKnown = 0.1, kReference = 0.5; // of the progress
    ToleranceAnswer answer{tolerance, 0, std::nullopt};
    accuracy::Bench bench(figure, request, backend, task);
    task.progress(kKnown);
    bench.makeReference(tolerance, nullptr);
    task.progress(kReference);
    answer.errorBar = bench.reference().errorBar(tolerance.metric);
    try {
        answer.choice = accuracy::chooseQuality(bench, tolerance);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::notConverged)
            throw;
    }
    return answer;
}

} // namespace

WindowAccuracy::WindowAccuracy(const Workplace& place)
    : QObject(place.window), place_(place), backend_(place.engine.makeBackend()), panel_(new AccuracyPanel),
      overlay_(new ErrorOverlay(place.viewport)), work_(tr("Accuracy"), this) {
    place_.addDock("dock.accuracy", tr("Accuracy"), panel_, Qt::RightDockWidgetArea)
        ->hide(); // until it is wanted: the panels beside it are the ones that one draws with
    connectPanel();
    connectWork();
    connect(place_.document, &StudioDocument::changed, this, &WindowAccuracy::showFigure);
    showFigure();
}

void WindowAccuracy::connectPanel() {
    connect(panel_, &AccuracyPanel::settingsWanted, this, &WindowAccuracy::findSettings);
    connect(panel_, &AccuracyPanel::studyWanted, this, &WindowAccuracy::runStudy);
    connect(panel_, &AccuracyPanel::savingsWanted, this, &WindowAccuracy::measureSavings);
    connect(panel_, &AccuracyPanel::stopWanted, this, &WindowAccuracy::stop);
    connect(panel_, &AccuracyPanel::reportWanted, this, &WindowAccuracy::chooseReport);
    connect(panel_, &AccuracyPanel::mapWanted, this, &WindowAccuracy::showMap);
    QAction* map = place_.actions->at("view.error-map");
    map->setCheckable(true);
    connect(map, &QAction::triggered, this, &WindowAccuracy::showMap);
    connect(place_.actions->at("edit.find-settings"), &QAction::triggered, this, [this] {
        auto* dock = place_.window->findChild<QDockWidget*>("dock.accuracy");
        dock->show(); // where the answer is
        dock->raise();
        findSettings(panel_->asked());
    });
}

void WindowAccuracy::connectWork() {
    connect(&work_, &NewestJob::started, this, [this](Job* job) {
        connect(job, qOverload<const QString&, double>(&Job::progressed), panel_,
                [this](const QString&, double fraction) { panel_->setProgress(fraction); });
    });
    connect(&work_, &NewestJob::failed, this, [this](const Error& error) {
        idle();
        place_.showError(error);
    });
    connect(&work_, &NewestJob::stopped, this, &WindowAccuracy::idle);
}

PlanRequest WindowAccuracy::request() const {
    const QSize pixels = place_.viewport->picturePixels();
    const glm::dvec2 size(pixels.width(), pixels.height());
    const double scale = std::min(1.0, kLongestEdge / std::max(size.x, size.y));
    PlanRequest request;
    request.size = glm::max(glm::ivec2(glm::round(size * scale)), 1);
    return request;
}

Quality WindowAccuracy::modelOf(const Figure& figure) const {
    return applied_ && figure.quality == *applied_ ? model_
                                                   : figure.quality; // what a search has lowered may rise again
}

void WindowAccuracy::findSettings(const accuracy::Tolerance& tolerance) {
    const auto figure = place_.document->figure();
    const AccuracyPanel::Work now = panel_->work();
    if (!figure || (now != AccuracyPanel::Work::none && now != AccuracyPanel::Work::search))
        return;
    working_ = figure;
    auto model = std::make_shared<Figure>(*figure);
    model->quality = modelOf(*figure);
    auto answer = std::make_shared<ToleranceAnswer>();
    panel_->setWork(AccuracyPanel::Work::search);
    work_.want([answer, model, tolerance, request = request(),
                backend = backend_](Task& task) { *answer = findAnswer(*model, request, *backend, tolerance, task); },
               [this, answer, model] {
                   idle();
                   const Quality before = place_.document->figure()->quality;
                   if (answer->choice && answer->choice->reached) {
                       apply(*answer->choice);
                       model_ = model->quality;
                       applied_ = place_.document->figure()->quality;
                   }
                   found_ = place_.document->figure();
                   panel_->showAnswer(*answer, !(found_->quality == before));
               });
}

void WindowAccuracy::apply(const accuracy::ToleranceChoice& choice) {
    const auto figure = place_.document->figure();
    const QString name = toleranceName(choice.asked);
    Edit edit{*figure, {}, {}, false};
    edit.figure.quality = choice.quality;
    edit.figure.quality.tolerance = choice.asked.value;
    edit.figure.quality.toleranceMetric = choice.asked.metric;
    edit.label = tr("Set accuracy: %1")
                     .arg(name.isEmpty() ? errorWords(choice.asked.value, choice.asked.metric) : name)
                     .toStdString();
    place_.document->apply(edit);
}

void WindowAccuracy::runStudy() {
    const auto figure = place_.document->figure();
    if (!figure || panel_->work() != AccuracyPanel::Work::none)
        return;
    working_ = figure;
    accuracy::StudyOptions options;
    const accuracy::Tolerance asked = panel_->asked();
    options.metric = asked.metric;
    if (toleranceName(asked).isEmpty())
        options.tolerance = asked;
    options.model = modelOf(*figure);
    options.secondsBudget = panel_->studySeconds();
    auto study = std::make_shared<accuracy::Study>();
    panel_->setWork(AccuracyPanel::Work::study);
    work_.want([study, figure, options, request = request(), backend = backend_](
                   Task& task) { *study = accuracy::runStudy(*figure, request, *backend, options, task); },
               [this, study, figure] {
                   idle();
                   studied_ = figure;
                   study_ = study;
                   panel_->showStudy(study);
               });
}

void WindowAccuracy::measureSavings() {
    const auto figure = place_.document->figure();
    if (!figure || panel_->work() != AccuracyPanel::Work::none)
        return;
    working_ = figure;
    auto savings = std::make_shared<accuracy::Savings>();
    panel_->setWork(AccuracyPanel::Work::savings);
    work_.want([savings, figure, request = request(), backend = backend_](
                   Task& task) { *savings = accuracy::measureSavings(*figure, *backend, request, task); },
               [this, savings, figure] {
                   idle();
                   saved_ = figure;
                   panel_->showSavings(*savings);
               });
}

void WindowAccuracy::showMap(bool on) {
    const auto figure = place_.document->figure();
    takeMapAway();
    if (panel_->work() == AccuracyPanel::Work::map)
        stop();
    if (!on || !figure || panel_->work() != AccuracyPanel::Work::none)
        return;
    if (study_ && study_->best.size() == study_->picture.size() && sameDrawing(*figure, *studied_, Qualities::matter)) {
        mapped_ = figure;
        showErrors(study_->picture, study_->best);
        return;
    }
    working_ = figure;
    auto pair = std::make_shared<Pair>();
    panel_->setWork(AccuracyPanel::Work::map);
    panel_->setMapShown(true);
    place_.actions->at("view.error-map")->setChecked(true);
    work_.want([pair, figure, model = modelOf(*figure), request = request(),
                backend = backend_](Task& task) { *pair = drawPair(*figure, model, request, *backend, task); },
               [this, pair, figure] {
                   idle();
                   mapped_ = figure;
                   showErrors(pair->picture, pair->best);
               });
}

void WindowAccuracy::showErrors(const Picture& picture, const Picture& best) {
    const glm::dvec3 background(mapped_->background.rgba);
    const std::vector<float> errors = accuracy::colourDifferences(picture, best, background);
    const double worst = worstShown(errors);
    overlay_->showMap(accuracy::errorMap(errors, picture.size(), worst), worst);
    panel_->setMapShown(true);
    place_.actions->at("view.error-map")->setChecked(true);
}

void WindowAccuracy::takeMapAway() {
    mapped_.reset();
    overlay_->clear();
    panel_->setMapShown(false);
    place_.actions->at("view.error-map")->setChecked(false);
}

void WindowAccuracy::stop() {
    work_.drop();
    idle();
}

void WindowAccuracy::idle() {
    working_.reset();
    if (panel_->work() == AccuracyPanel::Work::map && !mapped_)
        takeMapAway();
    panel_->setWork(AccuracyPanel::Work::none);
}

void WindowAccuracy::forgetDocument() {
    generation_ = place_.document->generation();
    stop();
    takeMapAway();
    found_.reset();
    applied_.reset();
    studied_.reset();
    study_.reset();
    saved_.reset();
    panel_->forget();
}

void WindowAccuracy::showFigure() {
    const auto figure = place_.document->figure();
    const bool drawable = figure && figure->volume && figure->volume->data;
    if (!drawable || generation_ != place_.document->generation())
        forgetDocument();
    place_.actions->at("view.error-map")->setEnabled(drawable);
    place_.actions->at("edit.find-settings")->setEnabled(drawable);
    panel_->setFigure(figure);
    if (!drawable)
        return;
    const bool search = panel_->work() == AccuracyPanel::Work::search;
    if (working_ && !sameDrawing(*figure, *working_, search ? Qualities::doNot : Qualities::matter)) {
        stop(); // nobody waits for what it would say of a figure that is not there any more
        panel_->say(tr("Stopped: the figure or the view has changed."));
        found_.reset();
    }
    if (mapped_ && !sameDrawing(*figure, *mapped_, Qualities::matter)) {
        takeMapAway();
        place_.tell(tr("The error is no longer shown: the picture has changed"));
    }
    if (found_)
        panel_->setAnswerCurrent(sameDrawing(*figure, *found_, Qualities::matter));
    if (studied_)
        panel_->setStudyCurrent(sameDrawing(*figure, *studied_, Qualities::matter));
    if (saved_)
        panel_->setSavingsCurrent(sameDrawing(*figure, *saved_, Qualities::matter));
}

void WindowAccuracy::chooseReport() {
    QString path = QFileDialog::getSaveFileName(
        place_.window, tr("Save report"), QFileInfo(place_.document->name()).completeBaseName() + "-accuracy.html",
        tr("Page with charts (*.html);;Table (*.csv);;JSON (*.json)"));
    if (path.isEmpty())
        return;
    if (!QStringList{"html", "csv", "json"}.contains(QFileInfo(path).suffix()))
        path += ".html";
    saveReport(path.toStdString());
}

void WindowAccuracy::saveReport(const std::filesystem::path& path) {
    if (!study_)
        return;
    Job* job = place_.makeJob(reportJob_, tr("Saving the report"), [path, study = study_, figure = studied_](Task&) {
        writeWholeFile(path, reportText(path.extension().string(), *study, *figure));
    });
    connect(job, &Job::finished, this, [this, path] {
        place_.tell(tr("The report is saved: %1").arg(QString::fromStdString(path.filename().string())));
        Q_EMIT reportSaved();
    });
    place_.progress->follow(job);
    job->start();
}

} // namespace limner
