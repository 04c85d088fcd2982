#pragma once

#include "core/project/history.h"
#include "widgets/gesture_key.h"

#include <QWidget>

#include <cstddef>
#include <functional>
#include <memory>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSlider;

namespace limner {

/// How one layer of the figure is drawn: opacity, transparency, shading and contours.
class LayerForm : public QWidget {
    Q_OBJECT

  public:
    explicit LayerForm(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer);
    [[nodiscard]] QSlider* opacity() const { return slider_; }
    [[nodiscard]] QComboBox* transparency() const { return transparency_; }
    [[nodiscard]] QComboBox* shading() const { return shading_; }
    [[nodiscard]] QCheckBox* contours() const { return contours_; }
    [[nodiscard]] QDoubleSpinBox* thickness() const { return thickness_; }
    [[nodiscard]] QCheckBox* evenWidth() const { return evenWidth_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);

  private:
    /// What an edit is called, and whether it merges with others of its gesture.
    struct Words {
        QString label;
        std::string mergeKey;
        bool ongoing = false;
    };

    void buildOpacity();
    void buildChoices();
    void buildContours();
    void layOut();
    void showLayer();
    void editLayer(const Words& words, const std::function<void(Layer&)>& change);
    void setOpacity(double opacity, bool ongoing);
    [[nodiscard]] bool any() const { return figure_ && layer_ < figure_->layers.size(); }

    QSlider* slider_;
    QDoubleSpinBox* percent_;
    QComboBox* transparency_;
    QComboBox* shading_;
    QCheckBox* contours_;
    QDoubleSpinBox* thickness_;
    QCheckBox* evenWidth_;
    std::shared_ptr<const Figure> figure_;
    std::size_t layer_ = 0;
    GestureKey key_;
};

} // namespace limner
