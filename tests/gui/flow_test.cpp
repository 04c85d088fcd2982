// One figure from scan to print as a new user makes it, in the real window: open, preset, style, opacity, lens, label,
// all of it undone and redone, saved, changed, lost in a crash, recovered, exported.
#include "gui/studio_window.h"

#include "app/studio/window_annotations.h"
#include "app/studio/window_export.h"
#include "app/studio/window_gallery.h"
#include "app/studio/window_recovery.h"
#include "widgets/annotation_form.h"
#include "widgets/gallery_list.h"
#include "widgets/label_tool.h"
#include "widgets/layer_list.h"
#include "widgets/style_drop.h"
#include "widgets/style_gallery.h"
#include "widgets/style_mime.h"
#include "widgets/transfer_canvas.h"
#include "widgets/transfer_editor_1d.h"

#include <QMimeData>
#include <QPlainTextEdit>

namespace limner {
namespace {

using testing::pumpUntil;
using testing::Studio;

/// A window that finds what another has left in the folder for unsaved work.
struct NextStudio : Studio {
    explicit NextStudio(const QString& recovery) {
        qputenv("LIMNER_RECOVERY", recovery.toUtf8());
        window = std::make_unique<MainWindow>(makeEngine());
        window->askAboutChanges = [] { return MainWindow::Answer::discard; };
        window->show();
    }
};

class Flow : public ::testing::Test {
  protected:
    void SetUp() override { qputenv("LIMNER_AUTOSAVE_EDITS", "1"); }
    void TearDown() override {
        qunsetenv("LIMNER_RECOVERY");
        qunsetenv("LIMNER_AUTOSAVE_EDITS");
    }
    [[nodiscard]] QString recovery() const { return folder_.filePath("recovery"); }

    void dropStyle(Studio& studio) {
        const auto& items = studio.window->gallery().list()->items();
        const auto unused = std::ranges::find_if(
            items, [&](const GalleryItem& item) { return !studio.figure().findStyle(item.card.id); });
        ASSERT_NE(unused, items.end());
        QMimeData data;
        data.setData(kStyleMime, QByteArray::fromStdString(unused->key()));
        Viewport& viewport = studio.window->viewport();
        const QPoint middle = viewport.sheet().center().toPoint();
        QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&viewport, &enter);
        studio.window->styles().drop().waitIdle();
        QDropEvent drop(middle, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&viewport, &drop);
        EXPECT_NE(studio.figure().findStyle(unused->card.id), nullptr);
    }

    void shapeOpacity(Studio& studio) {
        TransferCanvas* canvas = studio.window->transferEditor().canvas();
        const TransferCanvas::Handle point{TransferCanvas::HandleKind::point, 1};
        const auto at = canvas->positionOf(point);
        ASSERT_TRUE(at);
        QTest::mousePress(canvas, Qt::LeftButton, {}, at->toPoint());
        const QPointF to = *at + QPointF(0, 25);
        QMouseEvent move(QEvent::MouseMove, to, canvas->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(canvas, &move);
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, to.toPoint());
    }

    void label(Studio& studio, const QString& words) {
        auto* annotations = studio.window->findChild<WindowAnnotations*>();
        studio.window->activateWindow(); // the keys go to it, as they do on a desktop
        ASSERT_TRUE(QTest::qWaitForWindowActive(studio.window.get()));
        studio.trigger("edit.add-label");
        QTest::mouseClick(&annotations->tool(), Qt::LeftButton, {},
                          studio.window->viewport().sheet().center().toPoint());
        ASSERT_EQ(studio.figure().annotations.size(), 1U);
        ASSERT_TRUE(pumpUntil([&] { return annotations->form().words()->hasFocus(); }));
        QTest::keyClicks(annotations->form().words(), words);
    }

    void exportPicture(Studio& studio) {
        const QString picture = folder_.filePath("skull.png");
        ExportDialog::Choice choice;
        choice.output = studio.figure().output;
        choice.output.dpi = 50;
        choice.ending = "png";
        auto* exporting = studio.window->findChild<WindowExport*>();
        exporting->exportPath(picture.toStdString(), choice);
        ASSERT_TRUE(pumpUntil([&] { return !exporting->busy(); }));
        const QImage exported(picture);
        EXPECT_EQ(exported.size(), QSize(354, 354)) << "180 mm at 50 dots per inch";
    }

    QTemporaryDir folder_;
};

TEST_F(Flow, FromScanToPrintThroughACrash) {
    const std::filesystem::path project = folder_.filePath("skull.limner").toStdString();
    Figure lost;
    {
        NextStudio studio(recovery());
        ASSERT_TRUE(studio.openSample());
        ASSERT_TRUE(pumpUntil([&] { return !studio.window->gallery().list()->items().empty(); }));
        const Figure start = studio.figure();
        studio.window->usePreset("skull", "Skull");
        ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
        ASSERT_TRUE(studio.waitForFinal());
        dropStyle(studio);
        shapeOpacity(studio);
        studio.trigger("edit.add-lens");
        label(studio, "Skull");
        const Figure made = studio.figure();
        EXPECT_EQ(made.annotations.size(), 1U);
        ASSERT_TRUE(made.importance);
        EXPECT_EQ(made.importance->lenses.size(), 1U);
        const History& history = studio.window->document().history();
        const std::size_t steps = history.position();
        while (history.canUndo())
            studio.trigger("edit.undo");
        EXPECT_EQ(studio.figure(), start);
        while (history.canRedo())
            studio.trigger("edit.redo");
        EXPECT_EQ(history.position(), steps);
        EXPECT_EQ(studio.figure(), made);
        studio.window->savePath(project);
        ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy() && !studio.window->document().dirty(); }));
        bool kept = false;
        QObject::connect(studio.window->findChild<WindowRecovery*>(), &WindowRecovery::kept, [&] { kept = true; });
        studio.window->usePreset("skin", "Skin");
        ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy() && studio.window->document().dirty(); }));
        kept = false;
        studio.trigger("view.left");
        ASSERT_TRUE(pumpUntil([&] { return kept; }));
        lost = studio.figure();
        // The window goes without being closed: what a crash leaves is what lies on the disk.
    }
    NextStudio again(recovery());
    auto* unsaved = again.window->findChild<WindowRecovery*>();
    ASSERT_TRUE(pumpUntil([&] { return unsaved->offered().size() == 1; }));
    EXPECT_EQ(unsaved->offered()[0].project, project);
    unsaved->restore(0);
    ASSERT_TRUE(pumpUntil([&] { return !again.window->document().empty(); }));
    EXPECT_EQ(again.figure().layers, lost.layers);
    EXPECT_EQ(again.figure().annotations, lost.annotations);
    EXPECT_TRUE(again.window->document().dirty());
    EXPECT_EQ(again.window->document().projectPath(), project);
    exportPicture(again);
}

} // namespace
} // namespace limner
