#pragma once

#include "support/transfer_scenes.h"

namespace limner::testing {

/// Layers' parts, cut faces, depth of field and depth cues, each alone and all together.
void addPartFeatures(std::vector<TransferFeature>& features);

} // namespace limner::testing
