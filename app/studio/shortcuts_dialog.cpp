#include "app/studio/shortcuts_dialog.h"

#include "app/studio/action_table.h"
#include "widgets/action_match.h"
#include "widgets/command_palette.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace limner {
namespace {

constexpr QSize kSize(620, 560);
enum Column { kName, kKeys, kColumns };

} // namespace

ShortcutsDialog::ShortcutsDialog(Actions* actions, QWidget* parent)
    : QDialog(parent), actions_(actions), search_(new QLineEdit), table_(new QTableWidget), keys_(new QKeySequenceEdit),
      assign_(new QPushButton(tr("&Assign"))), reset_(new QPushButton(tr("&Standard"))),
      resetAll_(new QPushButton(tr("All &standard"))), word_(new QLabel) {
    setWindowTitle(tr("Shortcuts"));
    search_->setPlaceholderText(tr("Search"));
    search_->setAccessibleName(tr("Search the commands"));
    search_->setClearButtonEnabled(true);
    table_->setAccessibleName(tr("Commands and their keys"));
    table_->setColumnCount(kColumns);
    table_->setHorizontalHeaderLabels({tr("Command"), tr("Keys")});
    table_->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setTabKeyNavigation(false);
    keys_->setAccessibleName(tr("New keys of the chosen command"));
    keys_->setToolTip(tr("Press the keys; Assign without any takes the command's keys away"));
    word_->setWordWrap(true);
    reset_->setToolTip(tr("The keys that the command comes with"));
    auto* row = new QHBoxLayout;
    row->addWidget(keys_, 1);
    row->addWidget(assign_);
    row->addWidget(reset_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(resetAll_, QDialogButtonBox::ResetRole);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search_);
    layout->addWidget(table_, 1);
    layout->addLayout(row);
    layout->addWidget(word_);
    layout->addWidget(buttons);
    resize(kSize);
    fill();
    connect(search_, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
    connect(table_, &QTableWidget::currentCellChanged, this, &ShortcutsDialog::showChosen);
    connect(keys_, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutsDialog::showConflict);
    connect(assign_, &QPushButton::clicked, this, &ShortcutsDialog::assignKeys);
    connect(reset_, &QPushButton::clicked, this, [this] {
        for (const ActionRow& action : actionTable())
            if (chosenId() == action.id) {
                keys_->setKeySequence(Actions::standardShortcut(action));
                assignKeys();
                return;
            }
    });
    connect(resetAll_, &QPushButton::clicked, this, [this] {
        for (const ActionRow& action : actionTable())
            if (*action.text)
                actions_->setShortcut(action.id, Actions::standardShortcut(action));
        fill();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::accept);
    table_->setCurrentCell(0, kName);
}

void ShortcutsDialog::fill() {
    const int chosen = table_->currentRow();
    table_->setRowCount(0);
    for (const ActionRow& row : actionTable()) {
        if (!*row.text)
            continue;
        const QAction& action = *actions_->at(row.id);
        const int at = table_->rowCount();
        table_->insertRow(at);
        auto* name = new QTableWidgetItem(plainText(action));
        name->setData(Qt::UserRole, QString(row.id));
        name->setToolTip(action.statusTip());
        table_->setItem(at, kName, name);
        table_->setItem(at, kKeys, new QTableWidgetItem(action.shortcut().toString(QKeySequence::NativeText)));
    }
    filter();
    table_->setCurrentCell(std::max(chosen, 0), kName);
    showChosen();
}

void ShortcutsDialog::filter() {
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QString text = table_->item(row, kName)->text() + " " + table_->item(row, kKeys)->text();
        table_->setRowHidden(row, !matchScore(search_->text(), text));
    }
}

QString ShortcutsDialog::chosenId() const {
    const QTableWidgetItem* item = table_->item(table_->currentRow(), kName);
    return item ? item->data(Qt::UserRole).toString() : QString();
}

void ShortcutsDialog::showChosen() {
    const QString id = chosenId();
    keys_->setEnabled(!id.isEmpty());
    reset_->setEnabled(!id.isEmpty());
    keys_->setKeySequence(id.isEmpty() ? QKeySequence() : actions_->at(id)->shortcut());
    showConflict();
}

QString ShortcutsDialog::owner() const {
    if (keys_->keySequence().isEmpty())
        return {};
    for (const ActionRow& row : actionTable())
        if (*row.text && chosenId() != row.id && actions_->at(row.id)->shortcut() == keys_->keySequence())
            return row.id;
    return {};
}

void ShortcutsDialog::showConflict() {
    const QString id = chosenId();
    const QString other = owner();
    assign_->setEnabled(!id.isEmpty() && actions_->at(id)->shortcut() != keys_->keySequence());
    assign_->setText(other.isEmpty() ? tr("&Assign") : tr("Take &over"));
    word_->setText(
        other.isEmpty()
            ? QString()
            : tr("“%1” has these keys. It loses them when you take them over.").arg(plainText(*actions_->at(other))));
}

void ShortcutsDialog::assignKeys() {
    const QString id = chosenId();
    if (id.isEmpty())
        return;
    if (const QString other = owner(); !other.isEmpty())
        actions_->setShortcut(other, {});
    actions_->setShortcut(id, keys_->keySequence());
    fill();
}

} // namespace limner
