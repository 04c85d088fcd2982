#pragma once

#include "core/base/task.h"

namespace limner::cli {

/// While it lives, Ctrl-C (SIGINT), SIGTERM and SIGHUP cancel the task. Where the work does not stop within half a
/// second, or at a second signal, the process removes the files it was writing and ends with 130. One at a time.
class InterruptGuard {
  public:
    explicit InterruptGuard(Task& task);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

} // namespace limner::cli
