#pragma once

#include <QFrame>
#include <QStringList>

#include <functional>

class QLabel;
class QToolButton;

namespace limner {

/// A line above the picture with what the user should know and can read when it suits; it never stops the work.
class NoticeBar : public QFrame {
    Q_OBJECT

  public:
    enum class Kind { information, problem };

    explicit NoticeBar(QWidget* parent = nullptr);

    /// Shows the lines until they are dismissed or replaced; none hides the bar.
    void setNotices(const QStringList& lines, Kind kind);
    /// Shows a line with a button that does something about it, once: "Removed “Ivory”" — Undo.
    void offer(const QString& line, const QString& action, std::function<void()> then);
    /// The button of an offer; hidden without one.
    [[nodiscard]] QToolButton* action() const { return action_; }
    [[nodiscard]] const QStringList& notices() const { return lines_; }

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void display();
    void dress(); ///< in the kind's colour, light or dark as the window is

    QStringList lines_;
    Kind kind_ = Kind::information;
    bool expanded_ = false;
    std::function<void()> then_; ///< of an offer
    QLabel* text_;
    QToolButton* action_;
    QToolButton* more_;
    QToolButton* close_;
};

} // namespace limner
