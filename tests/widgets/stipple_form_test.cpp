#include "widgets/stipple_form.h"

#include "core/figure/figure_json.h"
#include "core/figure/parameters.h"
#include "core/figure/stipple_presets.h"
#include "widgets/light_form.h"
#include "widgets/part_form.h"
#include "widgets/test_figure.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

namespace limner {
namespace {

struct Panel {
    Panel() {
        form.resize(390, 1600);
        form.show();
        show();
        QObject::connect(&form, &StippleForm::edited, [this](const Edit& edit) {
            edits.push_back(edit);
            history.apply(edit);
            show();
        });
    }
    void show() { form.setFigure(history.current()); }
    void undo() {
        history.undo();
        show();
    }
    /// With a stipple that has none of its parts.
    void startBare() {
        Edit edit{*history.current(), {}, {}, false};
        edit.figure.stipple = Stipple{};
        history.apply(edit);
        show();
    }
    void take(const char* preset) const {
        auto* action = form.presets()->findChild<QAction*>(preset);
        ASSERT_TRUE(action) << preset;
        action->trigger();
    }
    [[nodiscard]] bool says(const QString& words) const {
        const auto labels = form.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](QLabel* l) { return l->isVisible() && l->text().contains(words); });
    }
    [[nodiscard]] const std::optional<Stipple>& stipple() const { return history.current()->stipple; }

    StippleForm form;
    History history{testing::smallFigure()};
    std::vector<Edit> edits;
};

void take(QComboBox* box, int row) {
    box->setCurrentIndex(row);
    Q_EMIT box->activated(row);
}

TEST(StippleForm, TheSwitchAddsAndRemovesTheWhole) {
    Panel panel;
    const Figure start = *panel.history.current();
    EXPECT_FALSE(panel.form.inked()->isChecked());
    EXPECT_FALSE(panel.form.ink()->isVisible());
    EXPECT_TRUE(panel.says("no marks of ink"));
    panel.form.inked()->click();
    ASSERT_TRUE(panel.stipple());
    EXPECT_EQ(*panel.stipple(), stipplePresets().front().part) << "something is to be seen";
    EXPECT_TRUE(panel.form.ink()->isVisible());
    EXPECT_FALSE(panel.says("no marks of ink"));
    panel.form.row("/stipple/size_mm")->box()->setValue(0.8);
    panel.form.part("/stipple/lighting")->present()->click();
    panel.form.inked()->click();
    EXPECT_FALSE(panel.stipple());
    EXPECT_EQ(*panel.history.current(), start) << "what is absent stays absent";
    panel.form.inked()->click();
    EXPECT_EQ(panel.stipple()->sizeMm, 0.8) << "the settings of before come back";
    EXPECT_TRUE(panel.stipple()->lighting);
    for (int i = 0; i < 5; ++i)
        panel.undo();
    EXPECT_FALSE(panel.stipple());
    EXPECT_FALSE(panel.form.inked()->isChecked());
    EXPECT_FALSE(panel.history.canUndo());
}

TEST(StippleForm, EveryPartComesAndGoesByItsCheckBox) {
    Panel panel;
    panel.startBare();
    const Figure start = *panel.history.current();
    for (const char* pointer :
         {"/stipple/boundary", "/stipple/silhouette", "/stipple/resolution", "/stipple/distance", "/stipple/interior",
          "/stipple/lighting", "/stipple/curves", "/stipple/inner_lines", "/stipple/hatching"}) {
        SCOPED_TRACE(pointer);
        PartForm* part = panel.form.part(pointer);
        ASSERT_TRUE(part);
        EXPECT_FALSE(part->present()->isChecked());
        EXPECT_EQ(part->present()->text().toStdString(), findParameter(pointer)->label);
        const int folded = part->sizeHint().height();
        part->present()->click();
        EXPECT_TRUE(part->on());
        EXPECT_GT(part->sizeHint().height(), folded) << "its rows open";
        EXPECT_NE(panel.stipple(), start.stipple);
        EXPECT_NE(writeFigure(*panel.history.current()).find(QString(pointer).section('/', -1).toStdString()),
                  std::string::npos);
        for (const Problem& problem : validateFigure(*panel.history.current()))
            EXPECT_FALSE(problem.fatal) << problem.pointer << " " << problem.why;
        part->present()->click();
        EXPECT_EQ(*panel.history.current(), start) << "a factor that is off is absent";
        panel.undo();
        EXPECT_TRUE(part->present()->isChecked());
        panel.undo();
        EXPECT_EQ(*panel.history.current(), start);
    }
}

struct Number {
    const char* pointer;
    double (*of)(const Stipple&);
};

constexpr Number kNumbers[] = {
    {"/stipple/size_mm", [](const Stipple& s) { return s.sizeMm; }},
    {"/stipple/k_max", [](const Stipple& s) { return s.kMax; }},
    {"/stipple/threshold", [](const Stipple& s) { return s.threshold; }},
    {"/stipple/spread_voxels", [](const Stipple& s) { return s.spreadVoxels; }},
    {"/stipple/boundary/kgc", [](const Stipple& s) { return s.boundary->kgc; }},
    {"/stipple/boundary/kgs", [](const Stipple& s) { return s.boundary->kgs; }},
    {"/stipple/boundary/kge", [](const Stipple& s) { return s.boundary->kge; }},
    {"/stipple/silhouette/ksc", [](const Stipple& s) { return s.silhouette->ksc; }},
    {"/stipple/silhouette/kss", [](const Stipple& s) { return s.silhouette->kss; }},
    {"/stipple/silhouette/kse", [](const Stipple& s) { return s.silhouette->kse; }},
    {"/stipple/resolution/kre", [](const Stipple& s) { return s.resolution->kre; }},
    {"/stipple/distance/kde", [](const Stipple& s) { return s.distance->kde; }},
    {"/stipple/interior/kte", [](const Stipple& s) { return s.interior->kte; }},
    {"/stipple/lighting/kle", [](const Stipple& s) { return s.lighting->kle; }},
    {"/stipple/curves/log", [](const Stipple& s) { return s.curves->log; }},
    {"/stipple/curves/eye", [](const Stipple& s) { return s.curves->eye; }},
    {"/stipple/curves/gradient", [](const Stipple& s) { return s.curves->gradient; }},
    {"/stipple/curves/width_mm", [](const Stipple& s) { return s.curves->widthMm; }},
    {"/stipple/inner_lines/ridges", [](const Stipple& s) { return s.innerLines->ridges; }},
    {"/stipple/inner_lines/valleys", [](const Stipple& s) { return s.innerLines->valleys; }},
    {"/stipple/inner_lines/width_mm", [](const Stipple& s) { return s.innerLines->widthMm; }},
    {"/stipple/hatching/length_mm", [](const Stipple& s) { return s.hatching->lengthMm; }},
    {"/stipple/hatching/width_mm", [](const Stipple& s) { return s.hatching->widthMm; }},
    {"/stipple/hatching/cross", [](const Stipple& s) { return s.hatching->cross; }},
};

void addAllParts(Panel& panel) {
    panel.startBare();
    for (PartForm* part : panel.form.findChildren<PartForm*>())
        if (!part->on())
            part->present()->click();
}

TEST(StippleForm, EachSliderChangesItsNumberInOneStepPerDrag) {
    Panel panel;
    addAllParts(panel);
    std::size_t steps = panel.history.position();
    for (const auto& [pointer, of] : kNumbers) {
        SCOPED_TRACE(pointer);
        ParameterRow* row = panel.form.row(pointer);
        ASSERT_TRUE(row);
        const Stipple before = *panel.stipple();
        row->slider()->setSliderDown(true);
        for (const int at : {20, 190, 137})
            row->slider()->setSliderPosition(at);
        EXPECT_TRUE(panel.edits.back().ongoing) << "drafts follow the hand";
        EXPECT_EQ(row->slider()->value(), 137) << "the hand keeps the slider";
        row->slider()->setSliderDown(false);
        EXPECT_FALSE(panel.edits.back().ongoing) << "the still is drawn at the end";
        EXPECT_EQ(panel.history.position(), ++steps);
        const double now = of(*panel.stipple());
        EXPECT_NE(now, of(before));
        EXPECT_NEAR(row->box()->value(), now, 0.5 * std::pow(10.0, -row->box()->decimals()) + 1e-12);
        int others = 0;
        for (const Number& other : kNumbers)
            others += other.pointer != pointer && other.of(*panel.stipple()) != other.of(before) ? 1 : 0;
        EXPECT_EQ(others, 0);
    }
}

TEST(StippleForm, TheBoxTakesTheWholeLegalRange) {
    Panel panel;
    addAllParts(panel);
    for (const auto& [pointer, of] : kNumbers) {
        SCOPED_TRACE(pointer);
        const Parameter* parameter = findParameter(pointer);
        QDoubleSpinBox* box = panel.form.row(pointer)->box();
        EXPECT_EQ(box->maximum(), *parameter->high);
        EXPECT_NEAR(box->minimum(), *parameter->low, 0.011);
        box->setValue(*parameter->high);
        EXPECT_EQ(of(*panel.stipple()), *parameter->high);
        EXPECT_EQ(panel.form.row(pointer)->slider()->value(), panel.form.row(pointer)->slider()->maximum());
        panel.form.row(pointer)->slider()->setSliderDown(true);
        panel.form.row(pointer)->slider()->setSliderDown(false);
        EXPECT_EQ(of(*panel.stipple()), *parameter->high) << "a press alone changes nothing";
    }
}

/// The middle of an exponent's slider lies at a quarter of its end: what changes a drawing lies below 1.
TEST(StippleForm, SmallExponentsHaveMoreOfTheSlider) {
    Panel panel;
    addAllParts(panel);
    ParameterRow* row = panel.form.row("/stipple/boundary/kge");
    row->slider()->setValue(100);
    EXPECT_DOUBLE_EQ(panel.stipple()->boundary->kge, 1.25);
    row->box()->setValue(0.2);
    EXPECT_EQ(row->slider()->value(), 40);
    for (int key = 0; key < 5; ++key)
        QTest::keyClick(row->slider(), Qt::Key_Left);
    EXPECT_EQ(row->slider()->value(), 35) << "keys do not stick";
}

TEST(StippleForm, WordsAreTheTablesAndGoIntoTheFigure) {
    const std::pair<const char*, std::string (*)(const Stipple&)> words[] = {
        {"/stipple/layer_opacity", [](const Stipple& s) { return s.layerOpacity; }},
        {"/stipple/matter", [](const Stipple& s) { return s.matter; }},
        {"/stipple/hidden", [](const Stipple& s) { return s.hidden; }},
        {"/stipple/placing", [](const Stipple& s) { return s.placing; }},
        {"/stipple/tone", [](const Stipple& s) { return s.tone; }},
        {"/stipple/gradient", [](const Stipple& s) { return s.gradient; }},
        {"/stipple/curves/width_by", [](const Stipple& s) { return s.curves->widthBy; }},
        {"/stipple/curves/hidden_lines", [](const Stipple& s) { return s.curves->hiddenLines; }}};
    Panel panel;
    addAllParts(panel);
    for (const auto& [pointer, of] : words) {
        SCOPED_TRACE(pointer);
        QComboBox* box = panel.form.choice(pointer);
        ASSERT_TRUE(box);
        const std::vector<std::string>& legal = findParameter(pointer)->choices;
        ASSERT_EQ(box->count(), static_cast<int>(legal.size()));
        for (int i = box->count() - 1; i >= 0; --i) {
            take(box, i);
            EXPECT_EQ(of(*panel.stipple()), legal[static_cast<std::size_t>(i)]);
        }
        take(box, 1);
        panel.undo();
        EXPECT_EQ(box->currentIndex(), 0);
        EXPECT_EQ(box->accessibleName().toStdString(), findParameter(pointer)->label);
    }
}

TEST(StippleForm, InkStyleSeedAndLightAreSet) {
    Panel panel;
    addAllParts(panel);
    panel.form.ink()->choose(QColor(255, 0, 0));
    EXPECT_EQ(panel.stipple()->inkRgb, glm::dvec3(1, 0, 0));
    panel.form.fromStyle()->click();
    EXPECT_TRUE(panel.stipple()->fromStyle);
    const std::size_t steps = panel.history.position();
    panel.form.seed()->setValue(41);
    panel.form.seed()->setValue(42);
    EXPECT_EQ(panel.stipple()->seed, 42);
    EXPECT_EQ(panel.history.position(), steps + 1) << "clicks that follow each other are one step";
    auto* light = panel.form.part("/stipple/lighting")->findChild<LightForm*>();
    ASSERT_TRUE(light);
    Q_EMIT light->ball()->moved({1, 0, 0}, "light#1", true);
    EXPECT_EQ(panel.stipple()->lighting->light.direction, glm::dvec3(1, 0, 0));
    EXPECT_TRUE(panel.edits.back().ongoing);
}

TEST(StippleForm, PresetsAreTakenWithOrWithoutStipples) {
    Panel panel;
    panel.take("stipple.outlines-only");
    ASSERT_TRUE(panel.stipple());
    EXPECT_EQ(panel.stipple()->kMax, 0);
    EXPECT_TRUE(panel.stipple()->innerLines);
    EXPECT_EQ(panel.history.undoLabel(), "Stipple “Outlines only”");
    panel.form.row("/stipple/size_mm")->box()->setValue(0.5);
    panel.take("stipple.pen-and-ink");
    EXPECT_EQ(panel.stipple()->sizeMm, 0.5) << "the ink is the user's";
    EXPECT_FALSE(panel.stipple()->innerLines);
    EXPECT_TRUE(panel.form.part("/stipple/hatching")->on());
    EXPECT_FALSE(panel.form.part("/stipple/inner_lines")->on());
    EXPECT_EQ(panel.form.presets()->actions().size(), static_cast<int>(stipplePresets().size()));
    panel.undo();
    EXPECT_TRUE(panel.form.part("/stipple/inner_lines")->on());
}

TEST(StippleForm, SaysThatWithoutAFactorAllIsDark) {
    Panel panel;
    panel.startBare();
    EXPECT_TRUE(panel.says("as dark as"));
    panel.form.part("/stipple/interior")->present()->click();
    EXPECT_FALSE(panel.says("as dark as"));
    panel.form.part("/stipple/interior")->present()->click();
    panel.form.part("/stipple/curves")->present()->click();
    EXPECT_TRUE(panel.says("as dark as")) << "a line is no tone";
}

TEST(StippleForm, KeysReachAllOfItFromTopToBottomAndAllHasAName) {
    Panel panel;
    addAllParts(panel);
    QTest::qWait(0);
    int reached = 0;
    int last = 0;
    QWidget* start = panel.form.inked();
    for (QWidget* at = start->nextInFocusChain(); at != start; at = at->nextInFocusChain()) {
        if (!(at->focusPolicy() & Qt::TabFocus) || !at->isVisibleTo(&panel.form) || at->focusProxy() ||
            !panel.form.isAncestorOf(at) || qobject_cast<QScrollArea*>(at)) // which takes keys only to scroll
            continue;
        const int y = at->mapTo(&panel.form, QPoint(0, at->height() / 2)).y();
        EXPECT_GE(y, last - 25) << at->metaObject()->className() << " " << at->accessibleName().toStdString();
        last = std::max(last, y);
        ++reached;
        const auto* button = qobject_cast<QAbstractButton*>(at);
        EXPECT_TRUE(!at->accessibleName().isEmpty() || (button && !button->text().isEmpty()))
            << at->metaObject()->className() << " at " << y;
        EXPECT_FALSE(at->toolTip().isEmpty()) << at->accessibleName().toStdString();
    }
    EXPECT_GE(reached, 2 * static_cast<int>(std::size(kNumbers)) + 8 + 9 + 3) << "numbers, words, switches, ink";
}

TEST(StippleForm, NothingIsToBeDoneWithoutAFigure) {
    Panel panel;
    panel.form.setFigure(nullptr);
    EXPECT_FALSE(panel.form.inked()->isEnabled());
    panel.take("stipple.plain-stipple");
    EXPECT_TRUE(panel.edits.empty());
}

} // namespace
} // namespace limner
