#pragma once

#include "renderer/backend.h"
#include "renderer/marks/marks.h"

#include <cstdint>
#include <optional>

namespace limner {

/// A figure's picture, layers and marks together, tile by tile. The marks are drawn once.
class MarkedPicture {
  public:
    /// Draws the plan's marks where it has any. Throws Error(cancelled). Plan and backend must outlive it.
    MarkedPicture(const RenderPlan& plan, const Backend& backend, Task& task);
    /// Layers that marks stand for are not rendered at all.
    [[nodiscard]] RenderResult render(const Tile& tile, Task& task) const;
    /// Those that the backend lays itself are not counted.
    [[nodiscard]] std::uint64_t dots() const { return marks_ ? marks_->dotCount() : 0; }
    [[nodiscard]] std::uint64_t strokes() const { return marks_ ? marks_->strokeCount() : 0; }

  private:
    const RenderPlan& plan_;
    const Backend& backend_;
    bool dotsByBackend_;
    std::optional<Marks> marks_;
};

/// A tile of the layers alone: empty where marks stand for them.
RenderResult renderLayers(const RenderPlan& plan, const Backend& backend, const Tile& tile, Task& task);

} // namespace limner
