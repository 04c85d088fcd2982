#include "core/style/extraction/sphere_edits.h"

#include <glm/geometric.hpp>
#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

double luminance(const Rgba& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

double linear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double encode(double value) { return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055; }

/// A sphere of the same size: each texel by its normal (n_y up, beyond the unit disk outside of it).
template <typename Texel>
SpherePtr mapped(int size, Texel texel) {
    std::vector<Rgba> pixels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    tbb::parallel_for(0, size, [&](int y) {
        for (int x = 0; x < size; ++x) {
            const glm::dvec2 normal((2.0 * x + 1) / size - 1, 1 - (2.0 * y + 1) / size);
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
            pixels[i] = texel(i, normal);
        }
    });
    return std::make_shared<const LitSphere>(size, std::move(pixels));
}

/// He, Sun, Tang 2013, a picture guided by itself: means of `radius` where it is flatter than `edge`, itself elsewhere.
cv::Mat guided(const cv::Mat& picture, int radius, double edge) {
    const cv::Size box(2 * radius + 1, 2 * radius + 1);
    const auto mean = [&](const cv::Mat& m) {
        cv::Mat result;
        cv::boxFilter(m, result, -1, box, {-1, -1}, true, cv::BORDER_REPLICATE);
        return result;
    };
    const cv::Mat m = mean(picture);
    const cv::Mat variance = mean(picture.mul(picture)) - m.mul(m);
    cv::Mat slope;
    cv::divide(variance, variance + edge * edge, slope);
    const cv::Mat offset = m - slope.mul(m);
    return mean(slope).mul(picture) + mean(offset);
}

double alphaAt(const AlphaCurve& curve, double radius) {
    const auto next = std::find_if(curve.begin(), curve.end(), [&](glm::dvec2 p) { return p.x > radius; });
    if (next == curve.begin()) {
        return next->y;
    }
    const glm::dvec2 before = *(next - 1);
    if (next == curve.end()) {
        return before.y;
    }
    return before.y + (next->y - before.y) * (radius - before.x) / (next->x - before.x);
}

} // namespace

SpherePtr withSmoothing(const SpherePtr& sphere, double amount) {
    const double strength = std::clamp(amount, 0.0, 1.0);
    // A twentieth of the disk at most; steps of a third stay edges even then.
    const int radius = static_cast<int>(std::lround(strength * 0.05 * sphere->size()));
    if (radius < 1) {
        return sphere;
    }
    const double edge = 0.02 + 0.1 * strength;
    std::vector<cv::Mat> channels;
    constexpr float Rgba::*kChannels[] = {&Rgba::r, &Rgba::g, &Rgba::b};
    for (float Rgba::*const channel : kChannels) {
        cv::Mat plane(sphere->size(), sphere->size(), CV_64F);
        for (std::size_t i = 0; i < sphere->pixels().size(); ++i) {
            plane.ptr<double>()[i] = sphere->pixels()[i].*channel;
        }
        channels.push_back(guided(plane, radius, edge));
    }
    return mapped(sphere->size(), [&](std::size_t i, glm::dvec2 /*normal*/) {
        const auto value = [&](std::size_t c) {
            return static_cast<float>(std::clamp(channels[c].ptr<double>()[i], 0.0, 1.0));
        };
        return Rgba{value(0), value(1), value(2), sphere->pixels()[i].a};
    });
}

SpherePtr withLightTurned(const SpherePtr& sphere, double degrees) {
    if (std::remainder(degrees, 360) == 0) {
        return sphere;
    }
    const double c = std::cos(degrees * kDegree);
    const double s = std::sin(degrees * kDegree);
    return mapped(sphere->size(),
                  [&](std::size_t /*i*/, glm::dvec2 n) { return sphere->at(c * n.x + s * n.y, -s * n.x + c * n.y); });
}

double lightDirection(const LitSphere& sphere) {
    glm::dvec2 sum(0, 0);
    double weight = 0;
    const int size = sphere.size();
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::dvec2 n((2.0 * x + 1) / size - 1, 1 - (2.0 * y + 1) / size);
            if (glm::dot(n, n) <= 1) {
                sum += n * luminance(sphere.pixels()[static_cast<std::size_t>(y * size + x)]);
                weight += glm::dot(n, n) / 2;
            }
        }
    }
    // A hundredth of the range across the disk is no direction.
    const bool fromAside = weight > 0 && glm::length(sum) / weight > 0.01;
    return fromAside ? std::atan2(sum.y, sum.x) / kDegree : 90;
}

SpherePtr withSymmetry(const SpherePtr& sphere) {
    const double angle = lightDirection(*sphere) * kDegree;
    const glm::dvec2 axis(std::cos(angle), std::sin(angle));
    return mapped(sphere->size(), [&](std::size_t i, glm::dvec2 n) {
        const glm::dvec2 mirrored = axis * (2 * glm::dot(n, axis)) - n;
        const Rgba& a = sphere->pixels()[i];
        const Rgba b = sphere->at(mirrored.x, mirrored.y);
        return Rgba{(a.r + b.r) / 2, (a.g + b.g) / 2, (a.b + b.b) / 2, (a.a + b.a) / 2};
    });
}

SpherePtr withoutPaperCast(const SpherePtr& sphere, const Rgba& paper) {
    return mapped(sphere->size(),
                  [&](std::size_t i, glm::dvec2 /*normal*/) { return withoutCast(sphere->pixels()[i], paper); });
}

Rgba withoutCast(const Rgba& colour, const Rgba& paper) {
    // Darker than this is no paper, and a division by next to nothing no mending.
    constexpr double kDarkest = 0.05;
    const auto channel = [&](float value, float white) {
        return static_cast<float>(encode(std::min(1.0, linear(value) / std::max(kDarkest, linear(white)))));
    };
    return {channel(colour.r, paper.r), channel(colour.g, paper.g), channel(colour.b, paper.b), colour.a};
}

SpherePtr withAlpha(const SpherePtr& sphere, const AlphaCurve& curve) {
    if (curve.empty()) {
        return sphere;
    }
    return mapped(sphere->size(), [&](std::size_t i, glm::dvec2 n) {
        Rgba texel = sphere->pixels()[i];
        texel.a = static_cast<float>(std::clamp(alphaAt(curve, std::min(1.0, glm::length(n))), 0.0, 1.0));
        return texel;
    });
}

SpherePtr edited(SpherePtr sphere, const SphereEdits& edits) {
    sphere = withSmoothing(sphere, edits.smoothing);
    if (edits.symmetric) {
        sphere = withSymmetry(sphere);
    }
    return withAlpha(withLightTurned(sphere, edits.turnDegrees), edits.alpha);
}

} // namespace limner
