// The Accuracy panel in the real window, on the sample head.
#include "gui/studio_window.h"

#include "app/studio/window_accuracy.h"
#include "widgets/accuracy_panel.h"
#include "widgets/error_overlay.h"

#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>

namespace limner {
namespace {

using testing::pumpUntil;
using testing::Studio;

constexpr int kAtMostMs = 400000; // measuring on a machine that has other things to do
constexpr int kScreen = 1;

struct Open : Studio {
    Open() {
        window->resize(900, 640); // a small picture: the work is the same
        EXPECT_TRUE(openSample());
    }
    WindowAccuracy& accuracy() { return *window->findChild<WindowAccuracy*>(); }
    AccuracyPanel& panel() { return accuracy().panel(); }
    bool waitIdle() {
        return pumpUntil([this] { return panel().work() == AccuracyPanel::Work::none && !accuracy().busy(); },
                         kAtMostMs);
    }
    [[nodiscard]] const History& history() const { return window->document().history(); }
};

TEST(Accuracy, SettingsForTheScreenAreOneStepAndTheLineSaysWhatTheyDeliver) {
    Open studio;
    const Quality before = studio.figure().quality;
    const std::size_t position = studio.history().position();
    EXPECT_FALSE(studio.panel().isVisible()) << "it is there when it is wanted";
    studio.panel().slider()->setValue(kScreen);
    studio.trigger("edit.find-settings");
    EXPECT_TRUE(studio.panel().isVisible());
    EXPECT_EQ(studio.panel().work(), AccuracyPanel::Work::search) << "the window does not wait for it";
    ASSERT_TRUE(studio.waitIdle());
    EXPECT_EQ(studio.history().position(), position + 1);
    const Quality found = studio.figure().quality;
    EXPECT_EQ(found.tolerance, 1.5);
    EXPECT_EQ(found.toleranceMetric, ErrorMetric::ciede2000);
    EXPECT_LE(found.stepVoxels, 0.5) << "the limit that no probe may overrule";
    const QString line = studio.panel().answer()->text();
    EXPECT_TRUE(line.startsWith("Delivered ΔE ")) << line.toStdString();
    EXPECT_TRUE(line.contains("asked ΔE 1.5")) << line.toStdString();
    EXPECT_TRUE(studio.panel().answer()->isEnabled());
    studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure().quality, before);
    EXPECT_FALSE(studio.panel().answer()->isEnabled()) << "what it says is of other settings now";
    studio.trigger("edit.redo");
    EXPECT_TRUE(studio.panel().answer()->isEnabled());
}

TEST(Accuracy, ASearchForAFigureThatChangesIsStopped) {
    Open studio;
    studio.panel().find()->click();
    const std::size_t position = studio.history().position();
    QTest::keyClick(&studio.window->viewport(), Qt::Key_Left);
    EXPECT_EQ(studio.panel().work(), AccuracyPanel::Work::none);
    ASSERT_TRUE(studio.waitIdle());
    QTest::qWait(0);
    EXPECT_EQ(studio.history().position(), position + 1) << "the turned view alone";
    EXPECT_FALSE(studio.figure().quality.tolerance);
    EXPECT_TRUE(studio.panel().answer()->text().startsWith("Stopped")) << studio.panel().answer()->text().toStdString();
}

TEST(Accuracy, AStudyThatIsStoppedLeavesNothingBehind) {
    Open studio;
    const auto figure = studio.window->document().figure();
    studio.panel().study()->click();
    ASSERT_TRUE(pumpUntil([&] { return studio.accuracy().busy(); }));
    EXPECT_FALSE(studio.panel().study()->isEnabled());
    studio.panel().stop()->click();
    ASSERT_TRUE(studio.waitIdle());
    EXPECT_FALSE(studio.accuracy().study());
    EXPECT_FALSE(studio.panel().report()->isEnabled());
    EXPECT_TRUE(studio.panel().findings()->text().isEmpty());
    EXPECT_TRUE(studio.panel().study()->isEnabled()) << "it can be had again";
    EXPECT_EQ(studio.window->document().figure(), figure);
}

TEST(Accuracy, AStudyRunsAndItsReportIsSaved) {
    Open studio;
    studio.panel().seconds()->setValue(studio.panel().seconds()->minimum());
    studio.panel().study()->click();
    ASSERT_TRUE(studio.waitIdle());
    ASSERT_TRUE(studio.accuracy().study());
    EXPECT_FALSE(studio.accuracy().study()->rows.empty());
    EXPECT_LE(std::max(studio.accuracy().study()->size.x, studio.accuracy().study()->size.y), 512);
    EXPECT_FALSE(studio.panel().findings()->text().isEmpty());
    EXPECT_FALSE(studio.window->document().dirty()) << "measuring changes nothing";
    const QTemporaryDir folder;
    for (const auto& [name, start] : {std::pair{"r.html", "<!doctype html>"}, {"r.json", "{"}, {"r.csv", "method"}}) {
        bool saved = false;
        const auto heard =
            QObject::connect(&studio.accuracy(), &WindowAccuracy::reportSaved, [&saved] { saved = true; });
        const QString path = folder.filePath(name);
        studio.accuracy().saveReport(path.toStdString());
        ASSERT_TRUE(pumpUntil([&] { return saved; })) << name;
        QObject::disconnect(heard);
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        EXPECT_TRUE(QString(file.readAll()).startsWith(start)) << name;
    }
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 3) << "and nothing beside them";
    QTest::keyClick(&studio.window->viewport(), Qt::Key_Left);
    EXPECT_FALSE(studio.panel().findings()->isEnabled()) << "the study is of another view";
}

TEST(Accuracy, WhatIsLeftOutAndWhatItSavesIsMeasured) {
    Open studio;
    studio.panel().measure()->click();
    EXPECT_EQ(studio.panel().work(), AccuracyPanel::Work::savings) << "the window does not wait for it";
    ASSERT_TRUE(studio.waitIdle());
    EXPECT_TRUE(studio.panel().savings()->text().contains("samples of empty blocks: "))
        << studio.panel().savings()->text().toStdString();
    EXPECT_FALSE(studio.window->document().dirty()) << "measuring changes nothing";
    QTest::keyClick(&studio.window->viewport(), Qt::Key_Left);
    EXPECT_FALSE(studio.panel().savings()->isEnabled()) << "they are of another view";
}

TEST(Accuracy, TheMapOfTheErrorGoesWhenThePictureChanges) {
    Open studio;
    QAction* action = studio.window->actions().at("view.error-map");
    ErrorOverlay& overlay = studio.accuracy().overlay();
    action->trigger();
    ASSERT_TRUE(studio.waitIdle());
    EXPECT_TRUE(overlay.shown());
    EXPECT_TRUE(action->isChecked());
    EXPECT_TRUE(studio.panel().map()->isChecked());
    bool any = false;
    for (int y = 0; y < overlay.map().height() && !any; ++y)
        for (int x = 0; x < overlay.map().width() && !any; ++x)
            any = overlay.map().pixelColor(x, y).alpha() > 0;
    EXPECT_TRUE(any) << "no picture is without error";
    QTest::keyClick(&studio.window->viewport(), Qt::Key_Left);
    EXPECT_FALSE(overlay.shown());
    EXPECT_FALSE(action->isChecked());
    EXPECT_FALSE(studio.panel().map()->isChecked());
    EXPECT_EQ(studio.panel().work(), AccuracyPanel::Work::none) << "it does not draw by itself again";
    studio.panel().map()->click();
    ASSERT_TRUE(studio.waitIdle());
    EXPECT_TRUE(overlay.shown());
    studio.panel().map()->click();
    EXPECT_FALSE(overlay.shown());
}

} // namespace
} // namespace limner
