#include "core/style/extraction/sphere_edits.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

/// Where on the way from the light the picked colours stand: cosines of the angle between normal and light.
constexpr double kShadowAt = -0.3;
constexpr double kMidAt = 0.45;

double mix(double a, double b, double share) { return a + (b - a) * share; }

Rgba mix(const Rgba& a, const Rgba& b, double share) {
    return {static_cast<float>(mix(a.r, b.r, share)), static_cast<float>(mix(a.g, b.g, share)),
            static_cast<float>(mix(a.b, b.b, share)), static_cast<float>(mix(a.a, b.a, share))};
}

/// A smooth way through three values that turns nowhere in between (Fritsch and Carlson 1980), level at both ends.
double through(double shadow, double mid, double light, double cosine) {
    const double before = (mid - shadow) / (kMidAt - kShadowAt);
    const double after = (light - mid) / (1 - kMidAt);
    const double slope = before * after > 0 ? 2 * before * after / (before + after) : 0;
    const bool dark = cosine < kMidAt;
    const double from = dark ? kShadowAt : kMidAt;
    const double width = dark ? kMidAt - kShadowAt : 1 - kMidAt;
    const double t = std::clamp((cosine - from) / width, 0.0, 1.0);
    const double a = dark ? shadow : mid;
    const double b = dark ? mid : light;
    const double slopeA = dark ? 0 : slope * width;
    const double slopeB = dark ? slope * width : 0;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return a * (2 * t3 - 3 * t2 + 1) + slopeA * (t3 - 2 * t2 + t) + b * (3 * t2 - 2 * t3) + slopeB * (t3 - t2);
}

float unit(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }

} // namespace

SpherePtr sphereOfSwatches(const Swatches& swatches, int size) {
    const Rgba mid = swatches.mid.value_or(mix(swatches.shadow, swatches.light, 0.5));
    const double aside = std::min(1.0, glm::length(swatches.towardsLight));
    const glm::dvec3 light(swatches.towardsLight, std::sqrt(1 - aside * aside));
    const glm::dvec3 lamp = glm::normalize(light);
    const glm::dvec3 gleam = glm::normalize(lamp + glm::dvec3(0, 0, 1));
    constexpr double kGleamExponent = 60; // a moist surface
    constexpr double kRimExponent = 4;    // a border of about a tenth of the disk
    std::vector<Rgba> pixels;
    pixels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            glm::dvec2 n((2.0 * x + 1) / size - 1, 1 - (2.0 * y + 1) / size);
            n /= std::max(1.0, glm::length(n));
            const glm::dvec3 normal(n, std::sqrt(std::max(0.0, 1 - glm::dot(n, n))));
            const double cosine = glm::dot(normal, lamp);
            const auto channel = [&](float shadow, float middle, float bright) {
                return unit(through(shadow, middle, bright, cosine));
            };
            Rgba colour{channel(swatches.shadow.r, mid.r, swatches.light.r),
                        channel(swatches.shadow.g, mid.g, swatches.light.g),
                        channel(swatches.shadow.b, mid.b, swatches.light.b), 1};
            if (swatches.rim) {
                colour = mix(colour, *swatches.rim, std::pow(1 - normal.z, kRimExponent));
            }
            if (swatches.highlight) {
                colour =
                    mix(colour, *swatches.highlight, std::pow(std::max(0.0, glm::dot(normal, gleam)), kGleamExponent));
            }
            pixels.push_back(colour);
        }
    }
    return std::make_shared<const LitSphere>(size, std::move(pixels));
}

} // namespace limner
