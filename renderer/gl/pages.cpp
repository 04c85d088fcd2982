#include "core/base/error.h"
#include "renderer/gl/scene_textures.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace limner::gl {

namespace {

/// Voxels that a sample reads beyond its cell's own: taps reach two, differences of fourth order three.
constexpr int kReach = 3;

std::uint64_t bytesPerVoxel(const RenderPlan& plan) {
    std::set<std::shared_ptr<const Volume>> all = {plan.field, plan.gradientField, plan.bendField, plan.secondVolume};
    for (const auto* measures : {&plan.importance, &plan.axisMeasures}) {
        all.insert(*measures ? (*measures)->statistics : nullptr);
    }
    for (const PlanLayer& layer : plan.layers) {
        all.insert(layer.distance);
    }
    all.insert(plan.blurs.begin(), plan.blurs.end());
    std::uint64_t bytes = plan.labels ? 1 : 0;
    for (const auto& volume : all) {
        bytes += !volume ? 0 : volume->type() == VoxelType::float32 ? 4 : 2;
    }
    return bytes;
}

/// How far from its own cell a page's sample reads.
int reachOf(const RenderPlan& plan) {
    double probe = 0;
    for (const PlanLayer& layer : plan.layers) {
        if (layer.contours && layer.contours->curvature == CurvatureEstimator::normals) {
            probe = std::max(probe, layer.contours->probeMm);
        }
    }
    const double slab = plan.preintegrated ? plan.lattice.stepMm : 0; // a page has the slabs whose middles it has
    return kReach + static_cast<int>(std::ceil((probe + slab) / plan.volume->grid().smallestSpacingMm()));
}

/// What all pages read.
std::uint64_t sharedBytes(const RenderPlan& plan) {
    std::uint64_t bytes = plan.skip->distance.size();
    bytes += plan.atlas ? 2 * plan.atlas->texels.size() : 0;
    if (plan.cues) {
        for (const auto& cue : {plan.cues->ambient, plan.cues->shadow, plan.cues->halo}) {
            bytes += cue ? sizeof(float) * cue->values.size() : 0;
        }
    }
    return bytes;
}

/// What the card offers a page.
struct PageRoom {
    int edge = 0; ///< voxels
    std::uint64_t voxels = 0;

    PageRoom(const RenderPlan& plan, const Device& device) : edge(device.facts().largest3d) {
        const std::uint64_t shared = sharedBytes(plan);
        // Half of it: the page before may stay while this one comes.
        voxels = device.room() > shared ? (device.room() - shared) / 2 / bytesPerVoxel(plan) : 0;
    }
    [[nodiscard]] bool holds(const glm::ivec3& size) const {
        const auto all = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) *
                         static_cast<std::uint64_t>(size.z);
        return glm::max(size.x, glm::max(size.y, size.z)) <= edge && all <= voxels;
    }
};

Page pageAt(const glm::ivec3& at, const glm::ivec3& cells, const glm::ivec3& dims, int reach) {
    Page page;
    page.lowCell = at * cells;
    page.highCell = glm::min(page.lowCell + cells, dims);
    const glm::ivec3 first = glm::max(page.lowCell - 1 - reach, glm::ivec3(0));
    page.firstVoxel = first;
    page.voxels = glm::min(page.highCell + reach, dims) - first;
    return page;
}

} // namespace

std::string Page::name() const {
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
        text += std::to_string(firstVoxel[axis]) + "+" + std::to_string(voxels[axis]) + " ";
    }
    return text;
}

PageGrid pagesOf(const RenderPlan& plan, const Device& device) {
    const glm::ivec3 dims = plan.volume->grid().dims;
    const PageRoom room(plan, device);
    const int reach = reachOf(plan);
    PageGrid grid;
    if (room.holds(dims)) {
        grid.pages = {{glm::ivec3(0), dims, glm::ivec3(0), dims}};
        return grid;
    }
    glm::ivec3 cells = dims;
    while (!room.holds(cells + 1 + 2 * reach)) {
        int longest = 0;
        for (int axis = 1; axis < 3; ++axis) {
            longest = cells[axis] > cells[longest] ? axis : longest;
        }
        constexpr int kSmallestPage = 8; // below it a page would be all margin
        if (cells[longest] <= kSmallestPage) {
            throw Error(ErrorKind::noResources, {"the volume cannot be drawn with OpenGL", "",
                                                 "the card has no room for a part of it", "use the backend cpu"});
        }
        cells[longest] = (cells[longest] + 1) / 2;
    }
    grid.count = (dims + cells - 1) / cells;
    for (int i = 0; i < grid.count.x * grid.count.y * grid.count.z; ++i) {
        const glm::ivec3 at(i % grid.count.x, i / grid.count.x % grid.count.y, i / (grid.count.x * grid.count.y));
        grid.pages.push_back(pageAt(at, cells, dims, reach));
    }
    return grid;
}

std::vector<Page> frontToBack(const PageGrid& grid, const KernelScene& scene) {
    const glm::ivec3 cells = grid.pages.front().highCell;
    glm::ivec3 begin; // the page where rays set out
    for (int axis = 0; axis < 3; ++axis) {
        const double eye = scene.origin[axis] / cells[axis];
        const double last = grid.count[axis] - 1;
        const double page =
            scene.perspective ? std::clamp(std::floor(eye), 0.0, last) : (scene.forward[axis] < 0 ? last : 0.0);
        begin[axis] = static_cast<int>(page);
    }
    // A ray only leaves the page it set out from, along every axis: each step makes the sum of the distances greater.
    std::vector<Page> sorted = grid.pages;
    const auto away = [&](const Page& page) {
        const glm::ivec3 d = glm::abs(page.lowCell / cells - begin);
        return d.x + d.y + d.z;
    };
    std::stable_sort(sorted.begin(), sorted.end(), [&](const Page& a, const Page& b) { return away(a) < away(b); });
    return sorted;
}

} // namespace limner::gl
