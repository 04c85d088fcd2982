#include "core/figure/rich_text.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace limner {
namespace {

constexpr std::array<std::string_view, 4> kTags{"b", "i", "sub", "sup"};

struct Token {
    std::string_view text; ///< as it stands
    std::size_t tag = 0;
    enum class Kind { text, open, close, lineEnd } kind = Kind::text;
};

/// The token that begins with the text's first character.
Token nextToken(std::string_view text) {
    if (text.front() == '\n') {
        return {text.substr(0, 1), 0, Token::Kind::lineEnd};
    }
    const auto starts = [&](const std::string& tag) { return text.substr(0, tag.size()) == tag; };
    if (starts("<br>")) {
        return {text.substr(0, 4), 0, Token::Kind::lineEnd};
    }
    for (std::size_t tag = 0; tag < kTags.size(); ++tag) {
        const std::string name(kTags[tag]);
        if (starts("<" + name + ">")) {
            return {text.substr(0, name.size() + 2), tag, Token::Kind::open};
        }
        if (starts("</" + name + ">")) {
            return {text.substr(0, name.size() + 3), tag, Token::Kind::close};
        }
    }
    const std::size_t end = text.find_first_of("<\n", 1);
    return {text.substr(0, end), 0, Token::Kind::text};
}

/// Tags without their other half become text.
std::vector<Token> tokensOf(std::string_view text) {
    std::vector<Token> tokens;
    std::vector<std::size_t> open;
    while (!text.empty()) {
        Token token = nextToken(text);
        text.remove_prefix(token.text.size());
        if (token.kind == Token::Kind::open) {
            open.push_back(tokens.size());
        } else if (token.kind == Token::Kind::close) {
            if (!open.empty() && tokens[open.back()].tag == token.tag) {
                open.pop_back();
            } else {
                token.kind = Token::Kind::text;
            }
        }
        tokens.push_back(token);
    }
    for (const std::size_t index : open) {
        tokens[index].kind = Token::Kind::text;
    }
    return tokens;
}

void append(TextLine& line, TextSpan look, std::string_view text) {
    if (!line.empty()) {
        TextSpan& last = line.back();
        look.text = last.text;
        if (look == last) {
            last.text += text;
            return;
        }
    }
    look.text = text;
    line.push_back(look);
}

} // namespace

std::vector<TextLine> parseRichText(const std::string& text) {
    std::vector<TextLine> lines(1);
    std::vector<TextSpan> looks(1);
    for (const Token& token : tokensOf(text)) {
        switch (token.kind) {
        case Token::Kind::text: append(lines.back(), looks.back(), token.text); break;
        case Token::Kind::lineEnd: lines.emplace_back(); break;
        case Token::Kind::close: looks.pop_back(); break;
        case Token::Kind::open: {
            TextSpan look = looks.back();
            switch (token.tag) {
            case 0: look.bold = true; break;
            case 1: look.italic = true; break;
            case 2: look.script = Script::sub; break;
            default: look.script = Script::super; break;
            }
            looks.push_back(look);
        }
        }
    }
    return lines;
}

std::string plainText(const std::string& text) {
    std::string out;
    for (const TextLine& line : parseRichText(text)) {
        if (!out.empty()) {
            out += ' ';
        }
        for (const TextSpan& span : line) {
            out += span.text;
        }
    }
    return out;
}

} // namespace limner
