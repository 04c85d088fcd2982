#include "renderer/visibility.h"

#include "renderer/reference/ray_parts.h"

#include <tbb/parallel_for.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace limner {

namespace {

constexpr int kRanges = 8;

/// Shares of some rays, summed.
struct Sums {
    std::vector<double> layers;
    std::map<int, double> labels;
    std::vector<double> ranges;
    double alpha = 0;

    explicit Sums(std::size_t layerCount) : layers(layerCount, 0.0), ranges(kRanges, 0.0) {}

    void add(const reference::RayPart& part, int label, std::size_t range) {
        layers[part.layer] += part.weight;
        labels[label] += part.weight;
        ranges[range] += part.weight;
        alpha += part.weight;
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
        for (const reference::RayPart& part : reference::rayParts(plan_, glm::dvec2(pixel) + 0.5)) {
            sums.add(part, labelAt(part.positionVoxel), rangeOf(part.value));
        }
    }

  private:
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

    [[nodiscard]] std::size_t rangeOf(double value) const {
        const ValueRange all = plan_.volume->range();
        const double share = all.high > all.low ? (value - all.low) / (all.high - all.low) : 0;
        return static_cast<std::size_t>(std::clamp(static_cast<int>(share * kRanges), 0, kRanges - 1));
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
