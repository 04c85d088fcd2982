#include "renderer/accuracy/study.h"

#include "core/base/error.h"
#include "renderer/accuracy/perceived_error.h"

#include <glm/common.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace limner::accuracy {

namespace {

constexpr double kFloorBars = 4;    // errors below so many bars say nothing of an order
constexpr double kCheapPicture = 3; // seconds that a whole picture for the error map may take

/// Fills in a study, measurement by measurement.
class Run {
  public:
    Run(Study& study, Bench& bench, const Quality& present, const StudyOptions& options, Task& task)
        : study_(study), bench_(bench), present_(present), options_(options), task_(task) {}

    [[nodiscard]] double elapsed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    /// Row of a quality; nothing when the time is up.
    std::optional<std::size_t> add(const std::string& method, const Quality& quality) {
        if (elapsed() > options_.secondsBudget) {
            study_.leftOut += 1;
            return std::nullopt;
        }
        return measure(method, quality);
    }

    /// However late it is: without the figure as it is there is no study.
    void present() {
        const ProbePicture whole = bench_.whole(present_);
        study_.picture = whole.picture;
        perProbe_ = whole.seconds / std::max(bench_.measure(present_).seconds, 1e-9);
        study_.present = measure("present", present_);
    }

    /// One line of the chart: all at its best but `base`'s difference, the step as parameter.
    void series(const std::string& method, const Quality& base) {
        StudySeries line{method, {}, 0, false};
        const KnobLevels& step = bench_.knobs().front();
        for (std::size_t i = 0; i < step.levels.size(); ++i) {
            if (const auto row = add(method, withLevel(base, step, i))) {
                line.rows.push_back(*row);
            }
        }
        findOrder(line);
        study_.series.push_back(std::move(line));
    }

    void oneKnobAtATime() {
        for (const KnobLevels& knob : bench_.knobs()) {
            if (!asked(knob.knob)) {
                continue;
            }
            for (std::size_t i = 0; knob.knob != Knob::step && i < knob.best(); ++i) {
                add(nameOf(knob.knob), withLevel(bench_.best(), knob, i));
            }
            budget(knob);
        }
    }

    void choices() {
        for (const NamedTolerance& named : namedTolerances()) {
            choose(std::string("for ") + named.name, named.tolerance);
        }
        if (options_.tolerance) {
            choose("as asked", *options_.tolerance);
        }
    }

    /// For the error map: with the finest step whose whole picture does not take too long.
    void bestPicture() {
        const KnobLevels& step = bench_.knobs().front();
        for (std::size_t level = step.best() + 1; level-- > 0;) {
            const Quality quality = withLevel(bench_.best(), step, level);
            if (quality.stepVoxels < present_.stepVoxels &&
                bench_.measure(quality).seconds * perProbe_ <= kCheapPicture) {
                study_.best = bench_.whole(quality).picture;
                if (bench_.hasLines()) {
                    study_.lines = compareLines(bench_.linesOf(present_, study_.picture),
                                                bench_.linesOf(quality, study_.best), study_.size.x);
                }
                return;
            }
        }
        study_.notes.emplace_back("No error map: a finer picture takes too long.");
    }

    void finish() {
        study_.limits = limitingKnob(bench_, present_, options_.metric);
        study_.limiting = limitingWords(study_.limits, options_.metric);
        if (study_.leftOut > 0) {
            study_.notes.push_back(std::to_string(study_.leftOut) + " settings were left out: the time was up.");
        }
        findPareto();
        study_.seconds = elapsed();
    }

  private:
    std::size_t measure(const std::string& method, const Quality& quality) {
        task_.throwIfCancelled();
        const Measured& measured = bench_.measure(quality);
        study_.rows.push_back({method, words(quality), measured, measured.seconds * perProbe_});
        return study_.rows.size() - 1;
    }

    [[nodiscard]] bool asked(Knob knob) const {
        return options_.knobs.empty() ||
               std::find(options_.knobs.begin(), options_.knobs.end(), knob) != options_.knobs.end();
    }

    [[nodiscard]] std::string words(const Quality& quality) const { return wordsOf(quality, bench_.knobs()); }

    void budget(const KnobLevels& knob) {
        const Quality& own = present_;
        KnobLevels single{knob.knob, {own}, {""}, true};
        const Quality quality = withLevel(bench_.best(), single, 0);
        const auto row = add(std::string(nameOf(knob.knob)) + " as it is", quality);
        if (!row) {
            return;
        }
        study_.budget.push_back(
            {knob.knob, levelWord(own, knob), study_.rows[*row].measured.error.of(options_.metric)});
    }

    void choose(const std::string& name, const Tolerance& tolerance) {
        if (elapsed() > options_.secondsBudget) {
            study_.leftOut += 1;
            return;
        }
        try {
            const ToleranceChoice choice = chooseQuality(bench_, tolerance);
            study_.choices.emplace_back(name, choice);
            add(name, choice.quality);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::notConverged) {
                throw;
            }
            study_.notes.push_back(name + ": " + error.text().why + ".");
        }
    }

    /// The mean over the halvings whose errors are both well above the bar; none: no order.
    void findOrder(StudySeries& line) const {
        double sum = 0;
        int count = 0;
        for (std::size_t i = 0; i + 1 < line.rows.size(); ++i) {
            const double coarse = study_.rows[line.rows[i]].measured.error.rmse;
            const double fine = study_.rows[line.rows[i + 1]].measured.error.rmse;
            if (fine > kFloorBars * bench_.reference().bar.rmse && fine > 0) {
                sum += std::log2(coarse / fine);
                ++count;
            }
        }
        line.ordered = count > 0;
        line.order = count > 0 ? sum / count : 0;
    }

    void findPareto() {
        std::vector<std::size_t> order(study_.rows.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return study_.rows[a].measured.seconds < study_.rows[b].measured.seconds;
        });
        double least = std::numeric_limits<double>::infinity();
        for (const std::size_t row : order) {
            const double error = study_.rows[row].measured.error.of(options_.metric);
            if (error < least) {
                least = error;
                study_.pareto.push_back(row);
            }
        }
    }

    Study& study_;
    Bench& bench_;
    const Quality& present_;
    const StudyOptions& options_;
    Task& task_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double perProbe_ = 1;
};

/// A line for each way of sampling that the figure can have.
void drawSeries(Run& run, const Bench& bench) {
    const Quality best = bench.best();
    for (const KnobLevels& knob : bench.knobs()) {
        if (knob.knob == Knob::preintegration) {
            run.series("point samples", withLevel(best, knob, 0));
            run.series("pre-integration", best);
            return;
        }
    }
    run.series("point samples", best);
}

} // namespace

Study runStudy(const Figure& figure, const PlanRequest& request, const Backend& backend, const StudyOptions& options,
               Task& task) {
    Study study;
    task.beginPhase("Drawing the reference");
    Figure model = figure;
    model.quality = options.model.value_or(figure.quality);
    Bench bench(std::move(model), request, backend, task);
    Run run(study, bench, figure.quality, options, task);
    const auto judge = options.judged ? makeReferenceBackend() : nullptr;
    bench.makeReference(options.tolerance.value_or(Tolerance{ErrorMetric::ciede2000, 0.7}), judge.get());
    study.title = figure.title;
    study.backend = backend.name();
    study.size = bench.size();
    study.probePixels = bench.probe().pixels();
    study.metric = options.metric;
    study.errorBar = bench.reference().errorBar(options.metric);
    study.referenceStep = bench.reference().step;
    study.referenceOrder = bench.reference().order;
    study.extrapolated = bench.reference().extrapolated;
    study.arithmetic = bench.reference().arithmetic;
    study.limit = bench.limit(figure.quality.preintegration);
    task.beginPhase("Measuring error and time");
    run.present();
    task.progress(0.1);
    drawSeries(run, bench);
    task.progress(0.4);
    run.oneKnobAtATime();
    task.progress(0.6);
    run.choices();
    task.progress(0.9);
    run.bestPicture();
    if (study.best.size() == study.picture.size()) {
        study.perceived = perceivedDifferences(study.picture, study.best, glm::dvec3(figure.background.rgba),
                                               pixelsPerDegree(study.size.x / figure.output.widthMm));
    }
    run.finish();
    return study;
}

Picture errorMap(const std::vector<float>& errors, glm::ivec2 size, double worst) {
    Picture map(size);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const float e = std::min(static_cast<float>(errors[i] / worst), 1.0F);
        const float alpha = std::min(2 * e, 1.0F);
        const glm::vec3 colour(std::clamp(3 - 3 * e, 0.0F, 1.0F), std::clamp(2 - 4 * e, 0.0F, 1.0F), 0);
        float* out = map.rgba().data() + 4 * i;
        out[0] = colour.r * alpha;
        out[1] = colour.g * alpha;
        out[2] = colour.b * alpha;
        out[3] = alpha;
    }
    return map;
}

} // namespace limner::accuracy
