#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace limner {

class Job;

/// One line that says what is going on, how far it is, and stops it. Shows itself only for work that lasts.
class ProgressStrip : public QWidget {
    Q_OBJECT

  public:
    explicit ProgressStrip(QWidget* parent = nullptr);

    /// Follows a job until it ends; the job's owner stays who it was.
    void follow(Job* job);
    /// For work that is no job and cannot be stopped: preparing a figure. A fraction of 1 or more hides the strip.
    void show(const QString& phase, double fraction);
    void done();

  private:
    void display(const QString& text, double fraction);

    QLabel* label_;
    QProgressBar* bar_;
    QToolButton* cancel_;
    QTimer delay_; ///< what is done within it never flickers up
    Job* job_ = nullptr;
};

} // namespace limner
