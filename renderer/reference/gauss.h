#pragma once

#include <array>

namespace limner::reference {

/// Eight-point Gauss-Legendre rule on [0, 1]: exact for polynomials up to degree 15.
struct GaussRule {
    std::array<double, 8> point;
    std::array<double, 8> weight;
};

const GaussRule& gaussRule();

} // namespace limner::reference
