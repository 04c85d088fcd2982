#pragma once

#include "widgets/ramp_canvas.h"

#include <QWidget>

#include <functional>

class QDoubleSpinBox;
class QMenu;
class QToolButton;

namespace limner {

class ColourButton;

/// A colour ramp with the selected key's numbers: a tone's colours, or tints, which have an opacity and may brighten.
class RampEditor : public QWidget {
    Q_OBJECT

  public:
    enum class Kind { colours, tints };

    explicit RampEditor(Kind kind, QWidget* parent = nullptr);

    void setKeys(const RampKeys& keys);
    /// Ready-made ramps by name and help; `use` is called with the place of the chosen one.
    void addPreset(const QString& name, const QString& help, const std::function<void()>& use);

    [[nodiscard]] RampCanvas* canvas() const { return canvas_; }
    [[nodiscard]] ColourButton* colour() const { return colour_; }
    [[nodiscard]] QDoubleSpinBox* place() const { return place_; }
    [[nodiscard]] QDoubleSpinBox* opacity() const { return opacity_; }
    [[nodiscard]] QDoubleSpinBox* brightness() const { return brightness_; }
    [[nodiscard]] QToolButton* add() const { return add_; }
    [[nodiscard]] QToolButton* step() const { return step_; }
    [[nodiscard]] QToolButton* remove() const { return remove_; }
    [[nodiscard]] QMenu* presets() const { return presets_; }

  Q_SIGNALS:
    void changed(const limner::RampKeys& keys, const QString& what, const std::string& key, bool ongoing);

  private:
    void buildFields();
    void layOut(Kind kind);
    void connectParts();
    void showSelection();
    void editSelected(const QString& what, const char* key, const std::function<void(RampKey&)>& change);

    RampCanvas* canvas_;
    ColourButton* colour_;
    QDoubleSpinBox* place_;
    QDoubleSpinBox* opacity_;    ///< percent; of tints
    QDoubleSpinBox* brightness_; ///< percent, the largest factor of the three; of tints
    QToolButton* add_;
    QToolButton* step_;
    QToolButton* remove_;
    QMenu* presets_;
    GestureKey gesture_;
};

} // namespace limner
