#pragma once

#include "core/figure/figure_json.h"

namespace limner {

/// Annotations that say nothing, point nowhere or do not fit: drawn without them all the same.
void checkAnnotations(const Figure& figure, std::vector<Problem>& problems);

} // namespace limner
