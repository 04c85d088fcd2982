#include "core/style/style_files.h"
#include "style_run.h"

#include <OpenImageIO/imageio.h>

namespace limner {
namespace {

using testing::expectRefused;
using testing::ProgramRun;
using testing::run;
using testing::WithStyles;

class StyleExtract : public WithStyles {
  protected:
    void SetUp() override {
        WithStyles::SetUp();
        paintBall("plate.png");
    }
    /// The command with these after the plate.
    [[nodiscard]] ProgramRun extract(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"style", "extract", path("plate.png")});
        return run(arguments);
    }
    void refuse(std::vector<std::string> arguments, int code, const std::string& hint) const {
        arguments.insert(arguments.begin(), {"style", "extract"});
        expectRefused(arguments, code, hint);
    }
};

TEST_F(StyleExtract, ACircleGivesAStyleItsCardAndTheFigures) {
    const ProgramRun r =
        extract({"--circle", "90,80,50", "-o", path("ball.png"), "--size", "128", "--name", "Warm clay", "--tags",
                 "clay,warm", "--credit", "A. Painter", "--licence", "CC0", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto facts = r.facts();
    EXPECT_GT(facts.at("coverage").get<double>(), 0.95);
    EXPECT_LT(facts.at("residual_rmse").get<double>(), 0.02);
    EXPECT_LT(facts.at("largest_hole_deg").get<double>(), 15);
    EXPECT_EQ(facts.at("circle"), nlohmann::json({90, 80, 50}));
    EXPECT_TRUE(facts.at("form_rmse").is_null() || facts.at("form_rmse") < 0.03);
    EXPECT_EQ(facts.at("style").at("id"), "warm-clay");
    EXPECT_EQ(facts.at("style").at("file"), path("ball.png"));
    EXPECT_TRUE(facts.at("warnings").is_array());
    const Style style = loadStyle(path("ball.png"));
    EXPECT_EQ(style.sphere->size(), 128);
    EXPECT_EQ(style.card.name, "Warm clay");
    EXPECT_EQ(style.card.tags, (std::vector<std::string>{"clay", "warm"}));
    EXPECT_EQ(style.card.credit, "A. Painter");
    EXPECT_EQ(style.card.origin.rfind("plate.png, circle 90,80,50 (20", 0), 0U) << style.card.origin;
    // It looks as the ball was painted: light at the upper left, warm.
    EXPECT_GT(style.sphere->at(-0.4, 0.4).r, style.sphere->at(0.6, -0.6).r + 0.2);
    const Rgba lit = style.sphere->at(-0.4, 0.4);
    EXPECT_NEAR(lit.g / lit.r, 0.8, 0.03);
    EXPECT_EQ(files(), (std::vector<std::string>{"ball.json", "ball.png", "plate.png"}));
    EXPECT_FALSE(exists("mine"));
}

TEST_F(StyleExtract, TheFiguresAreSaidInPlainWords) {
    const ProgramRun r = extract({"--ellipse", "90,80,50,49,0", "-o", path("ball.png")});
    ASSERT_EQ(r.code, 0) << r.err;
    for (const char* word : {"ellipse 90,80,50,49,0", "coverage", "residual", "widest gap", "ball.png"}) {
        EXPECT_NE(r.out.find(word), std::string::npos) << word << " in\n" << r.out;
    }
    EXPECT_TRUE(extract({"--ellipse", "90,80,50,49,0", "-o", path("ball.png"), "--json"}).facts().contains("ellipse"));
}

TEST_F(StyleExtract, DetectListsAndTakes) {
    const ProgramRun listed = extract({"--detect", "--json"});
    ASSERT_EQ(listed.code, 0) << listed.err;
    const auto proposals = listed.facts().at("proposals");
    ASSERT_GE(proposals.size(), 1U);
    EXPECT_EQ(files(), std::vector<std::string>{"plate.png"});
    const auto& best = proposals[0].contains("circle") ? proposals[0].at("circle") : proposals[0].at("ellipse");
    EXPECT_NEAR(best[0].get<double>(), 90, 2);
    EXPECT_NEAR(best[1].get<double>(), 80, 2);
    EXPECT_NEAR(best[2].get<double>(), 50, 2);
    const ProgramRun taken = extract({"--detect", "-o", path("ball.png"), "--json"});
    ASSERT_EQ(taken.code, 0) << taken.err;
    EXPECT_TRUE(exists("ball.png"));
    EXPECT_EQ(extract({"--detect", "--pick", "900", "-o", path("other.png")}).code, 2);
    EXPECT_FALSE(exists("other.png"));
}

TEST_F(StyleExtract, SnapMovesARoughOutline) {
    const ProgramRun r = extract({"--circle", "93,78,47", "--snap", "-o", path("ball.png"), "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto facts = r.facts();
    const auto& outline = facts.contains("circle") ? facts.at("circle") : facts.at("ellipse");
    EXPECT_NEAR(outline[0].get<double>(), 90, 1);
    EXPECT_NEAR(outline[1].get<double>(), 80, 1);
    EXPECT_NEAR(outline[2].get<double>(), 50, 1);
}

TEST_F(StyleExtract, ARegionWithMarks) {
    paintMask("region.png", {50, 40}, {130, 120});
    std::ofstream(path("marks.json")) << R"({"normals": [{"at": [90, 80], "normal": [0, 0]}]})";
    const ProgramRun r =
        extract({"--region", path("region.png"), "--marks", path("marks.json"), "-o", path("s.png"), "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.facts().at("region"), "region.png");
    EXPECT_TRUE(exists("s.png"));
    std::ofstream(path("broken.json")) << "{";
    refuse({path("plate.png"), "--region", path("region.png"), "--marks", path("broken.json"), "-o", path("t.png")}, 3,
           "broken.json");
    std::ofstream(path("words.png")) << "no picture";
    refuse({path("plate.png"), "--region", path("words.png"), "-o", path("t.png")}, 3, "words.png");
    EXPECT_FALSE(exists("t.png"));
}

TEST_F(StyleExtract, SwatchesNeedNoArtwork) {
    const ProgramRun r = run({"style", "extract", "--swatches", "light=#ffe0c0,shadow=#402010", "--light", "-0.4,0.6",
                              "-o", path("clay.png"), "--size", "64", "--add", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.facts().at("style").at("id"), "clay");
    const Style style = loadStyle(path("clay.png"));
    EXPECT_GT(style.sphere->at(-0.4, 0.6).r, style.sphere->at(0.6, -0.6).r + 0.3);
    EXPECT_EQ(mine().list().cards.size(), 1U);
    refuse({"--swatches", "light=#ffe0c0", "-o", path("t.png")}, 2, "shadow is missing");
    refuse({"--swatches", "light=#ffe0c0,shadow", "-o", path("t.png")}, 2, "no colour");
    refuse({"--swatches", "light=#ffe0c0,shadow=pink-ish", "-o", path("t.png")}, 2, "--swatches");
    refuse({"--swatches", "lihgt=#ffe0c0", "-o", path("t.png")}, 2, "lihgt");
    refuse({"--swatches", "light=#ffe0c0,shadow=#402010", "--light", "2,0", "-o", path("t.png")}, 2, "outside");
    refuse({path("plate.png"), "--swatches", "light=#ffe0c0,shadow=#402010", "-o", path("t.png")}, 2, "no artwork");
}

TEST_F(StyleExtract, AddPutsItAmongOnesStylesWithItsTexture) {
    const ProgramRun r = extract({"--circle", "90,80,50", "--add", "--texture", path("tile.png"), "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.facts().at("style").at("id"), "plate");
    EXPECT_EQ(r.facts().at("style").at("added"), true);
    EXPECT_EQ(r.facts().at("style").at("file"), nullptr);
    EXPECT_EQ(mine().load("plate").texture != nullptr, exists("tile.png"));
    EXPECT_EQ(extract({"--circle", "90,80,50", "--add", "--json"}).facts().at("style").at("id"), "plate-2");
    EXPECT_FALSE(exists("plate.json"));
}

TEST_F(StyleExtract, MasksAndPicturesAreWritten) {
    const ProgramRun only = extract({"--lettering", path("letters.png")});
    ASSERT_EQ(only.code, 0) << only.err;
    const auto in = OIIO::ImageInput::open(path("letters.png"));
    ASSERT_NE(in, nullptr);
    EXPECT_EQ(in->spec().width, 200);
    EXPECT_EQ(in->spec().nchannels, 1);
    const ProgramRun r = extract({"--circle", "90,80,50", "-o", path("ball.png"), "--difference", path("off.png"),
                                  "--ignore", path("letters.png"), "--keep-lettering", "--paper-cast", "--symmetric",
                                  "--smoothing", "0.3", "--turn", "-30", "--alpha", "0:0.5,1:1", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(exists("off.png"));
    const Style style = loadStyle(path("ball.png"));
    EXPECT_TRUE(style.sphere->hasDirectionalOpacity());
    EXPECT_NEAR(style.sphere->at(0, 0).a, 0.5, 0.02);
}

TEST_F(StyleExtract, WrongUsageIsNamed) {
    const std::string plate = path("plate.png");
    const std::string out = path("t.png");
    refuse({}, 2, "--circle");
    refuse({plate, "-o", out}, 2, "nothing says where");
    refuse({plate, "--circle", "90,80,50"}, 2, "-o STYLE.png");
    refuse({plate, "--circle", "90,80,50", "--detect", "-o", out}, 2, "several");
    refuse({"--circle", "90,80,50", "-o", out}, 2, "no artwork");
    refuse({plate, "--circle", "90,80,50", "--marks", "m.json", "-o", out}, 2, "--region");
    refuse({plate, "--circle", "90,80,50", "--light", "0,0", "-o", out}, 2, "--turn");
    refuse({plate, "--region", plate, "--snap", "-o", out}, 2, "--snap");
    for (const char* circle : {"90,80", "90,80,50,1", "a,b,c", "90,80,nan", "90,80,inf", "90;80;50", "", "1e999,0,1"}) {
        refuse({plate, std::string("--circle=") + circle, "-o", out}, 2, "");
    }
    for (const char* radius : {"0", "-5"}) {
        refuse({plate, std::string("--circle=90,80,") + radius, "-o", out}, 2, "greater than 0");
    }
    refuse({plate, "--ellipse=90,80,50,0,0", "-o", out}, 2, "greater than 0");
    for (const char* alpha : {"0.5:1,0.2:1", "0:2", "0:-1", "0", "0:1:2", "-1:1"}) {
        refuse({plate, "--circle", "90,80,50", std::string("--alpha=") + alpha, "-o", out}, 2, "--alpha");
    }
    for (const char* option : {"--size=8", "--size=99999", "--smoothing=2", "--turn=nan", "--pick=0"}) {
        refuse({plate, "--circle", "90,80,50", option, "-o", out}, 2, "");
    }
    refuse({plate, "--circle", "90,80,50", "-o", path("t.jpg")}, 2, ".png");
    refuse({plate, "--circle", "90,80,50", "-o", path("none/t.png")}, 2, "folder");
    refuse({plate, "--circle", "90,80,50", "-o", plate}, 2, "read from");
    refuse({plate, "--circle", "90,80,50", "-o", out, "--difference", out}, 2, "twice");
    EXPECT_EQ(files(), std::vector<std::string>{"plate.png"});
}

TEST_F(StyleExtract, ThereIsNothingToTake) {
    paintPlain("blank.png", {200, 160}, {0.95F, 0.93F, 0.9F, 1});
    paintPlain("clear.png", {200, 160}, {0, 0, 0, 0});
    paintMask("dot.png", {90, 80}, {91, 81});
    paintMask("empty.png", {0, 0}, {0, 0});
    std::ofstream(path("words.png")) << "no picture";
    const std::vector<std::string> before = files();
    const std::string out = path("t.png");
    refuse({path("blank.png"), "--circle", "90,80,50", "-o", out, "--lettering", path("l.png")}, 3, "blank.png");
    refuse({path("blank.png"), "--detect", "-o", out}, 3, "no round shaded thing");
    EXPECT_EQ(run({"style", "extract", path("blank.png"), "--detect"}).code, 0);
    refuse({path("clear.png"), "--circle", "90,80,50", "-o", out}, 3, "clear.png");
    refuse({path("plate.png"), "--region", path("dot.png"), "-o", out}, 3, "plate.png");
    refuse({path("plate.png"), "--region", path("empty.png"), "-o", out}, 3, "plate.png");
    refuse({path("plate.png"), "--circle", "5000,80,50", "-o", out}, 3, "plate.png");
    refuse({path("plate.png"), "--circle", "90,80,0.2", "-o", out}, 3, "plate.png");
    refuse({path("plate.png"), "--circle=1e300,-1e300,1e300", "-o", out}, 3, "plate.png");
    refuse({path("words.png"), "--circle", "90,80,50", "-o", out}, 3, "words.png");
    refuse({path("absent.png"), "--circle", "90,80,50", "-o", out}, 3, "absent.png");
    EXPECT_EQ(files(), before);
}

TEST_F(StyleExtract, ACirclePartlyOutsideIsSaidSo) {
    const ProgramRun r = extract({"--circle", "20,80,50", "-o", path("t.png"), "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto warnings = r.facts().at("warnings");
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const auto& warning) {
        return warning.template get<std::string>().find("outside the picture") != std::string::npos;
    })) << r.out;
    EXPECT_LT(r.facts().at("coverage").get<double>(), 0.9);
}

TEST_F(StyleExtract, FoldersThatCannotBeWrittenLeaveNothing) {
    std::ofstream(path("file")) << "x";
    ::setenv("LIMNER_STYLES", path("file").c_str(), 1);
    refuse({path("plate.png"), "--circle", "90,80,50", "--add"}, 5, path("file"));
    EXPECT_EQ(files(), (std::vector<std::string>{"file", "plate.png"}));
}

} // namespace
} // namespace limner
