#include "widgets/style_pictures.h"

#include "renderer/backend.h"
#include "renderer/export/picture_file.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limner {
namespace {

constexpr int kReachPixels = 384; ///< longer side: a line of a pixel is seen as two or three on the sheet

/// As cheap as it still shows what matters, with the volume that is cleaned up already where it is the same.
Figure plain(const RenderPlan& shown, const Figure& figure) {
    Figure result = figure;
    const Figure& drawn = *shown.figure;
    if (drawn.volume && figure.volume && drawn.volume->data == figure.volume->data && drawn.cleanup == figure.cleanup) {
        result.volume->data = shown.volume;
        result.cleanup.clear();
    }
    result.annotations.clear(); // nobody reads them at this size
    result.quality.gradient = GradientEstimator::central;
    result.quality.interpolation = Interpolation::linear;
    result.quality.precision = VoxelPrecision::full;
    result.quality.samplesPerPixel = 1;
    return result;
}

glm::ivec2 sizeOf(const Figure& figure, int edgePixels) {
    const double longer = std::max(figure.output.widthMm, figure.output.heightMm);
    const auto side = [&](double mm) { return std::max(1, static_cast<int>(std::lround(edgePixels * mm / longer))); };
    return {side(figure.output.widthMm), side(figure.output.heightMm)};
}

Picture render(Planner& planner, const Figure& figure, const PlanRequest& request, Task& task) {
    const auto plan = planner.plan(figure, request, task);
    return makeCpuBackend()->render(*plan, {{0, 0}, request.size}, task).picture;
}

/// Share of a map's pixels that is meant, times how much of them is not paper; 0..1.
std::vector<float> sharesOf(const Picture& map) {
    std::vector<float> shares;
    shares.reserve(map.rgba().size() / 4);
    for (std::size_t i = 0; i < map.rgba().size(); i += 4) {
        const float red = map.rgba()[i];
        const float both = red + map.rgba()[i + 1];
        shares.push_back(both > 0 ? std::clamp(red / both * map.rgba()[i + 3], 0.0F, 1.0F) : 0.0F);
    }
    return shares;
}

/// One pass of a running mean over a row or column of `count` numbers that lie `stride` apart.
void blurLine(std::vector<float>& values, std::size_t first, std::size_t stride, int count) {
    constexpr int kReach = 2;
    std::vector<float> sums(static_cast<std::size_t>(count) + 1, 0.0F);
    const auto at = [&](int i) -> float& { return values[first + static_cast<std::size_t>(i) * stride]; };
    for (int i = 0; i < count; ++i)
        sums[static_cast<std::size_t>(i) + 1] = sums[static_cast<std::size_t>(i)] + at(i);
    for (int i = 0; i < count; ++i) {
        const int low = std::max(0, i - kReach);
        const int high = std::min(count, i + kReach + 1);
        at(i) = (sums[static_cast<std::size_t>(high)] - sums[static_cast<std::size_t>(low)]) /
                static_cast<float>(high - low);
    }
}

/// Where two nodes share a surface the shares hover about one half: a line around them would follow the noise.
void smooth(std::vector<float>& shares, glm::ivec2 size) {
    constexpr int kPasses = 3; // of running means: nearly a bell of 2.4 pixels
    const auto width = static_cast<std::size_t>(size.x);
    for (int pass = 0; pass < kPasses; ++pass) {
        for (int y = 0; y < size.y; ++y)
            blurLine(shares, static_cast<std::size_t>(y) * width, 1, size.x);
        for (int x = 0; x < size.x; ++x)
            blurLine(shares, static_cast<std::size_t>(x), width, size.y);
    }
}

} // namespace

QImage StylePictures::figure(const RenderPlan& shown, const Figure& changed, int edgePixels, Task& task) {
    const Figure figure = plain(shown, changed);
    PlanRequest request;
    request.size = sizeOf(figure, edgePixels);
    request.subPixels = 2;
    // As a file of it would be: with its paper and its ink.
    const auto png = renderPng(*figures_.plan(figure, request, task), *makeCpuBackend(), pictureOptions(figure), task);
    return QImage::fromData(reinterpret_cast<const uchar*>(png.data()), static_cast<int>(png.size()), "PNG");
}

QImage StylePictures::reach(const RenderPlan& shown, const StyleTarget& target, const QColor& colour, Task& task) {
    constexpr float kVeil = 0.4F; // what lies under it is still seen
    Figure figure = targetMap(plain(shown, *shown.figure), target.layer, target.node);
    PlanRequest request;
    request.size = sizeOf(figure, kReachPixels);
    request.subPixels = 1;
    const Picture map = render(reaches_, figure, request, task);
    std::vector<float> shares = sharesOf(map);
    const glm::ivec2 size = map.size();
    smooth(shares, size);
    const auto inside = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < size.x && y < size.y &&
               shares[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)] >
                   0.5F;
    };
    QImage image(size.x, size.y, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < size.y; ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < size.x; ++x) {
            const bool edge =
                inside(x, y) && !(inside(x - 1, y) && inside(x + 1, y) && inside(x, y - 1) && inside(x, y + 1));
            const float share =
                shares[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)];
            QColor pixel = colour;
            pixel.setAlphaF(edge ? 1.0F : share * kVeil);
            row[x] = qPremultiply(pixel.rgba());
        }
    }
    return image;
}

} // namespace limner
