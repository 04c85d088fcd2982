#pragma once

#include "core/style/extraction/artwork.h"

#include <optional>

namespace limner {

/// The colour of the paper: the commonest light colour of the scan, where it covers a fiftieth of it at least.
std::optional<Rgba> paperColour(const ArtCut& artwork);

} // namespace limner
