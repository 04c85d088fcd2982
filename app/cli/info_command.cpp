#include "app/cli/info_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "core/figure/quantity.h"
#include "core/volume/histogram.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

constexpr const char* kExamples = R"(Examples:
  limner info head.nii.gz
  limner info dicom-folder --json
  limner info skull.limner
)";

constexpr int kBins = 1024;
constexpr std::size_t kPeaks = 6; // more matters than that no histogram tells apart

const char* modalityName(Modality modality) {
    switch (modality) {
    case Modality::ct: return "CT";
    case Modality::mr: return "MR";
    case Modality::labels: return "labels";
    case Modality::unknown: break;
    }
    return "unknown";
}

Facts triple(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Facts volumeFacts(const Volume& volume, const ImportReport& report) {
    const Grid& grid = volume.grid();
    Facts series = Facts::array();
    for (const SeriesSummary& s : report.series) {
        series.push_back(
            {{"uid", s.uid}, {"description", s.description}, {"modality", s.modality}, {"slices", s.slices}});
    }
    return {{"format", report.format},
            {"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
            {"spacing_mm", triple(grid.spacingMm)},
            {"origin_mm", triple(grid.originMm)},
            {"direction", {triple(grid.direction[0]), triple(grid.direction[1]), triple(grid.direction[2])}},
            {"type", report.type},
            {"range", {volume.range().low, volume.range().high}},
            {"non_finite", volume.contents().nonFinite},
            {"sha256_values", report.sha256Values},
            {"size_mm", triple(grid.sizeMm())},
            {"modality", modalityName(volume.contents().modality)},
            {"unit", volume.contents().unit},
            {"histogram_peaks", computeHistogram(volume, kBins).peaks(kPeaks)},
            {"file_bytes", report.fileBytes},
            {"memory_bytes", volume.bytes()},
            {"quantisation_error", report.quantisationError},
            {"label_names", report.labelNames},
            {"series", series}};
}

std::string join(const Facts& list, const char* between) {
    std::string text;
    for (const Facts& item : list) {
        text += (text.empty() ? "" : between) +
                (item.is_string() ? item.get<std::string>() : numberText(item.get<double>()));
    }
    return text;
}

/// The nearest anatomical direction of an axis: "right to left" for +x in LPS.
std::string anatomical(const Facts& axis) {
    static const char* const kWays[3][2] = {
        {"right to left", "left to right"}, {"front to back", "back to front"}, {"feet to head", "head to feet"}};
    std::size_t largest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(axis[i].get<double>()) > std::abs(axis[largest].get<double>())) {
            largest = i;
        }
    }
    return kWays[largest][axis[largest].get<double>() < 0 ? 1 : 0];
}

std::string volumeText(const Facts& f) {
    const std::string unit = f["unit"].get<std::string>().empty() ? "" : " " + f["unit"].get<std::string>();
    std::string text;
    text += factLine("Format", f["format"].get<std::string>() + ", " + f["type"].get<std::string>() + ", " +
                                   formatBytes(f["file_bytes"].get<std::uint64_t>()));
    text += factLine("Modality", f["modality"].get<std::string>());
    text += factLine("Voxels", join(f["dims"], " x "));
    text += factLine("Spacing", join(f["spacing_mm"], " x ") + " mm");
    text += factLine("Size", join(f["size_mm"], " x ") + " mm");
    text += factLine("Origin", join(f["origin_mm"], ", ") + " mm (first voxel; left, posterior, superior)");
    const Facts& axes = f["direction"];
    text += factLine("Axes", "i " + anatomical(axes[0]) + ", j " + anatomical(axes[1]) + ", k " + anatomical(axes[2]));
    text += factLine("Values", join(f["range"], " to ") + unit);
    text += factLine("Peaks", join(f["histogram_peaks"], ", ") + unit);
    if (f["non_finite"].get<std::size_t>() > 0) {
        text += factLine("Not finite", std::to_string(f["non_finite"].get<std::size_t>()) + " voxels");
    }
    text += factLine("SHA-256", f["sha256_values"].get<std::string>() + " (of the stored numbers)");
    int number = 0;
    for (const Facts& s : f["series"]) {
        text +=
            factLine(number == 0 ? "Series" : "", std::to_string(number + 1) + ": " + s["modality"].get<std::string>() +
                                                      ", " + std::to_string(s["slices"].get<int>()) + " slices, " +
                                                      s["description"].get<std::string>());
        ++number;
    }
    return text;
}

Facts layerFacts(const Layer& layer) {
    static const char* const kShadings[] = {"style", "phong", "flat"};
    Facts styles = Facts::array();
    for (const TransferNode& node : layer.transfer.nodes) {
        if (!node.style.empty() && std::find(styles.begin(), styles.end(), node.style) == styles.end()) {
            styles.push_back(node.style);
        }
    }
    return {{"name", layer.name},
            {"visible", layer.visible},
            {"shading", kShadings[static_cast<std::size_t>(layer.shading)]},
            {"transfer", layer.transfer.kind == TransferKind::oneDimensional ? "1d" : "2d"},
            {"styles", styles}};
}

Facts projectFacts(const Document& document) {
    const Figure& figure = document.figure;
    Facts styles = Facts::array();
    for (const StyleEntry& style : figure.styles) {
        styles.push_back({{"id", style.id}, {"name", style.name}, {"licence", style.licence}});
    }
    Facts layers = Facts::array();
    for (const Layer& layer : figure.layers) {
        layers.push_back(layerFacts(layer));
    }
    Facts facts{
        {"format", document.path.extension() == ".json" ? "figure.json" : "Limner project"},
        {"title", figure.title},
        {"styles", styles},
        {"layers", layers},
        {"cleanup_steps", figure.cleanup.size()},
        {"clip_planes", figure.clip.planes.size()},
        {"annotations", figure.annotations.size()},
        {"importance", figure.importance.has_value()},
        {"stipple", figure.stipple.has_value()},
        {"output",
         {{"width_mm", figure.output.widthMm}, {"height_mm", figure.output.heightMm}, {"dpi", figure.output.dpi}}}};
    Facts volume = nullptr;
    if (figure.volume) {
        volume = {{"path", figure.volume->path}, {"embedded", figure.volume->embedded}};
        volume["found"] = figure.volume->data != nullptr;
        if (figure.volume->data) {
            volume.update(volumeFacts(*figure.volume->data, document.volumeReport));
        }
    }
    facts["volume"] = volume;
    return facts;
}

std::string projectText(const Facts& f) {
    std::string text = factLine("Format", f["format"].get<std::string>());
    text += factLine("Title", f["title"].get<std::string>());
    const Facts& volume = f["volume"];
    if (volume.is_null()) {
        text += factLine("Scan", "none");
    } else {
        text += factLine("Scan", volume["path"].get<std::string>() +
                                     (volume["embedded"].get<bool>() ? " (inside the project)" : "") +
                                     (volume["found"].get<bool>() ? "" : " (not found)"));
    }
    for (const Facts& layer : f["layers"]) {
        text += factLine("Layer", layer["name"].get<std::string>() + (layer["visible"].get<bool>() ? "" : " (hidden)") +
                                      ": " + layer["shading"].get<std::string>() + ", " +
                                      layer["transfer"].get<std::string>() +
                                      (layer["styles"].empty() ? "" : ", " + join(layer["styles"], ", ")));
    }
    for (const Facts& style : f["styles"]) {
        text += factLine("Style", style["id"].get<std::string>() + ": " + style["name"].get<std::string>());
    }
    text += factLine("Clean-up", std::to_string(f["cleanup_steps"].get<std::size_t>()) + " steps");
    text += factLine("Output", numberText(f["output"]["width_mm"].get<double>()) + " x " +
                                   numberText(f["output"]["height_mm"].get<double>()) + " mm at " +
                                   numberText(f["output"]["dpi"].get<double>()) + " dpi");
    return text;
}

} // namespace

void InfoCommand::declare(CLI::App& app) {
    app.description("Shows what a scan or a project holds\n"
                    "Of a scan: format, size, spacing, orientation, values and what was repaired while\n"
                    "reading; of a project: its parts. Space is LPS in mm (x to the patient's left, y to\n"
                    "the back, z to the head).");
    app.footer(kExamples);
    figure_.declareInput(app, "FILE",
                         "A scan of any format that `limner render` reads, a .limner project or a "
                         "figure.json");
    figure_.declareMachine(app);
}

int InfoCommand::run(Console& console) {
    const Document document = figure_.openAsIs(console);
    const bool project = !document.path.empty();
    Facts facts = project ? projectFacts(document) : volumeFacts(*document.figure.volume->data, document.volumeReport);
    facts["warnings"] = console.task().warnings();
    if (console.json) {
        printFacts(console, facts);
    } else {
        console.print(project ? projectText(facts) : volumeText(facts));
    }
    return 0;
}

} // namespace limner::cli
