#include "core/figure/presets.h"

#include "core/base/error.h"
#include "core/figure/figure_json.h"
#include "core/figure/scan_facts.h"
#include "core/figure/view_frame.h"
#include "core/volume/phantom.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>
#include <random>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;
using VolumePointer = std::shared_ptr<const Volume>;

/// A fixed pattern in the place of noise: 0..4.
int grain(glm::ivec3 v) { return (v.x * 7 + v.y * 13 + v.z * 29) % 5; }

VolumePointer branches() { // thin crossing rods in an empty volume
    return makeVolume<std::uint8_t>(gridOf({128, 128, 128}), VoxelType::uint8, [](glm::ivec3 v) {
        const double a = std::hypot(v.x - v.y, v.z - 64.0);
        const double b = std::hypot(v.x + v.y - 128, v.z - 60.0 - 0.2 * v.x);
        return (std::min(a, b) < 2.5 ? 200 : 3) + grain(v);
    });
}

VolumePointer block(double noiseSigma) { // a made part: a box with a round hole
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, noiseSigma);
    return makeVolume<std::uint8_t>(gridOf({96, 96, 96}), VoxelType::uint8, [&](glm::ivec3 v) {
        const bool in = glm::all(glm::greaterThan(v, glm::ivec3(20))) && glm::all(glm::lessThan(v, glm::ivec3(76)));
        const bool hole = std::hypot(v.x - 48, v.y - 48) < 12;
        return std::clamp((in && !hole ? 180 : 20) + noise(random), 0.0, 255.0);
    });
}

VolumePointer blob() {
    return makeVolume<std::uint8_t>(gridOf({64, 64, 64}), VoxelType::uint8, [](glm::ivec3 v) {
        return 128 - 120 * std::clamp((std::hypot(v.x - 32, v.y - 30, v.z - 34) - 20) / 2, -1.0, 1.0) + grain(v);
    });
}

TEST(ScanFacts, TellsScansApart) {
    const auto kind = [](const VolumePointer& volume) { return examineScan(*volume).kind; };
    EXPECT_EQ(kind(makeHeadPhantom(96)), ScanKind::ctHead);
    EXPECT_EQ(kind(branches()), ScanKind::vessels);
    EXPECT_EQ(kind(block(6)), ScanKind::machined);
    EXPECT_EQ(kind(blob()), ScanKind::specimen);
    EXPECT_EQ(kind(makeVolume<std::uint8_t>(gridOf({60, 50, 40}), VoxelType::uint8,
                                            [](glm::ivec3 v) { return v.x < 15 ? 0 : v.y / 10 + 1; })),
              ScanKind::labels);
    EXPECT_EQ(kind(makeVolume<std::uint8_t>(gridOf({9, 9, 9}), VoxelType::uint8, [](glm::ivec3) { return 4; })),
              ScanKind::constant);
    EXPECT_EQ(kind(makeVolume<std::uint8_t>(gridOf({9, 9, 1}), VoxelType::uint8, [](glm::ivec3 v) { return v.x; })),
              ScanKind::slice);
}

TEST(ScanFacts, SeesThroughTheOffsetOfHounsfieldUnits) {
    const auto head = makeHeadPhantom(64);
    Grid grid = head->grid();
    const auto shifted =
        makeVolume<std::int16_t>(grid, VoxelType::int16, [&](glm::ivec3 v) { return head->storedAt(v) + 1024; });
    const ScanFacts facts = examineScan(*shifted);
    ASSERT_TRUE(facts.huIntercept);
    EXPECT_NEAR(*facts.huIntercept, 1024, 1);
    EXPECT_EQ(facts.kind, ScanKind::ctHead);
    EXPECT_NEAR(resolveAnchor(facts, "hu:300").value(), 1324, 1);
}

TEST(ScanFacts, OtsuPartsTwoAndThreeClasses) {
    const auto volume = makeVolume<std::uint8_t>(gridOf({90, 10, 10}), VoxelType::uint8, [](glm::ivec3 v) {
        return v.x < 40 ? 10 : v.x < 70 ? 100 : 240;
    });
    const ScanFacts facts = examineScan(*volume);
    EXPECT_GT(facts.otsuLower, 10);
    EXPECT_LT(facts.otsuLower, 100);
    EXPECT_GT(facts.otsuUpper, 100);
    EXPECT_LT(facts.otsuUpper, 240);
    EXPECT_TRUE(facts.otsu > 10 && facts.otsu < 240);
}

TEST(ScanFacts, AnchorsResolve) {
    const auto volume =
        makeVolume<std::int16_t>(gridOf({1000, 1, 2}), VoxelType::int16, [](glm::ivec3 v) { return v.x; });
    const ScanFacts facts = examineScan(*volume);
    EXPECT_EQ(resolveAnchor(facts, "low"), 0);
    EXPECT_EQ(resolveAnchor(facts, "high"), 999);
    EXPECT_NEAR(resolveAnchor(facts, "p0.25").value(), 250, 2);
    EXPECT_NEAR(resolveAnchor(facts, "otsu").value(), 500, 3);
    EXPECT_NEAR(resolveAnchor(facts, "m0.5").value(), 750, 4);
    EXPECT_NEAR(resolveAnchor(facts, "low~high:0.1").value(), 99.9, 1e-9);
    EXPECT_EQ(resolveAnchor(facts, "hu:300"), std::nullopt);
    EXPECT_EQ(resolveAnchor(facts, "hu:300|high"), 999);
    for (const char* text : {"", "|", "hu:", "p1.5", "pp", "otsu~high", "otsu~high:x", "peak"}) {
        EXPECT_EQ(resolveAnchor(facts, text), std::nullopt) << text;
    }
}

TEST(Presets, AutoIsFirstAndThereAreManyMore) {
    ASSERT_GE(bundledPresets().size(), 9U);
    EXPECT_EQ(bundledPresets().front().id, "auto");
    for (const PresetCard& card : bundledPresets()) {
        EXPECT_FALSE(card.name.empty());
        EXPECT_FALSE(card.help.empty());
    }
}

TEST(Presets, EveryOneFitsEveryVolume) {
    const VolumePointer volumes[] = {
        makeHeadPhantom(48), branches(), blob(),
        makeVolume<std::uint8_t>(gridOf({9, 9, 9}), VoxelType::uint8, [](glm::ivec3) { return 4; }),
        makeVolume<float>(
            gridOf({20, 1, 20}), VoxelType::float32, [](glm::ivec3 v) { return 0.01 * v.x; }, 7, -3)};
    for (const VolumePointer& volume : volumes) {
        for (const PresetCard& card : bundledPresets()) {
            std::vector<std::string> notes;
            if (card.modality == "labels") {
                continue; // label_look_test.cpp
            }
            const Figure figure = figureFromPreset(card.id, volume, notes);
            EXPECT_FALSE(figure.layers.empty()) << card.id;
            EXPECT_GT(figure.camera.heightMm, 0) << card.id;
            EXPECT_EQ(figure.volume->data, volume);
            for (const StyleEntry& style : figure.styles) {
                EXPECT_NE(style.sphere, nullptr) << card.id << ' ' << style.file;
            }
            for (const Problem& problem : validateFigure(figure)) {
                EXPECT_FALSE(problem.fatal) << card.id << ' ' << problem.pointer << ' ' << problem.why;
            }
            EXPECT_EQ(notes.empty(), card.id != "auto" && figure.cleanup.empty()) << card.id;
        }
    }
}

TEST(Presets, SayWhatWasTakenOut) {
    const auto volume = makeVolume<std::int16_t>(gridOf({120, 120, 60}), VoxelType::int16, [](glm::ivec3 v) {
        const bool head = std::hypot(v.x - 60, v.y - 50) < 40;
        return v.y > 104 && v.y < 110 ? 300 : head ? 40 : -1000; // a table behind the head
    });
    std::vector<std::string> notes;
    const Figure figure = figureFromPreset("skin", volume, notes);
    ASSERT_EQ(figure.cleanup.size(), 1U);
    EXPECT_EQ(figure.cleanup[0].kind, CleanupKind::keepLargest);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("table"), std::string::npos);
}

TEST(Presets, UnknownOnesNameTheKnown) {
    std::vector<std::string> notes;
    try {
        figureFromPreset("skul", blob(), notes);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(e.what()).find("skull"), std::string::npos);
    }
}

TEST(Presets, ALookKeepsCameraClipsAndOutput) {
    std::vector<std::string> notes;
    Figure figure = figureFromPreset("skull", makeHeadPhantom(48), notes);
    figure.camera.heightMm = 77;
    figure.clip.planes.push_back({{1, 0, 0}, 5});
    figure.output.dpi = 123;
    const Figure changed = withPreset(figure, "skin", notes);
    EXPECT_EQ(changed.camera, figure.camera);
    EXPECT_EQ(changed.clip, figure.clip);
    EXPECT_EQ(changed.output, figure.output);
    EXPECT_NE(changed.layers, figure.layers);
    figure.volume->data = nullptr;
    EXPECT_THROW(withPreset(figure, "skin", notes), Error);
}

/// Where a point lands in the picture.
glm::dvec2 pictured(const Camera& camera, const glm::dvec3& mm) { return glm::dvec2(ViewFrame(camera, 1).project(mm)); }

TEST(StandardView, NoMirroredPatient) {
    const auto head = makeHeadPhantom(32);
    const glm::dvec3 left(50, 0, 0), anterior(0, -50, 0), superior(0, 0, 50);
    const auto at = [&](StandardView view, const glm::dvec3& p) {
        return pictured(standardView(*head, view), p) - 0.5;
    };
    EXPECT_GT(at(StandardView::anterior, left).x, 0.1);
    EXPECT_LT(at(StandardView::anterior, superior).y, -0.1);
    EXPECT_LT(at(StandardView::posterior, left).x, -0.1);
    EXPECT_LT(at(StandardView::left, anterior).x, -0.1); // from the patient's left the face looks left
    EXPECT_GT(at(StandardView::right, anterior).x, 0.1);
    EXPECT_LT(at(StandardView::superior, left).x, -0.1); // from above, face up
    EXPECT_LT(at(StandardView::superior, anterior).y, -0.1);
    EXPECT_GT(at(StandardView::inferior, left).x, 0.1); // as films are hung
    EXPECT_LT(at(StandardView::inferior, anterior).y, -0.1);
    EXPECT_GT(at(StandardView::threeQuarter, left).x, 0.05);
}

TEST(StandardView, FitsTheMatterWithPaperAround) {
    Grid grid = gridOf({100, 80, 60});
    grid.spacingMm = {1, 2, 3};
    grid.originMm = {-300, 40, 7};
    const auto volume = makeVolume<std::uint8_t>(grid, VoxelType::uint8, [](glm::ivec3 v) {
        return v.x >= 40 && v.x < 60 && v.y >= 10 && v.y < 30 && v.z >= 20 && v.z < 30 ? 200 : 0;
    });
    const Camera camera = standardView(*volume, StandardView::anterior, 100);
    EXPECT_NEAR(camera.targetMm.x, -300 + 49.5, 1.5);
    EXPECT_NEAR(camera.targetMm.z, 7 + 3 * 24.5, 1.5);
    EXPECT_GT(camera.heightMm, 30); // ten slices of 3 mm
    EXPECT_LT(camera.heightMm, 40);
    const Camera whole = standardView(*volume, StandardView::anterior);
    EXPECT_NEAR(whole.heightMm, 1.08 * 180, 8);
}

} // namespace
} // namespace limner
