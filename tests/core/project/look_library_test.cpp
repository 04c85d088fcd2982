// The user's own looks: what is kept of a figure, and how it is laid over another.
#include "core/project/look_library.h"

#include "core/base/error.h"
#include "core/figure/look.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace limner {
namespace {

/// A volume whose 101 values run evenly from `low` to `high`: the first and last hundredth are known.
std::shared_ptr<const Volume> evenVolume(double low, double high, const std::string& unit) {
    Volume::Contents contents;
    contents.grid = testing::gridOf({101, 10, 10});
    contents.type = VoxelType::uint8;
    contents.slope = (high - low) / 100;
    contents.intercept = low;
    contents.range = {low, high};
    contents.unit = unit;
    std::vector<std::uint8_t> voxels;
    for (int i = 0; i < 101 * 100; ++i)
        voxels.push_back(static_cast<std::uint8_t>(i % 101));
    return std::make_shared<const Volume>(contents, std::as_bytes(std::span(voxels)));
}

Figure figureOf(std::shared_ptr<const Volume> volume) {
    Figure figure;
    figure.title = "Skull";
    figure.volume = VolumeReference{};
    figure.volume->data = std::move(volume);
    figure.volume->path = "scan.nrrd";
    figure.camera.heightMm = 77;
    figure.styles.push_back({"ochre", "styles/ochre.png", "Ochre", "me", "CC0",
                             std::make_shared<const LitSphere>(8, std::vector<Rgba>(64, Rgba{0.5F, 0.25F, 0.75F, 1}))});
    Layer layer;
    layer.name = "Bone";
    layer.transfer.nodes = {{500, "ochre", std::nullopt}};
    layer.transfer.opacity = {{250, 0}, {750, 1}};
    layer.clip = Clip{};
    layer.locked = true;
    figure.layers = {layer};
    figure.importance = Importance{};
    figure.importance->lenses = {Lens{}, Lens{}};
    figure.importance->lenses[1].anchorMm = glm::dvec3(1, 2, 3);
    figure.background.rgba = {0.5, 0.5, 0.5, 1};
    figure.annotations.push_back({});
    return figure;
}

TEST(Look, IsTheFigureWithoutItsSubject) {
    const Figure look = lookOf(figureOf(evenVolume(0, 1000, "HU")));
    EXPECT_FALSE(look.volume);
    EXPECT_EQ(look.camera, Camera{});
    EXPECT_TRUE(look.annotations.empty());
    EXPECT_EQ(look.background.rgba, glm::dvec4(0.5, 0.5, 0.5, 1));
    ASSERT_EQ(look.layers.size(), 1U);
    EXPECT_FALSE(look.layers[0].clip);
    EXPECT_FALSE(look.layers[0].locked);
    EXPECT_EQ(look.importance->lenses.size(), 1U) << "one hangs on a point of the scan";
}

TEST(Look, HounsfieldUnitsStayOtherValuesGoAlong) {
    const Figure look = lookOf(figureOf(evenVolume(0, 1000, "HU")));
    std::vector<std::string> notes;
    const Figure ct = withLook(figureOf(evenVolume(-1000, 3000, "HU")), look, notes);
    EXPECT_EQ(ct.layers[0].transfer.opacity[1].x, 750);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(ct.camera.heightMm, 77) << "the subject stays";
    EXPECT_EQ(ct.volume->path, "scan.nrrd");

    const Figure mr = withLook(figureOf(evenVolume(100, 300, "")), look, notes);
    EXPECT_EQ(notes.size(), 1U);
    // A quarter and three quarters of the way from 0 to 1000 are so from 100 to 300: to a bin of the histogram.
    EXPECT_NEAR(mr.layers[0].transfer.opacity[0].x, 150, 1);
    EXPECT_NEAR(mr.layers[0].transfer.opacity[1].x, 250, 1);
    EXPECT_NEAR(mr.layers[0].transfer.nodes[0].at, 200, 1);
}

struct Library : ::testing::Test {
    Library()
        : folder(std::filesystem::temp_directory_path() / ("looks-" + std::to_string(::getpid()))), looks(folder) {}
    ~Library() override { std::filesystem::remove_all(folder); }
    std::filesystem::path folder;
    LookLibrary looks;
    Task task;
};

TEST_F(Library, KeepsListsLoadsAndRemoves) {
    EXPECT_TRUE(looks.list().cards.empty());
    const std::vector<std::byte> picture(5, std::byte{7});
    const LookCard card = looks.add(figureOf(evenVolume(0, 1000, "HU")), "House / style", picture, task);
    EXPECT_EQ(card.name, "House / style");
    EXPECT_EQ(looks.add(figureOf(evenVolume(0, 1000, "HU")), "House / style", {}, task).name, "House / style 2");
    const LookLibrary::Listing listing = looks.list();
    ASSERT_EQ(listing.cards.size(), 2U);
    EXPECT_EQ(listing.cards[0].thumbnailPng, picture);
    const Figure loaded = looks.load(card.id, task);
    ASSERT_TRUE(loaded.findStyle("ochre"));
    ASSERT_TRUE(loaded.findStyle("ochre")->sphere) << "the styles are in the file";
    std::vector<std::string> notes;
    EXPECT_NEAR(withLook(figureOf(evenVolume(0, 200, "")), loaded, notes).layers[0].transfer.nodes[0].at, 100, 1)
        << "what the scan's values were is in the file";
    looks.remove(card.id);
    EXPECT_EQ(looks.list().cards.size(), 1U);
    EXPECT_THROW(looks.remove(card.id), Error);
    EXPECT_THROW(static_cast<void>(looks.load("../" + card.id, task)), Error);
}

TEST_F(Library, ABrokenFileIsALineAndTheOthersAreListed) {
    const LookCard card = looks.add(figureOf(evenVolume(0, 1000, "HU")), "Good", {}, task);
    std::ofstream(folder / "bad.limner") << "no zip";
    const LookLibrary::Listing listing = looks.list();
    ASSERT_EQ(listing.cards.size(), 1U);
    ASSERT_EQ(listing.problems.size(), 1U);
    EXPECT_NE(listing.problems[0].find("bad.limner"), std::string::npos);
    const LookCard again = looks.import(folder / (card.id + ".limner"), task);
    EXPECT_EQ(again.name, "Good 2");
    std::vector<std::string> notes;
    EXPECT_NEAR(
        withLook(figureOf(evenVolume(0, 200, "")), looks.load(again.id, task), notes).layers[0].transfer.nodes[0].at,
        100, 1);
}

} // namespace
} // namespace limner
