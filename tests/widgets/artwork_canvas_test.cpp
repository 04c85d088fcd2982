#include "widgets/artwork_canvas.h"

#include "widgets/art_plate.h"
#include "widgets/artwork_painting.h"
#include "widgets/draft_edits.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

namespace limner {
namespace {

/// A plate of 400 x 300 pixels, one to one on the screen, so that places and mouse positions are whole numbers.
struct Shown {
    explicit Shown(ToolKind tool, PlatePtr plate = testing::twoColours()) {
        canvas.resize(800, 600);
        QObject::connect(&canvas, &ArtworkCanvas::edited, [this](const DraftEdit& edit) {
            edits.push_back(edit);
            history.apply(edit);
            show();
        });
        ExtractionDraft draft;
        draft.plate = std::move(plate);
        history.apply({draft, "Open", {}, false});
        show();
        canvas.setTool(tool);
        canvas.show();
        canvas.activateWindow();
        QTest::qWait(0);
        canvas.showPixels();
        canvas.setFocus();
    }
    void show() { canvas.setDraft(history.current()); }
    [[nodiscard]] const ExtractionDraft& draft() const { return history.current(); }
    [[nodiscard]] QPoint at(double x, double y) const { return canvas.view().toWidget({x, y}).toPoint(); }
    void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
        const Qt::MouseButtons down = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button);
        QMouseEvent event(type, at, canvas.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button, down,
                          modifiers);
        QApplication::sendEvent(&canvas, &event);
    }
    /// Through all places of the artwork, the button held.
    void drag(const ArtPath& places, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::LeftButton) {
        std::vector<QPointF> positions;
        for (const glm::dvec2& place : places)
            positions.emplace_back(at(place.x, place.y));
        mouse(QEvent::MouseButtonPress, positions.front(), button, modifiers);
        for (std::size_t i = 1; i < positions.size(); ++i)
            for (int part = 1; part <= 4; ++part)
                mouse(QEvent::MouseMove, positions[i - 1] + (positions[i] - positions[i - 1]) * part / 4, button,
                      modifiers);
        mouse(QEvent::MouseButtonRelease, positions.back(), button, modifiers);
    }
    void click(double x, double y, Qt::KeyboardModifiers modifiers = {}) { drag({{x, y}}, modifiers); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&canvas, key, modifiers); }
    void setRegion(const ArtPath& outline) {
        ExtractionDraft changed = draft();
        changed.form = FormKind::region;
        changed.region = withEnclosed(blankMask(*changed.plate), outline, false);
        history.apply({changed, "Outline", {}, false});
        show();
        edits.clear();
    }
    /// How many steps, at least one, are taken back until the draft is that again.
    [[nodiscard]] int stepsBack(const ExtractionDraft& to) {
        int steps = 0;
        do
            ++steps;
        while (history.undo() && !(draft() == to));
        show();
        return steps;
    }

    DraftHistory history;
    std::vector<DraftEdit> edits;
    ArtworkCanvas canvas;
};

const ArtPath kSquare{{50, 50}, {150, 50}, {150, 150}, {50, 150}};

TEST(ArtworkCanvas, DrawsACircleFromItsCentreInOneStep) {
    Shown shown(ToolKind::circle);
    const ExtractionDraft before = shown.draft();
    shown.drag({{100, 80}, {130, 120}});
    ASSERT_TRUE(shown.draft().ellipse);
    EXPECT_EQ(shown.draft().form, FormKind::ellipse);
    EXPECT_EQ(*shown.draft().ellipse, (Ellipse{{100, 80}, {50, 50}, 0}));
    EXPECT_TRUE(shown.edits.front().ongoing);
    EXPECT_FALSE(shown.edits.back().ongoing);
    EXPECT_EQ(shown.stepsBack(before), 1);
}

TEST(ArtworkCanvas, DrawsACircleFromEdgeToEdge) {
    Shown shown(ToolKind::circle);
    shown.drag({{60, 100}, {160, 100}}, Qt::AltModifier);
    EXPECT_EQ(*shown.draft().ellipse, (Ellipse{{110, 100}, {50, 50}, 0}));
    ToolOptions options;
    options.fromCentre = false;
    shown.canvas.setOptions(options);
    shown.drag({{200, 100}, {200, 180}});
    EXPECT_EQ(*shown.draft().ellipse, (Ellipse{{200, 140}, {40, 40}, 0}));
}

TEST(ArtworkCanvas, DrawsAnEllipseInABox) {
    Shown shown(ToolKind::ellipse);
    shown.drag({{50, 40}, {150, 120}}, Qt::AltModifier);
    EXPECT_EQ(*shown.draft().ellipse, (Ellipse{{100, 80}, {50, 40}, 0}));
    shown.drag({{300, 200}, {330, 240}}, Qt::ShiftModifier);
    EXPECT_EQ(*shown.draft().ellipse, (Ellipse{{300, 200}, {50, 50}, 0})) << "Shift draws a circle";
}

TEST(ArtworkCanvas, HandlesMoveResizeAndTurnAnEllipse) {
    Shown shown(ToolKind::ellipse);
    shown.drag({{100, 80}, {160, 120}});
    const Ellipse drawn{{100, 80}, {60, 40}, 0};
    ASSERT_EQ(*shown.draft().ellipse, drawn);
    const ExtractionDraft before = shown.draft();
    shown.drag({{100, 80}, {120, 90}});
    EXPECT_EQ(*shown.draft().ellipse, (Ellipse{{120, 90}, {60, 40}, 0}));
    shown.drag({{180, 90}, {200, 95}});
    EXPECT_EQ(*shown.draft().ellipse, (Ellipse{{120, 90}, {80, 40}, 0})) << "the first axis alone";
    shown.drag({{120, 50}, {120, 60}});
    EXPECT_EQ(*shown.draft().ellipse, (Ellipse{{120, 90}, {80, 30}, 0})) << "the second, by its other end";
    EXPECT_EQ(shown.stepsBack(before), 3);
    const glm::dvec2 knob = handlePlace(drawn, EllipseHandle::turn, kTurnKnob);
    shown.drag({knob, {100, 180}});
    EXPECT_NEAR(shown.draft().ellipse->degrees, 90, 1e-9) << "clockwise as seen";
    EXPECT_EQ(shown.draft().ellipse->semiAxes, drawn.semiAxes);
}

TEST(ArtworkCanvas, ACircleStaysOneByItsHandles) {
    Shown shown(ToolKind::circle);
    shown.drag({{100, 80}, {100, 120}});
    shown.drag({{140, 80}, {160, 80}});
    EXPECT_EQ(*shown.draft().ellipse, (Ellipse{{100, 80}, {60, 60}, 0}));
}

TEST(ArtworkCanvas, APressOnAHandleAloneChangesNothing) {
    Shown shown(ToolKind::circle);
    shown.drag({{100, 80}, {130, 120}});
    shown.edits.clear();
    shown.click(102, 81);
    EXPECT_TRUE(shown.edits.empty());
}

TEST(ArtworkCanvas, AClickTakesTheSmallestProposalAround) {
    Shown shown(ToolKind::circle);
    const Ellipse large{{200, 150}, {90, 80}, 10};
    const Ellipse small{{210, 150}, {20, 18}, 0};
    shown.canvas.setRoundThings({{large, 0.9}, {small, 0.8}});
    shown.click(212, 151);
    EXPECT_EQ(*shown.draft().ellipse, small);
    shown.click(140, 150);
    EXPECT_EQ(*shown.draft().ellipse, large);
    shown.edits.clear();
    shown.click(20, 20);
    EXPECT_TRUE(shown.edits.empty()) << "there is nothing to take there";
}

TEST(ArtworkCanvas, ArrowKeysMoveTheOutlineAndDeleteRemovesIt) {
    Shown shown(ToolKind::circle);
    shown.drag({{100, 80}, {130, 120}});
    const ExtractionDraft before = shown.draft();
    shown.key(Qt::Key_Right);
    shown.key(Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(shown.draft().ellipse->centre, glm::dvec2(101, 90));
    EXPECT_EQ(shown.stepsBack(before), 1) << "a run of key presses is one step";
    shown.key(Qt::Key_Delete);
    EXPECT_EQ(shown.draft().form, FormKind::none);
}

TEST(ArtworkCanvas, ALassoTakesWhatItEnclosesAltTakesAwayShiftAdds) {
    Shown shown(ToolKind::region);
    ToolOptions options;
    options.findEdge = false;
    shown.canvas.setOptions(options);
    ArtPath closed = kSquare;
    closed.push_back(kSquare.front());
    shown.drag(closed);
    ASSERT_TRUE(shown.draft().region);
    const auto has = [&](int x, int y) { return shown.draft().region->has(x, y); };
    EXPECT_TRUE(has(51, 51));
    EXPECT_TRUE(has(148, 148));
    EXPECT_FALSE(has(48, 100));
    EXPECT_FALSE(has(152, 100));
    shown.drag({{90, 90}, {110, 90}, {110, 110}, {90, 110}, {90, 90}}, Qt::AltModifier);
    EXPECT_FALSE(has(100, 100));
    EXPECT_TRUE(has(80, 100));
    shown.drag({{250, 50}, {300, 50}, {300, 100}, {250, 100}, {250, 50}}, Qt::ShiftModifier);
    EXPECT_TRUE(has(275, 75));
    EXPECT_TRUE(has(80, 100));
    shown.drag({{250, 150}, {300, 150}, {300, 200}, {250, 200}, {250, 150}});
    EXPECT_FALSE(has(80, 100)) << "a new form";
    EXPECT_TRUE(has(275, 175));
}

TEST(ArtworkCanvas, ALassoThatFindsTheEdgeIsAskedFor) {
    Shown shown(ToolKind::region);
    std::vector<std::pair<ArtPath, OutlineMode>> drawn;
    QObject::connect(&shown.canvas, &ArtworkCanvas::outlineDrawn,
                     [&](const ArtPath& outline, OutlineMode mode) { drawn.emplace_back(outline, mode); });
    shown.drag(kSquare, Qt::ShiftModifier);
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(drawn[0].second, OutlineMode::add);
    EXPECT_EQ(drawn[0].first.front(), kSquare.front());
    EXPECT_EQ(drawn[0].first.back(), kSquare.back());
    EXPECT_TRUE(shown.edits.empty());
    shown.drag({{10, 10}, {12, 12}});
    EXPECT_EQ(drawn.size(), 1U) << "a slip of the hand encloses nothing";
}

TEST(ArtworkCanvas, TheBrushPaintsAndErasesInOneStepEach) {
    Shown shown(ToolKind::brush);
    ToolOptions options;
    options.brushRadius = 10;
    shown.canvas.setOptions(options);
    shown.drag({{50, 100}, {150, 100}});
    const ExtractionDraft painted = shown.draft();
    ASSERT_TRUE(painted.region);
    EXPECT_TRUE(painted.region->has(100, 92));
    EXPECT_TRUE(painted.region->has(41, 100));
    EXPECT_FALSE(painted.region->has(100, 88));
    shown.drag({{100, 100}, {100, 101}}, Qt::AltModifier);
    EXPECT_FALSE(shown.draft().region->has(100, 100));
    EXPECT_TRUE(shown.draft().region->has(60, 100));
    EXPECT_EQ(shown.stepsBack(painted), 1);
    shown.drag({{20, 100}, {180, 100}}, Qt::AltModifier);
    EXPECT_EQ(shown.draft().form, FormKind::none) << "all of it is erased";
    EXPECT_FALSE(shown.draft().region);
}

TEST(ArtworkCanvas, TheIgnoreBrushLeavesTheFormAlone) {
    Shown shown(ToolKind::ignore);
    shown.setRegion(kSquare);
    const MaskPtr region = shown.draft().region;
    shown.click(100, 100);
    ASSERT_TRUE(shown.draft().ignored);
    EXPECT_TRUE(shown.draft().ignored->has(100, 100));
    EXPECT_EQ(shown.draft().region, region);
    shown.key(Qt::Key_Delete);
    EXPECT_FALSE(shown.draft().ignored);
}

TEST(ArtworkCanvas, ANormalIsSetTurnedMovedAndRemoved) {
    Shown shown(ToolKind::normal);
    shown.click(100, 100);
    EXPECT_TRUE(shown.edits.empty()) << "there is no form yet";
    shown.setRegion(kSquare);
    const ExtractionDraft before = shown.draft();
    shown.drag({{100, 100}, {100 + kNeedle / 2, 100}});
    ASSERT_EQ(shown.draft().marks.normals.size(), 1U);
    EXPECT_EQ(shown.draft().marks.normals[0], (NormalMark{{100, 100}, {0.5, 0}}));
    EXPECT_EQ(shown.stepsBack(before), 1) << "set and turned at once";
    shown.history.redo();
    shown.show();
    shown.drag({{100 + kNeedle / 2, 100}, {100, 100 - kNeedle / 2}});
    EXPECT_EQ(shown.draft().marks.normals[0].normal, glm::dvec2(0, 0.5)) << "up";
    shown.drag({{100, 100 - kNeedle / 2}, {100, 180}});
    EXPECT_EQ(shown.draft().marks.normals[0].normal, glm::dvec2(0, -1)) << "no normal is longer than one";
    shown.drag({{100, 100}, {120, 90}}, Qt::ControlModifier);
    EXPECT_EQ(shown.draft().marks.normals[0], (NormalMark{{120, 90}, {0, -1}}));
    shown.key(Qt::Key_Left);
    EXPECT_EQ(shown.draft().marks.normals[0].at, glm::dvec2(119, 90));
    shown.key(Qt::Key_Delete);
    EXPECT_TRUE(shown.draft().marks.normals.empty());
    EXPECT_EQ(shown.stepsBack(before), 6);
}

TEST(ArtworkCanvas, ACreaseIsDrawnByItsCornersAndTilted) {
    Shown shown(ToolKind::crease);
    shown.setRegion(kSquare);
    const ExtractionDraft before = shown.draft();
    shown.click(60, 100);
    shown.click(100, 100);
    shown.click(140, 100);
    EXPECT_TRUE(shown.edits.empty()) << "it has not ended";
    shown.key(Qt::Key_Return);
    ASSERT_EQ(shown.draft().marks.creases.size(), 1U);
    EXPECT_EQ(shown.draft().marks.creases[0].path, (ArtPath{{60, 100}, {100, 100}, {140, 100}}));
    const double tilt = shown.draft().marks.creases[0].tiltDegrees;
    const QPointF middle(shown.at(100, 100));
    const QPointF handle = tiltHandle(middle, {1, 0}, tilt);
    EXPECT_LT(handle.y(), middle.y()) << "a ridge's handle stands above it";
    const glm::dvec2 from = shown.canvas.view().toArtwork(handle);
    shown.drag({from, {100, 100 + kTiltReach / 2}});
    EXPECT_EQ(shown.draft().marks.creases[0].tiltDegrees, -45) << "a valley";
    EXPECT_EQ(shown.stepsBack(before), 2);
}

TEST(ArtworkCanvas, ACreaseCanBeGivenUpAndRemoved) {
    Shown shown(ToolKind::crease);
    shown.setRegion(kSquare);
    shown.click(60, 100);
    shown.click(100, 100);
    shown.key(Qt::Key_Escape);
    shown.key(Qt::Key_Return);
    EXPECT_TRUE(shown.edits.empty());
    shown.click(60, 100);
    shown.click(100, 60);
    shown.key(Qt::Key_Backspace);
    shown.click(140, 100);
    shown.key(Qt::Key_Return);
    ASSERT_EQ(shown.draft().marks.creases.size(), 1U);
    EXPECT_EQ(shown.draft().marks.creases[0].path, (ArtPath{{60, 100}, {140, 100}}));
    shown.drag({{140, 100}, {140, 120}});
    EXPECT_EQ(shown.draft().marks.creases[0].path.back(), glm::dvec2(140, 120));
    shown.key(Qt::Key_Delete);
    EXPECT_TRUE(shown.draft().marks.creases.empty());
}

TEST(ArtworkCanvas, AnOpenOutlineIsAStrokeThatAClickFindsAgain) {
    Shown shown(ToolKind::open);
    shown.setRegion(kSquare);
    shown.drag({{50, 60}, {50, 140}});
    ASSERT_EQ(shown.draft().marks.open.size(), 1U);
    EXPECT_EQ(shown.draft().marks.open[0].front(), glm::dvec2(50, 60));
    EXPECT_EQ(shown.draft().marks.open[0].back(), glm::dvec2(50, 140));
    shown.key(Qt::Key_Escape);
    shown.key(Qt::Key_Delete);
    EXPECT_EQ(shown.draft().marks.open.size(), 1U) << "none is chosen";
    shown.click(51, 100);
    shown.key(Qt::Key_Delete);
    EXPECT_TRUE(shown.draft().marks.open.empty());
}

TEST(ArtworkCanvas, ThePickerTakesColoursOneAfterTheOther) {
    Shown shown(ToolKind::picker);
    shown.click(100, 100);
    const auto& light = shown.draft().swatches.of(SwatchRole::light);
    ASSERT_TRUE(light);
    EXPECT_NEAR(light->colour.r, 0.8, 0.005);
    EXPECT_EQ(light->at, glm::dvec2(100, 100));
    EXPECT_EQ(shown.canvas.options().role, SwatchRole::shadow) << "what no sphere can do without comes next";
    EXPECT_FALSE(canExtract(shown.draft()));
    shown.click(300, 100);
    EXPECT_NEAR(shown.draft().swatches.of(SwatchRole::shadow)->colour.b, 0.8, 0.005);
    EXPECT_TRUE(canExtract(shown.draft()));
    EXPECT_EQ(shown.canvas.options().role, SwatchRole::mid);
    shown.edits.clear();
    shown.click(-30, 100);
    EXPECT_TRUE(shown.edits.empty()) << "there is no colour beside the artwork";
}

TEST(ArtworkCanvas, TheWheelKeepsWhatIsUnderThePointer) {
    Shown shown(ToolKind::circle);
    const QPointF held(shown.at(60, 200));
    for (const int clicks : {1, 3, -2, -1}) {
        const glm::dvec2 before = shown.canvas.view().toArtwork(held);
        const double scale = shown.canvas.view().scale();
        QWheelEvent event(held, shown.canvas.mapToGlobal(held), {}, {0, 120 * clicks}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&shown.canvas, &event);
        const glm::dvec2 after = shown.canvas.view().toArtwork(held);
        EXPECT_NEAR(glm::distance(after, before), 0, 1e-9) << clicks;
        EXPECT_EQ(shown.canvas.view().scale() > scale, clicks > 0);
    }
    EXPECT_TRUE(shown.edits.empty());
}

TEST(ArtworkCanvas, TheMiddleButtonAndSpaceMoveTheArtwork) {
    Shown shown(ToolKind::circle);
    const QPoint before = shown.at(100, 100);
    shown.drag({{100, 100}, {140, 120}}, {}, Qt::MiddleButton);
    EXPECT_EQ(shown.at(100, 100), before + QPoint(40, 20));
    QTest::keyPress(&shown.canvas, Qt::Key_Space);
    const glm::dvec2 from = shown.canvas.view().toArtwork(before);
    const QPoint target = before - QPoint(30, 0);
    const glm::dvec2 to = shown.canvas.view().toArtwork(target);
    shown.drag({from, to});
    QTest::keyRelease(&shown.canvas, Qt::Key_Space);
    EXPECT_TRUE(shown.edits.empty());
    EXPECT_FALSE(shown.canvas.view().fits());
    shown.canvas.fit();
    EXPECT_TRUE(shown.canvas.view().fits());
    EXPECT_TRUE(QRectF(shown.canvas.rect()).contains(shown.canvas.view().sheet()));
}

TEST(ArtworkCanvas, AsksForASharperPartOfALargeScan) {
    const PlatePtr large = testing::twoColours(2 * Artwork::kReducedSide, 64);
    ASSERT_EQ(large->reduction(), 2);
    Shown shown(ToolKind::circle, large);
    ArtRect part;
    int longest = 0;
    QObject::connect(&shown.canvas, &ArtworkCanvas::sharperWanted, [&](const ArtRect& wanted, int pixels) {
        part = wanted;
        longest = pixels;
    });
    shown.canvas.showPixels();
    ASSERT_TRUE(QTest::qWaitFor([&] { return longest > 0; }));
    EXPECT_EQ(longest, 800) << "one for each of the screen's pixels";
    EXPECT_EQ(part, (ArtRect{2048 - 400, 0, 800, 64}));
}

TEST(ArtworkCanvas, ABorderRunsAlongThePixelsSides) {
    Mask mask;
    mask.width = 4;
    mask.height = 3;
    mask.values = {0,   0,   0,   0, //
                   0,   255, 255, 0, //
                   255, 0,   0,   0};
    QVector<QLineF> lines = borderOf(mask);
    double length = 0;
    for (const QLineF& line : lines)
        length += line.length();
    EXPECT_EQ(length, 6 + 4);
    EXPECT_TRUE(lines.contains(QLineF(1, 1, 3, 1))) << "one line for two pixels";
    EXPECT_TRUE(lines.contains(QLineF(0, 2, 0, 3))) << "along the mask's own edge";
    EXPECT_TRUE(lines.contains(QLineF(0, 3, 1, 3)));
}

TEST(ArtworkCanvas, KeysChangeTheBrush) {
    Shown shown(ToolKind::brush);
    const double radius = shown.canvas.options().brushRadius;
    shown.key(Qt::Key_BracketRight);
    EXPECT_GT(shown.canvas.options().brushRadius, radius);
    shown.key(Qt::Key_BracketLeft);
    EXPECT_NEAR(shown.canvas.options().brushRadius, radius, 1e-9);
}

} // namespace
} // namespace limner
