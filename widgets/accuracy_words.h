#pragma once

#include "renderer/accuracy/savings.h"
#include "renderer/accuracy/study.h"

#include <QString>

namespace limner {

/// Error, tolerance and settings in the window's language and number format.

/// "Largest difference"
QString metricName(ErrorMetric metric);
/// "ΔE 0.52", "0.00196"; three digits.
QString errorWords(double error, ErrorMetric metric);
/// "0.31 s", "12 ms"
QString secondsWords(double seconds);
/// The named one's name; empty: it has none.
QString toleranceName(const accuracy::Tolerance& tolerance);
/// Of a choice: on places that the search had not seen; where it was not reached, what kept it from being so.
double deliveredError(const accuracy::ToleranceChoice& choice);
/// Its place among the named ones; their number: it is none of them.
std::size_t placeOfTolerance(const accuracy::Tolerance& tolerance);
/// "step 0.25 voxel, pre-integrated, rays end at 0.001": what the search may change.
QString settingsWords(const Quality& quality);
/// The knob that keeps the error from being smaller, in a sentence.
QString limitWords(const accuracy::Limiting& limits, ErrorMetric metric);
/// A way of sampling of a study's series: "Pre-integration".
QString methodWords(const std::string& method);
/// What a picture is drawn without, a line each, and what all of it saves.
QString savingsWords(const accuracy::Savings& savings);
/// One choice of a study, by its name: "Screen", "As asked".
QString choiceWords(const std::string& name);

} // namespace limner
