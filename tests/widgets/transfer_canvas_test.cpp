#include "widgets/transfer_canvas.h"

#include "core/style/transfer_function.h"
#include "widgets/style_mime.h"
#include "widgets/test_figure.h"
#include "widgets/transfer_editor_1d.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QMimeData>
#include <QTest>

namespace limner {
namespace {

using Handle = TransferCanvas::Handle;
using Kind = TransferCanvas::HandleKind;

struct Edited {
    Edited() {
        editor.resize(460, 360);
        history = History(testing::smallFigure());
        editor.setFigure(history.current(), 0);
        QObject::connect(&editor, &TransferEditor1d::edited, [this](const Edit& edit) {
            history.apply(edit);
            editor.setFigure(history.current(), 0);
        });
        editor.show();
        QTest::qWait(0);
    }
    [[nodiscard]] const Transfer& transfer() const { return history.current()->layers[0].transfer; }
    [[nodiscard]] TransferCanvas& canvas() { return *editor.canvas(); }
    void drag(const Handle& handle, QPoint by) {
        const QPoint from = canvas().positionOf(handle)->toPoint();
        QTest::mousePress(&canvas(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= 5; ++i) {
            const QPointF at(from + by * i / 5);
            QMouseEvent move(QEvent::MouseMove, at, canvas().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(&canvas(), &move);
        }
        QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, from + by);
    }
    TransferEditor1d editor;
    History history;
};

TEST(TransferCanvas, ADraggedPointIsOneStepAndFollowsThePointer) {
    Edited e;
    const Transfer before = e.transfer();
    const QPointF start = *e.canvas().positionOf({Kind::point, 1});
    e.drag({Kind::point, 1}, {15, 40});
    EXPECT_GT(e.transfer().opacity[1].x, before.opacity[1].x);
    EXPECT_LT(e.transfer().opacity[1].y, before.opacity[1].y);
    const QPointF end = *e.canvas().positionOf({Kind::point, 1});
    EXPECT_NEAR(end.x() - start.x(), 15, 1);
    EXPECT_NEAR(end.y() - start.y(), 40, 1);
    EXPECT_EQ(e.history.position(), 1U);
    e.history.undo();
    EXPECT_EQ(e.transfer(), before);
}

TEST(TransferCanvas, PointsStayInOrderAndInRange) {
    Edited e;
    e.drag({Kind::point, 1}, {-400, -400});
    EXPECT_EQ(e.transfer().opacity[1].x, e.transfer().opacity[0].x) << "two points at one value are a step";
    EXPECT_EQ(e.transfer().opacity[1].y, 1);
    EXPECT_EQ(e.transfer().opacity.size(), 3U);
}

TEST(TransferCanvas, ADoubleClickAddsAndDeleteRemoves) {
    Edited e;
    const QPointF a = *e.canvas().positionOf({Kind::point, 1});
    const QPointF b = *e.canvas().positionOf({Kind::point, 2});
    QTest::mouseDClick(&e.canvas(), Qt::LeftButton, {}, QPoint(((a + b) / 2).x(), 60));
    ASSERT_EQ(e.transfer().opacity.size(), 4U);
    EXPECT_EQ(e.canvas().selected(), (Handle{Kind::point, 2}));
    QTest::keyClick(&e.canvas(), Qt::Key_Delete);
    EXPECT_EQ(e.transfer().opacity.size(), 3U);
}

TEST(TransferCanvas, StylesAreDraggedAlongTheirRail) {
    Edited e;
    e.drag({Kind::node, 1}, {-40, -30});
    EXPECT_LT(e.transfer().nodes[1].at, 900);
    EXPECT_GE(e.transfer().nodes[1].at, 200);
    EXPECT_EQ(e.editor.selectedNode(), 1U);
    QTest::keyClick(&e.canvas(), Qt::Key_Delete);
    EXPECT_EQ(e.transfer().nodes.size(), 1U);
    e.canvas().select(Handle{Kind::node, 0});
    QTest::keyClick(&e.canvas(), Qt::Key_Delete);
    EXPECT_EQ(e.transfer().nodes.size(), 1U) << "the last style stays";
}

TEST(TransferCanvas, ALineBetweenPointsMovesAsAWhole) {
    Edited e;
    const Transfer before = e.transfer();
    const QPointF a = *e.canvas().positionOf({Kind::point, 0});
    const QPointF b = *e.canvas().positionOf({Kind::point, 1});
    const QPoint middle = ((a + b) / 2).toPoint();
    QTest::mousePress(&e.canvas(), Qt::LeftButton, {}, middle);
    const QPointF to = middle + QPoint(20, 0);
    QMouseEvent move(QEvent::MouseMove, to, e.canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&e.canvas(), &move);
    QTest::mouseRelease(&e.canvas(), Qt::LeftButton, {}, to.toPoint());
    const double by = e.transfer().opacity[0].x - before.opacity[0].x;
    EXPECT_GT(by, 0);
    EXPECT_NEAR(e.transfer().opacity[1].x - before.opacity[1].x, by, 1e-9);
    EXPECT_EQ(e.transfer().opacity[2], before.opacity[2]);
}

TEST(TransferCanvas, KeysReachEveryHandleAndNudge) {
    Edited e;
    e.canvas().setFocus();
    for (int i = 0; i < 2; ++i)
        QTest::keyClick(&e.canvas(), Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(e.canvas().selected(), (Handle{Kind::point, 1}));
    const double before = e.transfer().opacity[1].y;
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&e.canvas(), Qt::Key_Down);
    EXPECT_NEAR(e.transfer().opacity[1].y, before - 0.03, 1e-12);
    EXPECT_EQ(e.history.position(), 1U) << "a run of key presses is one step";
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&e.canvas(), Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(e.canvas().selected(), (Handle{Kind::node, 1}));
}

TEST(TransferCanvas, AStepJumps) {
    Edited e;
    e.canvas().select(Handle{Kind::point, 2});
    e.canvas().makeStepAtSelected();
    ASSERT_EQ(e.transfer().opacity.size(), 4U);
    EXPECT_EQ(opacityAt(e.transfer().opacity, 999), 0.9);
    EXPECT_EQ(opacityAt(e.transfer().opacity, 1000), 1);
}

/// Keys go through the source that the studio gives: onto a ball, or where the value is.
TEST(TransferCanvas, ADroppedStyleIsResolvedByItsKey) {
    Edited e;
    QMimeData data;
    data.setData(kStyleMime, "mine:ink");
    const auto drop = [&](QPointF at) {
        QDragEnterEvent enter(at.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&e.canvas(), &enter);
        QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&e.canvas(), &event);
    };
    const QPointF ball = *e.canvas().positionOf({Kind::node, 1});
    drop(ball);
    EXPECT_EQ(e.history.position(), 0U) << "without a source nothing can be dropped";
    std::string asked;
    e.editor.setStyleSource([&](const std::string& key) {
        asked = key;
        auto style = std::make_shared<Style>();
        style->card.id = "ink";
        style->file = "/styles/ink.png";
        style->sphere = testing::plainSphere(0, 0, 0);
        return style;
    });
    drop(ball);
    EXPECT_EQ(asked, "mine:ink");
    EXPECT_EQ(e.transfer().nodes[1].style, "ink");
    EXPECT_EQ(e.history.current()->findStyle("ink")->file, "/styles/ink.png");
    drop(ball - QPointF(60, 0));
    EXPECT_EQ(e.transfer().nodes.size(), 3U);
    e.editor.setStyleSource([](const std::string&) { return nullptr; });
    drop(ball);
    EXPECT_EQ(e.history.position(), 2U) << "a style that is no more";
}

TEST(TransferCanvas, FieldsShowAndSetTheSelectedPoint) {
    Edited e;
    e.canvas().select(Handle{Kind::point, 1});
    const auto fields = e.editor.findChildren<QDoubleSpinBox*>();
    ASSERT_EQ(fields.size(), 2);
    EXPECT_EQ(fields[0]->value(), 250);
    EXPECT_EQ(fields[0]->suffix(), " HU");
    EXPECT_EQ(fields[1]->value(), 90);
    fields[0]->setValue(400);
    fields[1]->setValue(50);
    EXPECT_EQ(e.transfer().opacity[1], glm::dvec2(400, 0.5));
}

TEST(TransferCanvas, TwoDimensionalFunctionsAreLeftAlone) {
    Edited e;
    Figure figure = testing::smallFigure();
    figure.layers[0].transfer.kind = TransferKind::twoDimensional;
    e.history = History(figure);
    e.editor.setFigure(e.history.current(), 0);
    QTest::mouseDClick(&e.canvas(), Qt::LeftButton, {}, {200, 60});
    QTest::keyClick(&e.canvas(), Qt::Key_Delete);
    e.editor.grab();
    EXPECT_EQ(*e.history.current(), figure);
}

TEST(TransferCanvas, RulerTextsAreShortAndNeverMinusZero) {
    QLocale::setDefault(QLocale::c());
    EXPECT_EQ(valueText(-0.2, 10), "0");
    EXPECT_EQ(valueText(250, 10), "250");
    EXPECT_EQ(valueText(0.125, 0.005), "0.125");
}

} // namespace
} // namespace limner
