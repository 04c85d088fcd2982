#pragma once

#include <QHash>
#include <QObject>
#include <QString>

#include <span>

class QAction;
class QKeySequence;
class QMainWindow;

namespace limner {

/// One command of the program. Menus, tool bars, shortcuts, tool tips and the command palette read this table and
/// nothing else.
struct ActionRow {
    const char* id;       ///< "file.open"; what stands before the dot names the menu. "file.-" is a separator
    const char* text;     ///< for the menu, with its mnemonic
    const char* tip;      ///< one sentence
    const char* shortcut; ///< portable text; empty: none. "Copy" and the like take the platform's own
    const char* brief;    ///< for a tool bar's button; empty: not on the tool bar
};

std::span<const ActionRow> actionTable();

/// The table's rows as QActions of a window, with translated texts.
class Actions : public QObject {
    Q_OBJECT

  public:
    explicit Actions(QMainWindow* window);
    /// Asserts that the id is in the table.
    [[nodiscard]] QAction* at(const QString& id) const;
    /// The user's own keys for a command, kept from one start of the program to the next; those of the table are not.
    void setShortcut(const QString& id, const QKeySequence& keys);
    [[nodiscard]] static QKeySequence standardShortcut(const ActionRow& row);

  private:
    QHash<QString, QAction*> actions_;
};

} // namespace limner
