#pragma once

#include <QDialog>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace limner {

class Actions;

/// All commands with their keys; the chosen one's can be changed at once. Keys that another command has are taken from
/// it only after the user was told whose they are.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ShortcutsDialog(Actions* actions, QWidget* parent);

    [[nodiscard]] QLineEdit* search() const { return search_; }
    [[nodiscard]] QTableWidget* table() const { return table_; }
    [[nodiscard]] QKeySequenceEdit* keys() const { return keys_; }
    [[nodiscard]] QPushButton* assign() const { return assign_; }
    [[nodiscard]] QPushButton* resetAll() const { return resetAll_; }
    [[nodiscard]] QLabel* word() const { return word_; }

  private:
    void fill();
    void filter();
    void showChosen();
    void showConflict();
    void assignKeys();
    [[nodiscard]] QString chosenId() const;
    /// Another command with the keys in the field; empty: none.
    [[nodiscard]] QString owner() const;

    Actions* actions_;
    QLineEdit* search_;
    QTableWidget* table_;
    QKeySequenceEdit* keys_;
    QPushButton* assign_;
    QPushButton* reset_;
    QPushButton* resetAll_;
    QLabel* word_;
};

} // namespace limner
