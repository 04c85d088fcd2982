#include "core/style/style_files.h"
#include "core/style/texture_tile.h"
#include "style_run.h"
#include "support/test_data.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>

namespace limner {
namespace {

using testing::expectRefused;
using testing::ProgramRun;
using testing::run;
using testing::WithStyles;

Style madeStyle(const std::string& name) {
    Style style;
    style.card = {"", name, {"warm"}, "by hand", "The maker", "CC0"};
    style.sphere = std::make_shared<const LitSphere>(32, std::vector<Rgba>(32 * 32, Rgba{0.8F, 0.5F, 0.2F, 1}));
    return style;
}

std::vector<float> pixelsOf(const std::string& path, int width, int channels) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto in = OIIO::ImageInput::open(path, &config);
    EXPECT_TRUE(in && in->spec().width == width && in->spec().height == width && in->spec().nchannels == channels);
    std::vector<float> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(width * channels));
    EXPECT_TRUE(in && in->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, pixels.data()));
    return pixels;
}

TEST_F(WithStyles, ListTellsOnesOwnFromTheBundled) {
    const std::size_t bundled = bundledStyleCards().size();
    EXPECT_EQ(run({"style", "list", "--json"}).facts().at("styles").size(), bundled);
    const ProgramRun none = run({"style", "list", "--mine"});
    EXPECT_EQ(none.code, 0);
    EXPECT_NE(none.out.find("style add"), std::string::npos) << none.out;
    mine().add(madeStyle("Ochre"));
    const auto all = run({"style", "list", "--json"}).facts().at("styles");
    ASSERT_EQ(all.size(), bundled + 1);
    EXPECT_EQ(all[0].at("id"), "ochre");
    EXPECT_EQ(all[0].at("section"), "mine");
    EXPECT_EQ(all[0].at("credit"), "The maker");
    EXPECT_EQ(all[1].at("section"), "bundled");
    EXPECT_EQ(run({"style", "list", "--mine", "--json"}).facts().at("styles").size(), 1U);
    EXPECT_EQ(run({"style", "list", "--bundled", "--json"}).facts().at("styles").size(), bundled);
    EXPECT_EQ(run({"style", "list", "--mine", "--bundled", "--json"}).facts().at("styles").size(), bundled + 1);
    EXPECT_NE(run({"style", "list"}).out.find("ochre"), std::string::npos);
}

TEST_F(WithStyles, ListNamesWhatIsBrokenAndGoesOn) {
    mine().add(madeStyle("Ochre"));
    mine().add(madeStyle("Ink"));
    std::ofstream(path("mine/ink.json")) << "{ broken";
    const ProgramRun list = run({"style", "list", "--mine"});
    EXPECT_EQ(list.code, 0);
    EXPECT_NE(list.out.find("ochre"), std::string::npos);
    EXPECT_NE(list.err.find("ink.json"), std::string::npos) << list.err;
    const auto facts = run({"style", "list", "--mine", "--json"}).facts();
    EXPECT_EQ(facts.at("styles").size(), 1U);
    EXPECT_EQ(facts.at("warnings").size(), 1U);
    expectRefused({"style", "show", "ink"}, 3, "ink.json");
}

TEST_F(WithStyles, AddTakesAStyleWithItsCardAndTexture) {
    Style style = madeStyle("Red clay");
    style.texture = std::make_shared<const TextureTile>(16, std::vector<Rgba>(256, Rgba{1, 1, 1, 1}));
    writeStyle(style, path("a.png"));
    const ProgramRun added = run({"style", "add", path("a.png"), "--tags", "clay, red", "--json"});
    ASSERT_EQ(added.code, 0) << added.err;
    EXPECT_EQ(added.facts().at("styles").at(0).at("id"), "red-clay");
    EXPECT_EQ(added.facts().at("folder"), path("mine"));
    const Style mineNow = mine().load("red-clay");
    EXPECT_EQ(mineNow.card.credit, "The maker");
    EXPECT_EQ(mineNow.card.tags, (std::vector<std::string>{"clay", "red"}));
    EXPECT_NE(mineNow.texture, nullptr);
    EXPECT_EQ(run({"style", "add", path("a.png"), "--json"}).facts().at("styles").at(0).at("id"), "red-clay-2");
    const ProgramRun all = run({"style", "add", path("a-texture.png"), path("a.png"), "--json"});
    EXPECT_EQ(all.facts().at("styles").size(), 1U) << "a texture comes with its style";
    const ProgramRun renamed = run({"style", "add", path("a.png"), "--name", "Blue clay", "--licence", "CC BY 4.0"});
    EXPECT_NE(renamed.out.find("blue-clay"), std::string::npos) << renamed.out;
    EXPECT_EQ(mine().load("blue-clay").card.licence, "CC BY 4.0");
}

TEST_F(WithStyles, AddRefusesWhatIsNoBallAndKeepsTheRest) {
    std::ofstream(path("words.png")) << "no picture";
    writeStyle(madeStyle("Ochre"), path("a.png"));
    writeStyle(madeStyle("Ink"), path("b.png"));
    expectRefused({"style", "add", path("words.png")}, 3, "words.png");
    expectRefused({"style", "add", path("absent.png")}, 3, "absent.png");
    expectRefused({"style", "add"}, 2, "FILE");
    expectRefused({"style", "add", path("a.png"), path("b.png"), "--name", "x"}, 2, "one by one");
    EXPECT_FALSE(exists("mine"));
    std::ofstream(path("b.json")) << "{";
    expectRefused({"style", "add", path("b.png")}, 3, "b.json");
    const ProgramRun some = run({"style", "add", path("words.png"), path("a.png"), path("b.png")});
    EXPECT_EQ(some.code, 3);
    EXPECT_NE(some.err.find("2 of 3"), std::string::npos) << some.err;
    EXPECT_NE(some.err.find("b.json"), std::string::npos) << some.err;
    EXPECT_EQ(mine().list().cards.size(), 1U);
    std::ofstream(path("file")) << "x";
    ::setenv("LIMNER_STYLES", path("file").c_str(), 1);
    expectRefused({"style", "add", path("a.png")}, 5, path("file"));
}

TEST_F(WithStyles, ShowTellsTheFactsAndDrawsTheBall) {
    mine().add(madeStyle("Ochre"));
    const ProgramRun shown = run({"style", "show", "ochre", "-o", path("ball.png"), "--size", "64", "--json"});
    ASSERT_EQ(shown.code, 0) << shown.err;
    const auto facts = shown.facts();
    EXPECT_EQ(facts.at("name"), "Ochre");
    EXPECT_EQ(facts.at("section"), "mine");
    EXPECT_EQ(facts.at("size"), 32);
    EXPECT_EQ(facts.at("see_through"), false);
    EXPECT_EQ(facts.at("texture"), nullptr);
    EXPECT_EQ(facts.at("file"), path("mine/ochre.png"));
    const std::vector<float> ball = pixelsOf(path("ball.png"), 64, 4);
    EXPECT_EQ(ball[3], 0) << "the corner is clear";
    EXPECT_NEAR(ball[(64 * 32 + 32) * 4], 0.8, 1e-3);
    EXPECT_EQ(ball[(64 * 32 + 32) * 4 + 3], 1);
    const std::string bundled = bundledStyleCards().front().id;
    EXPECT_EQ(run({"style", "show", bundled, "--json"}).facts().at("section"), "bundled");
    EXPECT_EQ(run({"style", "show", path("mine/ochre.png"), "--json"}).facts().at("section"), "mine");
    writeStyle(madeStyle("Apart"), path("apart.png"));
    EXPECT_EQ(run({"style", "show", path("apart.png"), "--json"}).facts().at("section"), "file");
    EXPECT_NE(run({"style", "show", "ochre"}).out.find("The maker"), std::string::npos);
}

TEST_F(WithStyles, ShowRefusesWhatIsNotThere) {
    mine().add(madeStyle("Ochre"));
    expectRefused({"style", "show", "ocher"}, 2, "did you mean ochre?");
    expectRefused({"style", "show", "zzzzzzzzzzzz"}, 2, "style list");
    expectRefused({"style", "show", path("absent.png")}, 3, "absent.png");
    expectRefused({"style", "show", "ochre", "-o", path("ball.jpg")}, 2, ".png");
    expectRefused({"style", "show", "ochre", "-o", path("none/ball.png")}, 2, "folder");
    expectRefused({"style", "show", path("mine/ochre.png"), "-o", path("mine/../mine/ochre.png")}, 2, "read from");
    for (const char* size : {"0", "8", "1e9", "many"}) {
        expectRefused({"style", "show", "ochre", "-o", path("ball.png"), "--size", size}, 2, "--size");
    }
    EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(WithStyles, RemoveSaysHowToBringItBack) {
    mine().add(madeStyle("Ochre"));
    const ProgramRun removed = run({"style", "remove", "ochre"});
    EXPECT_EQ(removed.code, 0) << removed.err;
    EXPECT_NE(removed.out.find("--restore"), std::string::npos) << removed.out;
    EXPECT_TRUE(mine().list().cards.empty());
    expectRefused({"style", "remove", "ochre"}, 3, "ochre");
    const ProgramRun back = run({"style", "remove", "ochre", "--restore", "--json"});
    EXPECT_EQ(back.facts().at("restored").at(0), "ochre");
    EXPECT_EQ(mine().list().cards.size(), 1U);
    expectRefused({"style", "remove", "ochre", "--restore"}, 3, "was removed of late");
    expectRefused({"style", "remove", "../mine/ochre"}, 3, "ochre");
    expectRefused({"style", "remove", bundledStyleCards().front().id}, 2, "comes with Limner");
    expectRefused({"style", "remove", "bundled:" + bundledStyleCards().front().id}, 2, "comes with Limner");
    expectRefused({"style", "remove"}, 2, "ID");
}

TEST_F(WithStyles, EveryMatcapCanBeAdded) {
    const auto folder = testing::testData("matcaps");
    if (!folder) {
        GTEST_SKIP();
    }
    std::vector<std::string> arguments{"style", "add"};
    for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
        if (entry.path().extension() != ".txt") {
            arguments.push_back(entry.path().string());
        }
    }
    const std::size_t pictures = arguments.size() - 2;
    ASSERT_GT(pictures, 20U);
    arguments.emplace_back("--json");
    const ProgramRun added = run(arguments);
    ASSERT_EQ(added.code, 0) << added.err;
    EXPECT_EQ(added.facts().at("styles").size(), pictures);
    const StyleLibrary::Listing listing = mine().list();
    EXPECT_EQ(listing.cards.size(), pictures);
    EXPECT_TRUE(listing.problems.empty());
    for (const StyleCard& card : listing.cards) {
        const Style style = mine().load(card.id);
        EXPECT_GT(style.sphere->mean().a, 0.99) << card.id << ": the disk is opaque";
    }
}

// ---- in figures

class WithStylesAndScan : public WithStyles {
  protected:
    void SetUp() override {
        WithStyles::SetUp();
        testing::writeNrrd(*makeHeadPhantom(32), path("head.nrrd"));
    }
    [[nodiscard]] ProgramRun rendered(const std::string& style, const std::string& out) const {
        return run({"render", path("head.nrrd"), "-o", path(out), "--size", "48x48", "--preset", "auto", "--set",
                    "/layers/0/transfer/nodes=[{\"at\":0,\"style\":\"x\"}]", "--set",
                    "/layers/0/transfer/nodes/0/style=" + style, "--set", "/layers/0/shading=style", "--json"});
    }
};

TEST_F(WithStylesAndScan, SetTakesAnyStyleByItsName) {
    mine().add(madeStyle("Ochre"));
    for (const std::string& style : {std::string("ochre"), path("mine/ochre.png"), bundledStyleCards().front().id}) {
        const ProgramRun r = rendered(style, "o.png");
        EXPECT_EQ(r.code, 0) << style << r.err;
    }
    const ProgramRun none = rendered("no-such-style", "none.png");
    EXPECT_EQ(none.code, 2);
    EXPECT_NE(none.err.find("no-such-style"), std::string::npos) << none.err;
    EXPECT_FALSE(exists("none.png"));
}

TEST_F(WithStylesAndScan, AProjectMadeWithAnOwnStyleHoldsIt) {
    mine().add(madeStyle("Ochre"));
    const ProgramRun made =
        run({"new", path("head.nrrd"), "-o", path("head.limner"), "--size", "48x48", "--set",
             "/layers/0/transfer/nodes=[{\"at\":0,\"style\":\"ochre\"}]", "--set", "/layers/0/shading=style"});
    ASSERT_EQ(made.code, 0) << made.err;
    ASSERT_EQ(run({"render", path("head.limner"), "-o", path("before.png")}).code, 0);
    std::filesystem::remove_all(path("mine"));
    const ProgramRun after = run({"render", path("head.limner"), "-o", path("after.png"), "--json"});
    ASSERT_EQ(after.code, 0) << after.err;
    EXPECT_TRUE(after.facts().at("warnings").empty()) << after.out;
    EXPECT_EQ(pixelsOf(path("before.png"), 48, 3), pixelsOf(path("after.png"), 48, 3));
}

} // namespace
} // namespace limner
