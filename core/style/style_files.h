#pragma once

#include "core/style/lit_sphere.h"

#include <filesystem>
#include <string>

namespace limner {

/// A style on disk: a picture, `PICTURE.png`; its card, `PICTURE.json`; and, where there is one, its texture,
/// `PICTURE-texture.png`. Any thread.
std::filesystem::path cardFileOf(const std::filesystem::path& picture);
std::filesystem::path textureFileOf(const std::filesystem::path& picture);

/// JSON text of a card. Members of `old`, the text that it replaces, that are none of a card's stay as they are.
/// Throws Error(badInput) where `old` is no JSON object, with `where` in its words.
std::string cardText(const StyleCard& card, const std::string& old = {}, const std::string& where = {});

/// Writes all files of a style, each whole; the picture comes last, so that where it is the rest is too. Where
/// something fails nothing new is left. Throws Error(noResources).
void writeStyle(const Style& style, const std::filesystem::path& picture);

/// `loadStyle` with the texture beside the picture. Throws Error(badInput).
Style loadWholeStyle(const std::filesystem::path& picture);

/// Throws Error(badInput) for what `loadStyle` would refuse without reading it: looks at the header and the card only.
void checkStyleFiles(const std::filesystem::path& picture);

} // namespace limner
