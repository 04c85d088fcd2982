#include "app/studio/window_annotations.h"
#include "gui/studio_window.h"
#include "renderer/export/picture_file.h"
#include "widgets/annotation_form.h"
#include "widgets/annotation_overlay.h"
#include "widgets/label_tool.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QListWidget>
#include <QPlainTextEdit>

namespace limner {
namespace {

using testing::pumpUntil;
using testing::Studio;

struct Lettering : Studio {
    [[nodiscard]] WindowAnnotations& feature() const { return *window->findChild<WindowAnnotations*>(); }
    bool showsThem() {
        return pumpUntil([this] {
            return hasFinal() && window->viewport().picture()->plan->figure->annotations == figure().annotations;
        });
    }
};

/// A label by the tool and the keyboard, dragged, taken back and repeated.
TEST(StudioAnnotations, LabelsAStructure) {
    Lettering studio;
    EXPECT_FALSE(studio.window->actions().at("edit.add-label")->isEnabled());
    ASSERT_TRUE(studio.openSample());
    const auto plan = studio.window->viewport().picture()->plan;
    studio.trigger("edit.add-label");
    LabelTool& tool = studio.feature().tool();
    ASSERT_TRUE(tool.taken());
    studio.trigger("edit.scissors");
    EXPECT_FALSE(tool.taken()) << "one tool at a time";
    studio.trigger("edit.add-label");
    // Through the window: nothing of it lies over the tool.
    const QPoint middle = studio.window->viewport().sheet().center().toPoint();
    QTest::mouseClick(studio.window->windowHandle(), Qt::LeftButton, {},
                      studio.window->viewport().mapTo(studio.window.get(), middle));
    ASSERT_EQ(studio.figure().annotations.size(), 1U);
    EXPECT_TRUE(tool.taken()) << "for the next structure";
    QPlainTextEdit* words = studio.feature().form().words();
    EXPECT_EQ(studio.window->focusWidget(), words) << "what is typed next is the label's words";
    QTest::keyClicks(words, "Nose");
    QTest::keyClick(words, Qt::Key_Escape);
    EXPECT_FALSE(tool.taken()) << "Esc while the words are written";
    EXPECT_EQ(studio.figure().annotations[0].text, "Nose");
    ASSERT_TRUE(studio.showsThem());
    const auto& picture = *studio.window->viewport().picture();
    ASSERT_EQ(picture.annotations.size(), 1U);
    EXPECT_TRUE(picture.annotations[0].drawn);
    EXPECT_EQ(picture.plan->skip, plan->skip) << "lettering plans nothing anew";

    const QPointF from = *studio.feature().overlay().middleOf(0);
    const QPointF to = studio.window->viewport().sheet().topLeft() + QPointF(120, 60);
    QTest::mousePress(&studio.window->viewport(), Qt::LeftButton, {}, from.toPoint());
    QMouseEvent move(QEvent::MouseMove, to, studio.window->viewport().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     {});
    QApplication::sendEvent(&studio.window->viewport(), &move);
    QTest::mouseRelease(&studio.window->viewport(), Qt::LeftButton, {}, to.toPoint());
    ASSERT_TRUE(studio.figure().annotations[0].at);
    studio.trigger("edit.undo");
    EXPECT_FALSE(studio.figure().annotations[0].at);
    studio.trigger("edit.undo");
    studio.trigger("edit.undo");
    EXPECT_TRUE(studio.figure().annotations.empty());
    studio.trigger("edit.redo");
    studio.trigger("edit.redo");
    studio.trigger("edit.redo");
    ASSERT_TRUE(studio.figure().annotations.at(0).at);
    ASSERT_TRUE(studio.showsThem());
    QTest::mouseClick(&studio.window->viewport(), Qt::LeftButton, {},
                      studio.feature().overlay().middleOf(0)->toPoint());
    QTest::keyClick(&studio.window->viewport(), Qt::Key_Delete);
    EXPECT_TRUE(studio.figure().annotations.empty());
}

/// The tool is taken once, then it is a click and the words for each.
TEST(StudioAnnotations, LabelsThreeStructuresInARow) {
    Lettering studio;
    ASSERT_TRUE(studio.openSample());
    studio.trigger("edit.add-label");
    const Viewport& viewport = studio.window->viewport();
    QPlainTextEdit* words = studio.feature().form().words();
    const QPoint middle = viewport.sheet().center().toPoint();
    const QStringList names{"Nose", "Cheek", "Brow"};
    for (int i = 0; i < names.size(); ++i) {
        QTest::mouseClick(studio.window->windowHandle(), Qt::LeftButton, {},
                          viewport.mapTo(studio.window.get(), middle + QPoint(30 * (i - 1), 0)));
        ASSERT_EQ(studio.figure().annotations.size(), static_cast<std::size_t>(i + 1));
        ASSERT_EQ(studio.window->focusWidget(), words);
        QTest::keyClicks(words, names[i]);
        ASSERT_TRUE(studio.showsThem());
    }
    for (int i = 0; i < names.size(); ++i)
        EXPECT_EQ(studio.figure().annotations[static_cast<std::size_t>(i)].text, names[i].toStdString());
}

/// The window's picture and an exported one of the same size hold the same letters.
TEST(StudioAnnotations, TheWindowShowsWhatIsExported) {
    Lettering studio;
    ASSERT_TRUE(studio.openSample());
    AnnotationForm& form = studio.feature().form();
    form.addKind("scale-bar");
    form.addKind("orientation");
    form.addKind("legend");
    ASSERT_TRUE(studio.showsThem());
    const ScreenPicture& shown = *studio.window->viewport().picture();
    EXPECT_EQ(shown.annotations.size(), 3U);
    Task task;
    const auto png = renderPng(*shown.plan, *makeCpuBackend(), pictureOptions(*shown.plan->figure), task);
    QImage exported = QImage::fromData(reinterpret_cast<const uchar*>(png.data()), static_cast<int>(png.size()));
    ASSERT_EQ(exported.size(), shown.image.size());
    const QImage mine = shown.image.convertToFormat(QImage::Format_RGB32);
    exported = exported.convertToFormat(QImage::Format_RGB32);
    qint64 off = 0;
    for (int y = 0; y < mine.height(); ++y)
        for (int x = 0; x < mine.width(); ++x)
            off += mine.pixel(x, y) == exported.pixel(x, y) ? 0 : 1;
    EXPECT_EQ(off, 0);
}

} // namespace
} // namespace limner
