#include "renderer/export/pdf_fonts.h"

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

constexpr double kUnits = 1000; ///< of PDF's glyph space, an em

std::string hex4(std::size_t value) {
    char text[8];
    std::snprintf(text, sizeof text, "%04X", static_cast<unsigned>(value & 0xFFFFU));
    return text;
}

/// The hexadecimal UTF-16 of a text, without the mark of its order.
std::string utf16(const std::string& text) {
    const std::string marked = pdfText(text); // <FEFF....>
    return "<" + marked.substr(5);
}

std::string thousandths(double em) { return std::to_string(std::lround(em * kUnits)); }

/// Six letters that tell a subset from others: any, but the same for the same file.
std::string tag(std::size_t number) {
    std::string text = "LIMNAA";
    text[4] = static_cast<char>('A' + number / 26 % 26);
    text[5] = static_cast<char>('A' + number % 26);
    return text;
}

void writeStream(PdfFile& file, int number, const std::string& entries, const std::string& bytes) {
    file.beginStream(number, entries);
    file.streamBytes(bytes);
    file.endStream();
}

/// The table from codes to letters.
std::string unicodeMap(const std::vector<std::string>& lines) {
    std::string text = "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n/CIDSystemInfo << /Registry "
                       "(Adobe) /Ordering (UCS) /Supplement 0 >> def\n/CMapName /Adobe-Identity-UCS def\n/CMapType 2 "
                       "def\n1 begincodespacerange\n<0000> <FFFF>\nendcodespacerange\n";
    constexpr std::size_t kMost = 100; // lines in a block, as the format wants it
    for (std::size_t first = 0; first < lines.size(); first += kMost) {
        const std::size_t count = std::min(kMost, lines.size() - first);
        text += std::to_string(count) + " beginbfchar\n";
        for (std::size_t i = 0; i < count; ++i)
            text += lines[first + i];
        text += "endbfchar\n";
    }
    return text + "endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend\n";
}

/// The embedded glyphs and what a reader wants to know of them.
int writeDescriptor(PdfFile& file, const FontFace& face, const std::string& base,
                    const std::vector<std::uint32_t>& glyphs) {
    const FaceMetrics& metrics = face.metrics();
    const int descriptor = file.reserve();
    const int program = file.reserve();
    constexpr int kSymbolic = 4; // its letters are not only Latin
    file.write(descriptor, "<< /Type /FontDescriptor /FontName " + base + " /Flags " + std::to_string(kSymbolic) +
                               " /FontBBox [" + thousandths(metrics.lowest.x) + " " + thousandths(metrics.lowest.y) +
                               " " + thousandths(metrics.highest.x) + " " + thousandths(metrics.highest.y) +
                               "] /ItalicAngle 0 /Ascent " + thousandths(metrics.ascent) + " /Descent " +
                               thousandths(-metrics.descent) + " /CapHeight " + thousandths(metrics.capHeight) +
                               " /StemV 80 " + (face.trueType() ? "/FontFile2 " : "/FontFile3 ") +
                               pdfReference(program) + " >>");
    const std::string bytes = face.subset(glyphs);
    writeStream(file, program,
                face.trueType() ? "/Length1 " + std::to_string(bytes.size()) : std::string("/Subtype /OpenType"),
                bytes);
    return descriptor;
}

} // namespace

PdfFonts::Used& PdfFonts::used(const FontFace& face) {
    const auto found = std::find_if(faces_.begin(), faces_.end(), [&](const Used& one) { return one.face == &face; });
    if (found != faces_.end())
        return *found;
    faces_.push_back({&face, {}, {}});
    return faces_.back();
}

int PdfFonts::code(const FontFace& face, std::uint32_t glyph, const std::string& letters) {
    Used& of = used(face);
    if (!face.trueType()) { // its codes are its glyphs
        of.known.emplace(std::pair(glyph, std::string()), 0);
        const auto same =
            std::find_if(of.codes.begin(), of.codes.end(), [&](const Code& c) { return c.glyph == glyph; });
        if (same == of.codes.end())
            of.codes.push_back({glyph, letters});
        return static_cast<int>(glyph);
    }
    const auto [place, fresh] = of.known.try_emplace({glyph, letters}, static_cast<int>(of.codes.size()) + 1);
    if (fresh)
        of.codes.push_back({glyph, letters});
    return place->second;
}

std::string PdfFonts::name(const FontFace& face) {
    const auto index = &used(face) - faces_.data();
    return "/F" + std::to_string(index + 1);
}

std::string PdfFonts::write(PdfFile& file) const {
    std::string entries;
    for (std::size_t i = 0; i < faces_.size(); ++i)
        entries += "/F" + std::to_string(i + 1) + " " + pdfReference(writeFont(file, faces_[i], i)) + " ";
    return entries;
}

int PdfFonts::writeFont(PdfFile& file, const Used& used, std::size_t number) {
    const FontFace& face = *used.face;
    std::vector<std::uint32_t> glyphs;
    std::vector<std::string> letters;
    std::string widths;
    std::string toGlyph(2, '\0');
    for (std::size_t i = 0; i < used.codes.size(); ++i) {
        const Code& code = used.codes[i];
        const std::size_t value = face.trueType() ? i + 1 : code.glyph;
        glyphs.push_back(code.glyph);
        widths += std::to_string(value) + " [" + thousandths(face.advance(code.glyph)) + "] ";
        toGlyph += {static_cast<char>(code.glyph >> 8 & 0xFFU), static_cast<char>(code.glyph & 0xFFU)};
        if (!code.letters.empty())
            letters.push_back("<" + hex4(value) + "> " + utf16(code.letters) + "\n");
    }
    const int font = file.reserve();
    const int descendant = file.reserve();
    const int map = file.reserve();
    const int unicode = file.reserve();
    const std::string base = "/" + tag(number) + "+" + face.postScriptName();
    const int descriptor = writeDescriptor(file, face, base, glyphs);
    file.write(font, "<< /Type /Font /Subtype /Type0 /BaseFont " + base + " /Encoding /Identity-H /DescendantFonts [" +
                         pdfReference(descendant) + "] /ToUnicode " + pdfReference(unicode) + " >>");
    file.write(descendant, "<< /Type /Font /Subtype " +
                               std::string(face.trueType() ? "/CIDFontType2" : "/CIDFontType0") + " /BaseFont " + base +
                               " /CIDSystemInfo << /Registry (Adobe) /Ordering (Identity) /Supplement 0 >>" +
                               " /FontDescriptor " + pdfReference(descriptor) + " /DW 1000 /W [ " + widths + "]" +
                               (face.trueType() ? " /CIDToGIDMap " + pdfReference(map) : "") + " >>");
    writeStream(file, map, "", toGlyph);
    writeStream(file, unicode, "", unicodeMap(letters));
    return font;
}

} // namespace limner
