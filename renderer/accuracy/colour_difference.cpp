#include "renderer/accuracy/colour_difference.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limner::accuracy {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// XYZ of linear red, green and blue; a column each.
const glm::dmat3 kXyz{
    {0.4124564, 0.2126729, 0.0193339}, {0.3575761, 0.7151522, 0.1191920}, {0.1804375, 0.0721750, 0.9503041}};

double linear(double encoded) {
    const double size = std::abs(encoded);
    return std::copysign(size <= 0.04045 ? size / 12.92 : std::pow((size + 0.055) / 1.055, 2.4), encoded);
}

double lightnessCurve(double t) {
    constexpr double knee = 216.0 / 24389;
    return t > knee ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
}

/// Hue angle in degrees, [0, 360); 0 of a grey.
double hue(double a, double b) {
    if (a == 0 && b == 0) {
        return 0;
    }
    const double angle = std::atan2(b, a) / kDegree;
    return angle < 0 ? angle + 360 : angle;
}

double seventh(double x) { return x * x * x * x * x * x * x; }

/// How much of a chroma of this size counts as vivid, in [0, 1].
double vividness(double chroma) { return std::sqrt(seventh(chroma) / (seventh(chroma) + seventh(25))); }

struct Hues {
    double difference = 0; ///< degrees, in [-180, 180]
    double mean = 0;       ///< degrees
};

/// A grey has no hue: then there is no difference, and the mean is the other's.
Hues compareHues(double h1, double h2, bool grey) {
    if (grey) {
        return {0, h1 + h2};
    }
    double difference = h2 - h1;
    double mean = (h1 + h2) / 2;
    if (std::abs(h1 - h2) > 180) {
        difference += difference > 0 ? -360 : 360;
        mean += h1 + h2 < 360 ? 180 : -180;
    }
    return {difference, mean};
}

} // namespace

glm::dvec3 xyzOfSrgb(const glm::dvec3& rgb) { return kXyz * glm::dvec3(linear(rgb.r), linear(rgb.g), linear(rgb.b)); }

glm::dvec3 labOfXyz(const glm::dvec3& xyz) {
    const glm::dvec3 white = kXyz * glm::dvec3(1); // so that white is exactly L* = 100
    const glm::dvec3 f(lightnessCurve(xyz.x / white.x), lightnessCurve(xyz.y / white.y),
                       lightnessCurve(xyz.z / white.z));
    return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

glm::dvec3 labOfSrgb(const glm::dvec3& rgb) { return labOfXyz(xyzOfSrgb(rgb)); }

double ciede2000(const glm::dvec3& first, const glm::dvec3& second) {
    const double stretch = 0.5 * (1 - vividness((std::hypot(first.y, first.z) + std::hypot(second.y, second.z)) / 2));
    const double a1 = first.y * (1 + stretch);
    const double a2 = second.y * (1 + stretch);
    const double c1 = std::hypot(a1, first.z);
    const double c2 = std::hypot(a2, second.z);
    const Hues hues = compareHues(hue(a1, first.z), hue(a2, second.z), c1 * c2 == 0);
    const double lightness = (first.x + second.x) / 2 - 50;
    const double chroma = (c1 + c2) / 2;
    const double t = 1 - 0.17 * std::cos((hues.mean - 30) * kDegree) + 0.24 * std::cos(2 * hues.mean * kDegree) +
                     0.32 * std::cos((3 * hues.mean + 6) * kDegree) - 0.20 * std::cos((4 * hues.mean - 63) * kDegree);
    const double blue = (hues.mean - 275) / 25;
    const double turn = 30 * std::exp(-blue * blue) * kDegree;
    const double sl = 1 + 0.015 * lightness * lightness / std::sqrt(20 + lightness * lightness);
    const double sc = 1 + 0.045 * chroma;
    const double sh = 1 + 0.015 * chroma * t;
    const double dl = (second.x - first.x) / sl;
    const double dc = (c2 - c1) / sc;
    const double dh = 2 * std::sqrt(c1 * c2) * std::sin(hues.difference / 2 * kDegree) / sh;
    const double rotation = -2 * vividness(chroma) * std::sin(2 * turn);
    return std::sqrt(std::max(0.0, dl * dl + dc * dc + dh * dh + rotation * dc * dh));
}

} // namespace limner::accuracy
