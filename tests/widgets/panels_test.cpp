#include "widgets/layer_form.h"
#include "widgets/progress_strip.h"
#include "widgets/style_image.h"

#include "support/qt/qt_events.h"
#include "widgets/job.h"
#include "widgets/notice_bar.h"
#include "widgets/test_figure.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QTest>
#include <QToolButton>

namespace limner {
namespace {

using testing::pumpUntil;

/// A form over a history, as the window joins them.
struct LayerFormOnHistory {
    LayerFormOnHistory() {
        QObject::connect(&form, &LayerForm::edited, [this](const Edit& edit) {
            history.apply(edit);
            show();
        });
        form.show();
        show();
    }
    void show() { form.setFigure(history.current(), 1); }
    void undo() {
        history.undo();
        show();
    }
    [[nodiscard]] const Layer& layer() const { return history.current()->layers[1]; }
    History history{testing::smallFigure()};
    LayerForm form;
};

TEST(LayerForm, ContoursComeAndGoWithTheirPen) {
    LayerFormOnHistory on;
    const Figure start = *on.history.current();
    EXPECT_FALSE(on.form.contours()->isChecked());
    EXPECT_FALSE(on.form.thickness()->isEnabled());
    EXPECT_FALSE(on.form.evenWidth()->isEnabled());
    QTest::mouseClick(on.form.contours(), Qt::LeftButton, {}, QPoint(8, on.form.contours()->height() / 2));
    EXPECT_EQ(on.layer().contours, Contours{});
    for (const double mm : {0.7, 0.5, 0.35})
        on.form.thickness()->setValue(mm);
    EXPECT_EQ(on.layer().contours, Contours{.thicknessMm = 0.35});
    on.form.evenWidth()->click();
    EXPECT_EQ(on.layer().contours, (Contours{.thicknessMm = 0.35, .curvatureControlled = false}));
    EXPECT_EQ(on.history.position(), 3U) << "the thickness is one step";
    on.form.contours()->click();
    EXPECT_FALSE(on.layer().contours);
    on.form.contours()->click();
    EXPECT_EQ(on.layer().contours, (Contours{.thicknessMm = 0.35, .curvatureControlled = false}))
        << "the pen is where it was left";
    EXPECT_FALSE(on.history.current()->layers[0].contours) << "of another layer";
    for (int i = 0; i < 5; ++i)
        on.undo();
    EXPECT_EQ(*on.history.current(), start);
    EXPECT_FALSE(on.form.contours()->isChecked());
}

TEST(LayerForm, WhatItDoesNotShowStays) {
    LayerFormOnHistory on;
    Edit edit{*on.history.current(), "", {}, false};
    const Contours fine{.thicknessMm = 0.12345,
                        .curvature = CurvatureEstimator::normals,
                        .probeVoxels = 2}; // finer than the field shows
    edit.figure.layers[1].contours = fine;
    on.history.apply(edit);
    on.show();
    EXPECT_EQ(on.layer().contours, fine) << "showing is no edit";
    on.form.evenWidth()->click();
    EXPECT_EQ(on.layer().contours->thicknessMm, fine.thicknessMm);
    on.form.thickness()->setValue(0.5);
    EXPECT_EQ(on.layer().contours, (Contours{0.5, false, CurvatureEstimator::normals, 2}));
}

TEST(LayerForm, TransparencyIsAStep) {
    LayerFormOnHistory on;
    on.form.transparency()->setFocus();
    QTest::keyClick(on.form.transparency(), Qt::Key_Down);
    EXPECT_EQ(on.layer().transparency, Transparency::illustrative);
    EXPECT_EQ(on.history.position(), 1U);
    on.undo();
    EXPECT_EQ(on.layer().transparency, Transparency::uniform);
    EXPECT_EQ(on.form.transparency()->currentText(), "Uniform");
    on.form.setFigure(nullptr, 0);
    EXPECT_FALSE(on.form.isEnabled());
}

TEST(StyleImage, ABallShowsTheSphereAndNothingAround) {
    std::vector<Rgba> pixels(16 * 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            pixels[static_cast<std::size_t>(y) * 16 + static_cast<std::size_t>(x)] =
                y < 8 ? Rgba{1, 0, 0, 1} : Rgba{0, 0, 1, 1};
    const QImage ball = styleBall(LitSphere(16, pixels), 40);
    EXPECT_EQ(qAlpha(ball.pixel(0, 0)), 0);
    EXPECT_EQ(ball.pixelColor(20, 8), QColor(255, 0, 0)) << "up is up";
    EXPECT_EQ(ball.pixelColor(20, 32), QColor(0, 0, 255));
}

TEST(Job, EndsWithExactlyOneWord) {
    for (const int how : {0, 1, 2}) {
        QString heard;
        Job job(
            "work",
            [how](Task& task) {
                task.beginPhase("digging");
                task.progress(0.5);
                if (how == 1)
                    throw Error(ErrorKind::badInput, {"cannot read", "x", "it is broken", ""});
                while (how == 2)
                    task.throwIfCancelled();
            },
            nullptr);
        QObject::connect(&job, &Job::finished, [&] { heard += "finished"; });
        QObject::connect(&job, &Job::failed, [&](const Error& error) { heard += error.what(); });
        QObject::connect(&job, &Job::cancelled, [&] { heard += "cancelled"; });
        job.start();
        if (how == 2)
            job.cancel();
        ASSERT_TRUE(pumpUntil([&] { return !heard.isEmpty(); }));
        QTest::qWait(20);
        EXPECT_EQ(heard, how == 0 ? "finished" : how == 1 ? "cannot read: x: it is broken" : "cancelled");
    }
}

TEST(Job, AForeignExceptionIsAnErrorToo) {
    QString heard;
    Job job(
        "Reading", [](Task&) { throw std::bad_alloc(); }, nullptr);
    QObject::connect(&job, &Job::failed, [&](const Error& error) { heard = error.what(); });
    job.start();
    ASSERT_TRUE(pumpUntil([&] { return !heard.isEmpty(); }));
    EXPECT_TRUE(heard.startsWith("Reading failed"));
}

TEST(ProgressStrip, ShowsLastingWorkAndCancelsIt) {
    QWidget window;
    ProgressStrip strip(&window);
    window.show();
    bool cancelled = false;
    Job job(
        "Importing",
        [](Task& task) {
            while (true)
                task.throwIfCancelled();
        },
        nullptr);
    QObject::connect(&job, &Job::cancelled, [&] { cancelled = true; });
    strip.follow(&job);
    job.start();
    EXPECT_FALSE(strip.isVisible()) << "short work must not flicker";
    ASSERT_TRUE(pumpUntil([&] { return strip.isVisible(); }));
    job.cancel();
    ASSERT_TRUE(pumpUntil([&] { return cancelled; }));
    EXPECT_FALSE(strip.isVisible());
}

TEST(NoticeBar, AnOfferIsTakenOnce) {
    QWidget window;
    NoticeBar bar(&window);
    window.show();
    int taken = 0;
    bar.offer("Removed “Ivory”", "Undo", [&] { ++taken; });
    EXPECT_EQ(bar.action()->text(), "Undo");
    EXPECT_TRUE(bar.action()->isVisible());
    bar.action()->click();
    EXPECT_EQ(taken, 1);
    EXPECT_FALSE(bar.isVisible());
    bar.offer("Removed “Ink”", "Undo", [&] { ++taken; });
    bar.setNotices({"One slice is missing."}, NoticeBar::Kind::information);
    EXPECT_FALSE(bar.action()->isVisible()) << "another notice has no offer";
    EXPECT_EQ(taken, 1);
}

TEST(NoticeBar, HidesWithoutNotices) {
    QWidget window;
    NoticeBar bar(&window);
    window.show();
    bar.setNotices({"The scanner's table was removed.", "One slice is missing."}, NoticeBar::Kind::information);
    EXPECT_TRUE(bar.isVisible());
    bar.setNotices({}, NoticeBar::Kind::information);
    EXPECT_FALSE(bar.isVisible());
}

} // namespace
} // namespace limner
