#include "renderer/accuracy/picture_error.h"

#include "renderer/accuracy/colour_difference.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace limner::accuracy {

namespace {

constexpr float kWorstColour = 100; ///< of a pixel that is no number: black against white

/// The value that a share of them does not exceed; reorders.
float quantile(std::vector<float>& values, double share) {
    const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    return values[at];
}

} // namespace

bool isSound(const float* pixel) {
    return std::all_of(pixel, pixel + 4, [](float v) { return std::isfinite(v); });
}

glm::dvec3 laidOn(const float* pixel, const glm::dvec3& background) {
    const double clear = 1 - static_cast<double>(pixel[3]);
    return glm::clamp(glm::dvec3(pixel[0], pixel[1], pixel[2]) + clear * background, 0.0, 1.0);
}

ColourSummary summaryOf(std::vector<float> differences) {
    if (differences.empty()) {
        return {};
    }
    const double sum = std::accumulate(differences.begin(), differences.end(), 0.0);
    const float largest = *std::max_element(differences.begin(), differences.end());
    return {sum / static_cast<double>(differences.size()), quantile(differences, 0.95), largest};
}

double PictureError::psnr() const {
    return rmse > 0 ? -20 * std::log10(rmse) : std::numeric_limits<double>::infinity();
}

double PictureError::of(ErrorMetric metric) const {
    switch (metric) {
    case ErrorMetric::ciede2000: return p95Colour;
    case ErrorMetric::largest: return largest;
    case ErrorMetric::rootMeanSquare: break;
    }
    return rmse;
}

const char* nameOf(ErrorMetric metric) {
    switch (metric) {
    case ErrorMetric::ciede2000: return "ciede2000";
    case ErrorMetric::largest: return "max";
    case ErrorMetric::rootMeanSquare: break;
    }
    return "rmse";
}

std::vector<float> colourDifferences(const Picture& picture, const Picture& reference, const glm::dvec3& background) {
    const std::size_t pixels = picture.rgba().size() / 4;
    std::vector<float> differences(pixels);
    tbb::parallel_for(std::size_t{0}, pixels, [&](std::size_t i) {
        const float* a = picture.rgba().data() + 4 * i;
        const float* b = reference.rgba().data() + 4 * i;
        if (!isSound(a)) {
            differences[i] = kWorstColour;
        } else if (!std::equal(a, a + 4, b)) {
            differences[i] =
                static_cast<float>(ciede2000(labOfSrgb(laidOn(a, background)), labOfSrgb(laidOn(b, background))));
        }
    });
    return differences;
}

PictureError measureError(const Picture& picture, const Picture& reference, const glm::dvec3& background) {
    assert(picture.size() == reference.size());
    PictureError error;
    const auto a = picture.rgba();
    const auto b = reference.rgba();
    error.pixels = a.size() / 4;
    if (error.pixels == 0) {
        return error;
    }
    std::vector<float> channels(a.size());
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        channels[i] = std::isfinite(a[i]) ? std::abs(a[i] - b[i]) : 1.0F;
        squares += static_cast<double>(channels[i]) * channels[i];
        error.notFinite += i % 4 == 0 && !isSound(a.data() + i) ? 1 : 0;
    }
    error.rmse = std::sqrt(squares / static_cast<double>(a.size()));
    error.largest = *std::max_element(channels.begin(), channels.end());
    error.most999 = quantile(channels, 0.999);
    const ColourSummary colours = summaryOf(colourDifferences(picture, reference, background));
    error.meanColour = colours.mean;
    error.p95Colour = colours.p95;
    error.largestColour = colours.largest;
    return error;
}

} // namespace limner::accuracy
