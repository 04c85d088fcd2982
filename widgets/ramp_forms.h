#pragma once

#include "widgets/part_form.h"
#include "widgets/ramp_editor.h"

namespace limner {

/// The tone of a layer: key colours, saturation, and the light.
class ToneForm : public PartFormOf<Tone> {
    Q_OBJECT

  public:
    ToneForm();
    [[nodiscard]] RampEditor* ramp() const { return ramp_; }
    [[nodiscard]] LightForm* light() const { return light_; }

  private:
    RampEditor* ramp_;
    LightForm* light_;
};

/// The colour of a layer by position: the axis, and tints along it.
class PositionForm : public PartFormOf<PositionRamp> {
    Q_OBJECT

  public:
    PositionForm();
    [[nodiscard]] RampEditor* ramp() const { return ramp_; }
    [[nodiscard]] QComboBox* axis() const { return axis_; }

  private:
    void addAxis();

    QComboBox* axis_;
    RampEditor* ramp_;
};

} // namespace limner
