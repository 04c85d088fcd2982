#include "app/cli/console.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include <sys/ioctl.h>
#include <unistd.h>

namespace limner::cli {

namespace {

constexpr int kNarrowest = 30; // columns: below it a bar says nothing
constexpr int kWidestBar = 40;

int columnsOf(int terminal) {
    winsize size{};
    return ::ioctl(terminal, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

} // namespace

std::string clockText(double seconds) {
    const auto whole = static_cast<long>(std::lround(std::clamp(seconds, 0.0, 359'999.0))); // 99:59:59 is for ever
    char text[32];
    if (whole >= 3600) {
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    } else {
        std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    }
    return text;
}

Console::Console(const Streams& streams)
    : streams_(streams), task_(*this), onTerminal_(streams.terminal >= 0 && ::isatty(streams.terminal) == 1) {}

void Console::say(const std::string& line) {
    if (!quiet && !json) {
        print(line + "\n");
    }
}

void Console::print(const std::string& text) {
    const std::lock_guard lock(mutex_);
    eraseBar();
    streams_.out << text;
}

void Console::flush() {
    streams_.out.flush();
    if (!streams_.out) {
        throw Error(ErrorKind::noResources, {"cannot write the answer", "standard output", "", "is the disk full?"});
    }
}

void Console::fail(const Error& error) {
    const std::lock_guard lock(mutex_);
    eraseBar();
    if (json) {
        const ErrorText& text = error.text();
        const nlohmann::ordered_json object{{"error",
                                             {{"what", text.what},
                                              {"where", text.where},
                                              {"why", text.why},
                                              {"remedy", text.remedy},
                                              {"exit_code", static_cast<int>(error.kind())}}}};
        streams_.err << object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    } else {
        streams_.err << "limner: " << error.what() << '\n';
    }
    streams_.err.flush();
}

void Console::warned(const std::string& message) {
    const std::lock_guard lock(mutex_);
    if (quiet || json) {
        return;
    }
    eraseBar();
    streams_.err << "note: " << oneLine({message, "", "", ""}) << '\n';
    streams_.err.flush();
}

void Console::progressed(const std::string& phase, double fraction) {
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (phase != phase_ || fraction == 0) {
        phase_ = phase;
        phaseStart_ = now;
    }
    fraction_ = fraction;
    constexpr auto kRedraw = std::chrono::milliseconds(100); // smooth to the eye, nothing for a slow line
    if (onTerminal_ && !quiet && now - lastDrawn_ >= kRedraw) {
        lastDrawn_ = now;
        drawBar();
    }
}

void Console::clearBar() {
    const std::lock_guard lock(mutex_);
    eraseBar();
}

void Console::drawBar() {
    const int columns = columnsOf(streams_.terminal);
    if (columns < kNarrowest) {
        return;
    }
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - phaseStart_).count();
    std::string left;
    if (fraction_ > 0.01 && elapsed > 0.5) { // before that the guess jumps about
        left = "  " + clockText(elapsed * (1 - fraction_) / fraction_) + " left";
    }
    char percent[8];
    std::snprintf(percent, sizeof percent, "%3d %%", static_cast<int>(fraction_ * 100));
    const std::string name = phase_.substr(0, static_cast<std::size_t>(columns) / 3);
    const int used = static_cast<int>(name.size() + left.size()) + 12; // brackets, spaces, the percentage
    const int width = std::clamp(columns - used, 0, kWidestBar);
    const int full = static_cast<int>(fraction_ * width);
    streams_.err << "\r\033[K" << name << "  [" << std::string(static_cast<std::size_t>(full), '#')
                 << std::string(static_cast<std::size_t>(width - full), '.') << "] " << percent << left;
    streams_.err.flush();
    barShown_ = true;
}

void Console::eraseBar() {
    if (barShown_) {
        streams_.err << "\r\033[K";
        streams_.err.flush();
        barShown_ = false;
    }
}

} // namespace limner::cli
