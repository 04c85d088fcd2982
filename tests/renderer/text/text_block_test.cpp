#include "renderer/text/text_block.h"

#include <gtest/gtest.h>

#include <freetype/freetype.h>

#include <algorithm>

namespace limner {
namespace {

constexpr double kMmPerPoint = 25.4 / 72;

TextBlock set(const std::string& text, double sizePt = 10) {
    TextStyle style;
    style.sizePt = sizePt;
    return setText(text, style);
}

/// The advances of letters without kerning, in ems, as FreeType reads them from the file.
double advanceOf(const FontFace& face, const std::u32string& letters) {
    FT_Library library = nullptr;
    FT_Face file = nullptr;
    EXPECT_EQ(FT_Init_FreeType(&library), 0);
    EXPECT_EQ(FT_New_Face(library, face.source().file.c_str(), face.source().index, &file), 0);
    double sum = 0;
    for (const char32_t letter : letters) {
        EXPECT_EQ(FT_Load_Char(file, letter, FT_LOAD_NO_SCALE), 0);
        sum += static_cast<double>(file->glyph->metrics.horiAdvance) / file->units_per_EM;
    }
    FT_Done_Face(file);
    FT_Done_FreeType(library);
    return sum;
}

TEST(TextBlock, IsAsWideAsItsLettersAre) {
    const TextBlock block = set("Humerus μηρός");
    ASSERT_FALSE(block.runs.empty());
    EXPECT_EQ(block.runs[0].face->source().family, "DejaVu Sans");
    // No pair of these letters is kerned in DejaVu Sans.
    EXPECT_NEAR(block.sizeMm.x, advanceOf(*block.runs[0].face, U"Humerus μηρός") * 10 * kMmPerPoint, 1e-6);
    EXPECT_NEAR(set("Humerus μηρός", 20).sizeMm.x, 2 * block.sizeMm.x, 1e-9);
}

TEST(TextBlock, KernsAndJoinsWhatTheFontWantsJoined) {
    const TextBlock pair = set("AV");
    EXPECT_LT(pair.sizeMm.x, set("A").sizeMm.x + set("V").sizeMm.x - 1e-6);
    const TextBlock accent = set("e\u0301"); // one letter in two characters
    EXPECT_NEAR(accent.sizeMm.x, set("e").sizeMm.x, 1e-9);
}

TEST(TextBlock, FindsLettersThatTheFamilyLacks) {
    TextStyle style;
    style.family = "DejaVu Sans Mono";
    const TextBlock block = setText("ab", style);
    EXPECT_EQ(block.runs[0].face->source().family, "DejaVu Sans Mono");
    style.family = "No such family";
    EXPECT_EQ(setText("ab", style).runs[0].face->source().family, "DejaVu Sans");
    // A letter of no installed font leaves the text whole: it is drawn as an empty box.
    const TextBlock unknown = set("a\U0010FFFDb");
    EXPECT_EQ(unknown.runs[0].glyphs.size(), 3U);
}

TEST(TextBlock, SetsScriptsSmallAndBeside) {
    const TextBlock block = set("H<sub>2</sub>O<sup>+</sup>");
    ASSERT_EQ(block.runs.size(), 4U);
    EXPECT_LT(block.runs[1].emMm, block.runs[0].emMm);
    EXPECT_GT(block.runs[1].originMm.y, block.runs[0].originMm.y) << "down";
    EXPECT_LT(block.runs[3].originMm.y, block.runs[0].originMm.y) << "up";
    EXPECT_NEAR(block.runs[2].originMm.x, block.runs[0].advanceMm + block.runs[1].advanceMm, 1e-9);
}

TEST(TextBlock, UsesBoldFacesAndLeansWhatHasNoItalicOne) {
    const TextBlock block = set("<b>bold</b> <i>italic</i>");
    EXPECT_TRUE(block.runs[0].face->source().bold);
    const auto italic =
        std::find_if(block.runs.begin(), block.runs.end(), [](const TextRun& r) { return r.span.italic; });
    ASSERT_NE(italic, block.runs.end());
    const FontFace::Source& source = italic->face->source();
    EXPECT_TRUE(source.slanted || source.file.find("blique") != std::string::npos) << source.file;
}

TEST(TextBlock, BreaksLinesBetweenWords) {
    TextStyle style;
    style.sizePt = 10;
    style.wrapMm = 30;
    const TextBlock block = setText("The lateral pterygoid muscle and its two heads, seen from the left side", style);
    EXPECT_GE(block.baselinesMm.size(), 4U);
    EXPECT_LE(block.sizeMm.x, 30);
    std::string all;
    for (const TextRun& run : block.runs) {
        all += run.span.text;
    }
    EXPECT_EQ(all, "The lateral pterygoid muscle and its two heads, seen from the left side") << "nothing is lost";
    style.wrapMm = 1; // no word fits: a word a line
    EXPECT_EQ(setText("one two", style).baselinesMm.size(), 2U);
}

TEST(TextBlock, AlignsItsLines) {
    TextStyle style;
    const TextBlock left = setText("m\nmmm", style);
    style.align = TextAlign::right;
    const TextBlock right = setText("m\nmmm", style);
    style.align = TextAlign::centre;
    const TextBlock centre = setText("m\nmmm", style);
    EXPECT_EQ(left.runs[0].originMm.x, 0);
    EXPECT_NEAR(right.runs[0].originMm.x, left.sizeMm.x * 2 / 3, 1e-9);
    EXPECT_NEAR(centre.runs[0].originMm.x, left.sizeMm.x / 3, 1e-9);
    EXPECT_EQ(left.sizeMm, right.sizeMm);
}

TEST(TextBlock, OfNothingIsEmpty) {
    EXPECT_TRUE(set("").runs.empty());
    EXPECT_EQ(set("").sizeMm, glm::dvec2(0));
    EXPECT_EQ(set("a\n\nb").baselinesMm.size(), 3U) << "an empty line between";
    EXPECT_FALSE(set("\xFF\xFE damaged").runs.empty());
}

TEST(FontFace, EmbedsTheGlyphsInUseOnly) {
    const FontFace& face = fontFor({});
    const auto glyphs = face.shape("βα");
    ASSERT_EQ(glyphs.size(), 2U);
    const std::vector<std::uint32_t> some{glyphs[0].id, glyphs[1].id};
    const std::string bytes = face.subset(some);
    EXPECT_GT(bytes.size(), 1000U);
    EXPECT_LT(bytes.size(), 60000U) << "the whole is 750 kB";
    EXPECT_FALSE(face.outline(glyphs[0].id).steps.empty());
    EXPECT_TRUE(face.outline(face.shape(" ")[0].id).steps.empty());
}

TEST(FontShelf, NamesWhatIsInstalled) {
    const std::vector<std::string> families = fontFamilies();
    EXPECT_TRUE(std::is_sorted(families.begin(), families.end()));
    EXPECT_NE(std::find(families.begin(), families.end(), kDefaultFamily), families.end());
}

} // namespace
} // namespace limner
