#pragma once

#include "widgets/artwork_tool.h"

#include <QIcon>

namespace limner {

/// A tool as a line drawing in a palette's text colour, in its highlighted text's while chosen; `side` in logical
/// pixels.
QIcon toolIcon(ToolKind kind, const QPalette& palette, int side, double pixelRatio);

} // namespace limner
