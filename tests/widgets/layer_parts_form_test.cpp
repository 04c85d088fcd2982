#include "widgets/layer_parts_form.h"

#include "core/figure/figure_json.h"
#include "widgets/clip_form.h"
#include "widgets/curve_editor.h"
#include "widgets/ramp_forms.h"
#include "widgets/test_figure.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>

namespace limner {
namespace {

/// Both forms over a history, as the window joins them; the second layer is shown.
struct Forms {
    Forms() {
        const auto apply = [this](const Edit& edit) {
            last = edit;
            history.apply(edit);
            show();
        };
        QObject::connect(&parts, &LayerPartsForm::edited, apply);
        QObject::connect(&cues, &DepthCuesForm::edited, apply);
        parts.resize(360, 1500);
        parts.show();
        show();
    }
    void show() {
        parts.setFigure(history.current(), 1);
        cues.setFigure(history.current());
    }
    void undo() {
        history.undo();
        show();
    }
    void change(const std::function<void(Figure&)>& by) {
        Edit edit{*history.current(), {}, {}, false};
        by(edit.figure);
        history.apply(edit);
        show();
    }
    [[nodiscard]] const Layer& layer() const { return history.current()->layers[1]; }
    [[nodiscard]] PartForm* part(const char* name) const { return parts.part(std::string("/layers/*/") + name); }
    ParameterRow* row(const char* part_, const char* pointer) const {
        return part(part_)->row(std::string("/layers/*/") + pointer);
    }

    History history{testing::smallFigure()};
    LayerPartsForm parts;
    DepthCuesForm cues;
    Edit last;
};

void choose(QComboBox* box, int row) {
    box->setCurrentIndex(row);
    Q_EMIT box->activated(row);
}

TEST(LayerPartsForm, EveryPartComesAndGoesByItsCheckBox) {
    Forms forms;
    forms.change([](Figure& figure) { figure.layers[1].shading = Shading::phong; });
    const Figure start = *forms.history.current();
    for (const char* name : {"tone", "silhouette", "specular", "phong", "gradient_opacity", "line_gradient_opacity",
                             "position", "depth_of_field", "clip"}) {
        SCOPED_TRACE(name);
        PartForm* part = forms.part(name);
        ASSERT_TRUE(part);
        EXPECT_FALSE(part->present()->isChecked());
        EXPECT_FALSE(part->present()->toolTip().isEmpty());
        const int collapsed = part->sizeHint().height();
        part->present()->click();
        EXPECT_TRUE(part->on());
        EXPECT_GT(part->sizeHint().height(), collapsed) << "its rows open";
        EXPECT_NE(forms.history.current()->layers[1], start.layers[1]);
        EXPECT_EQ(forms.history.current()->layers[0], start.layers[0]);
        for (const Problem& problem : validateFigure(*forms.history.current()))
            EXPECT_FALSE(problem.fatal) << problem.pointer << " " << problem.why;
        part->present()->click();
        EXPECT_EQ(*forms.history.current(), start) << "what is absent stays absent";
        forms.undo();
        EXPECT_TRUE(part->present()->isChecked());
        forms.undo();
        EXPECT_EQ(*forms.history.current(), start);
    }
}

TEST(LayerPartsForm, WhatWasSetComesBackButNotOnAnotherLayer) {
    Forms forms;
    PartForm* silhouette = forms.part("silhouette");
    silhouette->present()->click();
    forms.row("silhouette", "silhouette/opacity")->box()->setValue(0.4);
    silhouette->present()->click();
    silhouette->present()->click();
    EXPECT_EQ(forms.layer().silhouette->opacity, 0.4);
    silhouette->present()->click();
    forms.parts.setFigure(forms.history.current(), 0);
    forms.parts.setFigure(forms.history.current(), 1);
    silhouette->present()->click();
    EXPECT_EQ(forms.layer().silhouette, Silhouette{});
}

TEST(LayerPartsForm, NumbersGoWhereTheyBelong) {
    Forms forms;
    forms.change([](Figure& figure) { figure.layers[1].shading = Shading::phong; });
    for (const char* name : {"tone", "silhouette", "specular", "phong", "depth_of_field"})
        forms.part(name)->present()->click();
    const std::tuple<const char*, const char*, double (*)(const Layer&)> rows[] = {
        {"tone", "tone/saturation", [](const Layer& l) { return l.tone->saturation; }},
        {"silhouette", "silhouette/opacity", [](const Layer& l) { return l.silhouette->opacity; }},
        {"specular", "specular/strength", [](const Layer& l) { return l.specular->strength; }},
        {"specular", "specular/exponent", [](const Layer& l) { return l.specular->exponent; }},
        {"phong", "phong/ambient", [](const Layer& l) { return l.phong->ambient; }},
        {"phong", "phong/diffuse", [](const Layer& l) { return l.phong->diffuse; }},
        {"depth_of_field", "depth_of_field/focus", [](const Layer& l) { return l.depthOfField->focus; }},
        {"depth_of_field", "depth_of_field/strength", [](const Layer& l) { return l.depthOfField->strength; }}};
    double value = 0.30;
    for (const auto& [part, pointer, of] : rows) {
        SCOPED_TRACE(pointer);
        const double before = of(forms.layer());
        forms.row(part, pointer)->box()->setValue(value += 0.05);
        EXPECT_NEAR(of(forms.layer()), value, 0.051) << "to the digits of its field";
        EXPECT_NE(of(forms.layer()), before);
        forms.undo();
        EXPECT_EQ(of(forms.layer()), before);
    }
    forms.parts.findChild<ParameterRow*>("silhouette.full")->box()->setValue(0.6);
    EXPECT_EQ(forms.layer().silhouette->range, glm::dvec2(0.6, 0.6)) << "the ends keep their order";
    forms.parts.findChild<ParameterRow*>("silhouette.none")->box()->setValue(0.2);
    EXPECT_EQ(forms.layer().silhouette->range, glm::dvec2(0.2, 0.2));
    forms.part("silhouette")->findChild<ColourButton*>()->choose(QColor(255, 0, 0));
    EXPECT_EQ(forms.layer().silhouette->rgb, glm::dvec3(1, 0, 0));
}

TEST(LayerPartsForm, PhongsLightShowsUnderPhongOnly) {
    Forms forms;
    EXPECT_FALSE(forms.part("phong")->isVisible());
    forms.change([](Figure& figure) { figure.layers[1].shading = Shading::phong; });
    EXPECT_TRUE(forms.part("phong")->isVisible());
}

TEST(LayerPartsForm, ALockedLayersPartsStay) {
    Forms forms;
    forms.part("tone")->present()->click();
    forms.change([](Figure& figure) { figure.layers[1].locked = true; });
    const Figure locked = *forms.history.current();
    EXPECT_FALSE(forms.part("tone")->isEnabled());
    forms.parts.tone()->ramp()->canvas()->addKeyAt(0.3);
    forms.parts.tone()->ramp()->presets()->actions().back()->trigger();
    forms.row("tone", "tone/saturation")->box()->setValue(0.2);
    forms.part("clip")->present()->click();
    EXPECT_EQ(*forms.history.current(), locked);
    forms.cues.part("/depth_cues/halo")->present()->click();
    EXPECT_TRUE(forms.history.current()->depthCues) << "the figure's cues are not the layer's";
}

TEST(ToneForm, KeysAreDraggedInOneStep) {
    Forms forms;
    forms.part("tone")->present()->click();
    RampCanvas* canvas = forms.parts.tone()->ramp()->canvas();
    const Tone before = *forms.layer().tone;
    const std::size_t steps = forms.history.position();
    const QPoint from = canvas->positionOf(1).toPoint();
    const int width = canvas->positionOf(3).toPoint().x() - canvas->positionOf(0).toPoint().x();
    QTest::mousePress(canvas, Qt::LeftButton, {}, from);
    for (const double by : {0.05, 0.1, 0.15})
        QTest::mouseMove(canvas, from + QPoint(static_cast<int>(by * width), 0));
    EXPECT_TRUE(forms.last.ongoing);
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, from + QPoint(static_cast<int>(0.15 * width), 0));
    EXPECT_FALSE(forms.last.ongoing);
    EXPECT_NEAR(forms.layer().tone->keys[1].at, before.keys[1].at + 0.15, 0.01);
    EXPECT_EQ(forms.layer().tone->keys[1].rgb, before.keys[1].rgb);
    EXPECT_EQ(forms.history.position(), steps + 1);
    forms.undo();
    EXPECT_EQ(*forms.layer().tone, before);
    QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->positionOf(1).toPoint() + QPoint(2, 0));
    EXPECT_EQ(*forms.layer().tone, before) << "a press alone moves nothing";
}

TEST(ToneForm, KeysComeGoStepAndChangeColour) {
    Forms forms;
    forms.part("tone")->present()->click();
    RampEditor* ramp = forms.parts.tone()->ramp();
    const std::vector<ColourKey> before = forms.layer().tone->keys;
    ramp->canvas()->select(1);
    ramp->add()->click();
    ASSERT_EQ(forms.layer().tone->keys.size(), before.size() + 1);
    EXPECT_EQ(ramp->canvas()->selected(), 2U);
    EXPECT_DOUBLE_EQ(forms.layer().tone->keys[2].at, (before[1].at + before[2].at) / 2);
    ramp->colour()->choose(QColor(0, 255, 0));
    EXPECT_EQ(forms.layer().tone->keys[2].rgb, glm::dvec3(0, 1, 0));
    ramp->step()->click();
    ASSERT_EQ(forms.layer().tone->keys.size(), before.size() + 2);
    EXPECT_EQ(forms.layer().tone->keys[2].at, forms.layer().tone->keys[3].at);
    EXPECT_EQ(forms.layer().tone->keys[2].rgb, before[1].rgb);
    EXPECT_EQ(ramp->canvas()->selected(), 3U);
    ramp->place()->setValue(0.7);
    EXPECT_EQ(forms.layer().tone->keys[3].at, 0.7);
    ramp->canvas()->setFocus();
    QTest::keyClick(ramp->canvas(), Qt::Key_Left);
    EXPECT_NEAR(forms.layer().tone->keys[3].at, 0.69, 1e-12);
    QTest::keyClick(ramp->canvas(), Qt::Key_Delete);
    QTest::mouseClick(ramp->canvas(), Qt::RightButton, {}, ramp->canvas()->positionOf(2).toPoint());
    EXPECT_EQ(forms.layer().tone->keys, before);
    QTest::mouseDClick(ramp->canvas(), Qt::LeftButton, {}, QPoint(ramp->canvas()->width() / 2, 10));
    EXPECT_EQ(forms.layer().tone->keys.size(), before.size() + 1) << "a double click on the ramp adds";
}

TEST(ToneForm, PresetsKeepTheLight) {
    Forms forms;
    forms.part("tone")->present()->click();
    const std::size_t steps = forms.history.position();
    choose(forms.parts.tone()->light()->kind(), 1);
    EXPECT_EQ(forms.layer().tone->light.kind, "object");
    LightBall* ball = forms.parts.tone()->light()->ball();
    QTest::mousePress(ball, Qt::LeftButton, {}, QPoint(ball->width() / 2, ball->height() / 2));
    QTest::mouseRelease(ball, Qt::LeftButton, {}, QPoint(ball->width() / 2, ball->height() / 2));
    EXPECT_NEAR(glm::distance(forms.layer().tone->light.direction, {0, -1, 0}), 0, 1e-9) << "from the viewer";
    QTest::mousePress(ball, Qt::LeftButton, {}, QPoint(ball->width() - 1, ball->height() / 2));
    QTest::mouseRelease(ball, Qt::LeftButton, {}, QPoint(ball->width() - 1, ball->height() / 2));
    EXPECT_GT(forms.layer().tone->light.direction.y, 0.5) << "outside the rim: from behind";
    const Light light = forms.layer().tone->light;
    for (QAction* action : forms.parts.tone()->ramp()->presets()->actions())
        if (action->text() == "Cartoon")
            action->trigger();
    EXPECT_EQ(forms.layer().tone->keys.size(), 8U);
    EXPECT_EQ(forms.layer().tone->light, light);
    EXPECT_EQ(forms.history.position(), steps + 4);
}

TEST(PositionForm, TintsHaveOpacityAndBrighten) {
    Forms forms;
    forms.part("position")->present()->click();
    PositionForm* form = forms.parts.position();
    RampEditor* ramp = form->ramp();
    ramp->canvas()->select(2);
    ramp->opacity()->setValue(20);
    EXPECT_EQ(forms.layer().position->ramp[2].rgba.a, 0.2);
    ramp->colour()->choose(QColor(255, 0, 0));
    ramp->brightness()->setValue(150);
    EXPECT_EQ(forms.layer().position->ramp[2].rgba, glm::dvec4(1.5, 0, 0, 0.2));
    ramp->colour()->choose(QColor(0, 0, 255));
    EXPECT_EQ(forms.layer().position->ramp[2].rgba, glm::dvec4(0, 0, 1.5, 0.2)) << "it goes on brightening";
    choose(form->axis(), form->axis()->findData("z"));
    EXPECT_EQ(forms.layer().position->axis, "z");
    choose(form->axis(), form->axis()->findData("direction"));
    EXPECT_EQ(forms.layer().position->direction, glm::dvec3(0, 1, 0)) << "the way the viewer looks now";
    for (QAction* action : ramp->presets()->actions())
        if (action->text() == "Vertical fade")
            action->trigger();
    EXPECT_EQ(forms.layer().position->axis, "z");
    EXPECT_EQ(forms.layer().position->ramp.front().rgba.a, 0);
    EXPECT_EQ(form->axis()->currentData(), "z");
}

TEST(CurveEditor, PointsAreDraggedAddedAndRemoved) {
    Forms forms;
    forms.part("line_gradient_opacity")->present()->click();
    auto* curve = forms.part("line_gradient_opacity")->findChild<CurveEditor*>();
    ASSERT_TRUE(curve);
    const OpacityPoints before = *forms.layer().lineGradientOpacity;
    const auto at = [&](double x, double y) { return curve->positionOf({x, y}).toPoint(); };
    const std::size_t steps = forms.history.position();
    QTest::mousePress(curve, Qt::LeftButton, {}, at(0.25, 1));
    for (const double x : {0.3, 0.4, 0.5})
        QTest::mouseMove(curve, at(x, 0.6));
    QTest::mouseRelease(curve, Qt::LeftButton, {}, at(0.5, 0.6));
    EXPECT_NEAR((*forms.layer().lineGradientOpacity)[1].x, 0.5, 0.01);
    EXPECT_NEAR((*forms.layer().lineGradientOpacity)[1].y, 0.6, 0.02);
    EXPECT_EQ(forms.history.position(), steps + 1);
    EXPECT_FALSE(forms.layer().gradientOpacity) << "the other curve is another part";
    forms.undo();
    EXPECT_EQ(*forms.layer().lineGradientOpacity, before);
    QTest::mouseDClick(curve, Qt::LeftButton, {}, at(0.7, 0.3));
    ASSERT_EQ(forms.layer().lineGradientOpacity->size(), before.size() + 1);
    EXPECT_EQ(curve->selected(), 2U);
    curve->setFocus();
    QTest::keyClick(curve, Qt::Key_Up);
    EXPECT_NEAR((*forms.layer().lineGradientOpacity)[2].y, 0.31, 0.02);
    QTest::mouseClick(curve, Qt::RightButton, {}, curve->positionOf(curve->points()[2]).toPoint());
    EXPECT_EQ(*forms.layer().lineGradientOpacity, before);
    while (curve->points().size() > 1) {
        curve->select(0);
        QTest::keyClick(curve, Qt::Key_Delete);
    }
    curve->select(0);
    QTest::keyClick(curve, Qt::Key_Delete);
    EXPECT_EQ(forms.layer().lineGradientOpacity->size(), 1U) << "a curve keeps a point";
    curve->select(0);
    for (int i = 0; i < 30; ++i)
        QTest::keyClick(curve, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ((*forms.layer().lineGradientOpacity)[0].x, 1) << "it stays in 0 to 1";
}

TEST(ClipForm, PlanesAreCutAlongTheViewMovedFlippedAndRemoved) {
    Forms forms;
    forms.part("clip")->present()->click();
    ClipForm* clip = forms.parts.clip();
    const Camera camera = forms.history.current()->camera;
    ASSERT_EQ(forms.layer().clip->planes.size(), 1U);
    const ClipPlane plane = forms.layer().clip->planes[0];
    EXPECT_EQ(plane.normal, -camera.direction) << "towards the viewer";
    EXPECT_DOUBLE_EQ(plane.offsetMm, glm::dot(plane.normal, camera.targetMm)) << "through what is looked at";
    forms.change([](Figure& figure) { figure.camera.direction = {1, 0, 0}; });
    clip->cutHere()->click();
    ASSERT_EQ(forms.layer().clip->planes.size(), 2U);
    EXPECT_EQ(forms.layer().clip->planes[1].normal, glm::dvec3(-1, 0, 0));
    EXPECT_EQ(clip->planes()->currentRow(), 1);
    EXPECT_TRUE(clip->planes()->item(1)->text().contains("R side")) << clip->planes()->item(1)->text().toStdString();
    clip->offset()->box()->setValue(12.5);
    EXPECT_EQ(forms.layer().clip->planes[1].offsetMm, 12.5);
    EXPECT_EQ(forms.layer().clip->planes[0], plane);
    clip->flip()->click();
    EXPECT_EQ(forms.layer().clip->planes[1], (ClipPlane{{1, 0, 0}, -12.5}));
    clip->removePlane()->click();
    EXPECT_EQ(forms.layer().clip->planes, std::vector{plane});
    clip->removePlane()->click();
    EXPECT_TRUE(forms.layer().clip->planes.empty());
    EXPECT_FALSE(clip->removePlane()->isEnabled());
    EXPECT_EQ(forms.history.current()->clip, Clip{}) << "the figure's own clip is another";
}

TEST(ClipForm, TheBoxStartsAroundTheScanAndNeverEmpties) {
    Forms forms;
    forms.part("clip")->present()->click();
    ClipForm* clip = forms.parts.clip();
    EXPECT_FALSE(clip->boxEnd(0, 0)->isVisible());
    clip->box()->click();
    ASSERT_TRUE(forms.layer().clip->boxMm);
    EXPECT_EQ(forms.layer().clip->boxMm->low, glm::dvec3(-1)) << "half a voxel before the first centre";
    EXPECT_EQ(forms.layer().clip->boxMm->high, glm::dvec3(63));
    EXPECT_TRUE(clip->boxEnd(0, 0)->isVisible());
    clip->boxEnd(1, 0)->setValue(20);
    clip->boxEnd(2, 1)->setValue(-50);
    EXPECT_EQ(forms.layer().clip->boxMm->low, glm::dvec3(-1, 20, -1));
    EXPECT_NEAR(forms.layer().clip->boxMm->high.z, -0.9, 1e-12) << "held above its low end";
    for (const Problem& problem : validateFigure(*forms.history.current()))
        EXPECT_FALSE(problem.fatal) << problem.pointer;
    clip->box()->click();
    EXPECT_FALSE(forms.layer().clip->boxMm);
}

TEST(ClipForm, CutFacesAreDrawnInWhatIsChosen) {
    Forms forms;
    forms.part("clip")->present()->click();
    ClipForm* clip = forms.parts.clip();
    EXPECT_EQ(forms.layer().clip->face, CutFace{}) << "flat, as the layer";
    choose(clip->face(), 0);
    EXPECT_FALSE(forms.layer().clip->face);
    choose(clip->face(), 3);
    EXPECT_EQ(forms.layer().clip->face, (CutFace{"ivory", std::nullopt}));
    EXPECT_EQ(clip->face()->currentIndex(), 3);
    choose(clip->face(), 2);
    ASSERT_TRUE(forms.layer().clip->face->rgb);
    EXPECT_TRUE(clip->faceColour()->isVisible());
    clip->faceColour()->choose(QColor(0, 0, 255));
    EXPECT_EQ(forms.layer().clip->face, (CutFace{{}, glm::dvec3(0, 0, 1)}));
    choose(clip->face(), 1);
    EXPECT_EQ(forms.layer().clip->face, CutFace{});
    EXPECT_FALSE(clip->faceColour()->isVisible());
}

TEST(DepthCuesForm, CuesComeGoAndLeaveNothingBehind) {
    Forms forms;
    const Figure start = *forms.history.current();
    PartForm* halo = forms.cues.part("/depth_cues/halo");
    PartForm* occlusion = forms.cues.part("/depth_cues/ambient_occlusion");
    PartForm* shadow = forms.cues.part("/depth_cues/shadow");
    halo->present()->click();
    occlusion->present()->click();
    shadow->present()->click();
    halo->row("/depth_cues/halo/width_mm")->box()->setValue(2.5);
    halo->findChild<ColourButton*>()->choose(Qt::white);
    occlusion->row("/depth_cues/ambient_occlusion/reach_mm")->box()->setValue(30);
    shadow->row("/depth_cues/shadow/soft_deg")->box()->setValue(45);
    choose(shadow->findChild<LightForm*>()->kind(), 1);
    const DepthCues cues = *forms.history.current()->depthCues;
    EXPECT_EQ(cues.halo->widthMm, 2.5);
    EXPECT_EQ(cues.halo->rgb, glm::dvec3(1));
    EXPECT_EQ(cues.ambientOcclusion->reachMm, 30);
    EXPECT_EQ(cues.shadow->softDeg, 45);
    EXPECT_EQ(cues.shadow->light.kind, "object");
    occlusion->present()->click();
    shadow->present()->click();
    EXPECT_TRUE(forms.history.current()->depthCues->halo);
    halo->present()->click();
    EXPECT_FALSE(forms.history.current()->depthCues);
    EXPECT_EQ(*forms.history.current(), start);
}

} // namespace
} // namespace limner
