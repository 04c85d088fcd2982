#pragma once

#include <QFrame>
#include <QStringList>

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
    [[nodiscard]] const QStringList& notices() const { return lines_; }

  private:
    void display();

    QStringList lines_;
    bool expanded_ = false;
    QLabel* text_;
    QToolButton* more_;
    QToolButton* close_;
};

} // namespace limner
