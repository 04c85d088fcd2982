#pragma once

#include "core/project/history.h"
#include "widgets/style_ball_cache.h"

#include <QWidget>

#include <memory>

class QListWidget;
class QListWidgetItem;

namespace limner {

class LayerForm;

/// The figure's layers: which is selected, which show, and how the selected one is drawn.
class LayerList : public QWidget {
    Q_OBJECT

  public:
    explicit LayerList(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure);
    [[nodiscard]] std::size_t selectedLayer() const { return selected_; }
    [[nodiscard]] QListWidget* list() const { return list_; }
    [[nodiscard]] LayerForm* form() const { return form_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void layerSelected(std::size_t layer);

  private:
    void itemChanged(const QListWidgetItem* item);
    void emitLayer(std::size_t index, const Layer& layer, const QString& label);

    QListWidget* list_;
    LayerForm* form_;
    std::shared_ptr<const Figure> figure_;
    std::size_t selected_ = 0;
    bool filling_ = false;
    StyleBallCache balls_;
};

} // namespace limner
