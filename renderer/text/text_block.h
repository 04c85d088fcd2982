#pragma once

#include "core/figure/rich_text.h"
#include "renderer/text/font_face.h"
#include "renderer/text/font_shelf.h"

namespace limner {

enum class TextAlign { left, centre, right };

struct TextStyle {
    std::string family = {};
    double sizePt = 8;
    bool bold = false;
    TextAlign align = TextAlign::left;
    double wrapMm = 0; ///< lines are broken between words to be no wider, where that is possible; 0: never
};

/// Letters of one face and look on one line. Places are mm from the block's top left corner, y down.
struct TextRun {
    const FontFace* face = nullptr;
    double emMm = 0;
    TextSpan span;          ///< the text and its look
    glm::dvec2 originMm{0}; ///< of its baseline
    double advanceMm = 0;
    std::vector<ShapedGlyph> glyphs; ///< from the origin, in ems
    std::size_t line = 0;
};

struct TextBlock {
    glm::dvec2 sizeMm{0};
    double firstMiddleMm = 0; ///< from the top to half the height of a small letter of the first line
    double emMm = 0;
    TextAlign align = TextAlign::left;
    std::vector<double> baselinesMm; ///< by line, from the top
    std::vector<TextRun> runs;       ///< from left to right, line by line
};

/// Sets a text with markup. Empty text makes an empty block. Throws Error(noResources) where there is no font.
TextBlock setText(const std::string& text, const TextStyle& style);

/// The letters of UTF-8 text; what is damaged becomes U+FFFD.
std::vector<char32_t> lettersOf(const std::string& text);

} // namespace limner
