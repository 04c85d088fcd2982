#include "renderer/marks/mark_view.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

namespace limner {

namespace {

constexpr double kMostDepthCells = 16e6;
/// Matter thinner than this is as good as air: noise must not hide a surface.
constexpr float kLeastData = 0.05F;
constexpr float kLeastOpacity = 0.25F;
/// Radius of a voxel's disc, in voxels: half the diagonal of its face on a surface as slanted to the grid as can be, so
/// that there are no holes.
constexpr float kDiscVoxels = 1;
/// A surface is some voxels thick; its marks do not hide one another.
constexpr float kToleranceVoxels = 1.5F;
/// Half the diagonal of a face in the tangent plane, and the way onto the surface.
constexpr double kReachVoxels = 2.2;
constexpr float kFarCells = 32768; ///< more than the grid has; whole numbers up to here keep half a bit of a cell

/// Floats as whole numbers in the same order, so that the nearest can be kept without a lock.
std::uint32_t ordered(float depth) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &depth, sizeof bits);
    return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}
float fromOrdered(std::uint32_t bits) {
    bits = (bits & 0x80000000U) != 0 ? bits & 0x7FFFFFFFU : ~bits;
    float depth = 0;
    std::memcpy(&depth, &bits, sizeof depth);
    return depth;
}

constexpr std::uint32_t kNothing = 0; // before every float

void keepLargest(std::uint32_t& cell, std::uint32_t value) {
    std::atomic_ref<std::uint32_t> shared(cell);
    std::uint32_t known = shared.load(std::memory_order_relaxed);
    while (known < value && !shared.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
    }
}

} // namespace

MarkView::MarkView(const RenderPlan& plan)
    : frame_(plan.figure->camera, plan.figure->output.aspect()),
      paperMm_(plan.figure->output.widthMm, plan.figure->output.heightMm), scale_(paperMm_.y / frame_.heightMm),
      perEyeDistance_(frame_.eyeDistanceMm > 0 ? 1 / frame_.eyeDistanceMm : 0), clip_(plan.clip) {}

PlaceOnPaper MarkView::place(const glm::dvec3& pointMm) const {
    const glm::dvec3 d = pointMm - frame_.targetMm;
    const double along = glm::dot(d, frame_.forward);
    const double w = 1 + along * perEyeDistance_;
    if (!(w > 0)) {
        return {{0, 0}, static_cast<float>(-along), 0};
    }
    const double scale = scale_ / w;
    return {glm::vec2(0.5 * paperMm_.x + scale * glm::dot(d, frame_.right),
                      0.5 * paperMm_.y - scale * glm::dot(d, frame_.up)),
            static_cast<float>(-along), static_cast<float>(scale)};
}

glm::vec3 MarkView::towardsEye(const glm::dvec3& pointMm) const {
    if (!(frame_.eyeDistanceMm > 0)) {
        return -glm::vec3(frame_.forward);
    }
    return glm::vec3(glm::normalize(frame_.targetMm - frame_.forward * frame_.eyeDistanceMm - pointMm));
}

glm::vec3 MarkView::seen(const glm::vec3& directionMm) const {
    const glm::dvec3 d(directionMm);
    return {glm::dot(d, frame_.right), glm::dot(d, frame_.up), -glm::dot(d, frame_.forward)};
}

bool MarkView::kept(const glm::dvec3& p) const {
    if (clip_.boxMm &&
        (glm::any(glm::lessThan(p, clip_.boxMm->low)) || glm::any(glm::greaterThan(p, clip_.boxMm->high)))) {
        return false;
    }
    return std::none_of(clip_.planes.begin(), clip_.planes.end(),
                        [&](const ClipPlane& plane) { return glm::dot(plane.normal, p) > plane.offsetMm; });
}

MarkDepth::Shape MarkDepth::shapeOf(const MarkField& field, const MarkView& view, bool matterOfLayers) {
    const glm::dvec2 paper = view.paperMm();
    Shape shape;
    shape.cellMm = std::max(0.5 * field.mmPerVoxel * view.scale(), std::sqrt(paper.x * paper.y / kMostDepthCells));
    shape.size = glm::max(glm::ivec2(glm::ceil(paper / shape.cellMm)), glm::ivec2(1));
    shape.toleranceMm = static_cast<float>(kToleranceVoxels * field.mmPerVoxel);
    shape.discMm = kDiscVoxels * static_cast<float>(field.mmPerVoxel);
    shape.least = matterOfLayers ? kLeastOpacity : kLeastData;
    return shape;
}

MarkDepth::MarkDepth(const MarkField& field, const MarkView& view, bool matterOfLayers)
    : shape_(shapeOf(field, view, matterOfLayers)), reachMm_(static_cast<float>(kReachVoxels * field.mmPerVoxel)) {
    std::vector<std::uint32_t> near(static_cast<std::size_t>(shape_.size.x) * static_cast<std::size_t>(shape_.size.y),
                                    kNothing);
    // The back of matter hides nothing that its front does not.
    const auto facesViewer = [&](const MarkVoxel& voxel) {
        return glm::dot(voxel.normalMm, view.towardsEye(field.placeMm(voxel))) > 0;
    };
    tbb::parallel_for(std::size_t{0}, field.voxels.size(), [&](std::size_t i) {
        const MarkVoxel& voxel = field.voxels[i];
        if (voxel.value >= shape_.least && voxel.share > 0 && facesViewer(voxel)) {
            addDisc(field, view, voxel, near);
        }
    });
    nearest_.resize(near.size());
    std::transform(near.begin(), near.end(), nearest_.begin(), [](std::uint32_t bits) {
        return bits == kNothing ? -std::numeric_limits<float>::infinity() : fromOrdered(bits);
    });
}

void MarkDepth::addDisc(const MarkField& field, const MarkView& view, const MarkVoxel& voxel,
                        std::vector<std::uint32_t>& near) {
    const glm::dvec3 mm = field.placeMm(voxel) + glm::dvec3(voxel.normalMm * voxel.edgeOffsetMm);
    if (!view.kept(mm)) {
        return;
    }
    const PlaceOnPaper at = view.place(mm);
    if (!(at.scale > 0)) {
        return;
    }
    const glm::vec3 n = view.seen(voxel.normalMm);
    const float facing = std::max(std::abs(n.z), 0.05F);
    const float radiusMm = shape_.discMm;
    const auto cell = static_cast<float>(shape_.cellMm);
    const float reach = radiusMm * at.scale / cell;
    const glm::vec2 middle = at.mm / cell;
    const auto low = glm::max(glm::ivec2(glm::ceil(middle - reach - 0.5F)), glm::ivec2(0));
    const auto high = glm::min(glm::ivec2(glm::floor(middle + reach - 0.5F)), shape_.size - 1);
    for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
            const glm::vec2 d = ((glm::vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5F) - middle) *
                                (cell / at.scale); // mm of the volume, y down
            const float rise = -(n.x * d.x - n.y * d.y) / std::copysign(facing, n.z);
            if (d.x * d.x + d.y * d.y + rise * rise <= radiusMm * radiusMm) {
                keepLargest(near[static_cast<std::size_t>(y) * static_cast<std::size_t>(shape_.size.x) +
                                 static_cast<std::size_t>(x)],
                            ordered(at.depthMm + rise));
            }
        }
    }
}

float MarkDepth::tolerance(float facing) const {
    // On a surface seen edge-on a cell is as deep as it is slanted.
    return shape_.toleranceMm * (1 + kSlantTolerance * (1 / std::max(facing, kLeastFacing) - 1));
}

bool MarkDepth::hidesVoxel(const PlaceOnPaper& middle, float facing) const {
    if (nearest_.empty()) {
        return false;
    }
    const auto cell = static_cast<float>(shape_.cellMm);
    const float reach = reachMm_ * middle.scale;
    const glm::vec2 low = (middle.mm - reach) / cell - 0.5F;
    const glm::vec2 high = (middle.mm + reach) / cell + 0.5F;
    if (!(low.x >= 0 && low.y >= 0 && high.x < static_cast<float>(shape_.size.x) &&
          high.y < static_cast<float>(shape_.size.y))) {
        return false;
    }
    const float least = middle.depthMm + reachMm_ + 2 * tolerance(facing);
    for (int y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y) {
        const float* row = nearest_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(shape_.size.x);
        for (int x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x) {
            if (row[x] < least) {
                return false;
            }
        }
    }
    return true;
}

float MarkDepth::visible(const PlaceOnPaper& place, float facing) const {
    if (nearest_.empty()) {
        return 1;
    }
    // Between four cells, so that a mark does not jump out of sight.
    const float tolerated = tolerance(facing);
    const glm::vec2 at = place.mm / static_cast<float>(shape_.cellMm) - 0.5F;
    // Far off the paper nothing is near; rounded down without a call.
    if (!(std::abs(at.x) < kFarCells && std::abs(at.y) < kFarCells)) {
        return 1;
    }
    const glm::ivec2 low = glm::ivec2(at + kFarCells) - static_cast<int>(kFarCells);
    const glm::vec2 f = at - glm::vec2(low);
    float sum = 0;
    for (int k = 0; k < 4; ++k) {
        const glm::ivec2 cell = low + glm::ivec2(k & 1, k >> 1);
        const float weight = ((k & 1) != 0 ? f.x : 1 - f.x) * ((k >> 1) != 0 ? f.y : 1 - f.y);
        if (cell.x < 0 || cell.y < 0 || cell.x >= shape_.size.x || cell.y >= shape_.size.y) {
            sum += weight;
            continue;
        }
        const float behind = nearest_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(shape_.size.x) +
                                      static_cast<std::size_t>(cell.x)] -
                             place.depthMm;
        const float t = std::clamp(behind / tolerated - 1, 0.0F, 1.0F);
        sum += weight * (1 - t * t * (3 - 2 * t));
    }
    return std::min(sum, 1.0F);
}

} // namespace limner
