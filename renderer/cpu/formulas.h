#pragma once

#include "renderer/accuracy/formula.h"

#include <cstddef>

namespace limner {

/// Arguments of one formula for kWidth evaluations side by side.
struct FormulaBlock {
    static constexpr std::size_t kWidth = 16; ///< a multiple of every vector's length
    Formula formula;
    std::size_t arguments; ///< a ray's: 3 for every sample; a sample without opacity changes nothing
    const float* in;       ///< argument k of evaluation i at k * kWidth + i
};

/// Evaluates in single precision with the vector instructions that `restrictKernelTarget` chose, else the machine's
/// best. `out`: result k of evaluation i at k * kWidth + i. Thread-safe.
void evaluateBlock(const FormulaBlock& block, float* out);

} // namespace limner
