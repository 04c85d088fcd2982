#pragma once

#include "renderer/plan/render_plan.h"

#include <string>
#include <vector>

namespace limner::accuracy {

/// What trades error against time, one at a time (spec accuracy.md 1.8).
enum class Knob {
    step,
    preintegration,
    termination,
    tableEntries,
    precision,
    interpolation,
    gradient,
    samplesPerPixel,
};

/// The name of a knob on the command line and in reports: "step", "pre-integration", "early end", ...
const char* nameOf(Knob knob);
/// All of them, in the enumeration's order.
const std::vector<Knob>& allKnobs();

/// A knob's levels, each worth a try, from the cheapest to the best; `better` by levels that follow them would be
/// another picture: interpolation, gradient and rays per pixel say what is drawn as much as how well. A figure that
/// asks for linear interpolation is not in error for it, but one that asks for tricubic is where it is drawn linearly.
struct KnobLevels {
    Knob knob = Knob::step;
    std::vector<Quality> levels; ///< of this knob alone; all else as it was
    std::vector<std::string> words;
    /// Whether its cost in time is worth a search: what only takes memory is measured but not chosen.
    bool searched = true;

    [[nodiscard]] std::size_t best() const { return levels.size() - 1; }
};

/// Level `level` of a knob set in `quality`.
Quality withLevel(const Quality& quality, const KnobLevels& knob, std::size_t level);

/// The knobs that can change this picture, with the levels of a study. `plan`: of the figure with everything at its
/// best.
std::vector<KnobLevels> knobsOf(const Quality& figure, const RenderPlan& plan);

/// Everything at its best, on the figure's own model.
Quality bestQuality(const Quality& figure, const std::vector<KnobLevels>& knobs);

/// What a quality has of one knob: "0.25", "on", "tricubic".
std::string levelWord(const Quality& quality, const KnobLevels& knob);
/// "step 0.25, early end 0.001": what of the searched knobs a quality has.
std::string wordsOf(const Quality& quality, const std::vector<KnobLevels>& knobs);

/// The longest step, in voxels, that no measurement may overrule, and why (spec accuracy.md 1.9): half a voxel, and
/// without pre-integration half of what the narrowest peak of a transfer function takes up where the scan is steepest.
struct StepLimit {
    double voxels = 0.5;
    std::string reason;
};
StepLimit stepLimit(const RenderPlan& plan, bool preintegration);

} // namespace limner::accuracy
