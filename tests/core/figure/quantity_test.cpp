#include "core/figure/quantity.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

template <typename Parse>
void expectUsage(const Parse& parse, const std::string& text) {
    try {
        parse(text, "--option");
        ADD_FAILURE() << "\"" << text << "\" was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("--option"), std::string::npos);
        EXPECT_LT(std::string(error.what()).size(), 300U);
    }
}

TEST(Quantity, BytesCountInPowersOf1024) {
    EXPECT_EQ(parseBytes("65536", ""), 65536U);
    EXPECT_EQ(parseBytes("4G", ""), std::uint64_t{4} << 30);
    EXPECT_EQ(parseBytes("1.5 GiB", ""), std::uint64_t{3} << 29);
    EXPECT_EQ(parseBytes("512mb", ""), std::uint64_t{512} << 20);
    EXPECT_EQ(parseBytes("2T", ""), std::uint64_t{2} << 40);
    for (const char* bad : {"", "G", "-1G", "0", "0.1", "4X", "4Gx", "nan", "inf", "1e400", "9e30", "4 4"}) {
        expectUsage(parseBytes, bad);
    }
}

TEST(Quantity, PixelSizesAreTwoPositiveWholeNumbers) {
    EXPECT_EQ(parsePixelSize("2126x1417", ""), glm::ivec2(2126, 1417));
    EXPECT_EQ(parsePixelSize("1X1", ""), glm::ivec2(1, 1));
    for (const char* bad : {"", "x", "10", "10x", "x10", "0x5", "5x0", "-1x5", "1.5x2", "10x10x10", "1e3x5",
                            "99999999999x1", "10 x 10"}) {
        expectUsage(parsePixelSize, bad);
    }
    expectUsage(parsePixelSize, std::string(100'000, '9'));
}

TEST(Quantity, ColoursComeInThreeWays) {
    EXPECT_EQ(parseColour("white", ""), glm::dvec4(1));
    EXPECT_EQ(parseColour("#f00", ""), glm::dvec4(1, 0, 0, 1));
    EXPECT_EQ(parseColour("#00FF00", ""), glm::dvec4(0, 1, 0, 1));
    EXPECT_EQ(parseColour("#00000033", ""), glm::dvec4(0, 0, 0, 0.2));
    EXPECT_EQ(parseColour("0.25, 0.5,1", ""), glm::dvec4(0.25, 0.5, 1, 1));
    EXPECT_EQ(parseColour("0,0,0,0", ""), glm::dvec4(0));
    for (const char* bad :
         {"", "#", "#12", "#12345", "#gggggg", "1,1", "1,1,1,1,1", "2,0,0", "-1,0,0", "nan,0,0", "1,1,1,", "blu"}) {
        expectUsage(parseColour, bad);
    }
}

TEST(Quantity, BytesAreShownInTheirUnit) {
    EXPECT_EQ(formatBytes(812), "812 bytes");
    EXPECT_EQ(formatBytes(1536), "1.5 KiB");
    EXPECT_EQ(formatBytes(std::uint64_t{4} << 30), "4.0 GiB");
}

} // namespace
} // namespace limner
