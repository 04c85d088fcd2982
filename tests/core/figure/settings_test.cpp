#include "core/base/error.h"
#include "core/figure/figure_json.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

std::string refusal(const Figure& figure, const std::string& assignment) {
    try {
        withSetting(figure, assignment);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << assignment;
    return "";
}

TEST(Settings, SetScalarsWordsAndVectors) {
    Figure figure = withSetting({}, "/camera/height_mm=123.5");
    EXPECT_EQ(figure.camera.heightMm, 123.5);
    figure = withSetting(figure, "/camera/projection=perspective");
    EXPECT_EQ(figure.camera.projection, Projection::perspective);
    figure = withSetting(figure, "/camera/projection=\"orthographic\"");
    EXPECT_EQ(figure.camera.projection, Projection::orthographic);
    figure = withSetting(figure, "/camera/target_mm=[1, 2, 3]");
    EXPECT_EQ(figure.camera.targetMm, glm::dvec3(1, 2, 3));
    figure = withSetting(figure, "/camera/target_mm/1=-7");
    EXPECT_EQ(figure.camera.targetMm, glm::dvec3(1, -7, 3));
    EXPECT_TRUE(withSetting(figure, "/output/transparent=true").output.transparent);
}

TEST(Settings, TextStaysText) {
    EXPECT_EQ(withSetting({}, "/title=2024").title, "2024");
    EXPECT_EQ(withSetting({}, "/title=a=b").title, "a=b");
    EXPECT_EQ(withSetting({}, "/title=\"quoted \\\" text\"").title, "quoted \" text");
    EXPECT_EQ(withSetting({}, "/title=\"half quoted").title, "\"half quoted");
    EXPECT_EQ(withSetting({}, "/title=tab\tand \\ line").title, "tab\tand \\ line");
    EXPECT_EQ(withSetting({}, "/title=").title, "");
}

TEST(Settings, MakesPartsAndItemsOnTheWay) {
    Figure figure = withSetting({}, "/layers/0/contours/thickness_mm=2");
    ASSERT_EQ(figure.layers.size(), 1u);
    ASSERT_TRUE(figure.layers[0].contours);
    EXPECT_EQ(figure.layers[0].contours->thicknessMm, 2);
    EXPECT_EQ(figure.layers[0].contours->probeVoxels, Contours{}.probeVoxels);
    figure = withSetting(figure, "/layers/-/name=Skin");
    ASSERT_EQ(figure.layers.size(), 2u);
    EXPECT_EQ(figure.layers[1].name, "Skin");
    figure = withSetting(figure, "/layers/1/transfer/opacity/-=[100, 0.5]");
    EXPECT_EQ(figure.layers[1].transfer.opacity, (std::vector<glm::dvec2>{{100, 0.5}}));
    figure = withSetting(figure, "/layers/1/transfer/nodes/0/rgb/2=1");
    EXPECT_EQ(figure.layers[1].transfer.nodes[0].rgb, glm::dvec3(0, 0, 1));
    figure = withSetting(figure, "/layers/0/transfer/nodes/x=[1, 2]");
    EXPECT_EQ(figure.layers[0].transfer.grid->x, (std::vector<double>{1, 2}));
    figure = withSetting(figure, "/labels/names/7=femur");
    EXPECT_EQ(figure.labels->names.at("7"), "femur");
    EXPECT_EQ(withSetting({}, "/clip/planes/-/offset_mm=4").clip.planes.front().offsetMm, 4);
    EXPECT_EQ(withSetting({}, "/stipple={}").stipple, Stipple{});
    EXPECT_EQ(withSetting({}, R"(/layers/-={"name": "A", "opacity": 0.5})").layers[0].opacity, 0.5);
}

TEST(Settings, NullRemoves) {
    Figure figure;
    figure.layers.resize(3);
    figure.layers[1].contours.emplace();
    figure.layers[2].name = "last";
    figure.camera.heightMm = 7;
    figure.unknown = {{"/layers/2/fur", "1"}, {"/layers/0/hair", "2"}, {"/future", "3"}};
    EXPECT_FALSE(withSetting(figure, "/layers/1/contours=null").layers[1].contours);
    const Figure fewer = withSetting(figure, "/layers/1=null");
    ASSERT_EQ(fewer.layers.size(), 2u);
    EXPECT_EQ(fewer.layers[1].name, "last");
    EXPECT_EQ(fewer.unknown, (UnknownMembers{{"/layers/1/fur", "1"}, {"/layers/0/hair", "2"}, {"/future", "3"}}));
    EXPECT_EQ(withSetting(figure, "/camera/height_mm=null").camera.heightMm, Camera{}.heightMm);
    EXPECT_EQ(withSetting(figure, "/stipple=null"), figure);
    EXPECT_EQ(withSetting(figure, "/stipple/boundary/kge=null"), figure);
    EXPECT_EQ(withSetting(figure, "/layers/9=null"), figure);
    EXPECT_EQ(withSetting(figure, "/future=null").unknown.count("/future"), 0u);
    EXPECT_EQ(withSetting(figure, "/layers=[]").unknown, (UnknownMembers{{"/future", "3"}}));
    refusal(figure, "/camera/up/1=null");
}

TEST(Settings, RefusalsSayWhatIsLegal) {
    EXPECT_NE(refusal({}, "/camera/hieght_mm=3").find("did you mean \"height_mm\""), std::string::npos);
    EXPECT_NE(refusal({}, "/camra/height_mm=3").find("did you mean \"camera\""), std::string::npos);
    EXPECT_NE(refusal({}, "/xyzzyplugh=3").find("known here: title, volume"), std::string::npos);
    EXPECT_NE(refusal({}, "/camera/height_mm=-3").find("a number > 0"), std::string::npos);
    EXPECT_NE(refusal({}, "/camera/projection=oblique").find("\"perspective\""), std::string::npos);
    EXPECT_NE(refusal({}, "/camera/height_mm/x=3").find("has no parts"), std::string::npos);
    EXPECT_NE(refusal({}, "/camera={\"zoom\": 2}").find("/camera/zoom"), std::string::npos);
    refusal({}, "camera/height_mm=3");
    refusal({}, "/camera/height_mm");
    refusal({}, "=3");
    refusal({}, "/camera/height_mm=");
    refusal({}, "/layers/1000000/name=x");
    refusal({}, "/layers/99999999999999999999/name=x");
    refusal({}, "/layers/-1/name=x");
    refusal({}, "/camera/up/3=1");
    refusal({}, "/a~2b=1");
}

TEST(Settings, AnotherPathForgetsTheOldScan) {
    Figure figure;
    figure.volume.emplace();
    figure.volume->path = "old.nrrd";
    figure.volume->absolutePath = "/data/old.nrrd";
    figure.volume->sha256 = "abc";
    figure.volume->embedded = true;
    const Figure other = withSetting(figure, "/volume/path=new.nrrd");
    EXPECT_EQ(other.volume->path, "new.nrrd");
    EXPECT_EQ(other.volume->sha256, "");
    EXPECT_EQ(other.volume->absolutePath, "");
    EXPECT_FALSE(other.volume->embedded);
    EXPECT_EQ(withSetting(figure, "/title=x").volume, figure.volume);
}

TEST(Settings, AnotherFileForgetsTheOldTexture) {
    Figure figure;
    StyleEntry& entry = figure.styles.emplace_back();
    entry.id = "stone";
    entry.texture.emplace();
    entry.texture->file = "bundled:marble";
    entry.texture->tile = std::make_shared<const TextureTile>(1, std::vector<Rgba>(1));
    EXPECT_EQ(withSetting(figure, "/styles/0/texture/file=bundled:wood").styles[0].texture->tile, nullptr);
    EXPECT_NE(withSetting(figure, "/styles/0/texture/strength=0.5").styles[0].texture->tile, nullptr);
}

TEST(Diff, TellsWhatAnEditCosts) {
    Figure figure;
    figure.layers.resize(2);
    figure.layers[0].transfer.opacity = {{0, 0}, {1, 1}};
    const auto cost = [&](const std::string& assignment) { return diff(figure, withSetting(figure, assignment)); };
    EXPECT_EQ(diff(figure, figure), ChangeCost::none);
    EXPECT_EQ(cost("/title=x"), ChangeCost::none);
    EXPECT_EQ(cost("/annotations/-/text=x"), ChangeCost::redraw);
    EXPECT_EQ(cost("/camera/direction=[1, 0, 0]"), ChangeCost::redraw);
    EXPECT_EQ(cost("/layers/0/transfer/opacity/1/1=0.5"), ChangeCost::newTables);
    EXPECT_EQ(cost("/layers/0/name=x"), ChangeCost::none);
    EXPECT_EQ(cost("/layers/0/visible=false"), ChangeCost::newPlan);
    EXPECT_EQ(cost("/layers/1=null"), ChangeCost::newPlan);
    EXPECT_EQ(cost("/layers/0/contours={}"), ChangeCost::newPlan);
    EXPECT_EQ(cost("/cleanup/-/above=3"), ChangeCost::newFields);
    EXPECT_EQ(cost("/quality/gradient=sobel"), ChangeCost::newFields);
    EXPECT_EQ(cost("/volume/path=x"), ChangeCost::newVolume);

    Figure cleaned = figure;
    cleaned.cleanup.emplace_back().camera.emplace();
    EXPECT_EQ(diff(cleaned, withSetting(cleaned, "/cleanup/0/camera/height_mm=9")), ChangeCost::newFields);

    Figure styled = figure;
    styled.styles.emplace_back();
    Figure resolved = styled;
    resolved.styles[0].sphere = std::make_shared<const LitSphere>(4, std::vector<Rgba>(16));
    EXPECT_EQ(diff(styled, resolved), ChangeCost::newTables);
}

} // namespace
} // namespace limner
