#pragma once

#include <cstdint>
#include <span>

namespace limner {

/// An ICC profile of sRGB, the same bytes in every run. Empty where the library cannot make one.
std::span<const std::uint8_t> srgbProfile();

} // namespace limner
