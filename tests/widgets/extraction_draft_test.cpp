#include "widgets/extraction_draft.h"

#include "widgets/art_plate.h"
#include "widgets/draft_edits.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

ExtractionDraft named(const std::string& name) {
    ExtractionDraft draft;
    draft.name = name;
    return draft;
}

TEST(DraftHistory, StepsOfOneGestureAreOne) {
    DraftHistory history;
    EXPECT_TRUE(history.apply({named("a"), "Type", "k#1", true}));
    EXPECT_TRUE(history.apply({named("ab"), "Type", "k#1", false}));
    EXPECT_FALSE(history.apply({named("ab"), "Type", "k#1", false})) << "it changes nothing";
    EXPECT_TRUE(history.apply({named("abc"), "Type", "k#2", false}));
    EXPECT_EQ(history.undoLabel(), "Type");
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.current().name, "ab");
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(history.current().name, "");
    EXPECT_FALSE(history.undo());
    EXPECT_TRUE(history.redo());
    EXPECT_TRUE(history.redo());
    EXPECT_FALSE(history.redo());
    EXPECT_EQ(history.current().name, "abc");
}

TEST(DraftHistory, AGestureBackToWhereItBeganLeavesNoStep) {
    DraftHistory history;
    history.apply({named("a"), "Type", "k#1", true});
    history.apply({named(""), "Type", "k#1", false});
    EXPECT_FALSE(history.canUndo());
    EXPECT_FALSE(history.canRedo());
}

TEST(DraftHistory, WhatWasTakenBackIsGoneAfterAChange) {
    DraftHistory history;
    history.apply({named("a"), "One", {}, false});
    history.undo();
    history.apply({named("b"), "Two", {}, false});
    EXPECT_FALSE(history.canRedo());
}

/// Masks of many strokes must not fill the memory; the newest steps stay.
TEST(DraftHistory, OldMasksFallAway) {
    DraftHistory history;
    Mask mask;
    mask.width = 2048;
    mask.height = 2048;
    mask.values.resize(mask.offset(0, mask.height));
    for (int i = 0; i < 100; ++i) {
        ExtractionDraft draft = named(std::to_string(i));
        draft.region = std::make_shared<const Mask>(mask);
        history.apply({draft, "Paint", {}, false});
    }
    int steps = 0;
    while (history.undo())
        ++steps;
    EXPECT_GE(steps, 50);
    EXPECT_LE(steps, 64) << "256 MB of 4 MB each";
}

TEST(ExtractionDraft, SameSphereLooksAtWhatCounts) {
    ExtractionDraft a;
    a.plate = testing::twoColours(40, 30);
    a.form = FormKind::ellipse;
    a.ellipse = Ellipse{{20, 15}, {8, 8}, 0};
    ExtractionDraft b = a;
    b.name = "another name";
    b.marks.depth = 2; // of a region
    EXPECT_TRUE(sameSphere(a, b));
    b.edits.smoothing = 0.5;
    EXPECT_TRUE(sameSource(a, b));
    EXPECT_FALSE(sameSphere(a, b));
    b = a;
    b.ellipse->centre.x += 1;
    EXPECT_FALSE(sameSource(a, b));
    b = a;
    b.removePaperCast = true;
    EXPECT_FALSE(sameSource(a, b));
    a.form = b.form = FormKind::swatches;
    EXPECT_TRUE(sameSource(a, b)) << "picked colours know no paper";
}

TEST(ExtractionDraft, ARequestHoldsTheFormAndWhatIsIgnored) {
    ExtractionDraft draft;
    draft.plate = testing::twoColours(40, 30);
    draft.form = FormKind::region;
    draft.region = withEnclosed(blankMask(*draft.plate), {{5, 5}, {20, 5}, {20, 20}, {5, 20}}, false);
    draft.marks.normals = {{{10, 10}, {0.5, 0.5}}};
    draft.ignored = std::make_shared<const Mask>(blankMask(*draft.plate));
    draft.skipLettering = false;
    draft.separateTexture = true;
    draft.size = 1024;
    const ExtractionRequest request = requestOf(draft, false);
    const auto* region = std::get_if<FormRegion>(&request.form);
    ASSERT_NE(region, nullptr);
    EXPECT_EQ(region->mask.values, draft.region->values);
    EXPECT_EQ(region->marks, draft.marks);
    EXPECT_EQ(request.ignored.values, draft.ignored->values);
    EXPECT_FALSE(request.skipLettering);
    EXPECT_TRUE(request.separateTexture);
    EXPECT_EQ(request.size, 1024);
    EXPECT_LT(requestOf(draft, true).size, 1024) << "while a hand moves";
}

TEST(ExtractionDraft, ACardSaysWhereTheStyleIsFrom) {
    ExtractionDraft draft;
    draft.plate = testing::twoColours(40, 30);
    draft.form = FormKind::ellipse;
    draft.ellipse = Ellipse{{20, 15}, {8, 6}, 0};
    draft.name = "  Élan vital, No. 7 ";
    draft.tags = "bone, warm ink ,, bone";
    draft.credit = "E. Haeckel";
    const StyleCard card = cardOf(draft, "2026-01-31");
    EXPECT_EQ(card.name, "Élan vital, No. 7");
    EXPECT_EQ(card.id, "elan-vital-no-7");
    EXPECT_EQ(card.tags, (std::vector<std::string>{"bone", "warm ink"}));
    EXPECT_EQ(card.origin, "plate.png, ellipse 16 x 12 pixels at (20, 15), 2026-01-31");
    EXPECT_EQ(card.credit, "E. Haeckel");
    draft.name = "骨";
    EXPECT_EQ(cardOf(draft, "2026-01-31").id, "style") << "no letter of it can be in an id";
}

TEST(ExtractionDraft, TheNextNameCounts) {
    EXPECT_EQ(nextName("Bone"), "Bone 2");
    EXPECT_EQ(nextName("Bone 2"), "Bone 3");
    EXPECT_EQ(nextName("Bone 99"), "Bone 100");
    EXPECT_EQ(nextName("Plate85"), "Plate85 2");
    EXPECT_EQ(nextName("7"), "7 2");
    EXPECT_EQ(nextName("Scan 20260131123456"), "Scan 20260131123456 2") << "that is no count";
}

TEST(DraftEdits, AStrokeIsRoundAndSoftAtItsEdge) {
    const PlatePtr plate = testing::twoColours(60, 40);
    const MaskPtr mask = withStroke(blankMask(*plate), {{20, 20}, {40, 20}, 5, false});
    EXPECT_EQ(mask->values[mask->offset(30, 20)], 255);
    EXPECT_TRUE(mask->has(15, 19));
    EXPECT_FALSE(mask->has(13, 20));
    EXPECT_FALSE(mask->has(30, 26));
    const MaskPtr erased = withStroke(*mask, {{30, 20}, {30, 20}, 2, true});
    EXPECT_FALSE(erased->has(30, 20));
    EXPECT_TRUE(erased->has(25, 20));
    const MaskPtr beside = withStroke(blankMask(*plate), {{-50, -50}, {-40, 500}, 5, false});
    EXPECT_FALSE(marksAnything(*beside));
}

TEST(DraftEdits, ACutsMaskLandsWhereTheCutIs) {
    const PlatePtr plate = testing::twoColours(60, 40);
    ArtCut cut;
    cut.origin = {20, 10};
    cut.scale = 2;
    Mask overCut;
    overCut.width = 10;
    overCut.height = 10;
    overCut.values.assign(100, 0);
    overCut.values[overCut.offset(3, 4)] = 255;
    const MaskPtr mask = withCutMarked(*plate, blankMask(*plate), cut, overCut);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x)
            EXPECT_EQ(mask->has(x, y), x >= 26 && x < 28 && y >= 18 && y < 20) << x << ", " << y;
}

TEST(DraftEdits, TheMiddleOfAPathIsAtHalfItsLength) {
    const PathMiddle middle = middleOf({{0, 0}, {10, 0}, {10, 30}});
    EXPECT_EQ(middle.place, glm::dvec2(10, 10));
    EXPECT_EQ(middle.direction, glm::dvec2(0, 1));
    EXPECT_EQ(middleOf({{3, 4}}).place, glm::dvec2(3, 4));
}

} // namespace
} // namespace limner
