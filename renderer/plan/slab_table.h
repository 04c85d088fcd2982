#pragma once

#include "renderer/plan/render_plan.h"

#include <string>
#include <vector>

namespace limner {

/// Pre-integration (core/optics/preintegration.h): a layer's extinction and its integrals over the table's entries.

/// Floats of an entry's row: extinction there and just before the next entry, then T, U and V up to it, each as two
/// numbers: the first of all rows are multiples of one quantum, so that their differences are exact, the second is the
/// rest.
inline constexpr int kSlabFloats = 8;
enum class SlabColumn { low = 0, high = 1, depth = 2, first = 4, second = 6 };

/// A row for each entry of `opacity`, which is of the reference length; computed in double.
std::vector<float> slabTable(const std::vector<float>& opacity);

/// Why a plan's samples cannot be slabs; empty: they can.
std::string whyNoSlabs(const RenderPlan& plan);

/// Makes a plan pre-integrated where the figure asks for it and nothing speaks against it. Its layers must be complete.
void planSlabs(RenderPlan& plan);

} // namespace limner
