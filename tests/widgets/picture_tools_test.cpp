// The tools over the picture that give clean-up steps.
#include "widgets/island_overlay.h"
#include "widgets/scissors_overlay.h"

#include "core/volume/cleanup.h"
#include "renderer/plan/planner.h"
#include "widgets/test_figure.h"
#include "widgets/viewport.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>

#include <cmath>
#include <numbers>

namespace limner {
namespace {

/// A figure twice as wide as high, under a tool.
template <typename Tool>
struct Shown {
    Shown() {
        Figure figure = testing::smallFigure();
        figure.output.widthMm = 200;
        figure.output.heightMm = 100;
        history = History(figure);
        viewport.resize(836, 436); // the sheet is 800 x 400
        show();
        const auto apply = [this](const Edit& edit) {
            history.apply(edit);
            show();
        };
        QObject::connect(&tool, &ToolOverlay::edited, apply);
        QObject::connect(&viewport, &Viewport::edited, apply);
        viewport.show();
        viewport.activateWindow();
        QTest::qWait(0);
        tool.take();
    }
    void show() {
        viewport.setFigure(history.current());
        tool.setFigure(history.current());
    }
    void showPicture() {
        Planner planner;
        Task task;
        PlanRequest request;
        request.size = {200, 100}; // a draft: coarser than the sheet
        ScreenPicture picture;
        picture.plan = planner.plan(*history.current(), request, task);
        picture.image = QImage(200, 100, QImage::Format_RGB32);
        picture.image.fill(Qt::white);
        viewport.setPicture(picture);
    }
    [[nodiscard]] QPoint at(double x, double y) const {
        const QRectF sheet = viewport.sheet();
        return QPointF(sheet.left() + x * sheet.width(), sheet.top() + y * sheet.height()).toPoint();
    }
    void move(QPoint to, Qt::MouseButtons buttons = Qt::NoButton) {
        QMouseEvent event(QEvent::MouseMove, QPointF(to), tool.mapToGlobal(QPointF(to)), Qt::NoButton, buttons, {});
        QApplication::sendEvent(&tool, &event);
    }
    void click(double x, double y) { QTest::mouseClick(&tool, Qt::LeftButton, {}, at(x, y)); }
    [[nodiscard]] const std::vector<CleanupStep>& steps() const { return history.current()->cleanup; }

    Viewport viewport;
    Tool tool{&viewport};
    History history;
};

using Scissors = Shown<ScissorsOverlay>;

TEST(ScissorsOverlay, ClickedCornersAndEnterCut) {
    Scissors shown;
    const Camera camera = shown.history.current()->camera;
    shown.click(0.5, 0.1);
    shown.click(0.9, 0.1);
    shown.click(0.9, 0.9);
    shown.click(0.5, 0.9);
    EXPECT_EQ(shown.tool.outline().size(), 4U);
    EXPECT_TRUE(shown.steps().empty());
    QTest::keyClick(&shown.tool, Qt::Key_Return);
    ASSERT_EQ(shown.steps().size(), 1U);
    const CleanupStep& step = shown.steps()[0];
    EXPECT_EQ(step.kind, CleanupKind::scissors);
    EXPECT_EQ(step.side, ScissorsSide::inside);
    EXPECT_EQ(step.camera, camera);
    EXPECT_EQ(step.aspect, 2);
    ASSERT_EQ(step.polygon.size(), 4U);
    EXPECT_NEAR(step.polygon[1].x, 0.9, 0.002);
    EXPECT_NEAR(step.polygon[1].y, 0.1, 0.002);
    EXPECT_FALSE(shown.tool.taken());
    // It is the right half of the picture that goes, and the figure's camera looks along y with x to the right.
    Task task;
    const auto& volume = shown.history.current()->volume->data;
    const auto cut = applyCleanup(volume, nullptr, shown.steps(), 2, task);
    EXPECT_EQ(cut->valueAt({18, 15, 15}), -1000);
    EXPECT_EQ(cut->valueAt({13, 15, 15}), volume->valueAt({13, 15, 15}));
    shown.history.undo();
    EXPECT_TRUE(shown.steps().empty());
}

TEST(ScissorsOverlay, AFreehandStrokeCutsWhenItIsLetGo) {
    Scissors shown;
    const auto onCircle = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / 40;
        return shown.at(0.5 + 0.1 * std::cos(angle), 0.5 + 0.2 * std::sin(angle));
    };
    QTest::mousePress(&shown.tool, Qt::LeftButton, {}, onCircle(0));
    for (int i = 1; i < 40; ++i)
        shown.move(onCircle(i), Qt::LeftButton);
    EXPECT_TRUE(shown.steps().empty());
    QTest::mouseRelease(&shown.tool, Qt::LeftButton, {}, onCircle(39));
    ASSERT_EQ(shown.steps().size(), 1U);
    EXPECT_EQ(shown.steps()[0].polygon.size(), 40U);
    EXPECT_EQ(shown.history.position(), 1U);
}

TEST(ScissorsOverlay, ADoubleClickCloses) {
    Scissors shown;
    shown.click(0.2, 0.2);
    shown.click(0.8, 0.2);
    shown.click(0.5, 0.8); // a double click is a click and then another
    QTest::mouseDClick(&shown.tool, Qt::LeftButton, {}, shown.at(0.5, 0.8));
    ASSERT_EQ(shown.steps().size(), 1U);
    EXPECT_EQ(shown.steps()[0].polygon.size(), 3U);
}

TEST(ScissorsOverlay, TheOtherSide) {
    Scissors shown;
    QTest::keyClick(&shown.tool, Qt::Key_I);
    for (const auto& [x, y] : {std::pair{0.2, 0.2}, {0.8, 0.2}, {0.5, 0.8}})
        shown.click(x, y);
    QTest::keyClick(&shown.tool, Qt::Key_Enter);
    ASSERT_EQ(shown.steps().size(), 1U);
    EXPECT_EQ(shown.steps()[0].side, ScissorsSide::outside);
}

TEST(ScissorsOverlay, EscapeLaysThemDownAndBackspaceTakesACornerBack) {
    Scissors shown;
    shown.click(0.2, 0.2);
    shown.click(0.8, 0.2);
    QTest::keyClick(&shown.tool, Qt::Key_Backspace);
    EXPECT_EQ(shown.tool.outline().size(), 1U);
    QTest::keyClick(&shown.tool, Qt::Key_Escape);
    EXPECT_FALSE(shown.tool.taken());
    EXPECT_TRUE(shown.steps().empty());
    shown.tool.take();
    EXPECT_TRUE(shown.tool.outline().empty()) << "a new outline each time";
}

TEST(ScissorsOverlay, AnOutlineOfNothingIsGivenUp) {
    Scissors shown;
    shown.click(0.2, 0.2);
    shown.click(0.8, 0.2);
    QTest::keyClick(&shown.tool, Qt::Key_Return);
    EXPECT_TRUE(shown.steps().empty());
    EXPECT_TRUE(shown.tool.taken());
    EXPECT_TRUE(shown.tool.outline().empty());
}

TEST(ScissorsOverlay, TheViewTurnsOnlyWithoutAnOutline) {
    Scissors shown;
    const Camera before = shown.history.current()->camera;
    QTest::keyClick(&shown.tool, Qt::Key_Right);
    EXPECT_NE(shown.history.current()->camera, before);
    const Camera turned = shown.history.current()->camera;
    shown.click(0.2, 0.2);
    QTest::keyClick(&shown.tool, Qt::Key_Right);
    EXPECT_EQ(shown.history.current()->camera, turned);
    EXPECT_EQ(shown.tool.outline().size(), 1U);
    shown.history.undo(); // by the menu
    shown.show();
    EXPECT_TRUE(shown.tool.outline().empty()) << "it was about another picture";
}

TEST(IslandOverlay, AClickKeepsWhatIsSeenThere) {
    Shown<IslandOverlay> shown;
    shown.click(0.5, 0.5);
    EXPECT_TRUE(shown.steps().empty()) << "there is no picture to click on";
    shown.showPicture();
    shown.click(0.02, 0.5);
    EXPECT_TRUE(shown.steps().empty()) << "paper";
    EXPECT_TRUE(shown.tool.taken());
    shown.click(0.5, 0.5);
    ASSERT_EQ(shown.steps().size(), 1U);
    const CleanupStep& step = shown.steps()[0];
    EXPECT_EQ(step.kind, CleanupKind::keepAt);
    ASSERT_TRUE(step.atMm);
    // The bone core: 6 voxels of 2 mm about the middle at 31 mm.
    EXPECT_NEAR(step.atMm->x, 31, 0.3);
    EXPECT_NEAR(step.atMm->z, 31, 0.3);
    EXPECT_NEAR(step.atMm->y, 31 - 12, 2.5);
    EXPECT_EQ(step.above, -170) << "the least that the skin shows: what hangs together by skin stays";
    EXPECT_FALSE(shown.tool.taken());
    Task task;
    const auto kept = applyCleanup(shown.history.current()->volume->data, nullptr, shown.steps(), 2, task);
    EXPECT_EQ(kept->valueAt({15, 15, 15}), 1000);
}

} // namespace
} // namespace limner
