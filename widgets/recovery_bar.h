#pragma once

#include <QFrame>
#include <QImage>
#include <QString>

#include <vector>

class QVBoxLayout;

namespace limner {

/// Unsaved work that can be had again, above the picture: what, when, how it looked. It stops nobody's work; what is
/// not decided on is offered again at the next start.
class RecoveryBar : public QFrame {
    Q_OBJECT

  public:
    struct Row {
        QString name;
        QString when;  ///< "today, 14:32"
        QString place; ///< of its project; empty: it was never saved
        QImage thumbnail;
    };

    explicit RecoveryBar(QWidget* parent = nullptr);
    /// None hides the bar.
    void setRows(const std::vector<Row>& rows);
    [[nodiscard]] int rows() const { return count_; }

  Q_SIGNALS:
    void restoreWanted(int row);
    void discardWanted(int row);

  private:
    QWidget* makeRow(const Row& row, int place);

    QVBoxLayout* list_;
    int count_ = 0;
};

} // namespace limner
