#pragma once

#include <QElapsedTimer>

#include <string>

namespace limner {

/// Merge keys for edits: one per drag, and one per run of key presses or wheel clicks that follow each other closely.
class GestureKey {
  public:
    /// A new gesture begins (a mouse press).
    std::string begin(const std::string& name) {
        name_ = name + "#" + std::to_string(++number_);
        clock_.start();
        return name_;
    }
    /// The running gesture's key, or a new one where the last such edit was of another kind or is too long ago.
    std::string again(const std::string& name) {
        constexpr qint64 kPauseMs = 1000; // a pause that people mean
        if (!name_.starts_with(name + "#") || !clock_.isValid() || clock_.elapsed() > kPauseMs)
            return begin(name);
        clock_.restart();
        return name_;
    }

    /// The key of a gesture whose button is still down, or is let go now: however long the hand rests.
    std::string during(const std::string& name) {
        if (!name_.starts_with(name + "#"))
            return begin(name);
        clock_.restart();
        return name_;
    }

  private:
    std::string name_;
    unsigned number_ = 0;
    QElapsedTimer clock_;
};

} // namespace limner
