#include "widgets/progress_strip.h"

#include "widgets/job.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include <algorithm>

namespace limner {

ProgressStrip::ProgressStrip(QWidget* parent)
    : QWidget(parent), label_(new QLabel), bar_(new QProgressBar), cancel_(new QToolButton) {
    constexpr int kSteps = 1000; // finer than a bar's pixels
    bar_->setRange(0, kSteps);
    bar_->setTextVisible(false);
    bar_->setFixedWidth(180);
    bar_->setMaximumHeight(10);
    bar_->setAccessibleName(tr("Progress"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Stop this; nothing is left behind"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 0, 6, 0);
    layout->setSpacing(8);
    layout->addWidget(label_);
    layout->addWidget(bar_);
    layout->addWidget(cancel_);
    delay_.setSingleShot(true);
    delay_.setInterval(200); // shorter work needs no word
    connect(&delay_, &QTimer::timeout, this, [this] { setVisible(true); });
    connect(cancel_, &QToolButton::clicked, this, [this] {
        if (job_) {
            label_->setText(tr("Stopping…"));
            job_->cancel();
        }
    });
    setVisible(false);
}

void ProgressStrip::follow(Job* job) {
    job_ = job;
    cancel_->setVisible(true);
    display(job->name(), 0);
    connect(job, qOverload<const QString&, double>(&Job::progressed), this,
            [this, job](const QString& phase, double fraction) {
                if (job == job_)
                    display(phase.isEmpty() ? job->name() : tr("%1: %2").arg(job->name(), phase), fraction);
            });
    const auto end = [this, job] {
        if (job == job_)
            done();
    };
    connect(job, &Job::finished, this, end);
    connect(job, &Job::failed, this, end);
    connect(job, &Job::cancelled, this, end);
    connect(job, &QObject::destroyed, this, end);
}

void ProgressStrip::show(const QString& phase, double fraction) {
    if (job_) // a job's progress goes first
        return;
    if (fraction >= 1) {
        done();
        return;
    }
    cancel_->setVisible(false);
    display(phase, fraction);
}

void ProgressStrip::display(const QString& text, double fraction) {
    label_->setText(text);
    bar_->setValue(static_cast<int>(std::clamp(fraction, 0.0, 1.0) * bar_->maximum()));
    if (!isVisible() && !delay_.isActive())
        delay_.start();
}

void ProgressStrip::done() {
    job_ = nullptr;
    delay_.stop();
    setVisible(false);
}

} // namespace limner
