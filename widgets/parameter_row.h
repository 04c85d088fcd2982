#pragma once

#include "widgets/gesture_key.h"

#include <QWidget>

#include <string>

class QDoubleSpinBox;
class QImage;
class QLabel;
class QSlider;

namespace limner {

struct Parameter;

/// A number of the figure as a slider over the range that is of use and a box that reaches all that is legal. Label,
/// help, unit and range are the parameter table's.
class ParameterRow : public QWidget {
    Q_OBJECT

  public:
    struct Useful {
        double low = 0;
        double high = 1;
        int decimals = 2;
        double power = 1; ///< of the slider's way: 2 gives small values more of it
    };

    /// `pointer`: of a number in the parameter table ("/importance/global").
    ParameterRow(std::string pointer, const Useful& useful, QWidget* parent = nullptr);

    /// Another range for the slider, of a scan's values for one. Nothing else changes; no signal.
    void setUseful(const Useful& useful);
    /// Shows a value without a signal. A slider under the hand stays where it is.
    void setValue(double value);
    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] QString label() const;
    [[nodiscard]] QSlider* slider() const { return slider_; }
    [[nodiscard]] QDoubleSpinBox* box() const { return box_; }
    /// A small picture of what the number does, before the slider; none at first.
    void setPicture(const QImage& picture);
    [[nodiscard]] QLabel* picture() const { return picture_; }

  Q_SIGNALS:
    /// `key`: one per drag and per run of key presses. The last of a drag is not ongoing.
    void changed(double value, const std::string& key, bool ongoing);

  private:
    [[nodiscard]] double sliderValue() const;
    void connectParts();

    std::string pointer_;
    const Parameter* parameter_;
    Useful useful_;
    QSlider* slider_;
    QDoubleSpinBox* box_;
    QLabel* picture_;
    GestureKey key_;
    bool dragged_ = false; ///< a press alone must not round the value to the slider's steps
};

} // namespace limner
