#include "core/style/extraction/find.h"
#include "core/style/extraction/rim.h"

#include <algorithm>

namespace limner {
namespace {

/// Of the ellipse, in pixels: enough to place it to a thousandth of its size.
constexpr int kFineRadius = 240;
/// Coarse to fine: first what the whole rim says, then where exactly it is.
constexpr int kCoarseRadius = 60;

} // namespace

std::optional<Ellipse> snapEllipse(const ArtCut& cut, const Ellipse& rough) {
    const double longer = std::max(rough.semiAxes.x, rough.semiAxes.y);
    const double shorter = std::min(rough.semiAxes.x, rough.semiAxes.y);
    if (!(shorter > 0) || !(longer / shorter < 20)) {
        return std::nullopt;
    }
    constexpr double kAround = 1.5;
    const glm::dvec2 box(longer * kAround);
    const Tones fine =
        tonesOf(cut, rough.centre - box, rough.centre + box, static_cast<int>(2 * kAround * kFineRadius));
    if (fine.pixels.empty()) {
        return std::nullopt;
    }
    Tones coarse = fine;
    while (longer / coarse.scale > 2 * kCoarseRadius && std::min(coarse.width, coarse.height) >= kCoarseRadius) {
        coarse = halved(coarse);
    }
    const auto found = followRim(coarse, ovalOf(rough, coarse), {{0.2, 0.12, 0.06}, 180});
    if (!found) {
        return std::nullopt;
    }
    const Ellipse near = ellipseOf(found->oval, coarse, rough.degrees);
    const auto closer = followRim(fine, ovalOf(near, fine), {{0.1, 0.03, 0.02}, 360});
    return ellipseOf(closer ? closer->oval : found->oval, closer ? fine : coarse, rough.degrees);
}

} // namespace limner
