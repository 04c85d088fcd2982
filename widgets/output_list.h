#pragma once

#include <QString>
#include <QWidget>

#include <vector>

class QLabel;
class QProgressBar;
class QToolButton;
class QVBoxLayout;

namespace limner {

/// One picture that is written, was, or will be.
struct OutputRow {
    enum class State { queued, running, done, failed, stopped };
    int id = 0;
    QString name;   ///< of the file
    QString folder; ///< for the tool tip
    QString facts;  ///< "2126 × 2126 pixels"
    State state = State::queued;
    QString phase; ///< of a running one
    double fraction = 0;
    QString problem; ///< of a failed one
};

/// The pictures of a session: what waits, runs, is done or failed, with what can be done about each.
class OutputList : public QWidget {
    Q_OBJECT

  public:
    explicit OutputList(QWidget* parent = nullptr);
    void setRows(const std::vector<OutputRow>& rows);
    /// A button of a row by what it does: "cancel", "retry", "show", "folder", "remove"; null: there is no such row.
    [[nodiscard]] QToolButton* button(int id, const QString& what) const;
    /// What the row says of its state.
    [[nodiscard]] QString status(int id) const;

  Q_SIGNALS:
    void cancelWanted(int id);
    void retryWanted(int id);
    void removeWanted(int id);
    void showWanted(int id);   ///< the picture itself
    void folderWanted(int id); ///< the folder that it is in

  private:
    struct Line {
        int id = 0;
        QWidget* box = nullptr;
        QLabel* name = nullptr;
        QLabel* status = nullptr;
        QProgressBar* bar = nullptr;
        QToolButton* cancel = nullptr;
        QToolButton* retry = nullptr;
        QToolButton* show = nullptr;
        QToolButton* folder = nullptr;
        QToolButton* remove = nullptr;
    };
    [[nodiscard]] Line makeLine(int id);
    [[nodiscard]] const Line* find(int id) const;
    static void showRow(const Line& line, const OutputRow& row);

    QVBoxLayout* list_;
    QLabel* none_;
    std::vector<Line> lines_;
};

} // namespace limner
