#include "core/style/extraction/normals.h"

#include "core/base/task.h"
#include "core/style/extraction/membrane.h"

#include <glm/geometric.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limner {
namespace {

using Cell = Membrane::Cell;

constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
/// Normals change slowly: a form is inflated on a grid of at most this many cells a side.
constexpr int kInflatedSide = 384;

NormalField emptyField(const ArtCut& cut) {
    NormalField field{cut.picture.width, cut.picture.height, {}};
    field.normals.assign(cut.picture.pixels.size(), glm::vec2(kNowhere, kNowhere));
    return field;
}

/// Keeps a normal within the unit disk.
glm::dvec2 onDisk(glm::dvec2 normal) {
    const double length = glm::length(normal);
    return length > 1 ? normal / length : normal;
}

/// The region on its own small grid, with a border of one cell outside it.
struct FormGrid {
    int width = 0;
    int height = 0;
    double perCell = 1; ///< pixels of the cut
    std::vector<Cell> cells;

    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    /// From a cut's place to the grid's; cell (i, j) covers [i, i+1] x [j, j+1].
    [[nodiscard]] glm::dvec2 fromCut(glm::dvec2 p) const { return p / perCell + 1.0; }
};

FormGrid gridOf(const Mask& region) {
    FormGrid grid;
    const int longer = std::max(region.width, region.height);
    grid.perCell = std::max(1.0, static_cast<double>(longer) / kInflatedSide);
    const int w = std::max(1, static_cast<int>(std::ceil(region.width / grid.perCell)));
    const int h = std::max(1, static_cast<int>(std::ceil(region.height / grid.perCell)));
    const cv::Mat mask(region.height, region.width, CV_8U, const_cast<std::uint8_t*>(region.values.data()));
    cv::Mat small;
    cv::resize(mask, small, {w, h}, 0, 0, cv::INTER_AREA);
    grid.width = w + 2;
    grid.height = h + 2;
    grid.cells.assign(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), Cell::fixed);
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const bool beyond = x == 0 || y == 0 || x == grid.width - 1 || y == grid.height - 1;
            Cell& cell = grid.cells[grid.at(x, y)];
            // What lies beyond the cut is unknown, not an edge of the form.
            cell = beyond ? Cell::wall : (small.at<std::uint8_t>(y - 1, x - 1) >= 128 ? Cell::free : Cell::fixed);
        }
    }
    return grid;
}

/// Visits places along a path at most half a cell apart, with the direction there.
template <typename Visit>
void walk(const FormGrid& grid, const ArtCut& cut, const ArtPath& path, Visit visit) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const glm::dvec2 from = grid.fromCut(cut.toCut(path[i]));
        const glm::dvec2 to = grid.fromCut(cut.toCut(path[i + 1]));
        const double length = glm::length(to - from);
        // A path far outside the picture is no reason to walk for hours.
        const int steps = static_cast<int>(std::clamp(std::ceil(2 * length), 1.0, 20'000.0));
        for (int k = 0; k <= steps && length > 0; ++k) {
            visit(from + (to - from) * (static_cast<double>(k) / steps), (to - from) / length);
        }
    }
}

template <typename Visit>
void around(const FormGrid& grid, glm::dvec2 place, double radius, Visit visit) {
    if (!(std::abs(place.x) < 1e6) || !(std::abs(place.y) < 1e6)) {
        return;
    }
    const int x0 = std::max(0, static_cast<int>(std::floor(place.x - radius)));
    const int x1 = std::min(grid.width - 1, static_cast<int>(std::floor(place.x + radius)));
    const int y0 = std::max(0, static_cast<int>(std::floor(place.y - radius)));
    const int y1 = std::min(grid.height - 1, static_cast<int>(std::floor(place.y + radius)));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const glm::dvec2 way = glm::dvec2(x + 0.5, y + 0.5) - place;
            if (glm::length(way) <= radius) {
                visit(grid.at(x, y), way);
            }
        }
    }
}

void openOutline(FormGrid& grid, const ArtCut& cut, const FormMarks& marks) {
    constexpr double kReach = 3; // cells: a stroke along an outline is drawn by hand
    for (const ArtPath& path : marks.open) {
        walk(grid, cut, path, [&](glm::dvec2 place, glm::dvec2 /*along*/) {
            around(grid, place, kReach, [&](std::size_t cell, glm::dvec2 /*way*/) {
                if (grid.cells[cell] == Cell::fixed) {
                    grid.cells[cell] = Cell::wall;
                }
            });
        });
    }
}

/// Distance from a cell to the occluding outline, in cells.
double roomAt(const FormGrid& grid, std::size_t cell) {
    cv::Mat inside(grid.height, grid.width, CV_8U);
    inside = 255;
    for (int y = 1; y + 1 < grid.height; ++y) {
        for (int x = 1; x + 1 < grid.width; ++x) {
            const auto free = [&](int dx, int dy) { return grid.cells[grid.at(x + dx, y + dy)] == Cell::free; };
            // The outline alone: what lies outside of it beyond an open stretch is not this form's edge.
            const bool outline =
                grid.cells[grid.at(x, y)] == Cell::fixed && (free(-1, 0) || free(1, 0) || free(0, -1) || free(0, 1));
            inside.at<std::uint8_t>(y, x) = outline ? 0 : 255;
        }
    }
    cv::Mat distance;
    cv::distanceTransform(inside, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return distance.at<float>(static_cast<int>(cell / static_cast<std::size_t>(grid.width)),
                              static_cast<int>(cell % static_cast<std::size_t>(grid.width))) -
           0.5; // the outline runs between two cells' centres
}

/// Normals of the inflated region, n_y up; 0 outside.
std::vector<glm::dvec2> inflate(const FormGrid& grid, double depth, Task& task) {
    Membrane membrane{grid.width, grid.height, grid.cells, std::vector<float>(grid.cells.size(), 0), 4, 2};
    solveMembrane(membrane, task);
    const std::vector<float>& h = membrane.values;
    std::size_t top = 0;
    for (std::size_t i = 0; i < h.size(); ++i) {
        top = grid.cells[i] == Cell::free && (grid.cells[top] != Cell::free || h[i] > h[top]) ? i : top;
    }
    std::vector<glm::dvec2> normals(h.size(), glm::dvec2(0, 0));
    if (grid.cells[top] != Cell::free || !(h[top] > 0)) {
        return normals;
    }
    // The form is as deep as it is wide where it is deepest, or as told: z^2 = k h.
    const double room = roomAt(grid, top) * std::clamp(depth, 0.1, 10.0);
    const double k = room * room / h[top];
    for (int y = 1; y + 1 < grid.height; ++y) {
        for (int x = 1; x + 1 < grid.width; ++x) {
            const std::size_t i = grid.at(x, y);
            if (grid.cells[i] != Cell::free) {
                continue;
            }
            // Beyond an outline, which runs half a cell away, h changes its sign; along a wall it goes on.
            const auto value = [&](std::size_t n) {
                return grid.cells[n] == Cell::free ? h[n] : (grid.cells[n] == Cell::fixed ? -h[i] : h[i]);
            };
            const double hx = (value(grid.at(x + 1, y)) - value(grid.at(x - 1, y))) / 2.0;
            const double hy = (value(grid.at(x, y + 1)) - value(grid.at(x, y - 1))) / 2.0;
            const double length = std::sqrt(k * k * (hx * hx + hy * hy) / 4 + k * std::max(0.0F, h[i]));
            normals[i] = length > 0 ? glm::dvec2(-k * hx / 2, k * hy / 2) / length : glm::dvec2(0, 0);
        }
    }
    return normals;
}

/// What is known of the normals at single cells, as corrections of the inflated form's.
struct Corrections {
    std::vector<Cell> cells;
    std::vector<glm::dvec2> values;
    bool any = false;

    void hold(std::size_t cell, glm::dvec2 correction) {
        if (cells[cell] != Cell::wall && cells[cell] != Cell::fixed) {
            cells[cell] = Cell::fixed;
            values[cell] = correction;
            any = true;
        }
    }
};

void addCreases(const FormGrid& grid, const ArtCut& cut, const FormMarks& marks,
                const std::vector<glm::dvec2>& inflated, Corrections& corrections) {
    for (const Crease& crease : marks.creases) {
        walk(grid, cut, crease.path, [&](glm::dvec2 place, glm::dvec2 /*along*/) {
            around(grid, place, 0.75, [&](std::size_t cell, glm::dvec2 /*way*/) {
                if (corrections.cells[cell] == Cell::free) {
                    corrections.cells[cell] = Cell::wall;
                }
            });
        });
    }
    for (const Crease& crease : marks.creases) {
        const double tilt = std::sin(crease.tiltDegrees * 3.14159265358979323846 / 180);
        walk(grid, cut, crease.path, [&](glm::dvec2 place, glm::dvec2 along) {
            around(grid, place, 2, [&](std::size_t cell, glm::dvec2 way) {
                if (corrections.cells[cell] != Cell::free) {
                    return;
                }
                const glm::dvec2 across = way - along * glm::dot(way, along);
                const double distance = glm::length(across);
                if (distance < 0.5) {
                    return; // beyond the path's end
                }
                const glm::dvec2 side = glm::dvec2(across.x, -across.y) / distance; // n_y goes up
                const glm::dvec2 forward(along.x, -along.y);
                const glm::dvec2 wanted = onDisk(side * tilt + forward * glm::dot(inflated[cell], forward));
                corrections.hold(cell, wanted - inflated[cell]);
            });
        });
    }
}

/// The corrections spread over the form, one of the two coordinates.
std::vector<float> spread(const FormGrid& grid, const Corrections& corrections, int axis, Task& task) {
    Membrane membrane{grid.width, grid.height, corrections.cells, std::vector<float>(grid.cells.size(), 0), 0, 1};
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
        membrane.values[i] = static_cast<float>(corrections.values[i][axis]);
    }
    solveMembrane(membrane, task);
    return membrane.values;
}

void correct(const FormGrid& grid, const ArtCut& cut, const FormMarks& marks, std::vector<glm::dvec2>& normals,
             Task& task) {
    Corrections corrections{grid.cells, std::vector<glm::dvec2>(grid.cells.size(), glm::dvec2(0, 0)), false};
    constexpr double kMark = 2; // cells: a mark means a small patch, not a point, which a membrane hardly feels
    for (const NormalMark& mark : marks.normals) {
        around(grid, grid.fromCut(cut.toCut(mark.at)), kMark, [&](std::size_t cell, glm::dvec2 /*way*/) {
            corrections.hold(cell, onDisk(mark.normal) - normals[cell]);
        });
    }
    addCreases(grid, cut, marks, normals, corrections);
    if (!corrections.any) {
        return;
    }
    const std::vector<float> x = spread(grid, corrections, 0, task);
    const std::vector<float> y = spread(grid, corrections, 1, task);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (grid.cells[i] == Cell::free) {
            normals[i] = onDisk(normals[i] + glm::dvec2(x[i], y[i]));
        }
    }
}

/// Bilinear between the centres of the region's cells near a place; those outside do not count.
glm::vec2 sample(const FormGrid& grid, const std::vector<glm::dvec2>& normals, glm::dvec2 place) {
    const double u = place.x - 0.5;
    const double v = place.y - 0.5;
    const int x0 = static_cast<int>(std::floor(u));
    const int y0 = static_cast<int>(std::floor(v));
    glm::dvec2 sum(0, 0);
    double weight = 0;
    for (int k = 0; k < 4; ++k) {
        const int x = std::clamp(x0 + k % 2, 0, grid.width - 1);
        const int y = std::clamp(y0 + k / 2, 0, grid.height - 1);
        const double w = std::max(0.0, 1 - std::abs(u - x)) * std::max(0.0, 1 - std::abs(v - y));
        if (grid.cells[grid.at(x, y)] == Cell::free) {
            sum += w * normals[grid.at(x, y)];
            weight += w;
        }
    }
    return weight > 0 ? glm::vec2(sum / weight) : glm::vec2(kNowhere, kNowhere);
}

} // namespace

NormalField ellipseNormals(const ArtCut& cut, const Ellipse& ellipse) {
    NormalField field = emptyField(cut);
    const double angle = ellipse.degrees * 3.14159265358979323846 / 180;
    const glm::dvec2 first(std::cos(angle), std::sin(angle));
    const glm::dvec2 second(-first.y, first.x);
    for (int y = 0; y < field.height; ++y) {
        for (int x = 0; x < field.width; ++x) {
            const glm::dvec2 way = cut.toArtwork({x + 0.5, y + 0.5}) - ellipse.centre;
            // Stretched along the axes and not turned, so that up stays up.
            const glm::dvec2 onUnit = first * (glm::dot(way, first) / ellipse.semiAxes.x) +
                                      second * (glm::dot(way, second) / ellipse.semiAxes.y);
            if (glm::dot(onUnit, onUnit) <= 1) {
                field.normals[cut.picture.offset(x, y)] = glm::vec2(onUnit.x, -onUnit.y);
            }
        }
    }
    return field;
}

NormalField formNormals(const ArtCut& cut, const Mask& region, const FormMarks& marks, Task& task) {
    NormalField field = emptyField(cut);
    FormGrid grid = gridOf(region);
    openOutline(grid, cut, marks);
    if (std::find(grid.cells.begin(), grid.cells.end(), Cell::fixed) == grid.cells.end()) {
        // No outline at all: nothing is known but that it faces the viewer.
        for (std::size_t i = 0; i < field.normals.size(); ++i) {
            field.normals[i] = region.values[i] >= 128 ? glm::vec2(0, 0) : field.normals[i];
        }
        return field;
    }
    std::vector<glm::dvec2> normals = inflate(grid, marks.depth, task);
    correct(grid, cut, marks, normals, task);
    for (int y = 0; y < field.height; ++y) {
        for (int x = 0; x < field.width; ++x) {
            if (region.has(x, y)) {
                field.normals[cut.picture.offset(x, y)] =
                    sample(grid, normals, grid.fromCut(glm::dvec2(x + 0.5, y + 0.5)));
            }
        }
    }
    return field;
}

} // namespace limner
