#include "core/style/picture_rows.h"

#include "core/base/error.h"
#include "core/project/archive.h"
#include "support/hand_written_pictures.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::HandWritten;

std::string bytesOf(cmsHPROFILE profile) {
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    std::string bytes(size, '\0');
    cmsSaveProfileToMem(profile, bytes.data(), &size);
    cmsCloseProfile(profile);
    return bytes;
}

std::string srgbProfile() { return bytesOf(cmsCreate_sRGBProfile()); }

constexpr double kAdobeGamma = 2.19921875;

std::string adobeRgbProfile() {
    const cmsCIExyY white{0.3127, 0.3290, 1};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1}, {0.21, 0.71, 1}, {0.15, 0.06, 1}};
    cmsToneCurve* curve = cmsBuildGamma(nullptr, kAdobeGamma);
    cmsToneCurve* curves[] = {curve, curve, curve};
    const cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves);
    cmsFreeToneCurve(curve);
    return bytesOf(profile);
}

std::string linearGreyProfile() {
    cmsToneCurve* curve = cmsBuildGamma(nullptr, 1);
    const cmsHPROFILE profile = cmsCreateGrayProfile(cmsD50_xyY(), curve);
    cmsFreeToneCurve(curve);
    return bytesOf(profile);
}

/// L*a*b* of inks that lie fully on the paper or not at all.
std::array<double, 3> inkLab(bool c, bool m, bool y, bool k) {
    const double light = (c ? 0.6 : 1.0) * (m ? 0.5 : 1.0) * (y ? 0.9 : 1.0) * (k ? 0.2 : 1.0);
    const bool all = c && m && y && k; // as black as it gets, so that nothing need be done about black
    return {all ? 0 : 100 * light, k ? 0 : (m ? 40.0 : 0) - (c ? 30.0 : 0), k ? 0 : (y ? 50.0 : 0) - (c ? 30.0 : 0)};
}

/// A press of our own: between the corners of the inks' cube, linear in L*a*b*.
std::string pressProfile() {
    const cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
    cmsSetProfileVersion(profile, 4.3);
    cmsSetDeviceClass(profile, cmsSigOutputClass);
    cmsSetColorSpace(profile, cmsSigCmykData);
    cmsSetPCS(profile, cmsSigLabData);
    cmsPipeline* pipeline = cmsPipelineAlloc(nullptr, 4, 3);
    cmsStage* table = cmsStageAllocCLut16bit(nullptr, 2, 4, 3, nullptr);
    const auto sampler = [](const cmsUInt16Number* in, cmsUInt16Number* out, void*) -> cmsInt32Number {
        const auto lab = inkLab(in[0] > 0, in[1] > 0, in[2] > 0, in[3] > 0);
        const cmsCIELab value{lab[0], lab[1], lab[2]};
        cmsFloat2LabEncoded(out, &value);
        return 1;
    };
    cmsStageSampleCLut16bit(table, sampler, nullptr, 0);
    // The format wants curves on both sides of a table.
    cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, 4, nullptr));
    cmsPipelineInsertStage(pipeline, cmsAT_END, table);
    cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, 3, nullptr));
    cmsWriteTag(profile, cmsSigAToB0Tag, pipeline);
    cmsPipelineFree(pipeline);
    cmsWriteTag(profile, cmsSigMediaWhitePointTag, cmsD50_XYZ());
    return bytesOf(profile);
}

double encode(double linear) {
    linear = std::clamp(linear, 0.0, 1.0);
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// By the two standards' formulas.
Rgba adobeToSrgb(const Rgba& adobe) {
    const double r = std::pow(adobe.r, kAdobeGamma);
    const double g = std::pow(adobe.g, kAdobeGamma);
    const double b = std::pow(adobe.b, kAdobeGamma);
    const auto narrow = [](double value) { return static_cast<float>(encode(value)); };
    return {narrow(1.398356 * r - 0.398356 * g), narrow(g), narrow(-0.042931 * g + 1.042931 * b), adobe.a};
}

/// L*a*b* (D50) to sRGB, by the formulas and the usual matrix (Bradford).
Rgba labToSrgb(const std::array<double, 3>& lab) {
    const auto inverse = [](double t) { return t > 6.0 / 29 ? t * t * t : 3 * 36.0 / 841 * (t - 4.0 / 29); };
    const double y = (lab[0] + 16) / 116;
    const double X = 0.9642 * inverse(y + lab[1] / 500);
    const double Y = inverse(y);
    const double Z = 0.8249 * inverse(y - lab[2] / 200);
    return {static_cast<float>(encode(3.1338561 * X - 1.6168667 * Y - 0.4906146 * Z)),
            static_cast<float>(encode(-0.9787684 * X + 1.9161415 * Y + 0.0334540 * Z)),
            static_cast<float>(encode(0.0719453 * X - 0.2289914 * Y + 1.4052427 * Z))};
}

void expectNear(const Rgba& got, const Rgba& expected, double most, const std::string& what) {
    EXPECT_NEAR(got.r, expected.r, most) << what;
    EXPECT_NEAR(got.g, expected.g, most) << what;
    EXPECT_NEAR(got.b, expected.b, most) << what;
    EXPECT_NEAR(got.a, expected.a, 1e-6) << what;
}

std::vector<Rgba> readAll(const fs::path& file) {
    PictureRows rows(file, {"cannot read it", "use another"});
    std::vector<Rgba> pixels;
    for (int y = 0; y < rows.height(); y += rows.bandRows()) {
        const auto band = rows.read(y);
        pixels.insert(pixels.end(), band.begin(), band.end());
    }
    return pixels;
}

std::string refusal(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        const std::string line = error.what();
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        return line;
    }
    ADD_FAILURE() << "was taken";
    return {};
}

/// Colours that both spaces hold, a hundred of them, in steps of 8 bits.
std::vector<Rgba> someColours() {
    std::vector<Rgba> colours;
    for (int i = 0; i < 100; ++i) {
        const auto step = [](double value) { return static_cast<float>(std::round(255 * value) / 255); };
        colours.push_back({step(0.35 + 0.3 * std::sin(i)), step(0.5 + 0.2 * std::sin(2.1 * i)),
                           step(0.4 + 0.25 * std::sin(0.7 * i)), step(i % 4 == 0 ? 0.5 : 1)});
    }
    return colours;
}

class PictureRowsTest : public ::testing::Test {
  protected:
    [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }

    [[nodiscard]] fs::path write(const std::string& name, const std::vector<Rgba>& pixels, OIIO::TypeDesc type,
                                 const std::string& profile, int channels = 4) const {
        OIIO::ImageSpec spec(static_cast<int>(pixels.size()) / 10, 10, channels, type);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        if (!profile.empty()) {
            spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                           profile.data());
        }
        std::vector<float> samples;
        for (const Rgba& p : pixels) {
            const float all[] = {p.r, p.g, p.b, p.a};
            samples.insert(samples.end(), all, all + channels);
        }
        const std::string file = path(name).string();
        const auto output = OIIO::ImageOutput::create(file);
        EXPECT_TRUE(output && output->open(file, spec) && output->write_image(OIIO::TypeDesc::FLOAT, samples.data()) &&
                    output->close());
        return file;
    }

    TemporaryFolder folder_;
};

TEST_F(PictureRowsTest, UntaggedAndSrgbPicturesComeAsTheyAre) {
    const std::vector<Rgba> colours = someColours();
    for (const char* name : {"a.png", "a.tif"}) {
        for (const OIIO::TypeDesc& type :
             {OIIO::TypeDesc(OIIO::TypeDesc::UINT8), OIIO::TypeDesc(OIIO::TypeDesc::UINT16)}) {
            const auto plain = readAll(write(name, colours, type, ""));
            EXPECT_EQ(readAll(write(name, colours, type, srgbProfile())), plain) << "to the last bit";
            for (std::size_t i = 0; i < colours.size(); ++i) {
                expectNear(plain[i], colours[i], 1e-6, name);
            }
        }
    }
}

TEST_F(PictureRowsTest, AProfileIsFollowed) {
    const std::vector<Rgba> colours = someColours();
    const struct {
        const char* name;
        OIIO::TypeDesc type;
        double most;
    } cases[] = {{"a.png", OIIO::TypeDesc::UINT8, 2e-3},
                 {"a.tif", OIIO::TypeDesc::UINT8, 2e-3},
                 {"b.png", OIIO::TypeDesc::UINT16, 5e-4},
                 {"b.tif", OIIO::TypeDesc::UINT16, 5e-4},
                 {"c.tif", OIIO::TypeDesc::FLOAT, 5e-4}};
    for (const auto& one : cases) {
        const auto got = readAll(write(one.name, colours, one.type, adobeRgbProfile()));
        ASSERT_EQ(got.size(), colours.size());
        for (std::size_t i = 0; i < colours.size(); ++i) {
            expectNear(got[i], adobeToSrgb(colours[i]), one.most, one.name + std::to_string(i));
        }
    }
    // A JPEG's own loss is larger than a profile's effect on some colours; one flat colour has none.
    const auto jpeg = readAll(
        write("a.jpg", std::vector<Rgba>(100, Rgba{0.2F, 0.8F, 0.4F}), OIIO::TypeDesc::UINT8, adobeRgbProfile(), 3));
    expectNear(jpeg[50], adobeToSrgb({0.2F, 0.8F, 0.4F}), 0.01, "a.jpg");
}

TEST_F(PictureRowsTest, GreyHasProfilesToo) {
    const HandWritten grey{4, 4, 16, 1, std::vector<std::uint32_t>(16, 14000), linearGreyProfile()};
    const auto got = readAll(testing::writeBytes(path("grey.tif"), testing::tiffOf(grey, 1)));
    const auto expected = static_cast<float>(encode(14000 / 65535.0));
    expectNear(got[5], {expected, expected, expected}, 1e-3, "grey");
}

TEST_F(PictureRowsTest, DamagedAndForeignProfilesAreLeftAside) {
    const std::vector<Rgba> colours = someColours();
    const auto plain = readAll(write("a.tif", colours, OIIO::TypeDesc::UINT8, ""));
    std::string damaged = adobeRgbProfile();
    damaged.resize(damaged.size() / 3);
    for (const std::string& profile : {damaged, std::string(300, 'x'), linearGreyProfile(), pressProfile()}) {
        EXPECT_EQ(readAll(write("a.tif", colours, OIIO::TypeDesc::UINT8, profile)), plain);
    }
}

/// Every corner of the inks' cube, as 8- or 16-bit samples of a picture of 4 x 4 pixels.
HandWritten inkCorners(int bits, bool upsideDown) {
    HandWritten inks{4, 4, bits, 4, {}};
    const std::uint32_t full = bits == 8 ? 255 : 65535;
    for (unsigned i = 0; i < 16; ++i) {
        for (unsigned c = 0; c < 4; ++c) {
            const bool on = (i >> c & 1U) != 0;
            inks.samples.push_back(on != upsideDown ? full : 0);
        }
    }
    return inks;
}

TEST_F(PictureRowsTest, InksWithoutAProfileTakeAwayWhatTheyCover) {
    const auto check = [](const std::vector<Rgba>& got, const std::string& what) {
        ASSERT_EQ(got.size(), 16U) << what;
        for (unsigned i = 0; i < 16; ++i) {
            const auto left = [&](unsigned c) { return (i >> c & 1U) != 0 || (i >> 3U & 1U) != 0 ? 0.0F : 1.0F; };
            expectNear(got[i], {left(0), left(1), left(2)}, 1e-6, what + std::to_string(i));
        }
    };
    for (const int bits : {8, 16}) {
        check(readAll(testing::writeBytes(path("a.tif"), testing::tiffOf(inkCorners(bits, false), 5))), "TIFF");
        check(readAll(testing::writeBytes(path("a.psd"), testing::psdOf(inkCorners(bits, true), 4))), "PSD");
    }
    HandWritten tiles = inkCorners(8, false);
    tiles.width = tiles.height = 16;
    for (int i = 0; i < 4; ++i) {
        const std::vector<std::uint32_t> once = tiles.samples;
        tiles.samples.insert(tiles.samples.end(), once.begin(), once.end());
    }
    auto tiled = readAll(testing::writeBytes(path("tiles.tif"), testing::tiffOf(tiles, 5, 16)));
    tiled.resize(16);
    check(tiled, "tiles");
}

TEST_F(PictureRowsTest, InksFollowTheirProfile) {
    for (const int bits : {8, 16}) {
        HandWritten inks = inkCorners(bits, false);
        inks.profile = pressProfile();
        const auto got = readAll(testing::writeBytes(path("a.tif"), testing::tiffOf(inks, 5)));
        for (unsigned i = 0; i < 16; ++i) {
            const auto on = [&](unsigned c) { return (i >> c & 1U) != 0; };
            expectNear(got[i], labToSrgb(inkLab(on(0), on(1), on(2), on(3))), 0.012,
                       std::to_string(bits) + " bits " + std::to_string(i));
        }
    }
}

TEST_F(PictureRowsTest, PhotoshopFilesInInksAreReadWithoutTheirProfile) {
    HandWritten inks = inkCorners(8, true);
    const auto plain = readAll(testing::writeBytes(path("a.psd"), testing::psdOf(inks, 4)));
    inks.profile = pressProfile();
    EXPECT_EQ(readAll(testing::writeBytes(path("b.psd"), testing::psdOf(inks, 4))), plain);
    HandWritten rgb{4, 4, 8, 3, std::vector<std::uint32_t>(48, 100), adobeRgbProfile()};
    const auto got = readAll(testing::writeBytes(path("c.psd"), testing::psdOf(rgb, 3)));
    const auto level = static_cast<float>(100 / 255.0);
    expectNear(got[7], adobeToSrgb({level, level, level}), 2e-3, "RGB");
}

TEST_F(PictureRowsTest, InksWithACoverageChannelStayInks) {
    HandWritten inks{4, 4, 8, 5, {}};
    for (int i = 0; i < 16; ++i) {
        inks.samples.insert(inks.samples.end(), {255, 0, 0, 0, 99});
    }
    const auto got = readAll(testing::writeBytes(path("a.tif"), testing::tiffOf(inks, 5)));
    expectNear(got[3], {0, 1, 1}, 1e-6, "cyan");
}

TEST_F(PictureRowsTest, ColumnsAreThoseOfTheWholeBand) {
    std::vector<Rgba> pixels;
    for (int i = 0; i < 700 * 10; ++i) {
        pixels.push_back({static_cast<float>(i % 251) / 255, static_cast<float>(i % 13) / 255, 0.2F, 1});
    }
    const fs::path rows = write("rows.tif", pixels, OIIO::TypeDesc::UINT8, "");
    HandWritten tiles{64, 32, 8, 3, {}};
    for (int i = 0; i < 64 * 32 * 3; ++i) {
        tiles.samples.push_back(static_cast<std::uint32_t>(i * 7 % 256));
    }
    const fs::path tiled = testing::writeBytes(path("tiles.tif"), testing::tiffOf(tiles, 2, 16));
    for (const fs::path& file : {rows, tiled}) {
        const auto whole = readAll(file);
        PictureRows part(file, {"cannot read it", "use another"});
        const auto width = static_cast<std::size_t>(part.width());
        for (const auto& [left, right] : {std::pair(0, 1), std::pair(15, 17), std::pair(31, 64), std::pair(63, 64)}) {
            for (int y = 0; y < part.height(); y += part.bandRows()) {
                const auto band = part.read(y, left, right);
                const auto across = static_cast<std::size_t>(right - left);
                for (std::size_t i = 0; i < band.size(); ++i) {
                    const std::size_t row = static_cast<std::size_t>(y) + i / across;
                    ASSERT_EQ(band[i], whole[row * width + static_cast<std::size_t>(left) + i % across]) << file << i;
                }
            }
        }
    }
}

TEST_F(PictureRowsTest, DamagedFilesAreRefusedInOneLine) {
    const std::vector<Rgba> colours(20000, Rgba{0.1F, 0.5F, 0.3F});
    for (const char* name : {"a.jpg", "a.png", "a.tif"}) {
        const fs::path file = write(name, colours, OIIO::TypeDesc::UINT8, "", 3);
        fs::resize_file(file, fs::file_size(file) * 2 / 3);
        EXPECT_NE(refusal([&] { readAll(file); }).find(name), std::string::npos);
    }
    // A table of colours that no file of that length holds.
    std::string photoshop = testing::psdOf(inkCorners(8, true), 4);
    photoshop[26] = '\x70';
    EXPECT_NE(refusal([&] { readAll(testing::writeBytes(path("a.psd"), photoshop)); }).find("a.psd"),
              std::string::npos);
    const fs::path exr = write("a.exr", someColours(), OIIO::TypeDesc::FLOAT, "");
    std::string bytes(fs::file_size(exr), '\0');
    std::ifstream(exr, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    EXPECT_EQ(readAll(exr).size(), 100U);
    bytes[bytes.find("chlist") + 9] = '\x70'; // how long the list of channels is
    EXPECT_NE(refusal([&] { readAll(testing::writeBytes(exr, bytes)); }).find("longer than the file"),
              std::string::npos);
    // Tiles of two thousand million pixels in a file of a few hundred bytes.
    std::string huge = testing::tiffOf({16, 16, 8, 3, std::vector<std::uint32_t>(768, 9)}, 2, 16);
    for (const char tag : {'\x42', '\x43'}) { // the tiles' width and height
        const std::size_t at = huge.find(std::string({tag, '\x01', '\x04', '\x00'}));
        ASSERT_NE(at, std::string::npos);
        huge.replace(at + 8, 4, std::string({'\0', '\0', '\1', '\0'}));
    }
    EXPECT_NE(refusal([&] { readAll(testing::writeBytes(path("huge.tif"), huge)); }).find("huge.tif"),
              std::string::npos);
}

} // namespace
} // namespace limner
