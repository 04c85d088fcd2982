#include "renderer/marks/hatch_map.h"

#include "renderer/marks/agree_turns.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace limner {

namespace {

constexpr double kMostCells = 4e6;
constexpr double kCellVoxels = 0.5;
/// Cells are no finer than serves strokes: mm on paper, or a share of its height.
constexpr double kFinestMm = 0.4;
constexpr double kFinestShare = 1 / 300.0;
/// Radius of a voxel's disc on the surface: neighbours overlap.
constexpr float kDiscVoxels = 1;
/// A surface's voxels lie this near one another; beyond is another surface.
constexpr float kThickVoxels = 2;
constexpr float kJumpVoxels = 4;
/// A cell is of the surface where so much of the cells around it is: discs reach over its border by most of a voxel.
constexpr float kWithin = 0.64F;
constexpr int kAround = 2;
/// Fainter tones have no strokes; voxels with less of their surface's ink may lie beside it.
constexpr float kFaintest = 0.01F;
constexpr float kMatter = 0.25F;
/// Difference of the principal curvatures, per voxel, at which their directions are half certain.
constexpr float kCertain = 0.04F;
/// What the view's vertical weighs where they are not.
constexpr float kFallback = 0.04F;

/// Whether a voxel is of a surface that hatching sees: it has a tone, or hides what is behind although it is all light.
bool onSurface(const LineScene& scene, std::span<const float> tone, std::size_t i) {
    const MarkVoxel& voxel = scene.field.voxels[i];
    return voxel.share > 0 &&
           (tone[i] >= kFaintest || (voxel.value >= kMatter &&
                                     glm::dot(voxel.normalMm, scene.view.towardsEye(scene.field.placeMm(voxel))) > 0));
}

std::vector<std::uint32_t> surfaceVoxels(const LineScene& scene, std::span<const float> tone) {
    std::vector<std::uint8_t> are(tone.size());
    tbb::parallel_for(std::size_t{0}, are.size(), [&](std::size_t i) { are[i] = onSurface(scene, tone, i) ? 1 : 0; });
    std::vector<std::uint32_t> voxels;
    for (std::uint32_t i = 0; i < are.size(); ++i) {
        if (are[i] != 0) {
            voxels.push_back(i);
        }
    }
    return voxels;
}

glm::vec2 twice(const glm::vec2& d) { return {d.x * d.x - d.y * d.y, 2 * d.x * d.y}; }

glm::vec2 half(const glm::vec2& turn) {
    const float angle = 0.5F * std::atan2(turn.y, turn.x);
    return {std::cos(angle), std::sin(angle)};
}

/// Directions of both families on paper (y down), as certain as they are long.
struct Directions {
    glm::vec2 along{0};
    glm::vec2 across{0};
};

Directions directionsAt(const LineScene& scene, std::size_t i) {
    const MarkVoxel& voxel = scene.field.voxels[i];
    const auto onPaper = [&](const glm::vec3& d) {
        const glm::vec3 seen = scene.view.seen(d);
        return twice({seen.x, -seen.y});
    };
    const glm::vec3 up(scene.view.frame().up);
    const glm::vec3 upright = up - voxel.normalMm * glm::dot(up, voxel.normalMm);
    Directions directions;
    float uncertain = kFallback;
    if (scene.field.curvatures.size() == scene.field.voxels.size()) {
        const MarkCurvature& c = scene.field.curvatures[i];
        const float apart = std::abs(c.most - c.least) * static_cast<float>(scene.field.mmPerVoxel);
        const float ratio = apart / kCertain;
        const float certain = 1 - 1 / (1 + ratio * ratio * ratio * ratio);
        if (certain > 0) { // not where it is not a number
            uncertain *= 1 - certain;
            directions.along += certain * onPaper(c.directionMm);
            directions.across += certain * onPaper(glm::cross(voxel.normalMm, c.directionMm));
        }
    }
    directions.along += uncertain * onPaper(upright);
    directions.across += uncertain * onPaper(glm::cross(voxel.normalMm, upright));
    return directions;
}

} // namespace

template <typename Use>
void HatchMap::forDisc(const LineScene& scene, std::size_t i, const Use& use) const {
    const MarkVoxel& voxel = scene.field.voxels[i];
    const auto voxelMm = static_cast<float>(scene.field.mmPerVoxel);
    const glm::dvec3 mm =
        scene.field.placeMm(voxel) + glm::dvec3(voxel.normalMm) * static_cast<double>(voxel.edgeOffsetMm);
    const PlaceOnPaper at = scene.view.place(mm);
    if (!(at.scale > 0) || !scene.view.kept(mm)) {
        return;
    }
    const glm::vec3 n = scene.view.seen(voxel.normalMm);
    const float facing = std::copysign(std::max(std::abs(n.z), 0.1F), n.z);
    const float radius = kDiscVoxels * voxelMm;
    const glm::vec2 middle = at.mm / cellMm_;
    const float reach = radius * at.scale / cellMm_;
    const glm::ivec2 low = glm::max(glm::ivec2(glm::ceil(middle - reach - 0.5F)), glm::ivec2(0));
    const glm::ivec2 high = glm::min(glm::ivec2(glm::floor(middle + reach - 0.5F)), size_ - 1);
    for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
            const glm::vec2 d = (glm::vec2(x, y) + 0.5F - middle) * (cellMm_ / at.scale);
            const float rise = -(n.x * d.x - n.y * d.y) / facing;
            const float share = 1 - (glm::dot(d, d) + rise * rise) / (radius * radius);
            if (share > 0) {
                use(indexOf(x, y), at.depthMm + rise, share);
            }
        }
    }
}

HatchMap::HatchMap(const LineScene& scene, std::span<const float> tone) {
    const glm::dvec2 paper = scene.view.paperMm();
    const double voxelMm = scene.field.mmPerVoxel;
    cellMm_ = static_cast<float>(
        std::max({kCellVoxels * voxelMm * scene.view.scale(), std::min(kFinestMm, kFinestShare * paper.y),
                  std::sqrt(paper.x * paper.y / kMostCells)}));
    jumpMm_ = kJumpVoxels * static_cast<float>(std::max(voxelMm, static_cast<double>(cellMm_) / scene.view.scale()));
    size_ = glm::max(glm::ivec2(glm::ceil(paper / static_cast<double>(cellMm_))), glm::ivec2(1));
    const std::size_t count = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    cells_.resize(count);
    along_.resize(count, glm::vec2(0));
    across_.resize(count, glm::vec2(0));
    const std::vector<std::uint32_t> surface = surfaceVoxels(scene, tone);
    gather(scene, tone, surface, nearestOf(scene, surface));
    settleBorder();
    TurnGrid asked{size_, std::vector<float>(count), along_};
    std::transform(cells_.begin(), cells_.end(), asked.depthMm.begin(), [](const Cell& cell) {
        return cell.weight > 0 ? cell.depthMm : std::numeric_limits<float>::quiet_NaN();
    });
    along_ = agreedTurns(asked, jumpMm_);
    asked.turns = std::move(across_);
    across_ = agreedTurns(asked, jumpMm_);
}

std::vector<float> HatchMap::nearestOf(const LineScene& scene, const std::vector<std::uint32_t>& surface) const {
    std::vector<float> nearest(cells_.size(), std::numeric_limits<float>::lowest());
    tbb::parallel_for(std::size_t{0}, surface.size(), [&](std::size_t k) {
        forDisc(scene, surface[k], [&](std::size_t cell, float depth, float) {
            const std::atomic_ref<float> shared(nearest[cell]);
            float known = shared.load(std::memory_order_relaxed);
            while (known < depth && !shared.compare_exchange_weak(known, depth, std::memory_order_relaxed)) {
            }
        });
    });
    return nearest;
}

/// Sums in the voxels' order: sums of floats differ in any other.
void HatchMap::gather(const LineScene& scene, std::span<const float> tone, const std::vector<std::uint32_t>& surface,
                      const std::vector<float>& nearest) {
    const float thick = kThickVoxels * static_cast<float>(scene.field.mmPerVoxel);
    std::vector<float> best(cells_.size(), 0);
    for (const std::uint32_t i : surface) {
        const Directions directions = directionsAt(scene, i);
        const float ofSurface = scene.field.voxels[i].share;
        forDisc(scene, i, [&](std::size_t index, float depth, float share) {
            if (depth < nearest[index] - thick) {
                return;
            }
            Cell& cell = cells_[index];
            const float weight = share * ofSurface;
            cell.weight += weight;
            cell.tone += weight * tone[i];
            cell.depthMm += weight * depth;
            along_[index] += weight * directions.along;
            across_[index] += weight * directions.across;
            if (weight > best[index]) {
                best[index] = weight;
                cell.voxel = i;
            }
        });
    }
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const float weight = cells_[i].weight;
        if (weight > 0) {
            cells_[i].tone = std::min(cells_[i].tone / weight, 1.0F);
            cells_[i].depthMm /= weight;
            cells_[i].weight = 1;
            along_[i] /= weight;
            across_[i] /= weight;
        }
    }
}

/// Takes the discs' overhang off the surface's border and closes pinholes.
void HatchMap::settleBorder() {
    const std::vector<Cell> cells = cells_;
    const std::vector<glm::vec2> along = along_;
    const std::vector<glm::vec2> across = across_;
    tbb::parallel_for(0, size_.y, [&](int y) {
        for (int x = 0; x < size_.x; ++x) {
            const std::size_t i = indexOf(x, y);
            Cell mean;
            glm::vec2 meanAlong(0);
            glm::vec2 meanAcross(0);
            int all = 0;
            for (int v = std::max(y - kAround, 0); v <= std::min(y + kAround, size_.y - 1); ++v) {
                for (int u = std::max(x - kAround, 0); u <= std::min(x + kAround, size_.x - 1); ++u) {
                    const std::size_t j = indexOf(u, v);
                    ++all;
                    if (cells[j].weight > 0) {
                        mean.weight += 1;
                        mean.tone += cells[j].tone;
                        mean.depthMm += cells[j].depthMm;
                        mean.voxel = cells[j].voxel;
                        meanAlong += along[j];
                        meanAcross += across[j];
                    }
                }
            }
            if (mean.weight < kWithin * static_cast<float>(all)) {
                cells_[i] = {};
            } else if (!(cells[i].weight > 0)) {
                const float n = mean.weight;
                cells_[i] = {1, mean.tone / n, mean.depthMm / n, mean.voxel};
                along_[i] = meanAlong / n;
                across_[i] = meanAcross / n;
            }
        }
    });
}

std::optional<HatchPlace> HatchMap::at(const glm::vec2& mm, Family family, std::optional<float> near) const {
    const glm::vec2 place = mm / cellMm_ - 0.5F;
    const glm::ivec2 low(glm::floor(place));
    const std::vector<glm::vec2>& turns = family == Family::along ? along_ : across_;
    HatchPlace found;
    glm::vec2 turn(0);
    float sum = 0;
    float best = 0;
    for (int k = 0; k < 4; ++k) {
        const glm::ivec2 c = low + glm::ivec2(k % 2, k / 2);
        if (c.x < 0 || c.y < 0 || c.x >= size_.x || c.y >= size_.y) {
            continue;
        }
        const std::size_t i = indexOf(c.x, c.y);
        const glm::vec2 off = 1.0F - glm::abs(place - glm::vec2(c));
        const float weight = off.x * off.y;
        const Cell& cell = cells_[i];
        if (!(cell.weight > 0) || (near && std::abs(cell.depthMm - *near) > jumpMm_)) {
            continue;
        }
        sum += weight;
        turn += weight * turns[i];
        found.tone += weight * cell.tone;
        found.depthMm += weight * cell.depthMm;
        if (weight > best) {
            best = weight;
            found.voxel = cell.voxel;
        }
    }
    if (!(sum > 0.5F) || !(glm::dot(turn, turn) > 1e-12F)) {
        return {};
    }
    found.tone /= sum;
    found.depthMm /= sum;
    found.direction = half(turn);
    return found;
}

float HatchMap::toneAt(const glm::vec2& mm) const {
    const glm::ivec2 c(glm::floor(mm / cellMm_));
    return c.x < 0 || c.y < 0 || c.x >= size_.x || c.y >= size_.y ? 0 : cells_[indexOf(c.x, c.y)].tone;
}

} // namespace limner
