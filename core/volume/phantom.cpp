#include "core/volume/phantom.h"

#include "core/volume/phantom_shapes.h"

#include <tbb/parallel_for.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

namespace limner {

namespace {

using phantom::Paint;
using phantom::Vec;

constexpr float kAirHu = -1000;
constexpr double kBoxMm = 240;
constexpr int kLargestCube = 16; // voxels per side that are decided together first
constexpr int kSmallestCube = 2; // below this the decision costs as much as the voxels

/// Share of a voxel inside the shape; the ramp reaches one voxel to either side, as a scanner's blur does.
float coverage(float distanceMm, float voxelMm) {
    const float t = std::clamp(0.5F - 0.5F * distanceMm / voxelMm, 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

/// Paints cubes of voxels from the coarse to the fine: most hold one tissue, or few shapes.
struct Painter {
    int size;
    float voxelMm;
    std::vector<std::int16_t>& voxels;

    /// The shapes that may vary inside a cube, over what fills it whole.
    struct Content {
        float base = kAirHu;
        std::vector<const Paint*> paints;
    };

    [[nodiscard]] Vec centre(const Vec& voxel) const {
        return (voxel + 0.5F) * voxelMm - static_cast<float>(kBoxMm / 2);
    }

    [[nodiscard]] Content narrowed(const Content& outer, const Vec& middle, float halfDiagonal) const {
        // The distances are estimates, up to about twice too large beside flat ellipsoids.
        const float reach = 2 * (halfDiagonal + voxelMm);
        Content inner{outer.base, {}};
        for (const Paint* paint : outer.paints) {
            const Vec outside = glm::max(glm::abs(middle - paint->middle) - paint->half, Vec(0));
            if (glm::dot(outside, outside) > reach * reach) {
                continue;
            }
            const float d = paint->distance(middle);
            if (d + paint->layers.back().insetMm < -reach) {
                inner = {paint->layers.back().hu, {}};
            } else if (d + paint->layers.front().insetMm < reach) {
                inner.paints.push_back(paint);
            }
        }
        return inner;
    }

    void cube(glm::ivec3 first, int edge, const Content& outer) const {
        const glm::ivec3 end = glm::min(first + edge, glm::ivec3((size + 1) / 2, size, size));
        if (first.x >= end.x || first.y >= end.y || first.z >= end.z) {
            return;
        }
        Vec middle = centre(Vec(first) + 0.5F * static_cast<float>(edge - 1));
        middle.x = -middle.x; // rows begin on the patient's right, shapes lie on the left
        const float halfDiagonal = 0.5F * static_cast<float>(edge) * voxelMm * 1.7320508F;
        const Content content = narrowed(outer, middle, halfDiagonal);
        if (content.paints.empty() || edge <= kSmallestCube) {
            fill(first, end, content);
            return;
        }
        for (int i = 0; i < 8; ++i) {
            cube(first + glm::ivec3(i & 1, i >> 1 & 1, i >> 2) * (edge / 2), edge / 2, content);
        }
    }

    /// Both halves of the head.
    void fill(glm::ivec3 first, glm::ivec3 end, const Content& content) const {
        for (int z = first.z; z < end.z; ++z) {
            for (int y = first.y; y < end.y; ++y) {
                std::int16_t* row = voxels.data() + (static_cast<std::size_t>(z) * static_cast<std::size_t>(size) +
                                                     static_cast<std::size_t>(y)) *
                                                        static_cast<std::size_t>(size);
                for (int x = first.x; x < end.x; ++x) {
                    float hu = content.base;
                    const Vec p = centre({size - 1 - x, y, z});
                    for (const Paint* paint : content.paints) {
                        const float d = paint->distance(p);
                        for (const phantom::Layer& layer : paint->layers) {
                            hu += (layer.hu - hu) * coverage(d + layer.insetMm, voxelMm);
                        }
                    }
                    row[x] = row[size - 1 - x] = static_cast<std::int16_t>(std::lround(hu));
                }
            }
        }
    }
};

} // namespace

std::shared_ptr<const Volume> makeHeadPhantom(int size) {
    assert(size > 0);
    const double voxelMm = kBoxMm / size;
    const auto n = static_cast<std::size_t>(size);
    std::vector<std::int16_t> voxels(n * n * n);
    const std::vector<Paint> paints = phantom::headPaints();
    const Painter painter{size, static_cast<float>(voxelMm), voxels};
    Painter::Content all;
    for (const Paint& paint : paints) {
        all.paints.push_back(&paint);
    }
    const int cubes = (size + kLargestCube - 1) / kLargestCube;
    tbb::parallel_for(0, cubes * cubes, [&](int zy) {
        for (int x = 0; x < cubes; ++x) {
            painter.cube(glm::ivec3(x, zy % cubes, zy / cubes) * kLargestCube, kLargestCube, all);
        }
    });
    Volume::Contents contents;
    contents.grid.dims = glm::ivec3(size);
    contents.grid.spacingMm = glm::dvec3(voxelMm);
    contents.grid.originMm = glm::dvec3(0.5 * (voxelMm - kBoxMm));
    contents.type = VoxelType::int16;
    contents.modality = Modality::ct;
    contents.unit = "HU";
    const auto [low, high] = std::minmax_element(voxels.begin(), voxels.end());
    contents.range = {static_cast<double>(*low), static_cast<double>(*high)};
    return std::make_shared<const Volume>(contents, std::as_bytes(std::span(voxels)));
}

} // namespace limner
