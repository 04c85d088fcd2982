#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace limner {

/// A float RGBA picture, premultiplied, sRGB-encoded colour (composition works on the encoded values, as the papers and
/// all their successors do), top row first.
class Picture {
  public:
    Picture() = default;
    explicit Picture(glm::ivec2 size)
        : size_(size), rgba_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4) {}

    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] std::span<float> rgba() { return rgba_; }
    [[nodiscard]] std::span<const float> rgba() const { return rgba_; }
    [[nodiscard]] float* pixel(int x, int y) {
        return rgba_.data() +
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x)) * 4;
    }
    [[nodiscard]] const float* pixel(int x, int y) const { return const_cast<Picture*>(this)->pixel(x, y); }

  private:
    glm::ivec2 size_{0};
    std::vector<float> rgba_;
};

} // namespace limner
