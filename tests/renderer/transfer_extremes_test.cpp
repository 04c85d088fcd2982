#include "core/volume/import.h"
#include "support/make_volume.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <unistd.h>

// Extremes of data (numerics.md 2f) with every feature of transfer functions on.

namespace limner {
namespace {

using testing::planOf;
using testing::renderWhole;

std::shared_ptr<const RenderPlan> plan16(const Figure& figure) {
    PlanRequest request;
    request.size = {16, 16};
    const auto& grid = figure.volume->data->grid();
    // A hundred samples on a diagonal, but steps no longer than a voxel.
    request.lattice = SampleLattice{std::min(glm::length(grid.sizeMm()) / 100, grid.smallestSpacingMm()), 0.5, 0};
    return planOf(figure, request);
}

class TransferExtremes : public ::testing::TestWithParam<std::size_t> {
  protected:
    /// The feature on a smooth scene of these extents.
    [[nodiscard]] static Figure figureOf(const testing::SmoothScene& scene) {
        Figure figure = testing::smoothFigure(scene);
        testing::transferFeatures()[GetParam()].apply(figure);
        return figure;
    }
    /// Looks at another volume instead, labels and all on its grid.
    static void replace(Figure& figure, std::shared_ptr<const Volume> volume) {
        figure.labels->data = testing::makeVolume<std::uint8_t>(
            volume->grid(), VoxelType::uint8, [](const glm::ivec3& v) { return (v.x + v.y) % 3 == 0 ? 3 : 7; });
        figure.camera.targetMm = volume->grid().centreMm();
        figure.camera.heightMm = glm::length(volume->grid().sizeMm()) * 0.7;
        figure.volume->data = std::move(volume);
    }
    static void expectSoundAndAlike(const Figure& figure, double bound, const std::string& what) {
        const auto plan = plan16(figure);
        const Picture exact = renderWhole(*makeReferenceBackend(), *plan);
        const Picture fast = renderWhole(*makeCpuBackend(), *plan);
        EXPECT_EQ(testing::unsoundPixels(exact), 0) << what;
        EXPECT_EQ(testing::unsoundPixels(fast), 0) << what;
        EXPECT_LT(testing::rootMeanSquare(exact, fast), bound) << what;
    }
};

INSTANTIATE_TEST_SUITE_P(Of, TransferExtremes, ::testing::Range(std::size_t{0}, testing::transferFeatures().size()),
                         [](const auto& one) { return testing::transferFeatures()[one.param].name; });

// Tables are not made to measure here (see transfer_agreement_test.cpp).
constexpr double kBound = 2e-4;
// Pixels of many voxels: styles are drawn from a coarser mip level, the reference's from the picture itself.
constexpr double kCoarseStyles = 2e-3;

TEST_P(TransferExtremes, ConstantVolumes) {
    for (const double value : {0.5, 0.0}) {
        Figure figure = figureOf({});
        const Grid grid = testing::gridOf({12, 11, 10});
        replace(figure, testing::makeVolume<float>(
                            grid, VoxelType::float32, [](const glm::ivec3&) { return 0.0F; }, 1, value));
        expectSoundAndAlike(figure, kBound, "float " + std::to_string(value));
        replace(figure, testing::makeVolume<std::uint8_t>(
                            grid, VoxelType::uint8, [](const glm::ivec3&) { return 7; }, 0.1, value - 0.7));
        expectSoundAndAlike(figure, kBound, "uint8 " + std::to_string(value));
    }
}

TEST_P(TransferExtremes, AxesOfOneVoxel) {
    for (const glm::ivec3 dims : {glm::ivec3(20, 18, 1), glm::ivec3(1, 20, 18), glm::ivec3(1, 17, 1), glm::ivec3(1)}) {
        Figure figure = figureOf({});
        replace(figure, testing::makeVolume<std::int16_t>(
                            testing::gridOf(dims), VoxelType::int16,
                            [](const glm::ivec3& v) { return 50 * v.x + 30 * v.y + 20 * v.z + 100; }, 1e-3, 0));
        expectSoundAndAlike(figure, kBound, std::to_string(dims.x) + "x" + std::to_string(dims.y));
    }
}

TEST_P(TransferExtremes, SpacingsOfOneToAThousand) {
    Figure figure = figureOf({});
    Grid grid = testing::gridOf({20, 18, 14});
    grid.spacingMm = {1, 1, 1000};
    replace(figure, testing::makeVolume<float>(grid, VoxelType::float32, [](const glm::ivec3& v) {
                return 0.5 + 0.3 * std::sin(0.3 * v.x) * std::cos(0.2 * v.y) + 0.02 * v.z;
            }));
    figure.camera.direction = {0.2, 0.9, 0.004};
    figure.camera.heightMm = 100;
    expectSoundAndAlike(figure, kCoarseStyles, "1:1000");
}

/// Moves a transfer function to another unit of the data.
void scaleTransfer(Transfer& transfer, double factor) {
    if (transfer.kind == TransferKind::oneDimensional) {
        const double own = transfer.axis == "value" ? factor : 1;
        for (std::size_t k = 0; k < transfer.nodes.size(); ++k) {
            transfer.nodes[k].at *= own;
            transfer.opacity[k].x *= own;
        }
        return;
    }
    const auto scale = [&](std::vector<double>& positions, const std::string& axis) {
        for (double& position : positions) {
            position *= axis == "value" ? factor : 1;
        }
    };
    scale(transfer.grid->x, transfer.axes[0]);
    scale(transfer.grid->y, transfer.axes[1]);
    for (OpacityShape& shape : transfer.opacity2d) {
        scale(shape.x, transfer.axes[0]);
        scale(shape.y, transfer.axes[1]);
    }
}

/// The same figure in another unit of the data.
void scaleValues(Figure& figure, double factor) {
    Volume::Contents contents = figure.volume->data->contents();
    const glm::ivec3 dims = contents.grid.dims;
    const auto old = figure.volume->data;
    std::vector<float> stored;
    for (int i = 0; i < dims.x * dims.y * dims.z; ++i) {
        const glm::ivec3 at(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y));
        stored.push_back(static_cast<float>(old->storedAt(at)));
    }
    contents.slope *= factor;
    contents.intercept *= factor;
    contents.range = {contents.range.low * factor, contents.range.high * factor};
    figure.volume->data = std::make_shared<const Volume>(contents, std::as_bytes(std::span(stored)));
    for (Layer& layer : figure.layers) {
        scaleTransfer(layer.transfer, factor);
    }
}

TEST_P(TransferExtremes, AnyUnitOfTheDataIsTheSamePicture) {
    for (const auto& backend : {makeCpuBackend(), makeReferenceBackend()}) {
        Figure ordinary = figureOf({});
        const Picture picture = renderWhole(*backend, *plan16(ordinary));
        EXPECT_EQ(testing::unsoundPixels(picture), 0);
        for (const int exponent : {-140, -60, 60, 120}) {
            Figure scaled = figureOf({});
            scaleValues(scaled, std::ldexp(1.0, exponent));
            const Picture other = renderWhole(*backend, *plan16(scaled));
            EXPECT_EQ(testing::unsoundPixels(other), 0) << exponent;
            EXPECT_LT(testing::largestDifference(picture, other), 1e-5) << backend->name() << " 2^" << exponent;
        }
    }
}

/// The smooth scene's voxels as a file keeps them, one of them replaced.
std::shared_ptr<const Volume> importedWith(float voxel) {
    const auto smooth = testing::smoothFigure({}).volume->data;
    const glm::ivec3 dims = smooth->grid().dims;
    std::vector<float> values;
    for (int i = 0; i < dims.x * dims.y * dims.z; ++i) {
        values.push_back(static_cast<float>(smooth->valueAt({i % dims.x, i / dims.x % dims.y, i / dims.x / dims.y})));
    }
    const float lowest = *std::min_element(values.begin(), values.end());
    const int middle = (dims.z / 2 * dims.y + dims.y / 2) * dims.x + dims.x / 2;
    values[static_cast<std::size_t>(middle)] = std::isnan(voxel) ? voxel : lowest;
    const auto path =
        std::filesystem::temp_directory_path() / ("limner-transfer-extremes-" + std::to_string(::getpid()) + ".raw");
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(float)));
    ImportOptions options;
    options.raw =
        std::to_string(dims.x) + "x" + std::to_string(dims.y) + "x" + std::to_string(dims.z) + ":float32:le:1,1.25,0.8";
    Task task;
    auto imported = importVolume(path, options, task);
    std::filesystem::remove(path);
    return imported.volume;
}

TEST(TransferHoles, ANanVoxelGivesTheMaskedPicture) {
    const auto holed = importedWith(std::numeric_limits<float>::quiet_NaN());
    const auto masked = importedWith(0);
    ASSERT_EQ(holed->contents().nonFinite, 1U);
    for (const testing::TransferFeature& feature : testing::transferFeatures()) {
        Figure figure = testing::smoothFigure({});
        feature.apply(figure);
        figure.camera.targetMm = holed->grid().centreMm();
        figure.labels->data = testing::makeVolume<std::uint8_t>(holed->grid(), VoxelType::uint8,
                                                                [](const glm::ivec3& v) { return v.x < 14 ? 3 : 7; });
        const auto picture = [&](const std::shared_ptr<const Volume>& volume) {
            figure.volume->data = volume;
            return renderWhole(*makeCpuBackend(), *plan16(figure));
        };
        const Picture withHole = picture(holed);
        EXPECT_EQ(testing::unsoundPixels(withHole), 0) << feature.name;
        EXPECT_TRUE(testing::sameBits(withHole, picture(masked))) << feature.name;
    }
}

TEST(TransferTables, OpaqueAirIsNoMoreThanOpaque) {
    // A table's lowest entry opaque, the next ones clear: a place before the first entry must not add to it.
    unsigned seed = 5;
    const auto below = [&](int count) {
        seed = seed * 1664525U + 1013904223U;
        return static_cast<int>((seed >> 8U) % static_cast<unsigned>(count));
    };
    for (int i = 0; i < 40; ++i) {
        const int low = below(60000) - 32768;
        const int high = std::min(32767, low + 10 + below(60000));
        const double slope = 0.01 * (5 + below(2000));
        Figure figure = testing::smoothFigure({});
        figure.volume->data = testing::makeVolume<std::int16_t>(
            testing::gridOf(glm::ivec3(6)), VoxelType::int16,
            [&](const glm::ivec3& v) { return v == glm::ivec3(5) ? high : low; }, slope, below(2000) - 1000);
        const Volume& volume = *figure.volume->data;
        figure.camera.targetMm = volume.grid().centreMm();
        figure.camera.heightMm = 8;
        const ValueRange range = volume.range();
        Layer& layer = figure.layers[0];
        layer.transfer.opacity = {{range.low, 1}, {range.low + (range.high - range.low) * 1e-4, 0}};
        EXPECT_EQ(testing::unsoundPixels(renderWhole(*makeCpuBackend(), *plan16(figure))), 0) << low << ' ' << slope;
        figure.layers.push_back(layer);
        figure.layers[1].opacity = 0.5;
        EXPECT_EQ(testing::unsoundPixels(renderWhole(*makeCpuBackend(), *plan16(figure))), 0) << low << ' ' << slope;
    }
}

} // namespace
} // namespace limner
