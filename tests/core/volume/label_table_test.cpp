#include "core/volume/label_table.h"

#include "core/volume/label_table_text.h"
#include "support/test_data.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

class LabelTables : public ::testing::Test {
  protected:
    fs::path folder = fs::temp_directory_path() / ("limner-label-tables-" + std::to_string(::getpid()));

    void SetUp() override {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    fs::path file(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder / name, std::ios::binary) << bytes;
        return folder / name;
    }
};

template <typename T>
void put(std::string& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// A NIfTI-1 header whose one extension says that it has `size` bytes, then `content`; one voxel.
std::string nifti(const std::string& content, std::int64_t size) {
    std::string b(360, '\0');
    put(b, 0, std::int32_t{348});
    for (std::size_t i = 0; i < 8; ++i) {
        put(b, 40 + 2 * i, static_cast<std::int16_t>(i == 0 ? 3 : 1));
        put(b, 76 + 4 * i, 1.0F);
    }
    put(b, 70, std::int16_t{2});
    b.replace(344, 4, std::string("n+1\0", 4));
    b[348] = 1;
    put(b, 352, static_cast<std::int32_t>(size));
    b += content;
    put(b, 108, static_cast<float>(b.size()));
    return b + '\0';
}

std::string nifti(const std::string& content) { return nifti(content, static_cast<std::int64_t>(content.size()) + 8); }

std::string caret(const std::string& labels) {
    return "<?xml version=\"1.0\"?><CaretExtension><VolumeInformation><LabelTable>" + labels +
           "</LabelTable></VolumeInformation></CaretExtension>";
}

bool warns(const LabelTable& table, const std::string& part) {
    for (const std::string& warning : table.warnings) {
        if (warning.find(part) != std::string::npos) {
            return true;
        }
    }
    return false;
}

// ---- real files

TEST(LabelTable, OfTotalSegmentatorsHeaderExtension) {
    const auto spine = testing::testData("volumes/torso_spine_labels.nii.gz");
    if (!spine) {
        GTEST_SKIP();
    }
    const LabelTable table = readLabelTable(*spine);
    EXPECT_TRUE(table.warnings.empty());
    EXPECT_EQ(table.entries.size(), 25U);
    EXPECT_EQ(table.entries.at(26), (LabelEntry{"vertebrae_S1", "#0000ff"}));
    EXPECT_EQ(table.entries.at(30), (LabelEntry{"vertebrae_L2", "#ff8000"})); // 0.50196 = 128 / 255
    EXPECT_EQ(table.entries.at(50).name, "vertebrae_C1");
    const LabelTable organs = readLabelTable(*testing::testData("dicom/siemens_torso_j2k_labels.nii.gz"));
    EXPECT_EQ(organs.entries.at(5), (LabelEntry{"liver", "#00ffff"}));
    EXPECT_EQ(organs.entries.at(1).name, "spleen");
}

TEST(LabelTable, OfTheTextFileBesideTheVolume) {
    const auto brain = testing::testData("volumes/brain_colin27_aal_labels.nii.gz");
    if (!brain) {
        GTEST_SKIP();
    }
    const LabelTable table = readLabelTable(*brain);
    EXPECT_TRUE(table.warnings.empty());
    EXPECT_EQ(table.entries.size(), 116U);
    EXPECT_EQ(table.entries.at(1), (LabelEntry{"Precentral_L", ""}));
    EXPECT_EQ(table.entries.at(116).name, "Vermis_10");
}

TEST(LabelTable, IsEmptyWhereThereIsNone) {
    if (const auto cranium = testing::testData("volumes/cranium_ct_labels.nrrd")) {
        EXPECT_TRUE(readLabelTable(*cranium).entries.empty());
        EXPECT_TRUE(readLabelTable(*cranium).warnings.empty());
    }
    EXPECT_TRUE(readLabelTable("/nowhere/at/all.nii.gz").entries.empty());
    EXPECT_TRUE(readLabelTable(fs::temp_directory_path()).entries.empty());
}

// ---- headers

TEST_F(LabelTables, SlicersKeysOfTheFirstLayer) {
    const auto path = file("seg.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1 1 1\nencoding: raw\n"
                                       "Segment0_Name:=left lung\nSegment0_LabelValue:=3\nSegment0_Color:=1 0.5 0\n"
                                       "Segment0_Layer:=0\n"
                                       "Segment1_Name:=elsewhere\nSegment1_LabelValue:=3\nSegment1_Layer:=1\n"
                                       "Segment12_Name:=no number\nSegment12_LabelValue:=many\n"
                                       "Segment13_LabelValue:=7\nSegment13_Color:=1 nan 0\n\n\1");
    const LabelTable table = readLabelTable(path);
    EXPECT_EQ(table.entries.size(), 2U);
    EXPECT_EQ(table.entries.at(3), (LabelEntry{"left lung", "#ff8000"}));
    EXPECT_EQ(table.entries.at(7), (LabelEntry{"", ""}));
}

TEST_F(LabelTables, TheHeaderGoesBeforeTheFileBesideIt) {
    const auto path = file("a.nii", nifti(caret("<Label Key=\"1\">liver</Label><Label Key=\"2\" Red=\"1\" Green=\"0\" "
                                                "Blue=\"0\"></Label>")));
    file("a.txt", "1 hepar 10 20 30\n2 spleen 40 50 60\n3 kidney 70 80 90\n");
    const LabelTable table = readLabelTable(path);
    EXPECT_EQ(table.entries.at(1), (LabelEntry{"liver", "#0a141e"}));
    EXPECT_EQ(table.entries.at(2), (LabelEntry{"spleen", "#ff0000"}));
    EXPECT_EQ(table.entries.at(3), (LabelEntry{"kidney", "#46505a"}));
}

TEST_F(LabelTables, ExtensionOfAHeaderWithItsPictureApart) {
    std::string header = nifti(caret("<Label Key=\"4\">rib</Label>"));
    header.replace(344, 4, std::string("ni1\0", 4));
    file("b.hdr", header);
    const auto image = file("b.img", std::string(1, '\1'));
    EXPECT_EQ(readLabelTable(image).entries.at(4).name, "rib");
    EXPECT_EQ(readLabelTable(folder / "b.hdr").entries.at(4).name, "rib");
}

// ---- hostile headers

TEST_F(LabelTables, SizesOfExtensionsAreHeldAgainstTheFile) {
    const std::string labels = caret("<Label Key=\"1\">liver</Label>");
    for (const std::int64_t size : {std::int64_t{-8}, std::int64_t{4}, std::int64_t{7}, std::int64_t{100000},
                                    std::int64_t{0x7fffffff}, std::int64_t{-0x7fffffff - 1}}) {
        const LabelTable table = readLabelTable(file("lie.nii", nifti(labels, size)));
        EXPECT_TRUE(table.entries.empty()) << size;
        EXPECT_TRUE(warns(table, "extension")) << size;
    }
    std::string cut = nifti(labels);
    cut.resize(400); // in the middle of the extension
    EXPECT_TRUE(readLabelTable(file("cut.nii", cut)).entries.empty());
    EXPECT_TRUE(warns(readLabelTable(file("cut.nii", cut)), "left out"));
    std::string far = nifti(labels);
    put(far, 108, 1e30F);
    EXPECT_TRUE(warns(readLabelTable(file("far.nii", far)), "impossible place"));
    for (const std::size_t length : {0, 1, 347, 348, 349, 352, 355, 359}) {
        EXPECT_TRUE(readLabelTable(file("short.nii", nifti(labels).substr(0, length))).entries.empty()) << length;
    }
}

TEST_F(LabelTables, DamagedBytesNeverThrow) {
    std::mt19937 random(7);
    const std::string sound = nifti(caret("<Label Key=\"1\" Red=\"1\" Green=\"0\" Blue=\"0\">liver</Label>"));
    std::size_t read = 0;
    for (int round = 0; round < 400; ++round) {
        std::string bytes = sound;
        for (int change = 0; change < 4; ++change) {
            // Half of them in the words that say sizes and places, the rest anywhere.
            const std::size_t at = change % 2 == 0 ? 344 + random() % 16 : random() % bytes.size();
            bytes[at] = static_cast<char>(random());
        }
        const fs::path path = file("damaged.nii", bytes);
        LabelTable table;
        ASSERT_NO_THROW(table = readLabelTable(path)) << round;
        EXPECT_LE(table.entries.size(), 1U);
        read += table.entries.size();
    }
    EXPECT_TRUE(read > 0 && read < 400) << read; // some survive, most do not
}

TEST_F(LabelTables, DamagedXmlIsSaid) {
    for (const std::string& xml :
         {std::string("<LabelTable><Label Key=\"1\">liver</Label>"), std::string("<LabelTable></Label>"),
          "<!DOCTYPE a [<!ENTITY b \"bbbb\">]>" + caret("<Label Key=\"1\">&b;</Label>").substr(21)}) {
        EXPECT_TRUE(warns(readLabelTable(file("bad.nii", nifti(xml))), "damaged")) << xml;
    }
}

TEST_F(LabelTables, NumbersThatAreNoLabelsAreLeftOut) {
    const LabelTable table = readLabelTable(file(
        "odd.nii", nifti(caret("<Label Key=\"99999999999999999999\">a</Label><Label Key=\"\">b</Label><Label>c</Label>"
                               "<Label Key=\"2.5\">d</Label><Label Key=\"8\" Red=\"nan\" Green=\"0\" Blue=\"0\">e"
                               "</Label><Label Key=\"9\" Red=\"-3\" Green=\"1e300\" Blue=\"0.2\">f</Label>"))));
    EXPECT_EQ(table.entries.size(), 2U);
    EXPECT_EQ(table.entries.at(8), (LabelEntry{"e", ""}));
    EXPECT_EQ(table.entries.at(9), (LabelEntry{"f", "#00ff33"}));
}

TEST_F(LabelTables, HoldAtMost65536Entries) {
    std::string text;
    for (int i = 1; i <= 70000; ++i) {
        text += std::to_string(i) + " region\n";
    }
    file("many.nii", nifti(""));
    file("many.txt", text);
    const LabelTable table = readLabelTable(folder / "many.nii");
    EXPECT_EQ(table.entries.size(), 65536U);
    EXPECT_TRUE(warns(table, "65536"));
    file("many.txt", std::string(9 << 20, '1'));
    EXPECT_TRUE(readLabelTable(folder / "many.nii").entries.empty());
    EXPECT_TRUE(warns(readLabelTable(folder / "many.nii"), "too long"));
}

TEST(LabelNames, AreCleanUtf8OfBoundedLength) {
    using importing::cleanLabelName;
    EXPECT_EQ(cleanLabelName("  a\tb\x1b[31m\x7f\r\n"), "ab[31m");
    EXPECT_EQ(cleanLabelName("na\xc3\xafve"), "na\xc3\xafve");
    EXPECT_EQ(cleanLabelName("a\xc2\x9b"
                             "b"),
              "ab"); // a control character of two bytes
    EXPECT_EQ(cleanLabelName("lat\xe9ral"), "lat?ral");
    EXPECT_EQ(cleanLabelName("\xc0\x80\xed\xa0\x80"), "?????"); // overlong zero, half a surrogate pair
    EXPECT_EQ(cleanLabelName(std::string(255, 'x') + "\xc3\xaf"), std::string(255, 'x'));
    EXPECT_EQ(cleanLabelName(std::string(5000, 'x')).size(), 256U);
}

// ---- text files

LabelTable parsed(const std::string& text) { return importing::parseLabelText(text, "labels.txt"); }

TEST(LabelText, ItkSnapsDescriptions) {
    const LabelTable table = parsed("################\n# ITK-SnAP Label Description File\n#\n"
                                    "    0     0    0    0        0  0  0    \"Clear Label\"\n"
                                    "    1   255    0    0        1  1  1    \"Label 1\"\n"
                                    "    2     0  255  128      0.5  1  1    \"Caudate, left\"\n");
    EXPECT_EQ(table.entries.at(0), (LabelEntry{"Clear Label", "#000000"}));
    EXPECT_EQ(table.entries.at(1), (LabelEntry{"Label 1", "#ff0000"}));
    EXPECT_EQ(table.entries.at(2), (LabelEntry{"Caudate, left", "#00ff80"}));
}

TEST(LabelText, FreeSurfersTable) {
    const LabelTable table =
        parsed("#No. Label Name: R G B A\n\n0 Unknown 0 0 0 0\n17 Left-Hippocampus 220 216 20 0\r\n"
               "18 Left-Amygdala 103 255 255 0\n19 Unknown 1 2 3 0\n");
    EXPECT_EQ(table.entries.at(17), (LabelEntry{"Left-Hippocampus", "#dcd814"}));
    EXPECT_EQ(table.entries.at(19), (LabelEntry{"Unknown", "#010203"}));
}

TEST(LabelText, NumbersAtTheEndAreColumnsOnlyWhereAllLinesHaveThem) {
    const LabelTable areas = parsed("1 Area 44\n2 Area 45\n3 Insula left\n");
    EXPECT_EQ(areas.entries.at(1).name, "Area 44");
    EXPECT_EQ(areas.entries.at(3).name, "Insula left");
    const LabelTable lobules = parsed("1 Lobule 1\n2 Lobule 2\n");
    EXPECT_EQ(lobules.entries.at(2).name, "Lobule 2");
    const LabelTable codes = parsed("1 Frontal Inf 2301\n2 Rolandic Oper 2331\n");
    EXPECT_EQ(codes.entries.at(1).name, "Frontal Inf");
    const LabelTable middle = parsed("1 2301 Frontal\n2 2331 Rolandic\n");
    EXPECT_EQ(middle.entries.at(2), (LabelEntry{"Rolandic", ""}));
}

TEST(LabelText, TabsAndHeadings) {
    const LabelTable table = parsed("index\tname\n1\tleft  ventricle\t12\n2\tright ventricle\t13\n");
    EXPECT_EQ(table.entries.size(), 2U);
    EXPECT_EQ(table.entries.at(2).name, "right ventricle");
    EXPECT_TRUE(table.warnings.empty());
    EXPECT_TRUE(warns(parsed("a\nb\n1 one\n2 two\n3 three\n"), "2 lines of labels.txt"));
}

TEST(LabelText, AnotherTextIsNoTable) {
    EXPECT_TRUE(parsed("").entries.empty());
    EXPECT_TRUE(parsed("1\n2 3\n").entries.empty());
    EXPECT_TRUE(parsed("Scanned at the museum.\nThanks to\n2 friends of ours\nand others.\n").entries.empty());
    EXPECT_TRUE(parsed(std::string(1 << 20, '"')).entries.empty());
}

} // namespace
} // namespace limner
