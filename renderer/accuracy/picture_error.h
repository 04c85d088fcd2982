#pragma once

#include "core/figure/figure.h"
#include "renderer/picture.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace limner::accuracy {

/// How far one picture is from another (spec accuracy.md 1.3). The first four over the channels of premultiplied RGBA,
/// as shares of the full range; colour differences (CIEDE2000) over pixels laid on the figure's background.
struct PictureError {
    double rmse = 0;
    double largest = 0;
    double most999 = 0; ///< 99.9 % of the channels' errors are no larger
    double meanColour = 0;
    double p95Colour = 0; ///< 95 % of the pixels' colour differences are no larger
    double largestColour = 0;
    std::size_t pixels = 0;
    std::size_t notFinite = 0; ///< pixels of the first picture that are no number; their errors count as 1 and 100

    [[nodiscard]] double psnr() const; ///< dB; infinite for equal pictures
    [[nodiscard]] double of(ErrorMetric metric) const;
};

/// Both of one size. `background`: sRGB.
PictureError measureError(const Picture& picture, const Picture& reference, const glm::dvec3& background);

/// Whether a pixel's four channels are numbers.
bool isSound(const float* pixel);

/// A premultiplied pixel as it is seen on the background; sRGB, 0..1.
glm::dvec3 laidOn(const float* pixel, const glm::dvec3& background);

/// Of colour differences: the mean, what 95 % of the pixels do not exceed, the largest. No pixels: zeros.
struct ColourSummary {
    double mean = 0;
    double p95 = 0;
    double largest = 0;
};
ColourSummary summaryOf(std::vector<float> differences);

/// Colour difference of every pixel, row by row.
std::vector<float> colourDifferences(const Picture& picture, const Picture& reference, const glm::dvec3& background);

/// "ciede2000", "max", "rmse": the words of the figure document.
const char* nameOf(ErrorMetric metric);

} // namespace limner::accuracy
