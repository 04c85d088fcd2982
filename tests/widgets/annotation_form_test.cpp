#include "widgets/annotation_form.h"

#include "widgets/annotation_overlay.h"
#include "widgets/label_tool.h"
#include "widgets/picture_feed.h"
#include "widgets/test_figure.h"
#include "widgets/viewport.h"

#include "renderer/plan/planner.h"
#include "support/qt/qt_events.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QTest>
#include <QToolButton>

namespace limner {
namespace {

using testing::pumpUntil;

Figure letteredFigure() {
    Figure figure = testing::smallFigure();
    figure.layers.pop_back(); // the bone core alone
    Annotation& label = figure.annotations.emplace_back();
    label.text = "Core";
    label.anchorMm = figure.volume->data->grid().centreMm();
    figure.annotations.emplace_back().kind = "scale-bar";
    return figure;
}

struct Panel {
    explicit Panel(const Figure& figure = letteredFigure()) : history(figure) {
        form.resize(390, 900);
        form.show();
        show();
        QObject::connect(&form, &AnnotationForm::edited, [this](const Edit& edit) {
            history.apply(edit);
            show();
        });
    }
    void show() { form.setFigure(history.current()); }
    [[nodiscard]] const std::vector<Annotation>& all() const { return history.current()->annotations; }
    void add(const char* kind) const {
        auto* action = form.add()->menu()->findChild<QAction*>(kind);
        ASSERT_TRUE(action) << kind;
        action->trigger();
    }

    AnnotationForm form;
    History history;
};

TEST(AnnotationForm, ListsWhatIsThere) {
    Panel panel;
    ASSERT_EQ(panel.form.list()->count(), 2);
    EXPECT_EQ(panel.form.list()->item(0)->text(), "Label: Core");
    EXPECT_EQ(panel.form.list()->item(1)->text(), "Scale bar");
    EXPECT_FALSE(panel.form.words()->isEnabled());
    panel.form.select(1);
    EXPECT_TRUE(panel.form.length()->isVisible());
    EXPECT_FALSE(panel.form.side()->isVisible());
    panel.form.select(0);
    EXPECT_FALSE(panel.form.length()->isVisible());
    EXPECT_TRUE(panel.form.side()->isVisible());
}

TEST(AnnotationForm, AddsEveryKindAndRemoves) {
    Panel panel;
    int wanted = 0;
    QObject::connect(&panel.form, &AnnotationForm::labelWanted, [&] { ++wanted; });
    panel.add("label");
    EXPECT_EQ(wanted, 1) << "a label needs a point: the tool's affair";
    for (const char* kind : {"scale-bar", "orientation", "title", "caption", "legend"}) {
        panel.add(kind);
        EXPECT_EQ(panel.all().back().kind, kind);
        EXPECT_EQ(panel.form.selected(), panel.all().size() - 1);
    }
    QTest::keyClick(panel.form.list(), Qt::Key_Delete);
    EXPECT_EQ(panel.all().back().kind, "caption");
    panel.history.undo();
    EXPECT_EQ(panel.all().back().kind, "legend");
}

TEST(AnnotationForm, WritingIsOneStep) {
    Panel panel;
    panel.form.writeWords(0);
    QTest::keyClicks(panel.form.words(), "Os");
    EXPECT_EQ(panel.all()[0].text, "Os");
    EXPECT_EQ(panel.form.list()->item(0)->text(), "Label: Os");
    panel.history.undo();
    EXPECT_EQ(panel.all()[0].text, "Core");
    EXPECT_FALSE(panel.history.canUndo());
}

TEST(AnnotationForm, MarksWordsWithTags) {
    Panel panel;
    panel.form.writeWords(0);
    auto* bold = panel.form.findChild<QToolButton*>("b");
    ASSERT_NE(bold, nullptr);
    bold->click();
    EXPECT_EQ(panel.all()[0].text, "<b>Core</b>");
    bold->click();
    EXPECT_EQ(panel.all()[0].text, "Core") << "a second time takes it away";
    panel.form.words()->moveCursor(QTextCursor::End);
    panel.form.findChild<QToolButton*>("sub")->click();
    QTest::keyClicks(panel.form.words(), "2");
    EXPECT_EQ(panel.all()[0].text, "Core<sub>2</sub>") << "what is typed stands between the tags";
}

TEST(AnnotationForm, ChangesLooksAndPlaces) {
    Panel panel;
    panel.form.select(0);
    panel.form.size()->setValue(12);
    EXPECT_EQ(panel.all()[0].sizePt, 12);
    panel.form.size()->setValue(0);
    EXPECT_EQ(panel.all()[0].sizePt, std::nullopt) << "the usual size again";
    panel.form.across()->setValue(25);
    ASSERT_TRUE(panel.all()[0].at);
    EXPECT_NEAR(panel.all()[0].at->x, 0.25, 1e-9);
    EXPECT_FALSE(panel.form.placedByItself()->isChecked());
    panel.form.placedByItself()->click();
    EXPECT_EQ(panel.all()[0].at, std::nullopt) << "given back to the layout";
    panel.form.layoutChoice()->setCurrentIndex(1);
    Q_EMIT panel.form.layoutChoice()->activated(1);
    EXPECT_EQ(panel.history.current()->annotationLayout, "ring");
    panel.form.select(1);
    panel.form.length()->setValue(30);
    EXPECT_EQ(panel.all()[1].lengthMm, 30);
}

/// The viewport with a real feed: what is shown is what a render thread made.
struct Shown {
    Shown() : history(letteredFigure()) {
        viewport.resize(436, 436); // a sheet of 400 pixels
        const auto apply = [this](const Edit& edit) {
            history.apply(edit);
            show();
        };
        QObject::connect(&overlay, &AnnotationOverlay::edited, apply);
        QObject::connect(&tool, &ToolOverlay::edited, apply);
        QObject::connect(&feed, &PictureFeed::arrived, [this](const ScreenPicture& picture) {
            viewport.setPicture(picture);
            finals += picture.facts.final ? 1 : 0;
        });
        viewport.show();
        overlay.setActive(true);
        show();
    }
    void show() {
        viewport.setFigure(history.current());
        overlay.setFigure(history.current());
        tool.setFigure(history.current());
        feed.want(history.current(), viewport.picturePixels(), false);
    }
    bool settle() {
        return pumpUntil([this] {
            const auto& picture = viewport.picture();
            return picture && picture->facts.final &&
                   picture->plan->figure->annotations == history.current()->annotations &&
                   picture->plan->figure->camera == history.current()->camera;
        });
    }
    [[nodiscard]] const std::vector<Annotation>& all() const { return history.current()->annotations; }

    Viewport viewport;
    AnnotationOverlay overlay{&viewport};
    LabelTool tool{&viewport};
    History history;
    std::shared_ptr<Planner> planner = std::make_shared<Planner>();
    std::atomic<int> plans{0};
    int finals = 0;
    PictureFeed feed{[this](const Figure& figure, const PlanRequest& request, Task& task) {
                         ++plans;
                         return planner->plan(figure, request, task);
                     },
                     makeCpuBackend()};
};

void move(Viewport& viewport, QPointF to) {
    QMouseEvent event(QEvent::MouseMove, to, viewport.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&viewport, &event);
}

TEST(AnnotationOverlay, DragsLetteringWithoutRendering) {
    Shown shown;
    ASSERT_TRUE(shown.settle());
    const auto middle = shown.overlay.middleOf(0);
    ASSERT_TRUE(middle);
    const int plans = shown.plans;
    const Camera camera = shown.history.current()->camera;
    const QImage before = shown.viewport.picture()->image;
    QTest::mousePress(&shown.viewport, Qt::LeftButton, {}, middle->toPoint());
    for (const double way : {10.0, 30.0, 60.0})
        move(shown.viewport, *middle + QPointF(-way, -way));
    QTest::mouseRelease(&shown.viewport, Qt::LeftButton, {}, (*middle + QPointF(-60, -60)).toPoint());
    ASSERT_TRUE(shown.all()[0].at);
    EXPECT_EQ(shown.overlay.selected(), 0U);
    EXPECT_EQ(shown.history.current()->camera, camera) << "the view stays";
    ASSERT_TRUE(shown.settle());
    const auto now = shown.overlay.middleOf(0);
    ASSERT_TRUE(now);
    EXPECT_NEAR(now->x(), middle->x() - 60, 2);
    EXPECT_NEAR(now->y(), middle->y() - 60, 2);
    EXPECT_NE(shown.viewport.picture()->image, before);
    EXPECT_EQ(shown.plans, plans) << "the still is lettered again";
    shown.history.undo();
    EXPECT_EQ(shown.all()[0].at, std::nullopt) << "one step";
}

TEST(AnnotationOverlay, DragsPointsOverMatter) {
    Shown shown;
    ASSERT_TRUE(shown.settle());
    const auto point = shown.overlay.pointOf(0);
    ASSERT_TRUE(point);
    const glm::dvec3 before = *shown.all()[0].anchorMm;
    QTest::mousePress(&shown.viewport, Qt::LeftButton, {}, point->toPoint());
    move(shown.viewport, *point + QPointF(20, 0)); // 4 mm at 80 mm in 400 pixels
    const glm::dvec3 now = *shown.all()[0].anchorMm;
    EXPECT_NEAR(now.x - before.x, 4, 0.3);
    EXPECT_LT(now.y, before.y) << "on the ball's front";
    move(shown.viewport, *point + QPointF(150, 0)); // beside the ball: no matter
    EXPECT_EQ(*shown.all()[0].anchorMm, now);
    QTest::mouseRelease(&shown.viewport, Qt::LeftButton, {}, (*point + QPointF(150, 0)).toPoint());
}

TEST(AnnotationOverlay, LeavesTheRestToTheViewport) {
    Shown shown;
    ASSERT_TRUE(shown.settle());
    int clicks = 0;
    int removals = 0;
    QObject::connect(&shown.viewport, &Viewport::clicked, [&] { ++clicks; });
    QObject::connect(&shown.overlay, &AnnotationOverlay::removeWanted, [&] { ++removals; });
    QTest::mouseClick(&shown.viewport, Qt::LeftButton, {}, shown.viewport.sheet().topLeft().toPoint() + QPoint(9, 99));
    EXPECT_EQ(clicks, 1);
    QTest::keyClick(&shown.viewport, Qt::Key_Delete);
    EXPECT_EQ(removals, 0) << "nothing is chosen";
    shown.overlay.select(0);
    QTest::keyClick(&shown.viewport, Qt::Key_Delete);
    EXPECT_EQ(removals, 1);
    shown.overlay.setActive(false);
    QTest::mouseClick(&shown.viewport, Qt::LeftButton, {}, shown.overlay.pointOf(0)->toPoint());
    EXPECT_EQ(clicks, 2) << "no handles while the panel is hidden";
}

TEST(LabelTool, ClicksOnMatter) {
    Shown shown;
    ASSERT_TRUE(shown.settle());
    int labelled = 0;
    QObject::connect(&shown.tool, &LabelTool::labelled, [&] { ++labelled; });
    shown.tool.take();
    QTest::mouseClick(&shown.tool, Qt::LeftButton, {}, shown.viewport.sheet().topLeft().toPoint() + QPoint(5, 5));
    EXPECT_EQ(shown.all().size(), 2U) << "paper has no name";
    EXPECT_TRUE(shown.tool.taken());
    QTest::mouseClick(&shown.tool, Qt::LeftButton, {}, shown.viewport.sheet().center().toPoint());
    ASSERT_EQ(shown.all().size(), 3U);
    EXPECT_EQ(labelled, 1);
    EXPECT_TRUE(shown.tool.taken()) << "the next one needs no second way through the menu";
    EXPECT_TRUE(shown.tool.accessibleDescription().contains("next")) << "what is read aloud is what is shown";
    const glm::dvec3 middle = shown.history.current()->volume->data->grid().centreMm();
    const glm::dvec3 point = *shown.all()[2].anchorMm;
    EXPECT_NEAR(point.x, middle.x, 0.5);
    EXPECT_NEAR(middle.y - point.y, 12, 2) << "the core's radius is six voxels of 2 mm";
}

} // namespace
} // namespace limner
