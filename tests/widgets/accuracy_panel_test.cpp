#include "widgets/accuracy_panel.h"

#include "support/qt/nameless_controls.h"
#include "support/qt/qt_events.h"
#include "widgets/accuracy_chart.h"
#include "widgets/accuracy_words.h"
#include "widgets/error_overlay.h"
#include "widgets/test_figure.h"
#include "widgets/viewport.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>

namespace limner {
namespace {

using accuracy::Tolerance;

constexpr int kDraft = 0, kScreen = 1, kPrint = 2, kReference = 3, kCustom = 4;

struct Shown {
    Shown() {
        panel.resize(390, 900);
        panel.show();
        panel.setFigure(std::make_shared<const Figure>(figure));
        QObject::connect(&panel, &AccuracyPanel::settingsWanted, [this](const Tolerance& t) { wanted.push_back(t); });
    }
    void setFigures(std::optional<double> tolerance, ErrorMetric metric) {
        figure.quality.tolerance = tolerance;
        figure.quality.toleranceMetric = metric;
        panel.setFigure(std::make_shared<const Figure>(figure));
    }
    Figure figure = testing::smallFigure();
    AccuracyPanel panel;
    std::vector<Tolerance> wanted;
};

/// Four measurements: the longer one waits, the smaller is the error; the first one is the figure's.
std::shared_ptr<accuracy::Study> smallStudy() {
    auto study = std::make_shared<accuracy::Study>();
    const double seconds[] = {0.02, 0.05, 0.2, 3}, errors[] = {5, 1.2, 0.5, 0.06}, steps[] = {2, 0.5, 0.25, 0.125};
    for (std::size_t i = 0; i < std::size(seconds); ++i) {
        accuracy::StudyRow row;
        row.pictureSeconds = seconds[i];
        row.measured.error.p95Colour = errors[i];
        row.measured.quality.stepVoxels = steps[i];
        study->rows.push_back(row);
        study->pareto.push_back(i);
    }
    study->series.push_back({"point samples", {0, 1, 2, 3}, 1.96, true});
    study->errorBar = 0.02;
    study->limits = {accuracy::Knob::step, "0.0625", 5, 0.03};
    accuracy::ToleranceChoice screen;
    screen.quality = study->rows[1].measured.quality;
    screen.reached = true;
    screen.heldOutError = 1.2;
    accuracy::ToleranceChoice print = screen;
    print.asked.value = 0.7;
    print.reached = false;
    study->choices = {{"for screen", screen}, {"for print", print}};
    return study;
}

TEST(AccuracyPanel, TheSliderHasTheNamedTolerancesAndTheNumberFollows) {
    Shown shown;
    EXPECT_EQ(shown.panel.slider()->value(), kScreen) << "what the engine asks for by itself";
    QTest::keyClick(shown.panel.slider(), Qt::Key_Right);
    EXPECT_EQ(shown.panel.slider()->value(), kPrint);
    EXPECT_DOUBLE_EQ(shown.panel.number()->value(), 0.7);
    QTest::keyClick(shown.panel.slider(), Qt::Key_Right);
    EXPECT_EQ(shown.panel.slider()->value(), kReference);
    EXPECT_EQ(shown.panel.metric()->currentData().toInt(), static_cast<int>(ErrorMetric::largest));
    EXPECT_EQ(shown.panel.asked().value, 1.0 / 510) << "not as the field rounds it";
    ASSERT_TRUE(testing::pumpUntil([&] { return !shown.wanted.empty(); }));
    ASSERT_EQ(shown.wanted.size(), 1U) << "keys that follow each other ask once";
    EXPECT_EQ(shown.wanted[0].metric, ErrorMetric::largest);
}

TEST(AccuracyPanel, ASliderThatIsLetGoElsewhereFindsSettings) {
    Shown shown;
    shown.panel.slider()->setSliderDown(true);
    shown.panel.slider()->setSliderPosition(kPrint);
    EXPECT_TRUE(shown.wanted.empty()) << "still in hand";
    shown.panel.slider()->setSliderDown(false);
    ASSERT_EQ(shown.wanted.size(), 1U);
    EXPECT_EQ(shown.wanted[0].value, 0.7);
    shown.panel.slider()->setSliderDown(true);
    shown.panel.slider()->setSliderPosition(kDraft);
    shown.panel.slider()->setSliderPosition(kPrint);
    shown.panel.slider()->setSliderDown(false);
    EXPECT_EQ(shown.wanted.size(), 1U) << "it is where it was";
}

TEST(AccuracyPanel, AnotherNumberOrMeasureIsACustomTolerance) {
    Shown shown;
    shown.panel.number()->setValue(0.25);
    EXPECT_EQ(shown.panel.slider()->value(), kCustom);
    EXPECT_EQ(shown.panel.asked().value, 0.25);
    EXPECT_EQ(shown.panel.asked().metric, ErrorMetric::ciede2000);
    const int rms = shown.panel.metric()->findData(static_cast<int>(ErrorMetric::rootMeanSquare));
    shown.panel.metric()->setCurrentIndex(rms);
    Q_EMIT shown.panel.metric()->activated(rms);
    EXPECT_EQ(shown.panel.slider()->value(), kCustom);
    EXPECT_EQ(shown.panel.asked().metric, ErrorMetric::rootMeanSquare);
    EXPECT_LT(shown.panel.asked().value, 0.01) << "a quarter of the full range would be another picture";
    EXPECT_TRUE(shown.wanted.empty());
    shown.panel.find()->click();
    ASSERT_EQ(shown.wanted.size(), 1U);
    EXPECT_EQ(shown.wanted[0].metric, ErrorMetric::rootMeanSquare);
}

TEST(AccuracyPanel, TheFiguresOwnToleranceIsShownWhenItChanges) {
    Shown shown;
    shown.setFigures(0.7, ErrorMetric::ciede2000);
    EXPECT_EQ(shown.panel.slider()->value(), kPrint);
    shown.panel.slider()->setValue(kDraft);
    shown.setFigures(0.7, ErrorMetric::ciede2000);
    EXPECT_EQ(shown.panel.slider()->value(), kDraft) << "an edit of something else leaves the hand's choice";
    shown.setFigures(0.01, ErrorMetric::largest);
    EXPECT_EQ(shown.panel.slider()->value(), kCustom);
    EXPECT_EQ(shown.panel.asked().value, 0.01);
    shown.setFigures(1.0 / 510, ErrorMetric::largest);
    EXPECT_EQ(shown.panel.slider()->value(), kReference);
}

TEST(AccuracyPanel, TheAnswerIsInPlainWords) {
    Shown shown;
    EXPECT_TRUE(shown.panel.answer()->isHidden());
    ToleranceAnswer answer{{ErrorMetric::ciede2000, 1.5}, 0.02, accuracy::ToleranceChoice{}};
    answer.choice->reached = true;
    answer.choice->heldOutError = 1.23;
    answer.choice->quality.stepVoxels = 0.25;
    answer.choice->limits = {accuracy::Knob::termination, "0", 1.1, 0.4};
    shown.panel.showAnswer(answer, true);
    EXPECT_FALSE(shown.panel.answer()->isHidden());
    for (const char* word : {"Delivered ΔE 1.23", "asked ΔE 1.5", "step 0.25 voxel", "early end of the rays", "ΔE 0.4"})
        EXPECT_TRUE(shown.panel.answer()->text().contains(word)) << word;
    EXPECT_TRUE(shown.panel.answer()->isEnabled());
    shown.panel.setAnswerCurrent(false);
    EXPECT_TRUE(shown.panel.answer()->text().contains("changed since"));
    EXPECT_FALSE(shown.panel.answer()->isEnabled());
    answer.choice->reached = false;
    answer.choice->searchedError = 1.9;
    shown.panel.showAnswer(answer, false);
    EXPECT_TRUE(shown.panel.answer()->text().startsWith("Not reached: asked ΔE 1.5")) << "never silently";
    EXPECT_TRUE(shown.panel.answer()->text().contains("ΔE 1.9"));
    EXPECT_TRUE(shown.panel.answer()->isEnabled());
    answer.choice.reset();
    answer.errorBar = 0.3;
    shown.panel.showAnswer(answer, false);
    EXPECT_TRUE(shown.panel.answer()->text().contains("cannot be told"));
    EXPECT_TRUE(shown.panel.answer()->text().contains("ΔE 0.3"));
}

TEST(AccuracyPanel, WhileItWorksOnlyWhatFitsCanBeAskedFor) {
    Shown shown;
    int stops = 0;
    QObject::connect(&shown.panel, &AccuracyPanel::stopWanted, [&] { ++stops; });
    EXPECT_FALSE(shown.panel.stop()->isVisible());
    shown.panel.setWork(AccuracyPanel::Work::study);
    EXPECT_TRUE(shown.panel.stop()->isVisible());
    for (const QWidget* widget : std::initializer_list<QWidget*>{shown.panel.slider(), shown.panel.find(),
                                                                 shown.panel.study(), shown.panel.map()})
        EXPECT_FALSE(widget->isEnabled()) << widget->toolTip().toStdString();
    shown.panel.stop()->click();
    EXPECT_EQ(stops, 1);
    shown.panel.setWork(AccuracyPanel::Work::search);
    EXPECT_TRUE(shown.panel.slider()->isEnabled()) << "another tolerance may be wanted meanwhile";
    EXPECT_FALSE(shown.panel.study()->isEnabled());
    shown.panel.setWork(AccuracyPanel::Work::none);
    EXPECT_TRUE(shown.panel.study()->isEnabled());
    EXPECT_FALSE(shown.panel.stop()->isVisible());
    shown.panel.setFigure(nullptr);
    EXPECT_FALSE(shown.panel.find()->isEnabled());
    EXPECT_FALSE(shown.panel.study()->isEnabled());
}

TEST(AccuracyPanel, WhatIsLeftOutStandsInLinesUntilTheFigureChanges) {
    Shown shown;
    int wanted = 0;
    QObject::connect(&shown.panel, &AccuracyPanel::savingsWanted, [&] { ++wanted; });
    EXPECT_FALSE(shown.panel.savings()->isVisibleTo(&shown.panel));
    shown.panel.measure()->click();
    EXPECT_EQ(wanted, 1);
    shown.panel.setWork(AccuracyPanel::Work::savings);
    EXPECT_FALSE(shown.panel.measure()->isEnabled());
    shown.panel.setWork(AccuracyPanel::Work::none);
    accuracy::Savings savings;
    savings.pixels = {256, 200};
    savings.ms = 10;
    savings.bytes = 20 << 20;
    savings.rules = {{{LeaveOut::emptySpace, "78 % of the blocks"}, 42, 32, 0},
                     {{LeaveOut::wideVoxels, "half of sixteen bits"}, 9, -1, 11 << 20}};
    savings.keptMs = 43;
    savings.keptBytes = savings.bytes + (11 << 20);
    shown.panel.showSavings(savings);
    const QStringList lines = shown.panel.savings()->text().split("\n");
    ASSERT_EQ(lines.size(), 3);
    EXPECT_EQ(lines[0], "samples of empty blocks: 32 ms");
    EXPECT_TRUE(lines[1].startsWith("wider voxels: 0 ms, 11")) << lines[1].toStdString();
    EXPECT_TRUE(lines[2].contains("33 ms") && lines[2].contains("256 × 200") && lines[2].contains("10 ms"))
        << lines[2].toStdString();
    shown.panel.setSavingsCurrent(false);
    EXPECT_FALSE(shown.panel.savings()->isEnabled());
    EXPECT_TRUE(shown.panel.savings()->text().contains("changed since"));
    shown.panel.showSavings({});
    EXPECT_TRUE(shown.panel.savings()->text().startsWith("Nothing is left out"));
    shown.panel.forget();
    EXPECT_FALSE(shown.panel.savings()->isVisibleTo(&shown.panel));
}

TEST(AccuracyPanel, AStudyHasItsTableSentenceAndReport) {
    Shown shown;
    EXPECT_FALSE(shown.panel.report()->isEnabled());
    EXPECT_FALSE(shown.panel.chart()->isVisible());
    shown.panel.showStudy(smallStudy());
    EXPECT_TRUE(shown.panel.report()->isEnabled());
    EXPECT_TRUE(shown.panel.chart()->isVisibleTo(&shown.panel));
    ASSERT_EQ(shown.panel.choices()->rowCount(), 4) << "what could not be told is there too";
    EXPECT_EQ(shown.panel.choices()->item(0, 0)->text(), "Screen");
    EXPECT_EQ(shown.panel.choices()->item(0, 1)->text(), "ΔE 1.2");
    EXPECT_EQ(shown.panel.choices()->item(0, 2)->text(), "50 ms");
    EXPECT_TRUE(shown.panel.choices()->item(1, 1)->text().contains("not reached"));
    EXPECT_EQ(shown.panel.choices()->item(3, 0)->text(), "Reference");
    EXPECT_EQ(shown.panel.choices()->item(3, 1)->text(), "cannot be told");
    EXPECT_TRUE(shown.panel.findings()->text().contains("the step along the rays"));
    EXPECT_TRUE(shown.panel.findings()->text().contains("20 ms"));
    EXPECT_TRUE(testing::namelessControls(shown.panel).empty());
    shown.panel.forget();
    EXPECT_FALSE(shown.panel.report()->isEnabled());
    EXPECT_EQ(shown.panel.choices()->rowCount(), 0);
}

TEST(AccuracyChart, MoreTimeIsRightAndMoreErrorIsUp) {
    AccuracyChart chart;
    chart.resize(360, 260);
    const auto study = smallStudy();
    const QImage empty = chart.grab().toImage();
    chart.setStudy(study);
    for (std::size_t i = 1; i < study->rows.size(); ++i) {
        EXPECT_GT(chart.placeOf(i).x(), chart.placeOf(i - 1).x());
        EXPECT_GT(chart.placeOf(i).y(), chart.placeOf(i - 1).y());
        EXPECT_TRUE(QRectF(chart.rect()).contains(chart.placeOf(i)));
    }
    const double decade = chart.placeOf(2).x() - chart.placeOf(0).x(); // 0.02 s to 0.2 s
    EXPECT_NEAR(chart.placeOf(1).x() - chart.placeOf(0).x(), decade * std::log10(2.5), 1e-6);
    EXPECT_EQ(chart.rowAt(chart.placeOf(2) + QPointF(2, 1)), 2U);
    EXPECT_FALSE(chart.rowAt({1, 1}));
    const QImage drawn = chart.grab().toImage();
    EXPECT_NE(drawn, empty);
    const QColor ring = drawn.pixelColor((chart.placeOf(0) + QPointF(5.5, 0)).toPoint());
    EXPECT_GT(ring.red(), ring.blue() + 60) << "the figure as it is";
    chart.setStudy(nullptr);
    EXPECT_EQ(chart.grab().toImage(), empty);
}

TEST(ErrorOverlay, TheMapLiesOverTheSheetUntilItIsCleared) {
    Figure figure = testing::smallFigure();
    figure.output.widthMm = 200;
    figure.output.heightMm = 100;
    Viewport viewport;
    viewport.resize(800, 500);
    viewport.setFigure(std::make_shared<const Figure>(figure));
    viewport.show();
    ErrorOverlay overlay(&viewport);
    EXPECT_FALSE(overlay.shown());
    Picture map({2, 1}); // the left half is red
    map.pixel(0, 0)[0] = map.pixel(0, 0)[3] = 1;
    overlay.showMap(map, 10);
    EXPECT_TRUE(overlay.shown());
    const QRectF sheet = viewport.sheet();
    const auto colourAt = [&](double x) {
        return viewport.grab().toImage().pixelColor((sheet.topLeft() + QPointF(x * sheet.width(), 30)).toPoint());
    };
    EXPECT_EQ(colourAt(0.1), QColor(Qt::red));
    EXPECT_EQ(colourAt(0.9), QColor(Qt::white));
    viewport.resize(600, 500);
    EXPECT_EQ(overlay.size(), viewport.size());
    overlay.clear();
    EXPECT_FALSE(overlay.shown());
    EXPECT_EQ(viewport.grab().toImage().pixelColor(viewport.sheet().center().toPoint() - QPoint(50, 50)),
              QColor(Qt::white));
}

} // namespace
} // namespace limner
