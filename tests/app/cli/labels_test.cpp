#include "program_run.h"

#include "support/make_volume.h"
#include "support/test_data.h"

namespace limner {
namespace {

using testing::ProgramRun;
using testing::run;

/// The head scan with labels: 0 outside a box, then 4 and 7 for its halves; named by a text file.
class WithLabels : public testing::WithScan {
  protected:
    void SetUp() override {
        testing::WithScan::SetUp();
        grid_ = makeHeadPhantom(48)->grid();
        write("labels.nrrd", grid_);
        std::ofstream(path("labels.txt")) << "4 lower half 255 0 0\n7 upper half 0 0 255\n9 nowhere 0 0 0\n";
    }
    void write(const std::string& name, const Grid& grid) const {
        const glm::ivec3 dims = grid.dims;
        const auto labels = testing::makeVolume<std::int16_t>(grid, VoxelType::int16, [&](glm::ivec3 v) {
            return v.x < dims.x / 4 || v.x >= dims.x / 2 ? 0 : v.z < dims.z / 2 ? 4 : 7;
        });
        testing::writeNrrd(*labels, path(name));
    }
    [[nodiscard]] std::string labels() const { return path("labels.nrrd"); }

    Grid grid_;
};

TEST_F(WithLabels, InfoListsTheLabelsOfALabelVolume) {
    const ProgramRun r = run({"info", labels(), "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto facts = r.facts();
    EXPECT_EQ(facts.at("modality"), "labels");
    ASSERT_EQ(facts.at("labels").size(), 2U);
    const auto& upper = facts.at("labels")[1];
    EXPECT_EQ(upper.at("id"), 7);
    EXPECT_EQ(upper.at("name"), "upper half");
    EXPECT_EQ(upper.at("colour"), "#0000ff");
    const glm::ivec3 n = grid_.dims;
    const int voxels = (n.x / 2 - n.x / 4) * n.y * (n.z - n.z / 2);
    EXPECT_EQ(upper.at("voxels"), voxels);
    const glm::dvec3 mm = grid_.spacingMm;
    EXPECT_NEAR(upper.at("ml").get<double>(), voxels * mm.x * mm.y * mm.z / 1000, 0.001 * voxels);
    const std::string text = run({"info", labels()}).out;
    EXPECT_NE(text.find("4 lower half: "), std::string::npos) << text;
    EXPECT_NE(text.find("\n                7 upper half: "), std::string::npos) << text;
    EXPECT_EQ(text.find("nowhere"), std::string::npos);
    EXPECT_FALSE(run({"info", scan(), "--json"}).facts().contains("labels"));
    EXPECT_EQ(run({"info", scan(), "--labels", labels(), "--json"}).facts().at("labels").size(), 2U);
}

TEST_F(WithLabels, AScanWithLabelsBecomesALabelledProject) {
    const ProgramRun made = run({"new", scan(), "--labels", labels(), "-o", path("f.json")});
    ASSERT_EQ(made.code, 0) << made.err;
    std::ifstream file(path("f.json"));
    const auto figure = nlohmann::json::parse(file);
    EXPECT_EQ(figure.at("labels").at("path"), "labels.nrrd");
    EXPECT_EQ(figure.at("labels").at("names").at("4"), "lower half");
    EXPECT_EQ(figure.at("labels").at("names").size(), 2U);
    EXPECT_EQ(figure.at("labels").at("colours").at("7"), "#0000ff");
    const auto& transfer = figure.at("layers").at(0).at("transfer");
    EXPECT_EQ(transfer.at("kind"), "2d");
    EXPECT_EQ(transfer.at("axes"), (nlohmann::json{"value", "label"}));
    EXPECT_EQ(transfer.at("nodes").at("y"), (nlohmann::json{4, 7}));
    EXPECT_EQ(transfer.at("nodes").at("styles"), (nlohmann::json{{"#ff0000"}, {"#0000ff"}}));

    const auto facts = run({"info", path("f.json"), "--json"}).facts();
    EXPECT_EQ(facts.at("labels_path"), "labels.nrrd");
    EXPECT_EQ(facts.at("labels").size(), 2U);
    EXPECT_EQ(run({"validate", path("f.json")}).code, 0);
}

TEST_F(WithLabels, APresetOfItsOwnKeepsTheLabels) {
    ASSERT_EQ(run({"new", scan(), "--labels", labels(), "--preset", "skull", "-o", path("f.json")}).code, 0);
    std::ifstream file(path("f.json"));
    const auto figure = nlohmann::json::parse(file);
    EXPECT_EQ(figure.at("layers").at(0).at("transfer").at("kind"), "1d");
    EXPECT_EQ(figure.at("labels").at("path"), "labels.nrrd");
}

TEST_F(WithLabels, WhatCannotBeUsedIsOneLine) {
    const auto refused = [&](std::vector<std::string> arguments, int code, const std::string& why) {
        const ProgramRun r = run(arguments);
        EXPECT_EQ(r.code, code) << r.err;
        EXPECT_NE(r.err.find(why), std::string::npos) << r.err;
        EXPECT_EQ(r.out, "");
    };
    Grid away = grid_;
    away.originMm.z += 10000;
    write("away.nrrd", away);
    refused({"render", scan(), "--labels", path("away.nrrd"), "-o", path("a.png")}, 3, "outside the scan");
    refused({"info", scan(), "--labels", path("away.nrrd")}, 3, "outside the scan");
    refused({"explain", scan(), "--labels", path("none.nrrd")}, 3, "none.nrrd");
    refused({"render", scan(), "--preset", "labelled", "-o", path("a.png")}, 2, "--labels");
    EXPECT_FALSE(exists("a.png"));
    Grid part = grid_;
    part.originMm.x += 0.75 * grid_.sizeMm().x;
    write("part.nrrd", part);
    const ProgramRun r = run({"info", scan(), "--labels", path("part.nrrd"), "--json"});
    EXPECT_EQ(r.code, 0);
    EXPECT_NE(r.facts().at("warnings").dump().find("25 %"), std::string::npos);
}

TEST(RealLabelFiles, AreListedByName) {
    const auto spine = testing::testData("volumes/torso_spine_labels.nii.gz");
    if (!spine) {
        GTEST_SKIP();
    }
    const auto facts = run({"info", spine->string(), "--json"}).facts();
    ASSERT_EQ(facts.at("labels").size(), 8U); // S1 to T11
    EXPECT_EQ(facts.at("labels")[0].at("id"), 26);
    EXPECT_EQ(facts.at("labels")[0].at("name"), "vertebrae_S1");
    EXPECT_EQ(facts.at("labels")[0].at("colour"), "#0000ff");
    EXPECT_EQ(facts.at("labels")[7].at("name"), "vertebrae_T11");
    const auto brain = run({"info", testing::testData("volumes/brain_colin27_aal_labels.nii.gz")->string(), "--json"});
    ASSERT_EQ(brain.facts().at("labels").size(), 116U);
    EXPECT_EQ(brain.facts().at("labels")[0].at("name"), "Precentral_L");
}

} // namespace
} // namespace limner
