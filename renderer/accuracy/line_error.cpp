#include "renderer/accuracy/line_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace limner::accuracy {

namespace {

constexpr float kVisible = 0.1F;

/// Distance of a pixel to the nearest one of a mask, up to kFarthest.
double distanceTo(const std::vector<bool>& mask, int width, int x, int y) {
    const int height = static_cast<int>(mask.size()) / width;
    int nearest = kFarthest * kFarthest;
    for (int dy = -kFarthest; dy <= kFarthest; ++dy) {
        for (int dx = -kFarthest; dx <= kFarthest; ++dx) {
            const int px = x + dx;
            const int py = y + dy;
            if (dx * dx + dy * dy < nearest && px >= 0 && px < width && py >= 0 && py < height &&
                mask[static_cast<std::size_t>(py) * static_cast<std::size_t>(width) + static_cast<std::size_t>(px)]) {
                nearest = dx * dx + dy * dy;
            }
        }
    }
    return std::sqrt(nearest);
}

} // namespace

std::vector<bool> lineMask(const Picture& picture, const Picture& withoutLines) {
    std::vector<bool> mask(picture.rgba().size() / 4);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const float* a = picture.rgba().data() + 4 * i;
        const float* b = withoutLines.rgba().data() + 4 * i;
        for (int c = 0; c < 4; ++c) {
            mask[i] = mask[i] || std::abs(a[c] - b[c]) > kVisible;
        }
    }
    return mask;
}

LineError compareLines(const std::vector<bool>& mask, const std::vector<bool>& reference, int width) {
    std::vector<double> distances;
    std::size_t apart = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const int x = static_cast<int>(i) % width;
        const int y = static_cast<int>(i) / width;
        if (mask[i] && reference[i]) {
            distances.insert(distances.end(), 2, 0.0);
        } else if (mask[i] || reference[i]) {
            distances.push_back(distanceTo(mask[i] ? reference : mask, width, x, y));
            ++apart;
        }
    }
    LineError error;
    if (distances.empty()) {
        return error;
    }
    error.any = true;
    error.meanDistance =
        std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size());
    const std::size_t at = (distances.size() * 95 + 99) / 100 - 1;
    std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(at), distances.end());
    error.p95Distance = distances[at];
    error.disagreement = static_cast<double>(apart) / (static_cast<double>(distances.size() + apart) / 2);
    return error;
}

} // namespace limner::accuracy
