#pragma once

#include "core/figure/figure.h"
#include "core/style/transfer_function.h"

#include <QString>

#include <span>
#include <string>

class QWidget;

namespace limner {

class TransferPlane;

/// What the editors of transfer functions have in common beside the canvas.

/// All axes' names in a figure document, in the order people look for them.
std::span<const char* const> axisWords();
QString axisName(const std::string& word);
/// A sentence about what the axis lacks in the figure and what to do; empty where it lacks nothing.
QString axisMissing(const Figure& figure, const std::string& word);

/// Buttons that zoom a canvas: less, more, fit to the data, all values.
QWidget* zoomButtons(TransferPlane* canvas);

} // namespace limner
