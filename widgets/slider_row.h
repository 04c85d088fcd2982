#pragma once

#include "widgets/gesture_key.h"

#include <QString>
#include <QWidget>

#include <string>

class QDoubleSpinBox;
class QSlider;

namespace limner {

/// A number that is no figure's setting, as a slider and a box; settings of a figure have `ParameterRow`.
class SliderRow : public QWidget {
    Q_OBJECT

  public:
    struct Range {
        double low = 0;
        double high = 1;
        double step = 0.01; ///< of the slider and of the box's arrows
        int decimals = 2;
        QString suffix = {};
    };
    SliderRow(const QString& name, const QString& tip, const Range& range, QWidget* parent = nullptr);

    /// Shows a value without a signal.
    void setValue(double value);
    [[nodiscard]] QSlider* slider() const { return slider_; }
    [[nodiscard]] QDoubleSpinBox* box() const { return box_; }

  Q_SIGNALS:
    /// `key`: one per drag and per run of key presses. The last of a drag is not ongoing.
    void changed(double value, const std::string& key, bool ongoing);

  private:
    std::string name_;
    Range range_;
    QSlider* slider_;
    QDoubleSpinBox* box_;
    GestureKey key_;
    bool dragged_ = false;
};

} // namespace limner
