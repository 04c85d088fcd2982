#include "widgets/label_list.h"

#include "core/figure/layer_edits.h"
#include "core/volume/derived_fields.h"
#include "widgets/job.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {
namespace {

constexpr int kChip = 14;
constexpr std::size_t kSearchFrom = 13; // fewer are seen at a glance
constexpr int kLabelRole = Qt::UserRole;

/// The colour that a layer draws a label with, or the label's own; invalid where it has none.
QColor colourOf(const Figure& figure, const Layer& layer, int label) {
    const Transfer& transfer = layer.transfer;
    const bool byLabel = transfer.kind == TransferKind::twoDimensional && transfer.grid && transfer.axes.size() == 2 &&
                         transfer.axes[1] == "label";
    if (byLabel) {
        const TransferGrid& grid = *transfer.grid;
        const auto row = static_cast<std::size_t>(std::find(grid.y.begin(), grid.y.end(), label) - grid.y.begin());
        if (row < grid.styles.size() && !grid.styles[row].empty() && grid.styles[row][0].starts_with('#'))
            return QColor(QString::fromStdString(grid.styles[row][0]));
    }
    const auto own = figure.labels->colours.find(std::to_string(label));
    return own == figure.labels->colours.end() ? QColor() : QColor(QString::fromStdString(own->second));
}

QIcon chip(const QColor& colour, const QPalette& palette, double ratio) {
    QPixmap pixmap(QSize(kChip, kChip) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette.color(QPalette::Mid));
    painter.setBrush(colour.isValid() ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(QRectF(0.5, 0.5, kChip - 1, kChip - 1), 3, 3);
    painter.end();
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // a selection must not colour it
    return icon;
}

QToolButton* button(const QString& text, const QString& tip) {
    auto* result = new QToolButton;
    result->setText(text);
    result->setToolTip(tip);
    result->setAutoRaise(true);
    return result;
}

} // namespace

LabelList::LabelList(QWidget* parent)
    : QWidget(parent), search_(new QLineEdit), list_(new QListWidget),
      all_(button(tr("All"), tr("Show every label that is listed"))),
      none_(button(tr("None"), tr("Hide every label that is listed"))) {
    search_->setPlaceholderText(tr("Search labels"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(tr("Search labels"));
    search_->setToolTip(tr("Part of a label's name, or its number"));
    list_->setIconSize({kChip, kChip});
    list_->setUniformItemSizes(true);
    list_->setAccessibleName(tr("Labels of the layer"));
    list_->setToolTip(tr("The check mark shows or hides a label in the selected layer"));
    auto* title = new QLabel(tr("&Labels"));
    title->setBuddy(list_);
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    row->addWidget(title, 1);
    row->addWidget(all_);
    row->addWidget(none_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 8);
    layout->setSpacing(6);
    layout->addLayout(row);
    layout->addWidget(search_);
    layout->addWidget(list_, 1);
    connect(list_, &QListWidget::itemChanged, this, &LabelList::itemChanged);
    connect(search_, &QLineEdit::textChanged, this, &LabelList::filter);
    connect(all_, &QToolButton::clicked, this, [this] { setListed(Qt::Checked); });
    connect(none_, &QToolButton::clicked, this, [this] { setListed(Qt::Unchecked); });
    setVisible(false);
}

LabelList::~LabelList() {
    delete job_; // the worker first: it holds what the members give it
}

void LabelList::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) {
    figure_ = std::move(figure);
    layer_ = layer;
    const bool any = figure_ && figure_->labels && figure_->labels->data && layer_ < figure_->layers.size();
    setVisible(any);
    if (!any)
        return;
    if (counted_ != figure_->labels->data)
        count(figure_->labels->data);
    showLabels();
}

void LabelList::count(const std::shared_ptr<const Volume>& labels) {
    delete job_;
    counted_ = labels;
    counts_.clear();
    search_->clear();
    auto found = std::make_shared<std::map<int, std::size_t>>();
    job_ = new Job(
        tr("Counting labels"),
        [labels, found](Task&) {
            *found = labelCounts(*labels).value_or(std::map<int, std::size_t>());
            found->erase(0); // no label
        },
        this);
    connect(job_, &Job::finished, this, [this, found] {
        counts_ = *found;
        job_->deleteLater();
        showLabels();
    });
    job_->start();
}

void LabelList::showLabels() {
    if (!figure_ || !figure_->labels || layer_ >= figure_->layers.size())
        return;
    const Layer& layer = figure_->layers[layer_];
    const bool changes = mayChange(*figure_, layer_);
    all_->setEnabled(changes);
    none_->setEnabled(changes);
    const QSignalBlocker quiet(list_);
    const int count = static_cast<int>(counts_.size());
    while (list_->count() > count)
        delete list_->takeItem(list_->count() - 1);
    while (list_->count() < count)
        list_->addItem(new QListWidgetItem);
    int row = 0;
    for (const auto& [label, voxels] : counts_) {
        QListWidgetItem* item = list_->item(row++);
        const auto name = figure_->labels->names.find(std::to_string(label));
        const bool named = name != figure_->labels->names.end() && !name->second.empty();
        item->setText(named ? QString::fromStdString(name->second) : tr("Label %1").arg(label));
        item->setData(kLabelRole, label);
        item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsUserCheckable |
                       (changes ? Qt::ItemIsEnabled : Qt::NoItemFlags));
        const bool shows =
            !layer.labels || std::find(layer.labels->begin(), layer.labels->end(), label) != layer.labels->end();
        item->setCheckState(shows ? Qt::Checked : Qt::Unchecked);
        item->setIcon(chip(colourOf(*figure_, layer, label), palette(), devicePixelRatioF()));
        item->setToolTip(tr("%1\nLabel %2, %3 voxels")
                             .arg(item->text())
                             .arg(label)
                             .arg(QLocale().toString(static_cast<qulonglong>(voxels))));
    }
    search_->setVisible(counts_.size() >= kSearchFrom);
    filter();
}

void LabelList::filter() {
    const QString words = search_->text().trimmed();
    for (int i = 0; i < list_->count(); ++i) {
        QListWidgetItem* item = list_->item(i);
        const bool fits = item->text().contains(words, Qt::CaseInsensitive) ||
                          QString::number(item->data(kLabelRole).toInt()) == words;
        item->setHidden(!fits);
    }
}

std::vector<int> LabelList::shown() const {
    const auto& labels = figure_->layers[layer_].labels;
    if (labels)
        return *labels;
    std::vector<int> all;
    for (const auto& [label, voxels] : counts_)
        all.push_back(label);
    return all;
}

void LabelList::emitLabels(const std::vector<int>& shown, const QString& label) {
    std::vector<int> sorted = shown;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    const bool all = std::all_of(counts_.begin(), counts_.end(), [&](const auto& one) {
        return std::binary_search(sorted.begin(), sorted.end(), one.first);
    });
    Edit edit{*figure_, label.toStdString(), {}, false};
    auto& labels = edit.figure.layers[layer_].labels;
    labels = all ? std::nullopt : std::optional(std::move(sorted));
    Q_EMIT edited(edit);
}

void LabelList::itemChanged(const QListWidgetItem* item) {
    if (!figure_ || !mayChange(*figure_, layer_))
        return;
    const int label = item->data(kLabelRole).toInt();
    const bool wanted = item->checkState() == Qt::Checked;
    std::vector<int> labels = shown();
    std::erase(labels, label);
    if (wanted)
        labels.push_back(label);
    emitLabels(labels, (wanted ? tr("Show label “%1”") : tr("Hide label “%1”")).arg(item->text()));
}

void LabelList::setListed(Qt::CheckState state) {
    if (!figure_ || !mayChange(*figure_, layer_))
        return;
    std::vector<int> labels = shown();
    for (int i = 0; i < list_->count(); ++i) {
        if (list_->item(i)->isHidden())
            continue;
        const int label = list_->item(i)->data(kLabelRole).toInt();
        std::erase(labels, label);
        if (state == Qt::Checked)
            labels.push_back(label);
    }
    emitLabels(labels, state == Qt::Checked ? tr("Show labels") : tr("Hide labels"));
}

} // namespace limner
