#include "core/style/extraction/tones.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr double kDegrees = 3.14159265358979323846 / 180;
/// A chroma counts less than lightness: noise and JPEG blocks are mostly in it.
constexpr float kLightness = 1 / 100.0F;
constexpr float kChroma = 1 / 150.0F;

} // namespace

glm::vec4 Tones::between(glm::dvec2 place) const {
    const double x = std::clamp(place.x - 0.5, 0.0, width - 1.0);
    const double y = std::clamp(place.y - 0.5, 0.0, height - 1.0);
    const int x0 = static_cast<int>(x);
    const int y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, width - 1);
    const int y1 = std::min(y0 + 1, height - 1);
    const auto across = static_cast<float>(x - x0);
    const auto down = static_cast<float>(y - y0);
    const glm::vec4 top = at(x0, y0) + (at(x1, y0) - at(x0, y0)) * across;
    const glm::vec4 bottom = at(x0, y1) + (at(x1, y1) - at(x0, y1)) * across;
    return top + (bottom - top) * down;
}

Tones tonesOf(const ArtCut& cut, glm::dvec2 low, glm::dvec2 high, int longest) {
    const ArtPicture& picture = cut.picture;
    const auto pixel = [](double place, int most) {
        return static_cast<int>(std::clamp(std::isfinite(place) ? place : 0.0, 0.0, static_cast<double>(most)));
    };
    const glm::dvec2 from = cut.toCut(low);
    const glm::dvec2 to = cut.toCut(high);
    const cv::Rect box(cv::Point(pixel(std::floor(from.x), picture.width), pixel(std::floor(from.y), picture.height)),
                       cv::Point(pixel(std::ceil(to.x), picture.width), pixel(std::ceil(to.y), picture.height)));
    Tones tones;
    if (box.width <= 0 || box.height <= 0 || picture.empty()) {
        return tones;
    }
    // OpenCV has no constant matrices; it is only read.
    const cv::Mat whole(picture.height, picture.width, CV_32FC4, const_cast<Rgba*>(picture.pixels.data()));
    const double scale = std::max(1.0, std::max(box.width, box.height) / static_cast<double>(std::max(1, longest)));
    cv::Mat rgba = whole(box).clone();
    for (int y = 0; y < rgba.rows; ++y) {
        auto* row = rgba.ptr<cv::Vec4f>(y);
        for (int x = 0; x < rgba.cols; ++x) {
            row[x] = {row[x][0] * row[x][3], row[x][1] * row[x][3], row[x][2] * row[x][3], row[x][3]};
        }
    }
    if (scale > 1) {
        // Both ways by the same factor: what is left of a pixel at the end is let go.
        const cv::Size size(std::max(1, static_cast<int>(box.width / scale)),
                            std::max(1, static_cast<int>(box.height / scale)));
        const cv::Rect used(0, 0, std::min(box.width, static_cast<int>(std::lround(size.width * scale))),
                            std::min(box.height, static_cast<int>(std::lround(size.height * scale))));
        cv::resize(cv::Mat(rgba(used)), rgba, size, 0, 0, cv::INTER_AREA);
    }
    std::vector<cv::Mat> planes;
    cv::split(rgba, planes);
    const cv::Mat alpha = planes[3];
    planes.pop_back();
    cv::Mat lab;
    cv::merge(planes, lab);
    cv::cvtColor(lab, lab, cv::COLOR_RGB2Lab);
    tones.width = lab.cols;
    tones.height = lab.rows;
    tones.origin = cut.toArtwork({box.x, box.y});
    tones.scale = cut.scale * scale;
    tones.pixels.reserve(lab.total());
    for (int y = 0; y < lab.rows; ++y) {
        const auto* colours = lab.ptr<cv::Vec3f>(y);
        const auto* opacity = alpha.ptr<float>(y);
        for (int x = 0; x < lab.cols; ++x) {
            tones.pixels.emplace_back(colours[x][0] * kLightness, colours[x][1] * kChroma, colours[x][2] * kChroma,
                                      opacity[x]);
        }
    }
    return tones;
}

Tones halved(const Tones& tones) {
    if (std::min(tones.width, tones.height) < 4) {
        return tones;
    }
    Tones half{tones.width / 2, tones.height / 2, {}, tones.origin, tones.scale * 2};
    half.pixels.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            half.pixels.push_back((tones.at(2 * x, 2 * y) + tones.at(2 * x + 1, 2 * y) + tones.at(2 * x, 2 * y + 1) +
                                   tones.at(2 * x + 1, 2 * y + 1)) *
                                  0.25F);
        }
    }
    return half;
}

glm::dvec2 Oval::normal(glm::dvec2 onCircle) const {
    // The inverse of the matrix, which is its own transpose, but for a positive factor.
    const glm::dvec2 across(yy * onCircle.x - xy * onCircle.y, xx * onCircle.y - xy * onCircle.x);
    const double length = std::hypot(across.x, across.y);
    return length > 0 ? across / length : onCircle;
}

double Oval::radius() const { return std::sqrt(std::max(0.0, xx * yy - xy * xy)); }

glm::dvec2 Oval::semiAxes() const {
    const double mean = (xx + yy) / 2;
    const double apart = std::hypot((xx - yy) / 2, xy);
    return {mean + apart, mean - apart};
}

glm::dvec2 Oval::toDisk(glm::dvec2 place) const {
    const double area = xx * yy - xy * xy;
    const glm::dvec2 from = place - centre;
    return glm::dvec2(yy * from.x - xy * from.y, xx * from.y - xy * from.x) / area;
}

Oval ovalOf(const Ellipse& ellipse, const Tones& tones) {
    const double c = std::cos(ellipse.degrees * kDegrees);
    const double s = std::sin(ellipse.degrees * kDegrees);
    const glm::dvec2 axes = ellipse.semiAxes / tones.scale;
    Oval oval;
    oval.centre = (ellipse.centre - tones.origin) / tones.scale;
    oval.xx = axes.x * c * c + axes.y * s * s;
    oval.xy = (axes.x - axes.y) * c * s;
    oval.yy = axes.x * s * s + axes.y * c * c;
    return oval;
}

Ellipse ellipseOf(const Oval& oval, const Tones& tones, double degrees) {
    const glm::dvec2 axes = oval.semiAxes() * tones.scale;
    const double turned = std::atan2(2 * oval.xy, oval.xx - oval.yy) / 2 / kDegrees;
    Ellipse ellipse{tones.origin + oval.centre * tones.scale, axes, turned};
    // An axis has no direction: of the four ways to say it, the one nearest to what was asked for.
    const double quarters = std::round((degrees - turned) / 90);
    ellipse.degrees = turned + 90 * quarters;
    if (static_cast<long>(quarters) % 2 != 0) {
        std::swap(ellipse.semiAxes.x, ellipse.semiAxes.y);
    }
    return ellipse;
}

} // namespace limner
