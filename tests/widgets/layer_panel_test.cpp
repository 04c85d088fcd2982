#include "widgets/layer_panel.h"

#include "widgets/layer_form.h"
#include "widgets/layer_list.h"
#include "widgets/layer_parts_form.h"
#include "widgets/layer_rows.h"
#include "widgets/part_form.h"
#include "widgets/style_gallery.h"
#include "widgets/test_figure.h"
#include "widgets/transfer_editor_1d.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QDropEvent>
#include <QMimeData>
#include <QSlider>
#include <QTest>

namespace limner {
namespace {

struct Panel {
    Panel() {
        panel.resize(380, 700);
        QObject::connect(&panel, &LayerPanel::edited, [this](const Edit& edit) {
            edits.push_back(edit);
            history.apply(edit);
            show();
        });
        panel.show();
        panel.activateWindow(); // its keys are shortcuts
        if (!QTest::qWaitForWindowActive(&panel))
            ADD_FAILURE() << "the panel gets no keys";
        show();
    }
    void show() { panel.setFigure(history.current()); }
    void undo() {
        history.undo();
        show();
    }
    [[nodiscard]] LayerRows& rows() { return *panel.layers()->list(); }
    [[nodiscard]] LayerList& layers() { return *panel.layers(); }
    [[nodiscard]] const Layer& layer(std::size_t i) const { return history.current()->layers.at(i); }
    [[nodiscard]] std::string names() const {
        std::string text;
        for (const Layer& layer : history.current()->layers)
            text += layer.name + " ";
        return text;
    }
    void clickOn(const QRect& place) {
        QTest::mouseClick(rows().viewport(), Qt::LeftButton, Qt::NoModifier, place.center());
    }
    /// Drops a row onto a place of the list.
    void drop(int row, QPoint at) {
        QMimeData data;
        data.setData(LayerRows::kMime, QByteArray::number(row));
        QDragEnterEvent enter(at, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(rows().viewport(), &enter);
        QDropEvent event(at, Qt::MoveAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(rows().viewport(), &event);
    }

    LayerPanel panel;
    History history{testing::smallFigure()};
    std::vector<Edit> edits;
};

TEST(LayerList, TheCheckMarkHidesAndTheSliderMerges) {
    Panel panel;
    std::size_t selected = 0;
    QObject::connect(&panel.panel, &LayerPanel::layerSelected, [&](std::size_t layer) { selected = layer; });
    EXPECT_EQ(panel.rows().count(), 2);
    panel.rows().item(1)->setCheckState(Qt::Unchecked);
    EXPECT_FALSE(panel.layer(1).visible);
    panel.rows().setCurrentRow(1);
    EXPECT_EQ(selected, 1U);
    for (int value = 190; value >= 100; value -= 10)
        panel.panel.form()->opacity()->setValue(value);
    EXPECT_EQ(panel.layer(1).opacity, 0.5);
    EXPECT_EQ(panel.layer(0).opacity, 1);
    EXPECT_EQ(panel.history.position(), 2U) << "one step for the check mark, one for the slider";
    panel.rows().item(0)->setText("Skeleton");
    EXPECT_EQ(panel.layer(0).name, "Skeleton");
}

TEST(LayerList, TheSwitchesOfARowSoloAndLockIt) {
    Panel panel;
    const Figure start = *panel.history.current();
    panel.clickOn(panel.rows().soloRect(1));
    EXPECT_TRUE(panel.layer(1).solo);
    EXPECT_FALSE(panel.layer(0).solo);
    EXPECT_EQ(panel.layers().selectedLayer(), 0U) << "a switch selects nothing";
    panel.clickOn(panel.rows().lockRect(0));
    EXPECT_TRUE(panel.layer(0).locked);
    EXPECT_FALSE(panel.layer(1).locked);
    EXPECT_EQ(panel.history.position(), 2U);
    panel.clickOn(panel.rows().soloRect(1));
    EXPECT_FALSE(panel.layer(1).solo);
    for (int i = 0; i < 3; ++i)
        panel.undo();
    EXPECT_EQ(*panel.history.current(), start);
}

TEST(LayerList, LayersAreAddedCopiedAndDeletedInOneStepEach) {
    Panel panel;
    const Figure start = *panel.history.current();
    panel.layers().duplicate()->trigger();
    EXPECT_EQ(panel.names(), "Bone Bone 2 Skin ");
    EXPECT_EQ(panel.layers().selectedLayer(), 1U) << "the copy is chosen";
    panel.layers().add()->trigger();
    EXPECT_EQ(panel.names(), "Bone Bone 2 Layer Skin ");
    EXPECT_EQ(panel.layers().selectedLayer(), 2U);
    EXPECT_FALSE(panel.layer(2).transfer.opacity.empty()) << "something is to be seen";
    panel.layers().remove()->trigger();
    EXPECT_EQ(panel.names(), "Bone Bone 2 Skin ");
    panel.rows().setFocus();
    QTest::keyClick(&panel.rows(), Qt::Key_Delete);
    EXPECT_EQ(panel.names(), "Bone Bone 2 ");
    EXPECT_EQ(panel.layers().selectedLayer(), 1U);
    EXPECT_EQ(panel.history.position(), 4U);
    for (int i = 0; i < 4; ++i)
        panel.undo();
    EXPECT_EQ(*panel.history.current(), start);
    panel.layers().remove()->trigger();
    panel.layers().remove()->trigger();
    EXPECT_TRUE(panel.history.current()->layers.empty());
    EXPECT_FALSE(panel.layers().remove()->isEnabled());
    EXPECT_FALSE(panel.panel.form()->isEnabled());
    panel.layers().add()->trigger();
    EXPECT_EQ(panel.names(), "Layer ");
}

TEST(LayerList, KeysButtonsAndDropsReorder) {
    Panel panel;
    panel.layers().duplicate()->trigger();
    ASSERT_EQ(panel.names(), "Bone Bone 2 Skin ");
    panel.layers().down()->trigger();
    EXPECT_EQ(panel.names(), "Bone Skin Bone 2 ");
    EXPECT_EQ(panel.layers().selectedLayer(), 2U) << "the choice goes along";
    EXPECT_FALSE(panel.layers().down()->isEnabled());
    panel.rows().setFocus();
    QTest::keyClick(&panel.rows(), Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(panel.names(), "Bone Bone 2 Skin ");
    const auto edge = [&](int row, bool lower) {
        const QRect rect = panel.rows().visualItemRect(panel.rows().item(row));
        return QPoint(rect.center().x(), lower ? rect.bottom() - 2 : rect.top() + 2);
    };
    panel.drop(0, edge(1, true));
    EXPECT_EQ(panel.names(), "Bone 2 Bone Skin ");
    panel.drop(2, edge(0, false));
    EXPECT_EQ(panel.names(), "Skin Bone 2 Bone ");
    EXPECT_EQ(panel.layers().selectedLayer(), 0U);
    const std::size_t steps = panel.history.position();
    panel.drop(1, edge(1, true));
    EXPECT_EQ(panel.history.position(), steps) << "in its own place";
    panel.drop(0, QPoint(5, panel.rows().viewport()->height() - 1));
    EXPECT_EQ(panel.names(), "Bone 2 Bone Skin ") << "below all rows: the last";
    panel.undo();
    EXPECT_EQ(panel.names(), "Skin Bone 2 Bone ");
}

TEST(LayerList, ALockedLayerStaysAsItIs) {
    Panel panel;
    panel.layers().lock()->trigger();
    ASSERT_TRUE(panel.layer(0).locked);
    const Figure locked = *panel.history.current();
    EXPECT_FALSE(panel.panel.form()->isEnabled());
    EXPECT_FALSE(panel.panel.parts()->part("/layers/*/tone")->isEnabled());
    EXPECT_TRUE(panel.panel.depthCues()->part("/depth_cues/halo")->isEnabled()) << "it is the figure's";
    EXPECT_FALSE(panel.layers().remove()->isEnabled());
    EXPECT_TRUE(panel.layers().remove()->toolTip().contains("locked")) << "says why";
    EXPECT_FALSE(panel.layers().down()->isEnabled());
    EXPECT_FALSE(panel.rows().item(0)->flags().testFlag(Qt::ItemIsEditable));
    EXPECT_FALSE(panel.rows().item(0)->flags().testFlag(Qt::ItemIsDragEnabled));
    panel.drop(0, QPoint(5, panel.rows().viewport()->height() - 1));
    EXPECT_EQ(panel.names(), "Bone Skin ");
    panel.rows().item(0)->setText("Other");
    panel.panel.form()->opacity()->setValue(20);
    panel.panel.parts()->part("/layers/*/tone")->present()->click();
    panel.rows().setFocus();
    QTest::keyClick(&panel.rows(), Qt::Key_Delete);
    EXPECT_EQ(*panel.history.current(), locked);
    panel.rows().item(0)->setCheckState(Qt::Unchecked);
    EXPECT_FALSE(panel.layer(0).visible) << "it can be hidden";
    panel.rows().setCurrentRow(1);
    EXPECT_TRUE(panel.panel.form()->isEnabled());
    EXPECT_FALSE(panel.layers().remove()->toolTip().contains("locked"));
    panel.clickOn(panel.rows().lockRect(0));
    EXPECT_FALSE(panel.layer(0).locked) << "it can be unlocked";
}

TEST(LayerList, EditorsOfTheTransferFunctionRespectTheLock) {
    Figure figure = testing::smallFigure();
    figure.layers[0].locked = true;
    auto shared = std::make_shared<const Figure>(figure);
    TransferEditor1d editor;
    StyleGallery gallery;
    int edits = 0;
    QObject::connect(&editor, &TransferEditor1d::edited, [&] { ++edits; });
    QObject::connect(&gallery, &StyleGallery::edited, [&] { ++edits; });
    gallery.setSource([](const std::string& key) {
        auto style = std::make_shared<Style>();
        style->card.id = styleIdOf(key);
        style->sphere = testing::plainSphere(0, 0, 0);
        return style;
    });
    for (const std::size_t layer : {0U, 1U}) {
        editor.setFigure(shared, layer);
        gallery.setFigure(shared, layer, {});
        EXPECT_EQ(editor.canvas()->isEnabled(), layer == 1);
        EXPECT_EQ(gallery.place().has_value(), layer == 1);
        editor.canvas()->select(TransferCanvas::Handle{TransferCanvas::HandleKind::point, 1});
        editor.canvas()->moveSelected(300, 0.2);
        editor.canvas()->addPointAfterSelected();
        editor.canvas()->removeSelected();
        Q_EMIT gallery.list()->useWanted("bundled:ink");
        EXPECT_EQ(edits, layer == 1 ? 4 : 0);
    }
}

} // namespace
} // namespace limner
