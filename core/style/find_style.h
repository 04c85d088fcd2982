#pragma once

#include "core/style/lit_sphere.h"

#include <optional>
#include <string>
#include <vector>

namespace limner {

class StyleLibrary;

/// The style that a person means by a word: "bundled:ID", the path of a style's picture, the id of a style of the
/// user's own, else of a bundled one. Nothing where there is none. Throws Error(badInput) for one that cannot be read.
std::optional<Style> findStyle(const std::string& word, const StyleLibrary& mine);

/// Ids of all styles, to tell a mistyped one.
std::vector<std::string> knownStyleIds(const StyleLibrary& mine);

} // namespace limner
