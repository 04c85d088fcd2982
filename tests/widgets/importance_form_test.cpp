#include "widgets/importance_form.h"

#include "widgets/lens_form.h"
#include "widgets/parameter_row.h"
#include "widgets/test_figure.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTest>

namespace limner {
namespace {

struct Panel {
    Panel() {
        show();
        QObject::connect(&form, &ImportanceForm::edited, [this](const Edit& edit) {
            edits.push_back(edit);
            history.apply(edit);
            show();
        });
    }
    void show() { form.setFigure(history.current()); }
    [[nodiscard]] const std::optional<Importance>& importance() const { return history.current()->importance; }
    [[nodiscard]] const Lens& lens(std::size_t i) const { return importance()->lenses.at(i); }

    ImportanceForm form;
    History history{testing::smallFigure()};
    std::vector<Edit> edits;
};

TEST(ImportanceForm, TheCheckBoxAddsAndRemovesThePart) {
    Panel panel;
    EXPECT_FALSE(panel.form.showsThrough()->isChecked());
    EXPECT_FALSE(panel.form.lenses()->isEnabled());
    panel.form.showsThrough()->click();
    ASSERT_TRUE(panel.importance());
    EXPECT_GT(panel.importance()->weights.gradient, 0) << "something is to be seen";
    EXPECT_TRUE(panel.form.lenses()->isEnabled());
    panel.form.row("/importance/weights/object")->box()->setValue(12);
    panel.form.showsThrough()->click();
    EXPECT_FALSE(panel.importance());
    panel.form.showsThrough()->click();
    EXPECT_EQ(panel.importance()->weights.object, 12) << "the settings of before come back";
    for (int i = 0; i < 4; ++i)
        panel.history.undo();
    panel.show();
    EXPECT_FALSE(panel.importance());
    EXPECT_FALSE(panel.form.showsThrough()->isChecked());
    EXPECT_FALSE(panel.history.canUndo());
}

TEST(ImportanceForm, EachSliderChangesItsWeightInOneStepPerDrag) {
    const std::pair<const char*, double (*)(const Importance&)> rows[] = {
        {"/importance/global", [](const Importance& i) { return i.global; }},
        {"/importance/weights/intensity", [](const Importance& i) { return i.weights.intensity; }},
        {"/importance/weights/extinction", [](const Importance& i) { return i.weights.extinction; }},
        {"/importance/weights/gradient", [](const Importance& i) { return i.weights.gradient; }},
        {"/importance/weights/silhouette", [](const Importance& i) { return i.weights.silhouette; }},
        {"/importance/weights/unocclusion", [](const Importance& i) { return i.weights.unocclusion; }},
        {"/importance/weights/lighting", [](const Importance& i) { return i.weights.lighting; }},
        {"/importance/weights/object", [](const Importance& i) { return i.weights.object; }},
        {"/importance/weights/statistics", [](const Importance& i) { return i.weights.statistics; }},
        {"/importance/background", [](const Importance& i) { return i.background; }}};
    Panel panel;
    panel.form.showsThrough()->click();
    std::size_t steps = 1;
    for (const auto& [pointer, value] : rows) {
        SCOPED_TRACE(pointer);
        QSlider* slider = panel.form.row(pointer)->slider();
        slider->setSliderDown(true);
        for (const int at : {20, 90, 140})
            slider->setSliderPosition(at);
        EXPECT_TRUE(panel.edits.back().ongoing);
        slider->setSliderDown(false);
        EXPECT_FALSE(panel.edits.back().ongoing) << "the still is drawn at the end";
        EXPECT_DOUBLE_EQ(value(*panel.importance()), 7);
        EXPECT_EQ(panel.history.position(), ++steps);
    }
}

TEST(ImportanceForm, TheBoxReachesWhatTheSliderDoesNot) {
    Panel panel;
    panel.form.showsThrough()->click();
    ParameterRow* row = panel.form.row("/importance/weights/gradient");
    row->box()->setValue(1e5);
    EXPECT_EQ(panel.importance()->weights.gradient, 1e5);
    EXPECT_EQ(row->slider()->value(), row->slider()->maximum());
    row->slider()->setSliderDown(true);
    row->slider()->setSliderDown(false);
    EXPECT_EQ(panel.importance()->weights.gradient, 1e5) << "a press alone changes nothing";
}

TEST(LensForm, LensesAreAddedAndRemoved) {
    Panel panel;
    LensForm& lenses = *panel.form.lenses();
    lenses.addLens();
    ASSERT_TRUE(panel.importance()) << "a lens needs importance";
    EXPECT_EQ(panel.history.position(), 1U);
    lenses.add()->click();
    ASSERT_EQ(panel.importance()->lenses.size(), 2U);
    EXPECT_EQ(lenses.list()->count(), 2);
    EXPECT_EQ(lenses.selected(), 1U);
    lenses.row("/importance/lenses/*/radius")->box()->setValue(0.3);
    EXPECT_EQ(panel.lens(1).radius, 0.3);
    EXPECT_EQ(panel.lens(0).radius, Lens{}.radius);
    lenses.select(0);
    lenses.remove()->click();
    ASSERT_EQ(panel.importance()->lenses.size(), 1U);
    EXPECT_EQ(panel.lens(0).radius, 0.3) << "the other one stays";
    lenses.select(0);
    lenses.remove()->click();
    EXPECT_FALSE(lenses.selected());
    EXPECT_FALSE(lenses.remove()->isEnabled());
    panel.history.undo();
    panel.show();
    EXPECT_EQ(lenses.list()->count(), 1);
}

TEST(LensForm, TheChosenLensIsEdited) {
    Panel panel;
    LensForm& lenses = *panel.form.lenses();
    lenses.addLens();
    EXPECT_FALSE(lenses.row("/importance/lenses/*/soft")->isEnabled()) << "a Gaussian has no edge";
    lenses.kind()->setCurrentIndex(lenses.kind()->findData("circular"));
    Q_EMIT lenses.kind()->activated(lenses.kind()->currentIndex());
    EXPECT_EQ(panel.lens(0).kind, "circular");
    EXPECT_TRUE(lenses.row("/importance/lenses/*/soft")->isEnabled());
    lenses.shape()->setCurrentIndex(lenses.shape()->findData("box"));
    Q_EMIT lenses.shape()->activated(lenses.shape()->currentIndex());
    EXPECT_EQ(panel.lens(0).shape, "box");
    lenses.row("/importance/lenses/*/soft")->box()->setValue(0.25);
    lenses.row("/importance/lenses/*/inside")->box()->setValue(3);
    lenses.row("/importance/lenses/*/outside")->box()->setValue(0.5);
    EXPECT_EQ(panel.lens(0).soft, 0.25);
    EXPECT_EQ(panel.lens(0).inside, 3);
    EXPECT_EQ(panel.lens(0).outside, 0.5);
    EXPECT_FALSE(lenses.row("/importance/lenses/*/cell")->isEnabled()) << "no screen, no dots";
    lenses.kind()->setCurrentIndex(lenses.kind()->findData("screendoor"));
    Q_EMIT lenses.kind()->activated(lenses.kind()->currentIndex());
    lenses.row("/importance/lenses/*/cell")->box()->setValue(0.0025);
    lenses.row("/importance/lenses/*/angle_deg")->box()->setValue(30);
    EXPECT_EQ(panel.lens(0).cell, 0.0025);
    EXPECT_EQ(panel.lens(0).angleDeg, 30);
    lenses.follows()->click();
    ASSERT_TRUE(panel.lens(0).anchorMm);
    EXPECT_EQ(*panel.lens(0).anchorMm, panel.history.current()->camera.targetMm) << "it is in the middle";
    lenses.follows()->click();
    EXPECT_FALSE(panel.lens(0).anchorMm);
}

} // namespace
} // namespace limner
