#pragma once

#include "core/style/extraction/forms.h"
#include "core/style/extraction/picture.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace limner::testing {

/// The colour of a ball by its normal (n_y up) or of a ground by its place.
using BallShade = std::function<glm::dvec3(glm::dvec2 normal)>;

/// Lambert's law and a highlight.
struct LitBall {
    glm::dvec3 light{-0.4, 0.5, 0.8};
    glm::dvec3 bright{0.9, 0.75, 0.6};
    glm::dvec3 dark{0.25, 0.15, 0.12};
    double highlight = 0;

    glm::dvec3 operator()(glm::dvec2 n) const {
        const glm::dvec3 normal(n, std::sqrt(std::max(0.0, 1 - glm::dot(n, n))));
        const glm::dvec3 to = glm::normalize(light);
        const glm::dvec3 half = glm::normalize(to + glm::dvec3(0, 0, 1));
        return dark + (bright - dark) * std::max(0.0, glm::dot(normal, to)) +
               highlight * std::pow(std::max(0.0, glm::dot(normal, half)), 30);
    }
};

inline ArtPicture plainPicture(int width, int height, Rgba colour) {
    ArtPicture picture{width, height, {}};
    picture.pixels.assign(picture.offset(0, height), colour);
    return picture;
}

/// Where a place of the picture is on the ellipse's disk, y up.
inline glm::dvec2 onDisk(const Ellipse& ellipse, glm::dvec2 place) {
    const double angle = ellipse.degrees * 3.14159265358979323846 / 180;
    const glm::dvec2 from = place - ellipse.centre;
    // The affine map that keeps "up" up: turned onto the axes, stretched, turned back.
    const glm::dvec2 turned(std::cos(angle) * from.x + std::sin(angle) * from.y,
                            -std::sin(angle) * from.x + std::cos(angle) * from.y);
    const glm::dvec2 unit = turned / ellipse.semiAxes;
    return {std::cos(angle) * unit.x - std::sin(angle) * unit.y,
            -(std::sin(angle) * unit.x + std::cos(angle) * unit.y)};
}

/// A ball over what is there, its edge smoothed over pixels.
inline void drawBall(ArtPicture& picture, const Ellipse& ellipse, const BallShade& shade) {
    constexpr int kPoints = 4;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            glm::dvec3 sum(0);
            int inside = 0;
            for (int k = 0; k < kPoints * kPoints; ++k) {
                const glm::dvec2 place(x + (k % kPoints + 0.5) / kPoints, y + (k / kPoints + 0.5) / kPoints);
                const glm::dvec2 n = onDisk(ellipse, place);
                if (glm::dot(n, n) <= 1) {
                    sum += glm::clamp(shade(n), 0.0, 1.0);
                    ++inside;
                }
            }
            Rgba& p = picture.at(x, y);
            const double share = inside / static_cast<double>(kPoints * kPoints);
            const glm::dvec3 under(p.r, p.g, p.b);
            const glm::dvec3 colour = under * (1 - share) + sum / static_cast<double>(kPoints * kPoints);
            p = {static_cast<float>(colour.x), static_cast<float>(colour.y), static_cast<float>(colour.z),
                 std::max(p.a, static_cast<float>(share))};
        }
    }
}

inline void addNoise(ArtPicture& picture, double deviation, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, deviation);
    for (Rgba& p : picture.pixels) {
        for (float* channel : {&p.r, &p.g, &p.b}) {
            *channel = static_cast<float>(std::clamp(*channel + noise(random), 0.0, 1.0));
        }
    }
}

/// A stroke with round ends and soft edges.
inline void drawStroke(ArtPicture& picture, glm::dvec2 from, glm::dvec2 to, double width, const Rgba& ink) {
    const glm::dvec2 whole = to - from;
    const glm::dvec2 low = glm::min(from, to) - width;
    const glm::dvec2 high = glm::max(from, to) + width;
    for (int y = std::max(0, static_cast<int>(low.y)); y < std::min<double>(picture.height, high.y); ++y) {
        for (int x = std::max(0, static_cast<int>(low.x)); x < std::min<double>(picture.width, high.x); ++x) {
            const glm::dvec2 place(x + 0.5, y + 0.5);
            const double share =
                std::clamp(glm::dot(place - from, whole) / std::max(1e-9, glm::dot(whole, whole)), 0.0, 1.0);
            const double away = glm::distance(place, from + whole * share);
            const auto cover = static_cast<float>(std::clamp(width / 2 - away + 0.5, 0.0, 1.0));
            Rgba& p = picture.at(x, y);
            p = {p.r + (ink.r - p.r) * cover, p.g + (ink.g - p.g) * cover, p.b + (ink.b - p.b) * cover, p.a};
        }
    }
}

/// Letters of straight strokes: A E F H I K L M N T V X Z. `height` of the letters; written towards `along` (length 1).
inline void drawText(ArtPicture& picture, const std::string& text, glm::dvec2 start, double height, glm::dvec2 along,
                     const Rgba& ink) {
    using Strokes = std::vector<std::pair<glm::dvec2, glm::dvec2>>; // x to the right, y up, in heights
    const auto strokesOf = [](char letter) -> Strokes {
        constexpr double w = 0.6;
        switch (letter) {
        case 'A': return {{{0, 0}, {w / 2, 1}}, {{w / 2, 1}, {w, 0}}, {{w / 4, 0.4}, {3 * w / 4, 0.4}}};
        case 'E': return {{{0, 0}, {0, 1}}, {{0, 0}, {w, 0}}, {{0, 0.5}, {0.8 * w, 0.5}}, {{0, 1}, {w, 1}}};
        case 'F': return {{{0, 0}, {0, 1}}, {{0, 0.5}, {0.8 * w, 0.5}}, {{0, 1}, {w, 1}}};
        case 'H': return {{{0, 0}, {0, 1}}, {{w, 0}, {w, 1}}, {{0, 0.5}, {w, 0.5}}};
        case 'I': return {{{w / 2, 0}, {w / 2, 1}}};
        case 'K': return {{{0, 0}, {0, 1}}, {{0, 0.45}, {w, 1}}, {{0.15, 0.55}, {w, 0}}};
        case 'L': return {{{0, 0}, {0, 1}}, {{0, 0}, {w, 0}}};
        case 'M': return {{{0, 0}, {0, 1}}, {{0, 1}, {w / 2, 0.4}}, {{w / 2, 0.4}, {w, 1}}, {{w, 1}, {w, 0}}};
        case 'N': return {{{0, 0}, {0, 1}}, {{0, 1}, {w, 0}}, {{w, 0}, {w, 1}}};
        case 'T': return {{{w / 2, 0}, {w / 2, 1}}, {{0, 1}, {w, 1}}};
        case 'V': return {{{0, 1}, {w / 2, 0}}, {{w / 2, 0}, {w, 1}}};
        case 'X': return {{{0, 0}, {w, 1}}, {{0, 1}, {w, 0}}};
        case 'Z': return {{{0, 1}, {w, 1}}, {{w, 1}, {0, 0}}, {{0, 0}, {w, 0}}};
        default: return {};
        }
    };
    const glm::dvec2 up(along.y, -along.x);
    double at = 0;
    for (const char letter : text) {
        for (const auto& [from, to] : strokesOf(letter)) {
            const auto place = [&](glm::dvec2 p) { return start + (along * (at + p.x) + up * p.y) * height; };
            drawStroke(picture, place(from), place(to), 0.17 * height, ink);
        }
        at += 0.9;
    }
}

} // namespace limner::testing
