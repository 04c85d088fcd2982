#include "renderer/plan/importance_bricks.h"

#include "core/optics/measures.h"
#include "core/optics/opacity.h"
#include "renderer/plan/plan_parts.h"

#include <tbb/parallel_for.h>

#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limner {

namespace {

/// Greatest extinction, per reference length, that a layer has over a range of values.
double greatestExtinction(const PlanLayer& layer, const ValueRange& values) {
    const TransferTable& table = layer.table;
    const std::vector<float>& all = table.rows == 0 ? table.opacity : table.opacity2d;
    auto first = all.begin();
    auto last = all.end();
    if (table.rows == 0 && table.axisX == TransferAxis::value && table.high > table.low) {
        const auto count = static_cast<double>(all.size());
        const double scale = (count - 1) / (table.high - table.low);
        // One entry more on either side than interpolation reads: backends find the entry in float32.
        const double low = std::clamp(std::floor((values.low - table.low) * scale) - 1, 0.0, count - 1);
        const double high = std::clamp(std::ceil((values.high - table.low) * scale) + 1, 0.0, count - 1);
        first = all.begin() + static_cast<std::ptrdiff_t>(low);
        last = all.begin() + static_cast<std::ptrdiff_t>(high) + 1;
    }
    const double classified = *std::max_element(first, last);
    // The 100-percent rule takes at most the square root.
    const double shading = layer.illustrative ? std::sqrt(classified) : classified;
    return optics::opticalDepth(layer.parts ? greatestOpacity(*layer.parts, shading) : shading);
}

/// Greatest of a field or of the objects' weights in the cells of a brick, margins included.
template <typename Of>
double greatestVoxel(const Volume& field, glm::ivec3 low, glm::ivec3 high, const Of& of) {
    double greatest = 0;
    const glm::ivec3 last = glm::min(high, field.grid().dims - 1);
    for (int z = std::max(low.z, 0); z <= last.z; ++z) {
        for (int y = std::max(low.y, 0); y <= last.y; ++y) {
            for (int x = std::max(low.x, 0); x <= last.x; ++x) {
                greatest = std::max(greatest, of(field, glm::ivec3(x, y, z)));
            }
        }
    }
    return greatest;
}

struct BrickBound {
    const RenderPlan& plan;
    const MinMaxGrid& lowHigh;

    /// Of one brick; below 0: nothing shows there.
    [[nodiscard]] double at(glm::ivec3 brick) const {
        const glm::ivec3 first = brick * ImportanceBricks::kBlocks;
        const glm::ivec3 end = glm::min(first + ImportanceBricks::kBlocks, lowHigh.blocks);
        ValueRange values{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
        bool shows = false;
        for (int z = first.z; z < end.z; ++z) {
            for (int y = first.y; y < end.y; ++y) {
                for (int x = first.x; x < end.x; ++x) {
                    const std::size_t i = (static_cast<std::size_t>(z) * lowHigh.blocks.y + y) * lowHigh.blocks.x + x;
                    shows = shows || plan.skip->distance[i] == 0;
                    for (const float stored : {lowHigh.low[i], lowHigh.high[i]}) {
                        const double value = plan.field->valueFromStored(stored);
                        values.low = std::min(values.low, value);
                        values.high = std::max(values.high, value);
                    }
                }
            }
        }
        return shows ? greatest(brick, values) : -1;
    }

  private:
    [[nodiscard]] double greatest(glm::ivec3 brick, const ValueRange& values) const {
        const PlanImportance& importance = *plan.importance;
        const ImportanceWeights& w = importance.source->weights;
        const double span = importance.intensity.high - importance.intensity.low;
        const double intensity = span > 0 ? std::clamp((values.high - importance.intensity.low) / span, 0.0, 1.0) : 0;
        double shared = w.intensity * intensity + w.gradient + w.silhouette + 3 * w.lighting;
        const int cells = ImportanceBricks::kBlocks * MinMaxGrid::kBlockCells;
        const glm::ivec3 low = brick * cells - 1; // cell c spans the voxels c - 1 and c
        if (!importance.weightOfSlot.empty()) {
            shared +=
                w.object * greatestVoxel(*plan.labels, low, low + cells, [&](const Volume& field, glm::ivec3 v) {
                    return static_cast<double>(importance.weightOfSlot[static_cast<std::size_t>(field.storedAt(v))]);
                });
        }
        if (importance.statistics) {
            shared += w.statistics * greatestVoxel(*importance.statistics, low, low + cells,
                                                   [](const Volume& field, glm::ivec3 v) { return field.valueAt(v); });
        }
        double most = 0;
        for (const PlanLayer& layer : plan.layers) {
            const double own =
                w.extinction > 0 ? w.extinction * optics::extinctionImportance(greatestExtinction(layer, values)) : 0;
            most = std::max(most, layer.source->importanceWeight * (shared + own));
        }
        return most * (1 + 1e-5); // float32 may round what it bounds up
    }
};

} // namespace

std::shared_ptr<const ImportanceBricks> computeImportanceBricks(const RenderPlan& plan, const MinMaxGrid& lowHigh) {
    auto result = std::make_shared<ImportanceBricks>();
    result->bricks = (lowHigh.blocks + ImportanceBricks::kBlocks - 1) / ImportanceBricks::kBlocks;
    const glm::ivec3 n = result->bricks;
    result->greatest.resize(static_cast<std::size_t>(n.x) * n.y * n.z);
    const BrickBound bound{plan, lowHigh};
    tbb::parallel_for(0, n.x * n.y * n.z, [&](int i) {
        result->greatest[static_cast<std::size_t>(i)] =
            static_cast<float>(bound.at({i % n.x, i / n.x % n.y, i / (n.x * n.y)}));
    });
    return result;
}

ImportanceAhead::ImportanceAhead(const RenderPlan& plan) {
    const glm::dvec3 dims(plan.volume->grid().dims);
    const glm::dmat3 across(plan.rays.rightVoxel, plan.rays.downVoxel, plan.rays.forwardVoxel);
    const glm::dmat3 toPicture = glm::inverse(across); // pixels right and down, and along the view
    const auto depth = [&](const glm::dvec3& voxel) { return (toPicture * (voxel - plan.rays.originVoxel)).z; };
    double nearest = std::numeric_limits<double>::max();
    double farthest = std::numeric_limits<double>::lowest();
    for (int corner = 0; corner < 8; ++corner) {
        const double at = depth(glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * dims - 0.5);
        nearest = std::min(nearest, at);
        farthest = std::max(farthest, at);
    }
    const double perSlab = kSlabs / (farthest - nearest);
    for (int i = 0; i < 3; ++i) {
        slabFromVoxel_[static_cast<std::size_t>(i)] = toPicture[i].z * perSlab;
    }
    slabFromVoxel_[3] = (depth(glm::dvec3(0)) - nearest) * perSlab;

    const ImportanceBricks& bricks = *plan.importance->bricks;
    const double cells = ImportanceBricks::kBlocks * MinMaxGrid::kBlockCells;
    constexpr double kEverywhere = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < bricks.greatest.size(); ++i) {
        if (bricks.greatest[i] < 0) {
            continue;
        }
        const auto index = static_cast<int>(i);
        const glm::dvec3 brick(index % bricks.bricks.x, index / bricks.bricks.x % bricks.bricks.y,
                               index / (bricks.bricks.x * bricks.bricks.y));
        Seen seen{glm::dvec2(kEverywhere), glm::dvec2(-kEverywhere), 0, bricks.greatest[i]};
        double last = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 voxel = (brick + glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2)) * cells - 1.0;
            glm::dvec3 at = toPicture * (voxel - plan.rays.originVoxel);
            last = std::max(last, (at.z - nearest) * perSlab);
            if (plan.rays.perspective && !(at.z > 0)) { // reaches behind the eye: may be anywhere
                seen.low = glm::dvec2(-kEverywhere);
                seen.high = glm::dvec2(kEverywhere);
                continue;
            }
            at /= plan.rays.perspective ? at.z : 1;
            seen.low = glm::min(seen.low, glm::dvec2(at));
            seen.high = glm::max(seen.high, glm::dvec2(at));
        }
        seen.lastSlab = static_cast<int>(std::clamp(std::ceil(last), 0.0, kSlabs - 1.0)); // rounding goes one further
        seen_.push_back(seen);
    }
}

ImportanceAhead::Table ImportanceAhead::behind(glm::dvec2 low, glm::dvec2 high) const {
    Table table{};
    for (const Seen& seen : seen_) {
        if (seen.low.x <= high.x && seen.low.y <= high.y && seen.high.x >= low.x && seen.high.y >= low.y) {
            float& slab = table[static_cast<std::size_t>(seen.lastSlab)];
            slab = std::max(slab, seen.greatest);
        }
    }
    for (std::size_t slab = kSlabs - 1; slab > 0; --slab) { // a ray meets a slab after those before it
        table[slab - 1] = std::max(table[slab - 1], table[slab]);
    }
    return table;
}

} // namespace limner
