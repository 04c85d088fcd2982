#pragma once

#include "renderer/accuracy/knobs.h"
#include "renderer/accuracy/model_reference.h"

#include <optional>
#include <string>
#include <vector>

namespace limner::accuracy {

/// The largest error that a picture may have.
struct Tolerance {
    ErrorMetric metric = ErrorMetric::ciede2000;
    double value = 1.5;
};

/// A reference's own bar must not be over this share of a tolerance that it judges.
inline constexpr double kBarShare = 0.1;

/// Named tolerances (spec accuracy.md 1.9): draft, screen, print and reference, the last changing no 8-bit value by
/// more than one.
struct NamedTolerance {
    const char* name;
    Tolerance tolerance;
};
const std::vector<NamedTolerance>& namedTolerances();

/// One quality as it was measured on the probe.
struct Measured {
    Quality quality;
    PictureError error; ///< against the model reference
    double seconds = 0; ///< of the probe, the least
    double median = 0;  ///< of the probe
    double spread = 0;  ///< of the probe, between the quartiles
    std::uint64_t samples = 0;
};

/// Measures qualities of one figure on its probe, each once. Not thread-safe.
class Bench {
  public:
    Bench(Figure figure, PlanRequest request, const Backend& backend, Task& task);

    /// Levels of every knob, from what the planner says of the figure at its best.
    [[nodiscard]] const std::vector<KnobLevels>& knobs() const { return knobs_; }
    [[nodiscard]] const ModelReference& reference() const { return reference_; }
    [[nodiscard]] const Probe& probe() const { return probe_; }
    [[nodiscard]] const Figure& figure() const { return figure_; }
    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] Quality best() const { return bestQuality(figure_.quality, knobs_); }
    [[nodiscard]] StepLimit limit(bool preintegration) const { return preintegration ? limitWith_ : limitWithout_; }

    /// Draws the reference, to as small a bar as this tolerance takes. `judge`: as `makeModelReference`.
    void makeReference(const Tolerance& tolerance, const Backend* judge);

    const Measured& measure(const Quality& quality);
    /// The same on the tiles that no search has seen.
    PictureError verify(const Quality& quality);
    /// A whole picture, once and without a clock.
    Picture draw(const Quality& quality);
    /// A whole picture, with the seconds that it took.
    ProbePicture whole(const Quality& quality);
    /// Some layer has contours or silhouettes.
    [[nodiscard]] bool hasLines() const;
    /// Where the lines of a whole picture are; `picture`: as `whole` gives it for that quality.
    std::vector<bool> linesOf(const Quality& quality, const Picture& picture);
    [[nodiscard]] std::size_t measurements() const { return measured_.size(); }

    Repeats repeats{5, 0.06};

  private:
    std::shared_ptr<const RenderPlan> planOf(const Quality& quality);

    Figure figure_;
    PlanRequest request_;
    const Backend& backend_;
    Task& task_;
    Planner planner_;
    glm::ivec2 size_{0};
    std::vector<KnobLevels> knobs_;
    StepLimit limitWith_;
    StepLimit limitWithout_;
    Probe probe_;
    ModelReference reference_;
    std::vector<std::unique_ptr<Measured>> measured_;
};

/// What keeps the error of a quality from being smaller.
struct Limiting {
    std::optional<Knob> knob; ///< whose rise to its best leaves the least error; nothing: no knob makes it smaller
    std::string best;         ///< that knob's best level
    double error = 0;
    double rest = 0; ///< with the knob at its best
};

/// The cheapest quality that keeps a tolerance, as found.
struct ToleranceChoice {
    Tolerance asked;
    Quality quality;
    bool reached = false;
    double searchedError = 0; ///< on the searched half of the probe
    double heldOutError = 0;  ///< delivered: on the half that the search has not seen
    double errorBar = 0;      ///< of the reference
    double probeSeconds = 0;  ///< of the searched half
    std::string words;        ///< the settings
    Limiting limits;          ///< what a smaller error would have to change
    std::string limiting;     ///< the same as one sentence
};

/// Greedy search (spec accuracy.md 1.9): from the cheapest levels the knob that removes most error for its time is
/// raised until four fifths of the tolerance are kept, then every knob is lowered while that holds, alone and against
/// another one raised. The step keeps its limit. What is found is verified on the other half of the probe; where that
/// fails, a smaller tolerance is searched, four times at most. Throws Error(notConverged) where the reference's own bar
/// is over a tenth of the tolerance.
ToleranceChoice chooseQuality(Bench& bench, const Tolerance& tolerance);

/// The knob whose error is the greatest in `quality`, of those that can be raised; and the same in one sentence.
Limiting limitingKnob(Bench& bench, const Quality& quality, ErrorMetric metric);
std::string limitingWords(const Limiting& limits, ErrorMetric metric);

} // namespace limner::accuracy
