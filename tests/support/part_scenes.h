#pragma once

#include "support/transfer_scenes.h"

namespace limner::testing {

/// Layers' parts, cut faces, depth of field and depth cues, each alone and all together.
void addPartFeatures(std::vector<TransferFeature>& features);

/// Samples as slabs, with what a slab's place may be read for.
void addSlabFeatures(std::vector<TransferFeature>& features);

} // namespace limner::testing
