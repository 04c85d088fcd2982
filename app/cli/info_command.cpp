#include "app/cli/info_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "core/figure/quantity.h"
#include "core/figure/scan_facts.h"
#include "core/volume/derived_fields.h"
#include "core/volume/histogram.h"
#include "core/volume/label_table.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

constexpr const char* kExamples = R"(Examples:
  limner info head.nii.gz
  limner info dicom-folder --json
  limner info organs.nii.gz               # labels: names, voxels and volume of each
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

/// The labels that occur, 0 (none) left out: [{id, name, colour, voxels, ml}]; null where the numbers are no labels.
Facts labelFacts(const Volume& volume, const std::map<int, LabelEntry>& table) {
    const auto counts = labelCounts(volume);
    if (!counts) {
        return nullptr;
    }
    const glm::dvec3 spacing = volume.grid().spacingMm;
    constexpr double kMm3PerMl = 1000;
    const double mlPerVoxel = spacing.x * spacing.y * spacing.z / kMm3PerMl;
    Facts facts = Facts::array();
    for (const auto& [label, voxels] : *counts) {
        if (label == 0) {
            continue;
        }
        const auto known = table.find(label);
        const LabelEntry entry = known == table.end() ? LabelEntry{} : known->second;
        facts.push_back({{"id", label},
                         {"name", entry.name},
                         {"colour", entry.colour.empty() ? Facts(nullptr) : Facts(entry.colour)},
                         {"voxels", voxels},
                         {"ml", static_cast<double>(voxels) * mlPerVoxel}});
    }
    return facts;
}

/// Of a figure's labels, by the names that it has for them.
Facts labelFacts(const LabelReference& labels) {
    std::map<int, LabelEntry> table;
    const auto take = [&](const std::map<std::string, std::string>& words, std::string LabelEntry::*part) {
        for (const auto& [label, word] : words) {
            if (const auto number = Facts::parse(label, nullptr, false); number.is_number_integer()) {
                table[number.get<int>()].*part = word;
            }
        }
    };
    take(labels.names, &LabelEntry::name);
    take(labels.colours, &LabelEntry::colour);
    return labels.data ? labelFacts(*labels.data, table) : Facts(nullptr);
}

std::string labelText(const Facts& labels) {
    constexpr std::size_t kMostLines = 256;
    std::string text;
    for (std::size_t i = 0; i < std::min(labels.size(), kMostLines); ++i) {
        const Facts& label = labels[i];
        const std::string name = label["name"].get<std::string>();
        text +=
            factLine(i == 0 ? "Labels" : "", std::to_string(label["id"].get<int>()) + (name.empty() ? "" : " " + name) +
                                                 ": " + std::to_string(label["voxels"].get<std::size_t>()) +
                                                 " voxels, " + numberText(label["ml"].get<double>()) + " ml");
    }
    if (labels.size() > kMostLines) {
        text += factLine("", std::to_string(labels.size() - kMostLines) + " more (--json has all)");
    }
    return text;
}

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
    return f.contains("labels") ? text + labelText(f["labels"]) : text;
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
    if (figure.labels) {
        facts["labels_path"] = figure.labels->path;
        facts["labels"] = labelFacts(*figure.labels);
    }
    return facts;
}

/// Of a file that is no project.
Facts scanFacts(const Document& document, const std::string& file, Task& task) {
    const Volume& volume = *document.figure.volume->data;
    Facts facts = volumeFacts(volume, document.volumeReport);
    const LabelTable table = readLabelTable(file);
    facts["label_names"] = Facts::object(); // all that the file knows of
    for (const auto& [label, entry] : table.entries) {
        facts["label_names"][std::to_string(label)] = entry.name;
    }
    if (document.figure.labels) {
        facts["labels_path"] = document.figure.labels->path;
        facts["labels"] = labelFacts(*document.figure.labels);
    } else if (volume.contents().modality == Modality::labels || looksLabelled(volume)) {
        for (const std::string& warning : table.warnings) {
            task.warn(warning);
        }
        facts["modality"] = modalityName(Modality::labels);
        facts["labels"] = labelFacts(volume, table.entries);
    }
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
    if (f.contains("labels")) {
        text += factLine("Label volume",
                         f["labels_path"].get<std::string>() + (f["labels"].is_null() ? " (not found)" : ""));
        text += labelText(f["labels"]);
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
                    "reading; of a label volume also the labels that occur; of a project: its parts. Space is LPS in "
                    "mm (x to the patient's left, y to\n"
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
    Facts facts = project ? projectFacts(document) : scanFacts(document, figure_.file(), console.task());
    facts["warnings"] = console.task().warnings();
    if (console.json) {
        printFacts(console, facts);
    } else {
        console.print(project ? projectText(facts) : volumeText(facts));
    }
    return 0;
}

} // namespace limner::cli
