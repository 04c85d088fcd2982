#include "widgets/lens_overlay.h"

#include "widgets/lens_place.h"
#include "widgets/test_figure.h"
#include "widgets/viewport.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>

namespace limner {
namespace {

/// A figure twice as wide as high, with a lens in the middle.
struct Shown {
    explicit Shown(const Lens& lens = {}) {
        Figure figure = testing::smallFigure();
        figure.output.widthMm = 200;
        figure.output.heightMm = 100;
        figure.importance = Importance{};
        figure.importance->lenses = {lens};
        history = History(figure);
        viewport.resize(800, 500);
        show();
        const auto apply = [this](const Edit& edit) {
            edits.push_back(edit);
            history.apply(edit);
            show();
        };
        QObject::connect(&overlay, &LensOverlay::edited, apply);
        QObject::connect(&viewport, &Viewport::edited, apply);
        viewport.show();
        viewport.activateWindow();
        QTest::qWait(0);
    }
    void show() {
        viewport.setFigure(history.current());
        overlay.setFigure(history.current(), 0);
    }
    void drag(QPointF from, QPoint by) {
        QTest::mousePress(&overlay, Qt::LeftButton, {}, from.toPoint());
        for (int i = 1; i <= 4; ++i) {
            const QPointF at(from.toPoint() + by * i / 4);
            QMouseEvent move(QEvent::MouseMove, at, overlay.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(&overlay, &move);
        }
        QTest::mouseRelease(&overlay, Qt::LeftButton, {}, from.toPoint() + by);
    }
    [[nodiscard]] const Lens& lens() const { return history.current()->importance->lenses.at(0); }
    [[nodiscard]] QRectF sheet() const { return viewport.sheet(); }

    Viewport viewport;
    LensOverlay overlay{&viewport};
    History history;
    std::vector<Edit> edits;
};

TEST(LensOverlay, DraggingTheMiddleMovesInOneStep) {
    Shown shown;
    EXPECT_EQ(shown.overlay.middle(), shown.sheet().center());
    shown.drag(*shown.overlay.middle(), {80, -40});
    EXPECT_NEAR(shown.lens().center.x, 0.5 + 80 / shown.sheet().width(), 0.002); // the sheet has whole pixels
    EXPECT_NEAR(shown.lens().center.y, 0.5 - 40 / shown.sheet().height(), 1e-9);
    EXPECT_EQ(shown.lens().radius, Lens{}.radius);
    EXPECT_EQ(shown.history.position(), 1U);
    EXPECT_TRUE(shown.edits.front().ongoing);
    EXPECT_FALSE(shown.edits.back().ongoing);
    shown.history.undo();
    EXPECT_EQ(shown.lens(), Lens{});
}

TEST(LensOverlay, DraggingTheEdgeResizesInOneStep) {
    for (const char* shape : {"circle", "ellipse", "box"}) {
        SCOPED_TRACE(shape);
        Lens lens;
        lens.shape = shape;
        lens.aspect = std::string(shape) == "circle" ? 1 : 1.5;
        Shown shown(lens);
        const QPointF edge = *shown.overlay.edge();
        EXPECT_NEAR(edge.x() - shown.sheet().center().x(), lens.radius * lens.aspect * shown.sheet().height(), 1e-6);
        shown.drag(edge, {30, 0});
        EXPECT_NEAR(shown.lens().radius, lens.radius + 30 / shown.sheet().height() / lens.aspect, 1e-9);
        EXPECT_EQ(shown.lens().center, lens.center);
        EXPECT_EQ(shown.history.position(), 1U);
    }
}

TEST(LensOverlay, KeysMoveResizeRemoveAndLeave) {
    Shown shown;
    QTest::keyClick(&shown.overlay, Qt::Key_Right);
    QTest::keyClick(&shown.overlay, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_NEAR(shown.lens().center.x, 0.5 + 0.011 / sheetAspect(*shown.history.current()), 1e-12);
    QTest::keyClick(&shown.overlay, Qt::Key_Up);
    EXPECT_NEAR(shown.lens().center.y, 0.49, 1e-12);
    EXPECT_EQ(shown.history.position(), 1U) << "presses that follow each other are one step";
    QTest::keyClick(&shown.overlay, Qt::Key_Plus);
    EXPECT_GT(shown.lens().radius, Lens{}.radius);
    QTest::keyClick(&shown.overlay, Qt::Key_Minus);
    EXPECT_NEAR(shown.lens().radius, Lens{}.radius, 1e-12);
    bool left = false;
    QObject::connect(&shown.overlay, &LensOverlay::left, [&] { left = true; });
    QTest::keyClick(&shown.overlay, Qt::Key_Escape);
    EXPECT_TRUE(left);
    QTest::keyClick(&shown.overlay, Qt::Key_Delete);
    EXPECT_TRUE(shown.history.current()->importance->lenses.empty());
    EXPECT_TRUE(shown.overlay.isHidden());
    shown.history.undo();
    shown.show();
    EXPECT_FALSE(shown.overlay.isHidden());
}

TEST(LensOverlay, ADragBesideTheHandlesTurnsTheView) {
    Shown shown;
    const Camera before = shown.history.current()->camera;
    shown.drag(*shown.overlay.middle() + QPointF(-30, 30), {60, 0});
    EXPECT_GT(glm::length(shown.history.current()->camera.direction - before.direction), 0.1);
    EXPECT_EQ(shown.lens(), Lens{});
}

TEST(LensOverlay, AnAnchoredLensFollowsTheScan) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        Figure figure = testing::smallFigure();
        figure.camera.projection = projection;
        Lens lens;
        lens.center = {0.7, 0.4};
        lens = lensFollowing(figure, lens, true);
        const glm::dvec2 before = *lensOnSheet(figure, lens);
        EXPECT_NEAR(before.x, 0.7 * sheetAspect(figure), 1e-12);
        EXPECT_NEAR(before.y, 0.4, 1e-12);
        figure.camera.heightMm *= 2; // everything moves half the way to the middle
        const glm::dvec2 after = *lensOnSheet(figure, lens);
        EXPECT_NEAR(after.y, 0.45, 1e-12);
        const Lens free = lensFollowing(figure, lens, false);
        EXPECT_FALSE(free.anchorMm);
        EXPECT_NEAR(free.center.x, 0.6, 1e-12) << "it stays where it is seen";
        figure.camera.heightMm /= 2;
        figure.camera.targetMm = *lens.anchorMm;
        EXPECT_NEAR(lensOnSheet(figure, lens)->y, 0.5, 1e-12);
    }
}

} // namespace
} // namespace limner
