#include "core/base/error.h"
#include "core/style/lit_sphere.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace limner {
namespace {

namespace fs = std::filesystem;

void appendBigEndian(std::string& out, std::uint32_t value, int bytes) {
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) {
        out.push_back(static_cast<char>(value >> static_cast<unsigned>(shift)));
    }
}

void appendChunk(std::string& out, const std::string& kind, const std::string& data) {
    appendBigEndian(out, static_cast<std::uint32_t>(data.size()), 4);
    const std::string body = kind + data;
    out += body;
    appendBigEndian(out,
                    static_cast<std::uint32_t>(
                        crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()))),
                    4);
}

struct Png {
    int width = 8;
    int height = 8;
    int bits = 8;
    int colourType = 2; ///< 0 grey, 2 RGB, 4 grey and alpha, 6 RGBA
    std::vector<std::uint32_t> texel;
};

/// A PNG with the same texel everywhere, written by hand: the reader under test has no part in it.
std::string pngOf(const Png& png) {
    std::string out = "\x89PNG\r\n\x1a\n";
    std::string header;
    appendBigEndian(header, static_cast<std::uint32_t>(png.width), 4);
    appendBigEndian(header, static_cast<std::uint32_t>(png.height), 4);
    header += {static_cast<char>(png.bits), static_cast<char>(png.colourType), 0, 0, 0};
    appendChunk(out, "IHDR", header);
    std::string rows;
    for (int y = 0; y < std::min(png.height, 64); ++y) {
        rows.push_back(0);
        for (int x = 0; x < std::min(png.width, 64); ++x) {
            for (const std::uint32_t value : png.texel) {
                appendBigEndian(rows, value, png.bits / 8);
            }
        }
    }
    std::string packed(compressBound(static_cast<uLong>(rows.size())), '\0');
    uLongf length = static_cast<uLongf>(packed.size());
    compress(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(rows.data()),
             static_cast<uLong>(rows.size()));
    packed.resize(length);
    appendChunk(out, "IDAT", packed);
    appendChunk(out, "IEND", "");
    return out;
}

class StyleFile : public ::testing::Test {
  protected:
    StyleFile() : folder_(fs::temp_directory_path() / ("limner-style-" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
    }
    ~StyleFile() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, const std::string& contents) {
        std::ofstream(folder_ / name, std::ios::binary) << contents;
        return folder_ / name;
    }
    /// Message of the error that reading gives.
    std::string failureOf(const fs::path& file) {
        try {
            loadStyle(file);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            return error.what();
        }
        return "read without complaint";
    }

    fs::path folder_;
};

TEST_F(StyleFile, EveryLayoutOfChannelsAndBits) {
    struct Case {
        Png png;
        Rgba wanted;
    };
    const std::vector<Case> cases{
        {{8, 8, 8, 0, {51}}, {0.2F, 0.2F, 0.2F, 1}},
        {{8, 8, 16, 0, {13107}}, {0.2F, 0.2F, 0.2F, 1}},
        {{8, 8, 8, 2, {51, 102, 153}}, {0.2F, 0.4F, 0.6F, 1}},
        {{8, 8, 16, 2, {13107, 26214, 39321}}, {0.2F, 0.4F, 0.6F, 1}},
        {{8, 8, 8, 4, {51, 102}}, {0.2F, 0.2F, 0.2F, 0.4F}},
        {{8, 8, 16, 6, {13107, 26214, 39321, 6554}}, {0.2F, 0.4F, 0.6F, 6554 / 65535.0F}},
        {{8, 8, 8, 6, {51, 102, 153, 0}}, {0.2F, 0.4F, 0.6F, 0}}, // clear texels keep their colour
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Style style = loadStyle(write("case" + std::to_string(i) + ".png", pngOf(cases[i].png)));
        const Rgba got = style.sphere->at(0, 0);
        EXPECT_NEAR(got.r, cases[i].wanted.r, 1e-6) << i;
        EXPECT_NEAR(got.g, cases[i].wanted.g, 1e-6) << i;
        EXPECT_NEAR(got.b, cases[i].wanted.b, 1e-6) << i;
        EXPECT_NEAR(got.a, cases[i].wanted.a, 1e-6) << i;
        EXPECT_EQ(style.card.id, "case" + std::to_string(i));
        EXPECT_EQ(style.sphere->hasDirectionalOpacity(), cases[i].wanted.a < 1) << i;
    }
}

TEST_F(StyleFile, LinearPicturesAreEncoded) {
    // Radiance: mantissas and a shared exponent, linear light. Rows of 4 texels are stored plainly.
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 4\n";
    for (int i = 0; i < 4 * 4; ++i) {
        hdr += {'\x80', '\x80', '\x80', '\x80'}; // 128 / 256 * 2^(128 - 128) = 0.5
    }
    const Style style = loadStyle(write("linear.hdr", hdr));
    EXPECT_NEAR(style.sphere->at(0, 0).g, 0.735357, 1e-5); // sRGB encoding of 0.5
}

TEST_F(StyleFile, TheCardBesideThePicture) {
    const fs::path picture = write("ball.png", pngOf({8, 8, 8, 0, {51}}));
    write("ball.json", R"({"id": "my-ball", "name": "My ball", "tags": ["bone"], "origin": "o", "credit": "c",
                           "licence": "l", "more": 1})");
    const StyleCard card = loadStyle(picture).card;
    EXPECT_EQ(card.id, "my-ball");
    EXPECT_EQ(card.name, "My ball");
    EXPECT_EQ(card.tags, std::vector<std::string>{"bone"});
    EXPECT_EQ(card.origin + card.credit + card.licence, "ocl");
    for (const char* broken : {"{", "[]", R"({"id": 3})", R"({"tags": "bone"})", "null", ""}) {
        write("ball.json", broken);
        EXPECT_NE(failureOf(picture).find("ball.json"), std::string::npos) << broken;
    }
}

TEST_F(StyleFile, WhatIsNoStyleIsRefusedInOneLine) {
    EXPECT_NE(failureOf(folder_ / "none.png").find("no such file"), std::string::npos);
    EXPECT_NE(failureOf(write("text.png", "not a picture")).find("cannot read the style"), std::string::npos);
    EXPECT_NE(failureOf(write("empty.png", "")).find("cannot read the style"), std::string::npos);
    EXPECT_NE(failureOf(write("wide.png", pngOf({16, 8, 8, 0, {51}}))).find("not square"), std::string::npos);
    EXPECT_NE(failureOf(write("small.png", pngOf({3, 3, 8, 0, {51}}))).find("out of range"), std::string::npos);
    EXPECT_NE(failureOf(write("vast.png", pngOf({9000, 9000, 8, 0, {51}}))).find("out of range"), std::string::npos);
    EXPECT_NE(failureOf(write("lying.png", pngOf({4096, 4096, 16, 6, {1, 2, 3, 4}}))).find("lying.png"),
              std::string::npos);
#ifdef __SANITIZE_ADDRESS__
    // OpenImageIO's PNG reader leaves a failed read by longjmp, past the destructor of its message: not our leak.
    const __lsan::ScopedDisabler notOurs;
#endif
    std::string cut = pngOf({64, 64, 16, 6, {1, 2, 3, 4}});
    cut.resize(60);
    EXPECT_NE(failureOf(write("cut.png", cut)).find("cut.png"), std::string::npos);
}

} // namespace
} // namespace limner
