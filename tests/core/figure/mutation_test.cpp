#include "core/base/error.h"
#include "core/figure/figure_json.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

namespace limner {
namespace {

using Random = std::mt19937;

std::size_t below(std::size_t bound, Random& random) {
    return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
}

/// One to four changes of a text: bytes flipped, pieces cut, doubled or moved, tokens put in.
std::string mutated(std::string text, Random& random) {
    static const char* const kTokens[] = {"null", "true",    "-1",    "1e308",   "1e-400", "[]",  "{}",  "\"\"",
                                          "[[",   "\\u0000", "1e999", "-0.0",    "\"x\":", ",",   "}",   "]",
                                          "9e15", "\"2d\"",  "0.5",   "\\ud800", "\xc3",   "// ", "NaN", "65536"};
    for (std::size_t changes = 1 + below(4, random); changes > 0 && !text.empty(); --changes) {
        const std::size_t place = below(text.size(), random);
        const std::size_t length = 1 + below(40, random);
        switch (below(10, random)) {
        case 0: text[place] = static_cast<char>(below(256, random)); break;
        case 1: text.erase(place, length); break;
        case 2: text.insert(place, text.substr(below(text.size(), random), length)); break;
        case 3: text.insert(place, kTokens[below(std::size(kTokens), random)]); break;
        case 4:
        case 5:
        case 6: {
            // Another digit: most such figures are legal.
            const std::size_t digit = text.find_first_of("0123456789", place);
            if (digit != std::string::npos) {
                text[digit] = static_cast<char>('0' + below(10, random));
            }
            break;
        }
        default: {
            // In place of a value, so that the text stays JSON more often.
            const std::size_t colon = text.find(": ", place);
            const std::size_t end = colon == std::string::npos ? colon : text.find_first_of(",}]\n", colon);
            if (end != std::string::npos) {
                text.replace(colon + 2, end - colon - 2, kTokens[below(std::size(kTokens), random)]);
            }
        }
        }
    }
    return text;
}

TEST(FigureMutations, AreRefusedInOneLineOrComeBackEqual) {
    std::ifstream file(std::string(LIMNER_SOURCE_DIR) + "/tests/core/figure/example_figure.json");
    std::ostringstream original;
    original << file.rdbuf();
    constexpr int kRuns = 4000; // a second or two
    Random random(4711);
    int accepted = 0;
    int understood = 0; ///< refused for what a place in the document says
    for (int run = 0; run < kRuns; ++run) {
        const std::string text = mutated(original.str(), random);
        try {
            const Figure figure = readFigure(text, "mutant");
            ++accepted;
            EXPECT_EQ(readFigure(writeFigure(figure), "again"), figure) << text;
            validateFigure(figure);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            const std::vector<Problem> problems = validateText(text);
            ASSERT_FALSE(problems.empty());
            understood += problems.front().pointer.empty() ? 0 : 1;
        }
    }
    std::cout << kRuns << " mutants, " << accepted << " accepted, " << understood << " refused by pointer\n";
    // Else the mutants are too wild to reach what is behind the parser.
    EXPECT_GT(accepted, kRuns / 20);
    EXPECT_GT(understood, kRuns / 20);
    EXPECT_LT(accepted, kRuns);
}

} // namespace
} // namespace limner
