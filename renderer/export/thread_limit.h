#pragma once

#include <memory>

namespace limner {

/// While it lives, the work of this process runs on at most that many threads.
class ThreadLimit {
  public:
    /// `threads` > 0.
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

  private:
    struct Control;
    std::unique_ptr<Control> control_;
};

} // namespace limner
