#pragma once

#include "core/figure/figure.h"

#include <cstddef>
#include <set>
#include <string>

namespace limner {

/// Changes of a figure's list of layers as functions from value to value. Places count from 0, the first to be drawn.

/// Whether there is such a layer and it is not locked.
bool mayChange(const Figure& figure, std::size_t layer);

/// Ids of the styles that a layer draws with: of its nodes or grid, and of its cut faces.
std::set<std::string> stylesOf(const Layer& layer);

/// The layer draws with style `to` wherever it drew with `from`.
void exchangeStyle(Layer& layer, const std::string& from, const std::string& to);

/// Styles that nothing draws with leave the list where they are kept elsewhere: bundled ones, and those whose picture
/// is named by an absolute path (the user's own). What the project alone has stays.
void dropUnusedStyles(Figure& figure);

/// A layer to start from: it shows the upper half of the scan's values in the figure's first style, or in a plain
/// colour under Phong's light where the figure has no style.
Layer freshLayer(const Figure& figure);

/// The layer comes to stand at `place` (held within the list), under a name that no other has.
Figure withLayerAdded(const Figure& figure, std::size_t place, Layer layer);
/// A copy behind the layer, neither locked nor solo, under a name of its own.
Figure withLayerDuplicated(const Figure& figure, std::size_t layer);
Figure withLayerRemoved(const Figure& figure, std::size_t layer);
/// The layer at `from` comes to stand at `to`; those between move up by one.
Figure withLayerMoved(const Figure& figure, std::size_t from, std::size_t to);

} // namespace limner
