#include "support/extreme_figures.h"

#include "core/volume/import.h"
#include "support/dice.h"
#include "support/extreme_parts.h"
#include "support/make_volume.h"
#include "support/transfer_scenes.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>
#include <vector>

#include <unistd.h>

namespace limner::testing {

namespace {

// ---- data ----------------------------------------------------------------------------------------------------------

/// From 0 to about 1.15, as in the smooth scenes.
double blobAt(const glm::dvec3& mm, double reachMm) {
    const double square = glm::dot(mm, mm) / (reachMm * reachMm);
    return std::exp(-2 * square) * (1 + 0.15 * std::sin(1.7 * mm.x) * std::cos(1.3 * mm.y + 0.9 * mm.z));
}

struct Data {
    Grid grid;
    std::vector<double> values; ///< x fastest, from 0 to 1.15
};

glm::dmat3 anyAxes(Dice& dice) {
    const glm::dvec3 x = glm::normalize(glm::dvec3{dice.between(0.2, 1), dice.between(-1, 1), dice.between(-1, 1)});
    const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(0.2, -0.5, 1)));
    const glm::dvec3 z = glm::cross(x, y);
    return {x, y, dice.oneIn(3) ? -z : z};
}

Grid anyGrid(Dice& dice, std::string& story) {
    Grid grid;
    grid.dims = {4 + dice.below(9), 4 + dice.below(9), 4 + dice.below(9)};
    grid.spacingMm = {dice.between(0.7, 1.2), dice.between(0.7, 1.2), dice.between(0.7, 1.2)};
    if (dice.oneIn(4)) {
        const int axis = dice.below(3);
        grid.dims[axis] = 1;
        if (dice.oneIn(3)) {
            grid.dims[(axis + 1) % 3] = 1;
        }
        story += ", axes of one voxel";
    }
    if (dice.oneIn(5)) {
        grid.spacingMm[dice.below(3)] *= dice.any({1e-3, 1e3});
        story += ", spacings 1:1000";
    }
    if (!dice.oneIn(3)) {
        grid.direction = anyAxes(dice);
    }
    grid.originMm = -grid.direction * (grid.spacingMm * (glm::dvec3(grid.dims - 1) / 2.0));
    return grid;
}

Data anyData(Dice& dice, std::string& story) {
    Data data{anyGrid(dice, story), {}};
    const int kind = dice.below(8);
    const double reach = 0.5 * glm::length(glm::dvec3(data.grid.dims));
    for (int z = 0; z < data.grid.dims.z; ++z) {
        for (int y = 0; y < data.grid.dims.y; ++y) {
            for (int x = 0; x < data.grid.dims.x; ++x) {
                const double blob = blobAt(glm::dvec3(x, y, z) - glm::dvec3(data.grid.dims - 1) / 2.0, reach);
                data.values.push_back(kind == 0   ? 0.6
                                      : kind == 1 ? (blob > 0.5 ? 1 : 0)
                                      : kind == 2 ? 1.15 * dice.unit()
                                                  : blob);
            }
        }
    }
    story += kind == 0 ? ", constant" : kind == 1 ? ", a mask" : kind == 2 ? ", noise" : "";
    return data;
}

/// Numbers of a file of floats, as the importer keeps them, laid on the grid.
std::shared_ptr<const Volume> asImported(const Grid& grid, const std::vector<float>& values) {
    const auto path = std::filesystem::temp_directory_path() / ("limner-figure-" + std::to_string(::getpid()) + ".raw");
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(float)));
    ImportOptions options;
    options.raw = std::to_string(grid.dims.x) + "x" + std::to_string(grid.dims.y) + "x" + std::to_string(grid.dims.z) +
                  ":float32:le:1,1,1";
    Task task;
    const auto read = importVolume(path, options, task).volume;
    std::filesystem::remove(path);
    Volume::Contents contents = read->contents();
    contents.grid = grid;
    const std::size_t row = static_cast<std::size_t>(grid.dims.x) * bytesPerVoxel(read->type());
    std::vector<std::byte> stored(row * static_cast<std::size_t>(grid.dims.y * grid.dims.z));
    for (int i = 0; i < grid.dims.y * grid.dims.z; ++i) {
        read->copyRow(i % grid.dims.y, i / grid.dims.y, stored.data() + row * static_cast<std::size_t>(i));
    }
    return std::make_shared<const Volume>(contents, stored);
}

/// Values v become unit * v + offset; the transfer functions with them.
struct Unit {
    double factor = 1;
    double offset = 0;
    const char* name = "";
};

std::shared_ptr<const Volume> anyVolume(Dice& dice, const Data& data, Unit& unit, std::string& story) {
    const auto at = [&](const glm::ivec3& voxel) {
        const glm::ivec3& dims = data.grid.dims;
        return data.values[static_cast<std::size_t>((voxel.z * dims.y + voxel.y) * dims.x + voxel.x)];
    };
    const int kind = dice.below(6);
    if (kind == 0) {
        story += ", 8 bits";
        return makeVolume<std::uint8_t>(
            data.grid, VoxelType::uint8, [&](const glm::ivec3& v) { return std::round(at(v) * 220); }, 1.0 / 220);
    }
    if (kind == 1) { // the whole range of the type, falling
        story += ", 16 bits";
        return makeVolume<std::int16_t>(
            data.grid, VoxelType::int16, [&](const glm::ivec3& v) { return std::round(32767 - at(v) * 56900); },
            -1.0 / 56900, 32767.0 / 56900);
    }
    constexpr double largest = 3e38; // float32 ends at 3.4e38
    unit = dice.any({Unit{1, 0, ""}, Unit{2 * largest / 1.2, -largest, ", floats of 1e38"},
                     Unit{1e-40, 0, ", denormal floats"}, Unit{1e6, 4e6, ", far from 0"}});
    story += unit.name;
    std::vector<float> values;
    for (const double value : data.values) {
        values.push_back(static_cast<float>(unit.factor * std::min(value, 1.2) + unit.offset));
    }
    if (dice.oneIn(4)) {
        story += ", voxels without a number";
        for (int i = 0; i < 1 + dice.below(5); ++i) {
            values[static_cast<std::size_t>(dice.below(static_cast<int>(values.size())))] =
                dice.any({std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()});
        }
        values.front() = static_cast<float>(unit.offset); // one number at least
    }
    return asImported(data.grid, values);
}

std::shared_ptr<const Volume> labelsOn(const Grid& grid) {
    return makeVolume<std::uint8_t>(grid, VoxelType::uint8, [&](const glm::ivec3& v) {
        const double height = v.z + 0.3 * v.x - 0.2 * v.y;
        return v == glm::ivec3(0) ? 3 : height < 0.3 * grid.dims.z ? 0 : height < 0.6 * grid.dims.z ? 3 : 7;
    });
}

// ---- view ----------------------------------------------------------------------------------------------------------

glm::dvec3 anyDirection(Dice& dice) {
    if (dice.oneIn(3)) { // along an axis or a diagonal, up to rounding
        const int which = dice.below(26);
        const int code = which < 13 ? which : which + 1;
        return {code % 3 - 1.0, code / 3 % 3 - 1.0, code / 9 - 1.0};
    }
    return {dice.between(-1, 1), dice.between(-1, 1), dice.between(-0.9, 0.9) + 1e-3};
}

/// Puts the eye of a perspective camera at a point.
void standAt(Camera& camera, const glm::dvec3& eyeMm) {
    camera.projection = Projection::perspective;
    const double distance = 0.5 * camera.heightMm / std::tan(0.5 * glm::radians(camera.fovDeg));
    camera.targetMm = eyeMm + glm::normalize(camera.direction) * distance;
}

void aim(Dice& dice, ExtremeFigure& made) {
    const Grid& grid = made.figure.volume->data->grid();
    Camera& camera = made.figure.camera;
    camera.direction = anyDirection(dice);
    camera.up = {0.31, 0.57, -0.76};
    camera.targetMm = grid.centreMm();
    camera.heightMm = 0.7 * grid.diagonalMm();
    camera.projection = dice.any({Projection::orthographic, Projection::perspective});
    camera.fovDeg = dice.between(10, 60);
    const auto inside = [&] {
        const glm::dvec3 share{dice.between(0.05, 0.95), dice.between(0.05, 0.95), dice.between(0.05, 0.95)};
        return grid.mmFromVoxel(share * glm::dvec3(grid.dims) - 0.5);
    };
    switch (dice.below(8)) {
    case 0:
        camera.fovDeg = dice.any({1.0, 50.0, 120.0, 175.0});
        camera.heightMm *= dice.any({1e-3, 0.1, 1.0});
        standAt(camera, inside());
        made.story += ", the eye inside";
        break;
    case 1:
        camera.projection = Projection::perspective;
        camera.fovDeg = glm::degrees(2 * std::atan(0.35e-4)); // ten thousand boxes away
        made.story += ", a far eye";
        break;
    case 2:
        camera.heightMm *= 1e-4;
        camera.targetMm = inside();
        made.story += ", pixels far smaller than voxels";
        break;
    case 3:
        camera.heightMm *= 20;
        made.story += ", pixels larger than voxels";
        break;
    default: break;
    }
}

// ---- the picture's size --------------------------------------------------------------------------------------------

/// Samples of a figure, at most: what a test of hundreds of figures has time for.
constexpr double kSamples = 12000;
constexpr double kMostOnRay = 8000;

void choosePixels(Dice& dice, ExtremeFigure& made) {
    const Grid& grid = made.figure.volume->data->grid();
    double& step = made.figure.quality.stepVoxels;
    const double length = grid.diagonalMm() / grid.smallestSpacingMm();
    step = dice.any({0.001, 0.01, 0.1, 0.3, 0.45, 0.5, 1.0, 3.0, 8.0, 64.0});
    if (made.figure.importance) { // what a longer step covers is 1 in single precision: no extinction to weigh
        step = std::min(step, 3.0);
    }
    step = std::max(step, length / kMostOnRay);
    if (step < 0.1) {
        keepPeaksBelow(made.figure, 0.999);
    }
    made.story += ", steps of " + std::to_string(step);
    const double rays = kSamples / std::max(1.0, length / step);
    int edge = std::clamp(static_cast<int>(std::sqrt(rays)), 1, 12);
    if (dice.oneIn(6)) {
        made.figure.quality.samplesPerPixel = 4;
        edge = std::max(1, edge / 2);
        made.story += ", four rays a pixel";
    }
    made.request.size = {edge, edge};
    made.tile = {{0, 0}, made.request.size};
    if (dice.oneIn(6)) {
        made.request.size = glm::ivec2(32768);
        made.tile.origin = {dice.below(32768 - edge), dice.below(32768 - edge)};
        made.story += ", of a picture of 32768 pixels";
    }
}

} // namespace

ExtremeFigure extremeFigure(unsigned seed) {
    Dice dice(seed);
    ExtremeFigure made;
    made.story = "seed " + std::to_string(seed);
    const Data data = anyData(dice, made.story);
    Unit unit;
    const auto volume = anyVolume(dice, data, unit, made.story);
    made.figure = extremeLayers(dice, made.story);
    made.figure.volume->data = volume;
    made.figure.labels->data = labelsOn(data.grid);
    if (dice.oneIn(4) && data.grid.diagonalMm() < 30) { // those labels are around the middle
        moveLabelsToAnotherGrid(made.figure);
    }
    pushTransfers(dice, made.figure, made.story);
    pushParts(dice, made.figure, made.story);
    aim(dice, made);
    choosePixels(dice, made);
    moveValues(made.figure, unit.factor, unit.offset);
    if (dice.oneIn(4)) {
        const double factor = dice.any({1e-4, 1e-2, 1e3, 1e5});
        scaleLengths(made.figure, factor);
        made.story += ", lengths times " + std::to_string(factor);
    }
    return made;
}

} // namespace limner::testing
