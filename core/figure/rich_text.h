#pragma once

#include <string>
#include <vector>

namespace limner {

enum class Script { normal, sub, super };

/// A part of a line that looks the same throughout.
struct TextSpan {
    std::string text; ///< UTF-8
    bool bold = false;
    bool italic = false;
    Script script = Script::normal;
    friend bool operator==(const TextSpan&, const TextSpan&) = default;
};

using TextLine = std::vector<TextSpan>;

/// Lines of a text with markup: <b>, <i>, <sub>, <sup> with their ends, <br> or a line break. All else is text as it
/// stands, a tag without its other half included: nothing is ever lost and no text is an error. Never without a line.
std::vector<TextLine> parseRichText(const std::string& text);

/// The words alone, on one line: for lists, tool tips and readers of screens.
std::string plainText(const std::string& text);

} // namespace limner
