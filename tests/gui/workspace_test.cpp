// Arrangement, colours, commands and keys of the real window; looks and variants.
#include "gui/studio_window.h"

#include "app/studio/shortcuts_dialog.h"
#include "app/studio/variant_dialog.h"
#include "app/studio/welcome_page.h"
#include "app/studio/window_looks.h"
#include "app/studio/window_slices.h"
#include "app/studio/window_view.h"
#include "app/studio/window_workspace.h"
#include "support/qt/nameless_controls.h"
#include "widgets/clip_form.h"
#include "widgets/clip_overlay.h"
#include "widgets/command_palette.h"
#include "widgets/measure_overlay.h"
#include "widgets/notice_bar.h"
#include "widgets/picture_handle.h"
#include "widgets/point_mark.h"
#include "widgets/slices_panel.h"
#include "widgets/style_gallery.h"
#include "widgets/view_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>

#include <filesystem>

namespace limner {
namespace {

using testing::pumpUntil;
using testing::Studio;

QDockWidget* panel(Studio& studio, const char* name) { return studio.window->findChild<QDockWidget*>(name); }

TEST(Workspace, EveryCommandIsFoundByItsName) {
    Studio studio;
    auto* workspace = studio.window->findChild<WindowWorkspace*>();
    QPointer<CommandPalette> palette = workspace->showCommands();
    int named = 0;
    for (const ActionRow& row : actionTable())
        if (*row.text && !studio.window->actions().at(row.id)->menu()) {
            const QString name = plainText(*studio.window->actions().at(row.id));
            palette->search()->setText(name);
            bool found = false;
            for (int i = 0; i < palette->list()->count(); ++i)
                found = found || palette->list()->item(i)->text().contains(name);
            EXPECT_TRUE(found) << row.id;
            ++named;
        }
    EXPECT_GT(named, 40);
    palette->search()->setText("dark");
    QTest::keyClick(palette->search(), Qt::Key_Return);
    EXPECT_TRUE(pumpUntil([&] { return studio.window->palette().color(QPalette::Window).lightness() < 100; }, 5000));
    EXPECT_TRUE(
        pumpUntil([&] { return studio.window->gallery().grab().toImage().pixelColor(2, 2).lightness() < 100; }, 5000));
    EXPECT_EQ(chosenStudioTheme(), StudioTheme::dark);
    studio.window->notices().setNotices({"a line"}, NoticeBar::Kind::information);
    EXPECT_LT(studio.window->notices().palette().color(QPalette::Window).lightness(), 100);
    workspace->useTheme(StudioTheme::light);
    EXPECT_TRUE(
        pumpUntil([&] { return studio.window->notices().palette().color(QPalette::Window).lightness() > 180; }, 5000))
        << "a line that is shown changes with the window";
}

TEST(Welcome, SampleFiguresOfScansThatAreHereAreOpened) {
    const std::string scans = std::string(LIMNER_TEST_DATA) + "/volumes";
    if (!std::filesystem::exists(scans + "/tooth.nrrd"))
        GTEST_SKIP() << "the test scans are not here";
    qputenv("LIMNER_SAMPLES", QByteArray::fromStdString(scans));
    {
        Studio studio;
        auto* welcome = studio.window->findChild<WelcomePage*>();
        QListWidget* list = welcome->figures();
        ASSERT_TRUE(pumpUntil([&] { return list->count() > 0; }));
        const auto tooth = [&] {
            for (int i = 0; i < list->count(); ++i)
                if (findSampleFigure(list->item(i)->data(Qt::UserRole).toString().toStdString()).scan == "tooth.nrrd")
                    return list->item(i);
            return static_cast<QListWidgetItem*>(nullptr);
        }();
        ASSERT_NE(tooth, nullptr);
        Q_EMIT list->itemActivated(tooth);
        ASSERT_TRUE(pumpUntil([&] { return !studio.window->document().empty(); }));
        EXPECT_TRUE(studio.figure().volume && studio.figure().volume->data);
        EXPECT_FALSE(studio.window->document().dirty());
    }
    qunsetenv("LIMNER_SAMPLES");
}

TEST(Workspace, EveryControlHasAName) {
    Studio studio;
    ASSERT_TRUE(studio.openSample());
    for (const std::string& control : testing::namelessControls(*studio.window))
        ADD_FAILURE() << control;
}

TEST(Workspace, LayoutsAreKeptByName) {
    Studio studio;
    auto* workspace = studio.window->findChild<WindowWorkspace*>();
    QDockWidget* styles = panel(studio, "dock.styles");
    workspace->saveLayout("All of it");
    styles->hide();
    workspace->saveLayout("Without styles");
    EXPECT_EQ(WindowWorkspace::layouts().size(), 2);
    workspace->useLayout("All of it");
    EXPECT_FALSE(styles->isHidden());
    workspace->useLayout("Without styles");
    EXPECT_TRUE(styles->isHidden());
    workspace->useStandardLayout();
    EXPECT_FALSE(styles->isHidden());
    workspace->removeLayout("All of it");
    workspace->removeLayout("Without styles");
    EXPECT_TRUE(WindowWorkspace::layouts().isEmpty());
}

TEST(Workspace, ThePanelsComeBackAfterOnlyThePicture) {
    Studio studio;
    studio.trigger("window.only-picture");
    EXPECT_TRUE(panel(studio, "dock.styles")->isHidden());
    EXPECT_TRUE(panel(studio, "dock.layers")->isHidden());
    studio.trigger("window.only-picture");
    EXPECT_FALSE(panel(studio, "dock.styles")->isHidden());
    EXPECT_FALSE(panel(studio, "dock.layers")->isHidden());
}

int rowOf(const QTableWidget& table, const char* id) {
    for (int row = 0; row < table.rowCount(); ++row)
        if (table.item(row, 0)->data(Qt::UserRole).toString() == id)
            return row;
    return -1;
}

TEST(Workspace, KeysAreChangedTakenOverAndKept) {
    const QKeySequence keys("Ctrl+L"); // of "Add lens"
    {
        Studio studio;
        ShortcutsDialog dialog(&studio.window->actions(), studio.window.get());
        dialog.table()->setCurrentCell(rowOf(*dialog.table(), "view.fit"), 0);
        dialog.keys()->setKeySequence(keys);
        EXPECT_TRUE(dialog.word()->text().contains("lens", Qt::CaseInsensitive)) << "it says whose they are";
        dialog.assign()->click();
        EXPECT_EQ(studio.window->actions().at("view.fit")->shortcut(), keys);
        EXPECT_TRUE(studio.window->actions().at("edit.add-lens")->shortcut().isEmpty());
    }
    Studio again;
    EXPECT_EQ(again.window->actions().at("view.fit")->shortcut(), keys) << "from one start to the next";
    EXPECT_TRUE(again.window->actions().at("edit.add-lens")->shortcut().isEmpty());
    ShortcutsDialog dialog(&again.window->actions(), again.window.get());
    dialog.resetAll()->click();
    EXPECT_EQ(again.window->actions().at("view.fit")->shortcut(), QKeySequence("F"));
    EXPECT_EQ(again.window->actions().at("edit.add-lens")->shortcut(), keys);
}

TEST(Workspace, NoTwoCommandsShareTheirStandardKeys) {
    QHash<QString, QString> owners;
    for (const ActionRow& row : actionTable()) {
        const QString keys = Actions::standardShortcut(row).toString();
        if (keys.isEmpty())
            continue;
        EXPECT_FALSE(owners.contains(keys)) << row.id << " and " << owners[keys].toStdString();
        owners[keys] = row.id;
    }
}

TEST(View, GripsOfTheCropBoxShowWithThePanelOnly) {
    Studio studio;
    ASSERT_TRUE(studio.openSample());
    auto* view = studio.window->findChild<WindowView*>();
    QDockWidget* dock = panel(studio, "dock.view");
    dock->raise();
    QTest::qWait(0);
    view->form().clip()->present()->click();
    view->form().clip()->box()->click();
    ASSERT_TRUE(studio.figure().clip.boxMm);
    PictureHandle* side = view->overlay().boxGrip(1);
    ASSERT_NE(side, nullptr);
    const double before = studio.figure().clip.boxMm->high.x;
    QTest::keyClick(side, Qt::Key_Left, Qt::NoModifier);
    EXPECT_NE(studio.figure().clip.boxMm->high.x, before);
    panel(studio, "dock.layers")->raise();
    QTest::qWait(0);
    EXPECT_EQ(view->overlay().boxGrip(1), nullptr);
}

TEST(Slices, AClickOnThePictureBringsThemThere) {
    Studio studio;
    ASSERT_TRUE(studio.openSample());
    auto* slices = studio.window->findChild<WindowSlices*>();
    panel(studio, "dock.slices")->raise();
    QTest::qWait(0);
    const glm::dvec3 before = slices->panel().point();
    const QPointF middle = studio.window->viewport().sheet().center();
    QTest::mouseClick(&studio.window->viewport(), Qt::LeftButton, {}, middle.toPoint());
    EXPECT_NE(slices->panel().point(), before);
    ASSERT_TRUE(slices->mark().place());
    EXPECT_NEAR(slices->mark().place()->x(), middle.x(), 3);
    EXPECT_NEAR(slices->mark().place()->y(), middle.y(), 3);
    studio.trigger("view.measure");
    EXPECT_TRUE(slices->measure().taken());
    studio.trigger("edit.scissors");
    EXPECT_FALSE(slices->measure().taken()) << "a hand holds one tool";
    EXPECT_FALSE(studio.window->actions().at("view.measure")->isChecked());
}

TEST(Looks, ALookIsKeptAndLaidOverAsOneStep) {
    Studio studio;
    qputenv("LIMNER_LOOKS", studio.styles.filePath("looks").toUtf8());
    studio.window = std::make_unique<MainWindow>(makeEngine());
    studio.window->askAboutChanges = [] { return MainWindow::Answer::discard; };
    studio.window->show();
    ASSERT_TRUE(studio.openSample());
    auto* looks = studio.window->findChild<WindowLooks*>();
    const Figure first = studio.figure();
    looks->keep("Mine");
    ASSERT_TRUE(pumpUntil([&] { return looks->cards().size() == 1; }));
    EXPECT_FALSE(looks->cards()[0].thumbnailPng.empty()) << "with a picture of the user's own scan";
    studio.window->usePreset("skull", "Skull");
    ASSERT_TRUE(pumpUntil([&] { return studio.figure().layers != first.layers; }));
    looks->use(looks->cards()[0].id, "Mine");
    ASSERT_TRUE(pumpUntil([&] { return studio.figure().layers == first.layers; }));
    EXPECT_EQ(studio.figure().camera, first.camera);
    EXPECT_EQ(studio.window->document().history().position(), 2U);
    looks->remove(looks->cards()[0].id);
    EXPECT_TRUE(pumpUntil([&] { return looks->cards().empty(); }));
    qunsetenv("LIMNER_LOOKS");
}

TEST(Variants, ASheetIsDrawnAndOneIsTaken) {
    Studio studio;
    ASSERT_TRUE(studio.openSample());
    auto* looks = studio.window->findChild<WindowLooks*>();
    QPointer<VariantDialog> dialog = looks->showVariants();
    const auto drawn = [&] { return !dialog->busy() && dialog->sheet()->count() > 0; };
    ASSERT_TRUE(pumpUntil(drawn));
    EXPECT_EQ(dialog->sheet()->count(), 8) << "the themes";
    const int opacity = dialog->source()->findData("/layers/0/opacity");
    ASSERT_GE(opacity, 0);
    dialog->source()->setCurrentIndex(opacity);
    ASSERT_TRUE(pumpUntil([&] { return drawn() && dialog->sheet()->count() == dialog->count()->value(); }));
    dialog->sheet()->setCurrentRow(0);
    Q_EMIT dialog->sheet()->itemActivated(dialog->sheet()->item(0));
    EXPECT_NEAR(studio.figure().layers[0].opacity, dialog->from()->value(), 1e-3);
    EXPECT_NE(dialog->sheet()->item(0)->icon().pixmap(64, 64).toImage(),
              dialog->sheet()->item(dialog->count()->value() - 1)->icon().pixmap(64, 64).toImage());
    EXPECT_EQ(studio.window->document().history().position(), 1U);
    dialog->close();
}

} // namespace
} // namespace limner
