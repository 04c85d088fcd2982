#pragma once

#include "renderer/accuracy/line_error.h"
#include "renderer/accuracy/tolerance.h"

#include <optional>
#include <string>
#include <vector>

namespace limner::accuracy {

/// What a study asks.
struct StudyOptions {
    ErrorMetric metric = ErrorMetric::ciede2000; ///< of hull, limiting knob and charts
    std::optional<Tolerance> tolerance;          ///< besides the named ones
    /// Whose interpolation, gradients and rays per pixel are the model, where the figure's own were found for a
    /// tolerance and are cheaper than what it asked for; nothing: the figure's.
    std::optional<Quality> model;
    std::vector<Knob> knobs;   ///< empty: all that can change the picture
    double secondsBudget = 60; ///< no measurement begins after that
    bool judged = true;        ///< the double-precision ray caster says how far the reference's arithmetic is off
};

/// One measured quality.
struct StudyRow {
    std::string method; ///< what it shows: "present", "step by point samples", "early end", "for print", ...
    std::string words;  ///< its settings
    Measured measured;
    double pictureSeconds = 0; ///< of the whole picture: the probe's time by what the present settings take
};

/// How the error falls as the step is halved, all else at its best.
struct StudySeries {
    std::string method;
    std::vector<std::size_t> rows; ///< of the study, from the longest step on
    double order = 0;              ///< observed: by the two longest stretches of halvings above the reference's bar
    bool ordered = false;          ///< there were such
};

/// What one knob alone takes away from the best picture.
struct KnobBudget {
    Knob knob = Knob::step;
    std::string present; ///< its level in the figure
    double error = 0;    ///< with that level and all else at its best
};

/// Error against run time of one figure (spec accuracy.md 1.8).
struct Study {
    std::string title;
    std::string backend;
    glm::ivec2 size{0};
    double probePixels = 0;
    ErrorMetric metric = ErrorMetric::ciede2000;
    double errorBar = 0;       ///< of the reference, in the study's metric
    double referenceStep = 0;  ///< its finest, voxels
    double referenceOrder = 0; ///< observed between its steps
    bool extrapolated = false;
    PictureError arithmetic; ///< see ModelReference
    std::vector<StudyRow> rows;
    std::size_t present = 0; ///< row of the figure as it is
    std::vector<StudySeries> series;
    std::vector<KnobBudget> budget;
    std::vector<std::size_t> pareto; ///< rows that no other one beats in both, by time
    std::vector<std::pair<std::string, ToleranceChoice>> choices;
    StepLimit limit;
    Limiting limits;      ///< of the figure as it is
    std::string limiting; ///< the same as one sentence
    int leftOut = 0;      ///< settings that were not measured: the time was up
    std::vector<std::string> notes;
    double seconds = 0;           ///< that the study took
    LineError lines;              ///< of contours and silhouettes, as it is against the best
    std::vector<float> perceived; ///< perceivedDifferences of the two pictures below; empty: there is no best
    Picture picture;              ///< the figure as it is, whole
    Picture best;                 ///< with everything at its best; the difference of the two is the error map
};

/// Runs it: progress goes through the task, which also cancels. Throws Error(notFinite), Error(cancelled).
Study runStudy(const Figure& figure, const PlanRequest& request, const Backend& backend, const StudyOptions& options,
               Task& task);

/// The error of every pixel (colour differences, row by row) as a picture: from clear over yellow and red to black,
/// black from `worst` on. Lies over the figure's picture.
Picture errorMap(const std::vector<float>& errors, glm::ivec2 size, double worst);

/// A report for people, a table, and facts for programs (spec figure-document.md: keys of `accuracy`).
std::string reportHtml(const Study& study, const Figure& figure);
std::string reportCsv(const Study& study);
std::string reportJson(const Study& study);

} // namespace limner::accuracy
