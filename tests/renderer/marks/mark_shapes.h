#pragma once

#include "core/base/error.h"
#include "renderer/marks/mark_field.h"
#include "renderer/marks/mark_view.h"
#include "renderer/marks/marks.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

namespace limner::testing {

/// Signed distance from a surface in mm, negative inside.
using Shape = std::function<double(const glm::dvec3& mm)>;

inline Shape ball(double radius, glm::dvec3 middle = glm::dvec3(0)) {
    return [=](const glm::dvec3& p) { return glm::distance(p, middle) - radius; };
}
/// Around the z axis.
inline Shape torus(double radius, double tube) {
    return [=](const glm::dvec3& p) { return std::hypot(std::hypot(p.x, p.y) - radius, p.z) - tube; };
}
/// Along the z axis, without ends.
inline Shape cylinder(double radius) {
    return [=](const glm::dvec3& p) { return std::hypot(p.x, p.y) - radius; };
}
inline Shape roundedCube(double half, double rounding) {
    return [=](const glm::dvec3& p) {
        const glm::dvec3 q = glm::abs(p) - (half - rounding);
        return glm::length(glm::max(q, glm::dvec3(0))) + std::min(std::max({q.x, q.y, q.z}), 0.0) - rounding;
    };
}

inline MarkVoxel voxelAt(glm::ivec3 cell, double distance, const glm::dvec3& normal, double voxelMm) {
    MarkVoxel voxel;
    voxel.cell = glm::u16vec3(cell);
    voxel.normalMm = glm::vec3(normal);
    const double d = distance / (0.8 * voxelMm);
    voxel.gradient = static_cast<float>(std::exp(-0.5 * d * d));
    voxel.value = static_cast<float>(0.5 * std::erfc(d / std::numbers::sqrt2));
    voxel.edge = static_cast<float>(0.4 * d * voxel.gradient);
    voxel.share = 0.4F * voxel.gradient;
    voxel.edgeOffsetMm = static_cast<float>(std::clamp(-distance, -voxelMm, voxelMm));
    return voxel;
}

/// Principal curvatures of a shape's level surface from its second differences.
inline MarkCurvature curvatureOf(const Shape& shape, const glm::dvec3& mm, const glm::dvec3& n) {
    constexpr double h = 1e-2;
    const glm::dvec3 u = glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 w = glm::cross(n, u);
    const auto second = [&](const glm::dvec3& a) {
        return (shape(mm + h * a) - 2 * shape(mm) + shape(mm - h * a)) / (h * h);
    };
    const double uu = second(u);
    const double ww = second(w);
    const double uw = second((u + w) / std::numbers::sqrt2) - 0.5 * (uu + ww);
    const double mean = 0.5 * (uu + ww);
    const double apart = std::hypot(0.5 * (uu - ww), uw);
    const double sign = mean >= 0 ? 1 : -1;
    MarkCurvature c;
    c.most = static_cast<float>(mean + sign * apart);
    c.least = static_cast<float>(mean - sign * apart);
    if (apart > 1e-4) {
        const double angle = 0.5 * std::atan2(uw, 0.5 * (uu - ww)) + (sign > 0 ? 0 : std::numbers::pi / 2);
        c.directionMm = glm::vec3(std::cos(angle) * u + std::sin(angle) * w);
    }
    return c;
}

/// Voxels within 1.8 voxels of the surface, with its exact normals and curvatures. The grid's middle is near (0, 0, 0).
inline MarkField fieldOf(const Shape& shape, int dims, double voxelMm) {
    MarkField field;
    field.grid.dims = glm::ivec3(dims);
    field.grid.spacingMm = glm::dvec3(voxelMm);
    field.grid.originMm = glm::dvec3(-0.5 * (dims - 1) * voxelMm) + voxelMm * glm::dvec3(0.13, 0.29, 0.41);
    field.stepMm = field.grid.voxelToMmMatrix();
    field.mmPerVoxel = voxelMm;
    field.layerNames = {""};
    field.rowStart = {0};
    constexpr double h = 1e-4;
    for (int z = 0; z < dims; ++z) {
        for (int y = 0; y < dims; ++y) {
            for (int x = 0; x < dims; ++x) {
                const glm::dvec3 mm = field.grid.mmFromVoxel(glm::dvec3(x, y, z));
                const double d = shape(mm);
                if (std::abs(d) < 1.8 * voxelMm) {
                    const glm::dvec3 n =
                        glm::normalize(glm::dvec3(shape(mm + glm::dvec3(h, 0, 0)) - shape(mm - glm::dvec3(h, 0, 0)),
                                                  shape(mm + glm::dvec3(0, h, 0)) - shape(mm - glm::dvec3(0, h, 0)),
                                                  shape(mm + glm::dvec3(0, 0, h)) - shape(mm - glm::dvec3(0, 0, h))));
                    field.voxels.push_back(voxelAt({x, y, z}, d, n, voxelMm));
                    field.curvatures.push_back(curvatureOf(shape, mm, n));
                }
            }
            field.rowStart.push_back(static_cast<std::uint32_t>(field.voxels.size()));
        }
    }
    return field;
}

/// A view of a square sheet of paper.
inline MarkView viewOf(glm::dvec3 direction, double heightMm, double paperMm, double fovDeg = 0) {
    auto figure = std::make_shared<Figure>();
    figure->camera.direction = direction;
    figure->camera.up =
        std::abs(direction.z) > 0.9 * glm::length(direction) ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    figure->camera.heightMm = heightMm;
    if (fovDeg > 0) {
        figure->camera.projection = Projection::perspective;
        figure->camera.fovDeg = fovDeg;
    }
    figure->output.widthMm = paperMm;
    figure->output.heightMm = paperMm;
    RenderPlan plan;
    plan.figure = figure;
    return MarkView(plan);
}

inline std::size_t strokesIn(const std::vector<MarkGroup>& groups) {
    std::size_t count = 0;
    for (const MarkGroup& group : groups) {
        count += group.strokes.size();
    }
    return count;
}

inline bool closedStroke(const MarkGroup& group, const Stroke& stroke) {
    return group.points[stroke.first].placeMm == group.points[stroke.first + stroke.count - 1].placeMm;
}

inline bool sameMarks(const std::vector<MarkGroup>& a, const std::vector<MarkGroup>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const MarkGroup& x, const MarkGroup& y) {
        return x.name == y.name &&
               std::equal(x.points.begin(), x.points.end(), y.points.begin(), y.points.end(),
                          [](const StrokePoint& p, const StrokePoint& q) {
                              return p.placeMm == q.placeMm && p.widthMm == q.widthMm;
                          }) &&
               std::equal(x.strokes.begin(), x.strokes.end(), y.strokes.begin(), y.strokes.end(),
                          [](const Stroke& p, const Stroke& q) {
                              return p.first == q.first && p.count == q.count && p.opacity == q.opacity;
                          });
    });
}

} // namespace limner::testing
