#include "renderer/scene/sub_pixels.h"

namespace limner {

void averageSubPixels(const SubPixels& from, const Tile& tile, Picture& picture) {
    const int n = from.perAxis;
    const glm::ivec2 corner = from.corner / n;
    const float share = 1.0F / static_cast<float>(n * n);
    for (int y = 0; y < from.pixels.y; ++y) {
        for (int x = 0; x < from.pixels.x; ++x) {
            const glm::ivec2 at = corner + glm::ivec2(x, y) - tile.origin;
            if (at.x < 0 || at.y < 0 || at.x >= tile.size.x || at.y >= tile.size.y) {
                continue;
            }
            float sum[4] = {};
            for (int sub = 0; sub < n * n; ++sub) {
                const auto row = static_cast<std::ptrdiff_t>(y * n + sub / n);
                const float* rgba = from.rgba + 4 * (row * from.rowLength + x * n + sub % n);
                for (int c = 0; c < 4; ++c) {
                    sum[c] += rgba[c];
                }
            }
            float* to = picture.pixel(at.x, at.y);
            for (int c = 0; c < 4; ++c) {
                to[c] = sum[c] * share;
            }
        }
    }
}

} // namespace limner
