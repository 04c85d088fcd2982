#pragma once

#include "core/figure/presets.h"
#include "core/project/history.h"
#include "widgets/gesture_key.h"

#include <QWidget>

#include <array>
#include <functional>
#include <memory>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace limner {

class ClipForm;
class ParameterRow;

/// From where the figure is seen, in numbers, and what is cut away from all of it: the standard views, three angles,
/// the point in the middle, the height of what is shown, how strong the perspective is, crop box and clip planes. Edits
/// go out; a standard view is asked for, since it has to fit the figure into the picture.
class ViewForm : public QWidget {
    Q_OBJECT

  public:
    explicit ViewForm(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure);
    [[nodiscard]] ClipForm* clip() const { return clip_; }
    [[nodiscard]] QComboBox* projection() const { return projection_; }
    [[nodiscard]] ParameterRow* perspective() const { return perspective_; }
    [[nodiscard]] ParameterRow* height() const { return height_; }
    /// Turn, tilt, roll.
    [[nodiscard]] QDoubleSpinBox* angle(std::size_t i) const { return angles_[i]; }
    /// Along x, y, z.
    [[nodiscard]] QDoubleSpinBox* target(std::size_t axis) const { return target_[axis]; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void sideWanted(limner::StandardView side);
    void fitWanted();

  private:
    void buildSides(QFormLayout* form);
    void buildCamera(QFormLayout* form);
    void buildAngles(QFormLayout* form);
    void buildMiddle(QFormLayout* form);
    QDoubleSpinBox* numberField(const QString& name, const QString& tip);
    void changeCamera(const QString& label, const std::string& key, bool ongoing,
                      const std::function<void(Camera&)>& by);
    void changeAngles();

    std::shared_ptr<const Figure> figure_;
    QComboBox* projection_;
    ParameterRow* perspective_;
    ParameterRow* height_;
    std::array<QDoubleSpinBox*, 3> angles_{};
    std::array<QDoubleSpinBox*, 3> target_{};
    ClipForm* clip_;
    GestureKey gesture_;
};

} // namespace limner
