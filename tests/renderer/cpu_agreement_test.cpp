#include "renderer/accuracy/analytic_scenes.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>

#include <hwy/targets.h>

#include <cmath>
#include <numbers>

// The SIMD backend against the reference, and one instruction set against the other.

namespace limner {
namespace {

using accuracy::AnalyticScene;
using testing::planOf;
using testing::renderWhole;

/// A smooth field with curvature everywhere, as the given kind of voxels.
std::shared_ptr<const Volume> smoothVolume(VoxelType type) {
    Grid grid = accuracy::centredGrid(40, 1);
    grid.spacingMm = {1, 1.25, 0.8};
    grid.direction = glm::dmat3({0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1});
    grid.originMm = -grid.direction * (grid.spacingMm * 19.5);
    const auto value = [](const glm::dvec3& mm) {
        return std::exp(-glm::dot(mm, mm) / 180) *
               (1 + 0.15 * std::sin(0.35 * mm.x) * std::cos(0.3 * mm.y + 0.2 * mm.z));
    };
    const auto smooth = accuracy::sampleField(grid, value);
    if (type == VoxelType::float32) {
        return smooth;
    }
    Volume::Contents contents = smooth->contents();
    contents.type = type;
    const bool bytes = type == VoxelType::uint8;
    const double low = bytes ? 0 : -30000;
    const double high = bytes ? 255 : 30000;
    const ValueRange range = smooth->range();
    contents.slope = (range.high - range.low) / (high - low);
    contents.intercept = range.low - contents.slope * low;
    std::vector<std::byte> stored;
    for (int z = 0; z < grid.dims.z; ++z) {
        for (int y = 0; y < grid.dims.y; ++y) {
            for (int x = 0; x < grid.dims.x; ++x) {
                const double number = std::round((smooth->valueAt({x, y, z}) - contents.intercept) / contents.slope);
                const auto word = static_cast<std::uint16_t>(static_cast<std::int16_t>(number));
                stored.push_back(static_cast<std::byte>(word & 0xFFU));
                if (!bytes) {
                    stored.push_back(static_cast<std::byte>(word >> 8U));
                }
            }
        }
    }
    return std::make_shared<const Volume>(contents, stored);
}

std::shared_ptr<const LitSphere> smoothSphere(bool directional) {
    constexpr int size = 256;
    std::vector<Rgba> pixels;
    for (int i = 0; i < size * size; ++i) {
        const double x = (i % size + 0.5) / size;
        const double y = (i / size + 0.5) / size;
        pixels.push_back({static_cast<float>(0.5 + 0.4 * std::sin(3 * x)),
                          static_cast<float>(0.5 + 0.4 * std::cos(2 * x + y)), static_cast<float>(x * y),
                          directional ? static_cast<float>(0.3 + 0.6 * x) : 1.0F});
    }
    return std::make_shared<const LitSphere>(size, std::move(pixels));
}

enum class Look { flat, phong, style, directional, twoLayers };

AnalyticScene smoothScene(VoxelType type, Look look, Projection projection) {
    Camera camera;
    camera.projection = projection;
    camera.direction = {0.3, 0.9, -0.4};
    camera.heightMm = 44;
    AnalyticScene scene{"smooth", accuracy::plainFigure(smoothVolume(type), camera), {}};
    scene.request.size = {64, 64};
    scene.figure.quality.stepVoxels = 0.4;
    StyleEntry entry;
    entry.id = "style";
    entry.sphere = smoothSphere(look == Look::directional);
    scene.figure.styles = {entry};
    Layer& layer = scene.figure.layers.front();
    layer.transfer.opacity = {{0.1, 0}, {0.9, 0.25}};
    layer.transfer.nodes = {{0.1, "", glm::dvec3(0.9, 0.2, 0.1)}, {0.8, "", glm::dvec3(0.2, 0.6, 0.9)}};
    layer.shading = look == Look::flat ? Shading::flat : look == Look::phong ? Shading::phong : Shading::style;
    if (layer.shading == Shading::style) {
        layer.transfer.nodes = {{0.1, "style", std::nullopt}, {0.8, "", glm::dvec3(0.2, 0.6, 0.9)}};
    }
    if (look == Look::twoLayers) {
        Layer core = layer;
        core.shading = Shading::phong;
        core.transfer.opacity = {{0.5, 0}, {0.9, 0.5}};
        core.transfer.nodes = {{0.5, "", glm::dvec3(0.9, 0.9, 0.2)}};
        scene.figure.layers.push_back(core);
    }
    return scene;
}

struct Case {
    const char* name;
    Look look;
    Projection projection;
};

class CpuAgreement : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(With, CpuAgreement,
                         ::testing::Values(Case{"flat", Look::flat, Projection::orthographic},
                                           Case{"phong", Look::phong, Projection::orthographic},
                                           Case{"phongPerspective", Look::phong, Projection::perspective},
                                           Case{"style", Look::style, Projection::orthographic},
                                           Case{"stylePerspective", Look::style, Projection::perspective},
                                           Case{"directional", Look::directional, Projection::orthographic},
                                           Case{"twoLayers", Look::twoLayers, Projection::perspective}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(CpuAgreement, WithTheReferenceOnSmoothScenes) {
    for (const VoxelType type : {VoxelType::float32, VoxelType::int16, VoxelType::uint8}) {
        const auto plan = planOf(smoothScene(type, GetParam().look, GetParam().projection));
        const Picture exact = renderWhole(*makeReferenceBackend(), *plan);
        const Picture fast = renderWhole(*makeCpuBackend(), *plan);
        EXPECT_GT(exact.pixel(32, 32)[3], 0.5);
        EXPECT_LT(testing::rootMeanSquare(fast, exact), 1e-4) << static_cast<int>(type);
        EXPECT_LT(testing::largestDifference(fast, exact), 2e-3)
            << static_cast<int>(type); // no lost pixel hides in the mean
        ::testing::Test::RecordProperty(std::string("rmse") + std::to_string(static_cast<int>(type)),
                                        std::to_string(testing::rootMeanSquare(fast, exact)));
    }
}

TEST_P(CpuAgreement, OfTheInstructionSets) {
    for (const VoxelType type : {VoxelType::float32, VoxelType::int16, VoxelType::uint8}) {
        const auto plan = planOf(smoothScene(type, GetParam().look, GetParam().projection));
        const auto backend = makeCpuBackend();
        const Picture best = renderWhole(*backend, *plan);
        int compared = 0;
        for (const auto target : hwy::SupportedAndGeneratedTargets()) {
            hwy::SetSupportedTargetsForTest(target);
            hwy::GetChosenTarget().DeInit();
            const std::string name = backend->name();
            const Picture picture = renderWhole(*backend, *plan);
            EXPECT_LT(testing::largestDifference(picture, best), 1e-5) << name << ' ' << static_cast<int>(type);
            ++compared;
        }
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().DeInit();
        EXPECT_GE(compared, 1);
        if (type == VoxelType::float32) {
            std::cout << compared << " instruction sets compared\n";
        }
    }
}

} // namespace
} // namespace limner
