#include "core/style/extraction/texture_apart.h"

#include <glm/geometric.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr int kLeastSide = 24;          ///< pixels: less has no texture to speak of
constexpr double kFacing = 0.7;         ///< of the normal aside: foreshortened to 0.7 there at most
constexpr double kLeastLighting = 0.04; ///< darker, a quotient is noise
constexpr float kMostFactor = 2;        ///< what a tile can hold

/// The largest square of pixels that count and face the viewer.
cv::Rect facingSquare(const NormalField& normals, const Mask& looked) {
    cv::Mat inside = cv::Mat::zeros(normals.height + 2, normals.width + 2, CV_8U);
    for (int y = 0; y < normals.height; ++y) {
        for (int x = 0; x < normals.width; ++x) {
            const std::size_t i = looked.offset(x, y);
            const glm::vec2 n = normals.normals[i];
            const bool facing = std::isfinite(n.x) && glm::length(n) <= kFacing;
            inside.at<std::uint8_t>(y + 1, x + 1) = facing ? 255 : 0;
        }
    }
    cv::Mat distance;
    cv::distanceTransform(inside, distance, cv::DIST_C, 3);
    double reach = 0;
    cv::Point centre;
    cv::minMaxLoc(distance, nullptr, &reach, nullptr, &centre);
    const int half = static_cast<int>(reach) - 1;
    return half < 1 ? cv::Rect() : cv::Rect(centre.x - 1 - half, centre.y - 1 - half, 2 * half + 1, 2 * half + 1);
}

/// Factors of the lighting over the square; 1 where nothing can be said.
cv::Mat factorsOver(const cv::Rect& square, const ArtPicture& art, const ArtPicture& reshaded, const Mask& looked) {
    cv::Mat factors(square.height, square.width, CV_32FC3);
    const auto quotient = [](float seen, float lit) {
        return lit < kLeastLighting ? 1.0F : std::min(kMostFactor, seen / lit);
    };
    for (int y = 0; y < square.height; ++y) {
        for (int x = 0; x < square.width; ++x) {
            const int px = square.x + x;
            const int py = square.y + y;
            const Rgba& seen = art.at(px, py);
            const Rgba& lit = reshaded.at(px, py);
            const bool counts = looked.has(px, py) && lit.a > 0;
            factors.at<cv::Vec3f>(y, x) =
                counts ? cv::Vec3f(quotient(seen.r, lit.r), quotient(seen.g, lit.g), quotient(seen.b, lit.b))
                       : cv::Vec3f(1, 1, 1);
        }
    }
    return factors;
}

/// Differences from the mean mixed with themselves moved by half a tile along one axis, so that opposite edges meet
/// inside the picture. Weights whose squares add up to one keep the contrast, which a plain cross-fade would halve.
cv::Mat joined(const cv::Mat& differences, bool along) {
    const int side = differences.rows;
    cv::Mat result(side, side, CV_32FC3);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double toEdge = 1 - std::abs(2 * ((along ? x : y) + 0.5) / side - 1); // 1 in the middle
            const double own = std::clamp(4 * toEdge, 0.0, 1.0);
            const double other = 1 - own;
            const cv::Vec3f a = differences.at<cv::Vec3f>(y, x);
            const cv::Vec3f b = along ? differences.at<cv::Vec3f>(y, (x + side / 2) % side)
                                      : differences.at<cv::Vec3f>((y + side / 2) % side, x);
            result.at<cv::Vec3f>(y, x) = (a * own + b * other) / std::sqrt(own * own + other * other);
        }
    }
    return result;
}

cv::Mat seamless(const cv::Mat& factors) {
    const cv::Mat joinedUp = joined(joined(factors - cv::mean(factors), true), false);
    return joinedUp + cv::Scalar(1, 1, 1);
}

} // namespace

std::shared_ptr<const TextureTile> textureApart(const ArtPicture& art, const NormalField& normals,
                                                const ArtPicture& reshaded, const Mask& looked) {
    const cv::Rect square = facingSquare(normals, looked);
    if (square.width < kLeastSide) {
        return nullptr;
    }
    const cv::Mat tile = seamless(factorsOver(square, art, reshaded, looked));
    int side = 16;
    while (side < square.width && side < 512) {
        side *= 2;
    }
    cv::Mat resized;
    cv::resize(tile, resized, {side, side}, 0, 0, side > square.width ? cv::INTER_LINEAR : cv::INTER_AREA);
    std::vector<Rgba> pixels;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const cv::Vec3f f = resized.at<cv::Vec3f>(y, x);
            const auto factor = [](float value) { return std::clamp(value, 0.0F, kMostFactor); };
            pixels.push_back({factor(f[0]), factor(f[1]), factor(f[2]), 1});
        }
    }
    return std::make_shared<const TextureTile>(side, std::move(pixels));
}

} // namespace limner
