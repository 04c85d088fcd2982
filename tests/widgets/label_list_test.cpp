#include "widgets/label_list.h"

#include "core/figure/label_look.h"
#include "core/project/history.h"
#include "support/make_volume.h"
#include "support/qt/qt_events.h"
#include "widgets/preset_menu.h"
#include "widgets/test_figure.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QListWidget>
#include <QTest>
#include <QToolButton>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;
using testing::pumpUntil;

/// Labels 1 to `count`, 10 voxels each, in slices along x; 0 in the first.
LabelReference labels(int count) {
    LabelReference reference;
    reference.data =
        makeVolume<std::uint8_t>(gridOf({count + 1, 5, 2}), VoxelType::uint8, [](glm::ivec3 v) { return v.x; });
    reference.names = {{"1", "femur"}, {"2", "tibia"}};
    reference.colours = {{"1", "#102030"}};
    return reference;
}

struct Panel {
    explicit Panel(int count, Figure figure = testing::smallFigure()) {
        figure.labels = labels(count);
        history = History(figure);
        QObject::connect(&list, &LabelList::edited, [this](const Edit& edit) {
            history.apply(edit);
            list.setFigure(history.current(), layer);
        });
        show();
        EXPECT_TRUE(pumpUntil([&] { return list.list()->count() == count; }));
        QTest::qWait(0);
    }
    void show() {
        list.setFigure(history.current(), layer);
        list.resize(300, 500);
    }
    [[nodiscard]] QListWidgetItem* row(int i) const { return list.list()->item(i); }
    [[nodiscard]] const std::optional<std::vector<int>>& shown() const {
        return history.current()->layers[layer].labels;
    }

    LabelList list;
    History history;
    std::size_t layer = 0;
};

TEST(LabelList, HasNamesColoursAndNumbersOfWhatOccurs) {
    Panel panel(3);
    EXPECT_EQ(panel.row(0)->text(), "femur");
    EXPECT_EQ(panel.row(2)->text(), "Label 3");
    EXPECT_TRUE(panel.row(2)->toolTip().contains("10 voxels"));
    const QImage chip = panel.row(0)->icon().pixmap(14, 14).toImage();
    EXPECT_EQ(chip.pixelColor(chip.rect().center()), QColor("#102030"));
    EXPECT_EQ(panel.row(2)->icon().pixmap(14, 14).toImage().pixelColor(7, 7).alpha(), 0);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(panel.row(i)->checkState(), Qt::Checked);
}

TEST(LabelList, ALockedLayersLabelsStay) {
    Figure figure = testing::smallFigure();
    figure.layers[0].locked = true;
    Panel panel(3, figure);
    const Figure before = *panel.history.current();
    EXPECT_FALSE(panel.row(1)->flags().testFlag(Qt::ItemIsEnabled));
    panel.row(1)->setCheckState(Qt::Unchecked);
    EXPECT_EQ(*panel.history.current(), before);
    panel.layer = 1;
    panel.show();
    panel.row(1)->setCheckState(Qt::Unchecked);
    EXPECT_EQ(panel.shown(), (std::vector{1, 3})) << "the other layer's go and come";
}

TEST(LabelList, ChipsHaveTheColoursOfALayerThatIsDrawnByLabel) {
    std::vector<std::string> notes;
    LabelReference plain = labels(3);
    plain.colours.clear();
    Panel panel(3, withLabels(testing::smallFigure(), plain, notes));
    const QImage chip = panel.row(2)->icon().pixmap(14, 14).toImage();
    EXPECT_EQ(chip.pixelColor(chip.rect().center()), QColor(QString::fromStdString(distinctColours(3)[2])));
}

TEST(LabelList, ChecksEditTheLayersLabelsAndCanBeUndone) {
    Panel panel(4);
    panel.row(1)->setCheckState(Qt::Unchecked);
    EXPECT_EQ(panel.shown(), (std::vector<int>{1, 3, 4}));
    EXPECT_EQ(panel.history.undoLabel(), "Hide label “tibia”");
    panel.row(3)->setCheckState(Qt::Unchecked);
    EXPECT_EQ(panel.shown(), (std::vector<int>{1, 3}));
    panel.row(1)->setCheckState(Qt::Checked);
    panel.row(3)->setCheckState(Qt::Checked);
    EXPECT_EQ(panel.shown(), std::nullopt) << "all labels: the part is absent again";
    EXPECT_EQ(panel.history.position(), 4U);
    panel.history.undo();
    panel.history.undo();
    panel.show();
    EXPECT_EQ(panel.row(3)->checkState(), Qt::Unchecked);
    EXPECT_EQ(panel.row(2)->checkState(), Qt::Checked);
    EXPECT_EQ(panel.history.current()->layers[1].labels, std::nullopt) << "the other layer is left alone";
}

TEST(LabelList, AllAndNoneTakeWhatTheSearchFound) {
    Panel panel(20);
    panel.list.search()->setText("label 1"); // 10 to 19
    EXPECT_TRUE(panel.row(0)->isHidden());
    EXPECT_FALSE(panel.row(9)->isHidden());
    panel.list.none()->click();
    EXPECT_EQ(panel.shown(), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 20}));
    EXPECT_TRUE(panel.row(0)->isHidden()) << "an edit keeps the search";
    panel.list.search()->setText("2"); // label 20 is no "2", tibia is
    EXPECT_FALSE(panel.row(1)->isHidden());
    EXPECT_TRUE(panel.row(0)->isHidden());
    panel.list.search()->clear();
    panel.list.none()->click();
    EXPECT_EQ(panel.shown(), std::vector<int>());
    panel.list.all()->click();
    EXPECT_EQ(panel.shown(), std::nullopt);
    EXPECT_EQ(panel.history.position(), 3U);
}

TEST(LabelList, SearchIsThereOnlyForManyLabels) {
    EXPECT_TRUE(Panel(12).list.search()->isHidden());
    EXPECT_FALSE(Panel(13).list.search()->isHidden());
}

TEST(LabelList, HidesWithoutLabelsAndFollowsOtherOnes) {
    Panel panel(3);
    EXPECT_FALSE(panel.list.isHidden());
    auto figure = std::make_shared<Figure>(*panel.history.current());
    figure->labels = labels(5);
    panel.list.setFigure(figure, 0);
    EXPECT_TRUE(pumpUntil([&] { return panel.list.list()->count() == 5; }));
    panel.list.setFigure(figure, 7);
    EXPECT_TRUE(panel.list.isHidden());
    panel.list.setFigure(nullptr, 0);
    EXPECT_TRUE(panel.list.isHidden());
}

TEST(PresetMenu, PresetsThatNeedLabelsWaitForThem) {
    PresetMenu menu;
    menu.setPresets({{"auto", "Automatic", "", "any"}, {"labelled", "Labelled", "", "labels"}});
    const auto* action = menu.findChild<QAction*>("preset.labelled");
    ASSERT_NE(action, nullptr);
    EXPECT_FALSE(action->isEnabled());
    menu.setLabelsThere(true);
    EXPECT_TRUE(action->isEnabled());
    EXPECT_TRUE(menu.findChild<QAction*>("preset.auto")->isEnabled());
}

} // namespace
} // namespace limner
