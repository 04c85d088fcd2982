#include "support/make_volume.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <algorithm>
#include <cmath>
#include <vector>

// Transfer functions, contours, transparency, estimators and interpolation of the SIMD backend against the reference.
//
// Bounds. The kernel reads tables, the reference the functions. A table is exact where a function is linear between
// its entries (bilinear, over two axes): with knots and nodes on entries single precision and the 15 bits of styles
// are all that is left, 1.3e-5 measured. Shapes with round or slanted borders have kinks between entries, which a table
// cuts by slope * entry / 8 or so: 1.4e-4 measured over the 256 entries of 8-bit data. Illustrative transparency takes
// the square root of such an error next to opacity 0: it is compared with knots on entries only.

namespace limner {
namespace {

using testing::planOf;
using testing::renderWhole;

constexpr int kSize = 36;

std::shared_ptr<const RenderPlan> planSmall(const Figure& figure) {
    PlanRequest request;
    request.size = {kSize, kSize};
    return planOf(figure, request);
}

/// How two pictures differ.
struct Difference {
    double rmse = 0;
    double most = 0; ///< of 99.9 % of the numbers
};

constexpr Difference kExactTables{2e-5, 2e-4};
constexpr Difference kCutKinks{2e-4, 2e-3};

Difference differenceOf(const Picture& a, const Picture& b) {
    std::vector<double> all;
    for (std::size_t i = 0; i < a.rgba().size(); ++i) {
        all.push_back(std::abs(static_cast<double>(a.rgba()[i]) - b.rgba()[i]));
    }
    const auto rank = all.begin() + static_cast<std::ptrdiff_t>(all.size() * 999 / 1000);
    std::nth_element(all.begin(), rank, all.end());
    return {testing::rootMeanSquare(a, b), *rank};
}

double greatestAlpha(const Picture& picture) {
    double greatest = 0;
    for (std::size_t i = 3; i < picture.rgba().size(); i += 4) {
        greatest = std::max(greatest, static_cast<double>(picture.rgba()[i]));
    }
    return greatest;
}

/// Entries of a table along one of its axes.
struct Entries {
    double low;
    double high;
    std::size_t count;
};

void snap(std::vector<double>& positions, const Entries& entries) {
    const double step = (entries.high - entries.low) / static_cast<double>(entries.count - 1);
    for (double& position : positions) {
        position = entries.low + std::round((position - entries.low) / step) * step;
    }
}

void snapPlane(Transfer& transfer, const TransferTable& table) {
    const Entries x{table.low, table.high, table.opacity.size()};
    const Entries y{table.lowY, table.highY, static_cast<std::size_t>(table.rows)};
    const bool swapped = transferAxis(transfer.axes[0]) != table.axisX;
    const auto along = [&](bool first, std::vector<double>& positions) {
        const bool ofX = first != swapped;
        if (ofX || table.axisY != TransferAxis::label) {
            snap(positions, ofX ? x : y);
        }
    };
    along(true, transfer.grid->x);
    along(false, transfer.grid->y);
    for (OpacityShape& shape : transfer.opacity2d) {
        along(true, shape.x);
        along(false, shape.y);
    }
    for (glm::dvec2& point : transfer.opacity) {
        std::vector<double> position{point.x};
        along(true, position);
        point.x = position[0];
    }
}

/// Moves knots, nodes and corners onto the nearest entries of the figure's own tables.
void snapToTables(Figure& figure) {
    const auto plan = planSmall(figure);
    ASSERT_EQ(plan->layers.size(), figure.layers.size());
    for (std::size_t i = 0; i < figure.layers.size(); ++i) {
        Transfer& transfer = figure.layers[i].transfer;
        const TransferTable& table = plan->layers[i].table;
        if (transfer.kind == TransferKind::twoDimensional) {
            snapPlane(transfer, table);
        } else if (table.rows == 0) {
            const Entries entries{table.low, table.high, table.opacity.size()};
            for (std::size_t k = 0; k < transfer.nodes.size(); ++k) {
                std::vector<double> position{transfer.nodes[k].at, transfer.opacity[k].x};
                snap(position, entries);
                transfer.nodes[k].at = position[0];
                transfer.opacity[k].x = position[1];
            }
        }
    }
}

class TransferAgreement : public ::testing::TestWithParam<std::size_t> {
  protected:
    [[nodiscard]] const testing::TransferFeature& feature() const { return testing::transferFeatures()[GetParam()]; }
};

INSTANTIATE_TEST_SUITE_P(Of, TransferAgreement, ::testing::Range(std::size_t{0}, testing::transferFeatures().size()),
                         [](const auto& one) { return testing::transferFeatures()[one.param].name; });

TEST_P(TransferAgreement, OfKernelAndReference) {
    for (const VoxelType type : {VoxelType::uint8, VoxelType::int16, VoxelType::float32}) {
        testing::SmoothScene scene;
        scene.type = type;
        scene.projection = type == VoxelType::int16 ? Projection::perspective : Projection::orthographic;
        Figure figure = testing::smoothFigure(scene);
        feature().apply(figure);
        if (feature().onEntries) {
            snapToTables(figure);
        }
        const auto plan = planSmall(figure);
        const Picture exact = renderWhole(*makeReferenceBackend(), *plan);
        const Difference d = differenceOf(renderWhole(*makeCpuBackend(), *plan), exact);
        EXPECT_GT(greatestAlpha(exact), 0.2);
        EXPECT_LT(d.rmse, feature().onEntries ? kExactTables.rmse : kCutKinks.rmse) << static_cast<int>(type);
        EXPECT_LT(d.most, feature().onEntries ? kExactTables.most : kCutKinks.most) << static_cast<int>(type);
    }
}

TEST(Splines, OvershootsCountAsTheRangesEnd) {
    // A cube with hard faces: the B-spline through it leaves the data's range, where a curve goes on rising.
    Figure figure = testing::smoothFigure({});
    const Grid grid = figure.volume->data->grid();
    figure.volume->data = testing::makeVolume<std::uint8_t>(grid, VoxelType::uint8, [](const glm::ivec3& v) {
        return v.x > 9 && v.x < 21 && v.y > 9 && v.y < 21 && v.z > 9 && v.z < 21 ? 200 : 20;
    });
    figure.quality.interpolation = Interpolation::tricubic;
    Layer& layer = figure.layers[0];
    layer.transfer.nodes = {{0, "", glm::dvec3(1, 0, 0)}, {220, "", glm::dvec3(0, 0, 1)}};
    layer.transfer.opacity = {{20, 0}, {200, 0.1}, {215, 1}};
    const auto plan = planSmall(figure);
    const Picture exact = renderWhole(*makeReferenceBackend(), *plan);
    const Difference d = differenceOf(renderWhole(*makeCpuBackend(), *plan), exact);
    EXPECT_GT(greatestAlpha(exact), 0.2);
    EXPECT_LT(d.rmse, kExactTables.rmse);
    EXPECT_LT(d.most, kExactTables.most);
}

TEST(RandomFigures, AreThoseOfTheReference) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        Figure figure = testing::randomFigure(seed);
        snapToTables(figure);
        const auto plan = planSmall(figure);
        const Picture exact = renderWhole(*makeReferenceBackend(), *plan);
        const Difference d = differenceOf(renderWhole(*makeCpuBackend(), *plan), exact);
        EXPECT_GT(greatestAlpha(exact), 0.2) << seed;
        EXPECT_LT(d.rmse, kExactTables.rmse) << seed;
        EXPECT_LT(d.most, kExactTables.most) << seed;
    }
}

} // namespace
} // namespace limner
