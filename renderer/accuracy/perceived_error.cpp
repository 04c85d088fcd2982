#include "renderer/accuracy/perceived_error.h"

#include "renderer/accuracy/colour_difference.h"
#include "renderer/accuracy/picture_error.h"

#include <opencv2/imgproc.hpp>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limner::accuracy {

namespace {

constexpr double kReadingMm = 300;

/// A part of a channel's blur: a Gaussian, its full width at half of its height in degrees. The weights of a channel
/// add up to 1.
struct Spread {
    double weight, degrees;
};
using Channel = std::array<Spread, 3>;
constexpr std::array<Channel, 3> kBlur = {{
    {{{1.00327, 0.0500}, {0.11442, 0.2250}, {-0.11769, 7.0000}}}, // light and dark
    {{{0.61673, 0.0685}, {0.38328, 0.8260}, {0, 1}}},             // red and green
    {{{0.56789, 0.0920}, {0.43212, 0.6451}, {0, 1}}},             // blue and yellow
}};

/// Opponent channels of XYZ (Poirson and Wandell 1993); columns of the GLM matrix are those of X, Y, Z.
const glm::dmat3 kOpponent{
    {0.2787336, -0.4487736, 0.0859513}, {0.7218031, 0.2898056, -0.5899859}, {-0.1065520, 0.0771569, 0.5011089}};

using Channels = std::array<cv::Mat, 3>;

Channels opponentChannels(const Picture& picture, const glm::dvec3& background) {
    Channels channels;
    for (cv::Mat& channel : channels) {
        channel.create(picture.size().y, picture.size().x, CV_64F);
    }
    tbb::parallel_for(0, picture.size().y, [&](int y) {
        for (int x = 0; x < picture.size().x; ++x) {
            const float* pixel = picture.pixel(x, y);
            const glm::dvec3 o = kOpponent * xyzOfSrgb(isSound(pixel) ? laidOn(pixel, background) : glm::dvec3(1));
            for (int i = 0; i < 3; ++i) {
                channels[static_cast<std::size_t>(i)].at<double>(y, x) = o[i];
            }
        }
    });
    return channels;
}

cv::Mat blurred(const cv::Mat& channel, const Channel& blur, double perDegree) {
    cv::Mat sum = cv::Mat::zeros(channel.size(), CV_64F);
    for (const Spread& part : blur) {
        const double sigma = part.degrees * perDegree / (2 * std::sqrt(2 * std::numbers::ln2));
        if (sigma < 0.2) { // finer than a pixel
            sum += part.weight * channel;
        } else if (sigma > std::max(channel.cols, channel.rows)) { // wider than the picture
            sum += part.weight * cv::mean(channel)[0];
        } else if (part.weight != 0) {
            cv::Mat one;
            cv::GaussianBlur(channel, one, {}, sigma, sigma, cv::BORDER_REPLICATE);
            sum += part.weight * one;
        }
    }
    return sum;
}

} // namespace

double pixelsPerDegree(double pixelsPerMm) { return pixelsPerMm * kReadingMm * std::tan(std::numbers::pi / 180); }

std::vector<float> perceivedDifferences(const Picture& picture, const Picture& reference, const glm::dvec3& background,
                                        double pixelsPerDegree) {
    Channels first = opponentChannels(picture, background);
    Channels second = opponentChannels(reference, background);
    for (std::size_t i = 0; i < 3; ++i) {
        first[i] = blurred(first[i], kBlur[i], pixelsPerDegree);
        second[i] = blurred(second[i], kBlur[i], pixelsPerDegree);
    }
    const glm::dmat3 back = glm::inverse(kOpponent);
    const auto lab = [&](const Channels& channels, int y, int x) {
        return labOfXyz(back * glm::dvec3(channels[0].at<double>(y, x), channels[1].at<double>(y, x),
                                          channels[2].at<double>(y, x)));
    };
    const int width = picture.size().x;
    std::vector<float> differences(picture.rgba().size() / 4);
    tbb::parallel_for(0, picture.size().y, [&](int y) {
        for (int x = 0; x < width; ++x) {
            differences[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
                static_cast<float>(ciede2000(lab(first, y, x), lab(second, y, x)));
        }
    });
    return differences;
}

} // namespace limner::accuracy
