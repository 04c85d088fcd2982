#include "core/figure/fitted_view.h"

#include "core/figure/presets.h"
#include "core/figure/view_frame.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace limner {

namespace {

constexpr double kMargin = 1.08; // paper left around the subject: four per cent on either side
constexpr std::size_t kMostSamples = 2'000'000;

struct Looking {
    glm::dvec3 direction;
    glm::dvec3 up;
};

Looking looking(StandardView view) {
    switch (view) {
    case StandardView::anterior: return {{0, 1, 0}, {0, 0, 1}};
    case StandardView::posterior: return {{0, -1, 0}, {0, 0, 1}};
    case StandardView::left: return {{-1, 0, 0}, {0, 0, 1}};
    case StandardView::right: return {{1, 0, 0}, {0, 0, 1}};
    case StandardView::superior: return {{0, 0, -1}, {0, -1, 0}};
    case StandardView::inferior: return {{0, 0, 1}, {0, -1, 0}};
    case StandardView::threeQuarter: break;
    }
    return {{0.52, 0.82, -0.2}, {0, 0, 1}};
}

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
};

/// Box, in the frame of `axes` (columns), of the voxels that show.
Box boxOf(const Volume& volume, const glm::dmat3& axes, const Shows& shows) {
    const Grid& grid = volume.grid();
    int stride = 1;
    while (grid.voxelCount() / static_cast<std::size_t>(stride * stride * stride) > kMostSamples) {
        ++stride;
    }
    const glm::dmat3 toFrame = glm::transpose(axes);
    const glm::ivec3 n = (grid.dims + stride - 1) / stride;
    std::vector<Box> boxes(static_cast<std::size_t>(n.z));
    tbb::parallel_for(0, n.z, [&](int k) {
        for (int j = 0; j < n.y; ++j) {
            for (int i = 0; i < n.x; ++i) {
                const glm::ivec3 v = glm::ivec3(i, j, k) * stride;
                // A lone voxel is noise, not the subject: its neighbours along x and y must show as well.
                const auto at = [&](int dx, int dy) { return volume.valueAt(v + glm::ivec3(dx, dy, 0)); };
                if (!shows.value(at(0, 0)) ||
                    shows.value(at(-1, 0)) + shows.value(at(1, 0)) + shows.value(at(0, -1)) + shows.value(at(0, 1)) <
                        2) {
                    continue;
                }
                const glm::dvec3 p = grid.mmFromVoxel(v);
                if (!shows.place || shows.place(p)) {
                    boxes[static_cast<std::size_t>(k)].add(toFrame * p);
                }
            }
        }
    });
    Box all;
    for (const Box& box : boxes) {
        if (!box.empty()) {
            all.add(box.low);
            all.add(box.high);
        }
    }
    return all;
}

Box boxOfCorners(const Grid& grid, const glm::dmat3& axes) {
    Box box;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 far(corner & 1, corner >> 1 & 1, corner >> 2);
        box.add(glm::transpose(axes) * grid.mmFromVoxel(far * glm::dvec3(grid.dims) - 0.5));
    }
    return box;
}

} // namespace

std::optional<BoxMm> boxOfMatter(const Volume& volume, const Shows& shows) {
    const Box box = boxOf(volume, glm::dmat3(1), shows);
    return box.empty() ? std::nullopt : std::optional(BoxMm{box.low, box.high});
}

Camera fittedCamera(const Volume& volume, Camera camera, const Shows& shows) {
    const ViewFrame view(camera, 1);
    const glm::dmat3 axes(view.right, view.up, view.forward);
    Box box = shows.value ? boxOf(volume, axes, shows) : Box{};
    const double voxel = glm::length(volume.grid().spacingMm);
    if (box.empty()) {
        box = boxOfCorners(volume.grid(), axes);
    } else {
        box.low -= 0.5 * voxel;
        box.high += 0.5 * voxel;
    }
    const glm::dvec3 size = box.high - box.low;
    camera.targetMm = axes * (0.5 * (box.low + box.high));
    camera.heightMm = kMargin * std::max({size.x, size.y, voxel});
    return camera;
}

Camera standardView(const Volume& volume, StandardView view, std::optional<double> matterAbove) {
    const Looking look = looking(view);
    Camera camera;
    camera.direction = look.direction;
    camera.up = look.up;
    Shows shows;
    if (matterAbove) {
        shows.value = [above = *matterAbove](double value) { return value > above ? 1 : 0; };
    }
    return fittedCamera(volume, camera, shows);
}

} // namespace limner
