#pragma once

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>

#include <functional>

namespace limner::testing {

/// The one QApplication of a test program, made on first use and left to the process's end. Settings go to a folder of
/// the test's own.
inline QApplication& qtApplication() {
    static QApplication* application = [] {
        static int argc = 1;
        static char name[] = "limner-test";
        static char* argv[] = {name, nullptr};
        auto* made = new QApplication(argc, argv);
        QApplication::setOrganizationName("LimnerTest");
        QApplication::setApplicationName("limner-test");
        static const QTemporaryDir settings;
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
        return made;
    }();
    return *application;
}

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
