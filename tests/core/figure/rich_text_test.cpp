#include "core/figure/rich_text.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

TEST(RichText, MarksPartsOfALine) {
    const auto lines = parseRichText("T<sub>2</sub> of <b>α <i>β</i></b>");
    ASSERT_EQ(lines.size(), 1U);
    const TextLine wanted{{"T", false, false, Script::normal},
                          {"2", false, false, Script::sub},
                          {" of ", false, false, Script::normal},
                          {"α ", true, false, Script::normal},
                          {"β", true, true, Script::normal}};
    EXPECT_EQ(lines[0], wanted);
}

TEST(RichText, BreaksLines) {
    const auto lines = parseRichText("a<br>b\nc<sup>x\ny</sup>");
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[3][0], (TextSpan{"y", false, false, Script::super}));
    EXPECT_EQ(parseRichText("").size(), 1U);
    EXPECT_EQ(plainText("Os <i>temporale</i><br>pars petrosa"), "Os temporale pars petrosa");
}

TEST(RichText, ShowsBrokenTagsAsText) {
    for (const char* text : {"a < b", "<b>open", "close</b>", "<i", "<>", "</", "<u>x</u>", "<b >x", "<B>x</B>", "<"}) {
        const auto lines = parseRichText(text);
        ASSERT_EQ(lines.size(), 1U) << text;
        ASSERT_EQ(lines[0].size(), 1U) << text;
        EXPECT_EQ(lines[0][0], (TextSpan{text})) << text;
    }
    // Halves that cross: the one that closes what is open last counts.
    const auto lines = parseRichText("<b>x<i>y</b>z</i>");
    EXPECT_EQ(plainText("<b>x<i>y</b>z</i>"), "<b>xy</b>z");
    EXPECT_TRUE(lines[0][1].italic);
}

} // namespace
} // namespace limner
