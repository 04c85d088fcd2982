#include "widgets/extraction_form.h"

#include "core/style/extraction/verdict.h"
#include "widgets/art_plate.h"
#include "widgets/curve_editor.h"
#include "widgets/extraction_words.h"
#include "widgets/slider_row.h"
#include "widgets/style_card_form.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPalette>
#include <QPushButton>
#include <QSlider>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

SpherePtr grey() { return std::make_shared<const LitSphere>(16, std::vector<Rgba>(256, Rgba{0.5F, 0.5F, 0.5F, 1})); }

std::shared_ptr<const ExtractionPictures> picturesWith(const ExtractionFigures& figures) {
    auto extraction = std::make_shared<Extraction>();
    extraction->sphere = grey();
    extraction->figures = figures;
    return std::make_shared<const ExtractionPictures>(picturesOf(extraction, grey()));
}

struct Shown {
    Shown() {
        draft.plate = testing::twoColours(40, 30);
        draft.form = FormKind::ellipse;
        draft.ellipse = Ellipse{{20, 15}, {8, 8}, 0};
        history.apply({draft, "Draw", {}, false});
        QObject::connect(&form, &ExtractionForm::edited, [this](const DraftEdit& edit) {
            history.apply(edit);
            form.setDraft(history.current());
        });
        form.setDraft(history.current());
    }
    [[nodiscard]] const ExtractionDraft& now() const { return history.current(); }
    [[nodiscard]] bool says(const QString& words) const {
        const auto labels = form.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return !label->isHidden() && label->text().contains(words); });
    }
    ExtractionDraft draft;
    DraftHistory history;
    ExtractionForm form;
};

TEST(ExtractionForm, ControlsAskForChangesAndShowThem) {
    Shown shown;
    shown.form.symmetric()->click();
    EXPECT_TRUE(shown.now().edits.symmetric);
    shown.form.paperCast()->click();
    EXPECT_TRUE(shown.now().removePaperCast);
    shown.form.lettering()->click();
    EXPECT_FALSE(shown.now().skipLettering);
    shown.form.texture()->click();
    EXPECT_TRUE(shown.now().separateTexture);
    QTest::keyClick(shown.form.smoothing()->slider(), Qt::Key_Right);
    QTest::keyClick(shown.form.smoothing()->slider(), Qt::Key_Right);
    EXPECT_NEAR(shown.now().edits.smoothing, 0.02, 1e-9);
    shown.history.undo();
    EXPECT_EQ(shown.now().edits.smoothing, 0) << "a run of keys is one step";
    shown.form.setDraft(shown.now());
    EXPECT_EQ(shown.form.smoothing()->slider()->value(), 0);
    EXPECT_TRUE(shown.form.texture()->isChecked());
}

TEST(ExtractionForm, OpacityByAngleIsACurveThatComesAndGoes) {
    Shown shown;
    EXPECT_TRUE(shown.form.opacity()->isHidden());
    auto boxes = shown.form.findChildren<QCheckBox*>();
    const auto byAngle = std::find_if(
        boxes.begin(), boxes.end(), [](const QCheckBox* box) { return box->text().remove('&').startsWith("Opacity"); });
    ASSERT_NE(byAngle, boxes.end());
    (*byAngle)->click();
    EXPECT_FALSE(shown.form.opacity()->isHidden());
    EXPECT_EQ(shown.form.opacity()->points(), shown.now().edits.alpha);
    EXPECT_FALSE(shown.now().edits.alpha.empty());
    (*byAngle)->click();
    EXPECT_TRUE(shown.now().edits.alpha.empty());
}

TEST(ExtractionForm, DepthIsOfOutlinedFormsAndPickedColoursHaveNoPaper) {
    Shown shown;
    EXPECT_TRUE(shown.form.depth()->isHidden());
    ExtractionDraft other = shown.now();
    other.form = FormKind::region;
    shown.form.setDraft(other);
    EXPECT_FALSE(shown.form.depth()->isHidden());
    other.form = FormKind::swatches;
    shown.form.setDraft(other);
    EXPECT_TRUE(shown.form.depth()->isHidden());
    EXPECT_FALSE(shown.form.paperCast()->isEnabled());
    EXPECT_FALSE(shown.form.lettering()->isEnabled());
}

TEST(ExtractionForm, FiguresAreToldInWordsWithWhatToDo) {
    Shown shown;
    EXPECT_FALSE(shown.says("Coverage ")) << "nothing is extracted yet";
    shown.form.setPictures(picturesWith({0.97, 0.02, 6, std::nullopt}), {});
    EXPECT_TRUE(shown.says("97 %"));
    EXPECT_TRUE(shown.says("good"));
    EXPECT_FALSE(shown.says("poor"));
    EXPECT_FALSE(shown.says("Placement"));
    shown.form.setPictures(picturesWith({0.97, 0.3, 6, 0.01}), {});
    EXPECT_TRUE(shown.says("0.300"));
    EXPECT_TRUE(shown.says("poor"));
    EXPECT_TRUE(shown.says("Placement"));
    EXPECT_TRUE(shown.says("Difference")) << "what to do about the worst of them";
}

TEST(ExtractionWords, GradesFallAsFiguresGetWorse) {
    for (const bool outlined : {false, true}) {
        const auto good = gradedFigures({0.95, 0.01, 5, 0.005}, outlined);
        const auto fair = gradedFigures({0.7, 0.05, 30, outlined ? 0.04 : 0.02}, outlined);
        const auto poor = gradedFigures({0.3, 0.2, 80, 0.2}, outlined);
        ASSERT_EQ(good.size(), 4U);
        for (std::size_t i = 0; i < good.size(); ++i) {
            EXPECT_EQ(good[i].grade, Grade::good) << i;
            EXPECT_EQ(fair[i].grade, Grade::fair) << i;
            EXPECT_EQ(poor[i].grade, Grade::poor) << i;
            EXPECT_TRUE(good[i].advice.isEmpty()) << i;
            EXPECT_FALSE(poor[i].advice.isEmpty()) << i;
            EXPECT_FALSE(good[i].tip.isEmpty()) << i;
        }
    }
    EXPECT_EQ(gradedFigures({0.95, 0.01, 5, std::nullopt}, false).size(), 3U);
}

/// The dialog and the command must not judge differently.
TEST(ExtractionWords, PoorIsWhatTheVerdictHasAnAdviceOn) {
    for (const double coverage : {0.2, 0.49, 0.5, 0.9})
        for (const double residual : {0.01, 0.05, 0.079, 0.081})
            for (const double hole : {5.0, 39.0, 41.0})
                for (const double form : {0.005, 0.02, 0.031, 0.049, 0.051})
                    for (const bool outlined : {false, true}) {
                        const ExtractionFigures figures{coverage, residual, hole, form};
                        const auto graded = gradedFigures(figures, outlined);
                        const auto poor = std::count_if(graded.begin(), graded.end(), [](const GradedFigure& figure) {
                            return figure.grade == Grade::poor;
                        });
                        EXPECT_EQ(static_cast<std::size_t>(poor), verdictOf(figures, outlined).advice.size())
                            << coverage << " " << residual << " " << hole << " " << form << " " << outlined;
                    }
}

/// Relative luminance, as the web's guidelines for contrast have it.
double luminance(const QColor& colour) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

TEST(ExtractionWords, GradesCanBeReadOnLightAndDarkWindows) {
    for (const QColor window : {QColor(0xec, 0xed, 0xef), QColor(0x2b, 0x2d, 0x31)}) {
        QPalette palette;
        palette.setColor(QPalette::Window, window);
        for (const Grade grade : {Grade::good, Grade::fair, Grade::poor}) {
            const double a = luminance(gradeColour(grade, palette));
            const double b = luminance(window);
            EXPECT_GE((std::max(a, b) + 0.05) / (std::min(a, b) + 0.05), 4.5) << static_cast<int>(grade);
        }
    }
}

TEST(StyleCardForm, AStyleNeedsANameAndALayerToBeUsed) {
    StyleCardForm form;
    ExtractionDraft draft;
    form.setDraft(draft);
    form.setPossible(true, {});
    EXPECT_FALSE(form.add()->isEnabled());
    EXPECT_TRUE(form.add()->toolTip().contains("name")) << form.add()->toolTip().toStdString();
    draft.name = "Bone";
    form.setDraft(draft);
    EXPECT_TRUE(form.add()->isEnabled());
    EXPECT_TRUE(form.addAndUse()->isEnabled());
    form.setPossible(true, "The layer is locked");
    EXPECT_TRUE(form.add()->isEnabled());
    EXPECT_FALSE(form.addAndUse()->isEnabled());
    EXPECT_EQ(form.addAndUse()->toolTip(), "The layer is locked");
    form.setPossible(false, {});
    EXPECT_FALSE(form.add()->isEnabled());
}

TEST(StyleCardForm, TypingIsOneStepAndKeepsTheCursor) {
    StyleCardForm form;
    DraftHistory history;
    QObject::connect(&form, &StyleCardForm::edited, [&](const DraftEdit& edit) {
        history.apply(edit);
        form.setDraft(history.current());
    });
    QTest::keyClicks(form.name(), "Boe");
    QTest::keyClick(form.name(), Qt::Key_Left);
    QTest::keyClicks(form.name(), "n");
    EXPECT_EQ(history.current().name, "Bone");
    EXPECT_EQ(form.name()->cursorPosition(), 3);
    history.undo();
    EXPECT_EQ(history.current().name, "");
    EXPECT_FALSE(history.canUndo());
}

} // namespace
} // namespace limner
