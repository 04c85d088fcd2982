#include "renderer/plan/explain.h"

#include "renderer/plan/plan_layer.h"

#include "core/volume/cleanup.h"
#include "renderer/annotations.h"
#include "renderer/plan/depth_cues.h"
#include "renderer/plan/skip_grid.h"
#include "renderer/plan/style_atlas.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <numeric>

namespace limner {

namespace {

double millisecondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Costs per item on one thread of a server core of 2023; the measured numbers beside them say how this machine differs.
constexpr double kCleanupNsPerVoxel = 15;  // labelling of islands
constexpr double kMinMaxNsPerVoxel = 2;    // 30 ms for 256^3
constexpr double kDistanceNsPerBlock = 70; // 18 ms for 64^3 blocks
constexpr double kTableNsPerEntry = 40;    // two searches and a logarithm
constexpr double kAtlasNsPerTexel = 10;
constexpr double kSweepNsPerCell = 8;
constexpr double kOpacityNsPerVoxel = 4;
constexpr double kRayNs = 200;   // set-up and skipping of a ray
constexpr double kSampleNs = 10; // 105 Msamples/s

std::uint64_t tableBytes(const RenderPlan& plan) {
    std::uint64_t bytes = 0;
    for (const PlanLayer& layer : plan.layers) {
        const TransferTable& table = layer.table;
        bytes += (table.opacity.size() + table.index.size() + table.rowIndex.size() + table.opacity2d.size()) *
                 sizeof(float);
    }
    return bytes;
}

struct Costs {
    const Figure& figure;
    const RenderPlan& plan;
    double threads;
    Task& task;

    [[nodiscard]] double parallelMs(double ns) const { return ns * 1e-6 / threads; }

    [[nodiscard]] PartCost cleanup() const {
        PartCost cost{"clean-up", 0, 0, 0};
        if (figure.cleanup.empty()) {
            return cost;
        }
        const Volume* labels = figure.labels && figure.labels->data ? figure.labels->data.get() : nullptr;
        cost.estimatedMs = parallelMs(kCleanupNsPerVoxel * static_cast<double>(plan.volume->grid().voxelCount()));
        cost.measuredMs = millisecondsOf(
            [&] { applyCleanup(figure.volume->data, labels, figure.cleanup, figure.output.aspect(), task); });
        cost.bytes = plan.volume == figure.volume->data ? 0 : plan.volume->bytes();
        return cost;
    }

    [[nodiscard]] PartCost tables() const {
        PartCost cost{"tables", 0, 0, tableBytes(plan)};
        cost.estimatedMs = static_cast<double>(cost.bytes) / (2 * sizeof(float)) * kTableNsPerEntry * 1e-6;
        cost.measuredMs = millisecondsOf([&] {
            for (const PlanLayer& layer : plan.layers) {
                bakeTransfer(*layer.source, *plan.volume, {}, figure.quality.tableEntries);
            }
        });
        return cost;
    }

    [[nodiscard]] PartCost skipGrid() const {
        PartCost cost{"skip grid", 0, 0, 0};
        const double voxels = static_cast<double>(plan.volume->grid().voxelCount());
        cost.estimatedMs = parallelMs(kMinMaxNsPerVoxel * voxels + kDistanceNsPerBlock * voxels / 64);
        cost.measuredMs = millisecondsOf([&] {
            const auto minMax = computeMinMaxGrid(*plan.field);
            const auto skip = computeSkipGrid(*minMax, visibleRange(plan.layers, *plan.volume));
            cost.bytes = (minMax->low.size() + minMax->high.size()) * sizeof(float) + skip->distance.size();
        });
        return cost;
    }

    [[nodiscard]] PartCost styles() const {
        PartCost cost{"styles", 0, 0, 0};
        if (!plan.atlas) {
            return cost;
        }
        cost.bytes = plan.atlas->texels.size() * sizeof(std::int16_t);
        cost.estimatedMs = parallelMs(kAtlasNsPerTexel * static_cast<double>(plan.atlas->texels.size()) / 4);
        std::vector<std::shared_ptr<const LitSphere>> spheres;
        for (const PlanLayer& layer : plan.layers) {
            for (const auto& entry : layer.styles.styles) {
                if (entry.sphere && std::find(spheres.begin(), spheres.end(), entry.sphere) == spheres.end()) {
                    spheres.push_back(entry.sphere);
                }
            }
        }
        cost.measuredMs = millisecondsOf(
            [&] { packStyles(spheres, plan.atlas->size, plan.mipLevels ? AtlasLevels::all : AtlasLevels::one); });
        return cost;
    }

    [[nodiscard]] PartCost depthCues() const {
        PartCost cost{"depth cues", 0, 0, 0};
        if (!plan.cues) {
            return cost;
        }
        const auto count = [&](const std::shared_ptr<const CueField>& field, double sweeps) {
            if (field) {
                const double cells = static_cast<double>(field->values.size()) / field->channels;
                cost.estimatedMs += parallelMs(cells * sweeps * kSweepNsPerCell);
                cost.bytes += field->values.size() * sizeof(float);
            }
        };
        count(plan.cues->ambient, 26);
        count(plan.cues->shadow, 7);
        count(plan.cues->halo, 18);
        cost.estimatedMs += parallelMs(kOpacityNsPerVoxel * static_cast<double>(plan.volume->grid().voxelCount()));
        RenderPlan without = plan;
        without.cues.reset();
        cost.measuredMs = millisecondsOf([&] { DepthCueFields().add(without, CueDetail::still, task); });
        return cost;
    }

    /// Measured on a probe and scaled to the picture.
    [[nodiscard]] PartCost rendering(const Backend& backend, Explanation& out) const {
        constexpr int kProbe = 256; // pixels an edge: a tenth of a second at the most
        out.probe = {std::min(kProbe, plan.size.x), std::min(kProbe, plan.size.y)};
        const Tile tile{(plan.size - out.probe) / 2, out.probe};
        RenderResult result;
        const double probeMs = millisecondsOf([&] { result = backend.render(plan, tile, task); });
        const double probePixels = static_cast<double>(out.probe.x) * out.probe.y;
        const double pixels = static_cast<double>(plan.size.x) * plan.size.y;
        out.samplesPerPixel = static_cast<double>(result.samples) / probePixels;
        PartCost cost{"rendering", 0, probeMs * pixels / probePixels, static_cast<std::uint64_t>(pixels * 16)};
        const double rays = pixels * plan.subPixels * plan.subPixels;
        cost.estimatedMs = parallelMs(rays * kRayNs + pixels * out.samplesPerPixel * kSampleNs);
        return cost;
    }
};

std::vector<std::string> fieldsOf(const RenderPlan& plan) {
    std::vector<std::string> fields{"value"};
    const auto add = [&](const char* name, auto reads) {
        if (std::any_of(plan.layers.begin(), plan.layers.end(), reads)) {
            fields.emplace_back(name);
        }
    };
    if (readsNormal(plan)) {
        fields.emplace_back("gradient");
    }
    add("curvature", readsCurvature);
    if (plan.labels) {
        fields.emplace_back("labels");
    }
    add("distance", [](const PlanLayer& layer) { return readsAxis(layer, TransferAxis::distance); });
    add("second volume", [](const PlanLayer& layer) { return readsAxis(layer, TransferAxis::second); });
    if ((plan.importance && plan.importance->statistics) || (plan.axisMeasures && plan.axisMeasures->statistics)) {
        fields.emplace_back("local statistics");
    }
    if (!plan.blurs.empty()) {
        fields.emplace_back("blurred copies");
    }
    if (plan.cues) {
        fields.emplace_back("depth cues");
    }
    return fields;
}

} // namespace

std::uint64_t Explanation::bytes() const {
    return std::accumulate(parts.begin(), parts.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const PartCost& part) { return sum + part.bytes; });
}

double Explanation::estimatedMs() const {
    return std::accumulate(parts.begin(), parts.end(), 0.0,
                           [](double sum, const PartCost& part) { return sum + part.estimatedMs; });
}

double Explanation::measuredMs() const {
    return std::accumulate(parts.begin(), parts.end(), 0.0,
                           [](double sum, const PartCost& part) { return sum + part.measuredMs; });
}

Explanation explainFigure(const Figure& figure, const PlanRequest& request, const Backend& backend, Task& task) {
    Explanation out;
    out.backend = backend.name();
    Planner planner;
    std::shared_ptr<const RenderPlan> plan;
    task.beginPhase("Planning");
    out.planningMs = millisecondsOf([&] { plan = planner.plan(figure, request, task); });
    out.used = plan->featuresUsed;
    out.notAsked = plan->featuresNotAsked;
    out.leftOut = plan->leftOut;
    if (!figure.annotations.empty()) {
        out.annotations = describeAnnotations(*plan->figure, drawAnnotations(*plan->figure, {}));
    }
    out.fields = fieldsOf(*plan);
    out.occupied = plan->skip ? plan->skip->occupied : 1;
    task.beginPhase("Measuring");
    const Costs costs{figure, *plan, static_cast<double>(tbb::this_task_arena::max_concurrency()), task};
    out.parts.push_back({"volume", 0, 0, figure.volume->data->bytes()});
    out.parts.push_back(costs.cleanup());
    out.parts.push_back(costs.tables());
    out.parts.push_back(costs.skipGrid());
    out.parts.push_back(costs.styles());
    if (plan->cues) {
        out.parts.push_back(costs.depthCues());
    }
    out.parts.push_back(costs.rendering(backend, out));
    return out;
}

} // namespace limner
