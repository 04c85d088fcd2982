#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QToolButton;

namespace limner {

/// Says above the picture that a file of the project is not where it was, and what can be done about it.
class MissingBar : public QFrame {
    Q_OBJECT

  public:
    explicit MissingBar(QWidget* parent = nullptr);
    /// Empty hides the bar.
    void setMissing(const QString& text);
    /// It is being looked for: the search can be stopped instead of started.
    void setSearching(bool searching);
    [[nodiscard]] QToolButton* find() const { return find_; }
    [[nodiscard]] QToolButton* findFolder() const { return findFolder_; }
    [[nodiscard]] QToolButton* search() const { return search_; }
    [[nodiscard]] QString text() const;

  Q_SIGNALS:
    void findWanted();       ///< the user wants to show the file
    void findFolderWanted(); ///< the user wants to show the folder of slices
    void searchWanted();     ///< it shall be looked for
    void stopWanted();

  private:
    QLabel* text_;
    QToolButton* find_;
    QToolButton* findFolder_; ///< of its own: no system's dialog lets one choose either
    QToolButton* search_;
    bool searching_ = false;
};

} // namespace limner
