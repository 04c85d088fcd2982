// Every grid of the test data against what other programs read from it: shape, spacing, place, range and values.

#include "core/base/error.h"
#include "core/volume/import.h"
#include "support/test_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <set>

namespace limner {
namespace {

using nlohmann::json;
using Differences = std::set<std::string>;

json manifest() {
    const auto path = testing::testData("manifest.json");
    return path ? json::parse(std::ifstream(*path)).at("entries") : json::array();
}

const json* entryOf(const json& entries, const std::string& file) {
    for (const json& entry : entries) {
        if (entry.at("file") == file) {
            return &entry;
        }
    }
    return nullptr;
}

ImportedVolume load(const std::string& file, const ImportOptions& options = {}) {
    Task task;
    return importVolume(*testing::testData(file), options, task);
}

bool hasWarning(const ImportedVolume& imported, const std::string& part) {
    return std::any_of(imported.report.warnings.begin(), imported.report.warnings.end(),
                       [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

/// Grids among the entries: pictures, artworks and single odd files are not.
bool isGrid(const json& entry) {
    const std::string file = entry.at("file");
    const bool folder = file.starts_with("volumes/") || file.starts_with("zoo/") || file.starts_with("stacks/") ||
                        file.starts_with("dicom/");
    return folder && !file.starts_with("dicom/single_files") && (entry.contains("dims") || entry.contains("series"));
}

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

/// The manifest rounds to six digits.
constexpr double kManifestDigits = 1e-5;

void compareShape(const json& entry, const Grid& grid, Differences& differences) {
    if (!entry.contains("dims")) {
        differences.insert("dims");
        return;
    }
    std::vector<int> dims = entry.at("dims");
    while (dims.size() > 3 && dims.back() == 1) {
        dims.pop_back();
    }
    dims.resize(std::max<std::size_t>(3, dims.size()), 1);
    if (dims != std::vector<int>{grid.dims.x, grid.dims.y, grid.dims.z}) {
        differences.insert("dims");
    }
    const json& spacing = entry.at("spacing");
    for (int i = 0; !spacing.is_null() && i < 3 && static_cast<std::size_t>(i) < spacing.size(); ++i) {
        const double expected = spacing[static_cast<std::size_t>(i)];
        if (expected > 0 && !near(grid.spacingMm[i], expected, kManifestDigits * std::max(1.0, expected))) {
            differences.insert("spacing");
        }
    }
}

void comparePlace(const json& entry, const Grid& grid, Differences& differences) {
    const glm::dmat3 axes = grid.voxelToMmMatrix();
    if (entry.contains("affine_ras")) {
        for (int row = 0; row < 3; ++row) {
            const json& expected = entry.at("affine_ras")[static_cast<std::size_t>(row)];
            const double toLps = row < 2 ? -1 : 1;
            for (int column = 0; column < 3; ++column) {
                if (!near(axes[column][row], toLps * expected[static_cast<std::size_t>(column)].get<double>(), 1e-4)) {
                    differences.insert("place");
                }
            }
            if (!near(grid.originMm[row], toLps * expected[3].get<double>(), 1e-4)) {
                differences.insert("place");
            }
        }
    }
    if (entry.contains("orientation_lps") && entry.contains("dims")) {
        for (int i = 0; i < 3; ++i) {
            const auto n = static_cast<std::size_t>(i);
            const json& orientation = entry.at("orientation_lps");
            const bool same = near(grid.direction[0][i], orientation[n].get<double>(), kManifestDigits) &&
                              near(grid.direction[1][i], orientation[n + 3].get<double>(), kManifestDigits) &&
                              near(grid.originMm[i], entry.at("first_position_lps")[n].get<double>(), 1e-4);
            if (!same) {
                differences.insert("place");
            }
        }
    }
}

void compareValues(const json& entry, const ImportedVolume& imported, Differences& differences) {
    const Volume::Contents& contents = imported.volume->contents();
    if (imported.report.sha256Values != entry.value("sha256_values", "")) {
        differences.insert("values");
    }
    if (!entry.contains("dims")) {
        return;
    }
    if (entry.at("not_finite").get<std::size_t>() != contents.nonFinite) {
        differences.insert("non-finite");
    }
    // "values" of DICOM are after rescale, in a type of the manifest's own.
    if (!entry.contains("values") && entry.at("dtype") != imported.report.type) {
        differences.insert("type");
    }
    const double low = entry.value("scaled_min", entry.at("min").get<double>());
    const double high = entry.value("scaled_max", entry.at("max").get<double>());
    constexpr double kFloat = 1e-6; // slopes are single precision in the files
    if (!near(contents.range.low, low, kFloat * std::max(1.0, std::abs(low))) ||
        !near(contents.range.high, high, kFloat * std::max(1.0, std::abs(high)))) {
        differences.insert("range");
    }
}

/// A disagreement that is meant: what differs, why, and a check that the reason holds.
struct Explanation {
    Differences differences;
    std::string why;
    std::function<void(const json& entries, const ImportedVolume* imported)> check;
};

const std::string kReferenceFolder = "dicom/odd/torso128_reference";

void expectSameValues(const json& entries, const ImportedVolume* imported, const std::string& reference) {
    ASSERT_NE(imported, nullptr);
    EXPECT_EQ(imported->report.sha256Values, entryOf(entries, reference)->at("sha256_values"));
}

/// Refused by default; the first component has the values of `reference` (where the zoo has them alone).
Explanation components(const std::string& file, const std::string& reference, std::vector<int> dims) {
    return {{"refused"},
            "colour, vectors and 4D are refused unless the first component is asked for",
            [file, reference, dims](const json& entries, const ImportedVolume*) {
                ImportOptions options;
                options.firstComponent = true;
                const ImportedVolume first = load(file, options);
                const glm::ivec3 found = first.volume->grid().dims;
                EXPECT_EQ(dims, (std::vector<int>{found.x, found.y, found.z}));
                EXPECT_TRUE(hasWarning(first, "first component"));
                if (!reference.empty()) {
                    const ImportedVolume alone = load(reference);
                    for (const glm::ivec3 voxel : {glm::ivec3(0), glm::ivec3(16, 12, 13), glm::ivec3(31, 24, 26)}) {
                        EXPECT_EQ(first.volume->valueAt(voxel), alone.volume->valueAt(voxel));
                    }
                }
                static_cast<void>(entries);
            }};
}

Explanation resampled(Differences differences, const std::string& warning) {
    return {std::move(differences), "laid on a straight grid; the hash, taken before that, agrees",
            [warning](const json&, const ImportedVolume* imported) {
                ASSERT_NE(imported, nullptr);
                EXPECT_TRUE(hasWarning(*imported, "resampled to a straight grid"));
                EXPECT_TRUE(hasWarning(*imported, warning));
            }};
}

/// At the places the file gives its voxels, the straight grid holds the reference's values (first slice: unshifted).
void checkShearedZoo(const json& entries, const ImportedVolume* imported) {
    ASSERT_NE(imported, nullptr);
    EXPECT_TRUE(hasWarning(*imported, "sheared"));
    const ImportedVolume reference = load("zoo/nrrd/raw_le.nrrd");
    const json& affine = entryOf(entries, "zoo/nifti/sheared_sform.nii.gz")->at("affine_ras");
    const glm::ivec3 dims = reference.volume->grid().dims;
    double worst = 0;
    double sum = 0;
    int count = 0;
    for (int k = 0; k < dims.z; ++k) {
        for (int j = 0; j < dims.y; ++j) {
            for (int i = 0; i < dims.x; ++i) {
                glm::dvec3 mm(0);
                for (int row = 0; row < 3; ++row) {
                    const json& r = affine[static_cast<std::size_t>(row)];
                    mm[row] = (row < 2 ? -1 : 1) * (r[0].get<double>() * i + r[1].get<double>() * j +
                                                    r[2].get<double>() * k + r[3].get<double>());
                }
                const double found = trilinear(*imported->volume, imported->volume->grid().voxelFromMm(mm));
                const double difference = std::abs(found - reference.volume->valueAt({i, j, k}));
                worst = k == 0 ? std::max(worst, difference) : worst;
                sum += difference;
                ++count;
            }
        }
    }
    EXPECT_LT(worst, 0.1);        // the affine has five digits: a 10^-5th of the steepest step of 2600
    EXPECT_LT(sum / count, 60.0); // two linear interpolations of coarse voxels; unsheared it would be several hundred
}

void explainZoo(std::map<std::string, Explanation>& table) {
    const std::string raw = "zoo/nrrd/raw_le.nrrd";
    const std::string bytes = "zoo/nrrd/uint8.nrrd";
    for (const std::string file : {"zoo/metaimage/rgb.mha", "zoo/nifti/rgb24.nii.gz",
                                   "zoo/nrrd/rgb_vector_first_axis.nrrd", "zoo/tiff/rgb_pages.tif"}) {
        table[file] = components(file, bytes, {32, 25, 27});
    }
    for (const std::string file : {"zoo/nifti/time_series_4d.nii.gz", "zoo/nrrd/time_series_4d.nrrd"}) {
        table[file] = components(file, raw, {32, 25, 27});
    }
    table["zoo/real_small/nibabel_example4d.nii.gz"] =
        components("zoo/real_small/nibabel_example4d.nii.gz", "", {128, 96, 24});
    table["zoo/real_small/nibabel_example_nifti2.nii.gz"] =
        components("zoo/real_small/nibabel_example_nifti2.nii.gz", "", {32, 20, 12});
    table["zoo/real_small/nrrdjs_example4.nrrd"] = components("zoo/real_small/nrrdjs_example4.nrrd", "", {4, 3, 2});
    table["zoo/nifti/units_micron.nii.gz"] = {
        {"spacing", "place"},
        "the manifest gives the header's micrometres, Limner millimetres",
        [](const json& entries, const ImportedVolume* imported) {
            const json& spacing = entryOf(entries, "zoo/nifti/units_micron.nii.gz")->at("spacing");
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(imported->volume->grid().spacingMm[i] * 1000,
                            spacing[static_cast<std::size_t>(i)].get<double>(), 1e-2);
            }
        }};
    table["zoo/tiff/multipage_u8_miniswhite.tif"] = {
        {"values"},
        "stored inverted; read as what it shows, which is the zoo's 8-bit head",
        [bytes](const json& entries, const ImportedVolume* imported) { expectSameValues(entries, imported, bytes); }};
}

void explainResampled(std::map<std::string, Explanation>& table) {
    table["zoo/nifti/sheared_sform.nii.gz"] = {
        {"dims", "place"}, "laid on a straight grid; the hash, taken before that, agrees", checkShearedZoo};
    table["zoo/real_small/phantom_sheared_ct.nii.gz"] = resampled({"dims", "spacing", "place"}, "sheared");
    table["dicom/ge_head_tilt_uneven"] = resampled({"dims", "place", "range"}, "unevenly spaced and sheared");
    table["dicom/philips_phantom_tilt_jpegll"] = resampled({"dims", "place"}, "sheared");
    table["dicom/odd/missing_two_slices"] = resampled({"dims"}, "2 slices seem to be missing");
    table["dicom/mr_head_uneven"] = {
        {"spacing", "place", "range"},
        "the mean step of slightly uneven slices, not the median; padding (0) became the lowest other value",
        [](const json& entries, const ImportedVolume* imported) {
            ASSERT_NE(imported, nullptr);
            EXPECT_NEAR(imported->volume->grid().spacingMm.z, 7.0, 0.05); // steps of 6.958 to 7.071 mm
            EXPECT_EQ(imported->volume->range().low, 1);
            static_cast<void>(entries);
        }};
}

void explainOdd(std::map<std::string, Explanation>& table) {
    const auto reference = [](const std::string& warning) {
        return [warning](const json& entries, const ImportedVolume* imported) {
            expectSameValues(entries, imported, kReferenceFolder);
            EXPECT_TRUE(warning.empty() || hasWarning(*imported, warning));
        };
    };
    table["dicom/odd/duplicate_slices"] = {{"dims", "values"},
                                           "the manifest counts the duplicates; without them it is the reference",
                                           reference("2 of 22 slices")};
    table["dicom/odd/garbage_high_bits"] = {
        {"values", "range"},
        "the manifest keeps the noise of the unused bits; without it, it is the reference",
        reference("")};
    table["dicom/odd/mixed_folder MR"] = {
        {"spacing", "place", "range"},
        "six slices of mr_head_uneven: the mean step, and padding became the lowest other value",
        [](const json&, const ImportedVolume* imported) {
            ASSERT_NE(imported, nullptr);
            EXPECT_NEAR(imported->volume->grid().spacingMm.z, 7.0, 0.05); // steps of 6.958 to 7.057 mm
            EXPECT_GT(imported->volume->range().low, 0);
        }};
    table["dicom/odd/signed_padding"] = {
        {"range"}, "padding became air", [](const json&, const ImportedVolume* imported) {
            EXPECT_EQ(imported->volume->range().low, -1024);
        }};
    table["dicom/odd/size_changes"] = {
        {"dims", "values"}, "split by size; the larger part is read", [](const json&, const ImportedVolume* imported) {
            ASSERT_NE(imported, nullptr);
            EXPECT_EQ(imported->volume->grid().dims, glm::ivec3(128, 128, 15));
            EXPECT_TRUE(hasWarning(*imported, "largest of 2 series"));
        }};
}

std::map<std::string, Explanation> explanations() {
    std::map<std::string, Explanation> table;
    explainZoo(table);
    explainResampled(table);
    explainOdd(table);
    return table;
}

std::string joined(const Differences& differences) {
    std::string text;
    for (const std::string& difference : differences) {
        text += (text.empty() ? "" : ", ") + difference;
    }
    return text;
}

TEST(Manifest, EveryGridAgreesOrSaysWhyNot) {
    const json entries = manifest();
    if (entries.empty()) {
        GTEST_SKIP();
    }
    std::map<std::string, Explanation> expected = explanations();
    int agree = 0;
    int all = 0;
    for (const json& entry : entries) {
        if (!isGrid(entry)) {
            continue;
        }
        const std::string file = entry.at("file");
        SCOPED_TRACE(file);
        ++all;
        ImportOptions options;
        options.series = file == "dicom/odd/size_changes" ? "" : entry.value("series", "");
        Differences differences;
        ImportedVolume imported;
        std::string refusal;
        try {
            imported = load(file, options);
            compareShape(entry, imported.volume->grid(), differences);
            comparePlace(entry, imported.volume->grid(), differences);
            compareValues(entry, imported, differences);
        } catch (const Error& error) {
            differences.insert("refused");
            refusal = error.what();
        }
        agree += differences.empty() ? 1 : 0;
        // A folder of several series is several entries.
        const std::string modality = entry.value("modality", "");
        const auto found = expected.find(file == "dicom/odd/mixed_folder" ? file + " " + modality : file);
        const Differences allowed = found == expected.end() ? Differences{} : found->second.differences;
        EXPECT_EQ(joined(differences), joined(allowed)) << refusal;
        if (found != expected.end()) {
            found->second.check(entries, imported.volume ? &imported : nullptr);
            std::cout << "  " << file << " differs in " << joined(differences) << ": " << found->second.why << '\n';
            expected.erase(found);
        }
    }
    std::cout << agree << " of " << all << " grids agree with the manifest\n";
    EXPECT_TRUE(expected.empty()) << "explained but never met: " << expected.begin()->first;
    EXPECT_GT(all, 150);
}

double largestDifference(const Volume& a, const Volume& b) {
    double worst = 0;
    const glm::ivec3 dims = a.grid().dims;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                worst = std::max(worst, std::abs(a.valueAt({x, y, z}) - b.valueAt({x, y, z})));
            }
        }
    }
    return worst;
}

TEST(OddDicom, GivesTheReferenceTorso) {
    if (!testing::testData(kReferenceFolder)) {
        GTEST_SKIP();
    }
    const ImportedVolume reference = load(kReferenceFolder);
    const std::map<std::string, double> within = {{"unsorted_random_names", 0},
                                                  {"duplicate_slices", 0},
                                                  {"missing_two_slices", 1e9}, // shape only: two slices are made up
                                                  {"mixed_folder", 0},
                                                  {"per_slice_rescale", 1},
                                                  {"monochrome1", 0},
                                                  {"garbage_high_bits", 0},
                                                  {"no_geometry", 0},
                                                  {"dicomdir", 0},
                                                  {"dicomdir/DICOMDIR", 0},
                                                  {"enhanced_ct_frames_shuffled.dcm", 0},
                                                  {"transfer_syntaxes/implicit_le", 0},
                                                  {"transfer_syntaxes/explicit_be", 0},
                                                  {"transfer_syntaxes/deflated", 0},
                                                  {"transfer_syntaxes/rle", 0},
                                                  {"transfer_syntaxes/jpeg_lossless_sv1", 0},
                                                  {"transfer_syntaxes/jpeg_lossless_p14_sv6", 0},
                                                  {"transfer_syntaxes/jpeg_ls", 0},
                                                  {"transfer_syntaxes/jpeg2000_lossless", 0},
                                                  {"transfer_syntaxes/no_preamble_no_meta", 0},
                                                  {"transfer_syntaxes/jpeg_extended_12bit_lossy", 9}};
    for (const auto& [folder, tolerance] : within) {
        SCOPED_TRACE(folder);
        const ImportedVolume odd = load("dicom/odd/" + folder);
        ASSERT_EQ(odd.volume->grid().dims, reference.volume->grid().dims);
        EXPECT_LE(largestDifference(*odd.volume, *reference.volume), tolerance);
        if (folder != "no_geometry") {
            EXPECT_EQ(odd.volume->grid(), reference.volume->grid());
        }
    }
}

/// Mean |difference| at the places of the reference's voxels, a voxel in from the border.
double meanDifferenceInSpace(const Volume& odd, const Volume& reference) {
    double sum = 0;
    int count = 0;
    const glm::ivec3 dims = reference.grid().dims;
    for (int z = 1; z + 1 < dims.z; ++z) {
        for (int y = 2; y + 2 < dims.y; ++y) {
            for (int x = 2; x + 2 < dims.x; ++x) {
                const glm::dvec3 mm = reference.grid().mmFromVoxel({x, y, z});
                sum += std::abs(trilinear(odd, odd.grid().voxelFromMm(mm)) - reference.valueAt({x, y, z}));
                ++count;
            }
        }
    }
    return sum / count;
}

TEST(OddDicom, LiesWhereTheReferenceLies) {
    if (!testing::testData(kReferenceFolder)) {
        GTEST_SKIP();
    }
    const ImportedVolume reference = load(kReferenceFolder);
    // Other sampling of the same body: edges differ, the body does not. A swapped or mirrored axis gives over 300 HU.
    for (const std::string folder : {"row_col_spacing_differ", "sagittal", "missing_two_slices"}) {
        SCOPED_TRACE(folder);
        const ImportedVolume odd = load("dicom/odd/" + folder);
        const double mean = meanDifferenceInSpace(*odd.volume, *reference.volume);
        std::cout << "  " << folder << ": mean difference " << mean << " HU\n";
        EXPECT_LT(mean, 40);
    }
}

TEST(OddDicom, PaddingIsAir) {
    if (!testing::testData(kReferenceFolder)) {
        GTEST_SKIP();
    }
    const ImportedVolume reference = load(kReferenceFolder);
    const ImportedVolume padded = load("dicom/odd/signed_padding");
    const glm::ivec3 dims = reference.volume->grid().dims;
    ASSERT_EQ(padded.volume->grid(), reference.volume->grid());
    for (int z = 0; z < dims.z; ++z) {
        EXPECT_EQ(padded.volume->valueAt({0, 0, z}), -1024); // outside the circle
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const double found = padded.volume->valueAt({x, y, z});
                ASSERT_TRUE(found == -1024 || found == reference.volume->valueAt({x, y, z}));
            }
        }
    }
}

TEST(OddDicom, SaysWhatIsOdd) {
    if (!testing::testData(kReferenceFolder)) {
        GTEST_SKIP();
    }
    EXPECT_TRUE(load(kReferenceFolder).report.warnings.empty());
    EXPECT_TRUE(hasWarning(load("dicom/odd/no_geometry"), "no position"));
    EXPECT_TRUE(hasWarning(load("dicom/odd/no_geometry"), "no pixel spacing"));
    EXPECT_TRUE(hasWarning(load("dicom/odd/per_slice_rescale"), "differ between the slices"));
    const ImportedVolume mixed = load("dicom/odd/mixed_folder");
    EXPECT_TRUE(hasWarning(mixed, "largest of 3 series"));
    ASSERT_EQ(mixed.report.series.size(), 3U);
    EXPECT_EQ(mixed.report.series[1].modality, "MR");
    ImportOptions second;
    second.series = "2";
    EXPECT_EQ(load("dicom/odd/mixed_folder", second).volume->contents().modality, Modality::mr);
    second.series = "9";
    EXPECT_THROW(load("dicom/odd/mixed_folder", second), Error);
}

TEST(SingleDicomFiles, LoadOrAreRefusedInOneLine) {
    const auto folder = testing::testData("dicom/single_files");
    if (!folder) {
        GTEST_SKIP();
    }
    int loaded = 0;
    int refused = 0;
    for (const auto& file : std::filesystem::directory_iterator(*folder)) {
        SCOPED_TRACE(file.path().filename());
        try {
            Task task;
            EXPECT_GT(importVolume(file.path(), {}, task).volume->grid().voxelCount(), 0U);
            ++loaded;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            ++refused;
        }
    }
    std::cout << loaded << " single files load, " << refused << " are refused\n";
    EXPECT_GE(loaded, 28);
}

TEST(Import, InvesaliusProjectIsThePackagedHead) {
    const std::filesystem::path sample = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
    const auto reference = testing::testData("volumes/cranium_ct.nrrd");
    if (!reference || !std::filesystem::exists(sample)) {
        GTEST_SKIP();
    }
    Task task;
    const ImportedVolume project = importVolume(sample, {}, task);
    const ImportedVolume nrrd = load("volumes/cranium_ct.nrrd");
    EXPECT_EQ(project.volume->grid().dims, nrrd.volume->grid().dims);
    EXPECT_EQ(project.report.sha256Values, nrrd.report.sha256Values);
    EXPECT_EQ(project.volume->contents().unit, "HU");
    EXPECT_NEAR(project.volume->grid().spacingMm.x, nrrd.volume->grid().spacingMm.x, kManifestDigits);
}

TEST(Import, RawBytesAsDescribed) {
    if (!testing::testData("zoo/raw")) {
        GTEST_SKIP();
    }
    const ImportedVolume reference = load("zoo/nrrd/raw_le.nrrd");
    for (const std::string file : {"int16_le.raw", "int16_be.raw", "int16_le.raw.gz"}) {
        ImportOptions options;
        options.raw = std::string("32x25x27:int16:") + (file.find("be") != std::string::npos ? "be" : "le") +
                      ":7.65625,9.57031,6";
        const ImportedVolume raw = load("zoo/raw/head_32x25x27_" + file, options);
        EXPECT_EQ(raw.report.sha256Values, reference.report.sha256Values) << file;
        EXPECT_EQ(raw.volume->grid().spacingMm, glm::dvec3(7.65625, 9.57031, 6)) << file;
    }
    ImportOptions options;
    options.raw = "32x25x27:uint8:le:1,1,1";
    const ImportedVolume skipped = load("zoo/raw/head_32x25x27_uint8_skip512.raw", options);
    EXPECT_EQ(skipped.report.sha256Values, load("zoo/nrrd/uint8.nrrd").report.sha256Values);
    EXPECT_TRUE(hasWarning(skipped, "512 bytes"));
    options.raw = "32x25:uint8";
    EXPECT_THROW(load("zoo/raw/head_32x25x27_uint8_skip512.raw", options), Error);
}

TEST(Import, LabelsAreKnownAsSuch) {
    if (!testing::testData("volumes/torso_spine_labels.nii.gz")) {
        GTEST_SKIP();
    }
    ImportOptions options;
    options.labels = true;
    const ImportedVolume labels = load("volumes/torso_spine_labels.nii.gz", options);
    EXPECT_EQ(labels.volume->contents().modality, Modality::labels);
}

TEST(Import, PicturesAreInNaturalOrderFromAnyOfThem) {
    if (!testing::testData("zoo/tiff/stack/head10.tif")) {
        GTEST_SKIP();
    }
    const ImportedVolume folder = load("zoo/tiff/stack");
    EXPECT_EQ(load("zoo/tiff/stack/head10.tif").report.sha256Values, folder.report.sha256Values);
    EXPECT_EQ(load("zoo/png_u16_stack/ct_0003.png").report.sha256Values, folder.report.sha256Values);
    const ImportedVolume imageJ = load("zoo/tiff/imagej_spacing.tif");
    EXPECT_NEAR(imageJ.volume->grid().spacingMm.x, 7.65625, 1e-3);
    EXPECT_NEAR(imageJ.volume->grid().spacingMm.z, 6.0, 1e-6);
    EXPECT_NEAR(load("zoo/tiff/multipage_u16_deflate.tif").volume->grid().spacingMm.y, 9.570312, 1e-3);
    EXPECT_THROW(load("zoo/png_mixed_sizes"), Error);
}

} // namespace
} // namespace limner
