#include "core/figure/figure_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace limner {
namespace {

/// A figure without a fault.
Figure soundFigure() {
    Figure figure;
    StyleEntry style;
    style.id = "ivory";
    style.file = "bundled:ivory";
    figure.styles = {style};
    Layer layer;
    TransferNode node;
    node.style = "ivory";
    layer.transfer.nodes = {node, node};
    layer.transfer.nodes[1].at = 5;
    layer.transfer.opacity = {{0, 0}, {1, 0.5}, {1, 1}};
    figure.layers = {layer};
    return figure;
}

bool hasProblem(const Figure& figure, const std::string& pointer, bool fatal) {
    const std::vector<Problem> problems = validateFigure(figure);
    return std::any_of(problems.begin(), problems.end(), [&](const Problem& problem) {
        return problem.pointer == pointer && problem.fatal == fatal && !problem.why.empty();
    });
}

TEST(Validate, SoundFigureHasNoProblem) {
    EXPECT_TRUE(validateFigure(soundFigure()).empty());
    Figure phong = soundFigure();
    phong.layers[0].shading = Shading::phong;
    phong.layers[0].specular.emplace();
    EXPECT_TRUE(validateFigure(phong).empty());
}

using Edit = std::function<void(Figure&)>;

using Case = std::pair<const char*, Edit>;

void expectFatal(std::span<const Case> cases) {
    for (const auto& [pointer, edit] : cases) {
        Figure figure = soundFigure();
        edit(figure);
        EXPECT_TRUE(hasProblem(figure, pointer, true)) << pointer;
    }
}

TEST(Validate, FaultsOfViewAndOutputAreFatal) {
    const Case cases[] = {
        {"/camera/direction",
         [](Figure& f) {
             f.camera.direction = {0, 0, 0};
         }},
        {"/camera/up",
         [](Figure& f) {
             f.camera.up = {0, 0, 0};
         }},
        {"/camera/up", [](Figure& f) { f.camera.up = f.camera.direction * -3.0; }},
        {"/camera/height_mm", [](Figure& f) { f.camera.heightMm = 0; }},
        {"/camera/fov_deg",
         [](Figure& f) {
             f.camera.projection = Projection::perspective;
             f.camera.fovDeg = 180;
         }},
        {"/clip/box_mm",
         [](Figure& f) {
             f.clip.boxMm = BoxMm{{0, 0, 0}, {1, -1, 1}};
         }},
        {"/clip/planes/0/normal",
         [](Figure& f) {
             f.clip.planes.push_back({{0, 0, 0}, 0});
         }},
        {"/cleanup/0/polygon", [](Figure& f) { f.cleanup.emplace_back().kind = CleanupKind::scissors; }},
        {"/cleanup/0/camera",
         [](Figure& f) {
             CleanupStep& step = f.cleanup.emplace_back();
             step.kind = CleanupKind::scissors;
             step.polygon = {{0, 0}, {1, 0}, {1, 1}};
         }},
        {"/cleanup/0/at_mm", [](Figure& f) { f.cleanup.emplace_back().kind = CleanupKind::keepAt; }},
        {"/cleanup/0/kind", [](Figure& f) { f.cleanup.emplace_back().kind = CleanupKind::eraseLabel; }},
    };
    expectFatal(cases);
}

TEST(Validate, FaultsOfStylesAndLayersAreFatal) {
    const Case cases[] = {
        {"/styles/1/id", [](Figure& f) { f.styles.push_back(f.styles[0]); }},
        {"/styles/0/file", [](Figure& f) { f.styles[0].file.clear(); }},
        {"/layers/0/transfer/nodes", [](Figure& f) { f.layers[0].transfer.nodes.clear(); }},
        {"/layers/0/transfer/nodes/1/at", [](Figure& f) { f.layers[0].transfer.nodes[1].at = -1; }},
        {"/layers/0/transfer/nodes/1/style", [](Figure& f) { f.layers[0].transfer.nodes[1].style = "iovry"; }},
        {"/layers/0/transfer/nodes/1", [](Figure& f) { f.layers[0].transfer.nodes[1].style.clear(); }},
        {"/layers/0/transfer/opacity/1/0", [](Figure& f) { f.layers[0].transfer.opacity[1].x = -1; }},
        {"/layers/0/transfer/opacity/2/1", [](Figure& f) { f.layers[0].transfer.opacity[2].y = 1.01; }},
        {"/layers/0/opacity", [](Figure& f) { f.layers[0].opacity = -1; }},
        {"/layers/0/tone/keys/1/at",
         [](Figure& f) {
             f.layers[0].tone = Tone{{}, {{1, {}}, {0, {}}}, 1};
         }},
        {"/layers/0/transfer/axes", [](Figure& f) { f.layers[0].transfer.kind = TransferKind::twoDimensional; }},
        {"/layers/0/transfer/nodes/styles",
         [](Figure& f) {
             f.layers[0].transfer.kind = TransferKind::twoDimensional;
             f.layers[0].transfer.grid = TransferGrid{{0, 1}, {0}, {{"ivory"}}};
         }},
        {"/layers/0/transfer/nodes/y/1",
         [](Figure& f) {
             f.layers[0].transfer.kind = TransferKind::twoDimensional;
             f.layers[0].transfer.grid = TransferGrid{{0}, {1, 1}, {{"ivory"}, {"ivory"}}};
         }},
        {"/output", [](Figure& f) { f.output.widthMm = 0; }},
        {"/output",
         [](Figure& f) {
             f.output.dpi = 1e5;
             f.output.heightMm = 1e5;
         }},
        {"/quality/samples_per_pixel", [](Figure& f) { f.quality.samplesPerPixel = 3; }},
    };
    expectFatal(cases);
}

/// A figure without a fault whose layer has two axes and one shape of each kind.
Figure planeFigure() {
    Figure figure = soundFigure();
    Transfer& transfer = figure.layers[0].transfer;
    transfer.kind = TransferKind::twoDimensional;
    transfer.axes = {"value", "gradient"};
    transfer.nodes.clear();
    transfer.grid = TransferGrid{{0, 1}, {0}, {{"ivory", "#a0b0C0"}}};
    transfer.opacity.clear();
    transfer.opacity2d = {{"rectangle", {0, 1}, {0, 0}, 1, 0, 0, {}},
                          {"trapezoid", {0, 0, 1, 1}, {0, 1, 2, 3}, 1, 0, 0, {}},
                          {"ellipse", {0, 1}, {0, 1}, 1, 0, 0, {}},
                          {"polygon", {0, 1, 0}, {0, 0, 1}, 1, 0, 0, {}},
                          {"mask", {0, 1}, {0, 1}, 1, 0, 2, {0, 0.5, 1, 1}}};
    return figure;
}

TEST(Validate, SoundPlanesHaveNoFault) {
    const std::vector<Problem> problems = validateFigure(planeFigure());
    for (const Problem& problem : problems) {
        EXPECT_FALSE(problem.fatal) << problem.pointer << ": " << problem.why;
        EXPECT_EQ(problem.pointer.find("opacity"), std::string::npos) << problem.pointer;
    }
}

TEST(Validate, FaultsOfShapesAreFatal) {
    using ShapeEdit = std::function<void(std::vector<OpacityShape>&)>;
    const std::pair<const char*, ShapeEdit> shapes[] = {
        {"/0/shape", [](auto& s) { s[0].shape = "blob"; }},
        {"/0/x", [](auto& s) { s[0].x = {1}; }},
        {"/0/y",
         [](auto& s) {
             s[0].y = {1, 2, 3};
         }},
        {"/0/x/1",
         [](auto& s) {
             s[0].x = {1, 0};
         }},
        {"/1/x",
         [](auto& s) {
             s[1].x = {0, 1};
         }},
        {"/1/y/3", [](auto& s) { s[1].y[3] = 1.5; }},
        {"/2/x", [](auto& s) { s[2].x = {}; }},
        {"/2/y/1", [](auto& s) { s[2].y[1] = -1; }},
        {"/3/x",
         [](auto& s) {
             s[3].x = s[3].y = {0, 1};
         }},
        {"/3/y", [](auto& s) { s[3].y.push_back(1); }},
        {"/3/y/2", [](auto& s) { s[3].y[2] = std::nan(""); }},
        {"/4/columns", [](auto& s) { s[4].columns = 0; }},
        {"/4/values", [](auto& s) { s[4].columns = 3; }},
        {"/4/values", [](auto& s) { s[4].values.clear(); }},
        {"/4/values/1", [](auto& s) { s[4].values[1] = 1.5; }},
        {"/2/opacity", [](auto& s) { s[2].opacity = -0.5; }},
        {"/2/soft", [](auto& s) { s[2].soft = 2; }},
    };
    for (const auto& [place, edit] : shapes) {
        Figure figure = planeFigure();
        edit(figure.layers[0].transfer.opacity2d);
        EXPECT_TRUE(hasProblem(figure, std::string("/layers/0/transfer/opacity_2d") + place, true)) << place;
    }
}

TEST(Validate, FaultsOfPlanesAreFatal) {
    const std::pair<const char*, std::function<void(Transfer&)>> parts[] = {
        {"/axes/0", [](Transfer& t) { t.axes[0] = "smell"; }},
        {"/axes/1", [](Transfer& t) { t.axes[1] = "value"; }},
        {"/distance", [](Transfer& t) { t.axes[1] = "distance"; }},
        {"/nodes/styles/0/1", [](Transfer& t) { t.grid->styles[0][1] = "#12"; }},
        {"/nodes/styles/0/0", [](Transfer& t) { t.grid->styles[0][0] = "iovry"; }},
        {"/opacity/0/1",
         [](Transfer& t) {
             t.opacity = {{0, 2}};
         }},
    };
    for (const auto& [place, edit] : parts) {
        Figure figure = planeFigure();
        edit(figure.layers[0].transfer);
        EXPECT_TRUE(hasProblem(figure, std::string("/layers/0/transfer") + place, true)) << place;
    }
    const Case others[] = {
        {"/layers/0/transfer/axis", [](Figure& f) { f.layers[0].transfer.axis = "smell"; }},
        {"/layers/0/transfer/distance", [](Figure& f) { f.layers[0].transfer.axis = "distance"; }},
        {"/styles/0/texture/file", [](Figure& f) { f.styles[0].texture.emplace(); }},
    };
    expectFatal(others);
}

TEST(Validate, WhatAnAxisNeedsIsSaid) {
    const std::pair<const char*, Edit> cases[] = {
        {"/axes/1", [](Figure& f) { f.layers[0].transfer.axes[1] = "label"; }},
        {"/axes/1", [](Figure& f) { f.layers[0].transfer.axes[1] = "second"; }},
        {"/distance/label",
         [](Figure& f) {
             f.layers[0].transfer.axes[1] = "distance";
             f.layers[0].transfer.distance.emplace();
         }},
        {"/opacity_2d", [](Figure& f) { f.layers[0].transfer.opacity2d.clear(); }},
    };
    for (const auto& [place, edit] : cases) {
        Figure figure = planeFigure();
        edit(figure);
        const std::string pointer = std::string("/layers/0/transfer") + place;
        EXPECT_TRUE(hasProblem(figure, pointer, false)) << pointer;
        figure.labels.emplace();
        figure.secondVolume.emplace();
        figure.layers[0].transfer.opacity = {{0, 1}};
        EXPECT_FALSE(hasProblem(figure, pointer, false)) << pointer;
    }
    Figure point = planeFigure();
    point.layers[0].transfer.axes[1] = "distance";
    point.layers[0].transfer.distance.emplace().fromMm = glm::dvec3(1, 2, 3);
    EXPECT_FALSE(hasProblem(point, "/layers/0/transfer/distance/label", false));
}

TEST(Validate, WeighedObjectsNeedLabels) {
    Figure figure = soundFigure();
    figure.importance.emplace().weights.object = 1;
    EXPECT_TRUE(hasProblem(figure, "/importance/objects", false)) << "no object has a weight";
    figure.importance->objects = {{1, 2}};
    EXPECT_TRUE(hasProblem(figure, "/importance/objects", true)) << "no labels";
    figure.labels.emplace();
    EXPECT_FALSE(hasProblem(figure, "/importance/objects", true));
}

TEST(Validate, AnAxisOfImportanceNeedsSomethingWeighed) {
    Figure figure = soundFigure();
    figure.layers[0].transfer.axis = "importance";
    EXPECT_TRUE(hasProblem(figure, "/layers/0/transfer/axis", true));
    figure.importance.emplace();
    EXPECT_FALSE(hasProblem(figure, "/layers/0/transfer/axis", true));
}

TEST(Validate, ClipsOfLayersAreChecked) {
    Figure figure = soundFigure();
    Clip& clip = figure.layers[0].clip.emplace();
    clip.boxMm = BoxMm{{0, 0, 0}, {1, 0, 1}};
    EXPECT_TRUE(hasProblem(figure, "/layers/0/clip/box_mm", true));
    clip.boxMm.reset();
    clip.planes = {{{0, 0, 0}, 1}};
    EXPECT_TRUE(hasProblem(figure, "/layers/0/clip/planes/0/normal", true));
    clip.planes.clear();
    clip.face = CutFace{"nobody", {}};
    EXPECT_TRUE(hasProblem(figure, "/layers/0/clip/face/style", true));
    figure.layers[0].position.emplace().axis = "direction";
    figure.layers[0].position->direction = {0, 0, 0};
    EXPECT_TRUE(hasProblem(figure, "/layers/0/position/direction", true));
}

TEST(Validate, AnnotationsThatCannotShowAreSaid) {
    Figure figure = soundFigure();
    Annotation& label = figure.annotations.emplace_back();
    EXPECT_TRUE(hasProblem(figure, "/annotations/0/text", false));
    label.text = "Orbit";
    EXPECT_FALSE(hasProblem(figure, "/annotations/0/text", false));
    EXPECT_TRUE(hasProblem(figure, "/annotations/0/anchor_mm", false));
    label.anchorMm = glm::dvec3(0);
    EXPECT_FALSE(hasProblem(figure, "/annotations/0/anchor_mm", false));
    figure.camera.heightMm = 100;
    figure.output = {180, 90, 300, false}; // 200 mm of the patient across
    Annotation& bar = figure.annotations.emplace_back();
    bar.kind = "scale-bar";
    bar.lengthMm = 200;
    EXPECT_FALSE(hasProblem(figure, "/annotations/1/length_mm", false));
    bar.lengthMm = 201;
    EXPECT_TRUE(hasProblem(figure, "/annotations/1/length_mm", false));
}

} // namespace
} // namespace limner
