#include "core/style/slug.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace limner {
namespace {

bool isSlug(const std::string& slug) {
    const bool letters = slug.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
    return letters && !slug.empty() && slug.size() <= 60 && slug.front() != '-' && slug.back() != '-' &&
           slug.find("--") == std::string::npos;
}

TEST(Slug, NamesBecomeReadableIds) {
    EXPECT_EQ(slugOf("Ivory bone"), "ivory-bone");
    EXPECT_EQ(slugOf("  Dürer's ochre (No. 2) "), "durer-s-ochre-no-2");
    EXPECT_EQ(slugOf("Žluťoučký kůň"), "zlutoucky-kun");
    EXPECT_EQ(slugOf("Du\u0308rer"), "durer") << "a letter and its mark apart, as some systems write names";
    EXPECT_EQ(slugOf("Ångström_№5"), "angstrom-5");
    EXPECT_EQ(slugOf("象牙"), "style");
    EXPECT_EQ(slugOf("象牙 ivory"), "ivory");
    EXPECT_EQ(slugOf(""), "style");
    EXPECT_EQ(slugOf("../../etc/passwd"), "etc-passwd");
    EXPECT_EQ(slugOf(std::string("a\0b", 3)), "a-b");
    EXPECT_EQ(slugOf("\xff\xfe"
                     "x\xc3"),
              "x");
}

TEST(Slug, AnyBytesGiveALegalIdAndALegalName) {
    std::mt19937 random(11);
    for (int i = 0; i < 3000; ++i) {
        std::string name;
        const std::size_t length = random() % 300;
        for (std::size_t k = 0; k < length; ++k) {
            name += static_cast<char>(random() % 256);
        }
        EXPECT_TRUE(isSlug(slugOf(name)));
        const std::string tidy = tidyName(name);
        EXPECT_LE(tidy.size(), 200U);
        EXPECT_EQ(tidyName(tidy), tidy);
        for (const char c : tidy) {
            EXPECT_GE(static_cast<unsigned char>(c), ' ');
        }
    }
    EXPECT_EQ(slugOf(std::string(59, 'a') + " b"), std::string(59, 'a')) << "no hyphen where it is cut";
}

TEST(Slug, NumbersStartAtTwoAndTakeTheFirstFreeOne) {
    const std::set<std::string> taken{"ivory", "ivory-2", "ivory-4"};
    const auto isTaken = [&](const std::string& word) { return taken.contains(word); };
    EXPECT_EQ(numbered("ivory", "-", isTaken), "ivory-3");
    EXPECT_EQ(numbered("ink", "-", isTaken), "ink");
}

TEST(Slug, NamesAreOneLineOfWholeCharacters) {
    EXPECT_EQ(tidyName(" red\n clay\t"), "red clay");
    EXPECT_EQ(tidyName("\x1b[31mred"), "[31mred");
    EXPECT_EQ(tidyName(std::string(199, 'a') + "é"), std::string(199, 'a')) << "half a character would be left";
}

} // namespace
} // namespace limner
