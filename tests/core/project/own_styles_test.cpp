#include "core/figure/style_edits.h"
#include "core/figure/transfer_edits.h"
#include "core/project/archive.h"
#include "core/project/project.h"
#include "core/style/png_writing.h"
#include "core/style/style_files.h"
#include "core/style/style_library.h"
#include "core/style/texture_tile.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>

namespace limner {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const LitSphere> graded(float blue) {
    std::vector<Rgba> pixels;
    for (int i = 0; i < 32 * 32; ++i) {
        pixels.push_back({static_cast<float>(i % 32) / 31, static_cast<float>(i) / 1023, blue, 1});
    }
    return std::make_shared<const LitSphere>(32, pixels);
}

/// A user's folder with a style that has everything, and a figure that is drawn with it.
class OwnStyles : public ::testing::Test {
  protected:
    OwnStyles() : library_(folder_.path() / "library") {
        Style style;
        style.card = {"", "Dürer's ochre", {"warm"}, "lion.png, circle 10,20,5", "A. Dürer", "public domain"};
        style.sphere = graded(0.25F);
        style.texture = std::make_shared<const TextureTile>(16, std::vector<Rgba>(256, Rgba{0.5F, 1, 1.5F, 1}));
        library_.add(style);
        Layer layer;
        layer.transfer.nodes = {{100, "", glm::dvec3(1, 0, 0)}};
        layer.transfer.opacity = {{0, 0}, {200, 1}};
        document_.figure.layers = {layer};
        document_.figure = withStyle(document_.figure, 0, 0, library_.load("durer-s-ochre"));
    }

    [[nodiscard]] Document saved(const std::string& name) {
        saveDocument(document_, folder_.path() / name, {}, task_);
        return opened(name);
    }
    [[nodiscard]] Document opened(const std::string& name) {
        return openDocument(folder_.path() / name, "", {}, task_);
    }
    [[nodiscard]] std::set<std::string> entriesOf(const std::string& name) const {
        const Archive archive(folder_.path() / name);
        std::set<std::string> names;
        for (const ArchiveEntry& entry : archive.entries()) {
            names.insert(entry.name);
        }
        return names;
    }

    TemporaryFolder folder_;
    StyleLibrary library_;
    Task task_;
    Document document_;
};

const std::set<std::string> kEntries{"figure.json", "styles/durer-s-ochre.png", "styles/durer-s-ochre.json",
                                     "styles/durer-s-ochre-texture.png"};

TEST_F(OwnStyles, AProjectNeedsNoLibrary) {
    static_cast<void>(saved("figure.limner"));
    EXPECT_EQ(entriesOf("figure.limner"), kEntries);
    fs::remove_all(library_.folder());
    const Document again = opened("figure.limner");
    EXPECT_TRUE(again.notes.empty());
    ASSERT_EQ(again.figure.styles.size(), 1U);
    const StyleEntry& entry = again.figure.styles[0];
    EXPECT_EQ(entry.file, "styles/durer-s-ochre.png");
    EXPECT_EQ(entry.credit, "A. Dürer");
    EXPECT_EQ(entry.licence, "public domain");
    const StyleEntry& before = document_.figure.styles[0];
    ASSERT_NE(entry.sphere, nullptr);
    EXPECT_TRUE(std::equal(entry.sphere->pixels().begin(), entry.sphere->pixels().end(),
                           before.sphere->pixels().begin(), before.sphere->pixels().end()))
        << "bit for bit";
    ASSERT_TRUE(entry.texture && entry.texture->tile);
    EXPECT_EQ(entry.texture->file, "styles/durer-s-ochre-texture.png");
    EXPECT_EQ(entry.texture->tile->pixels(), before.texture->tile->pixels());
    const Archive archive(folder_.path() / "figure.limner");
    const auto card = nlohmann::json::parse(archive.read(*archive.find("styles/durer-s-ochre.json")));
    EXPECT_EQ(card.at("origin"), "lion.png, circle 10,20,5");
    EXPECT_EQ(card.at("tags"), nlohmann::json({"warm"}));
    for (const ArchiveEntry& e : archive.entries()) {
        if (e.name.ends_with(".json")) {
            EXPECT_EQ(archive.read(e).find(folder_.path().string()), std::string::npos)
                << e.name << " names a place on this machine";
        }
    }
}

TEST_F(OwnStyles, SavingAgainAddsNothing) {
    saveDocument(document_, folder_.path() / "figure.limner", {}, task_);
    document_.path = folder_.path() / "figure.limner"; // as the studio goes on: the figure is as it was
    for (int i = 0; i < 3; ++i) {
        saveDocument(document_, document_.path, {}, task_);
        EXPECT_EQ(entriesOf("figure.limner"), kEntries);
    }
    document_.figure.styles[0].credit = "Albrecht Dürer";
    saveDocument(document_, document_.path, {}, task_);
    const Archive archive(document_.path);
    EXPECT_EQ(nlohmann::json::parse(archive.read(*archive.find("styles/durer-s-ochre.json"))).at("credit"),
              "Albrecht Dürer");
    const Document again = opened("figure.limner");
    saveDocument(again, folder_.path() / "copy.limner", {}, task_);
    EXPECT_EQ(entriesOf("copy.limner"), kEntries);
}

TEST_F(OwnStyles, AnotherPictureUnderTheSameIdReplacesNone) {
    saveDocument(document_, folder_.path() / "figure.limner", {}, task_);
    Document other = document_;
    other.path = folder_.path() / "figure.limner";
    other.figure.styles[0].sphere = graded(0.75F);
    saveDocument(other, other.path, {}, task_);
    const Document again = opened("figure.limner");
    EXPECT_EQ(again.figure.styles[0].file, "styles/durer-s-ochre_.png");
    EXPECT_NEAR(again.figure.styles[0].sphere->mean().b, 0.75, 1e-4);
    EXPECT_TRUE(entriesOf("figure.limner").contains("styles/durer-s-ochre.png")) << "undo may want it";
}

TEST_F(OwnStyles, ABareFigureGetsThePictureBeside) {
    document_.path = folder_.path() / "figure.json";
    const Document again = saved("figure.json");
    EXPECT_EQ(again.figure.styles[0].file, "styles/durer-s-ochre.png");
    fs::remove_all(library_.folder());
    const Document moved = opened("figure.json");
    EXPECT_TRUE(moved.notes.empty());
    EXPECT_NE(moved.figure.styles[0].sphere, nullptr);
    EXPECT_NE(moved.figure.styles[0].texture->tile, nullptr);
    EXPECT_EQ(loadStyleCard(folder_.path() / "styles/durer-s-ochre.json").licence, "public domain");
    // A second figure in the same folder has its own picture of that name.
    document_.figure.styles[0].sphere = graded(0.75F);
    document_.path = folder_.path() / "second.json";
    EXPECT_EQ(saved("second.json").figure.styles[0].file, "styles/durer-s-ochre_.png");
    EXPECT_NEAR(opened("figure.json").figure.styles[0].sphere->mean().b, 0.25, 1e-4);
    EXPECT_EQ(saved("second.json").figure.styles[0].file, "styles/durer-s-ochre_.png") << "and keeps it";
}

TEST_F(OwnStyles, AFullPathIsFoundAgainWhereNothingWasEmbedded) {
    document_.figure.styles[0].sphere = nullptr; // the folder was not mounted
    document_.figure.styles[0].texture->tile = nullptr;
    for (const std::string name : {"figure.limner", "figure.json"}) {
        const Document again = saved(name);
        EXPECT_NE(again.figure.styles[0].sphere, nullptr) << name;
        EXPECT_NE(again.figure.styles[0].texture->tile, nullptr) << name;
    }
    fs::remove_all(library_.folder());
    const Document lost = opened("figure.limner");
    EXPECT_EQ(lost.notes.size(), 2U);
    EXPECT_EQ(lost.figure.styles[0].file, document_.figure.styles[0].file) << "for the day it is back";
}

TEST_F(OwnStyles, BrokenCardsKeepNothingFromBeingSaved) {
    std::ofstream(library_.folder() / "durer-s-ochre.json") << "{ broken";
    EXPECT_EQ(saved("figure.limner").figure.styles[0].credit, "A. Dürer");
    fs::create_directories(folder_.path() / "styles");
    std::ofstream(folder_.path() / "styles/durer-s-ochre.json") << "broken too";
    EXPECT_EQ(saved("figure.json").figure.styles[0].credit, "A. Dürer");
}

TEST_F(OwnStyles, AStyleOfAProjectIsRecognisedInTheLibrary) {
    Document again = saved("figure.limner");
    const Figure before = again.figure;
    EXPECT_EQ(joinStyle(again.figure, library_.load("durer-s-ochre")), "durer-s-ochre");
    EXPECT_EQ(again.figure.styles.size(), 1U);
    const std::vector<Style> offered = projectStyles(again.figure);
    ASSERT_EQ(offered.size(), 1U);
    EXPECT_EQ(withStyle(again.figure, 0, 0, offered[0]), again.figure);
}

} // namespace
} // namespace limner
