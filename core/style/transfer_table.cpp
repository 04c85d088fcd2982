#include "core/style/opacity_shapes.h"
#include "core/style/transfer_function.h"
#include "core/style/transfer_plane.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

namespace limner {
namespace {

/// Plain 8-bit data have at most 255 steps; four entries each are past the 1024 that the specification asks for.
constexpr std::int64_t kEntries8 = 1024;
/// Asked for 16-bit and float data.
constexpr std::int64_t kEntries16 = 4096;
/// Beyond this the two tables leave the second-level cache of small cores (128 KiB), for steps nobody can see.
constexpr std::int64_t kMostEntries = 16384;

/// Over two axes: along the value, along anything else, and across. 2048 x 256 entries are 2 MiB a layer.
constexpr std::int64_t kLeastPlaneEntries = 256;
constexpr std::int64_t kMostPlaneEntries = 2048;
constexpr std::int64_t kPlaneEntries = 1024;
constexpr int kPlaneRows = 256;

/// Number of entries over the value. Where the stored numbers are few enough, a whole number of entries per stored
/// number, so that a curve's knots at data values lie on entries and the table is exact there.
std::int64_t valueEntries(const Volume& volume, ValueRange range, std::pair<std::int64_t, std::int64_t> leastAndMost) {
    const auto [least, most] = leastAndMost;
    if (volume.type() == VoxelType::float32) {
        return most;
    }
    const double steps = std::round((range.high - range.low) / std::abs(volume.contents().slope));
    if (!(steps >= 1 && steps < static_cast<double>(most))) {
        return steps >= 1 ? most : least;
    }
    const auto n = static_cast<std::int64_t>(steps);
    return n * ((least - 1 + n - 1) / n) + 1;
}

ValueRange axisRange(TransferAxis axis, const Volume& volume, const AxisRanges& ranges) {
    ValueRange range{0, 1};
    switch (axis) {
    case TransferAxis::value: range = volume.range(); break;
    case TransferAxis::second: range = ranges.second; break;
    case TransferAxis::distance: range = ranges.distance; break;
    case TransferAxis::curvature: range = ranges.curvature; break;
    case TransferAxis::importance: range = ranges.importance; break;
    case TransferAxis::gradient:
    case TransferAxis::label: break;
    }
    if (!std::isfinite(range.low) || !std::isfinite(range.high)) {
        return {0, 1};
    }
    if (!(range.high > range.low)) {
        // A constant volume: any width will do that does not vanish beside the value itself.
        range.high = range.low + std::max(1.0, std::abs(range.low) * 1e-6);
    }
    return range;
}

/// What entry k of `count` stands for. Product before quotient: exact at whole data values, so that a step there falls
/// on its own entry. Where the width is huge (float data) the product could overflow, and nothing is exact anyway.
double entryPosition(ValueRange range, std::size_t k, std::size_t count) {
    const double width = range.high - range.low;
    const double share = static_cast<double>(k);
    const double last = static_cast<double>(count - 1);
    return range.low + (width < 1e300 ? share * width / last : share / last * width);
}

/// Of the columns. Entries lie evenly over what a volume stores: where its levels are uneven, their values are read
/// off.
std::vector<double> entryPositions(const TransferTable& table, const Volume& volume) {
    const Volume::Contents& contents = volume.contents();
    const bool uneven = table.axisX == TransferAxis::value && !contents.levels.empty();
    std::vector<double> positions(table.opacity.size());
    for (std::size_t k = 0; k < positions.size(); ++k) {
        const double even = entryPosition({table.low, table.high}, k, positions.size());
        positions[k] = uneven ? volume.valueFromStored((even - contents.intercept) / contents.slope) : even;
    }
    return positions;
}

/// Where nodes lie among `count` entries of a range.
std::vector<double> entriesOf(std::vector<double> nodes, ValueRange range, std::size_t count) {
    const double last = static_cast<double>(count - 1);
    for (double& at : nodes) {
        at = (at / 2 - range.low / 2) / (range.high / 2 - range.low / 2) * last; // halves: no overflow
    }
    return nodes;
}

/// The same of the columns.
std::vector<double> nodeEntries(const TransferTable& table, const Volume& volume, std::vector<double> nodes) {
    const bool uneven = table.axisX == TransferAxis::value && !volume.contents().levels.empty();
    return uneven ? std::vector<double>() : entriesOf(std::move(nodes), {table.low, table.high}, table.opacity.size());
}

int atLeastOne(std::size_t count) { return static_cast<int>(std::max(count, std::size_t{1})); }

float layerOpacity(const Layer& layer, double opacity) {
    return static_cast<float>(std::clamp(layer.opacity * opacity, 0.0, 1.0));
}

/// Lays out X: range, entries (all 0) and axis.
void setColumns(TransferTable& table, TransferAxis axis, ValueRange range, std::int64_t entries) {
    table.axisX = axis;
    table.low = range.low;
    table.high = range.high;
    table.opacity.assign(static_cast<std::size_t>(entries), 0);
    table.index.assign(static_cast<std::size_t>(entries), 0);
}

/// One row for each label that has a position, after that of all others.
void setLabelRows(TransferTable& table, const std::vector<double>& positions) {
    std::set<int> labels;
    for (const double position : positions) {
        const double label = std::round(position);
        if (label != -1 && std::abs(label) <= std::numeric_limits<int>::max()) {
            labels.insert(static_cast<int>(label));
        }
    }
    table.axisY = TransferAxis::label;
    table.labels.assign(labels.begin(), labels.end());
    table.labels.insert(table.labels.begin(), -1);
    table.rows = static_cast<int>(table.labels.size());
    for (const int label : table.labels) {
        table.rowIndex.push_back(static_cast<float>(std::max(0.0, gridIndexAt(positions, label, true))));
    }
}

/// The second axis of a plane at row r; nothing where no label has the row.
std::optional<double> rowPosition(const TransferTable& table, const std::vector<double>& positions, std::size_t row) {
    if (table.labels.empty()) {
        return entryPosition({table.lowY, table.highY}, row, static_cast<std::size_t>(table.rows));
    }
    const double label = table.labels[row];
    return gridIndexAt(positions, label, true) < 0 ? std::nullopt : std::optional(label);
}

/// Fills in every row of `opacity2d` by `fill(row, its position, its first entry)` and the greatest of them.
template <typename Fill>
void fillRows(TransferTable& table, const std::vector<double>& positions, Fill fill) {
    const std::size_t columns = table.opacity.size();
    table.opacity2d.assign(static_cast<std::size_t>(table.rows) * columns, 0);
    tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(table.rows), [&](std::size_t row) {
        if (const auto position = rowPosition(table, positions, row)) {
            fill(*position, table.opacity2d.data() + row * columns);
        }
    });
    for (auto row = table.opacity2d.begin(); row != table.opacity2d.end();
         row += static_cast<std::ptrdiff_t>(columns)) {
        std::transform(table.opacity.begin(), table.opacity.end(), row, table.opacity.begin(),
                       [](float a, float b) { return std::max(a, b); });
    }
}

/// A line has two entries at least.
std::int64_t asked(int entries) { return std::max(2, entries); }

TransferTable bakeCurve(const Layer& layer, const Volume& volume, const AxisRanges& ranges, int entries) {
    TransferTable table;
    const TransferAxis axis = firstAxis(layer.transfer);
    const ValueRange range = axisRange(axis, volume, ranges);
    const std::int64_t least = volume.type() == VoxelType::uint8 ? kEntries8 : kEntries16;
    const std::int64_t automatic =
        axis == TransferAxis::value ? valueEntries(volume, range, {least, kMostEntries}) : kEntries16;
    setColumns(table, axis, range, entries > 0 ? asked(entries) : automatic);
    const std::vector<double> positions = entryPositions(table, volume);
    for (std::size_t k = 0; k < positions.size(); ++k) {
        table.opacity[k] = layerOpacity(layer, curveOpacityAt(layer.transfer, positions[k]));
        table.index[k] = static_cast<float>(nodeIndexAt(layer.transfer.nodes, positions[k]));
    }
    table.nodeEntries = nodeEntries(table, volume, nodePositions(layer.transfer).first);
    table.nodesX = table.nodeStrideY = atLeastOne(layer.transfer.nodes.size());
    return table;
}

/// A curve over labels as a plane: nothing changes along the value.
TransferTable bakeLabels(const Layer& layer, const Volume& volume) {
    TransferTable table;
    setColumns(table, TransferAxis::value, axisRange(TransferAxis::value, volume, {}), 2);
    const std::vector<double> nodes = nodePositions(layer.transfer).first;
    setLabelRows(table, nodes);
    fillRows(table, nodes, [&](double label, float* entries) {
        entries[0] = entries[1] = layerOpacity(layer, curveOpacityAt(layer.transfer, label));
    });
    table.nodesY = atLeastOne(nodes.size());
    return table;
}

/// `xs`: of the columns.
void fillPlane(TransferTable& table, const Layer& layer, const std::vector<double>& xs,
               const std::vector<double>& rowNodes, bool swapped) {
    const Transfer& transfer = layer.transfer;
    const PreparedShapes shapes(transfer.opacity2d);
    std::vector<double> curve(xs.size(), 1);
    if (!swapped) {
        std::transform(xs.begin(), xs.end(), curve.begin(), [&](double x) { return planeCurveAt(transfer, x); });
    }
    fillRows(table, rowNodes, [&](double y, float* entries) {
        const double curveOfRow = swapped ? planeCurveAt(transfer, y) : 1;
        for (std::size_t k = 0; k < xs.size(); ++k) {
            const double shape = swapped ? shapes.opacityAt(y, xs[k]) : shapes.opacityAt(xs[k], y);
            entries[k] = layerOpacity(layer, std::clamp(curve[k] * curveOfRow * shape, 0.0, 1.0));
        }
    });
}

TransferTable bakePlane(const Layer& layer, const Volume& volume, const AxisRanges& ranges, int entries) {
    TransferTable table;
    NodePositions nodes = nodePositions(layer.transfer);
    const int columns = atLeastOne(nodes.first.size());
    TransferAxis axisX = firstAxis(layer.transfer);
    TransferAxis axisY = *secondAxis(layer.transfer);
    const bool swapped = axisY != TransferAxis::label && (axisX == TransferAxis::label || axisY == TransferAxis::value);
    if (swapped) {
        std::swap(nodes.first, nodes.second);
        std::swap(axisX, axisY);
    }
    const ValueRange range = axisRange(axisX, volume, ranges);
    const std::int64_t automatic = axisX == TransferAxis::value
                                       ? valueEntries(volume, range, {kLeastPlaneEntries, kMostPlaneEntries})
                                       : kPlaneEntries;
    setColumns(table, axisX, range, entries > 0 ? std::min(asked(entries), automatic) : automatic);
    const std::vector<double> xs = entryPositions(table, volume);
    for (std::size_t k = 0; k < table.index.size(); ++k) {
        table.index[k] = static_cast<float>(gridIndexAt(nodes.first, xs[k], false));
    }
    table.nodeEntries = nodeEntries(table, volume, nodes.first);
    if (axisY == TransferAxis::label) {
        setLabelRows(table, nodes.second);
    } else {
        table.axisY = axisY;
        table.rows = kPlaneRows;
        const ValueRange across = axisRange(axisY, volume, ranges);
        table.lowY = across.low;
        table.highY = across.high;
        for (std::size_t row = 0; row < static_cast<std::size_t>(kPlaneRows); ++row) {
            const double y = entryPosition(across, row, static_cast<std::size_t>(kPlaneRows));
            table.rowIndex.push_back(static_cast<float>(gridIndexAt(nodes.second, y, false)));
        }
        table.nodeRows = entriesOf(nodes.second, across, static_cast<std::size_t>(kPlaneRows));
    }
    table.nodesX = atLeastOne(nodes.first.size());
    table.nodesY = atLeastOne(nodes.second.size());
    table.nodeStrideX = swapped ? columns : 1;
    table.nodeStrideY = swapped ? 1 : columns;
    fillPlane(table, layer, xs, nodes.second, swapped);
    return table;
}

} // namespace

TransferTable bakeTransfer(const Layer& layer, const Volume& volume, const AxisRanges& ranges, int entries) {
    if (secondAxis(layer.transfer)) {
        return bakePlane(layer, volume, ranges, entries);
    }
    return firstAxis(layer.transfer) == TransferAxis::label ? bakeLabels(layer, volume)
                                                            : bakeCurve(layer, volume, ranges, entries);
}

} // namespace limner
