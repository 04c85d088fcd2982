#include "widgets/transfer_canvas_2d.h"

#include "core/figure/figure_json.h"
#include "core/style/transfer_function.h"
#include "widgets/style_mime.h"
#include "widgets/test_figure.h"
#include "widgets/tissue_hints.h"
#include "widgets/transfer_editor.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QMimeData>
#include <QTest>
#include <QToolButton>

namespace limner {
namespace {

using Handle = TransferCanvas2d::Handle;
using Kind = TransferCanvas2d::HandleKind;

/// The bone layer over value and gradient, without shapes but one.
Figure planeFigure(const char* kind = "rectangle") {
    Figure figure = testing::smallFigure();
    Transfer& t = figure.layers[0].transfer;
    t = {};
    t.kind = TransferKind::twoDimensional;
    t.axes = {"value", "gradient"};
    t.grid = TransferGrid{{-200, 600}, {0.25, 0.75}, {{"ivory", "#804020"}, {"#ff0000", "ivory"}}};
    t.opacity2d = {freshShape(kind, {{-100, 0.3}, {500, 0.7}})};
    return figure;
}

struct Edited {
    explicit Edited(const Figure& start = planeFigure()) : history(start) {
        editor.resize(460, 560);
        QObject::connect(&editor, &TransferEditor::edited, [this](const Edit& edit) {
            ongoing += edit.ongoing ? 1 : 0;
            last = edit;
            history.apply(edit);
            show();
        });
        show();
        editor.show();
        QTest::qWait(0);
        canvas().showAll();
    }
    void show() {
        line->setFigure(history.current(), 0);
        editor.setFigure(history.current(), 0);
    }
    [[nodiscard]] const Transfer& transfer() const { return history.current()->layers[0].transfer; }
    [[nodiscard]] const OpacityShape& shape(std::size_t i = 0) const { return transfer().opacity2d[i]; }
    [[nodiscard]] TransferCanvas2d& canvas() { return *editor.plane()->canvas(); }
    void drag(QPointF from, QPointF by, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, from.toPoint());
        for (int i = 1; i <= 4; ++i) {
            const QPointF at(from.toPoint() + (by * i / 4).toPoint());
            QMouseEvent move(QEvent::MouseMove, at, canvas().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
            QApplication::sendEvent(&canvas(), &move);
        }
        QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, (from.toPoint() + by.toPoint()));
    }
    /// The first problem of the layer that would keep the figure from being drawn.
    [[nodiscard]] std::string problem() const {
        for (const Problem& one : validateFigure(*history.current()))
            if (one.fatal)
                return one.pointer + ": " + one.why;
        return {};
    }
    History history;
    TransferEditor1d* line = new TransferEditor1d; // the editor's, once it is given
    TransferEditor editor{line};
    Edit last;
    int ongoing = 0;
};

TEST(TransferCanvas2d, EveryShapeIsDrawnByDraggingItsTool) {
    for (const PlaneTool tool : {PlaneTool::rectangle, PlaneTool::trapezoid, PlaneTool::ellipse, PlaneTool::polygon}) {
        Edited e;
        e.editor.plane()->button(tool)->click();
        const QPointF a = e.canvas().positionAt({600, 0.9});
        const QPointF b = e.canvas().positionAt({900, 0.2});
        e.drag(a, b - a);
        ASSERT_EQ(e.transfer().opacity2d.size(), 2U);
        const PlaneBox box = boxOf(e.shape(1));
        EXPECT_NEAR(box.low.x, 600, 8);
        EXPECT_NEAR(box.high.x, 900, 8);
        EXPECT_NEAR(box.low.y, 0.2, 0.01);
        EXPECT_NEAR(box.high.y, 0.9, 0.01);
        EXPECT_EQ(e.history.position(), 1U) << "one step";
        EXPECT_GT(e.ongoing, 1) << "seen while the hand moves";
        EXPECT_FALSE(e.last.ongoing);
        EXPECT_EQ(e.canvas().selectedShape(), 1U);
        EXPECT_EQ(e.canvas().tool(), PlaneTool::select);
        EXPECT_TRUE(e.editor.plane()->button(PlaneTool::select)->isChecked());
        EXPECT_EQ(e.problem(), "");
    }
}

TEST(TransferCanvas2d, EveryShapeMovesAndResizesByMouseAndKeys) {
    for (const char* kind : {"rectangle", "trapezoid", "ellipse", "polygon", "mask"}) {
        Figure start = planeFigure(kind);
        if (std::string(kind) == "mask")
            start.layers[0].transfer.opacity2d[0].values.assign(64 * 64, 1.0);
        Edited e(start);
        const OpacityShape before = e.shape();
        e.drag(e.canvas().positionAt({215, 0.52}), {40, -20});
        const PlaneBox moved = boxOf(e.shape());
        EXPECT_GT(moved.low.x, -100) << kind;
        EXPECT_GT(moved.low.y, 0.3) << kind;
        EXPECT_NEAR(moved.high.x - moved.low.x, 600, 1e-6) << kind;
        EXPECT_EQ(e.history.position(), 1U) << kind;
        ASSERT_EQ(e.canvas().selected(), (Handle{Kind::shape, 0, 0})) << kind;
        const Handle corner{Kind::corner, 0, 1};
        const glm::dvec2 was = *e.canvas().placeOf(corner);
        e.drag(*e.canvas().positionOf(corner), {-30, -15});
        EXPECT_LT(e.canvas().placeOf(corner)->x, was.x) << kind;
        EXPECT_EQ(e.history.position(), 2U) << kind;
        const PlaneBox sized = boxOf(e.shape());
        e.canvas().select(Handle{Kind::shape, 0, 0});
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(&e.canvas(), Qt::Key_Right);
        EXPECT_GT(boxOf(e.shape()).low.x, sized.low.x) << kind;
        EXPECT_EQ(e.history.position(), 3U) << "a run of key presses is one step";
        while (e.history.canUndo())
            e.history.undo();
        EXPECT_EQ(e.shape(), before);
    }
}

TEST(TransferCanvas2d, PolygonsGainPointsByDoubleClickAndLoseThemByDelete) {
    Edited e(planeFigure("polygon"));
    QTest::mouseDClick(&e.canvas(), Qt::LeftButton, {}, e.canvas().positionAt({300, 0.58}).toPoint());
    ASSERT_EQ(e.shape().x.size(), 5U);
    ASSERT_EQ(e.canvas().selected()->kind, Kind::corner);
    QTest::keyClick(&e.canvas(), Qt::Key_Delete);
    EXPECT_EQ(e.shape().x.size(), 4U);
    EXPECT_EQ(e.transfer().opacity2d.size(), 1U);
}

TEST(TransferCanvas2d, AMaskIsPaintedAndErasedAsOneStepEach) {
    Edited e;
    e.editor.plane()->button(PlaneTool::paint)->click();
    e.canvas().setBrush({10, 0});
    const QPointF from = e.canvas().positionAt({600, 0.5});
    e.drag(from, {60, 0});
    ASSERT_EQ(e.transfer().opacity2d.size(), 2U);
    EXPECT_EQ(e.shape(1).shape, "mask");
    EXPECT_EQ(e.history.position(), 1U);
    const glm::dvec2 middle = e.canvas().placeAt(from + QPointF(30, 0));
    EXPECT_GT(membershipAt(e.shape(1), middle), 0.9);
    EXPECT_EQ(membershipAt(e.shape(1), e.canvas().placeAt(from + QPointF(30, 60))), 0);
    e.editor.plane()->button(PlaneTool::erase)->click();
    e.drag(from + QPointF(20, 0), {20, 0});
    EXPECT_LT(membershipAt(e.shape(1), middle), 0.1);
    EXPECT_EQ(e.transfer().opacity2d.size(), 2U) << "the same mask";
    EXPECT_EQ(e.history.position(), 2U);
    EXPECT_EQ(e.problem(), "");
    QTest::keyClick(&e.canvas(), Qt::Key_Escape);
    EXPECT_EQ(e.canvas().tool(), PlaneTool::select);
}

TEST(TransferCanvas2d, KeysReachEveryHandleAndDoAll) {
    Edited e;
    e.canvas().setFocus();
    std::vector<Handle> seen;
    for (int i = 0; i < 13; ++i) {
        QTest::keyClick(&e.canvas(), Qt::Key_Right, Qt::ControlModifier);
        seen.push_back(*e.canvas().selected());
    }
    EXPECT_EQ(seen[0], (Handle{Kind::shape, 0, 0}));
    EXPECT_EQ(seen[8], (Handle{Kind::corner, 0, 7}));
    EXPECT_EQ(seen[9], (Handle{Kind::node, 0, 0})) << "after the eight handles of the box";
    e.canvas().select(Handle{Kind::shape, 0, 0});
    QTest::keyClick(&e.canvas(), Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(e.transfer().opacity2d.size(), 2U);
    QTest::keyClick(&e.canvas(), Qt::Key_Insert);
    EXPECT_EQ(e.transfer().opacity2d.size(), 3U);
    for (int i = 0; i < 3; ++i) {
        e.canvas().select(Handle{Kind::shape, 0, 0});
        QTest::keyClick(&e.canvas(), Qt::Key_Delete);
    }
    EXPECT_TRUE(e.transfer().opacity2d.empty());
    EXPECT_EQ(opacity2dAt(e.transfer(), 200, 0.5), 0) << "without shapes nothing shows, not everything";
    QTest::keyClick(&e.canvas(), Qt::Key_Insert);
    EXPECT_GT(
        opacity2dAt(e.transfer(), boxOf(e.shape()).low.x + 1, (boxOf(e.shape()).low.y + boxOf(e.shape()).high.y) / 2),
        0);
}

TEST(TransferCanvas2d, NumbersShowAndSetTheSelectedShape) {
    Edited e;
    e.canvas().select(Handle{Kind::shape, 0, 0});
    EXPECT_EQ(e.editor.plane()->opacity()->value(), 80);
    e.editor.plane()->opacity()->setValue(35);
    e.editor.plane()->softness()->setValue(50);
    EXPECT_NEAR(e.shape().opacity, 0.35, 1e-12);
    EXPECT_NEAR(e.shape().soft, 0.5, 1e-12);
    EXPECT_EQ(e.history.position(), 2U);
}

TEST(TransferCanvas2d, BallsMoveColumnsAndRowsAndTheGridGrows) {
    Edited e;
    const auto node = [&](std::size_t i) { return Handle{Kind::node, i, 0}; };
    e.drag(*e.canvas().positionOf(node(3)), {-25, 15});
    EXPECT_LT(e.transfer().grid->x[1], 600);
    EXPECT_LT(e.transfer().grid->y[1], 0.75);
    EXPECT_EQ(e.transfer().grid->x[0], -200);
    EXPECT_EQ(e.history.position(), 1U);
    e.canvas().select(node(0));
    e.canvas().addColumn();
    ASSERT_EQ(e.transfer().grid->x.size(), 3U);
    EXPECT_EQ(e.transfer().grid->styles[1][1], "#ff0000") << "the new column looks like the one beside it";
    e.canvas().addRow();
    EXPECT_EQ(e.transfer().grid->y.size(), 3U);
    EXPECT_EQ(e.problem(), "");
    e.canvas().select(node(1));
    e.canvas().removeColumn();
    e.canvas().select(node(0));
    e.canvas().removeRow();
    EXPECT_EQ(e.transfer().grid->x.size(), 2U);
    EXPECT_EQ(e.transfer().grid->y.size(), 2U);
    EXPECT_EQ(e.problem(), "");
}

TEST(TransferCanvas2d, ADroppedStyleGoesOntoTheNearestBall) {
    Edited e;
    e.canvas().setStyleSource([](const std::string&) {
        auto style = std::make_shared<Style>();
        style->card.id = "ink";
        style->file = "/styles/ink.png";
        style->sphere = testing::plainSphere(0, 0, 0);
        return style;
    });
    QMimeData data;
    data.setData(kStyleMime, "mine:ink");
    const QPointF at = *e.canvas().positionOf({Kind::node, 1, 0}) + QPointF(6, -6);
    QDragEnterEvent enter(at.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&e.canvas(), &enter);
    QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&e.canvas(), &event);
    EXPECT_EQ(e.transfer().grid->styles,
              (std::vector<std::vector<std::string>>{{"ivory", "ink"}, {"#ff0000", "ivory"}}));
    EXPECT_EQ(e.canvas().selectedNode(), 1U);
}

TEST(TransferCanvas2d, LockedLayersStayAsTheyAre) {
    Figure figure = planeFigure();
    figure.layers[0].locked = true;
    Edited e(figure);
    e.canvas().setEnabled(true); // even then
    e.drag(e.canvas().positionAt({215, 0.52}), {40, -20});
    e.canvas().addShape();
    e.canvas().addColumn();
    e.canvas().setOpacity(0.1);
    QTest::keyClick(&e.canvas(), Qt::Key_Delete);
    EXPECT_EQ(*e.history.current(), figure);
}

TEST(TransferCanvas2d, HintsOfTissuesZoomBothEditors) {
    Edited e;
    const TissueHint& bone = tissueHints()[5];
    EXPECT_EQ(tissueWords(bone).contains("300"), true);
    const auto at = e.canvas().positionOf(bone);
    ASSERT_TRUE(at);
    QTest::mouseClick(&e.canvas(), Qt::LeftButton, {}, at->toPoint());
    EXPECT_LT(e.canvas().shownValues().low, 300);
    EXPECT_GT(e.canvas().shownValues().low, -1000);
    EXPECT_GT(e.canvas().shownValues().high, 1900);
    const ValueRange bones = e.canvas().shownValues();
    QTest::keyClick(&e.canvas(), Qt::Key_Plus);
    EXPECT_LT(e.canvas().shownValues().high - e.canvas().shownValues().low, bones.high - bones.low);
    QTest::keyClick(&e.canvas(), Qt::Key_Home);
    EXPECT_LE(e.canvas().shownValues().low, -1000);
    Figure plain = testing::smallFigure();
    e.history = History(plain);
    e.show();
    QTest::qWait(0);
    TransferCanvas& line = *e.line->canvas();
    QTest::mouseClick(&line, Qt::LeftButton, {}, line.positionOf(bone)->toPoint());
    EXPECT_EQ(line.shownValues().low, bones.low);
    EXPECT_EQ(line.shownValues().high, bones.high);
    EXPECT_EQ(e.history.position(), 0U) << "a zoom is no edit";
}

TEST(TransferEditor, TheSecondAxisMakesAPlaneAndItsAbsenceALine) {
    Figure figure = testing::smallFigure();
    figure.layers[0].transfer.opacity = {{150, 0}, {250, 0.9}, {800, 0.9}, {900, 0}};
    Edited e(figure);
    EXPECT_FALSE(e.editor.showsPlane());
    const auto choose = [&](QComboBox* box, const char* word) {
        box->setCurrentIndex(box->findData(QString(word)));
        Q_EMIT box->activated(box->currentIndex());
    };
    choose(e.editor.secondAxisBox(), "gradient");
    EXPECT_TRUE(e.editor.showsPlane());
    EXPECT_EQ(e.transfer().kind, TransferKind::twoDimensional);
    EXPECT_EQ(e.shape().x, (std::vector<double>{150, 250, 800, 900}));
    EXPECT_EQ(e.problem(), "");
    choose(e.editor.secondAxisBox(), "distance");
    EXPECT_EQ(e.transfer().axes[1], "distance");
    EXPECT_EQ(e.problem(), "") << "distances have a middle to start from";
    choose(e.editor.secondAxisBox(), "");
    EXPECT_FALSE(e.editor.showsPlane());
    EXPECT_EQ(e.transfer().opacity, figure.layers[0].transfer.opacity);
    EXPECT_EQ(e.transfer().nodes, figure.layers[0].transfer.nodes);
    EXPECT_EQ(e.history.position(), 3U);
    for (int i = 0; i < 3; ++i)
        e.history.undo();
    EXPECT_EQ(*e.history.current(), figure);
}

TEST(TransferEditor, SaysWhatAnAxisLacks) {
    Figure figure = planeFigure();
    figure.layers[0].transfer.axes = {"value", "label"};
    Edited e(figure);
    EXPECT_TRUE(e.editor.note().contains("labels"));
    Edited whole;
    EXPECT_EQ(whole.editor.note(), "");
    const int label = whole.editor.secondAxisBox()->findData(QString("label"));
    EXPECT_TRUE(whole.editor.secondAxisBox()->itemData(label, Qt::ToolTipRole).toString().contains("labels"));
}

TEST(TransferEditor, TheCurvesCourseIsAnEdit) {
    Edited e(testing::smallFigure());
    QObject::connect(e.line, &TransferEditor1d::edited, [&](const Edit& edit) {
        e.history.apply(edit);
        e.show();
    });
    QComboBox* box = e.line->curve();
    box->setCurrentIndex(box->findData(QString("smooth")));
    Q_EMIT box->activated(box->currentIndex());
    EXPECT_EQ(e.transfer().curve, OpacityCurve::smooth);
    EXPECT_EQ(e.history.position(), 1U);
    e.editor.grab();
}

} // namespace
} // namespace limner
