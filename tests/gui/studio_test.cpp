// The real window, driven by mouse and keys.
#include "gui/studio_window.h"

#include "app/studio/export_dialog.h"
#include "app/studio/window_background.h"
#include "app/studio/window_export.h"
#include "app/studio/window_stipple.h"
#include "core/figure/layer_edits.h"
#include "core/project/archive.h"
#include "core/project/embedded_volume.h"
#include "core/volume/phantom.h"
#include "support/make_volume.h"
#include "support/qt/qt_events.h"
#include "support/test_data.h"
#include "widgets/cleanup_form.h"
#include "widgets/importance_form.h"
#include "widgets/island_overlay.h"
#include "widgets/label_list.h"
#include "widgets/layer_list.h"
#include "widgets/layer_panel.h"
#include "widgets/layer_parts_form.h"
#include "widgets/lens_overlay.h"
#include "widgets/notice_bar.h"
#include "widgets/parameter_row.h"
#include "widgets/part_form.h"
#include "widgets/scissors_overlay.h"
#include "widgets/stipple_form.h"
#include "widgets/style_gallery.h"
#include "widgets/transfer_editor_1d.h"
#include "widgets/viewport.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSlider>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <fstream>
#include <iostream>

namespace limner {
namespace {

using testing::pumpUntil;
using testing::Studio;
using Kind = TransferCanvas::HandleKind;

/// Notes the longest time between two turns of the event loop.
class GapProbe : public QObject {
  public:
    GapProbe() {
        clock_.start();
        timer_.setInterval(1);
        connect(&timer_, &QTimer::timeout, this, [this] {
            longest_ = std::max(longest_, clock_.nsecsElapsed() * 1e-6);
            clock_.restart();
        });
        timer_.start();
    }
    /// Milliseconds.
    [[nodiscard]] double longest() const { return longest_; }

  private:
    QTimer timer_;
    QElapsedTimer clock_;
    double longest_ = 0;
};

/// Whether the picture shows anything but its background.
bool showsSomething(const QImage& image) {
    const QRgb corner = image.pixel(0, 0);
    int different = 0;
    for (int y = 0; y < image.height(); y += 4)
        for (int x = 0; x < image.width(); x += 4)
            different += image.pixel(x, y) != corner ? 1 : 0;
    return different > image.width() * image.height() / 16 / 20; // a twentieth of the probes
}

TEST(Studio, StartsWithWhatCanBeDone) {
    Studio studio;
    EXPECT_EQ(studio.window->windowTitle(), "Limner Studio");
    EXPECT_FALSE(studio.window->actions().at("file.save")->isEnabled());
    EXPECT_FALSE(studio.window->actions().at("edit.undo")->isEnabled());
    EXPECT_TRUE(studio.window->actions().at("file.open")->isEnabled());
}

TEST(Studio, ALockedLayerIsLeftAloneByThemesAndPanels) {
    Studio studio;
    ASSERT_TRUE(studio.openSample());
    studio.window->layers().lock()->trigger();
    const Figure locked = studio.figure();
    ASSERT_TRUE(locked.layers.at(0).locked);
    EXPECT_FALSE(studio.window->transferEditor().canvas()->isEnabled());
    EXPECT_FALSE(studio.window->gallery().place()) << "styles are looked at, not put anywhere";
    auto* theme = studio.window->findChild<QAction*>("theme.blackboard");
    ASSERT_NE(theme, nullptr);
    theme->trigger();
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    EXPECT_NE(studio.figure().background, locked.background);
    EXPECT_EQ(studio.figure().layers.at(0), locked.layers.at(0));
    for (const std::string& id : stylesOf(locked.layers.at(0)))
        EXPECT_EQ(*studio.figure().findStyle(id), *locked.findStyle(id)) << id;
    studio.trigger("edit.undo");
    studio.trigger("edit.undo");
    EXPECT_FALSE(studio.figure().layers.at(0).locked);
    EXPECT_TRUE(studio.window->transferEditor().canvas()->isEnabled());
    EXPECT_TRUE(studio.window->layerPanel().parts()->part("/layers/*/tone")->isEnabled());
}

TEST(Studio, TheActionTableIsWhole) {
    Studio studio;
    QStringList shortcuts;
    for (const ActionRow& row : actionTable()) {
        const QAction* action = studio.window->actions().at(row.id);
        if (action->isSeparator())
            continue;
        EXPECT_FALSE(action->toolTip().isEmpty()) << row.id;
        EXPECT_FALSE(action->associatedObjects().isEmpty()) << row.id << " is in no menu";
        if (!action->shortcut().isEmpty())
            shortcuts << action->shortcut().toString();
    }
    EXPECT_EQ(shortcuts.removeDuplicates(), 0);
}

/// The tools over the picture give clean-up steps; the cleaned volume is drawn by itself and comes back by undo.
TEST(Studio, CleansUpInThePicture) {
    Studio studio;
    EXPECT_FALSE(studio.window->actions().at("edit.scissors")->isEnabled());
    ASSERT_TRUE(studio.openSample());
    const auto showsSteps = [&] {
        return pumpUntil([&] {
            return studio.hasFinal() &&
                   studio.window->viewport().picture()->plan->figure->cleanup == studio.figure().cleanup;
        });
    };
    const auto before = studio.figure().cleanup;
    const auto volumeBefore = studio.window->viewport().picture()->plan->volume;
    studio.trigger("edit.keep-island");
    studio.trigger("edit.scissors");
    ScissorsOverlay& scissors = studio.window->scissors();
    EXPECT_TRUE(scissors.taken());
    EXPECT_FALSE(studio.window->islandTool().taken()) << "one tool at a time";
    const QRectF sheet = studio.window->viewport().sheet();
    for (const auto& [x, y] : {std::pair{0.05, 0.05}, {0.95, 0.05}, {0.95, 0.5}, {0.05, 0.5}})
        QTest::mouseClick(&scissors, Qt::LeftButton, {},
                          (sheet.topLeft() + QPointF(x * sheet.width(), y * sheet.height())).toPoint());
    QTest::keyClick(&scissors, Qt::Key_Return);
    EXPECT_FALSE(studio.window->actions().at("edit.scissors")->isChecked());
    ASSERT_EQ(studio.figure().cleanup.size(), before.size() + 1);
    EXPECT_EQ(studio.window->cleanup().list()->count(), static_cast<int>(before.size() + 1));
    ASSERT_TRUE(showsSteps());
    EXPECT_NE(studio.window->viewport().picture()->plan->volume, volumeBefore);
    studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure().cleanup, before);
    EXPECT_TRUE(showsSteps());
}

/// Labels come to the open scan as a step that can be undone, and the list under the layers has them.
TEST(Studio, OpensLabelsForTheScan) {
    Studio studio;
    EXPECT_FALSE(studio.window->actions().at("file.open-labels")->isEnabled());
    ASSERT_TRUE(studio.openSample());
    Grid coarse = studio.figure().volume->data->grid();
    coarse.dims /= 8;
    coarse.spacingMm *= 8.0;
    const auto halves = testing::makeVolume<std::int16_t>(
        coarse, VoxelType::int16, [&](glm::ivec3 v) { return v.x < coarse.dims.x / 2 ? 3 : 8; });
    const TemporaryFolder folder;
    Task task;
    writeNrrd(*halves, folder.path() / "halves.nrrd", task);
    const auto layers = studio.figure().layers;
    studio.window->openLabelsPath(folder.path() / "halves.nrrd");
    ASSERT_TRUE(pumpUntil([&] { return studio.figure().labels.has_value(); }));
    EXPECT_EQ(studio.figure().layers, layers);
    EXPECT_TRUE(pumpUntil([&] { return studio.window->labels().list()->count() == 2; }));
    studio.window->labels().list()->item(1)->setCheckState(Qt::Unchecked);
    EXPECT_EQ(studio.figure().layers[0].labels, std::vector<int>{3});
    studio.trigger("edit.undo");
    studio.trigger("edit.undo");
    EXPECT_FALSE(studio.figure().labels);
    EXPECT_TRUE(studio.window->labels().isHidden());
}

/// What stands in the corner of the shown picture.
bool waitForCorner(Studio& studio, const QColor& colour) {
    return pumpUntil([&] {
        const auto& picture = studio.window->viewport().picture();
        return picture && picture->image.pixelColor(0, 0) == colour;
    });
}

/// Paper and picture are a step each; a picture that cannot be read changes nothing.
TEST(Studio, TheBackgroundCanBeChosen) {
    Studio studio;
    EXPECT_FALSE(studio.window->actions().at("background.paper")->isEnabled());
    EXPECT_FALSE(studio.window->actions().at("background.picture")->isEnabled());
    ASSERT_TRUE(studio.openSample());
    const Figure start = studio.figure();
    auto* background = studio.window->findChild<WindowBackground*>();
    const auto settled = [&] { return !background->busy(); };
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("sheet.png").toStdString();
    QImage sheet(40, 30, QImage::Format_RGB32);
    sheet.fill(QColor(20, 200, 90));
    ASSERT_TRUE(sheet.save(QString::fromStdString(file.string())));

    background->usePicture(file);
    ASSERT_TRUE(pumpUntil(settled));
    EXPECT_EQ(studio.figure().background.kind, "image");
    EXPECT_EQ(studio.figure().background.rgba, start.background.rgba);
    EXPECT_TRUE(waitForCorner(studio, QColor(20, 200, 90)));
    const Figure withPicture = studio.figure();

    background->usePaper(QColor(255, 0, 51));
    EXPECT_EQ(studio.figure().background.kind, "colour");
    EXPECT_EQ(studio.figure().background.picture, nullptr);
    EXPECT_TRUE(waitForCorner(studio, QColor(255, 0, 51)));
    EXPECT_EQ(studio.window->document().history().position(), 2U);
    studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure(), withPicture);
    studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure(), start);

    background->usePicture(file.string() + ".none");
    ASSERT_TRUE(pumpUntil(settled));
    EXPECT_EQ(studio.figure(), start);
    auto* box = studio.window->findChild<QMessageBox*>();
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->detailedText().contains("no such file"));
    box->close();
}

/// A preset keeps the camera.
void choosePreset(Studio& studio, const Figure& start) {
    studio.window->usePreset("skull", "Skull");
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    EXPECT_NE(studio.figure().layers, start.layers);
    EXPECT_EQ(studio.figure().camera, start.camera);
    EXPECT_TRUE(studio.window->document().dirty());
    EXPECT_TRUE(studio.window->isWindowModified());
}

/// A theme exchanges the styles and the paper, and is one step back.
void chooseTheme(Studio& studio) {
    const Figure before = studio.figure();
    auto* action = studio.window->findChild<QAction*>("theme.blackboard");
    ASSERT_NE(action, nullptr);
    action->trigger();
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    EXPECT_EQ(studio.figure().layers.at(0).transfer, before.layers.at(0).transfer);
    EXPECT_NE(studio.figure().styles, before.styles);
    EXPECT_LT(studio.figure().background.rgba.g, 0.3);
    EXPECT_TRUE(waitForCorner(studio, QColor(0x22, 0x30, 0x2c)));
    studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure(), before);
    studio.trigger("edit.redo");
}

/// Another style, by a click into the gallery.
void clickAStyle(Studio& studio) {
    GalleryList* list = studio.window->gallery().list();
    ASSERT_TRUE(pumpUntil([&] { return list->items().size() >= 20; })) << "at least twenty bundled styles";
    const std::string before = studio.figure().layers[0].transfer.nodes.at(0).style;
    const auto other = std::find_if(list->items().begin(), list->items().end(),
                                    [&](const GalleryItem& item) { return item.card.id != before; });
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->rowOf(other->key())).center());
    EXPECT_NE(studio.figure().layers[0].transfer.nodes.at(0).style, before);
    ASSERT_TRUE(studio.waitForFinal());
}

/// An opacity point, by a drag; pictures come while it moves.
void dragAPoint(Studio& studio) {
    TransferCanvas& canvas = *studio.window->transferEditor().canvas();
    const auto points = studio.figure().layers[0].transfer.opacity;
    ASSERT_GE(points.size(), 2U);
    const QPoint from = canvas.positionOf({Kind::point, points.size() / 2})->toPoint();
    const std::size_t stepsBefore = studio.window->document().history().position();
    QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) {
        const QPointF at = from + QPointF(2.0 * i, 3.0 * i);
        QMouseEvent move(QEvent::MouseMove, at, canvas.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&canvas, &move);
        QTest::qWait(15);
    }
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, from + QPoint(20, 30));
    EXPECT_NE(studio.figure().layers[0].transfer.opacity, points);
    EXPECT_EQ(studio.window->document().history().position(), stepsBefore + 1);
    ASSERT_TRUE(studio.waitForFinal());
}

/// A turn with the keys and a standard view.
void turn(Studio& studio) {
    QTest::keyClick(&studio.window->viewport(), Qt::Key_Left);
    studio.trigger("view.left");
    EXPECT_EQ(studio.window->viewport().letters().left.substr(0, 1).size(), 1U);
    ASSERT_TRUE(studio.waitForFinal());
    EXPECT_EQ(studio.window->viewport().letters(), (EdgeLetters{"A", "P", "S", "I"}));
}

void undoAllAndRedoAll(Studio& studio, const Figure& start, Figure end) {
    while (studio.window->actions().at("edit.undo")->isEnabled())
        studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure(), start);
    EXPECT_FALSE(studio.window->document().dirty());
    while (studio.window->actions().at("edit.redo")->isEnabled())
        studio.trigger("edit.redo");
    EXPECT_EQ(studio.figure(), end);
}

void saveAndReopen(Studio& studio, const QTemporaryDir& folder, Figure end) {
    const std::filesystem::path project = folder.filePath("head.limner").toStdString();
    studio.window->savePath(project);
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    EXPECT_FALSE(studio.window->document().dirty());
    EXPECT_TRUE(studio.window->windowTitle().startsWith("head.limner"));
    const unsigned generation = studio.window->document().generation();
    studio.window->openPath(project);
    ASSERT_TRUE(pumpUntil([&] { return studio.window->document().generation() != generation; }));
    const Figure again = studio.figure();
    EXPECT_EQ(again.layers, end.layers);
    EXPECT_EQ(again.camera, end.camera);
    EXPECT_EQ(again.output, end.output);
    EXPECT_EQ(again.cleanup, end.cleanup);
    ASSERT_TRUE(again.volume && again.volume->data);
    ASSERT_TRUE(studio.waitForFinal());
}

void exportPng(Studio& studio, const QTemporaryDir& folder) {
    const std::filesystem::path png = folder.filePath("head.png").toStdString();
    ExportDialog::Choice choice;
    choice.output = {50, 50, 150, false};
    choice.ending = "png";
    auto* exports = studio.window->findChild<WindowExport*>();
    ASSERT_NE(exports, nullptr);
    exports->exportPath(png, choice);
    ASSERT_TRUE(pumpUntil([&] { return !exports->busy(); }));
    const QImage exported(QString::fromStdString(png.string()));
    EXPECT_EQ(exported.size(), QSize(295, 295));
    EXPECT_NEAR(exported.dotsPerMeterX(), 150 / 0.0254, 1);
    EXPECT_TRUE(showsSomething(exported));
}

TEST(Studio, FromScanToExportAndBack) {
    Studio studio;
    GapProbe gaps;
    QElapsedTimer clock;
    clock.start();
    studio.window->openSample();
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->document().empty(); }));
    const auto opened = clock.elapsed();
    ASSERT_TRUE(pumpUntil([&] { return studio.window->viewport().picture().has_value(); }));
    std::cout << "sample opened after " << opened << " ms, first picture after " << clock.elapsed() << " ms\n";
    ASSERT_TRUE(studio.waitForFinal());
    EXPECT_TRUE(showsSomething(studio.window->viewport().picture()->image));
    EXPECT_FALSE(studio.window->document().dirty());
    const Figure start = studio.figure();
    ASSERT_FALSE(start.layers.empty());

    ASSERT_NO_FATAL_FAILURE(choosePreset(studio, start));
    ASSERT_NO_FATAL_FAILURE(chooseTheme(studio));
    ASSERT_NO_FATAL_FAILURE(clickAStyle(studio));
    ASSERT_NO_FATAL_FAILURE(dragAPoint(studio));
    ASSERT_NO_FATAL_FAILURE(turn(studio));
    ASSERT_NO_FATAL_FAILURE(undoAllAndRedoAll(studio, start, studio.figure()));
    const QTemporaryDir folder;
    ASSERT_NO_FATAL_FAILURE(saveAndReopen(studio, folder, studio.figure()));
    ASSERT_NO_FATAL_FAILURE(exportPng(studio, folder));

    std::cout << "longest gap of the event loop: " << gaps.longest() << " ms\n";
    EXPECT_LT(gaps.longest(), 1000) << "the window hung";
}

TEST(Studio, ARealCtOpensWhileTheWindowLives) {
    const auto path = testing::testData("volumes/cthead_unc.nrrd");
    if (!path)
        GTEST_SKIP();
    Studio studio;
    GapProbe gaps;
    QElapsedTimer clock;
    clock.start();
    studio.window->openPath(*path);
    ASSERT_TRUE(pumpUntil([&] { return studio.window->viewport().picture().has_value(); }));
    std::cout << "first picture of a CT after " << clock.elapsed() << " ms\n";
    ASSERT_TRUE(studio.waitForFinal());
    std::cout << "final after " << clock.elapsed() << " ms; longest gap " << gaps.longest() << " ms\n";
    EXPECT_LT(gaps.longest(), 1000) << "the window hung";

    // From an edit to its first picture, as the render thread counts it.
    std::vector<double> times;
    double planMs = 0;
    double renderMs = 0;
    for (int i = 0; i < 20; ++i) {
        const auto* before = studio.window->viewport().picture()->plan.get();
        QTest::keyClick(&studio.window->viewport(), i % 2 ? Qt::Key_Left : Qt::Key_Right);
        ASSERT_TRUE(pumpUntil([&] { return studio.window->viewport().picture()->plan.get() != before; }));
        const PictureFacts& facts = studio.window->viewport().picture()->facts;
        times.push_back(facts.sinceRequestMs);
        planMs += facts.planMs / 20;
        renderMs += facts.renderMs / 20;
        if (i % 5 == 4) {
            ASSERT_TRUE(studio.waitForFinal());
        }
    }
    std::sort(times.begin(), times.end());
    std::cout << "edit to first picture: median " << times[10] << " ms, longest " << times.back() << " ms; mean "
              << planMs << " ms planning, " << renderMs << " ms drawing\n";
    std::cout << "longest gap while turning: " << gaps.longest() << " ms\n";
}

TEST(Studio, AFileThatIsNoScanIsToldInOneLine) {
    Studio studio;
    const QTemporaryDir folder;
    const std::string path = folder.filePath("broken.nrrd").toStdString();
    std::ofstream(path) << "NRRD0004\ntype: banana\n";
    studio.window->openPath(path);
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    auto* box = studio.window->findChild<QMessageBox*>();
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->detailedText().contains("broken.nrrd"));
    EXPECT_FALSE(box->text().contains('\n'));
    EXPECT_TRUE(studio.window->document().empty());
    box->close();
}

TEST(Studio, AnImportCanBeCancelledByOpeningSomethingElse) {
    Studio studio;
    studio.window->openSample();
    studio.window->openSample();
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    EXPECT_EQ(studio.window->document().generation(), 1U) << "only the second one arrives";
}

TEST(Studio, ADropOpens) {
    const auto path = testing::testData("volumes/cthead_unc.nrrd");
    if (!path)
        GTEST_SKIP();
    Studio studio;
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(path->string()))});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(studio.window.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(studio.window.get(), &drop);
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    EXPECT_FALSE(studio.window->document().empty());
    EXPECT_TRUE(studio.window->windowTitle().contains("cthead_unc.nrrd"));
}

TEST(Studio, ClosingAsksOnlyForChanges) {
    Studio studio;
    int asked = 0;
    MainWindow::Answer answer = MainWindow::Answer::cancel;
    studio.window->askAboutChanges = [&] {
        ++asked;
        return answer;
    };
    ASSERT_TRUE(studio.openSample());
    QTest::keyClick(&studio.window->viewport(), Qt::Key_Left);
    EXPECT_FALSE(studio.window->close());
    EXPECT_EQ(asked, 1);
    EXPECT_TRUE(studio.window->isVisible());
    studio.trigger("edit.undo");
    EXPECT_TRUE(studio.window->close()) << "undone is unchanged";
    EXPECT_EQ(asked, 1);
}

TEST(Studio, TheImportancePanelShowsWhatEachMeasureDoes) {
    Studio studio;
    studio.window->openSample();
    ASSERT_TRUE(pumpUntil([&] { return studio.hasFinal(); }));
    ParameterRow* gradient = studio.window->importance().row("/importance/weights/gradient");
    EXPECT_TRUE(gradient->picture()->pixmap().isNull());
    studio.window->actions().at("edit.add-lens")->trigger(); // raises the panel
    ASSERT_TRUE(pumpUntil([&] { return !gradient->picture()->pixmap().isNull(); }));
    const QImage first = gradient->picture()->pixmap().toImage();
    EXPECT_NE(first, studio.window->importance().row("/importance/weights/extinction")->picture()->pixmap().toImage());
    EXPECT_TRUE(studio.window->importance().row("/importance/global")->picture()->pixmap().isNull());
    ASSERT_TRUE(studio.figure().importance);
    EXPECT_EQ(studio.figure().importance->lenses.size(), 1U);
    EXPECT_TRUE(studio.window->lensOverlay().isVisible());
}

/// The action draws with ink and brings its panel; a dragged slider is one step, and the picture follows it in drafts.
TEST(Studio, TheStipplePanelChangesTheFigureWhileItsSlidersMove) {
    Studio studio;
    QAction* action = studio.window->actions().at("edit.stipple");
    EXPECT_FALSE(action->isEnabled());
    ASSERT_TRUE(studio.openSample());
    StippleForm& panel = studio.window->findChild<WindowStipple*>()->form();
    EXPECT_FALSE(panel.inked()->isChecked());
    EXPECT_TRUE(panel.visibleRegion().isEmpty()) << "it lies behind another tab";
    action->trigger();
    QTest::qWait(0);
    ASSERT_TRUE(studio.figure().stipple);
    EXPECT_TRUE(action->isChecked());
    EXPECT_TRUE(panel.inked()->isChecked());
    EXPECT_FALSE(panel.visibleRegion().isEmpty()) << "the panel is in front";
    EXPECT_EQ(studio.window->focusWidget(), panel.inked());
    const History& history = studio.window->document().history();
    const std::size_t before = history.position();
    QSlider* gain = panel.row("/stipple/boundary/kgs")->slider();
    gain->setSliderDown(true);
    for (const int at : {20, 60, 120}) {
        gain->setSliderPosition(at);
        EXPECT_TRUE(studio.window->document().gestureOngoing());
        ASSERT_TRUE(pumpUntil([&] {
            const auto& picture = studio.window->viewport().picture();
            return picture && picture->plan->figure->stipple == studio.figure().stipple;
        })) << "the picture follows";
    }
    gain->setSliderDown(false);
    EXPECT_FALSE(studio.window->document().gestureOngoing());
    EXPECT_EQ(history.position(), before + 1);
    ASSERT_TRUE(studio.waitForFinal());
    studio.trigger("edit.undo");
    studio.trigger("edit.undo");
    EXPECT_FALSE(studio.figure().stipple);
    EXPECT_FALSE(action->isChecked());
}

TEST(Studio, EveryKindOfFileThatExportOffersCanBeWritten) {
    Studio studio;
    ASSERT_TRUE(studio.openSample());
    ExportDialog dialog(studio.figure(), 0);
    QStringList endings;
    for (const QComboBox* box : dialog.findChildren<QComboBox*>())
        for (int i = 0; i < box->count(); ++i)
            if (box->itemData(i).typeId() == QMetaType::QString)
                endings << box->itemData(i).toString();
    EXPECT_TRUE(endings.contains("png") && endings.contains("svg") && endings.contains("pdf"));
    for (const QString& ending : endings)
        EXPECT_NO_THROW(checkExport("picture." + ending.toStdString(), {0, 0}, PictureOptions{}))
            << ending.toStdString();
}

TEST(Studio, TheShownPictureCanBeCopied) {
    Studio studio;
    ASSERT_TRUE(studio.openSample());
    studio.trigger("edit.copy-picture");
    EXPECT_EQ(QApplication::clipboard()->image().size(), studio.window->viewport().picture()->image.size());
}

} // namespace
} // namespace limner
