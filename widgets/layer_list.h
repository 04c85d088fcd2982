#pragma once

#include "core/project/history.h"
#include "widgets/gesture_key.h"
#include "widgets/style_ball_cache.h"

#include <QWidget>

#include <memory>

class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QListWidgetItem;
class QSlider;

namespace limner {

/// The figure's layers: which is selected, which show, and the selected one's opacity and shading.
class LayerList : public QWidget {
    Q_OBJECT

  public:
    explicit LayerList(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure);
    [[nodiscard]] std::size_t selectedLayer() const { return selected_; }
    [[nodiscard]] QListWidget* list() const { return list_; }
    [[nodiscard]] QSlider* opacity() const { return slider_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void layerSelected(std::size_t layer);

  private:
    void itemChanged(const QListWidgetItem* item);
    void showSelected();
    void emitLayer(std::size_t index, const Layer& layer, const QString& label, const std::string& key, bool ongoing);
    void setOpacity(double opacity, bool ongoing);

    QListWidget* list_;
    QSlider* slider_;
    QDoubleSpinBox* percent_;
    QComboBox* shading_;
    std::shared_ptr<const Figure> figure_;
    std::size_t selected_ = 0;
    bool filling_ = false;
    GestureKey key_;
    StyleBallCache balls_;
};

} // namespace limner
