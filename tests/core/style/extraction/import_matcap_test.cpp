#include "core/base/error.h"
#include "core/base/task.h"
#include "core/project/archive.h"
#include "core/style/extraction/extract.h"
#include "support/drawn_pictures.h"
#include "support/hand_written_pictures.h"
#include "support/test_data.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::LitBall;

class ImportMatcap : public ::testing::Test {
  protected:
    fs::path write(const std::string& name, const ArtPicture& picture, int channels = 4) const {
        const std::string file = (folder_.path() / name).string();
        OIIO::ImageSpec spec(picture.width, picture.height, channels, OIIO::TypeDesc::UINT16);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        const auto output = OIIO::ImageOutput::create(file);
        EXPECT_TRUE(output && output->open(file, spec) &&
                    output->write_image(OIIO::TypeDesc::FLOAT, picture.pixels.data(), sizeof(Rgba)) && output->close());
        return file;
    }

    std::string refusal(const fs::path& file) {
        try {
            importMatcap(file, task_);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            const std::string line = error.what();
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
            return line;
        }
        ADD_FAILURE() << file << " was taken";
        return {};
    }

    /// Root mean square over the disk but its outermost rim, where a picture of pixels is not sharp.
    static double errorOf(const LitSphere& sphere, const testing::BallShade& truth, double reach = 0.96) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < 60 * 60; ++i) {
            const glm::dvec2 n((i % 60 + 0.5) / 30 - 1, 1 - (i / 60 + 0.5) / 30);
            if (glm::length(n) < reach) {
                const Rgba got = sphere.at(n.x, n.y);
                const glm::dvec3 off = glm::dvec3(got.r, got.g, got.b) - glm::clamp(truth(n), 0.0, 1.0);
                sum += glm::dot(off, off) / 3;
                ++count;
            }
        }
        return std::sqrt(sum / count);
    }

    TemporaryFolder folder_;
    Task task_;
};

TEST_F(ImportMatcap, TakesABallThatFillsItsSquare) {
    for (const Rgba& ground : {Rgba{0.2F, 0.2F, 0.2F}, Rgba{1, 1, 1}, Rgba{0.9F, 0.75F, 0.6F}}) {
        ArtPicture picture = testing::plainPicture(256, 256, ground);
        testing::drawBall(picture, {{128, 128}, {128, 128}, 0}, LitBall{});
        const auto sphere = importMatcap(write("full.png", picture, 3), task_);
        EXPECT_EQ(sphere->size(), 256);
        EXPECT_FALSE(sphere->hasDirectionalOpacity());
        EXPECT_LT(errorOf(*sphere, LitBall{}), 0.002);
    }
}

TEST_F(ImportMatcap, FindsABallOnAPlainGround) {
    const struct {
        int width;
        int height;
        Ellipse ball;
        Rgba ground;
    } cases[] = {{400, 300, {{231.3, 148.7}, {101.5, 101.5}, 0}, {0.95F, 0.95F, 0.93F}},
                 {300, 300, {{150.2, 150.1}, {110.4, 110.4}, 0}, {0.05F, 0.05F, 0.05F}},
                 {300, 500, {{120.6, 340.3}, {95.3, 95.3}, 0}, {0.3F, 0.5F, 0.8F}}};
    for (const auto& one : cases) {
        ArtPicture picture = testing::plainPicture(one.width, one.height, one.ground);
        testing::drawBall(picture, one.ball, LitBall{{-0.3, 0.4, 0.8}, {0.9, 0.6, 0.4}, {0.3, 0.2, 0.2}, 0.3});
        const auto sphere = importMatcap(write("padded.png", picture, 3), task_);
        EXPECT_NEAR(sphere->size(), 2 * one.ball.semiAxes.x, 3);
        EXPECT_LT(errorOf(*sphere, LitBall{{-0.3, 0.4, 0.8}, {0.9, 0.6, 0.4}, {0.3, 0.2, 0.2}, 0.3}), 0.01);
    }
}

TEST_F(ImportMatcap, FindsADiskByItsAlpha) {
    ArtPicture picture = testing::plainPicture(320, 260, {0.5F, 0.5F, 0.5F, 0});
    testing::drawBall(picture, {{150.5, 120.5}, {100, 100}, 0}, LitBall{});
    const auto sphere = importMatcap(write("alpha.png", picture), task_);
    EXPECT_NEAR(sphere->size(), 200, 2);
    EXPECT_LT(errorOf(*sphere, LitBall{}), 0.01);
    EXPECT_GT(sphere->at(0.9, 0).a, 0.99F);
}

TEST_F(ImportMatcap, DirectionalOpacityIsNoDisk) {
    // A style of our own: clear in the middle and opaque at the rim, or the other way round.
    for (const bool hollow : {true, false}) {
        ArtPicture picture = testing::plainPicture(128, 128, {});
        for (int y = 0; y < 128; ++y) {
            for (int x = 0; x < 128; ++x) {
                const double r = std::min(1.0, glm::length(glm::dvec2(x - 63.5, y - 63.5) / 64.0));
                picture.at(x, y) = {0.8F, 0.5F, 0.3F, static_cast<float>(hollow ? r * r : 1 - r * r)};
            }
        }
        const auto sphere = importMatcap(write("veil.png", picture), task_);
        EXPECT_EQ(sphere->size(), 128);
        EXPECT_NEAR(sphere->at(0.5, 0).a, hollow ? 0.25 : 0.75, 0.02);
        EXPECT_NEAR(sphere->at(0.5, 0).r, 0.8, 0.005);
    }
}

TEST_F(ImportMatcap, CutsWhatIsNotSquareAndReducesWhatIsLarge) {
    ArtPicture wide = testing::plainPicture(500, 200, {});
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 500; ++x) { // no ball, no plain ground: the middle square it is
            wide.at(x, y) = {static_cast<float>(x) / 500, static_cast<float>(y) / 200, 0.5F, 1};
        }
    }
    const auto middle = importMatcap(write("wide.png", wide, 3), task_);
    EXPECT_EQ(middle->size(), 200);
    EXPECT_NEAR(middle->at(0, 0).r, 0.5, 0.01);
    EXPECT_NEAR(middle->at(-0.9, 0).r, 0.5 - 0.9 * 100 / 500, 0.01);
    EXPECT_NEAR(middle->at(0, 0.9).g, 0.05, 0.01);
    ArtPicture large = testing::plainPicture(1500, 1500, {0, 0, 0});
    testing::drawBall(large, {{750, 750}, {750, 750}, 0}, LitBall{});
    const auto reduced = importMatcap(write("large.png", large, 3), task_);
    EXPECT_EQ(reduced->size(), 1024);
    EXPECT_LT(errorOf(*reduced, LitBall{}), 0.003);
}

TEST_F(ImportMatcap, RefusesWhatHoldsNoDisk) {
    EXPECT_NE(refusal(write("clear.png", testing::plainPicture(100, 100, {0.4F, 0.4F, 0.4F, 0}))).find("clear"),
              std::string::npos);
    EXPECT_NE(refusal(write("tiny.png", testing::plainPicture(1, 1, {1, 1, 1}))).find("pixels across"),
              std::string::npos);
    EXPECT_NE(refusal(write("strip.png", testing::plainPicture(500, 10, {1, 1, 1}))).find("pixels across"),
              std::string::npos);
    EXPECT_NE(refusal(folder_.path() / "none.png").find("none.png"), std::string::npos);
    EXPECT_NE(refusal(testing::writeBytes(folder_.path() / "text.png", "not a picture")).find("text.png"),
              std::string::npos);
    const fs::path cut = write("cut.png", testing::plainPicture(300, 300, {0.2F, 0.5F, 0.6F}));
    fs::resize_file(cut, fs::file_size(cut) / 2);
    EXPECT_NE(refusal(cut).find("cut.png"), std::string::npos);
    Task cancelled;
    cancelled.cancel();
    EXPECT_THROW(importMatcap(write("ball.png", testing::plainPicture(64, 64, {1, 1, 1})), cancelled), Error);
}

TEST_F(ImportMatcap, TakesEveryMatcapOfTheTestPictures) {
    const auto folder = testing::testData("matcaps");
    if (!folder) {
        return;
    }
    int count = 0;
    for (const auto& entry : fs::directory_iterator(*folder)) {
        if (entry.path().extension() == ".txt") {
            continue;
        }
        const auto sphere = importMatcap(entry.path(), task_);
        // All of them fill their squares, whatever the ground behind them is.
        EXPECT_EQ(sphere->size(), entry.path().extension() == ".png" ? 256 : 512) << entry.path();
        EXPECT_FALSE(sphere->hasDirectionalOpacity()) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 34);
}

TEST_F(ImportMatcap, PutsNormalsWhereTheyBelong) {
    const auto file = testing::testData("matcaps/blender_check_normal_plus_y.png");
    if (!file) {
        return;
    }
    const auto sphere = importMatcap(*file, task_);
    const auto normals = [](glm::dvec2 n) {
        return 0.5 + 0.5 * glm::dvec3(n, std::sqrt(std::max(0.0, 1 - glm::dot(n, n))));
    };
    EXPECT_LT(errorOf(*sphere, normals), 0.01);
    EXPECT_GT(sphere->at(0, 0.9).g, 0.9F) << "n_y is up";
    EXPECT_GT(sphere->at(0.9, 0).r, 0.9F);
}

} // namespace
} // namespace limner
