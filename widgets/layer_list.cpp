#include "widgets/layer_list.h"

#include "widgets/layer_form.h"

#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {
namespace {

constexpr int kBall = 22;

/// An icon that a selection does not colour: the style must stay what it is.
QIcon untinted(const QPixmap& pixmap) {
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

} // namespace

LayerList::LayerList(QWidget* parent) : QWidget(parent), list_(new QListWidget), form_(new LayerForm) {
    list_->setIconSize({kBall, kBall});
    list_->setAccessibleName(tr("Layers"));
    list_->setToolTip(tr("The check mark shows or hides a layer; a double click renames it"));
    list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(list_, 1);
    layout->addWidget(form_);

    connect(list_, &QListWidget::itemChanged, this, &LayerList::itemChanged);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (filling_ || row < 0)
            return;
        selected_ = static_cast<std::size_t>(row);
        form_->setFigure(figure_, selected_);
        Q_EMIT layerSelected(selected_);
    });
    connect(form_, &LayerForm::edited, this, &LayerList::edited);
}

void LayerList::setFigure(std::shared_ptr<const Figure> figure) {
    figure_ = std::move(figure);
    const std::size_t count = figure_ ? figure_->layers.size() : 0;
    filling_ = true;
    while (list_->count() > static_cast<int>(count))
        delete list_->takeItem(list_->count() - 1);
    while (list_->count() < static_cast<int>(count))
        list_->addItem(new QListWidgetItem);
    for (std::size_t i = 0; i < count; ++i) {
        const Layer& layer = figure_->layers[i];
        QListWidgetItem* item = list_->item(static_cast<int>(i));
        item->setText(layer.name.empty() ? tr("Layer %1").arg(i + 1) : QString::fromStdString(layer.name));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
        item->setCheckState(layer.visible ? Qt::Checked : Qt::Unchecked);
        if (!layer.transfer.nodes.empty())
            item->setIcon(untinted(balls_.ball(*figure_, layer.transfer.nodes.front(), kBall, devicePixelRatioF())));
    }
    selected_ = count == 0 ? 0 : std::min(selected_, count - 1);
    if (count > 0)
        list_->setCurrentRow(static_cast<int>(selected_));
    filling_ = false;
    form_->setFigure(figure_, selected_);
}

void LayerList::emitLayer(std::size_t index, const Layer& layer, const QString& label) {
    Edit edit{*figure_, label.toStdString(), {}, false};
    edit.figure.layers[index] = layer;
    Q_EMIT edited(edit);
}

void LayerList::itemChanged(const QListWidgetItem* item) {
    const auto index = static_cast<std::size_t>(list_->row(item));
    if (filling_ || !figure_ || index >= figure_->layers.size())
        return;
    Layer layer = figure_->layers[index];
    const bool visible = item->checkState() == Qt::Checked;
    if (visible != layer.visible) {
        layer.visible = visible;
        emitLayer(index, layer, visible ? tr("Show layer") : tr("Hide layer"));
    } else if (item->text().toStdString() != layer.name) {
        layer.name = item->text().toStdString();
        emitLayer(index, layer, tr("Rename layer"));
    }
}

} // namespace limner
