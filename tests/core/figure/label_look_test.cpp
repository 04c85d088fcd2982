#include "core/figure/label_look.h"

#include "core/base/error.h"
#include "core/figure/figure_json.h"
#include "core/figure/presets.h"
#include "core/volume/phantom.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdlib>
#include <set>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

/// CIE L*a*b* of a colour "#rrggbb" (D65), which is not how the palette is made.
glm::dvec3 labOf(const std::string& hex) {
    const auto linear = [&](std::size_t at) {
        const double c = std::strtol(hex.substr(at, 2).c_str(), nullptr, 16) / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double r = linear(1);
    const double g = linear(3);
    const double b = linear(5);
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
    const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
    const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

TEST(DistinctColours, NeighboursDifferAndAllAreReadable) {
    const auto colours = distinctColours(kMostLabelRows);
    ASSERT_EQ(colours.size(), kMostLabelRows);
    for (std::size_t i = 0; i < colours.size(); ++i) {
        ASSERT_EQ(colours[i].size(), 7U);
        const glm::dvec3 lab = labOf(colours[i]);
        EXPECT_TRUE(lab.x > 45 && lab.x < 90) << colours[i]; // neither ink nor paper
        EXPECT_TRUE(std::hypot(lab.y, lab.z) > 15 && std::hypot(lab.y, lab.z) < 70) << colours[i]; // no grey, no neon
        if (i > 0) {
            EXPECT_GT(glm::distance(lab, labOf(colours[i - 1])), 25) << i; // 2.3 is just seen
        }
    }
    for (std::size_t i = 0; i < 16; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT(glm::distance(labOf(colours[i]), labOf(colours[j])), 10) << i << ' ' << j;
        }
    }
    EXPECT_EQ(std::set<std::string>(colours.begin(), colours.end()).size(), colours.size());
    const auto few = distinctColours(9);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), colours.begin()));
}

/// Labels 0 (outside), 2 and 5 (halves of a block), 9 (one voxel).
LabelReference block() {
    LabelReference labels;
    labels.path = "labels.nrrd";
    labels.data = makeVolume<std::uint8_t>(gridOf({40, 40, 40}), VoxelType::uint8, [](glm::ivec3 v) {
        const bool in = v.x >= 10 && v.x < 20 && v.y >= 10 && v.y < 30 && v.z >= 10 && v.z < 30;
        return v == glm::ivec3(3, 3, 3) ? 9 : !in ? 0 : v.z < 20 ? 2 : 5;
    });
    labels.names = {{"2", "lower"}};
    labels.colours = {{"5", "#102030"}, {"9", "no colour"}};
    return labels;
}

TEST(LabelLook, HasARowForEachLabelThatOccurs) {
    std::vector<std::string> notes;
    const Figure figure = withLabels({}, block(), notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(figure.labels->names.at("2"), "lower");
    ASSERT_EQ(figure.layers.size(), 1U);
    const Layer& layer = figure.layers[0];
    EXPECT_EQ(layer.transfer.kind, TransferKind::twoDimensional);
    EXPECT_EQ(layer.transfer.axes, (std::vector<std::string>{"value", "label"}));
    const auto palette = distinctColours(3);
    EXPECT_EQ(layer.transfer.grid->y, (std::vector<double>{2, 5, 9}));
    EXPECT_EQ(layer.transfer.grid->styles,
              (std::vector<std::vector<std::string>>{{palette[0]}, {"#102030"}, {palette[2]}}));
    EXPECT_TRUE(layer.transfer.opacity.empty());
    EXPECT_TRUE(layer.transfer.opacity2d.empty());
    EXPECT_EQ(layer.shading, Shading::phong);
    EXPECT_EQ(layer.contours->thicknessMm, 0.3);
    EXPECT_TRUE(drawsByLabel(figure));
    EXPECT_FALSE(drawsByLabel({}));
}

TEST(LabelLook, ComesBackFromJsonAsItWas) {
    std::vector<std::string> notes;
    const Figure figure = withLabels({}, block(), notes);
    const Figure again = readFigure(writeFigure(figure), "test");
    EXPECT_EQ(again.layers, figure.layers);
    EXPECT_EQ(again.labels->names, figure.labels->names);
    EXPECT_EQ(again.labels->colours, figure.labels->colours);
    for (const Problem& problem : validateFigure(figure)) {
        EXPECT_FALSE(problem.fatal) << problem.pointer << ' ' << problem.why;
    }
}

TEST(LabelLook, DrawsTheLargestOfTooMany) {
    LabelReference many; // label k has k voxels, all on one row
    many.data = makeVolume<std::int16_t>(gridOf({300, 300, 1}), VoxelType::int16,
                                         [](glm::ivec3 v) { return v.x < v.y ? v.y : 0; });
    std::vector<std::string> notes;
    const Figure figure = withLabels({}, many, notes);
    const auto& rows = figure.layers[0].transfer.grid->y;
    ASSERT_EQ(rows.size(), 200U);
    EXPECT_EQ(rows.front(), 100);
    EXPECT_EQ(rows.back(), 299);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("200 largest of 299"), std::string::npos);
}

TEST(LabelLook, RefusesWhatHasNoLabels) {
    std::vector<std::string> notes;
    EXPECT_THROW(withLabels({}, {}, notes), Error);
    LabelReference empty;
    empty.data = makeVolume<std::uint8_t>(gridOf({4, 4, 4}), VoxelType::uint8, [](glm::ivec3) { return 0; });
    EXPECT_THROW(withLabels({}, empty, notes), Error);
}

TEST(Presets, AutoDrawsLabelsWhereThereAreAny) {
    const auto scan =
        makeVolume<std::int16_t>(gridOf({40, 40, 40}), VoxelType::int16, [](glm::ivec3 v) { return v.x * 20 - 1000; });
    std::vector<std::string> notes;
    const Figure figure = figureFromPreset("auto", scan, notes, block());
    EXPECT_TRUE(drawsByLabel(figure));
    ASSERT_TRUE(figure.labels && figure.labels->data);
    EXPECT_EQ(figure.layers, figureFromPreset("labelled", scan, notes, figure.labels).layers);
    // Looks at the block (10 x 20 x 20 mm about (14.5, 19.5, 19.5)), not at the whole box.
    EXPECT_LT(glm::distance(figure.camera.targetMm, glm::dvec3(14.5, 19.5, 19.5)), 1);
    EXPECT_LT(figure.camera.heightMm, 40);
    EXPECT_EQ(figure.quality.samplesPerPixel, 4);

    const Figure bones = withPreset(figure, "skull", notes);
    EXPECT_EQ(bones.labels, figure.labels);
    EXPECT_FALSE(drawsByLabel(bones));
    EXPECT_TRUE(drawsByLabel(withPreset(bones, "auto", notes)));
    EXPECT_THROW(figureFromPreset("labelled", scan, notes), Error);
}

} // namespace
} // namespace limner
