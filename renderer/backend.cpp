#include "renderer/backend.h"

#include <algorithm>

namespace limner {

Picture stackOf(std::span<const Tile> tiles) {
    glm::ivec2 size{0};
    for (const Tile& tile : tiles) {
        size = {std::max(size.x, tile.size.x), size.y + tile.size.y};
    }
    return Picture(size);
}

void stackAt(int top, const Picture& tile, Picture& stack) {
    for (int y = 0; y < tile.size().y; ++y) {
        const float* row = tile.pixel(0, y);
        std::copy(row, row + static_cast<std::ptrdiff_t>(tile.size().x) * 4, stack.pixel(0, top + y));
    }
}

RenderResult Backend::renderTiles(const RenderPlan& plan, std::span<const Tile> tiles, Task& task) const {
    RenderResult all{stackOf(tiles), 0, 0};
    int top = 0;
    for (const Tile& tile : tiles) {
        const RenderResult one = render(plan, tile, task);
        stackAt(top, one.picture, all.picture);
        all.samples += one.samples;
        all.shaded += one.shaded;
        top += tile.size.y;
    }
    return all;
}

} // namespace limner
