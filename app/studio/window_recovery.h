#pragma once

#include "app/studio/workplace.h"
#include "core/project/recovery.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <vector>

namespace limner {

class RecoveryBar;

/// Keeps unsaved work against a crash, on a thread of its own, so that never more than a minute or fifty changes are
/// lost, whichever is less; and offers at the start what sessions before left behind. (LIMNER_AUTOSAVE_SECONDS and
/// LIMNER_AUTOSAVE_EDITS say after how much the writing begins.)
class WindowRecovery : public QObject {
    Q_OBJECT

  public:
    explicit WindowRecovery(const Workplace& place);
    ~WindowRecovery() override;

    [[nodiscard]] RecoveryBar& bar() { return *bar_; }
    /// What is offered, as the bar's rows.
    [[nodiscard]] const std::vector<RecoveryEntry>& offered() const { return offered_; }
    void restore(std::size_t row);
    void discard(std::size_t row);

  Q_SIGNALS:
    void kept(); ///< the document as it was when the autosave began is safe

  private:
    void offer();
    void documentChanged();
    void write();
    /// Does what touches the session's folder, once no autosave runs: a running one is not wanted any more.
    void atRest(std::function<void()> what);
    void rest();

    Workplace place_;
    RecoveryBar* bar_;
    std::shared_ptr<RecoverySession> session_;
    std::vector<RecoveryEntry> offered_;
    std::shared_ptr<RestoredWork> restored_; ///< that is being opened
    std::vector<std::function<void()>> after_;
    QPointer<Job> job_;
    QTimer due_;
    int mostEdits_;
    bool again_ = false; ///< once the running autosave is done
    int edits_ = 0;      ///< since the newest autosave began
    unsigned generation_ = 0;
    History::StateId seen_ = 0;
};

} // namespace limner
