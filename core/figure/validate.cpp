#include "core/figure/figure_json.h"
namespace limner {
std::vector<Problem> validateFigure(const Figure&) { return {}; }
} // namespace limner
