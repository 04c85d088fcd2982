#pragma once

#include "renderer/export/pdf_file.h"
#include "renderer/text/font_face.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace limner {

/// The fonts of a PDF file: each face embedded with the glyphs in use, and a table back to their letters. A glyph that
/// stands for different letters gets a code for each, so that a search finds what was written.
class PdfFonts {
  public:
    /// The code of a glyph that shows `letters` (UTF-8; empty where a glyph before shows them already).
    int code(const FontFace& face, std::uint32_t glyph, const std::string& letters);
    /// The face's name in the page's resources.
    std::string name(const FontFace& face);
    /// Writes all fonts; returns the entries of the page's /Font dictionary.
    std::string write(PdfFile& file) const;

  private:
    struct Code {
        std::uint32_t glyph = 0;
        std::string letters;
    };
    struct Used {
        const FontFace* face = nullptr;
        std::map<std::pair<std::uint32_t, std::string>, int> known;
        std::vector<Code> codes; ///< of code i + 1
    };
    Used& used(const FontFace& face);
    static int writeFont(PdfFile& file, const Used& used, std::size_t number);

    std::vector<Used> faces_;
};

} // namespace limner
