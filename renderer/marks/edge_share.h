#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

#ifdef __SSE__
#include <immintrin.h>
#endif

namespace limner {

/// Four numbers side by side, for processors that count so; compilers make a loop of it for the others.
using Four = float __attribute__((vector_size(16)));

inline Four atLeast0(Four x) {
#ifdef __SSE__
    return _mm_max_ps(x, Four{});
#else
    return x > 0 ? x : Four{};
#endif
}

inline Four atMost(Four x, Four most) {
#ifdef __SSE__
    return _mm_min_ps(x, most);
#else
    return x < most ? x : most;
#endif
}
inline Four squareRoot(Four x) {
#ifdef __SSE__
    return _mm_sqrt_ps(x);
#else
    return Four{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

/// The share of a pixel that lies on the inner side of a straight edge: `inside` is its middle's distance to the edge,
/// (a, b) the edge's unit normal.
inline float halfPlane(float inside, float a, float b) {
    a = std::abs(a);
    b = std::abs(b);
    const float most = 0.5F * (a + b);
    if (std::abs(inside) >= most)
        return inside > 0 ? 1.0F : 0.0F;
    const float flat = 0.5F * std::abs(a - b);
    if (std::abs(inside) <= flat)
        return 0.5F + inside / std::max(a, b);
    const float corner = (most - std::abs(inside)) * (most - std::abs(inside)) / (2 * a * b);
    return inside > 0 ? 1 - corner : corner;
}

} // namespace limner
