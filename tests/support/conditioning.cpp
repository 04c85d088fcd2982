#include "support/conditioning.h"

#include "support/extreme_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limner::testing {

namespace {

/// Places along a ray of a box's length, in single precision: some ulp of the box's diagonal.
constexpr double kUlps = 1e-6;

/// Opacities as single precision has them: some ulp of themselves and, near 1, of 1.
void roundOpacity(double& opacity, double sign) {
    if (opacity > 0 && opacity < 1) {
        opacity = std::clamp(opacity + sign * opacity * (1e-5 * (1 - opacity) + 1.2e-7), 0.0, 1.0);
    }
}

void roundOpacities(Layer& layer, double sign) {
    for (glm::dvec2& point : layer.transfer.opacity) {
        roundOpacity(point.y, sign);
    }
    for (OpacityShape& shape : layer.transfer.opacity2d) {
        roundOpacity(shape.opacity, sign);
    }
    roundOpacity(layer.opacity, sign);
}

/// Rays are worked out from the middle of blocks of pixels: some ulp of a block's width, in pixels. (The specification
/// allows 0.01.)
constexpr double kPixels = 1e-5;

/// Both along an axis, in voxels: much where the others are a thousand times as long, or where a pixel is.
double ulpsAlong(const RenderPlan& plan, int axis) {
    const Grid& grid = plan.volume->grid();
    const double mm = std::max(kUlps * grid.diagonalMm(), kPixels * plan.rays.footprintMm);
    return std::min(0.5 * grid.dims[axis], mm / grid.spacingMm[axis]);
}

/// Components of a gradient that are no more than so many times what single precision leaves of 0 have no direction.
constexpr double kRoundings = 16;

} // namespace

Conditioning::Conditioning(const ExtremeFigure& made, const RenderPlan& plan)
    : plan_(plan), exact_(makeReferenceBackend()) {
    plan_.earlyTermination = 0;
    addTransfers(made);
    addRays();
}

void Conditioning::addTransfers(const ExtremeFigure& made) {
    Planner planner;
    Task task;
    const auto add = [&](const std::string& name, const Figure& figure) {
        auto plan = std::make_shared<RenderPlan>(*planner.plan(figure, made.request, task));
        plan->earlyTermination = 0;
        neighbours_.push_back({name, plan});
    };
    for (const double sign : {-1.0, 1.0}) {
        Figure rounded = made.figure;
        for (Layer& layer : rounded.layers) {
            roundOpacities(layer, sign);
        }
        add("opacities", rounded);
        for (const bool across : {false, true}) {
            Figure moved = made.figure;
            bool any = false;
            for (const PlanLayer& layer : plan_.layers) {
                const TransferTable& table = layer.table;
                Transfer& transfer =
                    moved.layers[static_cast<std::size_t>(layer.source - plan_.figure->layers.data())].transfer;
                const bool plane = transfer.kind == TransferKind::twoDimensional;
                if (across && (!plane || !table.labels.empty() || table.rows < 2)) {
                    continue;
                }
                const double entry = across ? (table.highY - table.lowY) / (table.rows - 1)
                                            : (table.high - table.low) / static_cast<double>(table.opacity.size() - 1);
                const TransferAxis axis = across ? table.axisY : table.axisX;
                const std::string name = !plane                                   ? transfer.axis
                                         : transferAxis(transfer.axes[0]) == axis ? transfer.axes[0]
                                                                                  : transfer.axes[1];
                shiftAlong(transfer, name, sign * entry);
                any = true;
            }
            if (any) {
                add(across ? "an entry across" : "an entry along", moved);
            }
        }
    }
}

void Conditioning::addRays() {
    const auto add = [&](const std::string& name, const auto& change) {
        for (const double sign : {-1.0, 1.0}) {
            auto plan = std::make_shared<RenderPlan>(plan_);
            change(*plan, sign);
            neighbours_.push_back({name, plan});
        }
    };
    for (int axis = 0; axis < 3; ++axis) {
        add("rays along axis " + std::to_string(axis),
            [&](RenderPlan& plan, double sign) { plan.rays.originVoxel[axis] += sign * ulpsAlong(plan, axis); });
    }
    const double steps = std::min(0.1, kUlps * plan_.volume->grid().diagonalMm() / plan_.lattice.stepMm);
    add("samples", [&](RenderPlan& plan, double sign) { plan.lattice.phase += sign * steps; });
    add("gradients", [](RenderPlan& plan, double sign) { plan.gradientRounding *= sign > 0 ? kRoundings : 0; });
}

Conditioning::Spread Conditioning::at(glm::ivec2 pixel) const {
    Task task;
    const Tile one{pixel, {1, 1}};
    const Picture exact = exact_->render(plan_, one, task).picture;
    Spread spread;
    for (const Neighbour& neighbour : neighbours_) {
        const Picture moved = exact_->render(*neighbour.plan, one, task).picture;
        for (std::size_t c = 0; c < 4; ++c) {
            const double difference = std::abs(static_cast<double>(moved.rgba()[c]) - exact.rgba()[c]);
            if (difference > spread.most) {
                spread = {difference, neighbour.name};
            }
        }
    }
    return spread;
}

} // namespace limner::testing
