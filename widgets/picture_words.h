#pragma once

#include <QStringList>
#include <QToolButton>

namespace limner {

struct ScreenPicture;

/// What the shown picture is, in the status line: backend, pixels, time, samples, draft or final; and how much there is
/// to know of it before printing. A press asks for these sentences to be shown.
class PictureWords : public QToolButton {
    Q_OBJECT

  public:
    explicit PictureWords(QWidget* parent = nullptr);

    void showPicture(const ScreenPicture& picture);
    /// What is to be known of the scan itself: repaired, guessed, moved.
    void setScanWords(const QStringList& words);
    void clear();
    [[nodiscard]] QStringList warnings() const { return scanWords_ + pictureWords_; }

  Q_SIGNALS:
    void warningsWanted(const QStringList& warnings);

  private:
    void display();

    QString facts_;
    QStringList scanWords_;
    QStringList pictureWords_;
};

} // namespace limner
