#pragma once

#include <cstdint>

namespace limner {

/// A number's bits, mixed so that neighbours have nothing in common: chance that is the same everywhere.
inline std::uint32_t mixedBits(std::uint32_t x) {
    x ^= x >> 16U;
    x *= 0x7feb352dU;
    x ^= x >> 15U;
    x *= 0x846ca68bU;
    return x ^ (x >> 16U);
}

} // namespace limner
