#include "core/style/extraction/extract.h"

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/style/extraction/artwork.h"
#include "core/style/extraction/find.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace limner {
namespace {

constexpr int kLargest = 1024;
constexpr int kLeast = 8; ///< pixels across: less is no ball

/// Where the ball is: a circle in pixels of the picture.
struct Disk {
    glm::dvec2 centre{0, 0};
    double radius = 0;
};

/// The circle around what is opaque, where something clear surrounds it and it fills that circle.
std::optional<Disk> diskByAlpha(const ArtPicture& picture) {
    glm::ivec2 low(picture.width, picture.height);
    glm::ivec2 high(-1, -1);
    double opaque = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const float alpha = picture.at(x, y).a;
            opaque += alpha;
            if (alpha >= 0.5F) {
                low = {std::min(low.x, x), std::min(low.y, y)};
                high = {std::max(high.x, x), std::max(high.y, y)};
            }
        }
    }
    const glm::dvec2 size(high.x + 1 - low.x, high.y + 1 - low.y);
    const double share = opaque / (size.x * size.y);
    // A disk covers 0.785 of its square; a picture with alpha that is no disk is taken as a square one.
    const bool round = high.x >= low.x && std::abs(size.x - size.y) <= 0.05 * size.x && share > 0.6 && share < 0.85;
    if (!round) {
        return std::nullopt;
    }
    return Disk{glm::dvec2(low) + size / 2.0, (size.x + size.y) / 4};
}

/// A circle whose edge the picture shows, a little smaller than the picture; else the one that touches its sides.
Disk diskByEdge(const ArtCut& cut) {
    const glm::dvec2 size(cut.picture.width, cut.picture.height);
    const Disk inscribed{size / 2.0, std::min(size.x, size.y) / 2};
    const std::optional<Ellipse> snapped =
        snapEllipse(cut, {cut.toArtwork(inscribed.centre), glm::dvec2(0.95 * inscribed.radius * cut.scale), 0});
    if (!snapped) {
        return inscribed;
    }
    const Disk found{cut.toCut(snapped->centre), (snapped->semiAxes.x + snapped->semiAxes.y) / (2 * cut.scale)};
    const bool round = std::abs(snapped->semiAxes.x - snapped->semiAxes.y) < 0.04 * snapped->semiAxes.x;
    const bool inside = glm::distance(found.centre, inscribed.centre) < 0.06 * inscribed.radius &&
                        found.radius > 0.85 * inscribed.radius && found.radius < 1.02 * inscribed.radius;
    return round && inside ? found : inscribed;
}

/// Bilinear between pixel centres, held at the borders; clear pixels do not tint their neighbours.
Rgba sample(const ArtPicture& picture, glm::dvec2 place) {
    const double u = std::clamp(place.x - 0.5, 0.0, picture.width - 1.0);
    const double v = std::clamp(place.y - 0.5, 0.0, picture.height - 1.0);
    const int x = std::min(static_cast<int>(u), std::max(0, picture.width - 2));
    const int y = std::min(static_cast<int>(v), std::max(0, picture.height - 2));
    double alpha = 0;
    glm::dvec3 colour(0, 0, 0);
    for (int k = 0; k < 4; ++k) {
        const int px = std::min(x + k % 2, picture.width - 1);
        const int py = std::min(y + k / 2, picture.height - 1);
        const double weight = std::max(0.0, 1 - std::abs(u - px)) * std::max(0.0, 1 - std::abs(v - py));
        const Rgba& c = picture.at(px, py);
        alpha += weight * c.a;
        colour += weight * c.a * glm::dvec3(c.r, c.g, c.b);
    }
    colour = alpha > 0 ? colour / alpha : colour;
    return {static_cast<float>(colour.x), static_cast<float>(colour.y), static_cast<float>(colour.z),
            static_cast<float>(std::min(1.0, alpha))};
}

} // namespace

SpherePtr importMatcap(const std::filesystem::path& file, Task& task) {
    const Artwork artwork(file, task);
    const ArtCut& cut = artwork.reduced();
    const auto fail = [&](const std::string& why, const std::string& remedy) {
        throw Error(ErrorKind::badInput, {"cannot import the matcap", file.string(), why, remedy});
    };
    if (std::min(cut.picture.width, cut.picture.height) < kLeast) {
        fail("it is " + std::to_string(cut.picture.width) + " x " + std::to_string(cut.picture.height) + " pixels",
             "use a picture of a ball, 64 pixels or more across");
    }
    const bool clear =
        std::all_of(cut.picture.pixels.begin(), cut.picture.pixels.end(), [](const Rgba& c) { return c.a < 0.5F; });
    if (clear) {
        fail("it is clear all over", "use a picture of a shaded ball");
    }
    const std::optional<Disk> byAlpha = diskByAlpha(cut.picture);
    const Disk disk = byAlpha ? *byAlpha : diskByEdge(cut);
    const int size = std::clamp(static_cast<int>(std::lround(2 * disk.radius)), kLeast, kLargest);
    std::vector<Rgba> pixels;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::dvec2 onUnit((2.0 * x + 1) / size - 1, (2.0 * y + 1) / size - 1);
            Rgba texel = sample(cut.picture, disk.centre + onUnit * disk.radius);
            // Where alpha only cuts the ball out, it is not a style's opacity.
            texel.a = byAlpha ? 1 : texel.a;
            pixels.push_back(texel);
        }
    }
    return std::make_shared<const LitSphere>(size, std::move(pixels));
}

} // namespace limner
