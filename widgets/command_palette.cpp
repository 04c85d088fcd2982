#include "widgets/command_palette.h"

#include "widgets/action_match.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <tuple>
#include <utility>

namespace limner {
namespace {

constexpr QSize kSize(560, 380);
constexpr int kCommandRole = Qt::UserRole;

QString nameOf(const CommandPalette::Command& command) {
    return CommandPalette::tr("%1: %2").arg(command.where, plainText(*command.action));
}

} // namespace

QString plainText(const QAction& action) {
    QString text = action.text();
    text.remove('&');
    if (text.endsWith(u'…'))
        text.chop(1);
    return text;
}

CommandPalette::CommandPalette(std::vector<Command> commands, QWidget* parent)
    : QDialog(parent, Qt::Popup | Qt::FramelessWindowHint), commands_(std::move(commands)), search_(new QLineEdit),
      list_(new QListWidget) {
    setAttribute(Qt::WA_DeleteOnClose);
    setAccessibleName(tr("Commands"));
    setWindowTitle(tr("Commands"));
    search_->setPlaceholderText(tr("Type what you want to do"));
    search_->setAccessibleName(tr("Name of a command"));
    search_->setClearButtonEnabled(true);
    search_->installEventFilter(this);
    list_->setAccessibleName(tr("Commands that match"));
    list_->setUniformItemSizes(true);
    list_->setFocusPolicy(Qt::NoFocus); // the keys go to the line above
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(search_);
    layout->addWidget(list_, 1);
    resize(kSize);
    connect(search_, &QLineEdit::textChanged, this, &CommandPalette::showMatches);
    connect(search_, &QLineEdit::returnPressed, this, &CommandPalette::perform);
    connect(list_, &QListWidget::itemClicked, this, &CommandPalette::perform);
    showMatches();
    search_->setFocus();
}

void CommandPalette::showMatches() {
    using Row = std::tuple<bool, double, std::size_t>; // cannot be done, how badly it matches, index
    std::vector<Row> rows;
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        if (!commands_[i].action)
            continue;
        if (const auto score = matchScore(search_->text(), nameOf(commands_[i])))
            rows.emplace_back(!commands_[i].action->isEnabled(), search_->text().isEmpty() ? 0 : -*score, i);
    }
    std::sort(rows.begin(), rows.end());
    list_->clear();
    for (const auto& [disabled, score, index] : rows) {
        const QAction& action = *commands_[index].action;
        const QString keys = action.shortcut().toString(QKeySequence::NativeText);
        auto* item =
            new QListWidgetItem(keys.isEmpty() ? nameOf(commands_[index]) : nameOf(commands_[index]) + "    " + keys);
        item->setData(kCommandRole, static_cast<qulonglong>(index));
        item->setToolTip(action.statusTip());
        if (disabled)
            item->setFlags(Qt::NoItemFlags);
        list_->addItem(item);
    }
    list_->setCurrentRow(rows.empty() || std::get<0>(rows.front()) ? -1 : 0);
}

void CommandPalette::perform() {
    const QListWidgetItem* item = list_->currentItem();
    if (!item || !(item->flags() & Qt::ItemIsEnabled))
        return;
    const QPointer<QAction> action = commands_[item->data(kCommandRole).toULongLong()].action;
    close(); // the command may open a window of its own
    if (action)
        action->trigger();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == search_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool steps = key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown;
        if (steps) {
            QCoreApplication::sendEvent(list_, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace limner
