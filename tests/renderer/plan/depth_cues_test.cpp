#include "renderer/plan/depth_cues.h"

#include "core/style/ramps.h"
#include "renderer/plan/coarse_opacity.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace limner {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

Grid unitGrid(glm::ivec3 dims) {
    Grid grid;
    grid.dims = dims;
    return grid;
}

CueField clearField(glm::ivec3 dims) {
    return {dims, 1, 1, std::vector<float>(static_cast<std::size_t>(dims.x * dims.y * dims.z), 0.0F)};
}

float& at(CueField& field, glm::ivec3 cell) {
    return field.values[static_cast<std::size_t>((cell.z * field.dims.y + cell.y) * field.dims.x + cell.x)];
}

float at(const std::vector<float>& values, glm::ivec3 dims, glm::ivec3 cell) {
    return values[static_cast<std::size_t>((cell.z * dims.y + cell.y) * dims.x + cell.x)];
}

TEST(Occlusion, FallsWithDistanceAlongEveryAxis) {
    const glm::ivec3 dims(9, 9, 9);
    CueField field = clearField(dims);
    at(field, {4, 4, 4}) = 0.8F;
    const double reach = 3;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
            glm::dvec3 towards(0);
            towards[axis] = sign;
            const auto occlusion = occlusionTowards(field, unitGrid(dims), towards, reach);
            for (int distance = 1; distance <= 4; ++distance) {
                glm::ivec3 cell(4);
                cell[axis] -= sign * distance;
                EXPECT_NEAR(at(occlusion, dims, cell), 0.8 * std::exp(-(distance - 1) / reach), 1e-6)
                    << axis << sign << distance;
            }
            glm::ivec3 beyond(4);
            beyond[axis] += sign;
            EXPECT_EQ(at(occlusion, dims, beyond), 0);
            EXPECT_EQ(at(occlusion, dims, {4, 4, 4}), 0) << "a cell does not shade itself";
        }
    }
}

TEST(Occlusion, OfSeveralCellsComposes) {
    const glm::ivec3 dims(3, 3, 8);
    CueField field = clearField(dims);
    for (int z = 4; z < 7; ++z) {
        at(field, {1, 1, z}) = 0.5F;
    }
    const auto occlusion = occlusionTowards(field, unitGrid(dims), {0, 0, 1}, kUnbounded);
    EXPECT_NEAR(at(occlusion, dims, {1, 1, 0}), 1 - 0.125, 1e-6);
    EXPECT_NEAR(at(occlusion, dims, {1, 1, 5}), 0.5, 1e-6);
}

TEST(Occlusion, AlongADiagonalHitsWhatLiesThere) {
    const glm::ivec3 dims(9, 9, 9);
    CueField field = clearField(dims);
    at(field, {6, 6, 6}) = 1;
    const auto occlusion = occlusionTowards(field, unitGrid(dims), glm::normalize(glm::dvec3(1, 1, 1)), kUnbounded);
    EXPECT_NEAR(at(occlusion, dims, {2, 2, 2}), 1, 1e-6);
    EXPECT_EQ(at(occlusion, dims, {2, 4, 2}), 0);
}

TEST(Occlusion, KnowsTheGridsDirections) {
    // Spacing 2 along x: towards (2, 0, 1) mm is one cell along x and one along z.
    Grid grid = unitGrid({7, 3, 7});
    grid.spacingMm = {2, 1, 1};
    CueField field = clearField(grid.dims);
    at(field, {5, 1, 5}) = 1;
    const auto occlusion = occlusionTowards(field, grid, glm::normalize(glm::dvec3(2, 0, 1)), kUnbounded);
    EXPECT_NEAR(at(occlusion, grid.dims, {2, 1, 2}), 1, 1e-6);
}

std::shared_ptr<const RenderPlan> planOfCues(const std::function<void(Figure&)>& change) {
    Figure figure = testing::smoothFigure({});
    change(figure);
    PlanRequest request;
    request.size = {24, 24};
    return testing::planOf(figure, request);
}

CueField opacityOn(const RenderPlan& plan, int voxelsPerCell) {
    Task task;
    return coarseOpacity(plan, voxelsPerCell, task);
}

TEST(CoarseOpacity, IsThatOfItsVoxels) {
    const auto plan = planOfCues([](Figure&) {});
    const CueField fine = opacityOn(*plan, 1);
    const TransferTable& table = plan->layers.front().table;
    for (const glm::ivec3 voxel : {glm::ivec3(15, 17, 16), glm::ivec3(3, 20, 9), glm::ivec3(10, 12, 14)}) {
        const double value = plan->volume->valueAt(voxel);
        const double entry =
            (value - table.low) / (table.high - table.low) * static_cast<double>(table.opacity.size() - 1);
        const float expected = table.opacity[static_cast<std::size_t>(std::lround(entry))];
        EXPECT_NEAR(at(fine.values, fine.dims, voxel), expected, 1e-6);
    }
    const CueField coarse = opacityOn(*plan, 3);
    EXPECT_EQ(coarse.dims, (plan->volume->grid().dims + 2) / 3);
}

TEST(CoarseOpacity, OfEightBitVoxelsIsThatOfFullOnes) {
    const auto at = [](VoxelPrecision precision) {
        testing::SmoothScene scene;
        scene.type = VoxelType::int16;
        Figure figure = testing::smoothFigure(scene);
        figure.quality.precision = precision;
        PlanRequest request;
        request.size = {24, 24};
        const auto plan = testing::planOf(figure, request);
        EXPECT_EQ(plan->volume->type() == VoxelType::uint8, precision == VoxelPrecision::eightBits);
        return opacityOn(*plan, 4);
    };
    const CueField full = at(VoxelPrecision::full);
    const CueField eight = at(VoxelPrecision::eightBits);
    for (std::size_t i = 0; i < full.values.size(); ++i) {
        EXPECT_NEAR(full.values[i], eight.values[i], 0.01) << i; // 1/256 of the values, on ramps of slope 1 or so
    }
}

TEST(CoarseOpacity, GoesByEveryAxisThatAPlaceTells) {
    const auto sum = [](const std::function<void(Layer&)>& change) {
        const auto plan = planOfCues([&](Figure& f) {
            f.layers[0].transfer.distance.emplace().fromMm = f.volume->data->grid().centreMm();
            change(f.layers[0]);
        });
        double all = 0;
        for (const float v : opacityOn(*plan, 2).values) {
            all += v;
        }
        return all;
    };
    for (const char* axis : {"gradient", "distance", "second", "label"}) {
        const double plane = sum([&](Layer& l) { testing::makePlane(l, "value", axis); });
        const double line = sum([&](Layer& l) { testing::makeLine(l, axis); });
        EXPECT_GT(plane, 10) << axis;
        EXPECT_GT(line, 10) << axis;
        const double cells = 15 * 17 * 16;
        EXPECT_LT(plane, 0.6 * cells) << axis << ": not the most of the curve everywhere";
    }
    EXPECT_EQ(sum([](Layer& l) { testing::makeLine(l, "curvature"); }), 0) << "known along rays only";
}

TEST(CoarseOpacity, LeavesOutWhatIsCutAway) {
    const auto count = [](const RenderPlan& plan) {
        double sum = 0;
        for (const float v : opacityOn(plan, 2).values) {
            sum += v;
        }
        return sum;
    };
    const double whole = count(*planOfCues([](Figure&) {}));
    const glm::dvec3 middle = planOfCues([](Figure&) {})->volume->grid().centreMm();
    const ClipPlane plane{{1, 0, 0}, middle.x};
    const double ofFigure = count(*planOfCues([&](Figure& f) { f.clip.planes = {plane}; }));
    const double ofLayer = count(*planOfCues([&](Figure& f) { f.layers[0].clip.emplace().planes = {plane}; }));
    EXPECT_GT(whole, 10);
    EXPECT_NEAR(ofFigure / whole, 0.5, 0.1);
    EXPECT_EQ(ofFigure, ofLayer);
    const double faded = count(*planOfCues([&](Figure& f) {
        f.layers[0].position.emplace().ramp = {{0, {1, 1, 1, 0.25}}};
    }));
    EXPECT_NEAR(faded / whole, 0.25, 1e-5);
}

TEST(DepthCuePlans, HoldWhatTheFigureAsksForAndNoMore) {
    EXPECT_FALSE(planOfCues([](Figure&) {})->cues);
    const auto ambient = planOfCues([](Figure& f) { f.depthCues.emplace().ambientOcclusion.emplace(); });
    ASSERT_TRUE(ambient->cues);
    EXPECT_TRUE(ambient->cues->ambient);
    EXPECT_FALSE(ambient->cues->shadow || ambient->cues->halo);
    const auto off = planOfCues([](Figure& f) {
        f.depthCues.emplace().ambientOcclusion.emplace().strength = 0;
        f.depthCues->halo.emplace().strength = 0;
    });
    EXPECT_FALSE(off->cues) << "no strength, no field";
}

} // namespace
} // namespace limner
