#include "core/style/slug.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace limner {
namespace {

constexpr std::size_t kLongestSlug = 60;
constexpr std::size_t kLongestName = 200;

/// Plain letters of U+00C0 to U+017F, in order.
constexpr char kPlainLetters[] = "aaaaaaaceeeeiiiidnooooo-ouuuuytsaaaaaaaceeeeiiiidnooooo-ouuuuyty"
                                 "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"
                                 "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
static_assert(sizeof kPlainLetters == 0x180 - 0xC0 + 1, "a letter for each code point");

constexpr std::uint32_t kNoCharacter = 0xFFFD;

/// The character that starts at `at`, which moves past it; anything that is no UTF-8 counts byte by byte.
std::uint32_t nextCharacter(const std::string& text, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::uint32_t first = byte(at++);
    if (first < 0x80) {
        return first;
    }
    const int more = first >= 0xF0 ? 3 : (first >= 0xE0 ? 2 : 1);
    if (first < 0xC2 || first > 0xF4 || at + static_cast<std::size_t>(more) > text.size()) {
        return kNoCharacter;
    }
    std::uint32_t code = first & (0x3FU >> static_cast<unsigned>(more));
    for (int i = 0; i < more; ++i) {
        const std::uint32_t next = byte(at + static_cast<std::size_t>(i));
        if ((next & 0xC0U) != 0x80U) {
            return kNoCharacter;
        }
        code = code << 6U | (next & 0x3FU);
    }
    at += static_cast<std::size_t>(more);
    return code;
}

/// 0: the character goes without a trace; '-': it parts words.
char plainLetter(std::uint32_t code) {
    if (code >= 'A' && code <= 'Z') {
        return static_cast<char>(code - 'A' + 'a');
    }
    if ((code >= 'a' && code <= 'z') || (code >= '0' && code <= '9')) {
        return static_cast<char>(code);
    }
    if (code >= 0xC0 && code < 0x180) {
        return kPlainLetters[code - 0xC0];
    }
    const bool mark = code >= 0x300 && code < 0x370; // of a letter that came before it, as some systems write names
    return mark ? '\0' : '-';
}

} // namespace

std::string slugOf(const std::string& name) {
    std::string slug;
    for (std::size_t at = 0; at < name.size() && slug.size() < kLongestSlug;) {
        const char letter = plainLetter(nextCharacter(name, at));
        const bool parts = letter == '-' && (slug.empty() || slug.back() == '-');
        if (letter != '\0' && !parts) {
            slug += letter;
        }
    }
    while (!slug.empty() && slug.back() == '-') {
        slug.pop_back();
    }
    return slug.empty() ? "style" : slug;
}

std::string numbered(const std::string& word, const char* gap, const std::function<bool(const std::string&)>& taken) {
    std::string result = word;
    for (int n = 2; taken(result); ++n) {
        result = word + gap + std::to_string(n);
    }
    return result;
}

std::string tidyName(const std::string& name) {
    std::string tidy;
    for (std::size_t at = 0; at < name.size();) {
        const std::size_t start = at;
        const std::uint32_t code = nextCharacter(name, at);
        if (tidy.size() + (at - start) > kLongestName) {
            break;
        }
        const bool space = code <= ' ' || (code >= 0x7F && code <= 0xA0) || code == kNoCharacter;
        if (!space) {
            tidy.append(name, start, at - start);
        } else if (!tidy.empty() && tidy.back() != ' ') {
            tidy += ' ';
        }
    }
    while (!tidy.empty() && tidy.back() == ' ') {
        tidy.pop_back();
    }
    return tidy;
}

} // namespace limner
