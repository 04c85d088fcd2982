#include "core/style/extraction/paper.h"

#include <algorithm>
#include <array>
#include <vector>

namespace limner {
namespace {

constexpr int kSteps = 24;         ///< of each channel: paper's grain stays within one or two
constexpr float kLightest = 0.55F; ///< of the darkest channel: old paper is yellow, not brown
constexpr double kLeastShare = 0.02;

} // namespace

std::optional<Rgba> paperColour(const ArtCut& artwork) {
    std::vector<int> counts(static_cast<std::size_t>(kSteps) * kSteps * kSteps, 0);
    const auto step = [](float value) { return std::clamp(static_cast<int>(value * kSteps), 0, kSteps - 1); };
    const auto bin = [&](const Rgba& c) {
        return static_cast<std::size_t>((step(c.r) * kSteps + step(c.g)) * kSteps + step(c.b));
    };
    const auto light = [](const Rgba& c) { return c.a >= 0.5F && std::min({c.r, c.g, c.b}) >= kLightest; };
    for (const Rgba& c : artwork.picture.pixels) {
        counts[bin(c)] += light(c) ? 1 : 0;
    }
    const auto commonest = std::max_element(counts.begin(), counts.end());
    if (*commonest < kLeastShare * static_cast<double>(artwork.picture.pixels.size())) {
        return std::nullopt;
    }
    const auto wanted = static_cast<std::size_t>(commonest - counts.begin());
    std::array<double, 3> sum{};
    for (const Rgba& c : artwork.picture.pixels) {
        if (light(c) && bin(c) == wanted) {
            sum[0] += c.r;
            sum[1] += c.g;
            sum[2] += c.b;
        }
    }
    const auto mean = [&](std::size_t c) { return static_cast<float>(sum[c] / *commonest); };
    return Rgba{mean(0), mean(1), mean(2), 1};
}

} // namespace limner
