#include "widgets/newest_job.h"

#include "widgets/job.h"

#include <utility>

namespace limner {

NewestJob::NewestJob(QString name, QObject* parent) : QObject(parent), name_(std::move(name)) {}

NewestJob::~NewestJob() { delete job_; }

void NewestJob::want(Work work, std::function<void()> done, Running running) {
    Wanted wanted{std::move(work), std::move(done)};
    if (!job_) {
        start(std::move(wanted));
        return;
    }
    next_ = std::move(wanted);
    if (running == Running::stop) {
        heard_ = false;
        job_->cancel();
    }
}

Job* NewestJob::job() const { return job_; }

void NewestJob::drop() {
    next_.reset();
    heard_ = false;
    if (job_)
        job_->cancel();
}

void NewestJob::start(Wanted wanted) {
    heard_ = true;
    job_ = new Job(name_, std::move(wanted.work), this);
    connect(job_, &Job::finished, this, [this, done = std::move(wanted.done)] {
        if (heard_)
            done();
        ended();
    });
    connect(job_, &Job::failed, this, [this](const Error& error) {
        if (heard_)
            Q_EMIT failed(error);
        ended();
    });
    connect(job_, &Job::cancelled, this, [this] {
        if (heard_)
            Q_EMIT stopped();
        ended();
    });
    job_->start();
    Q_EMIT started(job_);
}

void NewestJob::ended() {
    job_->deleteLater();
    job_ = nullptr;
    if (next_)
        start(*std::exchange(next_, std::nullopt));
}

} // namespace limner
