#include "core/style/extraction/extract.h"

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/style/extraction/paper.h"
#include "support/artworks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limner {
namespace {

using namespace limner::testing;

const Ellipse kBall{{160.3, 149.7}, {120, 120}, 0};

Extraction extracted(const ArtPicture& picture, ExtractionRequest request) {
    const Artwork artwork(picture, "a drawing");
    Task task;
    return extractStyle(artwork, request, task);
}

Extraction extracted(const ArtPicture& picture, std::variant<Ellipse, FormRegion> form) {
    ExtractionRequest request;
    request.form = std::move(form);
    return extracted(picture, std::move(request));
}

ArtPicture ball(const LitSphere& style) { return drawn(320, 300, ballForm(kBall), style).picture; }

std::string refusal(const ArtPicture& picture, const ExtractionRequest& request) {
    try {
        extracted(picture, request);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ExtractStyle, ACleanBallGivesItsStyleBack) {
    const LitSphere style = plainStyle();
    const Extraction e = extracted(ball(style), kBall);
    EXPECT_LT(sphereError(*e.sphere, style, e.covered), 0.005);
    EXPECT_LT(e.figures.residualRmse, 0.005);
    EXPECT_GT(e.figures.coverage, 0.99);
    EXPECT_EQ(e.sphere->size(), 512);
    EXPECT_EQ(e.sphere, e.unedited);
}

TEST(ExtractStyle, AScanLargerThanTheSphereLosesNothing) {
    const LitSphere style = plainStyle();
    const Ellipse large{{620, 590}, {520, 520}, 0};
    const Extraction e = extracted(drawn(1240, 1180, ballForm(large), style).picture, large);
    EXPECT_LT(sphereError(*e.sphere, style, e.covered), 0.002);
}

struct Case {
    const char* name;
    ArtPicture picture;
    std::variant<Ellipse, FormRegion> form;
    Mask ignored = {};
};

/// 30 % of the ball behind a flat thing, which the user has painted out.
Case hidden(const LitSphere& style) {
    Case c{"hidden", ball(style), kBall, {320, 300, std::vector<std::uint8_t>(320 * 300, 0)}};
    for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < 320; ++x) {
            if (x > 160 + 0.31 * 120) {
                c.picture.at(x, y) = {0.1F, 0.6F, 0.2F, 1};
                c.ignored.values[c.ignored.offset(x, y)] = 255;
            }
        }
    }
    return c;
}

/// A photograph of the plate taken from 20 degrees aside: the ball is an ellipse.
Ellipse tilted() { return {{160.3, 149.7}, {120, 120 * std::cos(20 * 3.14159265 / 180)}, 25}; }

std::vector<Case> cases(const LitSphere& style) {
    const SyntheticArt ellipsoid = drawn(320, 300, ellipsoidForm({160, 150}, {120, 80, 80}), style);
    const SyntheticArt torus = drawn(320, 300, torusForm({160, 150}, 90, 40), style);
    const SyntheticArt blob = drawn(320, 300, blobForm({160, 150}), style);
    std::vector<Case> all;
    all.push_back({"ball", ball(style), kBall});
    all.push_back({"noise", withNoise(ball(style), 0.05), kBall});
    all.push_back({"jpeg", throughJpeg(ball(style), 60), kBall});
    all.push_back({"text", withLetters(ball(style)), kBall});
    all.push_back(hidden(style));
    all.push_back({"tilt", drawn(320, 300, ballForm(tilted()), style).picture, tilted()});
    all.push_back({"ellipsoid", ellipsoid.picture, FormRegion{ellipsoid.form, {}}});
    all.push_back({"ellipsoid noise", withNoise(ellipsoid.picture, 0.05), FormRegion{ellipsoid.form, {}}});
    all.push_back({"torus", torus.picture, FormRegion{torus.form, {}}});
    all.push_back({"torus jpeg", throughJpeg(torus.picture, 60), FormRegion{torus.form, {}}});
    all.push_back({"torus noise", withNoise(torus.picture, 0.05), FormRegion{torus.form, {}}});
    all.push_back({"blob", blob.picture, FormRegion{blob.form, {}}});
    all.push_back({"blob noise", withNoise(blob.picture, 0.05), FormRegion{blob.form, {}}});
    return all;
}

/// Places of the values in order.
std::vector<double> ranks(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> rank(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = static_cast<double>(i);
    }
    return rank;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const auto mean = [](const std::vector<double>& v) {
        return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
    };
    const double ma = mean(a);
    const double mb = mean(b);
    double ab = 0;
    double aa = 0;
    double bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - ma) * (b[i] - mb);
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
    }
    return ab / std::sqrt(aa * bb);
}

TEST(ExtractStyle, EveryFormInAnyStateGivesTheStyleBackAndTheFiguresDoNotFlatter) {
    // Of the soft style; the bold one's steps move with every error of a normal. What is reported follows what is true,
    // over good and bad cases of both, and is not below it.
    std::vector<double> reported;
    std::vector<double> truth;
    for (const bool bold : {false, true}) {
        const LitSphere style = bold ? boldStyle() : plainStyle();
        for (const Case& c : cases(style)) {
            ExtractionRequest request;
            request.form = c.form;
            request.ignored = c.ignored;
            const Extraction e = extracted(c.picture, request);
            const double error = sphereError(*e.sphere, style, e.covered);
            const double figure = std::hypot(e.figures.residualRmse, e.figures.formRmse.value_or(0));
            EXPECT_TRUE(bold || error < 0.03) << c.name << ": " << error;
            EXPECT_GT(e.figures.coverage, 0.6) << c.name;
            EXPECT_LT(error, 1.5 * figure + 0.002) << c.name;
            reported.push_back(figure);
            truth.push_back(error);
        }
    }
    EXPECT_GT(correlation(ranks(reported), ranks(truth)), 0.6);
}

TEST(ExtractStyle, AMisplacedCircleIsSeenInTheFigures) {
    const ArtPicture picture = ball(plainStyle());
    const Extraction right = extracted(picture, kBall);
    const Extraction wrong = extracted(picture, Ellipse{{172, 158}, {112, 112}, 0});
    ASSERT_TRUE(right.figures.formRmse && wrong.figures.formRmse);
    EXPECT_LT(*right.figures.formRmse, 0.005);
    EXPECT_GT(*wrong.figures.formRmse, 5 * *right.figures.formRmse);
    EXPECT_GT(*wrong.figures.formRmse, 0.5 * sphereError(*wrong.sphere, plainStyle(), wrong.covered));
}

TEST(ExtractStyle, TheDifferenceIsGreyWhereTheRegionIsExplained) {
    const Extraction e = extracted(withLetters(ball(plainStyle())), [] {
        ExtractionRequest request;
        request.form = kBall;
        request.skipLettering = false;
        return request;
    }());
    ASSERT_EQ(e.difference.pixels.size(), e.cut.picture.pixels.size());
    int grey = 0;
    int dark = 0;
    for (const Rgba& c : e.difference.pixels) {
        grey += c.a > 0 && std::abs(c.g - 0.5F) < 0.02F ? 1 : 0;
        dark += c.a > 0 && c.g < 0.4F ? 1 : 0;
    }
    EXPECT_GT(grey, 25'000);
    EXPECT_GT(dark, 1'000); // the letters
}

TEST(ExtractStyle, TextureIsSetApartAndRepeats) {
    ArtPicture picture = ball(plainStyle());
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const auto grain = static_cast<float>(1 + 0.15 * std::sin(0.9 * x) * std::sin(0.7 * y));
            Rgba& c = picture.at(x, y);
            c = {c.r * grain, c.g * grain, c.b * grain, 1};
        }
    }
    ExtractionRequest request;
    request.form = kBall;
    request.separateTexture = true;
    const Extraction e = extracted(picture, request);
    ASSERT_NE(e.texture, nullptr);
    const auto& tile = e.texture->pixels();
    const int side = e.texture->size();
    double mean = 0;
    double spread = 0;
    double seam = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const float value = tile[static_cast<std::size_t>(y * side + x)].g;
            mean += value;
            spread += (value - 1) * (value - 1);
        }
        seam += std::abs(tile[static_cast<std::size_t>(y * side)].g -
                         tile[static_cast<std::size_t>(y * side + side - 1)].g);
    }
    EXPECT_NEAR(mean / (side * side), 1, 0.03);
    EXPECT_NEAR(std::sqrt(spread / (side * side)), 0.075, 0.03);
    EXPECT_LT(seam / side, 0.05); // as between any two neighbours
    const Extraction tiny = extracted(drawn(60, 60, ballForm({{30, 30}, {14, 14}, 0}), plainStyle()).picture, [] {
        ExtractionRequest small;
        small.form = Ellipse{{30, 30}, {14, 14}, 0};
        small.separateTexture = true;
        return small;
    }());
    EXPECT_EQ(tiny.texture, nullptr);
}

TEST(ExtractStyle, PaperCastGoes) {
    ArtPicture picture = ball(plainStyle());
    const Rgba paper{0.93F, 0.9F, 0.82F, 1}; // as drawn
    const std::optional<Rgba> found = paperColour({picture, {0, 0}, 1});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->b, paper.b, 0.01);
    ExtractionRequest request;
    request.form = kBall;
    const Extraction plain = extracted(picture, request);
    request.removePaperCast = true;
    const Extraction mended = extracted(picture, request);
    const Rgba before = plain.sphere->at(-0.4, 0.4);
    const Rgba after = mended.sphere->at(-0.4, 0.4);
    EXPECT_NEAR(after.b, withoutCast(before, paper).b, 0.01);
}

TEST(ExtractStyle, EditsAreDoneAfterTheFigures) {
    ExtractionRequest request;
    request.form = kBall;
    request.edits.turnDegrees = 90;
    request.edits.alpha = {{0, 0.5}};
    const Extraction e = extracted(ball(plainStyle()), request);
    EXPECT_NEAR(e.sphere->at(0, 0.5).r, e.unedited->at(0.5, 0).r, 0.01);
    EXPECT_NEAR(e.sphere->at(0, 0).a, 0.5, 1e-6);
    EXPECT_FALSE(e.unedited->hasDirectionalOpacity());
}

ExtractionRequest of(std::variant<Ellipse, FormRegion> form) {
    ExtractionRequest request;
    request.form = std::move(form);
    return request;
}

TEST(ExtractStyle, SaysWhatIsWrongWithWhatItIsGiven) {
    const ArtPicture paper = withNoise({300, 300, std::vector<Rgba>(90'000, Rgba{0.9F, 0.88F, 0.8F, 1})}, 0.02);
    EXPECT_NE(refusal(paper, of(Ellipse{{150, 150}, {100, 100}, 0})).find("no shading"), std::string::npos);
    EXPECT_NE(refusal(lineDrawing(), of(Ellipse{{150, 150}, {98, 98}, 0})).find("no shading"), std::string::npos);
    const ArtPicture good = ball(plainStyle());
    EXPECT_NE(refusal(good, of(Ellipse{{900, 900}, {50, 50}, 0})).find("outside the scan"), std::string::npos);
    EXPECT_NE(refusal(good, of(Ellipse{{160, 150}, {2, 2}, 0})).find("pixels of it count"), std::string::npos);
    EXPECT_NE(refusal(good, of(Ellipse{{160, 150}, {0, -5}, 0})).find("impossible"), std::string::npos);
    EXPECT_NE(refusal(good, of(Ellipse{{NAN, 150}, {10, 10}, 0})).find("impossible"), std::string::npos);
    FormRegion onePixel{{320, 300, std::vector<std::uint8_t>(320 * 300, 0)}, {}};
    EXPECT_NE(refusal(good, of(onePixel)).find("region is empty"), std::string::npos);
    onePixel.mask.values[150 * 320 + 160] = 255;
    EXPECT_NE(refusal(good, of(onePixel)).find("pixels of it count"), std::string::npos);
    ArtPicture clear = good;
    for (Rgba& c : clear.pixels) {
        c.a = 0;
    }
    EXPECT_NE(refusal(clear, of(kBall)).find("pixels of it count"), std::string::npos);
    ExtractionRequest huge = of(kBall);
    huge.size = 100'000;
    EXPECT_NE(refusal(good, huge).find("16 to 2048"), std::string::npos);
}

TEST(ExtractStyle, ABallPartlyOffTheScanIsTakenWithAWord) {
    const Ellipse aside{{60, 150}, {100, 100}, 0};
    const Artwork artwork(drawn(320, 300, ballForm(aside), plainStyle()).picture, "a drawing");
    Task task;
    const Extraction e = extractStyle(artwork, of(aside), task);
    ASSERT_EQ(task.warnings().size(), 1U);
    EXPECT_NE(task.warnings()[0].find("outside the scan"), std::string::npos);
    EXPECT_LT(e.figures.coverage, 0.95);
    EXPECT_LT(sphereError(*e.sphere, plainStyle(), e.covered), 0.005);
}

TEST(ExtractStyle, StopsWhenToldTo) {
    const Artwork artwork(ball(plainStyle()), "a drawing");
    Task task;
    task.cancel();
    EXPECT_THROW(extractStyle(artwork, of(kBall), task), Error);
}

} // namespace
} // namespace limner
