#pragma once

#include "core/figure/figure.h"

#include <string>
#include <vector>

namespace limner {

class StyleLibrary;

/// How styles come into a figure's list and leave it.

/// Id of the style in the figure's list, which it joins where it is not there yet: as "bundled:ID", or with its
/// picture's path, its texture, credit and licence. One that looks the same is used again; one that has the id of
/// another gets a number: "ivory-2".
std::string joinStyle(Figure& figure, const Style& style);

/// The styles of the list that are not bundled, as the gallery shows them; those whose picture was not found are left
/// out.
std::vector<Style> projectStyles(const Figure& figure);

/// Styles that nothing draws with leave the list where they have a home elsewhere: bundled ones, and pictures with an
/// absolute path. What lies in the project or nowhere stays.
void dropUnusedStyles(Figure& figure);

/// Where layers or cut faces name a style that the list lacks and `findStyle` (core/style/find_style.h) knows, it
/// joins the list. Throws as that does.
void joinNamedStyles(Figure& figure, const StyleLibrary& mine);

} // namespace limner
