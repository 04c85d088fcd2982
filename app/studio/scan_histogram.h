#pragma once

#include "core/figure/figure.h"
#include "core/volume/histogram.h"

#include <memory>

namespace limner {

/// The histogram that a document's panels show; null where its scan is not there. Any thread.
std::shared_ptr<const Histogram> scanHistogram(const Figure& figure);

} // namespace limner
