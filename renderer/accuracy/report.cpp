#include "renderer/accuracy/study.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace limner::accuracy {

namespace {

using Facts = nlohmann::ordered_json;

Facts errorFacts(const PictureError& error) {
    Facts facts{{"rmse", error.rmse},
                {"max", error.largest},
                {"max_999", error.most999},
                {"ciede2000_mean", error.meanColour},
                {"ciede2000_p95", error.p95Colour},
                {"ciede2000_max", error.largestColour},
                {"non_finite", error.notFinite}};
    if (std::isfinite(error.psnr())) {
        facts["psnr_db"] = error.psnr();
    }
    return facts;
}

/// What of a quality a study may change, by the figure document's names.
Facts knobFacts(const Quality& quality) {
    return {{"step_voxels", quality.stepVoxels},
            {"preintegration", quality.preintegration},
            {"early_termination", quality.earlyTermination},
            {"table_entries", quality.tableEntries},
            {"samples_per_pixel", quality.samplesPerPixel}};
}

Facts choiceFacts(const std::string& name, const ToleranceChoice& choice) {
    return {{"name", name},
            {"metric", nameOf(choice.asked.metric)},
            {"tolerance", choice.asked.value},
            {"reached", choice.reached},
            {"settings", choice.words},
            {"knobs", knobFacts(choice.quality)},
            {"error_searched", choice.searchedError},
            {"error_held_out", choice.heldOutError},
            {"error_bar", choice.errorBar},
            {"limiting_knob", choice.limiting}};
}

Facts rowFacts(const Study& study) {
    Facts rows = Facts::array();
    for (const StudyRow& row : study.rows) {
        Facts facts{{"method", row.method},
                    {"settings", row.words},
                    {"knobs", knobFacts(row.measured.quality)},
                    {"seconds", row.pictureSeconds},
                    {"probe_seconds", row.measured.seconds},
                    {"probe_seconds_median", row.measured.median},
                    {"probe_seconds_iqr", row.measured.spread},
                    {"samples", row.measured.samples}};
        facts.update(errorFacts(row.measured.error));
        rows.push_back(facts);
    }
    return rows;
}

} // namespace

std::string reportJson(const Study& study) {
    Facts orders = Facts::array();
    for (const StudySeries& series : study.series) {
        orders.push_back({{"method", series.method},
                          {"observed", series.ordered ? Facts(series.order) : Facts(nullptr)},
                          {"rows", series.rows}});
    }
    Facts budget = Facts::array();
    for (const KnobBudget& knob : study.budget) {
        budget.push_back({{"knob", nameOf(knob.knob)}, {"present", knob.present}, {"error", knob.error}});
    }
    Facts choices = Facts::array();
    for (const auto& [name, choice] : study.choices) {
        choices.push_back(choiceFacts(name, choice));
    }
    Facts lines = nullptr;
    if (study.lines.any) {
        lines = {{"mean_distance_px", study.lines.meanDistance},
                 {"p95_distance_px", study.lines.p95Distance},
                 {"disagreement", study.lines.disagreement}};
    }
    Facts perceived = nullptr;
    if (!study.perceived.empty()) {
        const ColourSummary seen = summaryOf(study.perceived);
        perceived = {{"mean", seen.mean}, {"p95", seen.p95}, {"max", seen.largest}};
    }
    const Facts facts{{"title", study.title},
                      {"backend", study.backend},
                      {"width", study.size.x},
                      {"height", study.size.y},
                      {"probe_pixels", study.probePixels},
                      {"metric", nameOf(study.metric)},
                      {"reference",
                       {{"kind", "model"},
                        {"error_bar", study.errorBar},
                        {"step_voxels", study.referenceStep},
                        {"observed_order", study.referenceOrder},
                        {"extrapolated", study.extrapolated},
                        {"arithmetic", errorFacts(study.arithmetic)}}},
                      {"rows", rowFacts(study)},
                      {"pareto", study.pareto},
                      {"orders", orders},
                      {"budget", budget},
                      {"lines", lines},
                      {"perceived", perceived},
                      {"present", study.present},
                      {"choices", choices},
                      {"limiting_knob", study.limiting},
                      {"step_limit_voxels", study.limit.voxels},
                      {"step_limit_reason", study.limit.reason},
                      {"notes", study.notes},
                      {"study_seconds", study.seconds}};
    return facts.dump(2, ' ', false, Facts::error_handler_t::replace) + "\n";
}

std::string reportCsv(const Study& study) {
    std::ostringstream out;
    out.precision(8);
    out << "method,settings,step_voxels,preintegration,early_termination,table_entries,samples_per_pixel,"
           "seconds,probe_seconds,probe_seconds_median,probe_seconds_iqr,rmse,max,max_999,psnr_db,ciede2000_mean,"
           "ciede2000_p95,ciede2000_max,pareto,present\n";
    for (std::size_t i = 0; i < study.rows.size(); ++i) {
        const StudyRow& row = study.rows[i];
        const Quality& q = row.measured.quality;
        const PictureError& e = row.measured.error;
        const bool hull = std::find(study.pareto.begin(), study.pareto.end(), i) != study.pareto.end();
        out << row.method << ",\"" << row.words << "\"," << q.stepVoxels << ',' << q.preintegration << ','
            << q.earlyTermination << ',' << q.tableEntries << ',' << q.samplesPerPixel << ',' << row.pictureSeconds
            << ',' << row.measured.seconds << ',' << row.measured.median << ',' << row.measured.spread << ',' << e.rmse
            << ',' << e.largest << ',' << e.most999 << ',' << e.psnr() << ',' << e.meanColour << ',' << e.p95Colour
            << ',' << e.largestColour << ',' << hull << ',' << (i == study.present) << '\n';
    }
    return out.str();
}

} // namespace limner::accuracy
