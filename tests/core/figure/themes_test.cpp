#include "core/figure/themes.h"

#include "core/base/error.h"
#include "core/figure/figure_json.h"
#include "core/figure/presets.h"
#include "core/volume/phantom.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace limner {
namespace {

bool hasFatalProblem(const Figure& figure) {
    const std::vector<Problem> problems = validateFigure(figure);
    return std::any_of(problems.begin(), problems.end(), [](const Problem& problem) { return problem.fatal; });
}

constexpr const char* kRoles[] = {"bone",  "teeth", "skin",      "veil",    "vessel",  "vein",   "muscle", "organ",
                                  "brain", "fat",   "cartilage", "implant", "outline", "matter", "any"};

/// A figure with a style of every role, one of no role and one of a role that no theme names.
Figure figureOfAllRoles() {
    Figure figure;
    figure.background.rgba = {0.1, 0.2, 0.3, 0.5};
    for (const char* role : kRoles) {
        StyleEntry entry;
        entry.id = std::string("id of ") + role;
        entry.file = "styles/mine.png";
        entry.role = role;
        figure.styles.push_back(entry);
    }
    StyleEntry own;
    own.id = "own";
    own.file = "styles/own.png";
    own.credit = "A. Painter";
    figure.styles.push_back(own);
    StyleEntry unheard;
    unheard.id = "unheard";
    unheard.role = "ectoplasm";
    figure.styles.push_back(unheard);
    Layer layer;
    layer.transfer.nodes = {{0, "own", std::nullopt}, {1, "", glm::dvec3(0.2, 0.4, 0.6)}, {2, "id of bone", {}}};
    figure.layers.push_back(layer);
    return figure;
}

TEST(Themes, EveryOneHasAStyleForEveryRole) {
    ASSERT_GE(bundledThemes().size(), 7U);
    std::set<std::string> looks;
    for (const ThemeCard& card : bundledThemes()) {
        EXPECT_FALSE(card.name.empty()) << card.id;
        EXPECT_FALSE(card.help.empty()) << card.id;
        std::vector<std::string> notes;
        const Figure themed = withTheme(figureOfAllRoles(), card.id, notes);
        ASSERT_EQ(notes.size(), 1U) << card.id; // of the style without a role
        std::string look;
        for (const StyleEntry& entry : themed.styles) {
            if (entry.role.empty()) {
                continue;
            }
            EXPECT_TRUE(entry.file.starts_with("bundled:")) << card.id << " " << entry.role;
            ASSERT_NE(entry.sphere, nullptr) << card.id << " " << entry.role;
            EXPECT_EQ(entry.sphere, findBundledStyle(entry.file.substr(8))->sphere);
            EXPECT_FALSE(entry.licence.empty()) << card.id << " " << entry.role;
            // Where one looks through the skin, it must stay see-through.
            EXPECT_EQ(entry.sphere->hasDirectionalOpacity(), entry.role == "veil") << card.id << " " << entry.role;
            look += entry.file + " ";
        }
        EXPECT_EQ(themed.styles.back().file, themed.styles[14].file) << "any stands in for unheard roles";
        EXPECT_TRUE(looks.insert(look).second) << card.id << " looks like another theme";
    }
}

TEST(Themes, NeighboursInAPictureAreToldApart) {
    // Roles that stand beside each other in the presets' pictures.
    const std::pair<std::string, std::string> pairs[] = {{"bone", "vessel"},   {"bone", "skin"},  {"bone", "muscle"},
                                                         {"vessel", "muscle"}, {"brain", "skin"}, {"brain", "fat"},
                                                         {"vein", "bone"},     {"muscle", "fat"}, {"organ", "bone"}};
    for (const ThemeCard& card : bundledThemes()) {
        std::vector<std::string> notes;
        const Figure themed = withTheme(figureOfAllRoles(), card.id, notes);
        for (const auto& [a, b] : pairs) {
            if (a == "vessel" && b == "muscle" && (card.id == "red-chalk" || card.id == "graphite")) {
                continue; // one dark drawing stick for both
            }
            EXPECT_NE(themed.findStyle("id of " + a)->sphere, themed.findStyle("id of " + b)->sphere)
                << card.id << ": " << a << " and " << b;
        }
    }
}

TEST(Themes, OnlyLookChanges) {
    const Figure before = figureOfAllRoles();
    std::vector<std::string> notes;
    const Figure after = withTheme(before, "blackboard", notes);
    ASSERT_EQ(after.layers.size(), before.layers.size());
    EXPECT_EQ(after.layers[0].transfer, before.layers[0].transfer); // plain colours too
    EXPECT_EQ(after.camera, before.camera);
    EXPECT_EQ(after.output, before.output);
    EXPECT_EQ(*after.findStyle("own"), *before.findStyle("own"));
    EXPECT_NE(notes.at(0).find("\"own\""), std::string::npos);
    ASSERT_EQ(after.styles.size(), before.styles.size());
    for (std::size_t i = 0; i < after.styles.size(); ++i) {
        EXPECT_EQ(after.styles[i].id, before.styles[i].id);
        EXPECT_EQ(after.styles[i].role, before.styles[i].role);
    }
    EXPECT_LT(after.background.rgba.g, 0.3); // a dark board
    EXPECT_EQ(after.background.rgba.a, 1);
}

TEST(Themes, ALockedLayerKeepsItsLook) {
    Figure before = figureOfAllRoles();
    before.clip.face = CutFace{"id of bone", std::nullopt};
    Layer locked = before.layers[0];
    locked.name = "Mine";
    locked.locked = true;
    locked.contours.emplace().thicknessMm = 3;
    locked.transfer.nodes.push_back({3, "id of skin", {}});
    before.layers.push_back(locked);
    std::vector<std::string> notes;
    const Figure after = withTheme(before, "blackboard", notes);
    EXPECT_EQ(after.layers[1], before.layers[1]);
    for (const char* id : {"id of bone", "id of skin"})
        EXPECT_EQ(*after.findStyle(id), *before.findStyle(id)) << id;
    EXPECT_NE(std::find_if(notes.begin(), notes.end(),
                           [](const std::string& note) { return note.find("\"Mine\" is locked") != note.npos; }),
              notes.end());
    const std::string own = after.layers[0].transfer.nodes[2].style;
    EXPECT_NE(own, "id of bone") << "the other layer does not wear what is locked";
    ASSERT_TRUE(after.findStyle(own));
    EXPECT_EQ(after.clip.face->style, own);
    Figure free = before;
    free.layers.pop_back();
    std::vector<std::string> others;
    EXPECT_EQ(after.findStyle(own)->file, withTheme(free, "blackboard", others).findStyle("id of bone")->file);
    EXPECT_EQ(withTheme(after, "blackboard", notes), after) << "once apart, apart";
}

TEST(Themes, TheLastOneCounts) {
    Figure start = figureOfAllRoles();
    start.layers[0].contours.emplace();
    for (const ThemeCard& a : bundledThemes()) {
        for (const ThemeCard& b : bundledThemes()) {
            std::vector<std::string> notes;
            EXPECT_EQ(withTheme(withTheme(start, a.id, notes), b.id, notes), withTheme(start, b.id, notes))
                << a.id << " then " << b.id;
        }
    }
}

TEST(Themes, EveryPresetTakesThem) {
    const std::shared_ptr<const Volume> head = makeHeadPhantom(48);
    LabelReference labels; // for the preset that needs them
    labels.data =
        testing::makeVolume<std::uint8_t>(head->grid(), VoxelType::uint8, [](glm::ivec3 v) { return v.x / 24; });
    for (const PresetCard& preset : bundledPresets()) {
        std::vector<std::string> notes;
        const Figure figure = figureFromPreset(preset.id, head, notes, labels);
        notes.clear();
        const Figure themed = withTheme(figure, "haeckel", notes);
        EXPECT_TRUE(notes.empty()) << preset.id << ": " << notes.front();
        for (std::size_t i = 0; i < themed.styles.size(); ++i) {
            EXPECT_FALSE(figure.styles[i].role.empty()) << preset.id << " " << figure.styles[i].id;
            EXPECT_NE(themed.styles[i].sphere, figure.styles[i].sphere) << preset.id << " " << figure.styles[i].id;
            EXPECT_EQ(themed.styles[i].sphere->hasDirectionalOpacity(),
                      figure.styles[i].sphere->hasDirectionalOpacity());
        }
        ASSERT_EQ(themed.layers.size(), figure.layers.size());
        for (std::size_t i = 0; i < themed.layers.size(); ++i) {
            EXPECT_EQ(themed.layers[i].transfer, figure.layers[i].transfer) << preset.id;
        }
        EXPECT_FALSE(hasFatalProblem(themed)) << preset.id;
    }
}

TEST(Themes, TheirPenDrawsTheContoursOfLayersWithRoles) {
    Figure figure = figureOfAllRoles();
    figure.layers[0].contours = Contours{.thicknessMm = 7, .curvatureControlled = false};
    Layer plain;
    plain.transfer.nodes = {{0, "own", std::nullopt}, {1, "", glm::dvec3(1, 0, 0)}};
    plain.contours = Contours{.thicknessMm = 3};
    Layer plane;
    plane.transfer.kind = TransferKind::twoDimensional;
    plane.transfer.grid = TransferGrid{{0, 1}, {0}, {{"#808080", "id of skin"}}};
    Layer flat = figure.layers[0];
    flat.shading = Shading::flat;
    figure.layers.insert(figure.layers.end(), {plain, plane, flat});
    int with = 0;
    for (const ThemeCard& card : bundledThemes()) {
        std::vector<std::string> notes;
        const Figure themed = withTheme(figure, card.id, notes);
        EXPECT_NE(themed.layers[0].contours, figure.layers[0].contours) << card.id;
        EXPECT_EQ(themed.layers[1].contours, plain.contours) << card.id << ": no role";
        EXPECT_EQ(themed.layers[2].contours, themed.layers[0].contours) << card.id;
        EXPECT_EQ(themed.layers[3].contours, flat.contours) << card.id << ": not shaded by its styles";
        if (const auto& contours = themed.layers[0].contours) {
            ++with;
            // Thinner, no press prints; thicker, it hides what it bounds.
            EXPECT_GE(contours->thicknessMm, 0.1) << card.id;
            EXPECT_LE(contours->thicknessMm, 1) << card.id;
            EXPECT_EQ(*contours, Contours{.thicknessMm = contours->thicknessMm}) << card.id;
        }
    }
    EXPECT_GE(with, 3);
    EXPECT_LT(with, static_cast<int>(bundledThemes().size())) << "the brush has no pen";
}

TEST(Themes, RolesAndTheLookSurviveTheFile) {
    std::vector<std::string> notes;
    const Figure themed = withTheme(figureFromPreset("skull", makeHeadPhantom(48), notes), "gray", notes);
    const Figure read = readFigure(writeFigure(themed), "themed");
    ASSERT_EQ(read.styles.size(), themed.styles.size());
    for (std::size_t i = 0; i < read.styles.size(); ++i) {
        EXPECT_EQ(read.styles[i].role, themed.styles[i].role);
        EXPECT_EQ(read.styles[i].file, themed.styles[i].file);
    }
    EXPECT_EQ(read.background.rgba, themed.background.rgba);
}

TEST(Themes, AnUnknownOneNamesTheKnown) {
    std::vector<std::string> notes;
    try {
        withTheme(Figure{}, "cubism", notes);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        for (const ThemeCard& card : bundledThemes()) {
            EXPECT_NE(std::string(error.what()).find(card.id), std::string::npos) << error.what();
        }
    }
}

} // namespace
} // namespace limner
