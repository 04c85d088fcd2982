#include "widgets/layer_parts_form.h"

#include "widgets/clip_form.h"
#include "widgets/curve_editor.h"
#include "widgets/form_parts.h"
#include "widgets/ramp_forms.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {
namespace {

PartForm* found(const std::vector<PartForm*>& parts, std::string_view pointer) {
    const auto part = std::find_if(parts.begin(), parts.end(), [&](PartForm* p) { return p->pointer() == pointer; });
    return part == parts.end() ? nullptr : *part;
}

QVBoxLayout* column(QWidget* of) {
    auto* layout = new QVBoxLayout(of);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    return layout;
}

PartForm* silhouetteForm() {
    auto* form = new PartFormOf<Silhouette>("/layers/*/silhouette", layerPart<&Layer::silhouette>());
    form->addColour("/layers/*/silhouette/rgb", [](Silhouette& s) -> glm::dvec3& { return s.rgb; });
    // The parameter table has one range; its ends keep their order.
    const auto end = [form](glm::length_t i, const QString& label) {
        auto* row = new ParameterRow("/layers/*/silhouette/range", {0, 1, 3});
        addLabelled(form->rows(), label, row, row->slider());
        form->onShow([=](const Silhouette& s) { row->setValue(s.range[i]); });
        QObject::connect(row, &ParameterRow::changed, form, [=](double to, const std::string& key, bool ongoing) {
            form->change(PartForm::tr("Change range of silhouette"), key + "/" + std::to_string(i), ongoing,
                         [=](Silhouette& s) {
                             s.range[i] = to;
                             s.range[1 - i] = i == 0 ? std::max(to, s.range[1]) : std::min(to, s.range[0]);
                         });
        });
        row->setObjectName(i == 0 ? "silhouette.full" : "silhouette.none");
    };
    end(0, PartForm::tr("Full up to"));
    end(1, PartForm::tr("None from"));
    form->addNumber("/layers/*/silhouette/opacity", {0, 1, 2}, [](Silhouette& s) -> double& { return s.opacity; });
    return form;
}

PartForm* specularForm() {
    auto* form = new PartFormOf<Specular>("/layers/*/specular", layerPart<&Layer::specular>());
    form->addNumber("/layers/*/specular/strength", {0, 1, 2}, [](Specular& s) -> double& { return s.strength; });
    form->addNumber("/layers/*/specular/exponent", {1, 200, 1}, [](Specular& s) -> double& { return s.exponent; });
    return form;
}

PartForm* phongForm() {
    auto* form = new PartFormOf<PhongLight>("/layers/*/phong", layerPart<&Layer::phong>());
    form->addNumber("/layers/*/phong/ambient", {0, 1, 2}, [](PhongLight& p) -> double& { return p.ambient; });
    form->addNumber("/layers/*/phong/diffuse", {0, 1, 2}, [](PhongLight& p) -> double& { return p.diffuse; });
    return form;
}

PartForm* curveForm(const char* pointer, const PartFormOf<OpacityPoints>::Access& access) {
    auto* form = new PartFormOf<OpacityPoints>(pointer, access);
    auto* curve = new CurveEditor(PartForm::tr("gradient"));
    form->rows()->addRow(curve);
    form->onShow([curve](const OpacityPoints& points) { curve->setPoints(points); });
    QObject::connect(curve, &CurveEditor::changed, form,
                     [form](const OpacityPoints& to, const QString& what, const std::string& key, bool ongoing) {
                         form->change(what, key, ongoing, [&](OpacityPoints& points) { points = to; });
                     });
    return form;
}

/// Flat regions clear, boundaries whole.
OpacityPoints firstCurve(const Figure&) { return {{0, 0}, {0.25, 1}, {1, 1}}; }

PartForm* depthOfFieldForm() {
    auto* form = new PartFormOf<DepthOfField>("/layers/*/depth_of_field", layerPart<&Layer::depthOfField>());
    form->addNumber("/layers/*/depth_of_field/focus", {0, 1, 2}, [](DepthOfField& d) -> double& { return d.focus; });
    form->addNumber("/layers/*/depth_of_field/strength", {0, 5, 2},
                    [](DepthOfField& d) -> double& { return d.strength; });
    return form;
}

/// How a form reaches one of the depth cues, which leave the figure with the last of them.
template <auto Member,
          class Part = typename std::remove_reference_t<decltype(std::declval<DepthCues>().*Member)>::value_type>
typename PartFormOf<Part>::Access depthCue() {
    return {[](const Figure& figure, std::size_t) {
                return figure.depthCues ? (*figure.depthCues).*Member : std::optional<Part>();
            },
            [](Figure& figure, std::size_t, std::optional<Part> part) {
                DepthCues cues = figure.depthCues.value_or(DepthCues{});
                cues.*Member = std::move(part);
                figure.depthCues = cues == DepthCues{} ? std::nullopt : std::optional(cues);
            },
            [](const Figure&) { return Part{}; }};
}

PartForm* occlusionForm() {
    using T = AmbientOcclusion;
    auto* form = new PartFormOf<T>("/depth_cues/ambient_occlusion", depthCue<&DepthCues::ambientOcclusion>());
    form->addNumber("/depth_cues/ambient_occlusion/strength", {0, 1, 2}, [](T& t) -> double& { return t.strength; });
    form->addNumber("/depth_cues/ambient_occlusion/reach_mm", {0, 60, 1}, [](T& t) -> double& { return t.reachMm; });
    return form;
}

PartForm* shadowForm() {
    using T = ContactShadow;
    auto* form = new PartFormOf<T>("/depth_cues/shadow", depthCue<&DepthCues::shadow>());
    form->addNumber("/depth_cues/shadow/strength", {0, 1, 2}, [](T& t) -> double& { return t.strength; });
    form->addNumber("/depth_cues/shadow/reach_mm", {0, 100, 1}, [](T& t) -> double& { return t.reachMm; });
    form->addNumber("/depth_cues/shadow/soft_deg", {0, 60, 0}, [](T& t) -> double& { return t.softDeg; });
    form->addLight("/depth_cues/shadow/light", [](T& t) -> Light& { return t.light; });
    return form;
}

PartForm* haloForm() {
    using T = Halo;
    auto* form = new PartFormOf<T>("/depth_cues/halo", depthCue<&DepthCues::halo>());
    form->addColour("/depth_cues/halo/rgb", [](T& t) -> glm::dvec3& { return t.rgb; });
    form->addNumber("/depth_cues/halo/strength", {0, 1, 2}, [](T& t) -> double& { return t.strength; });
    form->addNumber("/depth_cues/halo/width_mm", {0, 6, 2}, [](T& t) -> double& { return t.widthMm; });
    form->addNumber("/depth_cues/halo/depth_mm", {0, 100, 1}, [](T& t) -> double& { return t.depthMm; });
    return form;
}

} // namespace

LayerPartsForm::LayerPartsForm(QWidget* parent)
    : QWidget(parent), tone_(new ToneForm), position_(new PositionForm), clip_(new ClipForm), phong_(phongForm()) {
    column(this);
    for (PartForm* part :
         {static_cast<PartForm*>(tone_), silhouetteForm(), specularForm(), phong_,
          curveForm("/layers/*/gradient_opacity", layerPart<&Layer::gradientOpacity>(firstCurve)),
          curveForm("/layers/*/line_gradient_opacity", layerPart<&Layer::lineGradientOpacity>(firstCurve)),
          static_cast<PartForm*>(position_), depthOfFieldForm(), static_cast<PartForm*>(clip_)})
        add(part);
    setFigure(nullptr, 0);
}

void LayerPartsForm::add(PartForm* part) {
    parts_.push_back(part);
    layout()->addWidget(part);
    connect(part, &PartForm::edited, this, &LayerPartsForm::edited);
}

void LayerPartsForm::setFigure(const std::shared_ptr<const Figure>& figure, std::size_t layer) {
    for (PartForm* part : parts_)
        part->setFigure(figure, layer);
    const bool phong = figure && layer < figure->layers.size() && figure->layers[layer].shading == Shading::phong;
    phong_->setVisible(phong);
}

PartForm* LayerPartsForm::part(std::string_view pointer) const { return found(parts_, pointer); }

DepthCuesForm::DepthCuesForm(QWidget* parent) : QWidget(parent) {
    column(this);
    for (PartForm* part : {occlusionForm(), shadowForm(), haloForm()})
        add(part);
    setFigure(nullptr);
}

void DepthCuesForm::add(PartForm* part) {
    parts_.push_back(part);
    layout()->addWidget(part);
    connect(part, &PartForm::edited, this, &DepthCuesForm::edited);
}

void DepthCuesForm::setFigure(const std::shared_ptr<const Figure>& figure) {
    for (PartForm* part : parts_)
        part->setFigure(figure, 0);
}

PartForm* DepthCuesForm::part(std::string_view pointer) const { return found(parts_, pointer); }

} // namespace limner
