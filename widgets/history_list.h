#pragma once

#include "core/project/history.h"

#include <QStringList>
#include <QWidget>

#include <vector>

class QListWidget;
class QToolButton;

namespace limner {

/// The steps of a document, oldest first, the current one marked; and states that the user gave a name. Says where the
/// user wants to go, goes nowhere.
class HistoryList : public QWidget {
    Q_OBJECT

  public:
    explicit HistoryList(QWidget* parent = nullptr);
    /// Null: nothing is open.
    void setHistory(const History* history);
    void setNames(const QStringList& names);
    [[nodiscard]] QListWidget* steps() const { return steps_; }
    [[nodiscard]] QListWidget* names() const { return names_; }
    [[nodiscard]] QToolButton* nameButton() const { return name_; }

  Q_SIGNALS:
    void goWanted(std::size_t position);
    void nameWanted(); ///< the current state shall get a name
    void namedWanted(int place);
    void renamed(int place, const QString& name);
    void forgetWanted(int place);

  private:
    void showCurrent(std::size_t position);

    QListWidget* steps_;
    QListWidget* names_;
    QToolButton* name_;
    QToolButton* forget_;
    std::vector<History::StateId> ids_; ///< of the rows
};

} // namespace limner
