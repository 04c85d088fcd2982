#pragma once

#include "core/volume/volume.h"

#include <QString>

#include <algorithm>

namespace limner {

/// The shown part of a canvas's axis: values to shares of the canvas's side and back.
class AxisView {
  public:
    AxisView() = default;
    /// A range without width is drawn out to one.
    explicit AxisView(ValueRange shown);

    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    [[nodiscard]] double width() const { return high_ - low_; }
    [[nodiscard]] double shareOf(double value) const { return (value - low_) / (high_ - low_); }
    [[nodiscard]] double valueOf(double share) const { return low_ + share * (high_ - low_); }

    /// `factor` below 1 shows less; the pivot stays where it is. Held between a ten-thousandth and twice of `whole`.
    void zoom(double pivot, double factor, double whole);
    void shift(double by) {
        low_ += by;
        high_ += by;
    }
    /// The same with a margin on both sides, as a share of the width.
    [[nodiscard]] AxisView widened(double share) const;

  private:
    double low_ = 0;
    double high_ = 1;
};

/// A step of 1, 2 or 5 times a power of ten, at least `least`.
double niceStep(double least);

/// "1 250" or "0.125": as many digits as the step between neighbouring pixels needs.
QString valueText(double value, double resolution);

} // namespace limner
