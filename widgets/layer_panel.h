#pragma once

#include "core/project/history.h"

#include <QWidget>

#include <memory>

namespace limner {

class DepthCuesForm;
class LayerForm;
class LayerList;
class LayerPartsForm;

/// The list of layers, and below it, to be scrolled, how the selected one is drawn and what holds for all of them.
class LayerPanel : public QWidget {
    Q_OBJECT

  public:
    explicit LayerPanel(QWidget* parent = nullptr);

    void setFigure(const std::shared_ptr<const Figure>& figure);
    [[nodiscard]] LayerList* layers() const { return layers_; }
    [[nodiscard]] LayerForm* form() const { return form_; }
    [[nodiscard]] LayerPartsForm* parts() const { return parts_; }
    [[nodiscard]] DepthCuesForm* depthCues() const { return cues_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void layerSelected(std::size_t layer);

  private:
    void showLayer();

    LayerList* layers_;
    LayerForm* form_;
    LayerPartsForm* parts_;
    DepthCuesForm* cues_;
    std::shared_ptr<const Figure> figure_;
};

} // namespace limner
