#include "core/base/error.h"
#include "core/base/task.h"
#include "core/style/extraction/extract.h"
#include "core/style/extraction/rim.h"

#include <glm/geometric.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace limner {
namespace {

namespace fs = std::filesystem;

/// Of the sphere's picture.
constexpr int kLargest = 1024;
/// A disk of fewer pixels across holds no shading to speak of.
constexpr double kSmallest = 16;
/// Longer side of what the disk is looked for in.
constexpr int kSide = 512;

constexpr const char* kWhat = "cannot import the matcap";

/// On the artwork.
struct Disk {
    glm::dvec2 centre{0, 0};
    double radius = 0;
};

Disk inscribed(const Artwork& artwork) {
    return {glm::dvec2(artwork.width(), artwork.height()) * 0.5, std::min(artwork.width(), artwork.height()) * 0.5};
}

/// The tone that nearly all of the border has; absent where the ground is no plain one.
std::optional<glm::vec4> plainGround(const Tones& tones) {
    std::vector<glm::vec4> border;
    for (int x = 0; x < tones.width; ++x) {
        border.push_back(tones.at(x, 0));
        border.push_back(tones.at(x, tones.height - 1));
    }
    for (int y = 0; y < tones.height; ++y) {
        border.push_back(tones.at(0, y));
        border.push_back(tones.at(tones.width - 1, y));
    }
    glm::vec4 middle(0);
    for (int c = 0; c < 4; ++c) {
        std::vector<float> values;
        for (const glm::vec4& tone : border) {
            values.push_back(tone[c]);
        }
        std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
        middle[c] = values[values.size() / 2];
    }
    constexpr float kPlain = 0.05F;
    // A ball that touches the border, or is cut off by it, leaves most of it.
    constexpr double kMost = 0.7;
    const auto like = std::count_if(border.begin(), border.end(),
                                    [&](const glm::vec4& tone) { return glm::length(tone - middle) < kPlain; });
    return static_cast<double>(like) > kMost * static_cast<double>(border.size()) ? std::optional(middle)
                                                                                  : std::nullopt;
}

/// The circle of what differs from the ground, in pixels of the tones; absent where that is not round.
std::optional<Oval> roundPatch(const Tones& tones, const glm::vec4& ground) {
    constexpr float kDiffers = 0.06F;
    cv::Mat differs(tones.height, tones.width, CV_8U);
    for (int y = 0; y < tones.height; ++y) {
        for (int x = 0; x < tones.width; ++x) {
            differs.at<std::uint8_t>(y, x) = glm::length(tones.at(x, y) - ground) > kDiffers ? 255 : 0;
        }
    }
    cv::morphologyEx(differs, differs, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(differs, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    const auto largest = std::max_element(outlines.begin(), outlines.end(), [](const auto& a, const auto& b) {
        return cv::contourArea(a) < cv::contourArea(b);
    });
    if (largest == outlines.end() || largest->size() < 12) {
        return std::nullopt;
    }
    cv::Point2f centre;
    float radius = 0;
    cv::minEnclosingCircle(*largest, centre, radius);
    // Where a part of the ball has the ground's tone, its hull still has most of the circle.
    std::vector<cv::Point> hull;
    cv::convexHull(*largest, hull);
    constexpr double kRound = 0.88;
    if (cv::contourArea(hull) < kRound * CV_PI * radius * radius) {
        return std::nullopt;
    }
    Oval oval;
    oval.centre = {centre.x + 0.5, centre.y + 0.5};
    oval.xx = oval.yy = radius + 0.5;
    return oval;
}

/// The disk that differs from a plain ground with a sharp edge almost all around.
std::optional<Disk> clearDisk(const Tones& tones) {
    const auto ground = plainGround(tones);
    const auto patch = ground ? roundPatch(tones, *ground) : std::nullopt;
    if (!patch) {
        return std::nullopt;
    }
    RimSearch search;
    search.reaches = {0.1, 0.05, 0.03};
    search.circle = true;
    const auto rim = followRim(tones, *patch, search);
    constexpr double kSupport = 0.7;
    constexpr double kWobble = 0.02;
    if (!rim || rim->support < kSupport || rim->wobble > kWobble) {
        return std::nullopt;
    }
    return Disk{tones.origin + rim->oval.centre * tones.scale, rim->oval.radius() * tones.scale};
}

Disk diskOf(const Artwork& artwork) {
    const Disk filling = inscribed(artwork);
    const Tones tones = tonesOf(artwork.reduced(), {0, 0}, {artwork.width(), artwork.height()}, kSide);
    auto found = clearDisk(tones);
    if (!found) {
        return filling;
    }
    // What nearly fills the square is meant to.
    constexpr double kNearly = 0.03;
    const glm::dvec2 apart = found->centre - filling.centre;
    if (artwork.width() == artwork.height() && std::hypot(apart.x, apart.y) < kNearly * filling.radius &&
        std::abs(found->radius - filling.radius) < kNearly * filling.radius) {
        return filling;
    }
    found->radius -= 0.5; // the pixels along the edge are half ground
    return *found;
}

/// The square around the disk, averaged over areas or read between pixels: exact where the disk lies on whole pixels.
std::vector<Rgba> pixelsOf(const Artwork& artwork, const Disk& disk, int size, Task& task) {
    const glm::dvec2 corner = disk.centre - glm::dvec2(disk.radius);
    const double side = 2 * disk.radius;
    const auto x = static_cast<int>(std::floor(corner.x + 1e-6));
    const auto y = static_cast<int>(std::floor(corner.y + 1e-6));
    const auto reach = [&](double from, int whole) { return static_cast<int>(std::ceil(from + side - 1e-6)) - whole; };
    const ArtRect rect{x, y, reach(corner.x, x), reach(corner.y, y)};
    const double step = side / size; // artwork pixels
    const ArtCut cut = artwork.cut(rect, static_cast<int>(std::lround(std::max(rect.width, rect.height) / step)), task);
    const ArtPicture& picture = cut.picture;
    if (picture.width == size && picture.height == size) {
        return picture.pixels;
    }
    const auto texel = [&](int column, int row) -> const Rgba& {
        return picture.at(std::clamp(column, 0, picture.width - 1), std::clamp(row, 0, picture.height - 1));
    };
    std::vector<Rgba> pixels;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const glm::dvec2 at = cut.toCut(corner + (glm::dvec2(column, row) + 0.5) * step) - 0.5;
            const auto left = static_cast<int>(std::floor(at.x));
            const auto top = static_cast<int>(std::floor(at.y));
            Rgba sum{0, 0, 0, 0};
            for (int k = 0; k < 4; ++k) {
                const Rgba& p = texel(left + k % 2, top + k / 2);
                const double across = k % 2 == 0 ? left + 1 - at.x : at.x - left;
                const double down = k / 2 == 0 ? top + 1 - at.y : at.y - top;
                const auto share = static_cast<float>(across * down) * p.a;
                sum = {sum.r + share * p.r, sum.g + share * p.g, sum.b + share * p.b, sum.a + share};
            }
            const float scale = sum.a > 0 ? 1 / sum.a : 0;
            pixels.push_back({std::min(1.0F, sum.r * scale), std::min(1.0F, sum.g * scale),
                              std::min(1.0F, sum.b * scale), std::min(1.0F, sum.a)});
        }
    }
    return pixels;
}

} // namespace

SpherePtr importMatcap(const fs::path& file, Task& task) {
    const auto fail = [&](const std::string& why, const std::string& remedy) {
        throw Error(ErrorKind::badInput, {kWhat, file.string(), why, remedy});
    };
    const Artwork artwork(file, task);
    const auto& shown = artwork.reduced().picture.pixels;
    if (std::all_of(shown.begin(), shown.end(), [](const Rgba& p) { return p.a < 0.02F; })) {
        fail("all of it is clear", "use a picture of a shaded ball");
    }
    const Disk disk = diskOf(artwork);
    if (2 * disk.radius < kSmallest) {
        fail("its ball is less than " + std::to_string(static_cast<int>(kSmallest)) + " pixels across",
             "use a larger picture, 512 pixels are plenty");
    }
    const int size = std::clamp(static_cast<int>(std::lround(2 * disk.radius)), 1, kLargest);
    return std::make_shared<const LitSphere>(size, pixelsOf(artwork, disk, size, task));
}

} // namespace limner
