#include "widgets/layer_form.h"

#include "core/figure/layer_edits.h"
#include "widgets/form_parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>
#include <initializer_list>

namespace limner {
namespace {

constexpr int kSliderSteps = 200; // half a percent each
constexpr double kThickestMm = 100;

/// Fields side by side; `wide` takes the room that is left.
QWidget* row(std::initializer_list<QWidget*> fields, const QWidget* wide) {
    auto* widget = new QWidget;
    auto* layout = new QHBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    for (QWidget* field : fields)
        layout->addWidget(field, field == wide ? 1 : 0);
    return widget;
}

template <class Value>
void select(QComboBox* box, Value value) {
    box->setCurrentIndex(box->findData(static_cast<int>(value)));
}

} // namespace

LayerForm::LayerForm(QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal)), percent_(new QDoubleSpinBox), transparency_(new QComboBox),
      shading_(new QComboBox), contours_(new QCheckBox), thickness_(new QDoubleSpinBox),
      evenWidth_(new QCheckBox(tr("Even &width"))) {
    buildOpacity();
    buildChoices();
    buildContours();
    layOut();
    showLayer();
}

void LayerForm::buildOpacity() {
    slider_->setRange(0, kSliderSteps);
    slider_->setAccessibleName(tr("Layer opacity"));
    slider_->setToolTip(tr("Multiplies the opacity of the whole layer, in percent"));
    percent_->setRange(0, 100);
    percent_->setDecimals(1);
    percent_->setSuffix(tr(" %"));
    percent_->setKeyboardTracking(false);
    percent_->setAccessibleName(tr("Layer opacity in percent"));
    percent_->setToolTip(slider_->toolTip());
    connect(slider_, &QSlider::sliderPressed, this, [this] { key_.begin("layer/opacity"); });
    connect(slider_, &QSlider::valueChanged, this,
            [this](int value) { setOpacity(static_cast<double>(value) / kSliderSteps, slider_->isSliderDown()); });
    connect(slider_, &QSlider::sliderReleased, this,
            [this] { setOpacity(static_cast<double>(slider_->value()) / kSliderSteps, false); });
    connect(percent_, &QDoubleSpinBox::valueChanged, this, [this](double value) { setOpacity(value / 100, false); });
}

void LayerForm::buildChoices() {
    transparency_->addItem(tr("Uniform"), static_cast<int>(Transparency::uniform));
    transparency_->addItem(tr("Illustrative"), static_cast<int>(Transparency::illustrative));
    transparency_->setAccessibleName(tr("Transparency"));
    transparency_->setToolTip(
        tr("Illustrative: clear where the surface faces the viewer, opaque where it turns away, as illustrators draw"));
    connect(transparency_, &QComboBox::activated, this, [this](int row) {
        editLayer({tr("Change transparency"), {}}, [&](Layer& layer) {
            layer.transparency = static_cast<Transparency>(transparency_->itemData(row).toInt());
        });
    });
    shading_->addItem(tr("Style"), static_cast<int>(Shading::style));
    shading_->addItem(tr("Phong"), static_cast<int>(Shading::phong));
    shading_->addItem(tr("Flat"), static_cast<int>(Shading::flat));
    shading_->setAccessibleName(tr("Shading"));
    shading_->setToolTip(tr("How light is drawn: by the styles, by a head light, or not at all"));
    connect(shading_, &QComboBox::activated, this, [this](int row) {
        editLayer({tr("Change shading"), {}},
                  [&](Layer& layer) { layer.shading = static_cast<Shading>(shading_->itemData(row).toInt()); });
    });
}

void LayerForm::buildContours() {
    contours_->setAccessibleName(tr("Contours"));
    contours_->setToolTip(tr("Draws lines where the surface turns away, in the colours of the styles' rims"));
    thickness_->setRange(0, kThickestMm);
    thickness_->setDecimals(2);
    thickness_->setSingleStep(0.05);
    thickness_->setSuffix(tr(" mm"));
    thickness_->setKeyboardTracking(false);
    thickness_->setAccessibleName(tr("Contour thickness in millimetres on paper"));
    thickness_->setToolTip(tr("Width of the pen on paper"));
    thickness_->setValue(Contours{}.thicknessMm);
    evenWidth_->setToolTip(
        tr("The line follows the curvature: it keeps its width on flat and bent surfaces alike, not only on round "
           "ones"));
    evenWidth_->setChecked(Contours{}.curvatureControlled);
    connect(contours_, &QCheckBox::clicked, this, [this](bool on) {
        editLayer({on ? tr("Draw contours") : tr("Remove contours"), {}}, [&](Layer& layer) {
            layer.contours.reset();
            if (on) {
                layer.contours = Contours{thickness_->value(), evenWidth_->isChecked()};
            }
        });
    });
    connect(thickness_, &QDoubleSpinBox::valueChanged, this, [this](double mm) {
        editLayer({tr("Change contour thickness"), key_.again("layer/thickness")}, [&](Layer& layer) {
            if (layer.contours)
                layer.contours->thicknessMm = mm;
        });
    });
    connect(evenWidth_, &QCheckBox::clicked, this, [this](bool on) {
        editLayer({tr("Change contours"), {}}, [&](Layer& layer) {
            if (layer.contours)
                layer.contours->curvatureControlled = on;
        });
    });
}

void LayerForm::layOut() {
    QWidget* opacity = row({slider_, percent_}, slider_);
    QWidget* contours = row({contours_, thickness_, evenWidth_}, thickness_);
    QFormLayout* form = formLayout(this);
    addLabelled(form, tr("&Opacity"), opacity, slider_);
    addLabelled(form, tr("Transpa&rency"), transparency_);
    addLabelled(form, tr("Sh&ading"), shading_);
    addLabelled(form, tr("&Contours"), contours, contours_);
    for (QWidget* field : std::initializer_list<QWidget*>{slider_, percent_, transparency_, shading_, thickness_})
        leaveWheelToPanel(field);
}

void LayerForm::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) {
    figure_ = std::move(figure);
    layer_ = layer;
    showLayer();
}

void LayerForm::showLayer() {
    const QSignalBlocker quiet[] = {QSignalBlocker(slider_), QSignalBlocker(percent_), QSignalBlocker(thickness_)};
    setEnabled(any() && mayChange(*figure_, layer_));
    const Layer layer = any() ? figure_->layers[layer_] : Layer{};
    if (!slider_->isSliderDown())
        slider_->setValue(static_cast<int>(std::lround(layer.opacity * kSliderSteps)));
    percent_->setValue(layer.opacity * 100);
    select(transparency_, layer.transparency);
    select(shading_, layer.shading);
    contours_->setChecked(layer.contours.has_value());
    thickness_->setEnabled(layer.contours.has_value());
    evenWidth_->setEnabled(layer.contours.has_value());
    if (layer.contours) { // else the pen that was used last stays for the next contours
        thickness_->setValue(layer.contours->thicknessMm);
        evenWidth_->setChecked(layer.contours->curvatureControlled);
    }
}

void LayerForm::editLayer(const Words& words, const std::function<void(Layer&)>& change) {
    if (!any() || !mayChange(*figure_, layer_))
        return;
    Edit edit{*figure_, words.label.toStdString(), words.mergeKey, words.ongoing};
    change(edit.figure.layers[layer_]);
    Q_EMIT edited(edit);
}

void LayerForm::setOpacity(double opacity, bool ongoing) {
    editLayer(
        {tr("Change layer opacity"), ongoing ? key_.during("layer/opacity") : key_.again("layer/opacity"), ongoing},
        [&](Layer& layer) { layer.opacity = opacity; });
}

} // namespace limner
