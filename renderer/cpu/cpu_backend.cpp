#include "renderer/backend.h"
#include "renderer/cpu/kernel.h"
#include "renderer/plan/plan_importance.h"
#include "renderer/scene/scene_builder.h"
#include "renderer/scene/sub_pixels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <vector>

namespace limner {

namespace {

/// Sub-pixels of a tile, cut into the picture's own blocks.
struct BlockRange {
    glm::ivec2 first; ///< sub-pixel corner of the tile
    glm::ivec2 end;
    glm::ivec2 firstBlock;
    glm::ivec2 blocks;
};

BlockRange blocksOf(const Tile& tile, int subPixels) {
    BlockRange range;
    range.first = tile.origin * subPixels;
    range.end = (tile.origin + tile.size) * subPixels;
    range.firstBlock = range.first / KernelBlock::kSize;
    range.blocks = (range.end + KernelBlock::kSize - 1) / KernelBlock::kSize - range.firstBlock;
    return range;
}

/// What a block's rays need for importance-aware composition.
struct BlockImportance {
    ImportanceAhead::Table ahead;
    float weights[KernelBlock::kSize * KernelBlock::kSize];

    /// Leaves a block that importance does not reach as it is: composed the ordinary way.
    void set(const RenderPlan& plan, const ImportanceAhead& all, KernelBlock& block) {
        const glm::dvec2 corner(block.x, block.y);
        const double perPixel = 1.0 / plan.subPixels;
        const glm::dvec2 low = corner * perPixel;
        const glm::dvec2 high = (corner + static_cast<double>(KernelBlock::kSize)) * perPixel;
        const auto& lenses = plan.importance->lenses;
        const double perFigure = 1.0 / plan.size.y;
        if (!plan.kept.has(LeaveOut::importanceOutsideLenses) &&
            lensesMiss(lenses, low * perFigure, high * perFigure)) {
            return;
        }
        ahead = all.behind(low, high);
        block.ahead = ahead.data();
        if (lenses.empty()) {
            return;
        }
        for (int i = 0; i < KernelBlock::kSize * KernelBlock::kSize; ++i) {
            const glm::dvec2 middle(i % KernelBlock::kSize + 0.5, i / KernelBlock::kSize + 0.5);
            weights[i] = static_cast<float>(globalWeightAt(plan, (corner + middle) * perPixel));
        }
        block.weights = weights;
    }
};

class CpuBackend : public Backend {
  public:
    [[nodiscard]] std::string name() const override { return "cpu"; }

    RenderResult render(const RenderPlan& plan, const Tile& tile, Task& task) const override {
        return plan.layers.empty() ? RenderResult{Picture(tile.size), 0, 0}
                                   : renderTile(plan, BuiltScene(plan), tile, task);
    }

    RenderResult renderTiles(const RenderPlan& plan, std::span<const Tile> tiles, Task& task) const override {
        RenderResult all{stackOf(tiles), 0, 0};
        if (plan.layers.empty()) {
            return all;
        }
        const BuiltScene built(plan);
        std::vector<int> tops(tiles.size());
        for (std::size_t i = 1; i < tiles.size(); ++i) {
            tops[i] = tops[i - 1] + tiles[i - 1].size.y;
        }
        std::atomic<std::uint64_t> samples{0};
        std::atomic<std::uint64_t> shaded{0};
        tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
            const RenderResult one = renderTile(plan, built, tiles[i], task);
            stackAt(tops[i], one.picture, all.picture);
            samples += one.samples;
            shaded += one.shaded;
        });
        all.samples = samples;
        all.shaded = shaded;
        return all;
    }

  private:
    static RenderResult renderTile(const RenderPlan& plan, const BuiltScene& built, const Tile& tile, Task& task) {
        RenderResult result{Picture(tile.size), 0, 0};
        const BlockRange range = blocksOf(tile, plan.subPixels);
        std::atomic<std::uint64_t> samples{0};
        std::atomic<std::uint64_t> shaded{0};
        tbb::parallel_for(0, range.blocks.x * range.blocks.y, [&](int i) {
            if (task.cancelled()) {
                return;
            }
            const glm::ivec2 index = range.firstBlock + glm::ivec2(i % range.blocks.x, i / range.blocks.x);
            const glm::ivec2 corner = index * KernelBlock::kSize;
            const glm::ivec2 wanted = glm::min(range.end - corner, glm::ivec2(KernelBlock::kSize));
            alignas(64) float rgba[KernelBlock::kSize * KernelBlock::kSize * 4] = {};
            KernelCounts counts;
            KernelBlock block{corner.x, corner.y, wanted.x, wanted.y};
            BlockImportance importance;
            if (built.ahead()) {
                importance.set(plan, *built.ahead(), block);
            }
            castBlock(built.scene(), block, rgba, counts);
            samples += counts.samples;
            shaded += counts.shaded;
            constexpr int kSize = KernelBlock::kSize;
            const SubPixels rays{rgba, kSize, corner, glm::ivec2(kSize / plan.subPixels), plan.subPixels};
            averageSubPixels(rays, tile, result.picture);
        });
        task.throwIfCancelled();
        result.samples = samples;
        result.shaded = shaded;
        return result;
    }
};

} // namespace

std::unique_ptr<Backend> makeCpuBackend() { return std::make_unique<CpuBackend>(); }

} // namespace limner
