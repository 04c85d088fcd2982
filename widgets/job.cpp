#include "widgets/job.h"

#include <exception>
#include <new>
#include <utility>

namespace limner {

Job::Job(QString name, Work work, QObject* parent)
    : QObject(parent), name_(std::move(name)), work_(std::move(work)), task_(*this) {}

Job::~Job() {
    task_.cancel();
    if (thread_.joinable())
        thread_.join();
}

void Job::start() {
    thread_ = std::thread([this] { run(); });
}

void Job::run() {
    try {
        work_(task_);
        QMetaObject::invokeMethod(
            this, [this] { Q_EMIT finished(); }, Qt::QueuedConnection);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::cancelled)
            QMetaObject::invokeMethod(
                this, [this] { Q_EMIT cancelled(); }, Qt::QueuedConnection);
        else
            QMetaObject::invokeMethod(
                this, [this, error] { Q_EMIT failed(error); }, Qt::QueuedConnection);
    } catch (const std::exception& exception) {
        const bool memory = dynamic_cast<const std::bad_alloc*>(&exception) != nullptr;
        const Error error(ErrorKind::noResources,
                          {name_.toStdString() + " failed", "",
                           memory ? "there is not enough memory" : exception.what(),
                           memory ? "close other programs and try again" : "please report this with the file"});
        QMetaObject::invokeMethod(
            this, [this, error] { Q_EMIT failed(error); }, Qt::QueuedConnection);
    }
}

void Job::progressed(const std::string& phase, double fraction) {
    {
        const std::lock_guard lock(mutex_);
        phase_ = phase;
        fraction_ = fraction;
    }
    if (!progressPending_.exchange(true))
        QMetaObject::invokeMethod(
            this, [this] { passProgress(); }, Qt::QueuedConnection);
}

void Job::passProgress() {
    progressPending_ = false;
    QString phase;
    double fraction = 0;
    {
        const std::lock_guard lock(mutex_);
        phase = QString::fromStdString(phase_);
        fraction = fraction_;
    }
    Q_EMIT progressed(phase, fraction);
}

} // namespace limner
