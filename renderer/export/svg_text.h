#pragma once

#include "renderer/annotations.h"
#include "renderer/export/compact_text.h"

#include <string>

namespace limner {

/// Text as XML holds it; control characters have no place there.
std::string escapedXml(const std::string& text);

/// "#rrggbb".
std::string hexColour(const InkColour& rgb);

/// A <text> element a line, its looks as <tspan>s. A line is held where it begins, ends or has its middle, as its block
/// is aligned: another font on another machine does not move it away from its leader.
void writeSvgText(CompactText& out, const PaperText& text);

} // namespace limner
