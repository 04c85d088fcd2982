#include "renderer/accuracy/knobs.h"

#include "core/volume/gradient_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace limner::accuracy {

namespace {

/// Copies one knob's member.
void copyKnob(const Quality& from, Quality& to, Knob knob) {
    switch (knob) {
    case Knob::step: to.stepVoxels = from.stepVoxels; break;
    case Knob::preintegration: to.preintegration = from.preintegration; break;
    case Knob::termination: to.earlyTermination = from.earlyTermination; break;
    case Knob::tableEntries: to.tableEntries = from.tableEntries; break;
    case Knob::precision: to.precision = from.precision; break;
    case Knob::interpolation: to.interpolation = from.interpolation; break;
    case Knob::gradient: to.gradient = from.gradient; break;
    case Knob::samplesPerPixel: to.samplesPerPixel = from.samplesPerPixel; break;
    }
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

template <typename Member, typename Value>
void addLevel(KnobLevels& knob, Member Quality::*member, Value value, const std::string& word) {
    Quality level;
    level.*member = value;
    knob.levels.push_back(level);
    knob.words.push_back(word);
}

bool uses(const RenderPlan& plan, const char* feature) {
    return std::any_of(plan.featuresUsed.begin(), plan.featuresUsed.end(),
                       [&](const PlanFeature& used) { return used.name == feature; });
}

const char* wordOf(Interpolation interpolation) {
    switch (interpolation) {
    case Interpolation::tricubic: return "tricubic";
    case Interpolation::smooth: return "smooth";
    case Interpolation::automatic:
    case Interpolation::linear: break;
    }
    return "linear";
}

const char* wordOf(GradientEstimator gradient) {
    switch (gradient) {
    case GradientEstimator::sobel: return "sobel";
    case GradientEstimator::neumann: return "neumann";
    case GradientEstimator::fourthOrder: return "fourth-order";
    case GradientEstimator::bspline: return "b-spline";
    case GradientEstimator::automatic:
    case GradientEstimator::central: break;
    }
    return "central";
}

/// What says what is drawn: cheaper levels than the figure's own are errors, better ones another picture.
void addModelKnobs(std::vector<KnobLevels>& knobs, const Quality& figure, const RenderPlan& plan) {
    if (plan.interpolation != Interpolation::linear) {
        KnobLevels knob{Knob::interpolation, {}, {}, true};
        addLevel(knob, &Quality::interpolation, Interpolation::linear, "linear");
        addLevel(knob, &Quality::interpolation, figure.interpolation, wordOf(plan.interpolation));
        knobs.push_back(knob);
    }
    if (readsNormal(plan) && plan.gradient != GradientEstimator::central) {
        KnobLevels knob{Knob::gradient, {}, {}, true};
        addLevel(knob, &Quality::gradient, GradientEstimator::central, "central");
        addLevel(knob, &Quality::gradient, figure.gradient, wordOf(plan.gradient));
        knobs.push_back(knob);
    }
    if (figure.samplesPerPixel >= 4) {
        KnobLevels knob{Knob::samplesPerPixel, {}, {}, true};
        for (int rays = 1; rays <= std::min(figure.samplesPerPixel, 16); rays *= 4) {
            addLevel(knob, &Quality::samplesPerPixel, rays, std::to_string(rays));
        }
        knobs.push_back(knob);
    }
}

/// Width of a table's narrowest peak, in entries: between the places left and right of a maximum where the opacity is
/// half as large. Infinite where nothing rises and falls again.
double narrowestPeak(const std::vector<float>& opacity) {
    double narrowest = std::numeric_limits<double>::infinity();
    const auto count = static_cast<std::ptrdiff_t>(opacity.size());
    for (std::ptrdiff_t i = 1; i + 1 < count; ++i) {
        const auto at = [&](std::ptrdiff_t k) { return opacity[static_cast<std::size_t>(k)]; };
        if (at(i) <= 0 || at(i) <= at(i - 1) || at(i) < at(i + 1)) {
            continue; // no rise ends here
        }
        std::ptrdiff_t left = i;
        std::ptrdiff_t right = i;
        for (; left >= 0 && at(left) > at(i) / 2 && at(left) <= at(i); --left) {
        }
        for (; right < count && at(right) > at(i) / 2 && at(right) <= at(i); ++right) {
        }
        if (left >= 0 && right < count && at(left) <= at(i) / 2 && at(right) <= at(i) / 2) {
            narrowest = std::min(narrowest, static_cast<double>(right - left));
        }
    }
    return narrowest;
}

} // namespace

const char* nameOf(Knob knob) {
    switch (knob) {
    case Knob::step: return "step";
    case Knob::preintegration: return "pre-integration";
    case Knob::termination: return "early end";
    case Knob::tableEntries: return "table entries";
    case Knob::precision: return "voxels";
    case Knob::interpolation: return "interpolation";
    case Knob::gradient: return "gradient";
    case Knob::samplesPerPixel: break;
    }
    return "rays per pixel";
}

const std::vector<Knob>& allKnobs() {
    static const std::vector<Knob> all = {Knob::step,         Knob::preintegration, Knob::termination,
                                          Knob::tableEntries, Knob::precision,      Knob::interpolation,
                                          Knob::gradient,     Knob::samplesPerPixel};
    return all;
}

Quality withLevel(const Quality& quality, const KnobLevels& knob, std::size_t level) {
    Quality changed = quality;
    copyKnob(knob.levels[level], changed, knob.knob);
    return changed;
}

std::vector<KnobLevels> knobsOf(const Quality& figure, const RenderPlan& plan) {
    std::vector<KnobLevels> knobs;
    KnobLevels step{Knob::step, {}, {}, true};
    for (const double voxels : {2.0, 1.0, 0.5, 0.25, 0.125, 0.0625}) {
        addLevel(step, &Quality::stepVoxels, voxels, number(voxels));
    }
    knobs.push_back(step);
    if (uses(plan, "pre-integration")) {
        KnobLevels knob{Knob::preintegration, {}, {}, true};
        addLevel(knob, &Quality::preintegration, false, "off");
        addLevel(knob, &Quality::preintegration, true, "on");
        knobs.push_back(knob);
    }
    KnobLevels termination{Knob::termination, {}, {}, true};
    for (const double left : {0.05, 0.01, 0.001, 0.0001, 0.0}) {
        addLevel(termination, &Quality::earlyTermination, left, number(left));
    }
    knobs.push_back(termination);
    KnobLevels table{Knob::tableEntries, {}, {}, false};
    for (const int entries : {256, 1024, 4096}) {
        addLevel(table, &Quality::tableEntries, entries, std::to_string(entries));
    }
    addLevel(table, &Quality::tableEntries, 0, "all it needs");
    knobs.push_back(table);
    KnobLevels precision{Knob::precision, {}, {}, false};
    addLevel(precision, &Quality::precision, VoxelPrecision::eightBits, "8-bit");
    addLevel(precision, &Quality::precision, VoxelPrecision::full, "full");
    knobs.push_back(precision);
    addModelKnobs(knobs, figure, plan);
    return knobs;
}

Quality bestQuality(const Quality& figure, const std::vector<KnobLevels>& knobs) {
    Quality best = figure;
    for (const KnobLevels& knob : knobs) {
        best = withLevel(best, knob, knob.best());
    }
    return best;
}

std::string levelWord(const Quality& quality, const KnobLevels& knob) {
    for (std::size_t i = 0; i < knob.levels.size(); ++i) {
        if (withLevel(quality, knob, i) == quality) {
            return knob.words[i];
        }
    }
    switch (knob.knob) { // a figure may set what no study would try
    case Knob::step: return number(quality.stepVoxels);
    case Knob::termination: return number(quality.earlyTermination);
    case Knob::tableEntries: return std::to_string(quality.tableEntries);
    default: return "as set";
    }
}

std::string wordsOf(const Quality& quality, const std::vector<KnobLevels>& knobs) {
    std::string words;
    for (const KnobLevels& knob : knobs) {
        if (knob.searched) {
            words += std::string(words.empty() ? "" : ", ") + nameOf(knob.knob) + " " + levelWord(quality, knob);
        }
    }
    return words;
}

StepLimit stepLimit(const RenderPlan& plan, bool preintegration) {
    StepLimit limit{0.5, "half a voxel: what lies between voxels is not missed"};
    if (preintegration) {
        return limit;
    }
    double slope = 0; // of the value, per voxel; measured where a layer asks for it
    for (const PlanLayer& layer : plan.layers) {
        const double peak = layer.table.rows == 0 && layer.table.axisX == TransferAxis::value
                                ? narrowestPeak(layer.table.opacity)
                                : std::numeric_limits<double>::infinity();
        if (!std::isfinite(peak)) {
            continue;
        }
        if (slope == 0) {
            slope = computeGradientStatistics(*plan.volume).p999 * plan.referenceLengthMm;
        }
        const double width =
            peak * (layer.table.high - layer.table.low) / static_cast<double>(layer.table.opacity.size() - 1);
        if (slope > 0 && 0.5 * width / slope < limit.voxels) {
            limit.voxels = 0.5 * width / slope;
            limit.reason = "the peak of " + number(width) + " in \"" + layer.name +
                           "\" would be stepped over where the scan is steepest (" + number(slope) + " per voxel)";
        }
    }
    return limit;
}

} // namespace limner::accuracy
