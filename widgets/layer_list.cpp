#include "widgets/layer_list.h"

#include "core/figure/layer_edits.h"
#include "core/figure/shape_edits.h"
#include "widgets/layer_rows.h"

#include <QAction>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>

namespace limner {
namespace {

constexpr int kBall = 22;
constexpr std::size_t kMostLayers = 64; // more are no illustration any longer

/// An icon that a selection does not colour: the style must stay what it is.
QIcon untinted(const QPixmap& pixmap) {
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

QString nameOf(const Layer& layer, std::size_t index) {
    return layer.name.empty() ? LayerList::tr("Layer %1").arg(index + 1) : QString::fromStdString(layer.name);
}

} // namespace

LayerList::LayerList(QWidget* parent) : QWidget(parent), list_(new LayerRows) {
    list_->setIconSize({kBall, kBall});
    list_->setAccessibleName(tr("Layers"));
    buildActions();
    layOut();
    connect(list_, &LayerRows::itemChanged, this, &LayerList::itemChanged);
    connect(list_, &LayerRows::currentRowChanged, this, [this](int row) {
        if (filling_ || row < 0)
            return;
        selected_ = static_cast<std::size_t>(row);
        showActions();
        Q_EMIT layerSelected(selected_);
    });
    connect(list_, &LayerRows::soloClicked, this, [this](int row) { setSolo(static_cast<std::size_t>(row)); });
    connect(list_, &LayerRows::lockClicked, this, [this](int row) { setLocked(static_cast<std::size_t>(row)); });
    connect(list_, &LayerRows::moveWanted, this,
            [this](int from, int to) { moveLayer(static_cast<std::size_t>(from), static_cast<std::size_t>(to)); });
    showActions();
}

QAction* LayerList::action(const QString& text, const QString& tip, const QKeySequence& keys,
                           void (LayerList::*run)()) {
    auto* action = new QAction(text, list_);
    action->setToolTip(keys.isEmpty() ? tip : tr("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut); // only the list's own keys
    connect(action, &QAction::triggered, this, run);
    list_->addAction(action);
    return action;
}

void LayerList::buildActions() {
    add_ = action(tr("Add"), tr("Add a layer behind the selected one"), Qt::Key_Insert, &LayerList::addLayer);
    duplicate_ =
        action(tr("Duplicate"), tr("Copy the selected layer"), Qt::CTRL | Qt::Key_D, &LayerList::duplicateLayer);
    remove_ = action(tr("Delete"), tr("Delete the selected layer"), Qt::Key_Delete, &LayerList::removeLayer);
    removeTip_ = remove_->toolTip();
    up_ = action(tr("Up"), tr("Draw the selected layer earlier"), Qt::ALT | Qt::Key_Up, &LayerList::moveUp);
    down_ = action(tr("Down"), tr("Draw the selected layer later"), Qt::ALT | Qt::Key_Down, &LayerList::moveDown);
    rename_ = action(tr("Rename"), tr("Give the selected layer another name"), {}, &LayerList::renameLayer);
    solo_ = new QAction(tr("Solo"), list_);
    lock_ = new QAction(tr("Locked"), list_);
    connect(solo_, &QAction::triggered, this, [this] { setSolo(selected_); });
    connect(lock_, &QAction::triggered, this, [this] { setLocked(selected_); });
    for (QAction* action : {solo_, lock_}) {
        action->setCheckable(true);
        list_->addAction(action);
    }
    list_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void LayerList::layOut() {
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    for (QAction* action : {add_, duplicate_, remove_, up_, down_}) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setFocusPolicy(Qt::TabFocus);
        if (action == up_ || action == down_)
            button->setArrowType(action == up_ ? Qt::UpArrow : Qt::DownArrow);
        if (action == up_)
            buttons->addStretch(1);
        buttons->addWidget(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 4);
    layout->setSpacing(6);
    layout->addWidget(list_, 1);
    layout->addLayout(buttons);
}

void LayerList::setFigure(std::shared_ptr<const Figure> figure) {
    figure_ = std::move(figure);
    const std::size_t count = figure_ ? figure_->layers.size() : 0;
    selected_ = count == 0 ? 0 : std::min(selected_, count - 1);
    showRows();
    showActions();
}

void LayerList::showRows() {
    const std::size_t count = figure_ ? figure_->layers.size() : 0;
    filling_ = true;
    while (list_->count() > static_cast<int>(count))
        delete list_->takeItem(list_->count() - 1);
    while (list_->count() < static_cast<int>(count))
        list_->addItem(new QListWidgetItem);
    for (std::size_t i = 0; i < count; ++i) {
        const Layer& layer = figure_->layers[i];
        QListWidgetItem* item = list_->item(static_cast<int>(i));
        item->setText(nameOf(layer, i));
        Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable;
        if (!layer.locked)
            flags |= Qt::ItemIsEditable | Qt::ItemIsDragEnabled;
        item->setFlags(flags);
        item->setCheckState(layer.visible ? Qt::Checked : Qt::Unchecked);
        item->setData(LayerRows::kSoloRole, layer.solo);
        item->setData(LayerRows::kLockRole, layer.locked);
        item->setForeground(palette().color(figure_->draws(layer) ? QPalette::Active : QPalette::Disabled,
                                            QPalette::Text)); // another one's solo hides it too
        const Transfer& transfer = layer.transfer;
        const bool grid = transfer.kind == TransferKind::twoDimensional && transfer.grid;
        if (grid || !transfer.nodes.empty()) {
            const TransferNode node = grid ? nodeOfCell(*transfer.grid, 0) : transfer.nodes.front();
            item->setIcon(untinted(balls_.ball(*figure_, node, kBall, devicePixelRatioF())));
        } else {
            item->setIcon({});
        }
    }
    if (count > 0)
        list_->setCurrentRow(static_cast<int>(selected_));
    filling_ = false;
}

void LayerList::showActions() {
    const bool locked = any() && figure_->layers[selected_].locked;
    const std::size_t count = figure_ ? figure_->layers.size() : 0;
    add_->setEnabled(figure_ && count < kMostLayers);
    duplicate_->setEnabled(any() && count < kMostLayers);
    remove_->setEnabled(any() && !locked);
    remove_->setToolTip(
        locked ? tr("“%1” is locked: unlock it to delete it").arg(nameOf(figure_->layers[selected_], selected_))
               : removeTip_);
    up_->setEnabled(any() && !locked && selected_ > 0);
    down_->setEnabled(any() && !locked && selected_ + 1 < count);
    rename_->setEnabled(any() && !locked);
    solo_->setEnabled(any());
    lock_->setEnabled(any());
    solo_->setChecked(any() && figure_->layers[selected_].solo);
    lock_->setChecked(locked);
}

void LayerList::emitLayers(Figure changed, const QString& label, std::size_t selected) {
    selected_ = selected; // the figure that comes back is shown with it
    Q_EMIT edited({std::move(changed), label.toStdString(), {}, false});
}

void LayerList::emitLayer(std::size_t index, const Layer& layer, const QString& label) {
    Figure changed = *figure_;
    changed.layers[index] = layer;
    emitLayers(std::move(changed), label, selected_);
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
    } else if (!layer.locked && item->text() != nameOf(layer, index)) {
        layer.name = item->text().toStdString();
        emitLayer(index, layer, tr("Rename layer"));
    }
}

void LayerList::moveLayer(std::size_t from, std::size_t to) {
    if (figure_ && mayChange(*figure_, from) && to < figure_->layers.size())
        emitLayers(withLayerMoved(*figure_, from, to), tr("Move layer"), to);
}

void LayerList::addLayer() {
    if (!figure_)
        return;
    const std::size_t place = any() ? selected_ + 1 : 0;
    emitLayers(withLayerAdded(*figure_, place, freshLayer(*figure_)), tr("Add layer"), place);
}

void LayerList::duplicateLayer() {
    if (any())
        emitLayers(withLayerDuplicated(*figure_, selected_), tr("Duplicate layer"), selected_ + 1);
}

void LayerList::removeLayer() {
    if (any() && mayChange(*figure_, selected_))
        emitLayers(withLayerRemoved(*figure_, selected_), tr("Delete layer"), selected_);
}

void LayerList::moveUp() {
    if (selected_ > 0)
        moveLayer(selected_, selected_ - 1);
}

void LayerList::moveDown() { moveLayer(selected_, selected_ + 1); }

void LayerList::renameLayer() {
    if (any() && mayChange(*figure_, selected_))
        list_->editItem(list_->item(static_cast<int>(selected_)));
}

void LayerList::setSolo(std::size_t index) {
    if (!figure_ || index >= figure_->layers.size())
        return;
    Layer layer = figure_->layers[index];
    layer.solo = !layer.solo;
    emitLayer(index, layer, layer.solo ? tr("Solo layer") : tr("End solo"));
}

void LayerList::setLocked(std::size_t index) {
    if (!figure_ || index >= figure_->layers.size())
        return;
    Layer layer = figure_->layers[index];
    layer.locked = !layer.locked;
    emitLayer(index, layer, layer.locked ? tr("Lock layer") : tr("Unlock layer"));
}

} // namespace limner
