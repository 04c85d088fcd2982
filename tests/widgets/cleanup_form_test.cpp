#include "widgets/cleanup_form.h"

#include "widgets/cleanup_words.h"
#include "widgets/parameter_row.h"
#include "widgets/test_figure.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTest>

namespace limner {
namespace {

struct Panel {
    explicit Panel(Figure figure = testing::smallFigure()) : history(std::move(figure)) {
        histogram = std::make_shared<const Histogram>(computeHistogram(*history.current()->volume->data, 256));
        show();
        QObject::connect(&form, &CleanupForm::edited, [this](const Edit& edit) {
            edits.push_back(edit);
            history.apply(edit);
            show();
        });
    }
    void show() { form.setFigure(history.current(), histogram); }
    [[nodiscard]] const std::vector<CleanupStep>& steps() const { return history.current()->cleanup; }
    [[nodiscard]] QString words(int row) const { return form.list()->item(row)->text(); }
    [[nodiscard]] QAction* kind(CleanupKind kind) const {
        for (QAction* action : form.add()->menu()->actions())
            if (action->data().toInt() == static_cast<int>(kind))
                return action;
        return nullptr;
    }
    [[nodiscard]] bool shows(const char* pointer) const { return form.row(pointer)->isVisibleTo(&form); }

    CleanupForm form;
    History history;
    std::shared_ptr<const Histogram> histogram;
    std::vector<Edit> edits;
};

/// A lasso as the scissors leave it.
CleanupStep lasso() {
    CleanupStep step;
    step.kind = CleanupKind::scissors;
    step.polygon = {{0.1, 0.1}, {0.9, 0.1}, {0.5, 0.9}};
    step.camera = Camera{};
    step.camera->direction = {1, 0, 0};
    return step;
}

TEST(CleanupWords, SayWhatEachStepDoes) {
    QLocale::setDefault(QLocale::c());
    Figure figure = testing::smallFigure();
    CleanupStep step;
    step.above = 300;
    EXPECT_EQ(cleanupWords(step, figure), "Keep the largest island above 300 HU");
    step.openingMm = 1.5;
    EXPECT_EQ(cleanupWords(step, figure), "Keep the largest island above 300 HU, parted where thinner than 3 mm");
    step.kind = CleanupKind::keepAt;
    step.atMm = {12.4, -40, 88.6};
    EXPECT_EQ(cleanupWords(step, figure), "Keep the island above 300 HU at 12, -40, 89 mm");
    step.kind = CleanupKind::removeIslands;
    step.belowMm3 = 50;
    EXPECT_EQ(cleanupWords(step, figure), "Remove islands above 300 HU that are smaller than 50 mm³");
    EXPECT_EQ(cleanupWords(lasso(), figure), "Scissors: 3 points, inside");
    step.kind = CleanupKind::eraseLabel;
    step.label = 3;
    EXPECT_EQ(cleanupWords(step, figure), "Erase label 3");
    figure.labels = LabelReference{};
    figure.labels->names["3"] = "mandible";
    EXPECT_EQ(cleanupWords(step, figure), "Erase mandible (label 3)");
}

TEST(CleanupForm, AddsStepsWithStartingValues) {
    Panel panel;
    EXPECT_FALSE(panel.form.remove()->isEnabled());
    panel.kind(CleanupKind::keepLargest)->trigger();
    panel.kind(CleanupKind::removeIslands)->trigger();
    ASSERT_EQ(panel.steps().size(), 2U);
    EXPECT_EQ(panel.steps()[0].above, -300);
    EXPECT_EQ(panel.form.selected(), std::optional<std::size_t>(1)) << "the new one is chosen";
    EXPECT_TRUE(panel.words(0).startsWith("1. Keep the largest island above -300 HU"));
    panel.history.undo();
    panel.show();
    EXPECT_EQ(panel.steps().size(), 1U);
    EXPECT_EQ(panel.form.list()->count(), 1);
    EXPECT_EQ(panel.history.redoLabel(), "Remove small islands");
}

TEST(CleanupForm, PlacesInThePictureAreAskedOfTheWindow) {
    Panel panel;
    int scissors = 0;
    int island = 0;
    QObject::connect(&panel.form, &CleanupForm::scissorsWanted, [&] { ++scissors; });
    QObject::connect(&panel.form, &CleanupForm::islandWanted, [&] { ++island; });
    panel.kind(CleanupKind::scissors)->trigger();
    panel.kind(CleanupKind::keepAt)->trigger();
    EXPECT_EQ(scissors, 1);
    EXPECT_EQ(island, 1);
    EXPECT_TRUE(panel.edits.empty());
}

TEST(CleanupForm, ALabelCanBeErasedOnlyWhereThereAreLabels) {
    Panel without;
    EXPECT_FALSE(without.kind(CleanupKind::eraseLabel)->isEnabled());
    Figure figure = testing::smallFigure();
    figure.labels = LabelReference{};
    figure.labels->data = figure.volume->data;
    Panel panel(figure);
    ASSERT_TRUE(panel.kind(CleanupKind::eraseLabel)->isEnabled());
    panel.kind(CleanupKind::eraseLabel)->trigger();
    EXPECT_TRUE(panel.form.label()->isVisibleTo(&panel.form));
    EXPECT_FALSE(panel.shows("/cleanup/*/above"));
    panel.form.label()->setValue(7);
    EXPECT_EQ(panel.steps()[0].label, 7);
    EXPECT_TRUE(panel.words(0).contains("label 7"));
}

TEST(CleanupForm, ShowsTheNumbersOfTheChosenKindAndEditsThem) {
    Figure figure = testing::smallFigure();
    figure.cleanup = {CleanupStep{}, lasso()};
    Panel panel(figure);
    panel.form.select(0);
    EXPECT_TRUE(panel.shows("/cleanup/*/above"));
    EXPECT_TRUE(panel.shows("/cleanup/*/opening_mm"));
    EXPECT_FALSE(panel.shows("/cleanup/*/below_mm3"));
    EXPECT_FALSE(panel.form.side()->isVisibleTo(&panel.form));
    QDoubleSpinBox* above = panel.form.row("/cleanup/*/above")->box();
    EXPECT_EQ(above->minimum(), -1000) << "the scan's range";
    EXPECT_EQ(above->maximum(), 1000);
    above->setValue(250);
    above->setValue(260);
    EXPECT_EQ(panel.steps()[0].above, 260);
    EXPECT_EQ(panel.history.position(), 1U) << "presses that follow each other are one step";
    panel.form.row("/cleanup/*/opening_mm")->box()->setValue(2);
    EXPECT_EQ(panel.steps()[0].openingMm, 2);
    panel.form.select(1);
    EXPECT_FALSE(panel.shows("/cleanup/*/above"));
    ASSERT_TRUE(panel.form.side()->isVisibleTo(&panel.form));
    panel.form.side()->setCurrentIndex(1);
    Q_EMIT panel.form.side()->activated(1);
    EXPECT_EQ(panel.steps()[1].side, ScissorsSide::outside);
    EXPECT_TRUE(panel.words(1).endsWith("outside"));
    panel.form.look()->click();
    EXPECT_EQ(panel.history.current()->camera, *lasso().camera);
    EXPECT_FALSE(panel.form.look()->isEnabled()) << "one looks from there already";
}

TEST(CleanupForm, ReordersAndDeletes) {
    Figure figure = testing::smallFigure();
    CleanupStep islands;
    islands.kind = CleanupKind::removeIslands;
    figure.cleanup = {CleanupStep{}, lasso(), islands};
    Panel panel(figure);
    panel.form.select(0);
    EXPECT_FALSE(panel.form.earlier()->isEnabled());
    panel.form.later()->click();
    EXPECT_EQ(panel.steps(), (std::vector{lasso(), CleanupStep{}, islands}));
    EXPECT_EQ(panel.form.selected(), std::optional<std::size_t>(1)) << "the choice goes with the step";
    panel.form.later()->click();
    EXPECT_FALSE(panel.form.later()->isEnabled());
    panel.form.earlier()->click();
    panel.form.remove()->click();
    EXPECT_EQ(panel.steps(), (std::vector{lasso(), islands}));
    for (int i = 0; i < 4; ++i)
        panel.history.undo();
    EXPECT_EQ(panel.steps(), figure.cleanup);
    EXPECT_FALSE(panel.history.canUndo());
}

} // namespace
} // namespace limner
