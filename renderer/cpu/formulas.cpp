// The papers' formulas by name over vectors of floats, for every instruction set (Highway's run-time dispatch).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/cpu/formulas.cpp"
#include <hwy/foreach_target.h> // must come before the headers that each target compiles anew
#include <hwy/highway.h>        // names the target: before the formulas

#include "renderer/accuracy/formula_calls.h"
#include "renderer/cpu/formulas.h"
#include "renderer/cpu/optics_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// The arguments of some evaluations of a block.
struct BlockArguments {
    const float* first;
    HWY_INLINE Lanes operator()(std::size_t argument) const {
        return Lanes(hn::LoadU(kF, first + argument * FormulaBlock::kWidth));
    }
};

void evaluateBlockTarget(const FormulaBlock& block, float* out) {
    static_assert(FormulaBlock::kWidth % kMaxLanes == 0);
    for (std::size_t i = 0; i < FormulaBlock::kWidth; i += hn::Lanes(kF)) {
        Lanes results[3];
        optics::evaluateFormula(block.formula, BlockArguments{block.in + i}, block.arguments, results);
        for (std::size_t k = 0; k < kindOf(block.formula).results; ++k) {
            hn::StoreU(results[k].v, kF, out + k * FormulaBlock::kWidth + i);
        }
    }
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace limner {

namespace {
HWY_EXPORT(evaluateBlockTarget);
}

void evaluateBlock(const FormulaBlock& block, float* out) { HWY_DYNAMIC_DISPATCH(evaluateBlockTarget)(block, out); }

} // namespace limner

#endif
