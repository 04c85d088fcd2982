#include "renderer/accuracy/tolerance.h"

#include "core/base/error.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace limner::accuracy {

namespace {

constexpr double kSafety = 0.8; // of the tolerance: the probe is a sample
constexpr int kMostTightenings = 4;
constexpr double kLeastSeconds = 1e-9;

/// Levels of the searched knobs.
using Setting = std::vector<std::size_t>;

/// One search for one tolerance.
class Search {
  public:
    Search(Bench& bench, const Tolerance& tolerance) : bench_(bench), tolerance_(tolerance) {
        for (const KnobLevels& knob : bench.knobs()) {
            if (knob.searched) {
                knobs_.push_back(&knob);
            }
        }
    }

    /// The setting found, or the best there is.
    Setting run(double bound) {
        Setting setting = cheapest();
        while (errorOf(setting) > bound && raise(setting)) {
        }
        for (bool lowered = true; lowered && errorOf(setting) <= bound;) {
            lowered = lower(setting, bound) || exchange(setting, bound);
        }
        return setting;
    }

    [[nodiscard]] Quality qualityOf(const Setting& setting) const {
        Quality quality = bench_.best();
        for (std::size_t i = 0; i < knobs_.size(); ++i) {
            quality = withLevel(quality, *knobs_[i], setting[i]);
        }
        const double limit = bench_.limit(quality.preintegration).voxels;
        quality.stepVoxels = std::min(quality.stepVoxels, limit);
        return quality;
    }

    [[nodiscard]] double errorOf(const Setting& setting) const {
        return bench_.measure(qualityOf(setting)).error.of(tolerance_.metric);
    }
    [[nodiscard]] double secondsOf(const Setting& setting) const { return bench_.measure(qualityOf(setting)).seconds; }

  private:
    [[nodiscard]] Setting cheapest() const { return Setting(knobs_.size(), 0); }

    [[nodiscard]] bool canRise(const Setting& setting, std::size_t knob) const {
        return setting[knob] < knobs_[knob]->best();
    }

    /// Raises the knob that removes most error for its time. Where none does, errors hide each other: the finest step's
    /// way is taken, or else whatever can still rise.
    bool raise(Setting& setting) const {
        const double error = errorOf(setting);
        const double seconds = secondsOf(setting);
        std::optional<Setting> best;
        double bestGain = 0;
        std::optional<Setting> any;
        for (std::size_t i = 0; i < knobs_.size(); ++i) {
            if (!canRise(setting, i)) {
                continue;
            }
            Setting next = setting;
            next[i] += 1;
            // Steps over the limit are all the same: on to the first that is not.
            while (canRise(next, i) && qualityOf(next) == qualityOf(setting)) {
                next[i] += 1;
            }
            any = any ? any : next;
            const double gain = (error - errorOf(next)) / std::max(secondsOf(next) - seconds, kLeastSeconds);
            if (gain > bestGain) {
                bestGain = gain;
                best = next;
            }
        }
        if (!best && !any) {
            return false;
        }
        setting = best ? *best : *any;
        return true;
    }

    /// Takes a cheaper setting that still keeps the bound.
    bool take(Setting& setting, const Setting& next, double bound) const {
        if (errorOf(next) <= bound && secondsOf(next) < secondsOf(setting)) {
            setting = next;
            return true;
        }
        return false;
    }

    bool lower(Setting& setting, double bound) const {
        for (std::size_t i = 0; i < knobs_.size(); ++i) {
            for (std::size_t level = 0; level < setting[i]; ++level) {
                Setting next = setting;
                next[i] = level;
                if (take(setting, next, bound)) {
                    return true;
                }
            }
        }
        return false;
    }

    /// One knob lower, another one higher.
    bool exchange(Setting& setting, double bound) const {
        for (std::size_t down = 0; down < knobs_.size(); ++down) {
            for (std::size_t up = 0; setting[down] > 0 && up < knobs_.size(); ++up) {
                if (up == down || !canRise(setting, up)) {
                    continue;
                }
                Setting next = setting;
                next[down] -= 1;
                next[up] += 1;
                if (take(setting, next, bound)) {
                    return true;
                }
            }
        }
        return false;
    }

    Bench& bench_;
    Tolerance tolerance_;
    std::vector<const KnobLevels*> knobs_;
};

std::string amount(double error, ErrorMetric metric) {
    char text[48];
    std::snprintf(text, sizeof text, metric == ErrorMetric::ciede2000 ? "dE00 %.3g" : "%.3g", error);
    return text;
}

void checkReference(const Bench& bench, const Tolerance& tolerance) {
    const double bar = bench.reference().errorBar(tolerance.metric);
    if (bar > tolerance.value * kBarShare) {
        throw Error(ErrorKind::notConverged,
                    {"the error cannot be told to this tolerance", "",
                     "the reference itself is only good to " + amount(bar, tolerance.metric) + ", the tolerance is " +
                         amount(tolerance.value, tolerance.metric),
                     "ask for a larger tolerance, or soften what is steep in the transfer functions"});
    }
}

} // namespace

const std::vector<NamedTolerance>& namedTolerances() {
    static const std::vector<NamedTolerance> named = {{"draft", {ErrorMetric::ciede2000, 3}},
                                                      {"screen", {ErrorMetric::ciede2000, 1.5}},
                                                      {"print", {ErrorMetric::ciede2000, 0.7}},
                                                      {"reference", {ErrorMetric::largest, 1.0 / 510}}};
    return named;
}

ToleranceChoice chooseQuality(Bench& bench, const Tolerance& tolerance) {
    checkReference(bench, tolerance);
    Search search(bench, tolerance);
    ToleranceChoice choice;
    choice.asked = tolerance;
    choice.errorBar = bench.reference().errorBar(tolerance.metric);
    double bound = kSafety * tolerance.value;
    for (int i = 0; i <= kMostTightenings; ++i) {
        const Setting setting = search.run(bound);
        choice.quality = search.qualityOf(setting);
        choice.searchedError = search.errorOf(setting);
        choice.probeSeconds = search.secondsOf(setting);
        choice.heldOutError = bench.verify(choice.quality).of(tolerance.metric);
        choice.reached = std::max(choice.searchedError, choice.heldOutError) + choice.errorBar <= tolerance.value;
        if (choice.reached || choice.searchedError > bound) {
            break;
        }
        // By as much as the half that was not searched is worse, a tenth at least, a half at most.
        bound *= std::clamp(kSafety * tolerance.value / choice.heldOutError, 0.5, 0.9);
    }
    choice.words = wordsOf(choice.quality, bench.knobs());
    choice.limits = limitingKnob(bench, choice.quality, tolerance.metric);
    choice.limiting = limitingWords(choice.limits, tolerance.metric);
    return choice;
}

Limiting limitingKnob(Bench& bench, const Quality& quality, ErrorMetric metric) {
    Limiting limits;
    limits.error = limits.rest = bench.measure(quality).error.of(metric);
    for (const KnobLevels& knob : bench.knobs()) {
        const Quality raised = withLevel(quality, knob, knob.best());
        const double rest = raised == quality ? limits.error : bench.measure(raised).error.of(metric);
        if (rest < limits.rest) {
            limits.rest = rest;
            limits.knob = knob.knob;
            limits.best = knob.words.back();
        }
    }
    return limits;
}

std::string limitingWords(const Limiting& limits, ErrorMetric metric) {
    if (!limits.knob) {
        return "Nothing that can be set makes the error of " + amount(limits.error, metric) + " smaller.";
    }
    return "The error of " + amount(limits.error, metric) + " is limited by the " + nameOf(*limits.knob) +
           ": at its best (" + limits.best + ") " + amount(limits.rest, metric) + " would be left.";
}

} // namespace limner::accuracy
