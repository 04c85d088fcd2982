#include "renderer/marks/join_lines.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <tuple>

namespace limner {

namespace {

/// Ends further apart than this are of different lines.
constexpr double kReachVoxels = 2.5;
/// Ends nearer than this belong together whatever way they point: their last pieces are all noise.
constexpr double kTouchVoxels = 0.6;
/// Length over which an end's direction is measured.
constexpr double kEndVoxels = 2;
/// Share of strong points that a line needs.
constexpr double kStrongShare = 0.25;

struct End {
    glm::dvec3 mm{0};
    glm::dvec3 outward{0}; ///< unit, away from the line
};

End endOf(const SurfaceLine& line, bool last, double voxelMm) {
    const std::size_t count = line.points.size();
    const auto point = [&](std::size_t k) { return line.points[last ? count - 1 - k : k].mm; };
    std::size_t back = 1;
    while (back + 1 < count && glm::distance(point(0), point(back)) < kEndVoxels * voxelMm) {
        ++back;
    }
    const glm::dvec3 way = point(0) - point(back);
    const double size = glm::length(way);
    return {point(0), size > 0 ? way / size : glm::dvec3(0)};
}

/// Squared distance, and the two ends (2 line + last).
using Pair = std::tuple<double, std::uint32_t, std::uint32_t>;

bool belongTogether(const End& a, const End& b, double voxelMm) {
    const glm::dvec3 gap = b.mm - a.mm;
    const double size = glm::length(gap);
    if (size > kReachVoxels * voxelMm || glm::dot(a.outward, b.outward) > -0.4) {
        return false;
    }
    return size < kTouchVoxels * voxelMm ||
           (glm::dot(a.outward, gap) > 0.6 * size && glm::dot(b.outward, gap) < -0.6 * size);
}

std::vector<Pair> candidates(const std::vector<End>& ends, double voxelMm) {
    using Key = std::tuple<int, int, int>;
    const auto cellOf = [&](const glm::dvec3& mm) { return glm::ivec3(glm::floor(mm / (kReachVoxels * voxelMm))); };
    std::map<Key, std::vector<std::uint32_t>> cells;
    for (std::uint32_t i = 0; i < ends.size(); ++i) {
        const glm::ivec3 c = cellOf(ends[i].mm);
        cells[{c.x, c.y, c.z}].push_back(i);
    }
    std::vector<Pair> pairs;
    for (std::uint32_t i = 0; i < ends.size(); ++i) {
        const glm::ivec3 c = cellOf(ends[i].mm);
        for (int k = 0; k < 27; ++k) {
            const auto found = cells.find({c.x + k % 3 - 1, c.y + k / 3 % 3 - 1, c.z + k / 9 - 1});
            if (found == cells.end()) {
                continue;
            }
            for (const std::uint32_t j : found->second) {
                if (j > i && belongTogether(ends[i], ends[j], voxelMm)) {
                    pairs.emplace_back(glm::dot(ends[i].mm - ends[j].mm, ends[i].mm - ends[j].mm), i, j);
                }
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// All lines linked to one, from its end `from` on; `partner` of an end is itself where nothing follows.
SurfaceLine linked(const std::vector<SurfaceLine>& lines, const std::vector<std::uint32_t>& partner, std::uint32_t from,
                   std::vector<std::uint8_t>& taken) {
    SurfaceLine whole;
    whole.layer = lines[from / 2].layer;
    std::uint32_t at = from;
    while (true) {
        const std::vector<LinePoint>& points = lines[at / 2].points;
        taken[at / 2] = 1;
        if (at % 2 == 0) {
            whole.points.insert(whole.points.end(), points.begin(), points.end());
        } else {
            whole.points.insert(whole.points.end(), points.rbegin(), points.rend());
        }
        const std::uint32_t next = partner[at ^ 1U];
        if (next == (at ^ 1U)) {
            return whole;
        }
        if (taken[next / 2] != 0) {
            whole.closed = true;
            return whole;
        }
        at = next;
    }
}

bool worthDrawing(const SurfaceLine& line, double leastMm) {
    double length = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        length += glm::distance(line.points[i - 1].mm, line.points[i].mm);
    }
    const auto strong =
        std::count_if(line.points.begin(), line.points.end(), [](const LinePoint& p) { return p.strong; });
    return length >= leastMm && static_cast<double>(strong) >= kStrongShare * static_cast<double>(line.points.size());
}

} // namespace

std::vector<SurfaceLine> joinLines(std::vector<SurfaceLine> lines, double voxelMm, double leastVoxels) {
    // Closed lines need no partner: they go first, then the open ones' ends are numbered from 0.
    const auto open = std::stable_partition(lines.begin(), lines.end(), [](const SurfaceLine& l) { return l.closed; });
    std::vector<SurfaceLine> joined(std::make_move_iterator(lines.begin()), std::make_move_iterator(open));
    lines.erase(lines.begin(), open);
    std::vector<End> ends;
    std::vector<std::uint32_t> partner;
    for (const SurfaceLine& line : lines) {
        for (const bool last : {false, true}) {
            partner.push_back(static_cast<std::uint32_t>(ends.size()));
            ends.push_back(endOf(line, last, voxelMm));
        }
    }
    for (const auto& [distance, a, b] : candidates(ends, voxelMm)) {
        if (partner[a] == a && partner[b] == b && (a / 2 != b / 2 || lines[a / 2].points.size() > 12)) {
            partner[a] = b;
            partner[b] = a;
        }
    }
    std::vector<std::uint8_t> taken(lines.size(), 0);
    for (const bool loops : {false, true}) {
        for (std::uint32_t i = 0; i < partner.size(); ++i) {
            if (taken[i / 2] == 0 && (loops || partner[i] == i)) {
                joined.push_back(linked(lines, partner, i, taken));
            }
        }
    }
    std::erase_if(joined, [&](const SurfaceLine& line) { return !worthDrawing(line, leastVoxels * voxelMm); });
    return joined;
}

} // namespace limner
