// The transfer function panel in the real window: over two axes, the mark of the pointer, and the tool that widens.
#include "gui/studio_window.h"

#include "app/studio/window_transfer.h"
#include "core/style/transfer_function.h"
#include "widgets/layer_list.h"
#include "widgets/layer_rows.h"
#include "widgets/transfer_editor.h"
#include "widgets/widen_overlay.h"

#include <QComboBox>
#include <QDockWidget>

namespace limner {
namespace {

using testing::pumpUntil;

struct TransferStudio : testing::Studio {
    [[nodiscard]] WindowTransfer& feature() const { return *window->findChild<WindowTransfer*>(); }
    [[nodiscard]] TransferEditor& editor() const { return feature().editor(); }
    bool rested() {
        return pumpUntil([this] { return !feature().busy(); }) && waitForFinal();
    }
    bool openSkull() {
        if (!openSample())
            return false;
        window->usePreset("skull", "Skull");
        return pumpUntil([this] { return !window->busy(); }) && waitForFinal();
    }
    [[nodiscard]] QPointF at(double x, double y) const {
        const QRectF sheet = window->viewport().sheet();
        return sheet.topLeft() + QPointF(x * sheet.width(), y * sheet.height());
    }
    [[nodiscard]] const Transfer& transfer() const {
        return figure().layers[window->layers().selectedLayer()].transfer;
    }
    void chooseSecond(const char* word) {
        QComboBox* box = editor().secondAxisBox();
        box->setCurrentIndex(box->findData(QString(word)));
        Q_EMIT box->activated(box->currentIndex());
    }
    void hover(QPointF position) {
        Viewport& viewport = window->viewport();
        QMouseEvent move(QEvent::MouseMove, position, viewport.mapToGlobal(position), Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(&viewport, &move);
    }
    /// Over a widget in the picture's place.
    static void drag(QWidget& widget, QPointF from, QPointF to) {
        QTest::mousePress(&widget, Qt::LeftButton, {}, from.toPoint());
        for (int i = 1; i <= 6; ++i) {
            const QPointF at = from + (to - from) * i / 6;
            QMouseEvent move(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(&widget, &move);
            QTest::qWait(5);
        }
        QTest::mouseRelease(&widget, Qt::LeftButton, {}, to.toPoint());
    }
};

TEST(StudioTransfer, TheValueUnderThePointerIsMarked) {
    TransferStudio studio;
    ASSERT_TRUE(studio.openSkull());
    TransferCanvas& line = *studio.editor().line()->canvas();
    EXPECT_FALSE(line.mark());
    studio.hover(studio.at(0.5, 0.45));
    ASSERT_TRUE(pumpUntil([&] { return line.mark().has_value(); }));
    EXPECT_GT(line.mark()->x, studio.window->document().figure()->volume->data->range().low);
    EXPECT_GT(opacityAt(studio.figure().layers[0].transfer.opacity, line.mark()->x), 0) << "what is seen shows";
    studio.hover(studio.at(0.01, 0.01));
    ASSERT_TRUE(pumpUntil([&] { return !line.mark().has_value(); })) << "paper has no value";
    const std::size_t steps = studio.window->document().history().position();
    studio.chooseSecond("gradient");
    EXPECT_TRUE(studio.editor().showsPlane());
    EXPECT_EQ(studio.window->document().history().position(), steps + 1);
    ASSERT_TRUE(studio.rested());
    studio.hover(studio.at(0.5, 0.45));
    TransferCanvas2d& plane = *studio.editor().plane()->canvas();
    ASSERT_TRUE(pumpUntil([&] { return plane.mark().has_value(); }));
    ASSERT_TRUE(plane.mark()->y);
    EXPECT_GT(*plane.mark()->y, 0.02) << "a surface has a gradient";
    EXPECT_LE(*plane.mark()->y, 1);
}

TEST(StudioTransfer, AHandOverThePictureWidensTheRangeAsOneStep) {
    TransferStudio studio;
    ASSERT_TRUE(studio.openSkull());
    // The range is made narrower first, so that there is something to win: the surface is seen halfway up its ramp.
    studio.hover(studio.at(0.5, 0.45));
    ASSERT_TRUE(pumpUntil([&] { return studio.editor().line()->canvas()->mark().has_value(); }));
    const double seen = studio.editor().line()->canvas()->mark()->x;
    constexpr double kRamp = 300; // HU
    Edit narrow{studio.figure(), "Narrow", {}, false};
    Layer& layer = narrow.figure.layers[studio.window->layers().selectedLayer()];
    layer.transfer.opacity = {{seen, 0}, {seen + kRamp, 1}};
    studio.window->document().apply(narrow);
    ASSERT_TRUE(studio.rested());
    const Figure start = studio.figure();
    const std::size_t steps = studio.window->document().history().position();
    studio.trigger("edit.widen-range");
    WidenOverlay& tool = studio.feature().widen();
    ASSERT_TRUE(tool.taken());
    for (const double y : {0.35, 0.45, 0.55}) {
        TransferStudio::drag(tool, studio.at(0.3, y), studio.at(0.7, y));
        ASSERT_TRUE(studio.rested());
    }
    const Transfer after = studio.transfer();
    ASSERT_EQ(after.opacity.size(), 2U);
    EXPECT_LT(after.opacity[1].x, layer.transfer.opacity[1].x);
    EXPECT_NEAR(after.opacity[1].x - after.opacity[0].x, kRamp, 1e-6) << "as steep as it was";
    EXPECT_FALSE(studio.window->document().gestureOngoing());
    const std::size_t now = studio.window->document().history().position();
    EXPECT_GT(now, steps);
    EXPECT_LE(now, steps + 3) << "a drag is one step";
    while (studio.window->document().history().position() > steps)
        studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure(), start);
    studio.trigger("edit.scissors");
    EXPECT_FALSE(tool.taken()) << "one tool has the mouse";
    EXPECT_FALSE(studio.window->actions().at("edit.widen-range")->isChecked());
}

} // namespace
} // namespace limner
