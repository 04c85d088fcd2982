#pragma once

#include "renderer/accuracy/study.h"

#include <string>

namespace limner::accuracy {

/// The study as one SVG element: log error over log time of a whole picture. A line for each way of sampling with the
/// step as parameter, a dot for each row, the hull of what no other one beats, the figure as it is, the named
/// tolerances where they are of the study's metric, and the reference's bar in grey.
std::string errorChart(const Study& study);

} // namespace limner::accuracy
