#pragma once

#include "core/base/task.h"
#include "renderer/picture.h"
#include "renderer/plan/render_plan.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace limner {

/// A rectangle of the plan's picture, in pixels.
struct Tile {
    glm::ivec2 origin{0};
    glm::ivec2 size{0};
};

struct RenderResult {
    Picture picture;           ///< of the tile's size, without the background
    std::uint64_t samples = 0; ///< volume samples taken
    std::uint64_t shaded = 0;  ///< of these, with a gradient and a colour
};

/// Turns a plan into pixels. The same plan gives the same picture on every backend to within their stated tolerances;
/// on one backend any tiling gives the same bits.
class Backend {
  public:
    virtual ~Backend() = default;
    [[nodiscard]] virtual std::string name() const = 0;
    /// Throws Error(cancelled) within 20 ms of a cancellation; on a graphics card after the piece that it is drawing.
    virtual RenderResult render(const RenderPlan& plan, const Tile& tile, Task& task) const = 0;
    /// Several tiles one below the other in one picture as wide as the widest; what a tile does not cover is clear.
    /// A backend that prepares a plan before it draws prepares it once for all of them.
    virtual RenderResult renderTiles(const RenderPlan& plan, std::span<const Tile> tiles, Task& task) const;

    /// Whether the backend draws the dots of the plan's marks itself.
    [[nodiscard]] virtual bool laysDots(const RenderPlan& /*plan*/) const { return false; }
    /// Lays the dots of the plan's marks, and no strokes, into a rendered tile: those that renderer/marks draws. By
    /// renderer/marks where the backend does not. Throws as `render` does.
    virtual void layDots(const RenderPlan& plan, const Tile& tile, Picture& picture, Task& task) const;
};

/// An empty picture that several tiles fit into, one below the other.
Picture stackOf(std::span<const Tile> tiles);
/// Copies a tile's picture to its place in a stack, from row `top` on.
void stackAt(int top, const Picture& tile, Picture& stack);

/// The SIMD ray caster (renderer/cpu). Uses all threads of the current TBB arena.
std::unique_ptr<Backend> makeCpuBackend();
/// Double precision, exact evaluation, no tables, no skipping (renderer/reference).
std::unique_ptr<Backend> makeReferenceBackend();

} // namespace limner
