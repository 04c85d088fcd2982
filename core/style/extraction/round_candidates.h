#pragma once

#include "core/style/extraction/tones.h"

#include <vector>

namespace limner {

class Task;

/// Ovals of the tones where something round may be, not yet snapped, the likeliest first: circles that edges agree on,
/// and ovals fitted to the outlines of patches of like tone. Always the same for the same tones. Internal to the
/// extraction. Throws Error(cancelled).
std::vector<Oval> roundCandidates(const Tones& tones, const Task& task, std::size_t most);

} // namespace limner
