#include "renderer/visibility.h"

#include "core/optics/opacity.h"
#include "renderer/plan/plan_importance.h"
#include "renderer/reference/field.h"
#include "renderer/reference/importance.h"

#include <tbb/parallel_for.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

namespace limner {

namespace {

constexpr int kRanges = 8;

/// A sample's weight in its pixel, while the ray goes on.
struct Part {
    int layer;
    int label;
    int range;
    double weight;
};

/// Shares of some rays, summed.
struct Sums {
    std::vector<double> layers;
    std::map<int, double> labels;
    std::vector<double> ranges;
    double alpha = 0;

    explicit Sums(std::size_t layerCount) : layers(layerCount, 0.0), ranges(kRanges, 0.0) {}

    void add(const Part& part, double factor) {
        const double share = part.weight * factor;
        layers[static_cast<std::size_t>(part.layer)] += share;
        labels[part.label] += share;
        ranges[static_cast<std::size_t>(part.range)] += share;
        alpha += share;
    }
    void add(const Sums& other) {
        std::transform(layers.begin(), layers.end(), other.layers.begin(), layers.begin(), std::plus<>());
        std::transform(ranges.begin(), ranges.end(), other.ranges.begin(), ranges.begin(), std::plus<>());
        for (const auto& [label, share] : other.labels) {
            labels[label] += share;
        }
        alpha += other.alpha;
    }
};

class VisibilityRays {
  public:
    explicit VisibilityRays(const RenderPlan& plan) : plan_(plan) {}

    void add(glm::ivec2 pixel, Sums& sums) const {
        const glm::dvec2 place = glm::dvec2(pixel) + 0.5;
        const auto ray = reference::rayThrough(plan_, place);
        if (!ray) {
            return;
        }
        std::optional<reference::ImportanceRay> weighed;
        if (const double weight = globalWeightAt(plan_, place); weight > 0) {
            weighed.emplace(plan_, weight);
        }
        double opacity = 0;
        std::vector<Part> parts;
        const reference::SampleSpan span = reference::samplesOf(*ray, plan_.lattice);
        for (long k = span.first; k < span.end; ++k) {
            const double certain = weighed ? weighed->certain() : opacity;
            if (1 - certain < plan_.earlyTermination || certain >= 1) {
                break;
            }
            const reference::Segment segment = reference::segmentOf(*ray, plan_.lattice, k);
            if (segment.lengthMm > 0) {
                addSample(*ray, segment, weighed, opacity, parts);
            }
        }
        // Importance scales all of a ray's colour before its background alike.
        const double alpha = weighed ? weighed->result().a : 1;
        for (const Part& part : parts) {
            sums.add(part, alpha);
        }
    }

  private:
    void addSample(const reference::Ray& ray, const reference::Segment& segment,
                   std::optional<reference::ImportanceRay>& weighed, double& opacity, std::vector<Part>& parts) const {
        const glm::dvec3 position = ray.positionVoxel(segment.positionMm);
        const double value = reference::valueAt(plan_, position);
        const reference::SampleFacts facts = reference::sampleFacts(plan_, ray, segment, value);
        for (std::size_t i = 0; i < plan_.layers.size(); ++i) {
            const reference::LayerSample sample = reference::shadeLayer(plan_, plan_.layers[i], facts);
            double weight = 0;
            if (weighed) {
                const double kept = weighed->add(plan_.layers[i], facts, sample);
                for (Part& part : parts) {
                    part.weight *= kept;
                }
                weight = 1 - kept;
            } else {
                weight = (1 - opacity) * optics::opacityOfLength(sample.opacity, sample.lengthRatio);
                opacity += weight;
            }
            if (weight > 0) {
                parts.push_back({static_cast<int>(i), labelAt(position), rangeOf(value), weight});
            }
        }
    }

    [[nodiscard]] int labelAt(const glm::dvec3& positionVoxel) const {
        if (!plan_.figure->labels || !plan_.figure->labels->data) {
            return 0;
        }
        const Volume& labels = *plan_.figure->labels->data;
        const glm::dvec3 at = labels.grid().voxelFromMm(plan_.volume->grid().mmFromVoxel(positionVoxel));
        const glm::ivec3 nearest(glm::floor(at + 0.5));
        const bool inside = glm::all(glm::greaterThanEqual(nearest, glm::ivec3(0))) &&
                            glm::all(glm::lessThan(nearest, labels.grid().dims));
        return inside ? static_cast<int>(labels.valueAt(nearest)) : 0;
    }

    [[nodiscard]] int rangeOf(double value) const {
        const ValueRange all = plan_.volume->range();
        const double share = all.high > all.low ? (value - all.low) / (all.high - all.low) : 0;
        return std::clamp(static_cast<int>(share * kRanges), 0, kRanges - 1);
    }

    const RenderPlan& plan_;
};

} // namespace

VisibilityShares measureVisibility(const RenderPlan& plan, Task& task) {
    const VisibilityRays rays(plan);
    Sums total(plan.layers.size());
    std::mutex mutex;
    tbb::parallel_for(0, plan.size.y, [&](int y) {
        Sums row(plan.layers.size());
        for (int x = 0; x < plan.size.x && !task.cancelled(); ++x) {
            rays.add({x, y}, row);
        }
        const std::lock_guard lock(mutex);
        total.add(row);
    });
    task.throwIfCancelled();
    const double perPixel = 1.0 / (static_cast<double>(plan.size.x) * plan.size.y);
    VisibilityShares shares;
    for (std::size_t i = 0; i < plan.layers.size(); ++i) {
        shares.layers.emplace_back(plan.layers[i].name, total.layers[i] * perPixel);
    }
    if (plan.figure->labels && plan.figure->labels->data) {
        for (const auto& [label, share] : total.labels) {
            shares.labels[label] = share * perPixel;
        }
    }
    const ValueRange all = plan.volume->range();
    for (int i = 0; i < kRanges; ++i) {
        const auto edge = [&](int k) { return all.low + (all.high - all.low) * k / kRanges; };
        shares.ranges.push_back({edge(i), edge(i + 1), total.ranges[static_cast<std::size_t>(i)] * perPixel});
    }
    shares.paper = 1 - total.alpha * perPixel;
    return shares;
}

} // namespace limner
