#pragma once

#include <QApplication>
#include <QElapsedTimer>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace limner::testing {

/// An application that notes how long each event's handling keeps the event loop, and says at the end which were the
/// longest: the window must answer within 50 ms whatever it does. Says, does not judge: machines are noisy.
class TimedApplication : public QApplication {
  public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override {
        if (depth_ > 0) // events inside of an event's handling count with it
            return QApplication::notify(receiver, event);
        const std::string what = std::string(receiver->metaObject()->className()) + " \"" +
                                 receiver->objectName().toStdString() + "\" event " + std::to_string(event->type());
        ++depth_;
        QElapsedTimer clock;
        clock.start();
        const bool result = QApplication::notify(receiver, event);
        --depth_;
        note(static_cast<double>(clock.nsecsElapsed()) * 1e-6, what);
        return result;
    }

    void startTest(const std::string& name) { test_ = name; }

    void report() const {
        std::printf("longest events of the run (limit for a window: 50 ms), %d of %d over it:\n", over_, events_);
        for (const Note& one : longest_)
            std::printf("  %6.1f ms  %s  in %s\n", one.ms, one.what.c_str(), one.test.c_str());
    }

  private:
    struct Note {
        double ms = 0;
        std::string what, test;
    };
    void note(double ms, const std::string& what) {
        constexpr double kLimitMs = 50;
        constexpr std::size_t kShown = 12;
        ++events_;
        over_ += ms > kLimitMs ? 1 : 0;
        longest_.push_back({ms, what, test_});
        std::ranges::sort(longest_, [](const Note& a, const Note& b) { return a.ms > b.ms; });
        longest_.resize(std::min(longest_.size(), kShown));
    }

    int depth_ = 0;
    int events_ = 0;
    int over_ = 0;
    std::string test_;
    std::vector<Note> longest_;
};

} // namespace limner::testing
