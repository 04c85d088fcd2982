#include "core/style/texture_tile.h"

#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/style/square_picture.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <map>
#include <mutex>

namespace limner {
namespace {

namespace fs = std::filesystem;

float mix(float a, float b, double weight) {
    // In this form equal ends give back exactly that value.
    return static_cast<float>(a + weight * (static_cast<double>(b) - a));
}

Rgba mix(const Rgba& a, const Rgba& b, double weight) {
    return {mix(a.r, b.r, weight), mix(a.g, b.g, weight), mix(a.b, b.b, weight), mix(a.a, b.a, weight)};
}

/// Where a coordinate lies between the centres of two neighbouring texels of an endless row of tiles.
struct Neighbours {
    std::size_t first = 0;
    std::size_t second = 0;
    double weight = 0;
};

Neighbours neighboursOf(double coordinate, int size) {
    const double share = coordinate - std::floor(coordinate);
    const double at = (std::isfinite(share) ? share : 0) * size - 0.5;
    const double below = std::floor(at);
    // One tile more, so that nothing is negative.
    const auto first = static_cast<std::size_t>(below + size);
    const auto count = static_cast<std::size_t>(size);
    return {first % count, (first + 1) % count, at - below};
}

/// Bilinear, repeating, of `size`^2 texels.
Rgba read(const std::vector<Rgba>& pixels, int size, const glm::dvec2& uv) {
    const Neighbours column = neighboursOf(uv.x, size);
    const Neighbours row = neighboursOf(uv.y, size);
    const auto along = [&](std::size_t line) {
        const Rgba* texels = pixels.data() + line * static_cast<std::size_t>(size);
        return mix(texels[column.first], texels[column.second], column.weight);
    };
    return mix(along(row.first), along(row.second), row.weight);
}

/// Clear texels leave a colour as it is.
Rgba factorOf(const Rgba& texel) {
    const auto factor = [&](float value) { return 1 + texel.a * (2 * value - 1); };
    return {factor(texel.r), factor(texel.g), factor(texel.b), 1};
}

/// Never fewer texels than the picture has, so less than twice as many along a side: between texels is enough.
std::vector<Rgba> resampled(const SquarePicture& picture, int size) {
    std::vector<Rgba> pixels;
    pixels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            pixels.push_back(read(picture.pixels, picture.size, glm::dvec2(x + 0.5, y + 0.5) / double(size)));
        }
    }
    return pixels;
}

/// Tiles read so far, by id.
class TextureFolder {
  public:
    std::shared_ptr<const TextureTile> find(const std::string& id) {
        const std::lock_guard lock(mutex_);
        const auto known = tiles_.find(id);
        if (known != tiles_.end()) {
            return known->second;
        }
        const fs::path picture = pictureOf(id);
        if (picture.empty()) {
            return nullptr;
        }
        return tiles_.emplace(id, loadTextureTile(picture)).first->second;
    }

  private:
    /// The folder is searched rather than asked for the name, so that no id leads out of it.
    static fs::path pictureOf(const std::string& id) {
        std::error_code missing;
        for (const auto& entry : fs::directory_iterator(resourcesFolder() / "textures", missing)) {
            if (entry.path().stem() == id && entry.path().extension() != ".json") {
                return entry.path();
            }
        }
        return {};
    }

    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const TextureTile>> tiles_;
};

} // namespace

std::shared_ptr<const TextureTile> TextureTile::half() const {
    if (size_ == 1) {
        return nullptr;
    }
    const auto side = static_cast<std::size_t>(size_);
    std::vector<Rgba> coarse;
    for (std::size_t y = 0; y < side; y += 2) {
        for (std::size_t x = 0; x < side; x += 2) {
            const Rgba* upper = pixels_.data() + y * side + x;
            const Rgba* lower = upper + side;
            coarse.push_back(mix(mix(upper[0], upper[1], 0.5), mix(lower[0], lower[1], 0.5), 0.5));
        }
    }
    return std::make_shared<const TextureTile>(size_ / 2, std::move(coarse));
}

Rgba TextureTile::at(double u, double v) const { return read(pixels_, size_, {u, v}); }

std::shared_ptr<const TextureTile> loadTextureTile(const fs::path& picture) {
    SquarePicture square = readSquarePicture(picture, kTileRules);
    try {
        std::transform(square.pixels.begin(), square.pixels.end(), square.pixels.begin(), factorOf);
        const auto size = static_cast<int>(std::bit_ceil(static_cast<unsigned>(square.size)));
        return std::make_shared<const TextureTile>(size, size == square.size ? std::move(square.pixels)
                                                                             : resampled(square, size));
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources,
                    {kTileRules.what, picture.string(), "out of memory", "use a smaller picture"});
    }
}

std::shared_ptr<const TextureTile> findBundledTexture(const std::string& id) {
    static TextureFolder folder;
    return folder.find(id);
}

} // namespace limner
