#include "renderer/export/svg_text.h"

#include <algorithm>
#include <vector>

namespace limner {

namespace {

constexpr int kSizeDecimals = 4;

/// Neighbours of one look are one piece of text, whatever words and faces they were set of.
struct Piece {
    TextSpan span;
    double emMm = 0;
    double baselineMm = 0;
    std::string family;
};

std::vector<Piece> piecesOf(const TextBlock& block, std::size_t line) {
    std::vector<Piece> pieces;
    for (const TextRun& run : block.runs) {
        if (run.line != line)
            continue;
        Piece piece{run.span, run.emMm, run.originMm.y, run.face->source().family};
        if (!pieces.empty()) {
            Piece& last = pieces.back();
            TextSpan look = run.span;
            look.text = last.span.text;
            if (look == last.span && piece.family == last.family) {
                last.span.text += run.span.text;
                continue;
            }
        }
        pieces.push_back(piece);
    }
    return pieces;
}

} // namespace

std::string escapedXml(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        default: out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

std::string hexColour(const InkColour& rgb) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", rgb.r, rgb.g, rgb.b);
    return text;
}

void writeSvgText(CompactText& out, const PaperText& text) {
    const TextBlock& block = text.block;
    const double share = block.align == TextAlign::left ? 0 : (block.align == TextAlign::centre ? 0.5 : 1);
    const char* const anchors[] = {"start", "middle", "end"};
    for (std::size_t line = 0; line < block.baselinesMm.size(); ++line) {
        std::vector<Piece> pieces = piecesOf(block, line);
        if (pieces.empty())
            continue;
        std::string& end = pieces.back().span.text; // a space there would be measured
        end.erase(std::find_if(end.rbegin(), end.rend(), [](char c) { return c != ' '; }).base(), end.end());
        out << "<text x=\"";
        out.number(text.atMm.x + share * block.sizeMm.x, kPlaceDecimals) << "\" y=\"";
        out.number(text.atMm.y + block.baselinesMm[line], kPlaceDecimals)
            << "\" text-anchor=\"" << anchors[static_cast<std::size_t>(block.align)] << "\" fill=\""
            << hexColour(text.rgb) << "\" xml:space=\"preserve\">";
        double baseline = block.baselinesMm[line];
        for (const Piece& piece : pieces) {
            out << "<tspan font-family=\"" << escapedXml("'" + piece.family + "', sans-serif") << "\" font-size=\"";
            out.number(piece.emMm, kSizeDecimals) << '"';
            if (piece.span.bold)
                out << " font-weight=\"bold\"";
            if (piece.span.italic)
                out << " font-style=\"italic\"";
            if (piece.baselineMm != baseline) {
                out << " dy=\"";
                out.number(piece.baselineMm - baseline, kSizeDecimals) << '"';
                baseline = piece.baselineMm;
            }
            out << '>' << escapedXml(piece.span.text) << "</tspan>";
        }
        out << "</text>\n";
    }
}

} // namespace limner
