#include "widgets/layer_list.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr int kBall = 22;
constexpr int kSliderSteps = 200; // half a percent each

/// An icon that a selection does not colour: the style must stay what it is.
QIcon untinted(const QPixmap& pixmap) {
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

} // namespace

LayerList::LayerList(QWidget* parent)
    : QWidget(parent), list_(new QListWidget), slider_(new QSlider(Qt::Horizontal)), percent_(new QDoubleSpinBox),
      shading_(new QComboBox) {
    list_->setIconSize({kBall, kBall});
    list_->setAccessibleName(tr("Layers"));
    list_->setToolTip(tr("The check mark shows or hides a layer; a double click renames it"));
    list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    slider_->setRange(0, kSliderSteps);
    slider_->setAccessibleName(tr("Layer opacity"));
    slider_->setToolTip(tr("Multiplies the opacity of the whole layer, in percent"));
    percent_->setRange(0, 100);
    percent_->setDecimals(1);
    percent_->setSuffix(tr(" %"));
    percent_->setKeyboardTracking(false);
    percent_->setAccessibleName(tr("Layer opacity in percent"));
    percent_->setToolTip(slider_->toolTip());
    shading_->addItem(tr("Style"), static_cast<int>(Shading::style));
    shading_->addItem(tr("Phong"), static_cast<int>(Shading::phong));
    shading_->addItem(tr("Flat"), static_cast<int>(Shading::flat));
    shading_->setAccessibleName(tr("Shading"));
    shading_->setToolTip(tr("How light is drawn: by the styles, by a head light, or not at all"));
    auto* opacityRow = new QHBoxLayout;
    opacityRow->setSpacing(6);
    opacityRow->addWidget(slider_, 1);
    opacityRow->addWidget(percent_);
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    auto* opacityLabel = new QLabel(tr("&Opacity"));
    opacityLabel->setBuddy(slider_);
    form->addRow(opacityLabel, opacityRow);
    form->addRow(tr("Sh&ading"), shading_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(list_, 1);
    layout->addLayout(form);

    connect(list_, &QListWidget::itemChanged, this, &LayerList::itemChanged);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (filling_ || row < 0)
            return;
        selected_ = static_cast<std::size_t>(row);
        showSelected();
        Q_EMIT layerSelected(selected_);
    });
    connect(slider_, &QSlider::sliderPressed, this, [this] { key_.begin("layer/opacity"); });
    connect(slider_, &QSlider::valueChanged, this,
            [this](int value) { setOpacity(static_cast<double>(value) / kSliderSteps, slider_->isSliderDown()); });
    connect(slider_, &QSlider::sliderReleased, this,
            [this] { setOpacity(static_cast<double>(slider_->value()) / kSliderSteps, false); });
    connect(percent_, &QDoubleSpinBox::valueChanged, this, [this](double value) { setOpacity(value / 100, false); });
    connect(shading_, &QComboBox::activated, this, [this](int row) {
        if (!figure_ || selected_ >= figure_->layers.size())
            return;
        Layer layer = figure_->layers[selected_];
        layer.shading = static_cast<Shading>(shading_->itemData(row).toInt());
        emitLayer(selected_, layer, tr("Change shading"), {}, false);
    });
    showSelected();
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
    showSelected();
}

void LayerList::showSelected() {
    const bool any = figure_ && selected_ < figure_->layers.size();
    slider_->setEnabled(any);
    percent_->setEnabled(any);
    shading_->setEnabled(any);
    const QSignalBlocker quietSlider(slider_);
    const QSignalBlocker quietPercent(percent_);
    const double opacity = any ? figure_->layers[selected_].opacity : 1;
    if (!slider_->isSliderDown())
        slider_->setValue(static_cast<int>(std::lround(opacity * kSliderSteps)));
    percent_->setValue(opacity * 100);
    if (any)
        shading_->setCurrentIndex(shading_->findData(static_cast<int>(figure_->layers[selected_].shading)));
}

void LayerList::emitLayer(std::size_t index, const Layer& layer, const QString& label, const std::string& key,
                          bool ongoing) {
    Edit edit{*figure_, label.toStdString(), key, ongoing};
    edit.figure.layers[index] = layer;
    Q_EMIT edited(edit);
}

void LayerList::setOpacity(double opacity, bool ongoing) {
    if (filling_ || !figure_ || selected_ >= figure_->layers.size())
        return;
    Layer layer = figure_->layers[selected_];
    layer.opacity = opacity;
    emitLayer(selected_, layer, tr("Change layer opacity"), key_.again("layer/opacity"), ongoing);
}

void LayerList::itemChanged(const QListWidgetItem* item) {
    const auto index = static_cast<std::size_t>(list_->row(item));
    if (filling_ || !figure_ || index >= figure_->layers.size())
        return;
    Layer layer = figure_->layers[index];
    const bool visible = item->checkState() == Qt::Checked;
    if (visible != layer.visible) {
        layer.visible = visible;
        emitLayer(index, layer, visible ? tr("Show layer") : tr("Hide layer"), {}, false);
    } else if (item->text().toStdString() != layer.name) {
        layer.name = item->text().toStdString();
        emitLayer(index, layer, tr("Rename layer"), {}, false);
    }
}

} // namespace limner
