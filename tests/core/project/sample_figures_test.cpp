#include "core/project/sample_figures.h"

#include "core/base/error.h"
#include "core/figure/figure_json.h"
#include "core/figure/themes.h"
#include "core/project/archive.h"
#include "core/project/embedded_volume.h"
#include "core/project/figure_text.h"
#include "core/project/project.h"
#include "core/style/background_picture.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <fstream>

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::gridOf;
using testing::makeVolume;

Figure sample(const std::string& id) {
    const fs::path file = findSampleFigure(id).file;
    return readFigure(readFigureText(file), file.string());
}

/// A folder with a scan and, beside it, what the figure "skull-by-labels" calls its labels.
class Samples : public ::testing::Test {
  protected:
    TemporaryFolder temporary;
    Task task;

    fs::path in(const std::string& name) const { return temporary.path() / name; }

    void SetUp() override {
        const Grid grid = gridOf({24, 20, 16});
        writeNrrd(*makeVolume<std::int16_t>(grid, VoxelType::int16, [](glm::ivec3 v) { return v.x * 80 - 1000; }),
                  in("head.nrrd"), task);
        writeLabels("cranium_ct_labels.nrrd", 1);
        writeLabels("own.nrrd", 2);
    }

    void writeLabels(const std::string& name, int label) {
        const auto volume = makeVolume<std::uint8_t>(gridOf({24, 20, 16}), VoxelType::uint8,
                                                     [label](glm::ivec3 v) { return v.x < 4 ? 0 : label; });
        writeNrrd(*volume, in(name), task);
    }

    Document open(const std::string& scan, const std::string& id, const fs::path& labels = {}) {
        OpenOptions options;
        options.labels = labels;
        options.sample = id;
        return openDocument(in(scan), options, task);
    }
};

TEST_F(Samples, AreTitledAndDrawnWithWhatComesWithLimner) {
    for (const SampleFigure& card : sampleFigures()) {
        EXPECT_FALSE(card.title.empty()) << card.id;
        EXPECT_FALSE(card.scan.empty()) << card.id;
        EXPECT_EQ(fs::path(card.scan).filename(), card.scan) << card.id << ": no folder of somebody's machine";
        for (const StyleEntry& style : sample(card.id).styles) {
            ASSERT_TRUE(style.file.starts_with("bundled:")) << card.id;
            EXPECT_NE(findBundledStyle(style.file.substr(std::string("bundled:").size())), nullptr) << style.file;
            EXPECT_FALSE(style.role.empty()) << card.id << ": themes exchange every style";
        }
    }
}

TEST_F(Samples, LieOverAScanWithTheLabelsBesideIt) {
    const Document document = open("head.nrrd", "skull-by-labels");
    const Figure wanted = sample("skull-by-labels");
    EXPECT_TRUE(document.notes.empty()) << document.notes.front();
    EXPECT_TRUE(document.path.empty());
    EXPECT_EQ(document.figure.layers, wanted.layers);
    EXPECT_EQ(document.figure.camera, wanted.camera);
    EXPECT_EQ(document.figure.cleanup, wanted.cleanup);
    EXPECT_EQ(document.figure.volume->path, fs::canonical(in("head.nrrd")).string());
    ASSERT_NE(document.figure.volume->data, nullptr);
    ASSERT_NE(document.figure.labels->data, nullptr);
    EXPECT_EQ(document.figure.labels->data->range().high, 1);
    EXPECT_FALSE(document.volumeReport.sha256Values.empty());
}

TEST_F(Samples, TakeLabelsThatAreGivenAndSayWhichAreMissing) {
    EXPECT_EQ(open("head.nrrd", "skull-by-labels", in("own.nrrd")).figure.labels->data->range().high, 2);
    fs::remove(in("cranium_ct_labels.nrrd"));
    const Document without = open("head.nrrd", "skull-by-labels");
    ASSERT_EQ(without.notes.size(), 1U);
    EXPECT_NE(without.notes[0].find("cranium_ct_labels.nrrd"), std::string::npos) << without.notes[0];
}

TEST_F(Samples, StandBeforeTheirPlateAndKeepItInAProject) {
    const Document document = open("head.nrrd", "spheres-of-a-plate-1");
    ASSERT_NE(document.figure.background.picture, nullptr);
    saveDocument(document, in("plate.limner"), {}, task);
    const Document again = openDocument(in("plate.limner"), OpenOptions{}, task);
    EXPECT_NE(again.figure.background.picture, nullptr);
    EXPECT_TRUE(again.notes.empty());
}

TEST_F(Samples, AreNotLaidOverAFigure) {
    std::ofstream(in("figure.json")) << R"({"limner": 1})";
    try {
        open("figure.json", "contours-even");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
    EXPECT_THROW(open("head.nrrd", "contours-odd"), Error);
}

TEST_F(Samples, OfTheExchangeOfThemesAreOneSceneInTwoThemes) {
    std::vector<std::string> notes;
    const Figure exchanged = withTheme(sample("theme-exchange-a"), "textbook", notes);
    const Figure b = sample("theme-exchange-b");
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(exchanged.layers, b.layers);
    EXPECT_EQ(exchanged.camera, b.camera);
    EXPECT_EQ(exchanged.background.rgba, b.background.rgba);
    ASSERT_EQ(exchanged.styles.size(), b.styles.size());
    for (std::size_t i = 0; i < b.styles.size(); ++i) {
        EXPECT_EQ(exchanged.styles[i].file, b.styles[i].file);
        EXPECT_EQ(exchanged.styles[i].role, b.styles[i].role);
    }
}

} // namespace
} // namespace limner
