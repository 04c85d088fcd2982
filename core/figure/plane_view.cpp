#include "core/figure/plane_view.h"

#include "core/style/opacity_shapes.h"
#include "core/volume/derived_fields.h"
#include "core/volume/gradient_statistics.h"

#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limner {
namespace {

constexpr int kBins = 256;        // finer than shapes are drawn
constexpr int kMostLabels = 255;  // what label slots hold
constexpr double kAllLabels = -1; // the position that stands for all labels without one of their own

const Volume* dataOf(const std::optional<VolumeReference>& reference) {
    return reference ? reference->data.get() : nullptr;
}
const Volume* labelsOf(const Figure& figure) { return figure.labels ? figure.labels->data.get() : nullptr; }

/// From the origin of distances to the farthest corner of the scan; from a label: the box's diagonal, as nothing is
/// farther.
double greatestDistanceMm(const Volume& volume, const Transfer& transfer) {
    const Grid& grid = volume.grid();
    const auto corner = [&](int i) {
        return grid.mmFromVoxel(glm::dvec3(i & 1, i >> 1 & 1, i >> 2) * glm::dvec3(grid.dims) - 0.5);
    };
    double greatest = 0;
    for (int i = 0; i < 8; ++i) {
        const bool point = transfer.distance && transfer.distance->fromMm;
        greatest = std::max(greatest, glm::distance(corner(i), point ? *transfer.distance->fromMm : corner(0)));
    }
    return greatest;
}

double greatestImportance(const Importance& importance) {
    const ImportanceWeights& w = importance.weights;
    constexpr double kLighting = 3; // core/optics/measures.h
    double object = 0;
    for (const ObjectImportance& one : importance.objects)
        object = std::max(object, one.weight);
    return w.intensity + w.gradient + w.silhouette + kLighting * w.lighting + w.object * object + w.statistics;
}

JointHistogram transposed(const JointHistogram& joint) {
    JointHistogram turned{joint.y, joint.x, joint.rows, joint.columns, {}};
    turned.counts.reserve(joint.counts.size());
    for (int column = 0; column < joint.columns; ++column)
        for (int row = 0; row < joint.rows; ++row)
            turned.counts.push_back(joint.at(column, row));
    return turned;
}

std::optional<JointHistogram> overLabels(const Volume& volume, const Volume& labels, const JointAxis& x, Task& task) {
    const int most = std::clamp(static_cast<int>(std::lround(labels.range().high)), 1, kMostLabels);
    std::map<int, std::uint8_t> slots;
    for (int label = 1; label <= most; ++label)
        slots[label] = static_cast<std::uint8_t>(label);
    const auto onGrid = labelSlots(labels, volume.grid(), slots, task);
    return jointHistogram(volume, x, *onGrid, {{-0.5, most + 0.5}, most + 1}, task);
}

std::optional<JointHistogram> overDistance(const Figure& figure, const Transfer& transfer, const JointAxis& x,
                                           Task& task) {
    const Volume& volume = *figure.volume->data;
    const JointAxis y{shownRange(figure, transfer, TransferAxis::distance), kBins};
    if (!transfer.distance)
        return std::nullopt;
    if (transfer.distance->fromMm)
        return jointHistogramOfDistance(volume, x, *transfer.distance->fromMm, y, task);
    if (!labelsOf(figure))
        return std::nullopt;
    const auto onGrid =
        labelSlots(*labelsOf(figure), volume.grid(), {{transfer.distance->label, std::uint8_t{1}}}, task);
    const auto distances = distanceToLabel(*onGrid, 1, task);
    return distances ? std::optional(jointHistogram(volume, x, *distances, y, task)) : std::nullopt;
}

/// Value over the axis.
std::optional<JointHistogram> overAxis(const Figure& figure, const Transfer& transfer, TransferAxis axis, Task& task) {
    const Volume& volume = *figure.volume->data;
    const JointAxis x{volume.range(), kBins};
    switch (axis) {
    case TransferAxis::gradient:
        return jointHistogramOfGradient(volume, x, computeGradientStatistics(volume).p999, kBins, task);
    case TransferAxis::label: return overLabels(volume, *labelsOf(figure), x, task);
    case TransferAxis::distance: return overDistance(figure, transfer, x, task);
    case TransferAxis::second: {
        const auto second = resampledValues(*dataOf(figure.secondVolume), volume.grid(), task);
        return jointHistogram(volume, x, *second, {second->range(), kBins}, task);
    }
    case TransferAxis::value:
    case TransferAxis::importance:
    case TransferAxis::curvature: break;
    }
    return std::nullopt;
}

/// Positions along one axis of a transfer, stretched.
class Stretch {
  public:
    Stretch(ValueRange from, ValueRange to) : from_(from), to_(to) {}
    void operator()(double& at) const {
        const double width = from_.high - from_.low;
        at = to_.low + (width > 0 ? (at - from_.low) / width : 0) * (to_.high - to_.low);
    }
    void operator()(std::vector<double>& all) const {
        for (double& at : all)
            (*this)(at);
    }

  private:
    ValueRange from_, to_;
};

/// A line over labels: one look for all of them, at its greatest opacity.
void lineOverLabels(Transfer& line) {
    double greatest = 0;
    for (const glm::dvec2& point : line.opacity)
        greatest = std::max(greatest, point.y);
    line.opacity = {{kAllLabels, greatest}};
    if (!line.nodes.empty())
        line.nodes.resize(1);
    for (TransferNode& node : line.nodes)
        node.at = kAllLabels;
}

void gridOverLabels(TransferGrid& grid, std::size_t place) {
    if (place == 0) {
        while (grid.x.size() > 1)
            grid = withColumnRemoved(grid, grid.x.size() - 1);
        grid.x = {kAllLabels};
    } else {
        while (grid.y.size() > 1)
            grid = withRowRemoved(grid, grid.y.size() - 1);
        grid.y = {kAllLabels};
    }
}

} // namespace

ValueRange shownRange(const Figure& figure, const Transfer& transfer, TransferAxis axis) {
    const Volume* volume = dataOf(figure.volume);
    const auto upTo = [](double high) { return high > 0 ? ValueRange{0, high} : ValueRange{0, 1}; };
    switch (axis) {
    case TransferAxis::value: return volume ? volume->range() : ValueRange{0, 1};
    case TransferAxis::label:
        return {kAllLabels, labelsOf(figure) ? std::max(1.0, labelsOf(figure)->range().high) : 1.0};
    case TransferAxis::distance: return upTo(volume ? greatestDistanceMm(*volume, transfer) : 0);
    case TransferAxis::importance: return upTo(figure.importance ? greatestImportance(*figure.importance) : 0);
    // A ball of two voxels' radius is the smallest whose curvature voxels can hold.
    case TransferAxis::curvature: return upTo(volume ? 0.5 / volume->grid().smallestSpacingMm() : 0);
    case TransferAxis::second:
        return dataOf(figure.secondVolume) ? dataOf(figure.secondVolume)->range() : ValueRange{0, 1};
    case TransferAxis::gradient: break;
    }
    return {0, 1};
}

PlaneBox shownPlane(const Figure& figure, const Transfer& transfer) {
    const ValueRange x = shownRange(figure, transfer, firstAxis(transfer));
    const auto second = secondAxis(transfer);
    const ValueRange y = second ? shownRange(figure, transfer, *second) : ValueRange{0, 1};
    return {{x.low, y.low}, {x.high, y.high}};
}

bool axisThere(const Figure& figure, TransferAxis axis) {
    switch (axis) {
    case TransferAxis::label: return labelsOf(figure) != nullptr;
    case TransferAxis::second: return dataOf(figure.secondVolume) != nullptr;
    case TransferAxis::importance: return figure.importance.has_value();
    case TransferAxis::value:
    case TransferAxis::gradient:
    case TransferAxis::distance:
    case TransferAxis::curvature: break;
    }
    return true;
}

std::optional<JointHistogram> planeHistogram(const Figure& figure, const Transfer& transfer, Task& task) {
    const auto second = secondAxis(transfer);
    if (!second || !dataOf(figure.volume) || !axisThere(figure, firstAxis(transfer)) || !axisThere(figure, *second))
        return std::nullopt;
    if (firstAxis(transfer) == TransferAxis::value)
        return overAxis(figure, transfer, *second, task);
    if (*second != TransferAxis::value)
        return std::nullopt;
    const auto joint = overAxis(figure, transfer, firstAxis(transfer), task);
    return joint ? std::optional(transposed(*joint)) : std::nullopt;
}

Transfer withAxis(const Figure& figure, Transfer transfer, std::size_t place, const std::string& name) {
    const TransferAxis axis = transferAxis(name);
    if (axis == TransferAxis::distance && !transfer.distance)
        transfer.distance.emplace().fromMm = figure.camera.targetMm;
    if (!secondAxis(transfer)) {
        const Stretch stretch(shownRange(figure, transfer, firstAxis(transfer)), shownRange(figure, transfer, axis));
        transfer.axis = name;
        for (glm::dvec2& point : transfer.opacity)
            stretch(point.x);
        for (TransferNode& node : transfer.nodes)
            stretch(node.at);
        if (axis == TransferAxis::label)
            lineOverLabels(transfer);
        return transfer;
    }
    if (transfer.axes[1 - place] == name) { // the other axis takes over what this one was
        const std::string old = transfer.axes[place];
        std::string between = "gradient"; // any third one
        for (const char* third : {"curvature", "distance"})
            between = between == old || between == name ? third : between;
        transfer = withAxis(figure, std::move(transfer), 1 - place, between);
        transfer = withAxis(figure, std::move(transfer), place, name);
        return withAxis(figure, std::move(transfer), 1 - place, old);
    }
    const TransferAxis was = place == 0 ? firstAxis(transfer) : *secondAxis(transfer);
    const Stretch stretch(shownRange(figure, transfer, was), shownRange(figure, transfer, axis));
    transfer.axes[place] = name;
    for (OpacityShape& shape : transfer.opacity2d)
        stretch(place == 0 ? shape.x : shape.y);
    if (place == 0)
        for (glm::dvec2& point : transfer.opacity)
            stretch(point.x);
    if (transfer.grid) {
        stretch(place == 0 ? transfer.grid->x : transfer.grid->y);
        if (axis == TransferAxis::label)
            gridOverLabels(*transfer.grid, place);
    }
    return transfer;
}

std::vector<float> planeOpacity(const Transfer& transfer, const PlaneBox& part, glm::ivec2 pixels) {
    const PreparedShapes shapes(transfer.opacity2d);
    std::vector<float> opacity(static_cast<std::size_t>(pixels.x) * static_cast<std::size_t>(pixels.y));
    const glm::dvec2 cell = (part.high - part.low) / glm::dvec2(pixels);
    std::vector<double> curve;
    for (int column = 0; column < pixels.x; ++column)
        curve.push_back(transfer.opacity.empty() ? 1 : curveOpacityAt(transfer, part.low.x + (column + 0.5) * cell.x));
    tbb::parallel_for(0, pixels.y, [&](int row) {
        const double y = part.high.y - (row + 0.5) * cell.y;
        float* line = opacity.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels.x);
        for (int column = 0; column < pixels.x; ++column)
            line[column] = static_cast<float>(curve[static_cast<std::size_t>(column)] *
                                              shapes.opacityAt(part.low.x + (column + 0.5) * cell.x, y));
    });
    return opacity;
}

} // namespace limner
