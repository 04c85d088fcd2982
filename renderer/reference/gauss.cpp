#include "renderer/reference/gauss.h"

#include <cmath>
#include <utility>

namespace limner::reference {

namespace {

/// P_n and its derivative by the three-term recurrence.
std::pair<double, double> legendre(int n, double x) {
    double previous = 1;
    double current = x;
    for (int k = 2; k <= n; ++k) {
        previous = std::exchange(current, ((2 * k - 1) * x * current - (k - 1) * previous) / k);
    }
    return {current, n * (x * current - previous) / (x * x - 1)};
}

/// Points and weights from the roots of P_8, by symmetry about 1/2.
GaussRule makeGaussRule() {
    GaussRule rule;
    constexpr int n = 8;
    for (int i = 0; i < n; ++i) {
        double x = std::cos(3.14159265358979323846 * (i + 0.75) / (n + 0.5)); // start near the root
        for (int newton = 0; newton < 20; ++newton) {                         // 5 reach double precision
            const auto [p, dp] = legendre(n, x);
            x -= p / dp;
        }
        const double dp = legendre(n, x).second;
        rule.point[static_cast<std::size_t>(i)] = (1 - x) / 2;
        rule.weight[static_cast<std::size_t>(i)] = 1 / ((1 - x * x) * dp * dp);
    }
    return rule;
}

} // namespace

const GaussRule& gaussRule() {
    static const GaussRule rule = makeGaussRule();
    return rule;
}

} // namespace limner::reference
