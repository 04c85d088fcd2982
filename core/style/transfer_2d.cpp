#include "core/style/opacity_shapes.h"
#include "core/style/transfer_function.h"
#include "core/style/transfer_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace limner {
namespace {

constexpr std::array<std::string_view, 7> kAxisNames{"value",      "gradient",  "label", "distance",
                                                     "importance", "curvature", "second"}; // in TransferAxis' order

/// Where shapes and curve are read for a position; nothing where a label has no node position.
std::optional<double> heldPosition(TransferAxis axis, const std::vector<double>& nodes, double at) {
    if (axis != TransferAxis::label) {
        return at;
    }
    const double index = gridIndexAt(nodes, at, true);
    return index < 0 ? std::nullopt : std::optional(std::round(nodes[static_cast<std::size_t>(index)]));
}

} // namespace

TransferAxis transferAxis(const std::string& name) {
    const auto found = std::find(kAxisNames.begin(), kAxisNames.end(), name);
    return found == kAxisNames.end() ? TransferAxis::value : static_cast<TransferAxis>(found - kAxisNames.begin());
}

TransferAxis firstAxis(const Transfer& transfer) {
    return transferAxis(secondAxis(transfer) ? transfer.axes[0] : transfer.axis);
}

std::optional<TransferAxis> secondAxis(const Transfer& transfer) {
    const bool plane = transfer.kind == TransferKind::twoDimensional && transfer.axes.size() >= 2;
    return plane ? std::optional(transferAxis(transfer.axes[1])) : std::nullopt;
}

NodePositions nodePositions(const Transfer& transfer) {
    NodePositions positions;
    if (!secondAxis(transfer)) {
        for (const TransferNode& node : transfer.nodes) {
            positions.first.push_back(node.at);
        }
    } else if (transfer.grid) {
        positions = {transfer.grid->x, transfer.grid->y};
    }
    return positions;
}

double planeCurveAt(const Transfer& transfer, double first) {
    return transfer.opacity.empty() ? 1 : curveOpacityAt(transfer, first);
}

double opacity2dAt(const Transfer& transfer, double x, double y) {
    const auto axis = secondAxis(transfer);
    const bool labels = firstAxis(transfer) == TransferAxis::label || axis == TransferAxis::label;
    const NodePositions nodes = labels ? nodePositions(transfer) : NodePositions{};
    const auto first = heldPosition(firstAxis(transfer), nodes.first, x);
    const auto second = axis ? heldPosition(*axis, nodes.second, y) : y;
    if (!first || !second) {
        return 0;
    }
    if (!axis) {
        return curveOpacityAt(transfer, *first);
    }
    const PreparedShapes shapes(transfer.opacity2d);
    return std::clamp(planeCurveAt(transfer, *first) * shapes.opacityAt(*first, *second), 0.0, 1.0);
}

} // namespace limner
