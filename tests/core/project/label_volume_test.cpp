#include "core/project/label_volume.h"

#include "core/base/error.h"
#include "core/figure/label_look.h"
#include "core/project/archive.h"
#include "core/project/embedded_volume.h"
#include "core/project/project.h"
#include "support/make_volume.h"
#include "support/test_data.h"

#include <gtest/gtest.h>

#include <fstream>

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::gridOf;
using testing::makeVolume;

/// A folder with a scan, its labels 1 and 2, and a table that also names a label 3, which does not occur.
class Labels : public ::testing::Test {
  protected:
    TemporaryFolder temporary;
    Task task;
    std::vector<std::string> notes;
    Grid grid = gridOf({24, 20, 16});

    fs::path in(const std::string& name) const { return temporary.path() / name; }

    void SetUp() override {
        const auto scan =
            makeVolume<std::int16_t>(grid, VoxelType::int16, [](glm::ivec3 v) { return v.x * 40 - 1000; });
        writeNrrd(*scan, in("scan.nrrd"), task);
        writeLabels("labels.nrrd", grid);
        std::ofstream(in("labels.txt")) << "1 femur 10 20 30\n2 tibia 40 50 60\n3 fibula 70 80 90\n";
    }

    void writeLabels(const std::string& name, const Grid& place) {
        const auto labels = makeVolume<std::uint8_t>(place, VoxelType::uint8, [](glm::ivec3 v) {
            return v.x < 4 ? 0 : v.y < 8 ? 1 : 2;
        });
        writeNrrd(*labels, in(name), task);
    }

    LabelReference open(const std::string& name) {
        LabelRequest request;
        request.scan = makeVolume<std::int16_t>(grid, VoxelType::int16, [](glm::ivec3 v) { return v.x; });
        return openLabels(in(name), request, notes, task);
    }

    void expectRefused(const std::string& name, const std::string& why) {
        try {
            open(name);
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
};

TEST_F(Labels, TakeNamesAndColoursOfWhatOccurs) {
    const LabelReference labels = open("labels.nrrd");
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(labels.names, (std::map<std::string, std::string>{{"1", "femur"}, {"2", "tibia"}}));
    EXPECT_EQ(labels.colours, (std::map<std::string, std::string>{{"1", "#0a141e"}, {"2", "#28323c"}}));
    EXPECT_EQ(labels.data->contents().modality, Modality::labels);
    EXPECT_EQ(labels.path, fs::canonical(in("labels.nrrd")).string());
}

TEST_F(Labels, AreRefusedWhereTheyFitNoScan) {
    const auto halves = makeVolume<float>(
        grid, VoxelType::float32, [](glm::ivec3 v) { return v.x / 46.0; }, 23);
    writeNrrd(*halves, in("halves.nrrd"), task);
    expectRefused("halves.nrrd", "not whole numbers");
    expectRefused("gone.nrrd", "no such file");
    Grid away = grid;
    away.originMm.x = 1000;
    writeLabels("away.nrrd", away);
    expectRefused("away.nrrd", "outside the scan");
}

TEST_F(Labels, OnAnotherGridAreTakenAndLittleCoverIsSaid) {
    Grid other = grid;
    other.spacingMm = {2, 1.25, 3};
    writeLabels("other.nrrd", other);
    EXPECT_EQ(open("other.nrrd").data->grid().spacingMm, other.spacingMm);
    EXPECT_TRUE(notes.empty());
    Grid quarter = grid;
    quarter.originMm.x = 18;
    writeLabels("quarter.nrrd", quarter);
    open("quarter.nrrd");
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("only 25 %"), std::string::npos) << notes[0];
}

TEST_F(Labels, OfAScanAreDrawnAndComeBackWithTheProject) {
    const Document fresh = openDocument(in("scan.nrrd"), OpenOptions{"", in("labels.nrrd"), {}}, task);
    EXPECT_TRUE(drawsByLabel(fresh.figure));
    fs::create_directory(in("project"));
    const fs::path path = in("project") / "figure.limner";
    saveDocument(fresh, path, {}, task);

    Document again = openDocument(path, OpenOptions{}, task);
    EXPECT_TRUE(again.notes.empty()) << again.notes[0];
    EXPECT_EQ(again.figure.labels->path, "../labels.nrrd");
    EXPECT_EQ(again.figure.labels->names, fresh.figure.labels->names);
    EXPECT_EQ(again.figure.layers, fresh.figure.layers);
    ASSERT_NE(again.figure.labels->data, nullptr);
    EXPECT_EQ(again.figure.labels->data->grid(), grid);

    // The document's own words win over the table's.
    again.figure.labels->names["1"] = "thigh bone";
    again.figure.labels->colours["2"] = "#ffffff";
    saveDocument(again, path, {}, task);
    const LabelReference own = *openDocument(path, OpenOptions{}, task).figure.labels;
    EXPECT_EQ(own.names.at("1"), "thigh bone");
    EXPECT_EQ(own.names.at("2"), "tibia");
    EXPECT_EQ(own.colours.at("2"), "#ffffff");
}

TEST_F(Labels, ThatMovedAreANoteAndCanBeGivenAnew) {
    const fs::path path = in("figure.limner");
    Document document = openDocument(in("scan.nrrd"), OpenOptions{"", in("labels.nrrd"), {}}, task);
    document.figure.labels->names["1"] = "thigh bone";
    saveDocument(document, path, {}, task);
    fs::rename(in("labels.nrrd"), in("elsewhere.nrrd"));

    const Document lost = openDocument(path, OpenOptions{}, task);
    EXPECT_EQ(lost.figure.labels->data, nullptr);
    EXPECT_EQ(lost.figure.labels->names.at("1"), "thigh bone");
    ASSERT_EQ(lost.notes.size(), 1U);
    EXPECT_NE(lost.notes[0].find("were not found"), std::string::npos);

    const Document found = openDocument(path, OpenOptions{"", in("elsewhere.nrrd"), {}}, task);
    EXPECT_TRUE(found.notes.empty()) << found.notes[0];
    EXPECT_NE(found.figure.labels->data, nullptr);
    EXPECT_EQ(found.figure.labels->names.at("1"), "thigh bone");

    // Other labels in the place of ones that are there bring their own names.
    fs::rename(in("elsewhere.nrrd"), in("labels.nrrd"));
    writeLabels("new.nrrd", grid);
    std::ofstream(in("new.txt")) << "1 skin\n2 fat\n";
    const Document replaced = openDocument(path, OpenOptions{"", in("new.nrrd"), {}}, task);
    EXPECT_EQ(replaced.figure.labels->names.at("1"), "skin");
    EXPECT_EQ(replaced.figure.layers, found.figure.layers) << "a project keeps its layers";
}

TEST_F(Labels, ThatCannotBeUsedAreANoteOfAProjectAndAnErrorWhenAskedFor) {
    const fs::path path = in("figure.limner");
    saveDocument(openDocument(in("scan.nrrd"), OpenOptions{"", in("labels.nrrd"), {}}, task), path, {}, task);
    Grid away = grid;
    away.originMm.x = 1000;
    writeLabels("labels.nrrd", away);
    const Document document = openDocument(path, OpenOptions{}, task);
    EXPECT_EQ(document.figure.labels->data, nullptr);
    ASSERT_EQ(document.notes.size(), 1U);
    EXPECT_NE(document.notes[0].find("outside the scan"), std::string::npos);
    EXPECT_THROW(openDocument(path, OpenOptions{"", in("labels.nrrd"), {}}, task), Error);
}

TEST(RealLabels, LieInTheirScansWhicheverWayTheirRowsRun) {
    const auto torso = testing::testData("dicom/siemens_torso_j2k");
    if (!torso) {
        GTEST_SKIP();
    }
    Task task;
    const fs::path file = *testing::testData("dicom/siemens_torso_j2k_labels.nii.gz");
    const Document document = openDocument(*torso, OpenOptions{"", file, {}}, task);
    for (const std::string& note : document.notes) {
        EXPECT_EQ(note.find("cover"), std::string::npos) << note;
    }
    const LabelReference& labels = *document.figure.labels;
    const Volume& scan = *document.figure.volume->data;
    EXPECT_EQ(labels.names.at("5"), "liver");
    // Rows run the other way, yet a voxel of each is at the same place: liver is soft tissue, a vertebra is bone.
    EXPECT_LT(labels.data->grid().direction[1].y * scan.grid().direction[1].y, 0);
    const auto mean = [&](int label) {
        double sum = 0;
        double count = 0;
        const glm::ivec3 dims = labels.data->grid().dims;
        for (int z = 0; z < dims.z; z += 2) {
            for (int y = 0; y < dims.y; y += 4) {
                for (int x = 0; x < dims.x; x += 4) {
                    if (labels.data->valueAt({x, y, z}) == label) {
                        sum += trilinear(scan, scan.grid().voxelFromMm(labels.data->grid().mmFromVoxel({x, y, z})));
                        ++count;
                    }
                }
            }
        }
        return count > 0 ? sum / count : 0;
    };
    EXPECT_GT(mean(5), 20);
    EXPECT_LT(mean(5), 200);
    EXPECT_GT(mean(32), mean(5) + 40) << "vertebra T12"; // where the rows turned round have the soft belly wall
}

} // namespace
} // namespace limner
