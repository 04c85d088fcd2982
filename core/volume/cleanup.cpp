#include "core/volume/cleanup.h"

#include "core/figure/view_frame.h"
#include "core/volume/bit_grid.h"
#include "core/volume/brick_rows.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace limner {

namespace {

/// Reach of partial volume: linear interpolation one voxel, the scanner's blur another; together nearly a ball.
constexpr Connectivity kRim[] = {Connectivity::faces, Connectivity::corners};
/// Thin matter on what stays, longer than any ear (about 80 mm at most) ...
constexpr double kLongestThinPartMm = 90;
/// ... and mostly standing above itself from slice to slice is a table's or headrest's shell; vessels branch.
constexpr double kSheetShare = 0.75; // cushions 0.80, the nose with the walls of its sinuses 0.66 (CT heads)
/// A thick part beyond a neck is something else where its inside is more than this of the subject's; an ear or a nose
/// has a grain of one.
constexpr double kOtherShare = 1e-3;

/// The volume's numbers while the steps run over them.
struct Scan {
    Volume::Contents contents;
    std::vector<std::byte> stored;

    template <typename T>
    [[nodiscard]] T* row(int y, int z) {
        const glm::ivec3 dims = contents.grid.dims;
        return reinterpret_cast<T*>(stored.data()) +
               (static_cast<std::size_t>(z) * static_cast<std::size_t>(dims.y) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(dims.x);
    }
};

Scan copyOf(const Volume& volume) {
    Scan scan{volume.contents(), {}};
    const glm::ivec3 dims = volume.grid().dims;
    const std::size_t rowBytes = static_cast<std::size_t>(dims.x) * bytesPerVoxel(volume.type());
    scan.stored.resize(volume.grid().voxelCount() * bytesPerVoxel(volume.type()));
    tbb::parallel_for(0, dims.z, [&](int z) {
        for (int y = 0; y < dims.y; ++y) {
            const std::size_t row =
                static_cast<std::size_t>(z) * static_cast<std::size_t>(dims.y) + static_cast<std::size_t>(y);
            volume.copyRow(y, z, scan.stored.data() + row * rowBytes);
        }
    });
    return scan;
}

template <typename T, typename Predicate>
BitGrid maskOf(Scan& scan, Predicate isIn) {
    const glm::ivec3 dims = scan.contents.grid.dims;
    BitGrid mask(dims);
    tbb::parallel_for(0, dims.z, [&](int z) {
        for (int y = 0; y < dims.y; ++y) {
            const T* row = scan.row<T>(y, z);
            BitGrid::Word* words = mask.row(y, z);
            for (int x = 0; x < dims.x; ++x) {
                words[x / 64] |= static_cast<BitGrid::Word>(isIn(row[x])) << (x % 64);
            }
        }
    });
    return mask;
}

/// Voxels whose value is above `value`.
BitGrid matterAbove(Scan& scan, double value) {
    return withVoxelType(scan.contents.type, [&](auto* none) {
        using T = std::remove_cvref_t<decltype(*none)>;
        const double stored = (value - scan.contents.intercept) / scan.contents.slope;
        // In double: every stored number is exact there, so that "above" is exact too.
        return scan.contents.slope > 0 ? maskOf<T>(scan, [stored](T v) { return static_cast<double>(v) > stored; })
                                       : maskOf<T>(scan, [stored](T v) { return static_cast<double>(v) < stored; });
    });
}

/// Gives the voxels of the set the volume's lowest value.
void clear(Scan& scan, const BitGrid& set) {
    const double lowest = (scan.contents.range.low - scan.contents.intercept) / scan.contents.slope;
    withVoxelType(scan.contents.type, [&](auto* none) {
        using T = std::remove_cvref_t<decltype(*none)>;
        const T fill = std::is_integral_v<T>
                           ? static_cast<T>(std::clamp(std::round(lowest), double{std::numeric_limits<T>::lowest()},
                                                       double{std::numeric_limits<T>::max()}))
                           : static_cast<T>(lowest);
        const glm::ivec3 dims = set.dims();
        tbb::parallel_for(0, dims.z, [&](int z) {
            for (int y = 0; y < dims.y; ++y) {
                T* row = scan.row<T>(y, z);
                const BitGrid::Word* words = set.row(y, z);
                for (int x = 0; x < dims.x; ++x) {
                    if ((words[x / 64] >> (x % 64) & 1) != 0) {
                        row[x] = fill;
                    }
                }
            }
        });
    });
}

/// Removed matter with its rim: what is within two voxels of it and not as near to kept matter.
BitGrid withRim(BitGrid removed, BitGrid kept) {
    for (const Connectivity round : kRim) {
        kept = dilatedByOne(kept, round);
        BitGrid grown = dilatedByOne(removed, round);
        grown -= kept;
        removed |= grown;
    }
    return removed;
}

/// What leaves the volume in one step.
struct Removal {
    BitGrid removed;
    BitGrid kept;
    bool rim = true;
};

std::vector<bool> only(std::size_t count, std::size_t chosen) {
    std::vector<bool> marks(count);
    marks[chosen] = true;
    return marks;
}

double extentMm(const Component& c, const glm::dvec3& spacingMm) {
    return glm::length(glm::dvec3(c.high - c.low + 1) * spacingMm);
}

/// The largest island when matter thinner than twice the opening does not connect, with its own thin parts.
BitGrid largestOpened(const BitGrid& matter, const Grid& grid, double openingMm) {
    const Components cores(eroded(matter, grid.spacingMm, openingMm), Connectivity::faces);
    if (cores.list().empty()) { // all is thin: nothing to tell apart
        return matter;
    }
    // One voxel more than was taken off: rounded corners come back.
    BitGrid kept =
        dilated(cores.select(only(cores.list().size(), 0)), grid.spacingMm, openingMm + grid.smallestSpacingMm());
    kept &= matter;
    BitGrid rest = matter;
    rest -= kept;
    const Components parts(rest, Connectivity::faces);
    std::vector<bool> stays = parts.meeting(dilatedByOne(kept, Connectivity::faces));
    const std::vector<bool> isCore = parts.meeting(cores.select([&] {
        std::vector<bool> others(cores.list().size());
        const double subject = static_cast<double>(cores.list()[0].voxels);
        for (std::size_t i = 1; i < others.size(); ++i) {
            others[i] = static_cast<double>(cores.list()[i].voxels) > kOtherShare * subject;
        }
        return others;
    }()));
    for (std::size_t i = 0; i < stays.size(); ++i) {
        const Component& part = parts.list()[i];
        const bool sheet = static_cast<double>(part.stacked) > kSheetShare * static_cast<double>(part.voxels);
        const bool shell = sheet && extentMm(part, grid.spacingMm) > kLongestThinPartMm;
        stays[i] = stays[i] && !shell && !isCore[i];
    }
    kept |= parts.select(stays);
    return kept;
}

Removal keepLargest(Scan& scan, const CleanupStep& step) {
    const Grid& grid = scan.contents.grid;
    BitGrid matter = matterAbove(scan, step.above);
    BitGrid kept = matter;
    if (step.openingMm > 0) {
        kept = largestOpened(matter, grid, step.openingMm);
    } else if (const Components islands(matter, Connectivity::faces); !islands.list().empty()) {
        kept = islands.select(only(islands.list().size(), 0));
    }
    matter -= kept;
    return {std::move(matter), std::move(kept)};
}

/// The island at a point, or the nearest one within a few voxels of it: a click lands on a surface.
int islandNear(const Components& islands, const Grid& grid, const glm::dvec3& pointMm) {
    constexpr int kReach = 3;
    const glm::ivec3 centre(glm::round(grid.voxelFromMm(pointMm)));
    int best = -1;
    double bestDistance = std::numeric_limits<double>::infinity();
    for (int z = -kReach; z <= kReach; ++z) {
        for (int y = -kReach; y <= kReach; ++y) {
            for (int x = -kReach; x <= kReach; ++x) {
                const glm::ivec3 voxel = centre + glm::ivec3(x, y, z);
                if (voxel != glm::clamp(voxel, glm::ivec3(0), grid.dims - 1)) {
                    continue;
                }
                const int island = islands.at(voxel);
                const double distance = glm::distance(grid.mmFromVoxel(voxel), pointMm);
                if (island >= 0 && distance < bestDistance) {
                    best = island;
                    bestDistance = distance;
                }
            }
        }
    }
    return best;
}

Removal keepAt(Scan& scan, const CleanupStep& step, Task& task) {
    BitGrid matter = matterAbove(scan, step.above);
    const Components islands(matter, Connectivity::faces);
    const int island = step.atMm ? islandNear(islands, scan.contents.grid, *step.atMm) : -1;
    if (island < 0) {
        task.warn("clean-up: there is no matter at the point of a keep-at step; the step does nothing");
        return {BitGrid(matter.dims()), std::move(matter)};
    }
    BitGrid kept = islands.select(only(islands.list().size(), static_cast<std::size_t>(island)));
    matter -= kept;
    return {std::move(matter), std::move(kept)};
}

Removal removeIslands(Scan& scan, const CleanupStep& step) {
    const Grid& grid = scan.contents.grid;
    const double voxelMm3 = grid.spacingMm.x * grid.spacingMm.y * grid.spacingMm.z;
    BitGrid matter = matterAbove(scan, step.above);
    // Corners connect here: a thread that runs across the voxels' diagonal is no crowd of islands.
    const Components islands(matter, Connectivity::corners);
    std::vector<bool> stays(islands.list().size());
    for (std::size_t i = 0; i < stays.size(); ++i) {
        stays[i] = static_cast<double>(islands.list()[i].voxels) * voxelMm3 >= step.belowMm3;
    }
    BitGrid kept = islands.select(stays);
    matter -= kept;
    return {std::move(matter), std::move(kept)};
}

/// Crossings of the picture of one voxel row with the lasso's edges, as positions along the row, in front of the eye.
/// Positions along a row are a projective map of positions in the picture, so homogeneous points stay linear.
void crossings(const std::vector<glm::dvec2>& polygon, const glm::dvec3& start, const glm::dvec3& step,
               std::vector<double>& out) {
    out.clear();
    const glm::dvec3 line = glm::cross(start, step);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const glm::dvec3 a(polygon[k], 1);
        const glm::dvec3 b(polygon[(k + 1) % polygon.size()], 1);
        if ((glm::dot(line, a) < 0) == (glm::dot(line, b) < 0)) { // half-open: a corner counts once
            continue;
        }
        const glm::dvec3 edge = glm::cross(a, b);
        const double along = -glm::dot(edge, start) / glm::dot(edge, step);
        if (std::isfinite(along) && start.z + along * step.z > 0) {
            out.push_back(along);
        }
    }
    std::sort(out.begin(), out.end());
}

bool insidePolygon(const std::vector<glm::dvec2>& polygon, const glm::dvec2& p) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const glm::dvec2 a = polygon[k];
        const glm::dvec2 b = polygon[(k + 1) % polygon.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            inside = !inside;
        }
    }
    return inside;
}

/// Marks the voxels of one row that the lasso cuts.
void cutRow(const CleanupStep& step, const glm::dvec3& start, const glm::dvec3& along, glm::ivec3 rowYZCount,
            std::vector<double>& scratch, BitGrid& cut) {
    const int count = rowYZCount.z;
    const bool cutInside = step.side == ScissorsSide::inside;
    // A row that runs into the picture is one point there.
    const glm::dvec2 first = glm::dvec2(start) / start.z;
    const glm::dvec3 end = start + along * static_cast<double>(count);
    constexpr double kPoint = 1e-9; // of the picture: far below any pixel
    const bool isPoint = start.z > 0 && end.z > 0 && glm::distance(first, glm::dvec2(end) / end.z) < kPoint;
    if (isPoint) {
        if (insidePolygon(step.polygon, first) == cutInside) {
            cut.setRun(rowYZCount.x, rowYZCount.y, {0, count});
        }
        return;
    }
    crossings(step.polygon, start, along, scratch);
    for (int x = 0; x < count; ++x) {
        if (!(start.z + x * along.z > 0)) {
            continue; // behind the eye
        }
        // Parity is counted from the end of the row's picture that runs off to infinity: there it is outside.
        const auto before = std::lower_bound(scratch.begin(), scratch.end(), static_cast<double>(x)) - scratch.begin();
        const auto passed = along.z >= 0 ? before : static_cast<std::ptrdiff_t>(scratch.size()) - before;
        if ((passed % 2 == 1) == cutInside) {
            cut.set({x, rowYZCount.x, rowYZCount.y});
        }
    }
}

Removal scissors(Scan& scan, const CleanupStep& step, double figureAspect, Task& task) {
    const Grid& grid = scan.contents.grid;
    BitGrid cut(grid.dims);
    if (!step.camera || step.polygon.size() < 3) {
        task.warn("clean-up: a scissors step needs an outline of three points and its view; the step does nothing");
    } else {
        const ViewFrame view(*step.camera, step.aspect.value_or(figureAspect));
        const glm::dmat3 toMm = grid.voxelToMmMatrix();
        const glm::dvec3 along = view.projectStep(toMm[0]);
        tbb::parallel_for(0, grid.dims.z, [&](int z) {
            std::vector<double> scratch;
            for (int y = 0; y < grid.dims.y; ++y) {
                cutRow(step, view.project(grid.mmFromVoxel({0, y, z})), along, {y, z, grid.dims.x}, scratch, cut);
            }
        });
    }
    return {std::move(cut), BitGrid(grid.dims), false}; // the user's line is the wall: no rim
}

Removal eraseLabel(Scan& scan, const CleanupStep& step, const Volume* labels, Task& task) {
    const Grid& grid = scan.contents.grid;
    Removal removal{BitGrid(grid.dims), BitGrid(grid.dims)};
    if (labels == nullptr) {
        task.warn("clean-up: an erase-label step needs a label volume; the step does nothing");
        return removal;
    }
    const glm::dmat3 map = labels->grid().mmToVoxelMatrix();
    const glm::dvec3 step0 = map * grid.voxelToMmMatrix()[0];
    tbb::parallel_for(0, grid.dims.z, [&](int z) {
        for (int y = 0; y < grid.dims.y; ++y) {
            const glm::dvec3 start = labels->grid().voxelFromMm(grid.mmFromVoxel({0, y, z}));
            for (int x = 0; x < grid.dims.x; ++x) {
                const glm::ivec3 voxel(glm::round(start + step0 * static_cast<double>(x)));
                if (voxel != glm::clamp(voxel, glm::ivec3(0), labels->grid().dims - 1)) {
                    continue;
                }
                const int label = static_cast<int>(std::lround(labels->valueAt(voxel)));
                if (label == step.label) {
                    removal.removed.set({x, y, z});
                } else if (label != 0) {
                    removal.kept.set({x, y, z});
                }
            }
        }
    });
    return removal;
}

} // namespace

std::shared_ptr<const Volume> applyCleanup(std::shared_ptr<const Volume> volume, const Volume* labels,
                                           const std::vector<CleanupStep>& steps, double figureAspect, Task& task) {
    if (!volume || steps.empty()) {
        return volume;
    }
    task.beginPhase("Cleaning up");
    Scan scan = copyOf(*volume);
    bool changed = false;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        task.throwIfCancelled();
        const CleanupStep& step = steps[i];
        Removal removal = [&] {
            switch (step.kind) {
            case CleanupKind::keepLargest: return keepLargest(scan, step);
            case CleanupKind::keepAt: return keepAt(scan, step, task);
            case CleanupKind::removeIslands: return removeIslands(scan, step);
            case CleanupKind::scissors: return scissors(scan, step, figureAspect, task);
            case CleanupKind::eraseLabel: break;
            }
            return eraseLabel(scan, step, labels, task);
        }();
        task.throwIfCancelled();
        if (!removal.removed.empty()) {
            clear(scan, removal.rim ? withRim(std::move(removal.removed), std::move(removal.kept)) : removal.removed);
            changed = true;
        }
        task.progress(static_cast<double>(i + 1) / static_cast<double>(steps.size()));
    }
    task.throwIfCancelled();
    return changed ? std::make_shared<const Volume>(scan.contents, scan.stored) : volume;
}

} // namespace limner
