#pragma once

#include "core/style/lit_sphere.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace limner {

class TextureTile;

/// The bytes of a PNG: RGBA of 16 bits, sRGB, alpha not premultiplied, so that the colour of clear texels stays and
/// what came from 16 bits goes back bit for bit. `pixels`: width * height, top row first. Any thread.
std::string pngBytes(glm::ivec2 size, std::span<const Rgba> pixels);
std::string pngBytes(const LitSphere& sphere);
/// As `loadTextureTile` reads it: half the tile's factors.
std::string pngBytes(const TextureTile& tile);
/// Grey of 8 bits.
std::string pngBytes(glm::ivec2 size, std::span<const std::uint8_t> values);

/// The whole file or nothing: written beside, then renamed. Throws Error(noResources).
void writeWholeFile(const std::filesystem::path& file, const std::string& bytes);

} // namespace limner
