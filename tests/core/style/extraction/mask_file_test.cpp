#include "core/style/extraction/mask_file.h"

#include "core/base/error.h"
#include "core/style/png_writing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

class MaskFile : public ::testing::Test {
  protected:
    MaskFile() : folder_(fs::temp_directory_path() / ("limner-mask-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~MaskFile() override { fs::remove_all(folder_); }

    [[nodiscard]] Mask loaded(glm::ivec2 size, const std::vector<Rgba>& pixels) const {
        writeWholeFile(folder_ / "m.png", pngBytes(size, pixels));
        return loadMask(folder_ / "m.png");
    }

    fs::path folder_;
};

TEST_F(MaskFile, WhiteCountsAndBlackAndClearDoNot) {
    const Mask mask =
        loaded({3, 2}, {{1, 1, 1, 1}, {0, 0, 0, 1}, {1, 1, 1, 0}, {0.7F, 0.7F, 0.7F, 1}, {1, 0, 0, 1}, {}});
    ASSERT_EQ(mask.width, 3);
    ASSERT_EQ(mask.height, 2);
    EXPECT_TRUE(mask.has(0, 0));
    EXPECT_FALSE(mask.has(1, 0));
    EXPECT_FALSE(mask.has(2, 0));
    EXPECT_TRUE(mask.has(0, 1));
    EXPECT_FALSE(mask.has(1, 1));
    EXPECT_FALSE(mask.has(2, 1));
    EXPECT_EQ(mask.values[0], 255);
}

TEST_F(MaskFile, AShapeOnAClearGroundCountsWhereItIsOpaque) {
    const Mask mask = loaded({2, 1}, {{0, 0, 0, 1}, {0, 0, 0, 0}});
    EXPECT_TRUE(mask.has(0, 0));
    EXPECT_FALSE(mask.has(1, 0));
    const Mask black = loaded({2, 1}, {{0, 0, 0, 1}, {0, 0, 0, 1}});
    EXPECT_FALSE(black.has(0, 0)) << "a black mask without clear parts is an empty one";
}

TEST_F(MaskFile, GreyMasksComeBackAsTheyWereWritten) {
    std::vector<std::uint8_t> values(17 * 5);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<std::uint8_t>(3 * i);
    }
    writeWholeFile(folder_ / "g.png", pngBytes({17, 5}, values));
    EXPECT_EQ(loadMask(folder_ / "g.png").values, values);
}

TEST_F(MaskFile, LargeMasksAreReducedToTheShareThatCounts) {
    constexpr int kWidth = 8200; // three to one
    std::vector<std::uint8_t> values(static_cast<std::size_t>(kWidth) * 7);
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < kWidth / 2; ++x) {
            values[static_cast<std::size_t>(y * kWidth + x)] = 255;
        }
    }
    writeWholeFile(folder_ / "g.png", pngBytes({kWidth, 7}, values));
    const Mask mask = loadMask(folder_ / "g.png");
    EXPECT_EQ(mask.width, 2734);
    EXPECT_EQ(mask.height, 3);
    ASSERT_EQ(mask.values.size(), 2734U * 3);
    for (int y = 0; y < 3; ++y) {
        EXPECT_EQ(mask.values[mask.offset(0, y)], 255) << "the last, thinner row too";
        EXPECT_EQ(mask.values[mask.offset(2733, y)], 0);
        EXPECT_NEAR(mask.values[mask.offset(1366, y)], 170, 1) << "two columns of three";
    }
}

TEST_F(MaskFile, WhatIsNoPictureIsRefused) {
    std::ofstream(folder_ / "words.png") << "words";
    std::ofstream(folder_ / "empty.png") << "";
    for (const char* name : {"words.png", "empty.png", "absent.png"}) {
        try {
            static_cast<void>(loadMask(folder_ / name));
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
        }
    }
}

} // namespace
} // namespace limner
