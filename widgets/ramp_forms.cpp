#include "widgets/ramp_forms.h"

#include "core/figure/camera_moves.h"
#include "core/figure/part_presets.h"
#include "widgets/core_words.h"
#include "widgets/form_parts.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

namespace limner {
namespace {

/// The editor under its words, over the whole width.
void addRamp(QFormLayout* rows, RampEditor* ramp, const std::string& pointer) {
    auto* label = new QLabel(labelOfSetting(pointer));
    label->setToolTip(helpOfSetting(pointer));
    label->setBuddy(ramp->canvas());
    rows->addRow(label);
    rows->addRow(ramp);
}

Tone firstTone(const Figure&) { return tonePresets().front().part; }

PositionRamp firstPosition(const Figure&) { return positionPresets().front().part; }

} // namespace

ToneForm::ToneForm()
    : PartFormOf<Tone>("/layers/*/tone", layerPart<&Layer::tone>(firstTone)),
      ramp_(new RampEditor(RampEditor::Kind::colours)) {
    addRamp(rows(), ramp_, "/layers/*/tone/keys");
    addNumber("/layers/*/tone/saturation", {0, 2, 2}, [](Tone& tone) -> double& { return tone.saturation; });
    light_ = addLight("/layers/*/tone/light", [](Tone& tone) -> Light& { return tone.light; });
    onShow([this](const Tone& tone) { ramp_->setKeys(rampOf(tone.keys)); });
    connect(ramp_, &RampEditor::changed, this,
            [this](const RampKeys& keys, const QString& what, const std::string& key, bool ongoing) {
                change(what, key, ongoing, [&](Tone& tone) { tone.keys = toneKeysOf(keys); });
            });
    for (const PartPreset<Tone>& preset : tonePresets()) {
        const QString name = coreWord(preset.name);
        ramp_->addPreset(name, coreWord(preset.help), [this, name, &preset] {
            change(tr("Tone “%1”").arg(name), {}, false, [&](Tone& tone) { // the light stays where it was put
                tone.keys = preset.part.keys;
                tone.saturation = preset.part.saturation;
            });
        });
    }
}

PositionForm::PositionForm()
    : PartFormOf<PositionRamp>("/layers/*/position", layerPart<&Layer::position>(firstPosition)), axis_(new QComboBox),
      ramp_(new RampEditor(RampEditor::Kind::tints)) {
    addAxis();
    addRamp(rows(), ramp_, "/layers/*/position/ramp");
    onShow([this](const PositionRamp& position) {
        axis_->setCurrentIndex(axis_->findData(QString::fromStdString(position.axis)));
        ramp_->setKeys(position.ramp);
    });
    connect(ramp_, &RampEditor::changed, this,
            [this](const RampKeys& keys, const QString& what, const std::string& key, bool ongoing) {
                change(what, key, ongoing, [&](PositionRamp& position) { position.ramp = keys; });
            });
    for (const PartPreset<PositionRamp>& preset : positionPresets()) {
        const QString name = coreWord(preset.name);
        ramp_->addPreset(name, coreWord(preset.help), [this, name, &preset] {
            change(tr("Colour by position “%1”").arg(name), {}, false,
                   [&](PositionRamp& position) { position = preset.part; });
        });
    }
}

void PositionForm::addAxis() {
    axis_->addItem(tr("View: near to far"), "view");
    axis_->addItem(tr("Right to left"), "x");
    axis_->addItem(tr("Front to back"), "y");
    axis_->addItem(tr("Bottom to top"), "z");
    axis_->addItem(tr("The view's direction here, kept"), "direction");
    axis_->setToolTip(helpOfSetting("/layers/*/position/axis"));
    axis_->setAccessibleName(labelOfSetting("/layers/*/position/axis"));
    axis_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    leaveWheelToPanel(axis_);
    addLabelled(rows(), labelOfSetting("/layers/*/position/axis"), axis_);
    connect(axis_, &QComboBox::activated, this, [this](int row) {
        change(tr("Change axis"), {}, false, [&](PositionRamp& position) {
            position.axis = axis_->itemData(row).toString().toStdString();
            if (position.axis == "direction")
                position.direction = cameraFrame(figure()->camera).forward;
        });
    });
}

} // namespace limner
