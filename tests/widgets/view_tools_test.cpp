// The view in numbers, grips of the cut, slices and measuring.
#include "widgets/clip_overlay.h"
#include "widgets/measure_overlay.h"
#include "widgets/picture_handle.h"
#include "widgets/point_mark.h"
#include "widgets/slices_panel.h"
#include "widgets/view_form.h"

#include "core/figure/view_frame.h"
#include "renderer/plan/planner.h"
#include "support/qt/qt_events.h"
#include "widgets/clip_form.h"
#include "widgets/parameter_row.h"
#include "widgets/test_figure.h"
#include "widgets/viewport.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTest>

namespace limner {
namespace {

using testing::pumpUntil;

/// The small ball from the front, in a sheet of 800 x 400 pixels that shows 80 mm of height: five pixels a millimetre.
struct Shown {
    Shown() {
        Figure figure = testing::smallFigure();
        figure.output.widthMm = 200;
        figure.output.heightMm = 100;
        start(figure);
        viewport.resize(836, 436);
        viewport.show();
        viewport.activateWindow();
        QTest::qWait(0);
        show();
    }
    void start(const Figure& figure) { history = History(figure); }
    void apply(const Edit& edit) {
        edits.push_back(edit);
        history.apply(edit);
        show();
    }
    virtual ~Shown() = default;
    virtual void show() { viewport.setFigure(history.current()); }
    [[nodiscard]] const Figure& figure() const { return *history.current(); }
    void showPicture() {
        Planner planner;
        Task task;
        PlanRequest request;
        request.size = {200, 100};
        ScreenPicture picture;
        picture.plan = planner.plan(figure(), request, task);
        picture.image = QImage(200, 100, QImage::Format_RGB32);
        viewport.setPicture(picture);
    }
    Viewport viewport;
    History history;
    std::vector<Edit> edits;
};

struct Cutting : Shown {
    Cutting() {
        Figure cut = figure();
        cut.clip.boxMm = BoxMm{glm::dvec3(10), glm::dvec3(50)};
        cut.clip.planes = {{{1, 0, 0}, 40}};
        start(cut);
        QObject::connect(&overlay, &ClipOverlay::edited, [this](const Edit& edit) { apply(edit); });
        Cutting::show();
    }
    void show() override {
        Shown::show();
        overlay.setFigure(history.current());
    }
    void drag(PictureHandle* grip, QPointF by) {
        const QPoint middle = grip->rect().center();
        QTest::mousePress(grip, Qt::LeftButton, {}, middle);
        const QPointF from = grip->mapToGlobal(QPointF(middle));
        for (int i = 1; i <= 4; ++i) {
            QMouseEvent move(QEvent::MouseMove, grip->mapFromGlobal(from + by * i / 4), from + by * i / 4, Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(grip, &move);
        }
        QMouseEvent release(QEvent::MouseButtonRelease, grip->mapFromGlobal(from + by), from + by, Qt::LeftButton,
                            Qt::NoButton, {});
        QApplication::sendEvent(grip, &release);
    }
    ClipOverlay overlay{&viewport};
};

TEST(ClipOverlay, ASideOfTheBoxFollowsThePointerInOneStep) {
    Cutting cutting;
    const double pixelsPerMm = cutting.viewport.sheet().height() / 80;
    PictureHandle* left = cutting.overlay.boxGrip(1); // seen from the front, the patient's left is on the right
    ASSERT_NE(left, nullptr);
    EXPECT_EQ(cutting.overlay.boxGrip(2), nullptr) << "its normal points at the viewer";
    cutting.drag(left, {5 * pixelsPerMm, 33});
    EXPECT_NEAR(cutting.figure().clip.boxMm->high.x, 55, 1e-6) << "what goes across the normal does not count";
    EXPECT_EQ(cutting.figure().clip.boxMm->low, glm::dvec3(10));
    EXPECT_EQ(cutting.history.position(), 1U);
    EXPECT_FALSE(cutting.edits.back().ongoing);
    PictureHandle* bottom = cutting.overlay.boxGrip(4);
    ASSERT_NE(bottom, nullptr);
    cutting.drag(bottom, {0, -1000 * pixelsPerMm});
    EXPECT_NEAR(cutting.figure().clip.boxMm->low.z, 49.9, 1e-9) << "a box keeps a volume";
}

TEST(ClipOverlay, APlaneMovesAlongItsNormalByMouseAndKeys) {
    Cutting cutting;
    PictureHandle* grip = cutting.overlay.planeGrip(0);
    ASSERT_NE(grip, nullptr);
    const double pixelsPerMm = cutting.viewport.sheet().height() / 80;
    cutting.drag(grip, {-4 * pixelsPerMm, 0});
    EXPECT_NEAR(cutting.figure().clip.planes[0].offsetMm, 36, 1e-6);
    QTest::keyClick(cutting.overlay.planeGrip(0), Qt::Key_Right);
    EXPECT_NEAR(cutting.figure().clip.planes[0].offsetMm, 37, 1e-6);
    QTest::keyClick(cutting.overlay.planeGrip(0), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_NEAR(cutting.figure().clip.planes[0].offsetMm, 36.9, 1e-6);
    QTest::keyClick(cutting.overlay.planeGrip(0), Qt::Key_Delete);
    EXPECT_TRUE(cutting.figure().clip.planes.empty());
    EXPECT_EQ(cutting.overlay.planeGrip(0), nullptr);
}

struct Viewing : Shown {
    Viewing() {
        QObject::connect(&form, &ViewForm::edited, [this](const Edit& edit) { apply(edit); });
        Viewing::show();
    }
    void show() override {
        Shown::show();
        form.setFigure(history.current());
    }
    ViewForm form;
};

TEST(ViewForm, AnglesMiddleAndHeightAreNumbers) {
    Viewing viewing;
    EXPECT_EQ(viewing.form.angle(0)->value(), 0) << "from the front";
    viewing.form.angle(0)->setValue(90);
    EXPECT_NEAR(glm::dot(viewing.figure().camera.direction, glm::dvec3(-1, 0, 0)), 1, 1e-12);
    viewing.form.angle(1)->setValue(30);
    EXPECT_NEAR(viewing.figure().camera.direction.z, -0.5, 1e-12) << "from above, down";
    EXPECT_EQ(viewing.form.angle(0)->value(), 90);
    viewing.form.target(2)->setValue(12.5);
    EXPECT_EQ(viewing.figure().camera.targetMm.z, 12.5);
    viewing.form.height()->box()->setValue(55);
    EXPECT_EQ(viewing.figure().camera.heightMm, 55);
    EXPECT_FALSE(viewing.form.perspective()->isEnabled()) << "parallel rays have none";
    viewing.form.projection()->setCurrentIndex(1);
    Q_EMIT viewing.form.projection()->activated(1);
    EXPECT_EQ(viewing.figure().camera.projection, Projection::perspective);
    EXPECT_TRUE(viewing.form.perspective()->isEnabled());
}

TEST(ViewForm, TheFiguresCutIsSwitchedOnAndOff) {
    Viewing viewing;
    viewing.form.clip()->present()->click();
    ASSERT_EQ(viewing.figure().clip.planes.size(), 1U);
    EXPECT_NEAR(viewing.figure().clip.planes[0].normal.y, -1, 1e-12) << "what is nearer goes";
    viewing.form.clip()->box()->click();
    EXPECT_TRUE(viewing.figure().clip.boxMm);
    for (const Layer& layer : viewing.figure().layers)
        EXPECT_FALSE(layer.clip) << "the layers' own are left alone";
    viewing.form.clip()->present()->click();
    EXPECT_EQ(viewing.figure().clip, Clip{});
    viewing.form.clip()->present()->click();
    EXPECT_TRUE(viewing.figure().clip.boxMm) << "what was there comes back";
}

struct Slicing : Shown {
    Slicing() {
        panel.resize(260, 700);
        panel.show();
        QTest::qWait(0);
        panel.setFigure(history.current(), {-1000, 1000});
    }
    SlicesPanel panel;
};

TEST(Slices, AClickInOneMovesAllAndKeysGoByVoxels) {
    Slicing slicing;
    const glm::dvec3 centre = slicing.figure().volume->data->grid().centreMm();
    EXPECT_EQ(slicing.panel.point(), centre);
    SliceCanvas* axial = slicing.panel.canvas(SlicePlane::axial);
    ASSERT_TRUE(pumpUntil([&] { return !axial->picture().isNull(); }));
    const QPoint click = axial->rect().center() + QPoint(20, -10);
    QTest::mouseClick(axial, Qt::LeftButton, {}, click);
    const glm::dvec3 moved = slicing.panel.point();
    EXPECT_GT(moved.x, centre.x) << "to the patient's left, which is on the right";
    EXPECT_LT(moved.y, centre.y) << "to the front, which is above";
    EXPECT_EQ(moved.z, centre.z);
    EXPECT_NEAR(axial->onScreen(moved).x(), click.x(), 1e-6);
    QTest::keyClick(axial, Qt::Key_PageUp);
    EXPECT_NEAR(slicing.panel.point().z, centre.z + 2, 1e-9) << "a voxel is 2 mm";
    QTest::keyClick(slicing.panel.canvas(SlicePlane::coronal), Qt::Key_Up);
    EXPECT_NEAR(slicing.panel.point().z, centre.z + 4, 1e-9) << "up is towards the head";
    for (int i = 0; i < 40; ++i)
        QTest::keyClick(axial, Qt::Key_PageUp);
    EXPECT_LE(slicing.panel.point().z, 63) << "not out of the scan, which ends half a voxel past 62 mm";
}

TEST(Slices, ThePictureShowsTheScanWithWhatTheLayersShow) {
    Slicing slicing;
    SliceCanvas* axial = slicing.panel.canvas(SlicePlane::axial);
    const auto at = [&](const glm::dvec3& offset) {
        const QImage& picture = axial->picture();
        const QPointF p = axial->onScreen(slicing.panel.point() + offset) * picture.devicePixelRatio();
        return picture.isNull() ? QColor() : picture.pixelColor(p.toPoint());
    };
    const auto ivory = [&] { return at({2, 2, 0}).red() > at({2, 2, 0}).blue() + 20; };
    EXPECT_TRUE(pumpUntil(ivory, 20000)) << "bone in its style's colour";
    EXPECT_LT(at({28, 28, 0}).red(), 10) << "air is black";
}

TEST(Slices, LookHereIsAnEdit) {
    Slicing slicing;
    QObject::connect(&slicing.panel, &SlicesPanel::edited, [&](const Edit& edit) { slicing.apply(edit); });
    slicing.panel.setPoint({20, 30, 40});
    slicing.panel.lookHere()->click();
    EXPECT_EQ(slicing.figure().camera.targetMm, glm::dvec3(20, 30, 40));
    EXPECT_TRUE(slicing.panel.words()->text().contains("20.0, 30.0, 40.0"))
        << slicing.panel.words()->text().toStdString();
    PointMark mark(&slicing.viewport);
    mark.setPoint(slicing.history.current(), slicing.panel.point());
    ASSERT_TRUE(mark.place());
    EXPECT_NEAR(mark.place()->x(), slicing.viewport.sheet().center().x(), 1e-9) << "in the middle, as asked for";
}

struct Measuring : Shown {
    Measuring() { Measuring::show(); }
    void show() override {
        Shown::show();
        tool.setFigure(history.current());
    }
    void click(QPointF at) { QTest::mouseClick(&tool, Qt::LeftButton, {}, at.toPoint()); }
    MeasureOverlay tool{&viewport};
};

TEST(Measure, TwoClicksGiveTheDistanceOnTheMatterAThirdTheAngle) {
    Measuring measuring;
    measuring.tool.take();
    ASSERT_TRUE(measuring.tool.taken());
    const QPointF middle = measuring.viewport.sheet().center();
    measuring.click(middle);
    EXPECT_TRUE(measuring.tool.points().empty()) << "no picture yet";
    measuring.showPicture();
    const double pixelsPerMm = measuring.viewport.sheet().height() / 80;
    measuring.click(middle + QPointF(-6, 0) * pixelsPerMm);
    measuring.click(middle + QPointF(6, 0) * pixelsPerMm);
    ASSERT_TRUE(measuring.tool.distanceMm());
    EXPECT_NEAR(*measuring.tool.distanceMm(), 12, 0.5) << "both lie equally deep on the ball's core";
    measuring.click(middle + QPointF(6, -6) * pixelsPerMm);
    ASSERT_TRUE(measuring.tool.angleDeg());
    EXPECT_GT(*measuring.tool.angleDeg(), 60);
    EXPECT_LT(*measuring.tool.angleDeg(), 95);
    QTest::keyClick(&measuring.tool, Qt::Key_Backspace);
    EXPECT_FALSE(measuring.tool.angleDeg());
    measuring.click(QPointF(measuring.viewport.sheet().topLeft()) + QPointF(5, 5));
    EXPECT_EQ(measuring.tool.points().size(), 2U) << "there is nothing but paper";
    QTest::keyClick(&measuring.tool, Qt::Key_Escape);
    EXPECT_FALSE(measuring.tool.taken());
    EXPECT_TRUE(measuring.tool.points().empty());
}

} // namespace
} // namespace limner
