#include "renderer/accuracy/normal_quantisation.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limner::accuracy {

namespace {

using Directions = std::vector<glm::dvec3>;

/// (x, y, z) with all signs of what is not 0, in its three cyclic orders.
void addCyclic(const glm::dvec3& corner, Directions& out) {
    for (int turn = 0; turn < 3; ++turn) {
        const glm::dvec3 v(corner[turn], corner[(turn + 1) % 3], corner[(turn + 2) % 3]);
        for (int signs = 0; signs < 8; ++signs) {
            const glm::dvec3 s(signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1);
            const glm::dvec3 signedCorner = glm::normalize(s * v);
            const bool known = std::any_of(out.begin(), out.end(), [&](const glm::dvec3& other) {
                return glm::distance(other, signedCorner) < 1e-9; // far below any edge
            });
            if (!known) {
                out.push_back(signedCorner);
            }
        }
    }
}

Directions divided(const std::array<glm::dvec3, 3>& triangle) {
    const auto middle = [&](int a, int b) {
        return glm::normalize(triangle[static_cast<std::size_t>(a)] + triangle[static_cast<std::size_t>(b)]);
    };
    const std::array<glm::dvec3, 3> middles{middle(0, 1), middle(1, 2), middle(2, 0)};
    return {
        glm::normalize(triangle[0] + middles[0] + middles[2]), glm::normalize(triangle[1] + middles[1] + middles[0]),
        glm::normalize(triangle[2] + middles[2] + middles[1]), glm::normalize(middles[0] + middles[1] + middles[2])};
}

Directions makeDirections() {
    constexpr double kGolden = std::numbers::phi;
    Directions dodecahedron;
    addCyclic({1, 1, 1}, dodecahedron);
    addCyclic({0, 1 / kGolden, kGolden}, dodecahedron);
    Directions icosahedron; // its vertices are the middles of the dodecahedron's faces
    addCyclic({0, kGolden, 1}, icosahedron);
    const double edge = std::sqrt(5.0) / 3;                        // cosine over an edge of the dodecahedron
    const double spoke = std::sqrt((5 + 2 * std::sqrt(5.0)) / 15); // from a face's middle to its corner
    const auto at = [](const glm::dvec3& a, const glm::dvec3& b, double cosine) {
        return std::abs(glm::dot(a, b) - cosine) < 1e-9;
    };
    Directions all;
    for (const glm::dvec3& top : icosahedron) {
        for (std::size_t i = 0; i < dodecahedron.size(); ++i) {
            for (std::size_t j = i + 1; j < dodecahedron.size(); ++j) {
                const glm::dvec3& a = dodecahedron[i];
                const glm::dvec3& b = dodecahedron[j];
                if (at(top, a, spoke) && at(top, b, spoke) && at(a, b, edge)) {
                    const Directions four = divided({top, a, b});
                    all.insert(all.end(), four.begin(), four.end());
                }
            }
        }
    }
    return all;
}

double angleDeg(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::degrees(2 * std::asin(std::min(1.0, glm::distance(a, b) / 2))); // exact where it is small, too
}

/// Point i of `count` that cover the sphere evenly: a spiral by the golden angle.
glm::dvec3 spiral(int i, int count) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double turn = 2 * std::numbers::pi * i / std::numbers::phi;
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

/// The corner of cells nearest to a point: what is as far from its three nearest directions as from each other.
glm::dvec3 cornerNear(const glm::dvec3& point) {
    Directions nearest = quantisedDirections();
    std::partial_sort(nearest.begin(), nearest.begin() + 3, nearest.end(),
                      [&](const auto& a, const auto& b) { return glm::dot(a, point) > glm::dot(b, point); });
    const glm::dvec3 corner = glm::normalize(glm::cross(nearest[1] - nearest[0], nearest[2] - nearest[0]));
    return glm::dot(corner, point) < 0 ? -corner : corner;
}

} // namespace

const std::vector<glm::dvec3>& quantisedDirections() {
    static const Directions directions = makeDirections();
    return directions;
}

glm::dvec3 quantisedNormal(const glm::dvec3& normal) {
    return *std::max_element(quantisedDirections().begin(), quantisedDirections().end(),
                             [&](const auto& a, const auto& b) { return glm::dot(a, normal) < glm::dot(b, normal); });
}

NormalQuantisationError measureNormalQuantisation(int samples) {
    NormalQuantisationError error;
    glm::dvec3 farthest(0, 0, 1);
    for (int i = 0; i < samples; ++i) {
        const glm::dvec3 normal = spiral(i, samples);
        const double own = angleDeg(normal, quantisedNormal(normal));
        error.meanDeg += own / samples;
        if (own > error.largestDeg) {
            error.largestDeg = own;
            farthest = normal;
        }
    }
    const glm::dvec3 corner = cornerNear(farthest);
    error.largestDeg = std::max(error.largestDeg, angleDeg(corner, quantisedNormal(corner)));
    return error;
}

LitSphereError measureLitSphereError(const LitSphere& style, int pixels) {
    LitSphereError error;
    int channels = 0;
    for (int y = 0; y < pixels; ++y) {
        for (int x = 0; x < pixels; ++x) {
            const glm::dvec2 place((2 * x + 1.0) / pixels - 1, 1 - (2 * y + 1.0) / pixels);
            if (glm::dot(place, place) >= 1) {
                continue;
            }
            const glm::dvec3 normal(place, std::sqrt(1 - glm::dot(place, place)));
            const glm::dvec3 kept = quantisedNormal(normal);
            const Rgba is = style.at(normal.x, normal.y);
            const Rgba was = style.at(kept.x, kept.y);
            for (const double d : {is.r - was.r, is.g - was.g, is.b - was.b}) {
                error.rms += d * d;
                error.largest = std::max(error.largest, std::abs(d));
                ++channels;
            }
        }
    }
    error.rms = channels > 0 ? std::sqrt(error.rms / channels) : 0;
    return error;
}

} // namespace limner::accuracy
