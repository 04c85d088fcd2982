#pragma once

#include <QApplication>
#include <QElapsedTimer>

#include <functional>

namespace limner::testing {

/// Runs the event loop until `done` or the time is over; tells whether it was done.
inline bool pumpUntil(const std::function<bool()>& done, int atMostMs = 120000) {
    QElapsedTimer clock;
    clock.start();
    while (!done()) {
        if (clock.elapsed() > atMostMs)
            return false;
        QApplication::processEvents(QEventLoop::AllEvents, 10);
    }
    return true;
}

} // namespace limner::testing
