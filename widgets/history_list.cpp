#include "widgets/history_list.h"

#include "widgets/form_parts.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {

HistoryList::HistoryList(QWidget* parent)
    : QWidget(parent), steps_(new QListWidget), names_(new QListWidget),
      name_(
          textButton(tr("Name this state…"), tr("Keep the figure as it is now under a name, until the program ends"))),
      forget_(textButton(tr("Forget"), tr("Take the chosen name away; the figure stays as it is"))) {
    steps_->setAccessibleName(tr("Steps"));
    steps_->setToolTip(tr("Click on a step to go there, forth and back; no step is lost until something is changed"));
    steps_->setUniformItemSizes(true);
    steps_->setSpacing(1);
    names_->setAccessibleName(tr("Named states"));
    names_->setToolTip(tr("Click on a name to go there, as a change that can be undone; F2 renames it"));
    names_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(name_);
    buttons->addWidget(forget_);
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(heading(tr("Steps")));
    layout->addWidget(steps_, 3);
    layout->addWidget(heading(tr("Named states")));
    layout->addWidget(names_, 1);
    layout->addLayout(buttons);
    const auto go = [this](const QListWidgetItem* item) {
        Q_EMIT goWanted(static_cast<std::size_t>(steps_->row(item)));
    };
    connect(steps_, &QListWidget::itemClicked, this, go);
    connect(steps_, &QListWidget::itemActivated, this, go);
    const auto goNamed = [this](const QListWidgetItem* item) { Q_EMIT namedWanted(names_->row(item)); };
    connect(names_, &QListWidget::itemClicked, this, goNamed);
    connect(names_, &QListWidget::itemActivated, this, goNamed);
    connect(names_, &QListWidget::itemChanged, this,
            [this](const QListWidgetItem* item) { Q_EMIT renamed(names_->row(item), item->text()); });
    connect(names_, &QListWidget::itemSelectionChanged, this,
            [this] { forget_->setEnabled(!names_->selectedItems().isEmpty()); });
    connect(name_, &QToolButton::clicked, this, &HistoryList::nameWanted);
    connect(forget_, &QToolButton::clicked, this, [this] {
        if (names_->currentRow() >= 0)
            Q_EMIT forgetWanted(names_->currentRow());
    });
    setHistory(nullptr);
    setNames({});
}

void HistoryList::setHistory(const History* history) {
    setEnabled(history != nullptr);
    const std::vector<History::Step> none;
    const std::vector<History::Step>& steps = history ? history->steps() : none;
    std::size_t same = 0;
    while (same < std::min(ids_.size(), steps.size()) && ids_[same] == steps[same].id)
        ++same;
    const QSignalBlocker quiet(steps_);
    while (steps_->count() > static_cast<int>(same))
        delete steps_->takeItem(steps_->count() - 1);
    ids_.resize(same);
    for (std::size_t i = same; i < steps.size(); ++i) {
        const QString label = QString::fromStdString(steps[i].label);
        steps_->addItem(!label.isEmpty() ? label : i == 0 ? tr("As it was opened") : tr("Change"));
        ids_.push_back(steps[i].id);
    }
    if (history)
        showCurrent(history->position());
}

void HistoryList::showCurrent(std::size_t position) {
    for (int i = 0; i < steps_->count(); ++i) {
        QListWidgetItem* item = steps_->item(i);
        const bool current = i == static_cast<int>(position);
        const bool undone = i > static_cast<int>(position);
        if (item->font().bold() != current) {
            QFont bold = font();
            bold.setBold(current);
            item->setFont(bold);
        }
        item->setData(Qt::AccessibleDescriptionRole, current ? tr("the current state") : QString());
        item->setForeground(undone ? palette().brush(QPalette::Disabled, QPalette::Text) : QBrush());
    }
    steps_->setCurrentRow(static_cast<int>(position));
    steps_->scrollToItem(steps_->currentItem());
}

void HistoryList::setNames(const QStringList& names) {
    const QSignalBlocker quiet(names_);
    const int current = names_->currentRow();
    names_->clear();
    for (const QString& name : names) {
        auto* item = new QListWidgetItem(name, names_);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    if (current < names_->count())
        names_->setCurrentRow(current);
    forget_->setEnabled(!names_->selectedItems().isEmpty());
}

} // namespace limner
