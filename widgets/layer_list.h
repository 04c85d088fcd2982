#pragma once

#include "core/project/history.h"
#include "widgets/style_ball_cache.h"

#include <QWidget>

#include <functional>
#include <memory>

class QAction;
class QListWidgetItem;

namespace limner {

class LayerRows;

/// The figure's layers, the first to be drawn on top: which is selected, shown, solo or locked; they are added,
/// duplicated, deleted, renamed and put into another order. A locked layer can only be unlocked, shown or hidden, made
/// solo and copied.
class LayerList : public QWidget {
    Q_OBJECT

  public:
    explicit LayerList(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure);
    [[nodiscard]] std::size_t selectedLayer() const { return selected_; }
    [[nodiscard]] LayerRows* list() const { return list_; }
    [[nodiscard]] QAction* add() const { return add_; }
    [[nodiscard]] QAction* duplicate() const { return duplicate_; }
    [[nodiscard]] QAction* remove() const { return remove_; }
    [[nodiscard]] QAction* up() const { return up_; }
    [[nodiscard]] QAction* down() const { return down_; }
    [[nodiscard]] QAction* solo() const { return solo_; }
    [[nodiscard]] QAction* lock() const { return lock_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void layerSelected(std::size_t layer);

  private:
    QAction* action(const QString& text, const QString& tip, const QKeySequence& keys, void (LayerList::*run)());
    void buildActions();
    void layOut();
    void showRows();
    void showActions();
    void itemChanged(const QListWidgetItem* item);
    /// Emits the figure with other layers; `selected` is the chosen one then.
    void emitLayers(Figure changed, const QString& label, std::size_t selected);
    void emitLayer(std::size_t index, const Layer& layer, const QString& label);
    void moveLayer(std::size_t from, std::size_t to);
    void addLayer();
    void duplicateLayer();
    void removeLayer();
    void moveUp();
    void moveDown();
    void renameLayer();
    void setSolo(std::size_t layer);
    void setLocked(std::size_t layer);
    [[nodiscard]] bool any() const { return figure_ && selected_ < figure_->layers.size(); }

    LayerRows* list_;
    QAction* add_ = nullptr;
    QAction* duplicate_ = nullptr;
    QAction* remove_ = nullptr;
    QAction* up_ = nullptr;
    QAction* down_ = nullptr;
    QAction* rename_ = nullptr;
    QAction* solo_ = nullptr;
    QAction* lock_ = nullptr;
    QString removeTip_;
    std::shared_ptr<const Figure> figure_;
    std::size_t selected_ = 0;
    bool filling_ = false;
    StyleBallCache balls_;
};

} // namespace limner
