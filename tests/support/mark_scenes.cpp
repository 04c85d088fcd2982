#include "support/mark_scenes.h"

#include "renderer/marks/draw_marks.h"
#include "support/make_volume.h"

#include <algorithm>
#include <cmath>

namespace limner::testing {

std::shared_ptr<const Volume> bodyVolume(int edge, const std::function<double(const glm::dvec3&)>& distanceMm) {
    Grid grid = gridOf(glm::ivec3(edge));
    grid.originMm = glm::dvec3(-0.5 * (edge - 1));
    return makeVolume<std::uint8_t>(grid, VoxelType::uint8, [&](const glm::ivec3& voxel) {
        return std::lround(255 * std::clamp(0.5 - 0.5 * distanceMm(grid.mmFromVoxel(glm::dvec3(voxel))), 0.0, 1.0));
    });
}

std::shared_ptr<const Volume> slabVolume(int edge) {
    return bodyVolume(edge, [](const glm::dvec3& p) { return p.z; });
}

Figure inkFigure(std::shared_ptr<const Volume> volume, double paperMm, double heightMm) {
    Figure figure;
    figure.volume.emplace().data = std::move(volume);
    figure.output.widthMm = figure.output.heightMm = paperMm;
    figure.camera.heightMm = heightMm;
    figure.stipple.emplace().layerOpacity = "alone";
    return figure;
}

void lookFromAbove(Figure& figure) {
    figure.camera.direction = {0, 0, -1};
    figure.camera.up = {0, 1, 0};
}

std::shared_ptr<const RenderPlan> markPlan(const Figure& figure, bool moving) {
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {64, 64};
    request.moving = moving;
    return planner.plan(figure, request, task);
}

Marks marksOf(const Figure& figure, bool moving) {
    Task task;
    return drawMarks(*markPlan(figure, moving), task);
}

std::vector<Dot> allDots(const Marks& marks) {
    std::vector<Dot> all;
    for (const MarkGroup& group : marks.groups) {
        all.insert(all.end(), group.dots.begin(), group.dots.end());
    }
    return all;
}

double inkedShare(const Marks& marks, double lowMm, double highMm) {
    const std::vector<Dot> dots = allDots(marks);
    double largest = 0;
    for (const Dot& dot : dots) {
        largest = std::max(largest, static_cast<double>(dot.radiusMm));
    }
    if (!(largest > 0)) {
        return 0;
    }
    const int n = static_cast<int>(std::ceil((highMm - lowMm) / (0.1 * largest)));
    const double step = (highMm - lowMm) / n;
    std::vector<float> clear(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 1.0F);
    for (const Dot& dot : dots) {
        const glm::dvec2 middle = (glm::dvec2(dot.placeMm) - lowMm) / step - 0.5;
        const double radius = static_cast<double>(dot.radiusMm) / step;
        for (int y = std::max(0, static_cast<int>(std::ceil(middle.y - radius)));
             y <= std::min(n - 1, static_cast<int>(std::floor(middle.y + radius))); ++y) {
            const double half = std::sqrt(radius * radius - (y - middle.y) * (y - middle.y));
            for (int x = std::max(0, static_cast<int>(std::ceil(middle.x - half)));
                 x <= std::min(n - 1, static_cast<int>(std::floor(middle.x + half))); ++x) {
                clear[static_cast<std::size_t>(y) * static_cast<std::size_t>(n) + static_cast<std::size_t>(x)] *=
                    1 - dot.opacity;
            }
        }
    }
    double sum = 0;
    for (const float share : clear) {
        sum += static_cast<double>(1 - share);
    }
    return sum / static_cast<double>(clear.size());
}

} // namespace limner::testing
