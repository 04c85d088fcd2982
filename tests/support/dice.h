#pragma once

#include <initializer_list>
#include <random>

namespace limner::testing {

/// Random choices with names.
class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    /// Not std's distributions: they differ between libraries.
    double unit() { return static_cast<double>(random_()) / 4294967296.0; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    bool oneIn(int count) { return below(count) == 0; }
    template <typename T>
    T any(std::initializer_list<T> choices) {
        return choices.begin()[below(static_cast<int>(choices.size()))];
    }

  private:
    std::mt19937 random_;
};

} // namespace limner::testing
