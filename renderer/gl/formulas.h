#pragma once

#include "renderer/accuracy/formula.h"
#include "renderer/gl/context.h"

#include <cstddef>
#include <string>
#include <vector>

namespace limner::gl {

/// Evaluates a formula in GLSL for many sets of arguments, in single precision. `arguments`: `count` numbers for each
/// set, one set after the other; for importanceRay 3 for every sample, a sample without opacity changes nothing. Gives
/// the formula's results for each set, one set after the other. Throws Error(noOpenGl).
std::vector<float> evaluateFormula(const ContextFactory& contexts, Formula formula, std::size_t count,
                                   const std::vector<float>& arguments);

} // namespace limner::gl
