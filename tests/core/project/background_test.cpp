// The picture behind a figure: found, kept in the project, and told where it is not there.
#include "core/base/error.h"
#include "core/figure/figure_json.h"
#include "core/project/archive.h"
#include "core/project/project.h"
#include "core/style/background_picture.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <fstream>
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

fs::path writePicture(const fs::path& path, int width) {
    OIIO::ImageSpec spec(width, 2, 3, OIIO::TypeDesc::UINT8);
    const std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width) * 6, 90);
    const auto output = OIIO::ImageOutput::create(path.string());
    EXPECT_TRUE(output->open(path.string(), spec) && output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) &&
                output->close());
    return path;
}

Document withBackground(const fs::path& picture) {
    Document document;
    document.figure.background.kind = "image";
    document.figure.background.file = picture.string();
    document.figure.background.picture = std::make_shared<const BackgroundPicture>(picture);
    return document;
}

class ProjectBackground : public ::testing::Test {
  protected:
    [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }
    Document open(const std::string& name) { return openDocument(path(name), "", {}, task_); }
    TemporaryFolder folder_;
    Task task_;
};

TEST_F(ProjectBackground, GoesIntoTheProjectByteForByte) {
    const fs::path art = writePicture(path("art.PNG"), 7);
    const std::string bytes = bytesOf(art);
    saveDocument(withBackground(art), path("a.limner"), {}, task_);
    fs::remove(art);
    Document opened = open("a.limner");
    EXPECT_TRUE(opened.notes.empty());
    EXPECT_EQ(opened.figure.background.file, "background.png");
    ASSERT_NE(opened.figure.background.picture, nullptr);
    EXPECT_EQ(opened.figure.background.picture->size(), glm::ivec2(7, 2));
    EXPECT_EQ(bytesOf(opened.figure.background.picture->file()), bytes);
    EXPECT_NE(opened.figure.background.picture->covering({4, 4}, 1 << 20), nullptr);

    // Again and again: one picture, whichever is the figure's now.
    saveDocument(opened, path("a.limner"), {}, task_);
    Document other = withBackground(writePicture(path("other.jpg"), 9));
    other.path = path("a.limner");
    saveDocument(other, path("a.limner"), {}, task_);
    const Archive archive(path("a.limner"));
    EXPECT_EQ(archive.find("background.png"), nullptr);
    ASSERT_NE(archive.find("background.jpg"), nullptr);
    EXPECT_EQ(open("a.limner").figure.background.picture->size().x, 9);
    // An undone choice is saved from what the document holds.
    opened.path = path("a.limner");
    saveDocument(opened, path("a.limner"), {}, task_);
    EXPECT_EQ(open("a.limner").figure.background.picture->size().x, 7);
}

TEST_F(ProjectBackground, OfABareFigureStaysWhereItIs) {
    fs::create_directories(path("pictures"));
    saveDocument(withBackground(writePicture(path("pictures/art.png"), 7)), path("figure.json"), {}, task_);
    const Document opened = open("figure.json");
    EXPECT_EQ(opened.figure.background.file, "pictures/art.png");
    ASSERT_NE(opened.figure.background.picture, nullptr);
    EXPECT_EQ(opened.figure.background.picture->size().x, 7);
    // Out of an archive it is written beside the figure.
    saveDocument(opened, path("a.limner"), {}, task_);
    fs::create_directories(path("there"));
    saveDocument(open("a.limner"), path("there/figure.json"), {}, task_);
    EXPECT_EQ(bytesOf(path("there/background.png")), bytesOf(path("pictures/art.png")));
    EXPECT_NE(open("there/figure.json").figure.background.picture, nullptr);
}

TEST_F(ProjectBackground, OfAFormatThatProjectsDoNotHoldStaysWhereItIs) {
    const fs::path art = writePicture(path("art.bmp"), 7);
    saveDocument(withBackground(art), path("a.limner"), {}, task_);
    const Document opened = open("a.limner");
    EXPECT_EQ(opened.figure.background.file, art.string());
    ASSERT_NE(opened.figure.background.picture, nullptr);
    EXPECT_EQ(opened.figure.background.picture->size().x, 7);
}

TEST_F(ProjectBackground, ThatIsNotThereIsANote) {
    std::ofstream(path("none.json")) << R"({"limner": 1, "background": {"kind": "image", "file": "none.png"}})";
    const Document missing = open("none.json");
    ASSERT_EQ(missing.notes.size(), 1U);
    EXPECT_NE(missing.notes[0].find("none.png"), std::string::npos);
    EXPECT_EQ(missing.figure.background.picture, nullptr);
    std::ofstream(path("text.png")) << "no picture";
    std::ofstream(path("bad.json")) << R"({"limner": 1, "background": {"kind": "image", "file": "text.png"}})";
    const Document bad = open("bad.json");
    ASSERT_EQ(bad.notes.size(), 1U);
    EXPECT_NE(bad.notes[0].find("text.png"), std::string::npos);
    // What was not found is not forgotten.
    saveDocument(missing, path("kept.limner"), {}, task_);
    EXPECT_EQ(open("kept.limner").figure.background.file, "none.png");
}

TEST_F(ProjectBackground, ChangeOfIt) {
    Figure figure = withBackground(writePicture(path("a.png"), 7)).figure;
    Figure other = figure;
    other.background.picture = std::make_shared<const BackgroundPicture>(path("a.png"));
    EXPECT_NE(figure, other);
    EXPECT_EQ(diff(figure, other), ChangeCost::redraw);
}

} // namespace
} // namespace limner
