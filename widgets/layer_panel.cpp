#include "widgets/layer_panel.h"

#include "widgets/form_parts.h"
#include "widgets/layer_form.h"
#include "widgets/layer_list.h"
#include "widgets/layer_parts_form.h"
#include "widgets/part_form.h"

#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>

namespace limner {

LayerPanel::LayerPanel(QWidget* parent)
    : QWidget(parent), layers_(new LayerList), form_(new LayerForm), parts_(new LayerPartsForm),
      cues_(new DepthCuesForm) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(8, 4, 8, 8);
    column->setSpacing(8);
    column->addWidget(form_);
    column->addWidget(parts_);
    column->addSpacing(4);
    column->addWidget(heading(tr("Depth cues, over all layers")));
    column->addWidget(cues_);
    column->addStretch(1);
    QScrollArea* scroll = scrolling(content);
    auto* split = new QSplitter(Qt::Vertical);
    split->setChildrenCollapsible(false);
    split->addWidget(layers_);
    split->addWidget(scroll);
    split->setStretchFactor(0, 1);
    split->setStretchFactor(1, 2);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(split);
    scrollToOpened(scroll);
    connect(layers_, &LayerList::edited, this, &LayerPanel::edited);
    connect(form_, &LayerForm::edited, this, &LayerPanel::edited);
    connect(parts_, &LayerPartsForm::edited, this, &LayerPanel::edited);
    connect(cues_, &DepthCuesForm::edited, this, &LayerPanel::edited);
    connect(layers_, &LayerList::layerSelected, this, [this](std::size_t layer) {
        showLayer();
        Q_EMIT layerSelected(layer);
    });
}

void LayerPanel::setFigure(const std::shared_ptr<const Figure>& figure) {
    figure_ = figure;
    layers_->setFigure(figure);
    showLayer();
    cues_->setFigure(figure);
}

void LayerPanel::showLayer() {
    form_->setFigure(figure_, layers_->selectedLayer());
    parts_->setFigure(figure_, layers_->selectedLayer());
}

} // namespace limner
