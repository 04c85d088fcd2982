#include "renderer/plan/planner.h"

#include "core/base/error.h"
#include "core/volume/cleanup.h"
#include "core/volume/gradient_statistics.h"
#include "renderer/plan/describe_plan.h"
#include "renderer/plan/ray_frame.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace limner {

namespace {

/// One slot: successive plans differ in few inputs, so keeping the last result of each stage is enough.
template <typename Key, typename Value>
class LastResult {
  public:
    template <typename Compute>
    const Value& get(const Key& key, const Compute& compute) {
        if (!key_ || !(*key_ == key)) {
            value_ = compute();
            key_ = key;
        }
        return value_;
    }

  private:
    std::optional<Key> key_;
    Value value_;
};

[[noreturn]] void refuse(const std::string& where, const std::string& why, const std::string& remedy) {
    throw Error(ErrorKind::badInput, {"the figure cannot be drawn", where, why, remedy});
}

bool drawsSpheres(const PlanLayer& layer) {
    return layer.shading == Shading::style && std::any_of(layer.styles.styles.begin(), layer.styles.styles.end(),
                                                          [](const auto& e) { return e.sphere != nullptr; });
}

PlanLayer planLayer(const Figure& figure, const Layer& source, const Volume& volume) {
    PlanLayer layer;
    layer.name = source.name;
    layer.source = &source;
    layer.shading = source.shading;
    layer.twoSided = source.twoSided;
    layer.specular = source.specular.value_or(Specular{});
    layer.table = bakeTransfer(source, volume);
    layer.styles = indexStyles(figure, source.transfer);
    if (layer.shading == Shading::style && !drawsSpheres(layer)) {
        layer.shading = Shading::flat; // only plain colours: constant spheres are unshaded colour
    }
    return layer;
}

bool showsAnything(const Layer& layer, const TransferTable& table) {
    return layer.visible && layer.opacity > 0 &&
           std::any_of(table.opacity.begin(), table.opacity.end(), [](float o) { return o > 0; });
}

/// Opacity of one step from that of the reference length (spec style-transfer-functions.md 6).
std::vector<float> stepOpacity(const std::vector<float>& opacity, double ratio) {
    std::vector<float> corrected(opacity.size());
    std::transform(opacity.begin(), opacity.end(), corrected.begin(), [ratio](float a) {
        return a >= 1 ? 1.0F : static_cast<float>(-std::expm1(ratio * std::log1p(-static_cast<double>(a))));
    });
    return corrected;
}

VisibleRange visibleRange(const std::vector<PlanLayer>& layers, const Volume& volume) {
    VisibleRange range{volume.storedFromValue(volume.range().low), volume.storedFromValue(volume.range().high), {}};
    if (range.low > range.high) {
        std::swap(range.low, range.high); // a falling rescale slope
    }
    std::size_t entries = 2;
    for (const PlanLayer& layer : layers) {
        entries = std::max(entries, layer.table.opacity.size());
    }
    range.visible.assign(entries, 0);
    for (const PlanLayer& layer : layers) {
        for (std::size_t i = 0; i < layer.table.opacity.size(); ++i) {
            const bool falling = volume.contents().slope < 0;
            range.visible[falling ? entries - 1 - i : i] |= layer.table.opacity[i] > 0 ? 1 : 0;
        }
    }
    return range;
}

void checkDrawable(const Figure& figure) {
    if (!figure.volume || !figure.volume->data) {
        refuse("/volume", "there is no volume", "choose a scan or find the one that moved");
    }
    if (!(figure.quality.stepVoxels > 0)) {
        refuse("/quality/step_voxels", "the step must be above 0", "0.5 is a good step");
    }
}

} // namespace

struct Planner::Cache {
    using CleanKey =
        std::tuple<std::shared_ptr<const Volume>, std::shared_ptr<const Volume>, std::vector<CleanupStep>, double>;
    using VisibleKey = std::tuple<std::shared_ptr<const MinMaxGrid>, double, double, std::vector<std::uint8_t>>;
    using AtlasKey = std::tuple<std::vector<std::shared_ptr<const LitSphere>>, int>;
    LastResult<CleanKey, std::shared_ptr<const Volume>> cleaned;
    LastResult<std::shared_ptr<const Volume>, std::shared_ptr<const MinMaxGrid>> minMax;
    LastResult<std::shared_ptr<const Volume>, GradientStatistics> gradients;
    LastResult<VisibleKey, std::shared_ptr<const SkipGrid>> skip;
    LastResult<AtlasKey, std::shared_ptr<const StyleAtlas>> atlas;
    std::vector<std::pair<glm::dvec3, std::shared_ptr<const LitSphere>>> plainSpheres;

    /// Plain colours among lit spheres are constant spheres; one and the same object per colour, so that the atlas is
    /// kept.
    std::shared_ptr<const LitSphere> plainSphere(const glm::dvec3& rgb) {
        for (const auto& [colour, sphere] : plainSpheres) {
            if (colour == rgb) {
                return sphere;
            }
        }
        constexpr int size = 8; // the smallest the atlas takes
        const glm::vec3 c(rgb);
        auto sphere = std::make_shared<const LitSphere>(size, std::vector<Rgba>(size * size, {c.r, c.g, c.b, 1}));
        plainSpheres.emplace_back(rgb, sphere);
        return sphere;
    }

    void packAtlas(RenderPlan& plan);
};

void Planner::Cache::packAtlas(RenderPlan& plan) {
    std::vector<std::shared_ptr<const LitSphere>> spheres;
    int largest = 0;
    for (PlanLayer& layer : plan.layers) {
        if (!drawsSpheres(layer)) {
            continue;
        }
        for (const auto& entry : layer.styles.styles) {
            auto sphere = entry.sphere ? entry.sphere : plainSphere(entry.rgb);
            const auto known = std::find(spheres.begin(), spheres.end(), sphere);
            layer.atlasSlots.push_back(static_cast<int>(known - spheres.begin()));
            if (known == spheres.end()) {
                spheres.push_back(sphere);
            }
            largest = std::max(largest, sphere->size());
        }
    }
    if (spheres.empty()) {
        return;
    }
    // The finest structure worth resolving is a ball of about 64 voxels across; over one pixel of it the normal turns
    // by footprint / radius, which spans that many texels of the sphere's radius (spec style-transfer-functions.md 7).
    // (Twice as fine costs a style up to 60 % more time: several spheres then no longer fit the second-level cache.)
    constexpr double radiusVoxels = 32;
    const double turn =
        plan.rays.footprintMm / plan.subPixels / (radiusVoxels * plan.volume->grid().smallestSpacingMm());
    const double texels = 2 / std::max(turn, 1e-6); // beyond any picture's size
    const int wanted = static_cast<int>(std::min<double>(largest, texels));
    plan.atlas = atlas.get({spheres, wanted}, [&] { return packStyles(spheres, wanted); });
}

Planner::Planner() : cache_(std::make_unique<Cache>()) {}
Planner::~Planner() = default;

std::shared_ptr<const RenderPlan> Planner::plan(const Figure& figure, const PlanRequest& request, Task& task) {
    const std::lock_guard lock(mutex_);
    checkDrawable(figure);
    auto plan = std::make_shared<RenderPlan>();
    plan->figure = std::make_shared<const Figure>(figure);
    plan->size = request.size.x > 0 ? request.size : figure.output.sizePixels();
    const double aspect = static_cast<double>(plan->size.x) / plan->size.y;
    const auto labels = figure.labels ? figure.labels->data : nullptr;
    plan->volume = cache_->cleaned.get({figure.volume->data, labels, figure.cleanup, aspect}, [&] {
        return applyCleanup(figure.volume->data, labels.get(), figure.cleanup, aspect, task);
    });
    const Volume& volume = *plan->volume;
    const Quality& quality = figure.quality;
    plan->subPixels = request.subPixels > 0           ? request.subPixels
                      : quality.samplesPerPixel >= 16 ? 4
                      : quality.samplesPerPixel >= 4  ? 2
                                                      : 1;
    plan->referenceLengthMm = volume.grid().smallestSpacingMm();
    plan->lattice = request.lattice.value_or(
        SampleLattice{quality.stepVoxels * request.stepScale * plan->referenceLengthMm, 0.5, 0});
    plan->earlyTermination = quality.earlyTermination;
    plan->clip = figure.clip;
    plan->rays = makeRayFrame(figure.camera, volume, plan->size);
    for (const Layer& layer : plan->figure->layers) {
        PlanLayer planned = planLayer(*plan->figure, layer, volume);
        if (!request.omit || showsAnything(layer, planned.table)) {
            planned.stepOpacity = stepOpacity(planned.table.opacity, plan->lattice.stepMm / plan->referenceLengthMm);
            plan->layers.push_back(std::move(planned));
        }
    }
    task.throwIfCancelled();
    const auto minMax = cache_->minMax.get(plan->volume, [&] { return computeMinMaxGrid(volume); });
    VisibleRange range = visibleRange(plan->layers, volume);
    if (!request.omit) {
        std::fill(range.visible.begin(), range.visible.end(), std::uint8_t{1});
    }
    plan->skip = cache_->skip.get({minMax, range.low, range.high, range.visible},
                                  [&] { return computeSkipGrid(*minMax, range); });
    cache_->packAtlas(*plan);
    if (plan->atlas) {
        const GradientStatistics statistics =
            cache_->gradients.get(plan->volume, [&] { return computeGradientStatistics(volume); });
        plan->gradientMax = statistics.p999;
        plan->gradientFloor = statistics.noise;
    }
    describePlan(*plan, request);
    return plan;
}

} // namespace limner
