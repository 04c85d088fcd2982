#pragma once

#include "core/base/task.h"
#include "renderer/backend.h"

#include <atomic>
#include <cmath>
#include <functional>

namespace limner::testing {

/// Paints a picture that is known in closed form, tile by tile: what the files must hold.
class GradientBackend : public Backend {
  public:
    [[nodiscard]] std::string name() const override { return "gradient"; }

    /// Premultiplied colour of a pixel; opaque to the left, half transparent in the middle, empty at the right.
    static glm::vec4 colourAt(int x, int y) {
        const float alpha = x % 8 < 5 ? 1.0F : (x % 8 < 7 ? 0.5F : 0.0F);
        const glm::vec3 colour(static_cast<float>(x % 256) / 255, static_cast<float>(y % 256) / 255,
                               static_cast<float>((x + y) % 256) / 255);
        return {colour * alpha, alpha};
    }

    RenderResult render(const RenderPlan&, const Tile& tile, Task& task) const override {
        task.throwIfCancelled();
        RenderResult result;
        result.picture = Picture(tile.size);
        for (int y = 0; y < tile.size.y; ++y) {
            for (int x = 0; x < tile.size.x; ++x) {
                const glm::vec4 c = colourAt(tile.origin.x + x, tile.origin.y + y);
                float* pixel = result.picture.pixel(x, y);
                pixel[0] = c.r;
                pixel[1] = c.g;
                pixel[2] = c.b;
                pixel[3] = c.a;
            }
        }
        result.samples = static_cast<std::uint64_t>(tile.size.x) * static_cast<std::uint64_t>(tile.size.y);
        ++calls;
        largestTile = std::max<int>(largestTile, tile.size.x * tile.size.y);
        if (afterTile) {
            afterTile(result.picture);
        }
        return result;
    }

    std::function<void(Picture&)> afterTile; ///< to break, stop or count
    mutable std::atomic<int> calls{0};
    mutable std::atomic<int> largestTile{0};
};

} // namespace limner::testing
