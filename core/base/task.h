#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

namespace limner {

/// Hears of a task's progress. Called from whichever thread does the work; implementations must be thread-safe.
class TaskListener {
  public:
    virtual ~TaskListener() = default;
    /// `fraction` in [0, 1], never falling within one phase.
    virtual void progressed(const std::string& phase, double fraction) = 0;
    virtual void warned(const std::string& message) = 0;
};

/// Handed to every long job (import, fields, render, poster): carries progress and warnings out and cancellation in.
/// All functions may be called from any thread. A job that sees `cancelled()` leaves nothing behind and throws
/// Error(ErrorKind::cancelled), which `throwIfCancelled` does for it.
class Task {
  public:
    Task() = default;
    explicit Task(TaskListener& listener) : listener_(&listener) {}
    /// A part of `whole`: its progress moves the whole's from `from` to `to`, its phase names are not shown, its
    /// warnings are the whole's, and it is cancelled with the whole. Lives shorter than the whole.
    Task(Task& whole, double from, double to) : whole_(&whole), from_(from), to_(to) {}
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

    void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool cancelled() const noexcept {
        return cancelled_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->cancelled());
    }
    void throwIfCancelled() const;

    void beginPhase(const std::string& name);
    void progress(double fraction);
    void warn(const std::string& message);

    /// Everything warned so far, in order, each message once.
    [[nodiscard]] std::vector<std::string> warnings() const;

  private:
    TaskListener* listener_ = nullptr;
    Task* whole_ = nullptr; ///< set: this is a part of another task
    double from_ = 0;
    double to_ = 1;
    std::atomic<bool> cancelled_{false};
    mutable std::mutex mutex_;
    std::string phase_;
    double fraction_ = 0;
    std::vector<std::string> warnings_;
};

} // namespace limner
