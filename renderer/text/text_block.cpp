#include "renderer/text/text_block.h"

#include "core/base/units.h"

#include <algorithm>
#include <numeric>

namespace limner {
namespace {

constexpr double kMmPerPoint = kMmPerInch / 72;
constexpr double kScriptSize = 0.65; ///< of the letters beside
constexpr double kSuperUp = 0.36;    ///< ems
constexpr double kSubDown = 0.16;
constexpr double kLineHeight = 1.22; ///< ems from baseline to baseline
constexpr double kAbove = 0.88;      ///< of the first baseline: capitals with their accents
constexpr double kBelow = 0.26;

/// The next letter of UTF-8 text and the bytes it takes.
std::pair<char32_t, std::size_t> letterAt(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t length = lead < 0x80 ? 1 : (lead >= 0xF0 ? 4 : (lead >= 0xE0 ? 3 : (lead >= 0xC2 ? 2 : 0)));
    if (length == 0 || length > text.size()) {
        return {U'\uFFFD', 1};
    }
    char32_t code = length == 1 ? lead : lead & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xC0U) != 0x80) {
            return {U'\uFFFD', 1};
        }
        code = code << 6 | (byte & 0x3FU);
    }
    return {code, length};
}

/// Letters that belong to the one before: combining marks and joiners stay in its face.
bool attaches(char32_t letter) {
    return (letter >= 0x300 && letter <= 0x36F) || (letter >= 0x200B && letter <= 0x200D) ||
           (letter >= 0xFE00 && letter <= 0xFE0F);
}

/// A piece of a line that is not broken: a word with the space after it, in one look.
struct Piece {
    TextRun run;
    bool breakAfter = false; ///< it ends with a space
    double inkMm = 0;        ///< its width without that space
};

class Setter {
  public:
    explicit Setter(const TextStyle& style) : style_(style) { block_.emMm = style.sizePt * kMmPerPoint; }

    TextBlock set(const std::string& text) {
        for (const TextLine& line : parseRichText(text)) {
            std::vector<Piece> pieces;
            for (const TextSpan& span : line) {
                addSpan(span, pieces);
            }
            addLines(std::move(pieces));
        }
        finish();
        return std::move(block_);
    }

  private:
    void addSpan(const TextSpan& span, std::vector<Piece>& pieces) {
        std::string_view rest = span.text;
        while (!rest.empty()) {
            const std::size_t space = rest.find(' ');
            const std::size_t end = space == std::string_view::npos ? rest.size() : space + 1;
            addWord(span, rest.substr(0, end), pieces);
            rest.remove_prefix(end);
        }
    }

    /// One piece for each face that it takes.
    void addWord(const TextSpan& look, std::string_view word, std::vector<Piece>& pieces) {
        const FontWish wish{style_.family, look.bold || style_.bold, look.italic};
        while (!word.empty()) {
            const FontFace* face = nullptr;
            std::size_t end = 0;
            while (end < word.size()) {
                const auto [letter, bytes] = letterAt(word.substr(end));
                const bool stays = face != nullptr && (attaches(letter) || letter == U' ');
                const FontFace* wanted = stays ? face : &fontWith(wish, letter);
                if (face != nullptr && wanted != face) {
                    break;
                }
                face = wanted;
                end += bytes;
            }
            addPiece(look, word.substr(0, end), *face, pieces);
            word.remove_prefix(end);
        }
    }

    void addPiece(const TextSpan& look, std::string_view text, const FontFace& face, std::vector<Piece>& pieces) const {
        Piece piece;
        TextRun& run = piece.run;
        run.face = &face;
        run.emMm = block_.emMm * (look.script == Script::normal ? 1 : kScriptSize);
        run.span = look;
        run.span.text = text;
        run.span.bold = look.bold || style_.bold;
        run.glyphs = face.shape(text);
        for (const ShapedGlyph& glyph : run.glyphs) {
            run.advanceMm += glyph.advance * run.emMm;
        }
        piece.breakAfter = text.back() == ' ';
        piece.inkMm = run.advanceMm;
        if (piece.breakAfter && !run.glyphs.empty()) {
            piece.inkMm -= run.glyphs.back().advance * run.emMm;
        }
        pieces.push_back(std::move(piece));
    }

    /// Breaks between words where a line would be too wide.
    void addLines(std::vector<Piece> pieces) {
        std::size_t first = 0;
        do {
            double width = 0;
            std::size_t end = first;
            std::size_t lastBreak = first;
            while (end < pieces.size()) {
                const bool full = style_.wrapMm > 0 && width + pieces[end].inkMm > style_.wrapMm;
                if (full && lastBreak > first) {
                    end = lastBreak;
                    break;
                }
                width += pieces[end].run.advanceMm;
                ++end;
                if (pieces[end - 1].breakAfter) {
                    lastBreak = end;
                }
            }
            addLine(std::span(pieces).subspan(first, end - first));
            first = end;
        } while (first < pieces.size());
    }

    void addLine(std::span<Piece> pieces) {
        const std::size_t line = block_.baselinesMm.size();
        block_.baselinesMm.push_back((kAbove + kLineHeight * static_cast<double>(line)) * block_.emMm);
        double x = 0;
        double ink = 0;
        for (Piece& piece : pieces) {
            piece.run.line = line;
            const Script script = piece.run.span.script;
            const double shift = script == Script::super ? -kSuperUp : (script == Script::sub ? kSubDown : 0);
            piece.run.originMm = {x, block_.baselinesMm.back() + shift * block_.emMm};
            ink = x + piece.inkMm;
            x += piece.run.advanceMm;
            block_.runs.push_back(std::move(piece.run));
        }
        widths_.push_back(ink);
    }

    void finish() {
        if (block_.runs.empty()) {
            return;
        }
        block_.align = style_.align;
        block_.sizeMm.x = *std::max_element(widths_.begin(), widths_.end());
        block_.sizeMm.y = block_.baselinesMm.back() + kBelow * block_.emMm;
        block_.firstMiddleMm =
            block_.baselinesMm.front() - block_.runs.front().face->metrics().xHeight / 2 * block_.emMm;
        const double share = style_.align == TextAlign::left ? 0 : (style_.align == TextAlign::centre ? 0.5 : 1);
        for (TextRun& run : block_.runs) {
            run.originMm.x += share * (block_.sizeMm.x - widths_[run.line]);
        }
    }

    const TextStyle& style_;
    TextBlock block_;
    std::vector<double> widths_; ///< by line, without spaces at its end
};

} // namespace

TextBlock setText(const std::string& text, const TextStyle& style) { return Setter(style).set(text); }

std::vector<char32_t> lettersOf(const std::string& text) {
    std::vector<char32_t> letters;
    for (std::string_view rest = text; !rest.empty();) {
        const auto [letter, bytes] = letterAt(rest);
        letters.push_back(letter);
        rest.remove_prefix(bytes);
    }
    return letters;
}

} // namespace limner
