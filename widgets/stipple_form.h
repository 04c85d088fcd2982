#pragma once

#include "core/project/history.h"

#include <QWidget>

#include <memory>
#include <string_view>

class QCheckBox;
class QComboBox;
class QLabel;
class QMenu;
class QSpinBox;

namespace limner {

class ColourButton;
class ParameterRow;
class PartForm;
class StipplePart;

/// The figure's marks of ink: whether it has any, a menu of ready-made looks, the ink and its dots, the factors of
/// their tone, lines and strokes, and how the marks stand to the layers.
class StippleForm : public QWidget {
    Q_OBJECT

  public:
    explicit StippleForm(QWidget* parent = nullptr);

    void setFigure(const std::shared_ptr<const Figure>& figure);
    /// The switch of the whole.
    [[nodiscard]] QCheckBox* inked() const;
    [[nodiscard]] QMenu* presets() const;
    /// A factor, or a family of lines, by its pointer: "/stipple/lighting"; null where there is none.
    [[nodiscard]] PartForm* part(std::string_view pointer) const;
    /// A number, be it of the whole or of a part; null where there is none.
    [[nodiscard]] ParameterRow* row(std::string_view pointer) const;
    [[nodiscard]] QComboBox* choice(std::string_view pointer) const;
    [[nodiscard]] ColourButton* ink() const;
    [[nodiscard]] QCheckBox* fromStyle() const;
    [[nodiscard]] QSpinBox* seed() const;

  Q_SIGNALS:
    void edited(const limner::Edit& edit);

  private:
    StipplePart* whole_;
    QLabel* none_; ///< says what the panel is for
};

} // namespace limner
