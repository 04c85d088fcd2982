#pragma once

#include "core/base/error.h"
#include "core/base/task.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <functional>
#include <optional>

namespace limner {

class Job;

/// Background work of one sort, of which only the newest matters: one piece runs at a time, one may wait. All on the
/// interface's thread but the work itself.
class NewestJob : public QObject {
    Q_OBJECT

  public:
    using Work = std::function<void(Task&)>;

    NewestJob(QString name, QObject* parent);
    /// Cancels what runs and waits for it.
    ~NewestJob() override;

    enum class Running {
        stop,     ///< what runs is cancelled; its outcome is nobody's business any more
        complete, ///< what runs may come to its end and be shown: else a moving hand would see nothing
    };
    /// Asks for `work`; `done` follows on the interface's thread when it has ended well.
    void want(Work work, std::function<void()> done, Running running = Running::stop);
    /// Nothing is wanted any more.
    void drop();
    [[nodiscard]] bool busy() const { return !job_.isNull(); }
    /// What runs; null: nothing does.
    [[nodiscard]] Job* job() const;

  Q_SIGNALS:
    void failed(const limner::Error& error);
    void stopped(); ///< someone else cancelled the newest: its button was pressed
    void started(limner::Job* job);

  private:
    struct Wanted {
        Work work;
        std::function<void()> done;
    };
    void start(Wanted wanted);
    void ended();

    QString name_;
    QPointer<Job> job_;  ///< the window may end all jobs before its dialogs go
    bool heard_ = false; ///< the running work's outcome is still wanted
    std::optional<Wanted> next_;
};

} // namespace limner
