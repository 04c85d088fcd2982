#include "core/figure/presets.h"

#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/figure/figure_json.h"
#include "core/figure/fitted_view.h"
#include "core/figure/label_look.h"
#include "core/figure/scan_facts.h"
#include "core/style/lit_sphere.h"
#include "core/style/transfer_function.h"
#include "core/volume/cleanup.h"

#include <nlohmann/json.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>

namespace limner {

namespace {

using Json = nlohmann::ordered_json;

struct Preset {
    PresetCard card;
    int rank = 0; ///< order in lists
    Json json;
};

[[noreturn]] void badPreset(const std::filesystem::path& path, const std::string& why) {
    throw Error(ErrorKind::badInput, {"cannot read the preset", path.string(), why, "install Limner anew"});
}

Preset loadPreset(const std::filesystem::path& path) {
    std::ifstream file(path);
    try {
        Preset preset;
        preset.json = Json::parse(file);
        preset.card = {path.stem().string(), preset.json.at("name"), preset.json.at("help"),
                       preset.json.at("modality")};
        preset.rank = preset.json.at("rank");
        if (!preset.json.at("figure").is_object()) {
            badPreset(path, "\"figure\" is not an object");
        }
        return preset;
    } catch (const nlohmann::json::exception& e) {
        badPreset(path, e.what());
    }
}

std::vector<Preset> loadPresets() {
    const std::filesystem::path folder = resourcesFolder() / "presets";
    std::vector<Preset> presets;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
        if (entry.path().extension() == ".json") {
            presets.push_back(loadPreset(entry.path()));
        }
    }
    if (presets.empty()) {
        badPreset(folder, missing ? missing.message() : "no preset in this folder");
    }
    std::sort(presets.begin(), presets.end(), [](const Preset& a, const Preset& b) {
        return std::pair(a.rank, a.card.id) < std::pair(b.rank, b.card.id);
    });
    return presets;
}

const std::vector<Preset>& allPresets() {
    static const std::vector<Preset> presets = loadPresets();
    return presets;
}

const Preset& findPreset(const std::string& id) {
    std::string known;
    for (const Preset& preset : allPresets()) {
        if (preset.card.id == id) {
            return preset;
        }
        known += ", " + preset.card.id;
    }
    throw Error(ErrorKind::usage, {"there is no such preset", id, "", "known are: auto" + known});
}

/// The preset that `auto` takes for a kind of scan.
const char* presetFor(ScanKind kind) {
    switch (kind) {
    case ScanKind::constant:
    case ScanKind::slice: return "slice";
    case ScanKind::labels: return "regions";
    case ScanKind::ctHead: return "skin-over-bone";
    case ScanKind::ctBody: return "torso-bones";
    case ScanKind::ctContrast: return "heart-and-aorta";
    case ScanKind::ctSlab: return "section";
    case ScanKind::ctWindowed: return "windowed-ct";
    case ScanKind::mrHead: return "brain";
    case ScanKind::vessels: return "vessels";
    case ScanKind::machined: return "industrial";
    case ScanKind::specimen: break;
    }
    return "specimen";
}

std::string sayKind(ScanKind kind) {
    switch (kind) {
    case ScanKind::constant: return "a volume of one value";
    case ScanKind::slice: return "a single slice";
    case ScanKind::labels: return "labelled regions";
    case ScanKind::ctHead: return "CT of a head";
    case ScanKind::ctBody: return "CT of a trunk";
    case ScanKind::ctContrast: return "CT with contrast medium";
    case ScanKind::ctSlab: return "CT of a few slices";
    case ScanKind::ctWindowed: return "CT that was windowed to 8 bits";
    case ScanKind::mrHead: return "MR of a head";
    case ScanKind::vessels: return "an angiography";
    case ScanKind::machined: return "a made part";
    case ScanKind::specimen: break;
    }
    return "a specimen";
}

// ---- anchors ----------------------------------------------------------------------------------------------------

/// Replaces anchored values ("hu:300", "p0.98") by numbers, wherever a text stands that is an anchor of this scan.
void resolveAnchors(Json& json, const ScanFacts& facts, const std::string& key) {
    if (json.is_structured()) {
        for (auto it = json.begin(); it != json.end(); ++it) {
            resolveAnchors(*it, facts, json.is_object() ? it.key() : key);
        }
    } else if (json.is_string() && (key == "at" || key == "opacity" || key == "above")) {
        const auto value = resolveAnchor(facts, json.get<std::string>());
        if (!value) {
            throw Error(ErrorKind::usage, {"the preset does not fit this volume", "",
                                           "its value " + json.get<std::string>() + " means nothing here",
                                           "choose another preset, or auto"});
        }
        json = *value;
    }
}

/// Anchors of unlike kinds may cross on unusual data; curves must rise all the same.
void sortCurves(Layer& layer) {
    double last = -std::numeric_limits<double>::infinity();
    for (glm::dvec2& point : layer.transfer.opacity) {
        last = point.x = std::max(point.x, last);
    }
    last = -std::numeric_limits<double>::infinity();
    for (TransferNode& node : layer.transfer.nodes) {
        last = node.at = std::max(node.at, last);
    }
}

void resolveStyles(Figure& figure) {
    const std::string prefix = "bundled:";
    for (StyleEntry& entry : figure.styles) {
        if (!entry.file.starts_with(prefix)) {
            continue;
        }
        if (const Style* style = findBundledStyle(entry.file.substr(prefix.size()))) {
            entry.name = style->card.name;
            entry.credit = style->card.credit;
            entry.licence = style->card.licence;
            entry.sphere = style->sphere;
        }
    }
}

/// One colour per label, from cool to warm: linear interpolation between two labels passes those between them, so
/// neighbours in number must look alike.
Layer regionsLayer(const ScanFacts& facts) {
    constexpr int kMostRegions = 512;
    const glm::dvec3 ramp[] = {{0.80, 0.47, 0.40}, {0.86, 0.70, 0.46}, {0.55, 0.68, 0.52}, {0.42, 0.57, 0.70}};
    Layer layer;
    layer.name = "Regions";
    layer.shading = Shading::phong;
    const int last = std::clamp(static_cast<int>(std::lround(facts.histogram.range.high)), 1, kMostRegions);
    for (int label = 1; label <= last; ++label) {
        const double at = last > 1 ? 3.0 * (label - 1) / (last - 1) : 0;
        const int low = std::min(static_cast<int>(at), 2);
        const glm::dvec3 rgb = glm::mix(ramp[low], ramp[low + 1], at - low);
        layer.transfer.nodes.push_back({label - 0.5, "", rgb});
        layer.transfer.nodes.push_back({label + 0.5, "", rgb});
    }
    layer.transfer.opacity = {{0.4, 0}, {0.6, 1}};
    return layer;
}

constexpr const char* kLabelled = "labelled";

using Labels = std::optional<LabelReference>;

Figure labelledLook(const Figure& figure, const Labels& labels, std::vector<std::string>& notes) {
    if (!labels) {
        throw Error(ErrorKind::usage, {"the preset does not fit this scan", kLabelled, "the figure has no labels",
                                       "open the scan with a label volume (--labels FILE)"});
    }
    return withLabels(figure, *labels, notes);
}

/// The preset's figure for a scan: styles, layers, quality, labels; no camera.
Figure lookOf(const Preset& preset, const ScanFacts& facts, const Labels& labels, std::vector<std::string>& notes) {
    Json json = preset.json.at("figure");
    resolveAnchors(json, facts, "");
    json["limner"] = 1;
    Figure figure = readFigure(json.dump(), "preset " + preset.card.id);
    if (preset.card.id == "regions") {
        figure.layers = {regionsLayer(facts)};
    }
    for (Layer& layer : figure.layers) {
        sortCurves(layer);
    }
    resolveStyles(figure);
    figure.labels = labels;
    return preset.card.id == kLabelled ? labelledLook(figure, labels, notes) : figure;
}

// ---- clean-up ---------------------------------------------------------------------------------------------------

struct Cleaned {
    std::vector<CleanupStep> steps;
    std::shared_ptr<const Volume> volume;
};

CleanupStep cleanupStep(const Json& rule, const ScanFacts& facts, const Grid& grid) {
    CleanupStep step;
    step.above = resolveAnchor(facts, rule.at("above").get<std::string>()).value_or(facts.otsu);
    step.kind = rule.at("kind") == "remove-islands" ? CleanupKind::removeIslands : CleanupKind::keepLargest;
    step.openingMm = rule.value("opening_mm", rule.value("opening_voxels", 0.0) * grid.smallestSpacingMm());
    const glm::dvec3 size = grid.sizeMm();
    step.belowMm3 = rule.value("below_share", 0.0) * size.x * size.y * size.z; // of the volume's box
    return step;
}

/// Share of the matter that a step took away.
double removedShare(const Volume& before, const Volume& after, double above) {
    const auto matter = [above](const Volume& volume) {
        constexpr int kBins = 1024;
        const Histogram h = computeHistogram(volume, kBins);
        double sum = 0;
        for (std::size_t i = 0; i < h.counts.size(); ++i) {
            sum += h.binCentre(i) > above ? static_cast<double>(h.counts[i]) : 0;
        }
        return sum;
    };
    const double all = matter(before);
    return all > 0 ? 1 - matter(after) / all : 0;
}

/// Runs the preset's clean-up rules and keeps those that change something.
Cleaned cleanSubject(const Preset& preset, const ScanFacts& facts, const std::shared_ptr<const Volume>& volume,
                     std::vector<std::string>& notes) {
    Cleaned cleaned{{}, volume};
    for (const Json& rule : preset.json.value("cleanup", Json::array())) {
        const CleanupStep step = cleanupStep(rule, facts, volume->grid());
        Task task;
        auto next = applyCleanup(cleaned.volume, nullptr, {step}, 1, task);
        if (next == cleaned.volume) {
            continue;
        }
        const double share = removedShare(*cleaned.volume, *next, step.above);
        if (share < rule.value("at_least", 0.0) || share > rule.value("at_most", 1.0)) {
            continue; // not what the rule is for: a holder is large, a table is small beside the subject
        }
        cleaned.volume = std::move(next);
        cleaned.steps.push_back(step);
        notes.push_back(rule.at("note").get<std::string>() + " (clean-up step " + std::to_string(cleaned.steps.size()) +
                        ", \"" + rule.at("kind").get<std::string>() + "\"; delete it to have everything back).");
    }
    return cleaned;
}

// ---- camera -----------------------------------------------------------------------------------------------------

constexpr int kCurveEntries = 4096; // of the visibility table: finer than any threshold needs

Shows whatShows(const Figure& figure, const Volume& volume) {
    constexpr double kFaint = 0.04; // opacity per voxel below which nobody misses it at the edge of the picture
    const ValueRange range = volume.range();
    auto table = std::make_shared<std::vector<std::uint8_t>>(kCurveEntries);
    const double scale = range.high > range.low ? (kCurveEntries - 1) / (range.high - range.low) : 0;
    for (int i = 0; i < kCurveEntries; ++i) {
        const double value = scale > 0 ? range.low + i / scale : range.low;
        for (const Layer& layer : figure.layers) {
            if (figure.draws(layer) && layer.opacity * curveOpacityAt(layer.transfer, value) > kFaint) {
                (*table)[static_cast<std::size_t>(i)] = 1;
            }
        }
    }
    Shows shows;
    shows.value = [table, range, scale](double value) {
        const double entry = std::clamp((value - range.low) * scale, 0.0, kCurveEntries - 1.0);
        return static_cast<int>((*table)[static_cast<std::size_t>(entry)]);
    };
    shows.place = [planes = figure.clip.planes](const glm::dvec3& p) {
        return std::all_of(planes.begin(), planes.end(),
                           [&](const ClipPlane& plane) { return glm::dot(plane.normal, p) <= plane.offsetMm; });
    };
    return shows;
}

/// Looks at a single slice head on, as films are hung: anterior or superior up, the patient's left on the right.
Camera sliceCamera(const Grid& grid) {
    int across = 0;
    for (int axis = 1; axis < 3; ++axis) {
        across = grid.dims[axis] <= grid.dims[across] ? axis : across;
    }
    Camera camera;
    camera.direction = grid.direction[across];
    const glm::dvec3 a = grid.direction[(across + 1) % 3];
    const glm::dvec3 b = grid.direction[(across + 2) % 3];
    const bool upright = std::max(std::abs(a.z), std::abs(b.z)) > 0.5;
    const glm::dvec3 wanted = upright ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
    camera.up = std::abs(glm::dot(a, wanted)) > std::abs(glm::dot(b, wanted)) ? a : b;
    camera.up *= glm::dot(camera.up, wanted) < 0 ? -1.0 : 1.0;
    const glm::dvec3 right = glm::cross(camera.direction, camera.up);
    if (right.x + 0.5 * right.y < 0) {
        camera.direction = -camera.direction;
    }
    return camera;
}

void aim(Figure& figure, const Preset& preset, const Volume& volume) {
    Shows shows = whatShows(figure, volume);
    if (preset.json.contains("cut")) { // share of the subject's height that stays, from below
        if (const auto box = boxOfMatter(volume, shows)) {
            const double height = preset.json.at("cut").get<double>();
            figure.clip.planes.push_back({{0, 0, 1}, box->low.z + height * (box->high.z - box->low.z)});
            shows = whatShows(figure, volume);
        }
    }
    Camera camera = standardView(volume, StandardView::threeQuarter);
    if (preset.card.id == "slice") {
        camera = sliceCamera(volume.grid());
    } else if (preset.json.contains("direction")) {
        const auto d = preset.json.at("direction").get<std::array<double, 3>>();
        camera.direction = {d[0], d[1], d[2]};
    }
    if (drawsByLabel(figure)) {
        shows.value = [](double label) { return label > 0 ? 1 : 0; };
        figure.camera = fittedCamera(*figure.labels->data, camera, shows);
    } else {
        figure.camera = fittedCamera(volume, camera, shows);
    }
}

std::string choose(const std::string& preset, const ScanFacts& facts, const Labels& labels,
                   std::vector<std::string>& notes) {
    if (preset != "auto") {
        return preset;
    }
    if (labels && labels->data) {
        notes.push_back(std::string("There are labels. Drawn by the preset \"") + kLabelled + "\".");
        return kLabelled;
    }
    const std::string chosen = presetFor(facts.kind);
    std::string note = "Taken for " + sayKind(facts.kind);
    if (!facts.why.empty()) {
        note += ": " + facts.why;
    }
    if (facts.huIntercept && *facts.huIntercept != 0) {
        note += " (plus " + std::to_string(std::lround(*facts.huIntercept)) + ")";
    }
    notes.push_back(note + ". Drawn by the preset \"" + chosen + "\".");
    return chosen;
}

} // namespace

const std::vector<PresetCard>& bundledPresets() {
    static const std::vector<PresetCard> cards = [] {
        std::vector<PresetCard> list = {
            {"auto", "Automatic", "Reads the scan's values and picks the preset that suits it.", "any"}};
        for (const Preset& preset : allPresets()) {
            list.push_back(preset.card);
        }
        return list;
    }();
    return cards;
}

Figure figureFromPreset(const std::string& preset, std::shared_ptr<const Volume> volume,
                        std::vector<std::string>& notes, const Labels& labels) {
    const ScanFacts facts = examineScan(*volume);
    const Preset& chosen = findPreset(choose(preset, facts, labels, notes));
    Figure figure = lookOf(chosen, facts, labels, notes);
    figure.title = chosen.card.name;
    Cleaned cleaned = cleanSubject(chosen, facts, volume, notes);
    figure.cleanup = std::move(cleaned.steps);
    aim(figure, chosen, *cleaned.volume);
    figure.volume = VolumeReference{};
    figure.volume->data = std::move(volume);
    return figure;
}

Figure withPreset(const Figure& figure, const std::string& preset, std::vector<std::string>& notes) {
    if (!figure.volume || !figure.volume->data) {
        throw Error(ErrorKind::usage, {"cannot apply the preset", preset, "the figure has no volume to measure",
                                       "load the volume first"});
    }
    const ScanFacts facts = examineScan(*figure.volume->data);
    const Preset& chosen = findPreset(choose(preset, facts, figure.labels, notes));
    Figure look = lookOf(chosen, facts, figure.labels, notes);
    Figure changed = figure;
    changed.styles = std::move(look.styles);
    changed.layers = std::move(look.layers);
    changed.quality = look.quality;
    return changed;
}

} // namespace limner
