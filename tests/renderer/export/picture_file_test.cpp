#include "renderer/export/picture_file.h"

#include "core/base/error.h"
#include "gradient_backend.h"
#include "renderer/export/pixel_rows.h"
#include "renderer/export/srgb_profile.h"
#include "support/small_disk.h"

#include <gtest/gtest.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include <unistd.h>

namespace limner {
namespace {

using testing::GradientBackend;
using testing::SmallDisk;

class PictureFileTest : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            std::filesystem::temp_directory_path() / ("limner-export-" + std::to_string(::getpid()) + "-" +
                                                      ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::size_t filesLeft() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
    }

    std::filesystem::path folder_;
    GradientBackend backend_;
    Task task_;
};

RenderPlan planOf(int width, int height) {
    RenderPlan plan;
    plan.size = {width, height};
    return plan;
}

struct ReadBack {
    OIIO::ImageSpec spec;
    std::vector<float> numbers; ///< as stored, integers as 0..1

    [[nodiscard]] const float* at(int x, int y) const {
        return numbers.data() +
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(spec.width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(spec.nchannels);
    }
};

ReadBack readBack(const std::filesystem::path& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1); // numbers as they lie in the file
    auto in = OIIO::ImageInput::open(path.string(), &config);
    EXPECT_NE(in, nullptr) << OIIO::geterror();
    ReadBack back;
    if (in == nullptr) {
        return back;
    }
    back.spec = in->spec();
    back.numbers.resize(back.spec.image_pixels() * static_cast<std::size_t>(back.spec.nchannels));
    EXPECT_TRUE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, back.numbers.data())) << in->geterror();
    return back;
}

std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

template <typename Function>
Error errorOf(Function function) {
    try {
        function();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error;
    }
    ADD_FAILURE() << "nothing was thrown";
    return {ErrorKind::usage, {}};
}

// ---- every format: values, depth, dpi, profile

struct FormatCase {
    const char* ending;
    SampleDepth depth;
    OIIO::TypeDesc::BASETYPE type;
    double tolerance; ///< of a stored number in 0..1
    bool linear = false;
    bool dpi = true;
    bool profile = true;
};

class EveryFormat : public PictureFileTest, public ::testing::WithParamInterface<FormatCase> {};

constexpr double kHalfOf8Bits = 0.5 / 255 + 1e-6; // rounding to nearest, and the float that it is read as
constexpr double kHalfOf16Bits = 0.5 / 65535 + 1e-6;
constexpr double kFloat = 2e-6;     // a few roundings of float arithmetic
constexpr double kHalfFloat = 5e-4; // 11 significant bits
constexpr double kLossy = 0.06;     // JPEG and WebP at quality 95, on a gradient with jumps

INSTANTIATE_TEST_SUITE_P(
    Formats, EveryFormat,
    ::testing::Values(FormatCase{"png", SampleDepth::automatic, OIIO::TypeDesc::UINT8, kHalfOf8Bits},
                      FormatCase{"png", SampleDepth::sixteen, OIIO::TypeDesc::UINT16, kHalfOf16Bits},
                      FormatCase{"tif", SampleDepth::eight, OIIO::TypeDesc::UINT8, kHalfOf8Bits},
                      FormatCase{"TIFF", SampleDepth::sixteen, OIIO::TypeDesc::UINT16, kHalfOf16Bits},
                      FormatCase{"tif", SampleDepth::floating, OIIO::TypeDesc::FLOAT, kFloat},
                      FormatCase{"exr", SampleDepth::automatic, OIIO::TypeDesc::FLOAT, kFloat, true, true, false},
                      FormatCase{"exr", SampleDepth::sixteen, OIIO::TypeDesc::HALF, kHalfFloat, true, true, false},
                      FormatCase{"jpg", SampleDepth::automatic, OIIO::TypeDesc::UINT8, kLossy},
                      FormatCase{"webp", SampleDepth::automatic, OIIO::TypeDesc::UINT8, kLossy, false, false, false}),
    [](const auto& c) { return std::string(c.param.ending) + "_" + OIIO::TypeDesc(c.param.type).c_str(); });

TEST_P(EveryFormat, HoldsThePictureOnItsBackground) {
    const FormatCase& c = GetParam();
    const auto path = folder_ / (std::string("picture.") + c.ending);
    PictureOptions options;
    options.depth = c.depth;
    options.dpi = 450;
    options.background = {0.25, 0.5, 0.75, 1};
    const ExportFacts facts = exportPicture(planOf(200, 150), backend_, path, options, task_);
    EXPECT_EQ(facts.size, glm::ivec2(200, 150));
    EXPECT_EQ(facts.samples, 200U * 150U);
    EXPECT_EQ(filesLeft(), 1U);

    const ReadBack back = readBack(path);
    ASSERT_EQ(back.spec.width, 200);
    ASSERT_EQ(back.spec.height, 150);
    ASSERT_EQ(back.spec.nchannels, 3);
    EXPECT_EQ(back.spec.format, c.type);
    double worst = 0;
    double sum = 0;
    for (int y = 0; y < 150; ++y) {
        for (int x = 0; x < 200; ++x) {
            const glm::vec4 p = GradientBackend::colourAt(x, y);
            const glm::dvec3 background(options.background);
            for (int i = 0; i < 3; ++i) {
                double expected = p[i] + (1 - p.a) * background[i];
                if (c.linear) {
                    expected = expected <= 0.04045 ? expected / 12.92 : std::pow((expected + 0.055) / 1.055, 2.4);
                }
                const double difference = std::abs(back.at(x, y)[i] - expected);
                worst = std::max(worst, difference);
                sum += difference;
            }
        }
    }
    if (c.tolerance == kLossy) {
        EXPECT_LT(sum / (200 * 150 * 3), kLossy);
    } else {
        EXPECT_LE(worst, c.tolerance);
    }
    if (c.dpi) {
        EXPECT_NEAR(back.spec.get_float_attribute("XResolution"), 450, 0.02); // PNG counts whole pixels per metre
        EXPECT_NEAR(back.spec.get_float_attribute("YResolution"), 450, 0.02);
        EXPECT_EQ(back.spec.get_string_attribute("ResolutionUnit").substr(0, 2), "in");
    }
    const auto* profile = back.spec.find_attribute("ICCProfile");
    ASSERT_EQ(profile != nullptr, c.profile);
    if (profile != nullptr) {
        const auto expected = srgbProfile();
        ASSERT_EQ(static_cast<std::size_t>(profile->type().size()), expected.size());
        EXPECT_TRUE(std::equal(expected.begin(), expected.end(), static_cast<const std::uint8_t*>(profile->data())));
    }
}

TEST_P(EveryFormat, KeepsAlphaWhereTheFormatHasIt) {
    const FormatCase& c = GetParam();
    const auto path = folder_ / (std::string("picture.") + c.ending);
    PictureOptions options;
    options.depth = c.depth;
    options.transparent = true;
    exportPicture(planOf(64, 48), backend_, path, options, task_);
    const ReadBack back = readBack(path);
    if (std::string(c.ending) == "jpg") {
        ASSERT_EQ(back.spec.nchannels, 3);
        EXPECT_NEAR(back.at(7, 20)[0], 1, kLossy); // empty: the background
        return;
    }
    ASSERT_EQ(back.spec.nchannels, 4);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const glm::vec4 p = GradientBackend::colourAt(x, y);
            ASSERT_NEAR(back.at(x, y)[3], p.a, std::min(c.tolerance, kHalfOf8Bits)) << x << ' ' << y;
            if (c.tolerance == kLossy) {
                continue;
            }
            for (int i = 0; i < 3; ++i) {
                const double straight = p.a > 0 ? p[i] / p.a : 0;
                const double expected =
                    c.linear ? linearFromSrgb(static_cast<float>(straight)) * static_cast<double>(p.a) : straight;
                ASSERT_NEAR(back.at(x, y)[i], expected, c.tolerance + kFloat) << x << ' ' << y;
            }
        }
    }
}

// ---- encoding

TEST(SrgbEncoding, GoesThereAndBackAndKnowsItsFixedPoints) {
    EXPECT_EQ(linearFromSrgb(0), 0);
    EXPECT_FLOAT_EQ(linearFromSrgb(1), 1);
    EXPECT_NEAR(linearFromSrgb(0.5F), 0.21404114, 1e-6); // IEC 61966-2-1
    for (float v = -0.5F; v < 2; v += 0.01F) {
        EXPECT_NEAR(srgbFromLinear(linearFromSrgb(v)), v, 3e-6); // two powers in float
    }
}

TEST(ToRgba8, LaysOverTheBackgroundOrKeepsAlpha) {
    Picture picture({2, 1});
    const float half[4] = {0.25F, 0.125F, 0, 0.5F};
    std::copy_n(half, 4, picture.pixel(0, 0));
    PictureOptions options;
    options.background = {0, 0, 1, 1};
    EXPECT_EQ(toRgba8(picture, options), (std::vector<std::uint8_t>{64, 32, 128, 255, 0, 0, 255, 255}));
    options.background = {0, 0, 1, 0.5}; // half a blue on white paper
    EXPECT_EQ(toRgba8(picture, options)[4], 128);
    options.transparent = true;
    EXPECT_EQ(toRgba8(picture, options), (std::vector<std::uint8_t>{128, 64, 0, 128, 0, 0, 0, 0}));
}

TEST(EncodePng, IsAReadablePng) {
    Picture picture({256, 256});
    for (int i = 0; i < 256; ++i) {
        picture.pixel(i, i)[3] = 1; // black
    }
    const auto bytes = encodePng(picture, {});
    OIIO::Filesystem::IOMemReader reader(const_cast<std::byte*>(bytes.data()), bytes.size());
    auto in = OIIO::ImageInput::open("x.png", nullptr, &reader);
    ASSERT_NE(in, nullptr);
    std::vector<std::uint8_t> row(256 * 3);
    ASSERT_TRUE(in->read_scanline(5, 0, OIIO::TypeDesc::UINT8, row.data()));
    EXPECT_EQ(row[15], 0);
    EXPECT_EQ(row[18], 255);
}

TEST_F(PictureFileTest, CountsPixelsThatAreNotFinite) {
    backend_.afterTile = [](Picture& picture) {
        picture.pixel(3, 0)[1] = std::numeric_limits<float>::quiet_NaN();
        picture.pixel(4, 0)[3] = std::numeric_limits<float>::infinity();
    };
    const auto path = folder_ / "p.png";
    const ExportFacts facts = exportPicture(planOf(32, 32), backend_, path, {}, task_);
    EXPECT_EQ(facts.notFinite, 2U);
    ASSERT_EQ(task_.warnings().size(), 1U);
    EXPECT_EQ(readBack(path).at(3, 0)[0], 1); // empty: paper
}

// ---- tiles and memory

TEST_F(PictureFileTest, TilingChangesNoByte) {
    PictureOptions options;
    options.depth = SampleDepth::sixteen;
    exportPicture(planOf(333, 257), backend_, folder_ / "whole.png", options, task_);
    options.tile = 48;
    exportPicture(planOf(333, 257), backend_, folder_ / "tiles.png", options, task_);
    EXPECT_GT(backend_.calls, 40);
    options.tile = 1;
    exportPicture(planOf(333, 257), backend_, folder_ / "pixels.png", options, task_);
    const std::string whole = bytesOf(folder_ / "whole.png");
    EXPECT_EQ(whole, bytesOf(folder_ / "tiles.png"));
    EXPECT_EQ(whole, bytesOf(folder_ / "pixels.png"));
}

TEST_F(PictureFileTest, TilingChangesNoNumberOfATiff) {
    PictureOptions options;
    for (const int tile : {0, 5, 40, 4000}) {
        options.tile = tile;
        exportPicture(planOf(201, 99), backend_, folder_ / (std::to_string(tile) + ".tif"), options, task_);
    }
    const auto whole = readBack(folder_ / "0.tif").numbers;
    for (const char* name : {"5.tif", "40.tif", "4000.tif"}) {
        EXPECT_EQ(whole, readBack(folder_ / name).numbers) << name;
    }
}

TEST_F(PictureFileTest, BandsShrinkWithTheBudget) {
    PictureOptions options;
    options.memoryBudget = std::size_t{20} << 20;
    exportPicture(planOf(4096, 512), backend_, folder_ / "p.png", options, task_);
    EXPECT_LE(static_cast<std::size_t>(backend_.largestTile) * 16, std::size_t{4} << 20);
    options.memoryBudget = 1000;
    const Error error = errorOf([&] { exportPicture(planOf(64, 64), backend_, folder_ / "q.png", options, task_); });
    EXPECT_EQ(error.kind(), ErrorKind::noResources);
    EXPECT_EQ(filesLeft(), 1U);
}

// ---- refusals come before any rendering

TEST_F(PictureFileTest, RefusesWhatTheFormatCannotHold) {
    struct Case {
        const char* name;
        glm::ivec2 size;
        SampleDepth depth;
        ErrorKind kind;
    };
    const Case cases[] = {
        {"a.gif", {8, 8}, SampleDepth::automatic, ErrorKind::usage},
        {"a", {8, 8}, SampleDepth::automatic, ErrorKind::usage},
        {"a.jpg", {8, 8}, SampleDepth::sixteen, ErrorKind::usage},
        {"a.webp", {8, 8}, SampleDepth::floating, ErrorKind::usage},
        {"a.png", {8, 8}, SampleDepth::floating, ErrorKind::usage},
        {"a.exr", {8, 8}, SampleDepth::eight, ErrorKind::usage},
        {"a.png", {0, 8}, SampleDepth::automatic, ErrorKind::usage},
        {"a.png", {0, 0}, SampleDepth::automatic, ErrorKind::usage},
        {"a.png", {8, -1}, SampleDepth::automatic, ErrorKind::usage},
        {"a.jpg", {65501, 8}, SampleDepth::automatic, ErrorKind::usage},
        {"a.webp", {8, 16384}, SampleDepth::automatic, ErrorKind::usage},
        {"a.tif", {1'000'000'000, 8}, SampleDepth::automatic, ErrorKind::usage},
        {"a.webp", {16383, 16383}, SampleDepth::automatic, ErrorKind::noResources},
        {"none/a.png", {8, 8}, SampleDepth::automatic, ErrorKind::usage},
    };
    for (const Case& c : cases) {
        PictureOptions options;
        options.depth = c.depth;
        const Error error =
            errorOf([&] { exportPicture(planOf(c.size.x, c.size.y), backend_, folder_ / c.name, options, task_); });
        EXPECT_EQ(error.kind(), c.kind) << c.name << ": " << error.what();
    }
    for (const double dpi : {0.0, -300.0, 1e9, std::nan("")}) {
        PictureOptions options;
        options.dpi = dpi;
        EXPECT_EQ(errorOf([&] { checkExport(folder_ / "a.png", {8, 8}, options); }).kind(), ErrorKind::usage);
    }
    EXPECT_EQ(errorOf([&] {
                  checkExport(folder_ / ".." / folder_.filename() / "", {8, 8}, {});
              }).kind(),
              ErrorKind::usage);
    EXPECT_EQ(backend_.calls, 0);
    EXPECT_EQ(filesLeft(), 0U);
}

// ---- stops and failures leave nothing

TEST_F(PictureFileTest, ACancelLeavesTheOldFile) {
    for (const char* ending : {"png", "tif", "exr", "jpg", "webp"}) {
        const auto path = folder_ / (std::string("p.") + ending);
        std::ofstream(path) << "old";
        Task task;
        backend_.calls = 0;
        backend_.afterTile = [&](Picture&) {
            if (backend_.calls == 3) {
                task.cancel();
            }
        };
        PictureOptions options;
        options.tile = 64;
        EXPECT_EQ(errorOf([&] { exportPicture(planOf(256, 256), backend_, path, options, task); }).kind(),
                  ErrorKind::cancelled);
        EXPECT_EQ(bytesOf(path), "old");
        std::filesystem::remove(path);
        EXPECT_EQ(filesLeft(), 0U) << ending;
    }
}

TEST_F(PictureFileTest, AFullDiskLeavesTheOldFileAndSaysWhy) {
    backend_.afterTile = [](Picture& picture) { // noise does not compress
        std::uint32_t state = 1;
        for (float& v : picture.rgba()) {
            state = state * 1664525U + 1013904223U;
            v = static_cast<float>(state >> 8) / static_cast<float>(1 << 24);
        }
    };
    // 5 kB is inside the header, 200 kB inside the pixels; the last fails at the very end (the buffer's flush).
    for (const rlim_t bytes : {rlim_t{5'000}, rlim_t{200'000}, rlim_t{1'000'000}}) {
        for (const char* ending : {"png", "tif", "exr", "jpg", "webp"}) {
            const auto path = folder_ / (std::string("p.") + ending);
            std::ofstream(path) << "old";
            backend_.calls = 0;
            PictureOptions options;
            options.tile = 256;
            std::optional<Error> error;
            {
                const SmallDisk disk(bytes);
                try {
                    exportPicture(planOf(1024, 2048), backend_, path, options, task_);
                } catch (const Error& e) {
                    error = e;
                }
            }
            ASSERT_TRUE(error.has_value()) << ending << ' ' << bytes;
            EXPECT_EQ(error->kind(), ErrorKind::noResources) << ending;
            EXPECT_NE(std::string(error->what()).find("File too large"), std::string::npos) << error->what();
            EXPECT_EQ(bytesOf(path), "old");
            std::filesystem::remove(path);
            EXPECT_EQ(filesLeft(), 0U) << ending << ' ' << bytes;
        }
    }
}

TEST_F(PictureFileTest, ABackendThatFailsLeavesNothing) {
    backend_.afterTile = [&](Picture&) {
        if (backend_.calls == 2) {
            throw Error(ErrorKind::noResources, {"no", "", "", ""});
        }
    };
    PictureOptions options;
    options.tile = 32;
    errorOf([&] { exportPicture(planOf(128, 128), backend_, folder_ / "p.tif", options, task_); });
    EXPECT_EQ(filesLeft(), 0U);
}

TEST_F(PictureFileTest, FollowsALinkAndKeepsIt) {
    std::filesystem::create_directory(folder_ / "real");
    std::ofstream(folder_ / "real" / "p.png") << "old";
    std::filesystem::create_symlink("real/p.png", folder_ / "p.png");
    exportPicture(planOf(8, 8), backend_, folder_ / "p.png", {}, task_);
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "p.png"));
    EXPECT_EQ(readBack(folder_ / "real" / "p.png").spec.width, 8);
}

// ---- progress

TEST_F(PictureFileTest, ProgressRisesEvenlyAndEndsAtOne) {
    struct Listener : TaskListener {
        std::vector<double> fractions;
        void progressed(const std::string& phase, double fraction) override {
            if (phase == "Rendering") {
                fractions.push_back(fraction);
            }
        }
        void warned(const std::string&) override {}
    } listener;
    Task task(listener);
    PictureOptions options;
    options.tile = 64;
    exportPicture(planOf(128, 256), backend_, folder_ / "p.png", options, task);
    ASSERT_EQ(listener.fractions.size(), 9U); // the start and eight tiles of equal size
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_NEAR(listener.fractions[i], static_cast<double>(i) / 8, 1e-12);
    }
}

} // namespace
} // namespace limner
