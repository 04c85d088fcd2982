#pragma once

#include "core/base/error.h"
#include "core/base/task.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace limner {

/// A long piece of work (import, save, export) on a thread of its own, so that the window never waits. Lives on the
/// interface's thread; every signal comes there. Ends with exactly one of `finished`, `failed`, `cancelled`. What the
/// work makes, it leaves in something shared with whoever started it.
class Job : public QObject, private TaskListener {
    Q_OBJECT

  public:
    using Work = std::function<void(Task&)>;

    Job(QString name, Work work, QObject* parent);
    /// Cancels and waits.
    ~Job() override;

    void start();
    void cancel() { task_.cancel(); }
    [[nodiscard]] const QString& name() const { return name_; }
    [[nodiscard]] std::vector<std::string> warnings() const { return task_.warnings(); }

  Q_SIGNALS:
    void progressed(const QString& phase, double fraction);
    void finished();
    void failed(const limner::Error& error);
    void cancelled();

  private:
    void progressed(const std::string& phase, double fraction) override;
    void warned(const std::string&) override {} // read at the end, through warnings()
    void run();
    void passProgress();

    QString name_;
    Work work_;
    Task task_;
    std::mutex mutex_;
    std::string phase_;
    double fraction_ = 0;
    std::atomic<bool> progressPending_{false}; ///< one notice at a time: a fast worker must not flood the window
    std::thread thread_;
};

} // namespace limner
