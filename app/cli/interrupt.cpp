#include "app/cli/interrupt.h"

#include "core/base/pending_file.h"

#include <atomic>
#include <cassert>
#include <csignal>

#include <sys/time.h>
#include <unistd.h>

namespace limner::cli {

namespace {

std::atomic<Task*> running{nullptr};
std::atomic<bool> interrupted{false};
static_assert(std::atomic<Task*>::is_always_lock_free, "a signal handler may not lock");

/// For work inside a library that cannot be told to stop: nothing is left behind all the same.
void endNow(int /*signal*/) {
    removePendingFiles();
    constexpr char kLine[] = "limner: cancelled\n";
    [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, kLine, sizeof kLine - 1);
    ::_exit(130);
}

void onInterrupt(int signal) {
    Task* const task = running.load();
    if (task == nullptr || interrupted.exchange(true)) {
        endNow(signal);
    }
    task->cancel();
    itimerval halfSecond{};
    halfSecond.it_value.tv_usec = 500'000;
    ::setitimer(ITIMER_REAL, &halfSecond, nullptr);
}

void handle(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART; // libraries do not all retry an interrupted read
    sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
}

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

} // namespace

InterruptGuard::InterruptGuard(Task& task) {
    assert(running.load() == nullptr);
    interrupted = false;
    running = &task;
    handle(SIGALRM, endNow);
    for (const int signal : kSignals) {
        struct sigaction before {};
        ::sigaction(signal, nullptr, &before);
        if (signal != SIGHUP || before.sa_handler != SIG_IGN) { // nohup's wish stands
            handle(signal, onInterrupt);
        }
    }
    handle(SIGXFSZ, SIG_IGN); // a file over the limit is a failed write, not the end of the program
    handle(SIGPIPE, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
    const itimerval none{};
    ::setitimer(ITIMER_REAL, &none, nullptr);
    for (const int signal : kSignals) {
        handle(signal, SIG_DFL);
    }
    handle(SIGALRM, SIG_DFL);
    running = nullptr;
}

} // namespace limner::cli
