#include "widgets/axis_view.h"

#include <QLocale>

#include <cmath>

namespace limner {

AxisView::AxisView(ValueRange shown) : low_(shown.low), high_(shown.high) {
    const double least = 1e-9 * std::max(1.0, std::abs(low_));
    if (!(high_ - low_ > least))
        high_ = low_ + least;
}

void AxisView::zoom(double pivot, double factor, double whole) {
    const double wanted = std::clamp(width() * factor, whole * 1e-4, std::max(whole * 2, 1e-9));
    const double applied = wanted / width();
    low_ = pivot + (low_ - pivot) * applied;
    high_ = low_ + wanted;
}

AxisView AxisView::widened(double share) const {
    AxisView wider = *this;
    wider.low_ -= share * width();
    wider.high_ += share * width();
    return wider;
}

double niceStep(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (power * factor >= least)
            return power * factor;
    return power * 10;
}

QString valueText(double value, double resolution) {
    const int decimals =
        resolution > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(resolution) - 1e-9)), 0, 9) : 0;
    const double zero = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value; // no "-0"
    return QLocale().toString(zero, 'f', decimals);
}

} // namespace limner
