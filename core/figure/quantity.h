#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace limner {

/// Quantities as people write them. All throw Error(usage) naming `where` (an option, a pointer) and what is legal.

/// "4G", "512M", "1.5 GiB", "65536": bytes, K/M/G/T to the base of 1024. Greater than zero.
std::uint64_t parseBytes(const std::string& text, const std::string& where);

/// "2126x1417": width and height in pixels, each at least 1.
glm::ivec2 parsePixelSize(const std::string& text, const std::string& where);

/// "#fff", "#ffeedd", "#ffeedd80", "1,0.9,0.8", "1,0.9,0.8,0.5", "white", "black", "grey": sRGB-encoded, not
/// premultiplied, 0..1.
glm::dvec4 parseColour(const std::string& text, const std::string& where);

/// The colour of "#rrggbb", as figures write colours in lists of style ids; nothing for any other text.
std::optional<glm::dvec3> plainColour(const std::string& text);

/// "12.5 GiB", "3.2 MiB", "812 bytes".
std::string formatBytes(std::uint64_t bytes);

} // namespace limner
