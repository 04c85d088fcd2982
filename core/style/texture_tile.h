#pragma once

#include "core/style/lit_sphere.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace limner {

/// A picture that repeats without a seam, laid on the object: factors of the style's colour, 1 = unchanged. Kept as the
/// picture's sRGB numbers times two, so that mid grey leaves a colour as it is and white doubles it.
class TextureTile {
  public:
    /// `pixels`: size * size factors, top row first; size is a power of two.
    TextureTile(int size, std::vector<Rgba> pixels) : size_(size), pixels_(std::move(pixels)) {}
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] const std::vector<Rgba>& pixels() const { return pixels_; }
    /// Bilinear between texel centres, repeating; u and v count tiles, u to the right and v down: texel (x, y) has its
    /// centre at ((x + 0.5) / size, (y + 0.5) / size).
    [[nodiscard]] Rgba at(double u, double v) const;
    /// The next coarser tile, texels averaged in fours; null at size 1.
    [[nodiscard]] std::shared_ptr<const TextureTile> half() const;

  private:
    int size_;
    std::vector<Rgba> pixels_;
};

/// Reads a tile (any format OpenImageIO reads, square, 16 to 2048 pixels; resampled to the next power of two; clear
/// texels become the factor 1, alpha itself is not kept). Throws Error(badInput).
std::shared_ptr<const TextureTile> loadTextureTile(const std::filesystem::path& picture);

/// The bundled tile of that id ("paper", "marble", ...), from `resourcesFolder()/textures`, read on first use; null
/// where there is none. Thread-safe.
std::shared_ptr<const TextureTile> findBundledTexture(const std::string& id);

} // namespace limner
