#pragma once

#include "core/base/error.h"
#include "core/base/task.h"

#include <chrono>
#include <iosfwd>
#include <mutex>
#include <string>

namespace limner::cli {

/// Where a command's words go: facts to `out`, notes, errors and the progress bar to `err`. The bar is drawn only on a
/// terminal, with the time that is left. Thread-safe.
class Console : public TaskListener {
  public:
    struct Streams {
        std::ostream& out;
        std::ostream& err;
        int terminal = -1; ///< file descriptor of `err` where it may be a terminal; -1: no bar
    };

    explicit Console(const Streams& streams);

    bool quiet = false; ///< --quiet: errors only
    bool json = false;  ///< --json: facts as one JSON object; notes are part of it

    /// The one task of the program run.
    [[nodiscard]] Task& task() { return task_; }

    /// A fact for people; nothing with --quiet or --json.
    void say(const std::string& line);
    /// What the command was asked for: shown with --quiet too.
    void print(const std::string& text);
    /// One line, or an object with --json.
    void fail(const Error& error);
    /// Takes the bar off the screen.
    void clearBar();
    /// Throws Error(noResources) where what was said could not be written.
    void flush();

    void progressed(const std::string& phase, double fraction) override;
    void warned(const std::string& message) override;

  private:
    void drawBar();
    void eraseBar();

    Streams streams_;
    Task task_;
    std::mutex mutex_;
    bool onTerminal_ = false;
    bool barShown_ = false;
    std::string phase_;
    double fraction_ = 0;
    std::chrono::steady_clock::time_point phaseStart_;
    std::chrono::steady_clock::time_point lastDrawn_;
};

/// "0:07", "2:05:00".
std::string clockText(double seconds);

} // namespace limner::cli
