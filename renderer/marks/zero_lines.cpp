#include "renderer/marks/zero_lines.h"

#include "renderer/marks/join_lines.h"
#include "renderer/marks/neighbours.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <array>
#include <cmath>
#include <limits>

namespace limner {

namespace {

/// Three mark voxels, in rising order: the face of two tetrahedra, and a name for the point of a line on it.
using Face = std::array<std::uint32_t, 3>;

struct FacePoint {
    Face face{0};
    LinePoint point;
};

/// What a line is inside one tetrahedron.
struct Piece {
    std::array<FacePoint, 2> ends;
    std::uint8_t layer = 0;
};

/// Numbers that are zero, or multiples of one another, have no one zero line: moved by this share, each otherwise.
double nudged(float number, std::uint32_t index, std::uint32_t salt, double unit) {
    std::uint32_t h = (index + salt) * 0x9E3779B1U;
    h ^= h >> 15U;
    h *= 0x85EBCA77U;
    h ^= h >> 13U;
    return static_cast<double>(number) + unit * (1e-6 + 1e-5 * static_cast<double>(h >> 8U) / (1U << 24U));
}

class Tetrahedra {
  public:
    Tetrahedra(const MarkField& field, const ZeroLineRequest& request)
        : field_(field), request_(request), mmFromVoxelT_(glm::transpose(field.grid.mmToVoxelMatrix())) {}

    /// The six around the diagonal of the cube over `corners` (x fastest); absent corners are kNone.
    void addCube(const std::array<std::uint32_t, 8>& corners, std::vector<Piece>& pieces) const {
        if (!mayCross(corners)) {
            return;
        }
        static constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        for (const auto& order : kOrders) {
            std::array<std::uint32_t, 4> v{corners[0], 0, 0, corners[7]};
            v[1] = corners[1U << static_cast<unsigned>(order[0])];
            v[2] = corners[(1U << static_cast<unsigned>(order[0])) | (1U << static_cast<unsigned>(order[1]))];
            if (v[1] != kNone && v[2] != kNone) {
                addPiece(v, order, pieces);
            }
        }
    }

    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  private:
    /// False where all corners that are there lie on one side of zero.
    [[nodiscard]] bool mayCross(const std::array<std::uint32_t, 8>& corners) const {
        constexpr float close = 1e-3F; // more than numbers are nudged
        glm::vec2 low(std::numeric_limits<float>::max());
        glm::vec2 high(std::numeric_limits<float>::lowest());
        for (const std::uint32_t i : corners) {
            if (i != kNone) {
                const glm::vec2 own(request_.surface.distances[i] / static_cast<float>(field_.mmPerVoxel),
                                    request_.number[i]);
                low = glm::min(low, own);
                high = glm::max(high, own);
            }
        }
        const bool surface = low.x < close && high.x > -close;
        return surface && (!request_.axis.empty() || (low.y < close && high.y > -close));
    }

    void addPiece(const std::array<std::uint32_t, 4>& v, const int (&order)[3], std::vector<Piece>& pieces) const {
        Piece piece;
        unsigned found = 0;
        for (unsigned without = 0; without < 4 && found < 2; ++without) {
            Face face{};
            for (unsigned k = 0, n = 0; k < 4; ++k) {
                if (k != without) {
                    face[n++] = v[k];
                }
            }
            std::sort(face.begin(), face.end());
            found += crosses(face, piece.ends[found]) ? 1U : 0U;
        }
        if (found < 2) {
            return;
        }
        const glm::vec3 slope = slopeOf(v, order);
        if (!request_.axis.empty() && glm::dot(slope, request_.axis[v[0]]) >= 0) {
            return;
        }
        const bool strong = std::any_of(v.begin(), v.end(), [&](std::uint32_t i) { return request_.strong[i] != 0; });
        for (FacePoint& end : piece.ends) {
            end.point.slope = slope;
            end.point.strong = strong;
        }
        piece.layer = field_.voxels[v[0]].layer;
        pieces.push_back(piece);
    }

    [[nodiscard]] double distance(std::uint32_t i) const {
        return nudged(request_.surface.distances[i], i, 1, field_.mmPerVoxel);
    }
    [[nodiscard]] double number(std::uint32_t i) const { return nudged(request_.number[i], i, 7919, 1); }

    /// Sign of a voxel's axis against another's.
    [[nodiscard]] double side(std::uint32_t of, std::uint32_t against) const {
        return request_.axis.empty() || glm::dot(request_.axis[of], request_.axis[against]) >= 0 ? 1 : -1;
    }

    /// Where both the distance and the number are zero on a face, each linear there.
    bool crosses(const Face& f, FacePoint& found) const {
        const glm::dvec3 far(distance(f[0]), distance(f[1]), distance(f[2]));
        const double second = side(f[1], f[0]);
        const double third = side(f[2], f[0]);
        if (second * third * side(f[2], f[1]) < 0) {
            return false;
        }
        const glm::dvec3 of(number(f[0]), second * number(f[1]), third * number(f[2]));
        glm::dvec3 share = glm::cross(far, of);
        const bool inside = (share.x > 0 && share.y > 0 && share.z > 0) || (share.x < 0 && share.y < 0 && share.z < 0);
        if (!inside) {
            return false;
        }
        share /= share.x + share.y + share.z;
        found.face = f;
        found.point = {};
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t i = f[static_cast<std::size_t>(k)];
            found.point.mm += share[k] * field_.placeMm(field_.voxels[i]);
            found.point.normalMm += static_cast<float>(share[k]) * request_.surface.normals[i];
            found.point.strength += static_cast<float>(share[k]) * request_.strength[i];
        }
        const float size = glm::length(found.point.normalMm);
        if (!(size > 1e-3F) || !(found.point.strength >= request_.least)) {
            return false;
        }
        found.point.normalMm /= size;
        return true;
    }

    [[nodiscard]] glm::vec3 slopeOf(const std::array<std::uint32_t, 4>& v, const int (&order)[3]) const {
        glm::dvec3 perVoxel(0);
        for (unsigned k = 0; k < 3; ++k) {
            perVoxel[order[k]] = side(v[k + 1], v[0]) * number(v[k + 1]) - side(v[k], v[0]) * number(v[k]);
        }
        return {mmFromVoxelT_ * perVoxel};
    }

    const MarkField& field_;
    const ZeroLineRequest& request_;
    glm::dmat3 mmFromVoxelT_;
};

/// Pieces of the cubes whose lowest corner lies in one row.
std::vector<Piece> piecesOfRow(const MarkField& field, const ZeroLineRequest& request, const Tetrahedra& tetrahedra,
                               glm::ivec2 yz) {
    std::vector<Piece> pieces;
    std::array<std::uint32_t, 4> at{};
    std::array<std::uint32_t, 4> end{};
    for (unsigned k = 0; k < 4; ++k) {
        const std::size_t row = static_cast<std::size_t>(yz.x) + (k & 1U) +
                                static_cast<std::size_t>(field.grid.dims.y) * (static_cast<std::size_t>(yz.y) + k / 2);
        at[k] = field.rowStart[row];
        end[k] = field.rowStart[row + 1];
    }
    for (std::uint32_t low = at[0]; low < end[0]; ++low) {
        if (request.use[low] == 0) {
            continue;
        }
        const int x = field.voxels[low].cell.x;
        std::array<std::uint32_t, 8> corners{};
        for (unsigned k = 0; k < 4; ++k) {
            while (at[k] < end[k] && field.voxels[at[k]].cell.x < x) {
                ++at[k];
            }
            for (unsigned step = 0; step < 2; ++step) {
                const std::uint32_t i = at[k] + (at[k] < end[k] && field.voxels[at[k]].cell.x == x ? step : 0);
                const bool there =
                    i < end[k] && field.voxels[i].cell.x == x + static_cast<int>(step) && request.use[i] != 0;
                corners[2 * k + step] = there ? i : Tetrahedra::kNone;
            }
        }
        if (corners[7] != Tetrahedra::kNone) {
            tetrahedra.addCube(corners, pieces);
        }
    }
    return pieces;
}

std::vector<Piece> allPieces(const MarkField& field, const ZeroLineRequest& request) {
    const Tetrahedra tetrahedra(field, request);
    const glm::ivec3 dims = field.grid.dims;
    if (dims.x < 2 || dims.y < 2 || dims.z < 2) {
        return {};
    }
    std::vector<std::vector<Piece>> ofSlice(static_cast<std::size_t>(dims.z - 1));
    tbb::parallel_for(0, dims.z - 1, [&](int z) {
        std::vector<Piece>& own = ofSlice[static_cast<std::size_t>(z)];
        for (int y = 0; y + 1 < dims.y; ++y) {
            const std::vector<Piece> row = piecesOfRow(field, request, tetrahedra, {y, z});
            own.insert(own.end(), row.begin(), row.end());
        }
    });
    std::vector<Piece> all;
    for (const std::vector<Piece>& own : ofSlice) {
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

/// For every end of a piece (2 piece + end) the end that shares its face, or itself.
std::vector<std::uint32_t> partners(const std::vector<Piece>& pieces) {
    std::vector<std::uint32_t> order(2 * pieces.size());
    std::vector<std::uint32_t> partner(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        order[i] = i;
        partner[i] = i;
    }
    const auto face = [&](std::uint32_t i) -> const Face& { return pieces[i / 2].ends[i % 2].face; };
    tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return face(a) != face(b) ? face(a) < face(b) : a < b;
    });
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        if (face(order[i]) == face(order[i + 1])) {
            partner[order[i]] = order[i + 1];
            partner[order[i + 1]] = order[i];
            ++i;
        }
    }
    return partner;
}

/// The line through a piece, from its end `from` on.
SurfaceLine walk(const std::vector<Piece>& pieces, const std::vector<std::uint32_t>& partner, std::uint32_t from,
                 std::vector<std::uint8_t>& walked) {
    SurfaceLine line;
    line.layer = pieces[from / 2].layer;
    std::uint32_t at = from;
    while (true) {
        walked[at / 2] = 1;
        line.points.push_back(pieces[at / 2].ends[at % 2].point);
        const std::uint32_t out = at ^ 1U;
        const std::uint32_t next = partner[out];
        if (next == out) {
            line.points.push_back(pieces[out / 2].ends[out % 2].point);
            return line;
        }
        if (walked[next / 2] != 0) {
            line.closed = true;
            return line;
        }
        at = next;
    }
}

} // namespace

SmoothSurface smoothSurface(const MarkField& field, std::span<const std::uint8_t> use) {
    SmoothSurface smooth;
    smooth.normals.resize(field.voxels.size(), glm::vec3(0));
    smooth.distances.resize(field.voxels.size(), 0);
    const glm::mat3 mmFromVoxel(field.grid.voxelToMmMatrix());
    const auto voxelMm = static_cast<float>(field.mmPerVoxel);
    tbb::parallel_for(std::size_t{0}, field.voxels.size(), [&](std::size_t i) {
        if (use[i] == 0) {
            return;
        }
        const glm::vec3 own = field.voxels[i].normalMm;
        glm::vec3 normal(0);
        float distance = 0;
        float sum = 0;
        forNeighbours(field, i, [&](std::uint32_t j, const glm::ivec3& step) {
            const MarkVoxel& v = field.voxels[j];
            const float alike = std::max(glm::dot(own, v.normalMm), 0.0F);
            const glm::vec3 away = mmFromVoxel * glm::vec3(step); // from the voxel to its neighbour
            const float known = 1.1F - std::min(std::abs(v.edgeOffsetMm) / voxelMm, 1.0F);
            const float weight = (v.gradient + 1e-3F) * alike * alike * known *
                                 std::exp(-0.7F * glm::dot(away, away) / (voxelMm * voxelMm));
            normal += weight * v.normalMm;
            distance -= weight * (glm::dot(v.normalMm, away) + v.edgeOffsetMm);
            sum += weight;
        });
        const float size = glm::length(normal);
        smooth.normals[i] = size > 1e-12F ? normal / size : own;
        smooth.distances[i] = sum > 0 ? distance / sum : -field.voxels[i].edgeOffsetMm;
    });
    return smooth;
}

std::vector<SurfaceLine> zeroLines(const MarkField& field, const ZeroLineRequest& request, double leastVoxels) {
    const std::vector<Piece> pieces = allPieces(field, request);
    const std::vector<std::uint32_t> partner = partners(pieces);
    std::vector<std::uint8_t> walked(pieces.size(), 0);
    std::vector<SurfaceLine> lines;
    for (const bool loops : {false, true}) {
        for (std::uint32_t i = 0; i < partner.size(); ++i) {
            if (walked[i / 2] == 0 && (loops || partner[i] == i)) {
                lines.push_back(walk(pieces, partner, i, walked));
            }
        }
    }
    return joinLines(std::move(lines), field.mmPerVoxel, leastVoxels);
}

} // namespace limner
