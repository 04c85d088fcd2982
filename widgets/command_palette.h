#pragma once

#include <QDialog>
#include <QPointer>

#include <vector>

class QAction;
class QLineEdit;
class QListWidget;

namespace limner {

/// Every command of the program by its name: type some of its letters, Up and Down choose, Enter does it, Escape
/// leaves. Commands that cannot be done now stand at the end, grey, and say nothing where they are chosen.
class CommandPalette : public QDialog {
    Q_OBJECT

  public:
    struct Command {
        QString where; ///< "File", "Preset": what the command belongs to
        QPointer<QAction> action;
    };

    CommandPalette(std::vector<Command> commands, QWidget* parent);

    [[nodiscard]] QLineEdit* search() const { return search_; }
    [[nodiscard]] QListWidget* list() const { return list_; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void showMatches();
    void perform();

    std::vector<Command> commands_;
    QLineEdit* search_;
    QListWidget* list_;
};

/// An action's text without its mnemonic's mark and dots.
QString plainText(const QAction& action);

} // namespace limner
