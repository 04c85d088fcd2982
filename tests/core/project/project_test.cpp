#include "core/base/error.h"
#include "core/figure/figure_json.h"
#include "core/project/archive.h"
#include "core/project/embedded_volume.h"
#include "core/project/project.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

namespace limner {
namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

Figure smallFigure() {
    Figure figure;
    figure.title = "A figure";
    Layer layer;
    layer.transfer.nodes.emplace_back().rgb = glm::dvec3(1, 0.5, 0);
    layer.transfer.opacity = {{0, 0}, {1, 1}};
    figure.layers = {layer};
    return figure;
}

std::shared_ptr<const Volume> rampVolume() {
    Volume::Contents contents;
    contents.grid.dims = {5, 4, 3};
    contents.grid.spacingMm = {0.5, 0.75, 2};
    contents.grid.originMm = {-10, 20, 30.5};
    contents.type = VoxelType::int16;
    contents.intercept = -1000;
    contents.range = {-1000, -1000 + 59};
    contents.modality = Modality::ct;
    std::vector<std::int16_t> numbers(60);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = static_cast<std::int16_t>(i);
    }
    return std::make_shared<const Volume>(contents, std::as_bytes(std::span(numbers)));
}

StyleEntry gradedStyle() {
    StyleEntry style;
    style.id = "own/style";
    style.name = "Own";
    style.credit = "The maker";
    style.licence = "CC0-1.0";
    style.file = "from/elsewhere.png";
    std::vector<Rgba> pixels;
    for (int i = 0; i < 64; ++i) {
        pixels.push_back({static_cast<float>(i) / 63, 0.25F, 0.5F, 1});
    }
    style.sphere = std::make_shared<const LitSphere>(8, pixels);
    return style;
}

TEST(Project, ComesBackAsItWasSaved) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "figure.limner";
    Task task;
    Document document;
    document.figure = smallFigure();
    document.figure.unknown = {{"/future", "{\"a\":1}"}};
    document.figure.styles = {gradedStyle()};
    saveDocument(document, path, {}, task);
    EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"figure.limner"});

    const Document again = openDocument(path, "", {}, task);
    EXPECT_EQ(again.figure.title, "A figure");
    EXPECT_EQ(again.figure.layers, document.figure.layers);
    EXPECT_EQ(again.figure.unknown, document.figure.unknown);
    ASSERT_EQ(again.figure.styles.size(), 1u);
    EXPECT_EQ(again.figure.styles[0].file, "styles/own_style.png");
    EXPECT_EQ(again.figure.styles[0].credit, "The maker");
    ASSERT_NE(again.figure.styles[0].sphere, nullptr);
    for (const double x : {-0.6, 0.0, 0.3}) {
        // Half a step of 16 bits, plus what the rim's continuation may round.
        EXPECT_NEAR(again.figure.styles[0].sphere->at(x, 0.1).r, document.figure.styles[0].sphere->at(x, 0.1).r, 2e-5);
    }
    ASSERT_FALSE(again.notes.empty()); // the unknown key is said
    EXPECT_NE(again.notes[0].find("/future"), std::string::npos);
}

TEST(Project, OpeningAndSavingLosesNothing) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "figure.limner";
    Task task;
    Document document;
    document.figure = smallFigure();
    document.figure.styles = {gradedStyle()};
    VolumeReference volume;
    volume.path = "gone.nrrd";
    volume.absolutePath = "/nowhere/gone.nrrd";
    volume.sha256 = "abc";
    volume.bytes = 42;
    document.figure.volume = volume;
    SaveOptions options;
    options.thumbnailPng.assign(100, std::byte{7});
    saveDocument(document, path, options, task);

    const Document opened = openDocument(path, "", {}, task);
    EXPECT_EQ(opened.figure.volume, document.figure.volume);
    EXPECT_TRUE(std::any_of(opened.notes.begin(), opened.notes.end(), [](const std::string& note) {
        return note.find("gone.nrrd") != std::string::npos && note.find("not found") != std::string::npos;
    }));
    const fs::path second = folder.path() / "second.limner";
    saveDocument(opened, second, {}, task);
    const Archive before(path);
    const Archive after(second);
    ASSERT_EQ(before.entries().size(), 4u); // figure, picture, card, thumbnail
    for (const ArchiveEntry& entry : before.entries()) {
        const ArchiveEntry* kept = after.find(entry.name);
        ASSERT_NE(kept, nullptr) << entry.name;
        EXPECT_EQ(after.read(*kept), before.read(entry)) << entry.name;
    }
}

TEST(Project, KeepsTwoBackups) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "figure.limner";
    Task task;
    Document document;
    document.figure = smallFigure();
    for (const char* title : {"one", "two", "three", "four"}) {
        document.figure.title = title;
        saveDocument(document, path, {}, task);
    }
    EXPECT_EQ(namesIn(folder.path()), (std::set<std::string>{"figure.limner", "figure.limner~", "figure.limner~~"}));
    EXPECT_EQ(openDocument(path, "", {}, task).figure.title, "four");
    EXPECT_EQ(openDocument(path.string() + "~", "", {}, task).figure.title, "three");
    EXPECT_EQ(openDocument(path.string() + "~~", "", {}, task).figure.title, "two");
}

TEST(Project, BareFiguresAreSavedWithTheirStylesBeside) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "figure.json";
    Task task;
    Document document;
    document.figure = smallFigure();
    document.figure.styles = {gradedStyle()};
    saveDocument(document, path, {}, task);
    const Document again = openDocument(path, "", {}, task);
    EXPECT_EQ(again.figure.layers, document.figure.layers);
    ASSERT_EQ(again.figure.styles.size(), 1u);
    EXPECT_NE(again.figure.styles[0].sphere, nullptr);
    EXPECT_TRUE(fs::exists(folder.path() / "styles/own_style.png"));
}

std::shared_ptr<const TextureTile> gradedTile() {
    std::vector<Rgba> pixels;
    for (int i = 0; i < 256; ++i) {
        pixels.push_back({static_cast<float>(i) / 128, 1, 0.25F, 1});
    }
    return std::make_shared<const TextureTile>(16, pixels);
}

TEST(Project, TexturesGoWithTheirStyles) {
    const TemporaryFolder folder;
    Task task;
    Document document;
    document.figure = smallFigure();
    document.figure.styles = {gradedStyle(), gradedStyle()};
    document.figure.styles[0].texture = StyleTexture{"from/elsewhere.png", 12, 0.5, gradedTile()};
    document.figure.styles[1].id = "second";
    document.figure.styles[1].file = "bundled:ivory-bone";
    document.figure.styles[1].texture = StyleTexture{"", 8, 1, gradedTile()};
    for (const char* name : {"figure.limner", "figure.json"}) {
        const fs::path path = folder.path() / name;
        saveDocument(document, path, {}, task);
        const Document again = openDocument(path, "", {}, task);
        ASSERT_EQ(again.figure.styles.size(), 2u);
        for (const StyleEntry& style : again.figure.styles) {
            ASSERT_TRUE(style.texture.has_value());
            ASSERT_NE(style.texture->tile, nullptr) << name;
            ASSERT_EQ(style.texture->tile->size(), 16);
            for (std::size_t i = 0; i < 256; ++i) {
                EXPECT_NEAR(style.texture->tile->pixels()[i].r, static_cast<double>(i) / 128, 2 / 65535.0);
            }
        }
        EXPECT_EQ(again.figure.styles[0].texture->file, "styles/own_style-texture.png");
        EXPECT_EQ(again.figure.styles[0].texture->sizeMm, 12);
        EXPECT_EQ(again.figure.styles[1].file, "bundled:ivory-bone");
        EXPECT_EQ(again.figure.styles[1].texture->file, "styles/second-texture.png");
        // Saved once more, the pictures go along as they are.
        const fs::path copy = folder.path() / (std::string("copy-") + name);
        saveDocument(again, copy, {}, task);
        const Document third = openDocument(copy, "", {}, task);
        EXPECT_EQ(third.figure.styles[0].texture->file, again.figure.styles[0].texture->file);
        ASSERT_NE(third.figure.styles[0].texture->tile, nullptr);
        EXPECT_EQ(third.figure.styles[0].texture->tile->pixels(), again.figure.styles[0].texture->tile->pixels());
    }
}

TEST(Project, MissingTexturesAreNotesAndStay) {
    const TemporaryFolder folder;
    Task task;
    Document document;
    document.figure = smallFigure();
    document.figure.styles = {gradedStyle(), gradedStyle()};
    document.figure.styles[0].texture = StyleTexture{"gone.png", 12, 0.5, nullptr};
    document.figure.styles[1].id = "second";
    document.figure.styles[1].texture = StyleTexture{"bundled:no-such-thing", 12, 0.5, nullptr};
    saveDocument(document, folder.path() / "figure.limner", {}, task);
    const Document again = openDocument(folder.path() / "figure.limner", "", {}, task);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string& file = document.figure.styles[i].texture->file;
        EXPECT_EQ(again.figure.styles[i].texture, document.figure.styles[i].texture);
        EXPECT_TRUE(std::any_of(again.notes.begin(), again.notes.end(), [&](const std::string& note) {
            return note.find("texture") != std::string::npos && note.find(file) != std::string::npos;
        })) << file;
    }
}

TEST(Project, ScansAreFoundBesideTheProjectAndCheckedForChange) {
    const TemporaryFolder folder;
    Task task;
    const std::string sum = writeNrrd(*rampVolume(), folder.path() / "scan.nrrd", task);
    Document document;
    document.figure = smallFigure();
    VolumeReference volume;
    volume.path = "scan.nrrd";
    volume.sha256 = sum;
    document.figure.volume = volume;
    const fs::path path = folder.path() / "figure.limner";
    saveDocument(document, path, {}, task);
    const Document found = openDocument(path, "", {}, task);
    ASSERT_NE(found.figure.volume->data, nullptr);
    EXPECT_TRUE(found.notes.empty()) << found.notes[0];
    EXPECT_EQ(found.volumeReport.sha256Values, sum);

    // Project and scan move together; only the relative path still holds.
    const fs::path moved = folder.path() / "moved";
    fs::create_directory(moved);
    saveDocument(found, path, {}, task);
    fs::rename(path, moved / "figure.limner");
    fs::rename(folder.path() / "scan.nrrd", moved / "scan.nrrd");
    EXPECT_NE(openDocument(moved / "figure.limner", "", {}, task).figure.volume->data, nullptr);
    // The project moves alone: the absolute path holds.
    const Document again = openDocument(moved / "figure.limner", "", {}, task);
    saveDocument(again, folder.path() / "figure.limner", {}, task);
    EXPECT_EQ(openDocument(folder.path() / "figure.limner", "", {}, task).figure.volume->path, "moved/scan.nrrd");

    document.figure.volume->sha256 = "0000";
    saveDocument(document, moved / "other.limner", {}, task);
    const Document changed = openDocument(moved / "other.limner", "", {}, task);
    ASSERT_EQ(changed.notes.size(), 1u);
    EXPECT_NE(changed.notes[0].find("has changed"), std::string::npos);
}

TEST(Project, EmbeddedScansTravelInside) {
    const TemporaryFolder folder;
    Task task;
    Document document;
    document.figure = smallFigure();
    document.figure.volume.emplace();
    document.figure.volume->path = "scan.nrrd";
    document.figure.volume->data = rampVolume();
    SaveOptions options;
    options.embedVolume = true;
    const fs::path path = folder.path() / "figure.limner";
    saveDocument(document, path, options, task);
    const Document again = openDocument(path, "", {}, task);
    EXPECT_TRUE(again.notes.empty()) << again.notes[0];
    ASSERT_NE(again.figure.volume->data, nullptr);
    const Volume& want = *document.figure.volume->data;
    const Volume& have = *again.figure.volume->data;
    EXPECT_EQ(have.grid().dims, want.grid().dims);
    EXPECT_EQ(have.grid().originMm, want.grid().originMm);
    EXPECT_EQ(have.grid().spacingMm, want.grid().spacingMm);
    EXPECT_EQ(have.contents().modality, Modality::ct);
    for (int i = 0; i < 60; ++i) {
        const glm::ivec3 voxel(i % 5, i / 5 % 4, i / 20);
        EXPECT_EQ(have.valueAt(voxel), want.valueAt(voxel));
    }
    saveDocument(again, folder.path() / "copy.limner", {}, task); // embedded stays embedded
    EXPECT_NE(openDocument(folder.path() / "copy.limner", "", {}, task).figure.volume->data, nullptr);
}

TEST(Project, CancelledSavesLeaveTheOldFile) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "figure.limner";
    Document document;
    document.figure = smallFigure();
    Task task;
    saveDocument(document, path, {}, task);
    const std::string before = bytesOf(path);
    Task stopped;
    stopped.cancel();
    document.figure.title = "never";
    EXPECT_THROW(saveDocument(document, path, {}, stopped), Error);
    EXPECT_EQ(bytesOf(path), before);
    EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"figure.limner"});
}

} // namespace
} // namespace limner
