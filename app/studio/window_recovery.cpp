#include "app/studio/window_recovery.h"

#include "widgets/job.h"
#include "widgets/notice_bar.h"
#include "widgets/recovery_bar.h"

#include <QDateTime>
#include <QImage>
#include <QLocale>
#include <QMainWindow>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace limner {
namespace {

// Never more than a minute or fifty changes shall be lost: the writing begins early enough to be over by then.
constexpr int kLongestSeconds = 50;
constexpr int kMostEdits = 25;

int limitOf(const char* variable, int usual) {
    bool given = false;
    const int limit = qEnvironmentVariableIntValue(variable, &given);
    return given && limit > 0 ? limit : usual;
}

QString whenText(std::int64_t seconds) {
    const QDateTime time = QDateTime::fromSecsSinceEpoch(seconds);
    const QString clock = QLocale().toString(time.time(), QLocale::ShortFormat);
    const qint64 days = time.date().daysTo(QDate::currentDate());
    return days == 0   ? WindowRecovery::tr("today, %1").arg(clock)
           : days == 1 ? WindowRecovery::tr("yesterday, %1").arg(clock)
                       : WindowRecovery::tr("%1, %2").arg(QLocale().toString(time.date(), QLocale::ShortFormat), clock);
}

} // namespace

WindowRecovery::WindowRecovery(const Workplace& place)
    : QObject(place.window), place_(place), bar_(new RecoveryBar),
      session_(std::make_shared<RecoverySession>(recoveryFolder())),
      mostEdits_(limitOf("LIMNER_AUTOSAVE_EDITS", kMostEdits)) {
    if (auto* centre = qobject_cast<QVBoxLayout*>(place_.window->centralWidget()->layout()))
        centre->insertWidget(0, bar_);
    due_.setSingleShot(true);
    due_.setInterval(1000 * limitOf("LIMNER_AUTOSAVE_SECONDS", kLongestSeconds));
    connect(&due_, &QTimer::timeout, this, &WindowRecovery::write);
    connect(bar_, &RecoveryBar::restoreWanted, this, [this](int row) { restore(static_cast<std::size_t>(row)); });
    connect(bar_, &RecoveryBar::discardWanted, this, [this](int row) { discard(static_cast<std::size_t>(row)); });
    connect(place_.document, &StudioDocument::changed, this, &WindowRecovery::documentChanged);
    offer();
}

WindowRecovery::~WindowRecovery() {
    delete job_; // waits
    rest();
}

void WindowRecovery::offer() {
    offered_ = unsavedWork(recoveryFolder());
    std::vector<RecoveryBar::Row> rows;
    for (const RecoveryEntry& entry : offered_)
        rows.push_back({QString::fromStdString(entry.name), whenText(entry.savedAt),
                        isProject(entry.project) ? QString::fromStdString(entry.project.string()) : QString(),
                        entry.thumbnail.empty() ? QImage() : QImage(QString::fromStdString(entry.thumbnail.string()))});
    bar_->setRows(rows);
}

void WindowRecovery::restore(std::size_t row) {
    if (row >= offered_.size())
        return;
    const RecoveryEntry entry = offered_[row];
    auto restored = std::make_shared<RestoredWork>();
    restored_ = restored;
    place_.openDocument(
        tr("Restoring %1").arg(QString::fromStdString(entry.name)),
        [restored, entry](Task& task) {
            *restored = openWork(entry, task);
            return restored->document;
        },
        Opened::restored);
}

void WindowRecovery::discard(std::size_t row) {
    if (row >= offered_.size())
        return;
    discardWork(offered_[row]);
    offer();
}

void WindowRecovery::documentChanged() {
    const StudioDocument& document = *place_.document;
    if (generation_ != document.generation()) {
        generation_ = document.generation();
        edits_ = 0;
        seen_ = document.history().stateId();
        due_.stop();
        if (!document.empty() && document.opened() == Opened::restored && restored_) {
            atRest([this, work = std::exchange(restored_, nullptr)] { session_->adopt(std::move(*work)); });
            QMetaObject::invokeMethod(this, &WindowRecovery::offer, Qt::QueuedConnection); // without the restored one
            return;
        }
    }
    if (!document.dirty()) {
        edits_ = 0;
        seen_ = document.history().stateId();
        due_.stop();
        atRest([this] { session_->clear(); });
        return;
    }
    if (seen_ == document.history().stateId())
        return;
    seen_ = document.history().stateId();
    if (!due_.isActive())
        due_.start();
    if (!document.gestureOngoing() && ++edits_ >= mostEdits_)
        write();
}

void WindowRecovery::write() {
    if (!place_.document->dirty())
        return;
    if (job_) { // the disk is slow: what has changed meanwhile is next
        again_ = true;
        return;
    }
    due_.stop();
    edits_ = 0;
    again_ = false;
    auto unsaved = std::make_shared<UnsavedDocument>();
    unsaved->document = place_.document->snapshot();
    unsaved->name = place_.document->name().toStdString();
    unsaved->thumbnailPng = place_.thumbnail();
    // Not one of the window's jobs: nobody waits for it, and its failure is no box in the way.
    job_ = new Job(
        tr("Keeping unsaved work"), [session = session_, unsaved](Task& task) { session->write(*unsaved, task); },
        this);
    connect(job_, &Job::finished, this, [this] {
        rest();
        Q_EMIT kept();
        if (std::exchange(again_, false))
            write();
    });
    connect(job_, &Job::cancelled, this, &WindowRecovery::rest);
    connect(job_, &Job::failed, this, [this](const Error& error) {
        place_.notices->setNotices({QString::fromUtf8(error.what())}, NoticeBar::Kind::problem);
        if (place_.document->dirty())
            due_.start(); // there may be room again by then
        rest();
    });
    job_->start();
}

void WindowRecovery::atRest(std::function<void()> what) {
    if (!job_) {
        what();
        return;
    }
    after_.push_back(std::move(what));
    job_->cancel();
}

void WindowRecovery::rest() {
    if (job_) {
        job_->deleteLater();
        job_.clear();
    }
    for (const auto& what : std::exchange(after_, {}))
        what();
}

} // namespace limner
