#include "core/figure/stipple_presets.h"

#include "core/figure/figure_json.h"
#include "core/optics/stipple.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <set>

namespace limner {
namespace {

/// A place on a surface, as the factors see it.
struct Place {
    double gradient = 0.6;
    double cosineEye = 0.8;
    double depth = 0; ///< -1 far, 1 near
    glm::dvec3 normal{0, 0, 1};
};

/// The tone that a look asks for there, of whole matter: the product of the factors that are there.
double toneAt(const Stipple& look, const Place& place) {
    double tone = 1;
    if (const auto& f = look.boundary)
        tone *= optics::boundaryFactor(1.0, place.gradient, {f->kgc, f->kgs, f->kge});
    if (const auto& f = look.silhouette)
        tone *= optics::silhouetteFactor(1.0, place.cosineEye, {f->ksc, f->kss, f->kse});
    if (const auto& f = look.distance)
        tone *= optics::distanceFactor(place.depth, 1.0, f->kde);
    if (const auto& f = look.interior)
        tone *= optics::interiorFactor(place.gradient, f->kte);
    if (const auto& f = look.lighting)
        tone *= optics::lightingFactor(glm::dot(glm::normalize(f->light.direction), place.normal), f->kle);
    return tone;
}

const Stipple& look(const std::string& id) {
    for (const PartPreset<Stipple>& preset : stipplePresets())
        if (preset.id == id)
            return preset.part;
    throw std::out_of_range(id);
}

TEST(StipplePresets, EachIsValidAndTheSameAfterAFile) {
    std::set<std::string> ids;
    std::set<std::string> names;
    for (const PartPreset<Stipple>& preset : stipplePresets()) {
        SCOPED_TRACE(preset.id);
        EXPECT_TRUE(ids.insert(preset.id).second);
        EXPECT_TRUE(names.insert(preset.name).second);
        EXPECT_TRUE(preset.help.ends_with(".")) << preset.help;
        Figure figure;
        figure.stipple = preset.part;
        for (const Problem& problem : validateFigure(figure))
            EXPECT_FALSE(problem.fatal) << problem.pointer << ": " << problem.why;
        EXPECT_EQ(readFigure(writeFigure(figure), "here").stipple, figure.stipple);
    }
    EXPECT_GE(ids.size(), 6U);
}

TEST(StipplePresets, EachDrawsSomethingAndNoneIsBlackWhereItFacesTheViewer) {
    for (const PartPreset<Stipple>& preset : stipplePresets()) {
        SCOPED_TRACE(preset.id);
        const Stipple& ink = preset.part;
        const bool dots = ink.kMax > 0 && ink.sizeMm > 0;
        EXPECT_TRUE(dots || ink.hatching || ink.curves || ink.innerLines);
        EXPECT_TRUE(!dots || toneAt(ink, {.cosineEye = 0.2, .normal = {0.8, -0.6, 0}}) > 0.1) << "some ink in the dark";
        EXPECT_TRUE(!(dots || ink.hatching) || toneAt(ink, {.gradient = 1, .cosineEye = 1}) < 0.7) << "paper is seen";
    }
}

TEST(StipplePresets, EachDoesWhatItsNameSays) {
    const Place facing{.cosineEye = 1};
    const Place turned{.cosineEye = 0.1};
    for (const char* id : {"boundaries-and-silhouettes", "see-through"})
        EXPECT_GT(toneAt(look(id), turned), 2 * toneAt(look(id), facing)) << id;
    EXPECT_GT(toneAt(look("boundaries-and-silhouettes"), {.gradient = 1}),
              1.5 * toneAt(look("boundaries-and-silhouettes"), {.gradient = 0.1}));
    EXPECT_EQ(look("see-through").hidden, "show");

    const Stipple& plain = look("plain-stipple");
    EXPECT_EQ(toneAt(plain, facing), toneAt(plain, {.cosineEye = 0.1, .depth = -0.9, .normal = {0, -1, 0}}));

    const Stipple& near = look("near-parts-darker");
    EXPECT_GT(toneAt(near, {.depth = 0.9}), 1.5 * toneAt(near, {.depth = 0}));
    EXPECT_LT(toneAt(near, {.depth = -0.9}), 0.3 * toneAt(near, {.depth = 0}));

    for (const char* id : {"lit-from-upper-left", "pen-and-ink"}) {
        const glm::dvec3 upperLeft = glm::normalize(glm::dvec3(-1, 1, 1)); // right, up, towards the viewer
        EXPECT_EQ(look(id).lighting->light.kind, "head") << "left as the viewer sees it";
        EXPECT_LT(toneAt(look(id), {.normal = upperLeft}), 0.15) << id;
        EXPECT_GT(toneAt(look(id), {.normal = -upperLeft}), 0.6) << id;
    }
    for (const char* id : {"pen-and-ink", "outlines-only"})
        EXPECT_EQ(look(id).kMax, 0) << id << " has no dots";
    EXPECT_TRUE(look("pen-and-ink").hatching);
    EXPECT_TRUE(look("outlines-only").curves && look("outlines-only").innerLines);
    EXPECT_FALSE(look("outlines-only").hatching);
}

TEST(StipplePresets, ALookLeavesInkAndPaperAsTheyWereSet) {
    const Stipple& pen = look("pen-and-ink");
    EXPECT_EQ(stippleInLook({}, pen), pen);
    Stipple now = look("plain-stipple");
    now.inkRgb = {0.3, 0.1, 0};
    now.fromStyle = true;
    now.sizeMm = 0.6;
    now.layerOpacity = "over";
    now.matter = "data";
    now.placing = "volume";
    now.tone = "count";
    now.gradient = "central";
    now.threshold = 0.2;
    now.spreadVoxels = 1;
    now.seed = 7;
    Stipple there = stippleInLook(now, pen);
    EXPECT_EQ(there.hatching, pen.hatching);
    EXPECT_EQ(there.boundary, pen.boundary);
    EXPECT_EQ(there.kMax, 0);
    EXPECT_EQ(stippleInLook(there, look("plain-stipple")), now) << "nothing of the other look stays behind";
}

} // namespace
} // namespace limner
