#pragma once

#include "core/style/background_picture.h"
#include "renderer/export/picture_format.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <memory>
#include <span>

namespace limner {

/// The picture behind a rendered one, at its size. Immutable.
class Backdrop {
  public:
    explicit Backdrop(std::shared_ptr<const CoveringCopy> copy) : copy_(std::move(copy)) {}

    /// Lays a piece of the backdrop's row over the colours in `rgb` (three a pixel), from pixel `start` on. Bilinear.
    void layOver(glm::ivec2 start, std::span<float> rgb) const;

  private:
    std::shared_ptr<const CoveringCopy> copy_;
};

/// Bytes that the backdrop of a picture of that size takes; 0 where there is none. At most a quarter of the memory
/// budget: on less, the picture behind the figure is made coarser, not refused.
std::size_t backdropBytes(const PictureOptions& options, const PixelLayout& layout, glm::ivec2 size);

/// Reads it. Null where the options have none or the layout keeps alpha. Throws Error(badInput) where its file is
/// damaged or gone.
std::shared_ptr<const Backdrop> makeBackdrop(const PictureOptions& options, const PixelLayout& layout, glm::ivec2 size);

} // namespace limner
