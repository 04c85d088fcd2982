#include "widgets/viewport.h"

#include "widgets/test_figure.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

namespace limner {
namespace {

/// A viewport whose edits go straight into a history, as the window does it.
struct Shown {
    Shown() {
        viewport.resize(600, 500);
        show(testing::smallFigure());
        QObject::connect(&viewport, &Viewport::edited, [this](const Edit& edit) {
            edits.push_back(edit);
            history.apply(edit);
            viewport.setFigure(history.current());
        });
        viewport.show();
        QTest::qWait(0);
    }
    void show(const Figure& figure) {
        history = History(figure);
        viewport.setFigure(history.current());
    }
    [[nodiscard]] const Camera& camera() const { return history.current()->camera; }
    [[nodiscard]] QPoint middle() const { return viewport.sheet().center().toPoint(); }
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint by) {
        QTest::mousePress(&viewport, button, modifiers, middle());
        for (int i = 1; i <= 4; ++i) {
            QMouseEvent move(QEvent::MouseMove, QPointF(middle() + by * i / 4),
                             viewport.mapToGlobal(QPointF(middle() + by * i / 4)), Qt::NoButton, button, modifiers);
            QApplication::sendEvent(&viewport, &move);
        }
        QTest::mouseRelease(&viewport, button, modifiers, middle() + by);
    }
    Viewport viewport;
    History history;
    std::vector<Edit> edits;
};

TEST(Viewport, TheSheetHasTheFiguresProportions) {
    Shown shown;
    Figure figure = testing::smallFigure();
    figure.output.widthMm = 200;
    figure.output.heightMm = 100;
    shown.show(figure);
    const QRectF sheet = shown.viewport.sheet();
    EXPECT_NEAR(sheet.width() / sheet.height(), 2, 0.02); // whole pixels
    EXPECT_TRUE(QRectF(shown.viewport.rect()).contains(sheet));
    EXPECT_NEAR(sheet.center().x(), shown.viewport.rect().center().x(), 1.5);
}

TEST(Viewport, AClickThatMovesNothingIsToldAndNoEdit) {
    Shown shown;
    std::vector<QPointF> clicks;
    QObject::connect(&shown.viewport, &Viewport::clicked, [&](QPointF at) { clicks.push_back(at); });
    QTest::mouseClick(&shown.viewport, Qt::LeftButton, {}, shown.middle());
    ASSERT_EQ(clicks.size(), 1U);
    EXPECT_EQ(clicks[0], QPointF(shown.middle()));
    EXPECT_EQ(shown.history.position(), 0U);
    shown.drag(Qt::LeftButton, {}, {40, 0});
    QTest::mouseClick(&shown.viewport, Qt::LeftButton, {}, QPoint(1, 1));
    QTest::mouseClick(&shown.viewport, Qt::MiddleButton, {}, shown.middle());
    EXPECT_EQ(clicks.size(), 1U) << "neither a drag, nor the desk, nor another button";
}

TEST(Viewport, ADragTurnsInOneStep) {
    Shown shown;
    const Camera before = shown.camera();
    shown.drag(Qt::LeftButton, Qt::NoModifier, {80, 20});
    EXPECT_GT(glm::length(shown.camera().direction - before.direction), 0.1);
    EXPECT_EQ(shown.camera().targetMm, before.targetMm);
    EXPECT_EQ(shown.history.position(), 1U);
    EXPECT_TRUE(shown.edits.front().ongoing);
    EXPECT_FALSE(shown.edits.back().ongoing) << "the still is drawn at the end";
    shown.drag(Qt::LeftButton, Qt::NoModifier, {-30, 0});
    EXPECT_EQ(shown.history.position(), 2U) << "the next drag is the next step";
}

TEST(Viewport, MiddleAndShiftDragsMove) {
    for (const auto& [button, modifiers] : {std::pair{Qt::MiddleButton, Qt::KeyboardModifiers(Qt::NoModifier)},
                                            std::pair{Qt::LeftButton, Qt::KeyboardModifiers(Qt::ShiftModifier)}}) {
        Shown shown;
        const Camera before = shown.camera();
        shown.drag(button, modifiers, {60, 0});
        EXPECT_EQ(shown.camera().direction, before.direction);
        const double mm = 60 / shown.viewport.sheet().height() * before.heightMm;
        EXPECT_NEAR(glm::dot(shown.camera().targetMm - before.targetMm, cameraFrame(before).right), -mm, 1e-9);
        EXPECT_EQ(shown.history.position(), 1U);
    }
}

TEST(Viewport, TheWheelZoomsTowardsThePointer) {
    Shown shown;
    const Camera before = shown.camera();
    const QPointF at = shown.viewport.sheet().center() + QPointF(100, -50);
    for (int i = 0; i < 3; ++i) {
        QWheelEvent wheel(at, shown.viewport.mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&shown.viewport, &wheel);
    }
    EXPECT_LT(shown.camera().heightMm, before.heightMm * 0.7);
    const CameraFrame frame = cameraFrame(before);
    const double height = shown.viewport.sheet().height();
    const auto under = [&](const Camera& camera) {
        return camera.targetMm + (frame.right * 100.0 + frame.up * 50.0) / height * camera.heightMm;
    };
    EXPECT_NEAR(glm::length(under(shown.camera()) - under(before)), 0, 1e-6); // mm
    EXPECT_EQ(shown.history.position(), 1U) << "clicks that follow each other are one step";
    QTest::qWait(400);
    EXPECT_FALSE(shown.edits.back().ongoing) << "it settles";
}

TEST(Viewport, KeysTurnAndZoom) {
    Shown shown;
    const Camera before = shown.camera();
    QTest::keyClick(&shown.viewport, Qt::Key_Right);
    EXPECT_NEAR(glm::dot(shown.camera().direction, before.direction), std::cos(5 * 3.14159265358979 / 180), 1e-9);
    QTest::keyClick(&shown.viewport, Qt::Key_Plus);
    EXPECT_LT(shown.camera().heightMm, before.heightMm);
    QTest::keyClick(&shown.viewport, Qt::Key_Minus);
    EXPECT_NEAR(shown.camera().heightMm, before.heightMm, 1e-9);
}

TEST(Viewport, ADoubleClickFitsWhatIsVisible) {
    Shown shown;
    Figure figure = testing::smallFigure();
    figure.layers.pop_back(); // the bone core: a ball of 12 voxels' diameter
    figure.camera.targetMm += glm::dvec3(50, 20, -30);
    figure.camera.heightMm = 400;
    shown.show(figure);
    QTest::mouseDClick(&shown.viewport, Qt::LeftButton, {}, shown.middle());
    EXPECT_NEAR(glm::length(shown.camera().targetMm - figure.volume->data->grid().centreMm()), 0, 1);
    EXPECT_GT(shown.camera().heightMm, 22);
    EXPECT_LT(shown.camera().heightMm, 30);
}

TEST(Viewport, LettersBelongToTheShownPicture) {
    Shown shown;
    EXPECT_EQ(shown.viewport.letters(), (EdgeLetters{"R", "L", "S", "I"}));
    ScreenPicture picture;
    picture.image = QImage(10, 10, QImage::Format_RGBX8888);
    auto plan = std::make_shared<RenderPlan>();
    auto figure = std::make_shared<Figure>(testing::smallFigure());
    figure->camera.direction = {0, -1, 0};
    plan->figure = figure;
    picture.plan = plan;
    shown.viewport.setPicture(picture);
    EXPECT_EQ(shown.viewport.letters(), (EdgeLetters{"L", "R", "S", "I"}))
        << "the camera may have moved on; what is seen is this picture";
}

TEST(Viewport, DrawsThePictureAndTheLetters) {
    Shown shown;
    ScreenPicture picture;
    picture.image = QImage(shown.viewport.picturePixels(), QImage::Format_RGBX8888);
    picture.image.fill(QColor(10, 200, 30));
    auto plan = std::make_shared<RenderPlan>();
    plan->figure = shown.history.current();
    picture.plan = plan;
    picture.facts.final = true;
    shown.viewport.setPicture(picture);
    const QImage grabbed = shown.viewport.grab().toImage();
    const QRectF sheet = shown.viewport.sheet();
    EXPECT_EQ(grabbed.pixelColor(sheet.center().toPoint() + QPoint(20, 40)), QColor(10, 200, 30));
    int ink = 0; // of the letter at the right edge
    for (int y = -12; y <= 12; ++y)
        for (int x = 4; x < 24; ++x)
            ink += grabbed.pixelColor(static_cast<int>(sheet.right()) - x, static_cast<int>(sheet.center().y()) + y) ==
                           QColor(10, 200, 30)
                       ? 0
                       : 1;
    EXPECT_GT(ink, 20);
}

TEST(Viewport, WithoutAScanNothingHappens) {
    Viewport viewport;
    viewport.resize(300, 300);
    bool edited = false;
    QObject::connect(&viewport, &Viewport::edited, [&](const Edit&) { edited = true; });
    for (const bool project : {false, true}) { // nothing at all, and a project without its scan
        viewport.setFigure(project ? std::make_shared<const Figure>() : nullptr);
        QTest::mouseDClick(&viewport, Qt::LeftButton, {}, {150, 150});
        QTest::keyClick(&viewport, Qt::Key_Left);
        viewport.fit();
        viewport.showSide(StandardView::left);
        viewport.grab();
    }
    EXPECT_FALSE(edited);
}

} // namespace
} // namespace limner
