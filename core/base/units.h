#pragma once

namespace limner {

inline constexpr double kMmPerInch = 25.4;

/// Pixels that `lengthMm` on paper takes at `dpi`.
constexpr double pixelsFromMm(double lengthMm, double dpi) { return lengthMm * dpi / kMmPerInch; }

/// Length on paper of `pixels` at `dpi`.
constexpr double mmFromPixels(double pixels, double dpi) { return pixels * kMmPerInch / dpi; }

} // namespace limner
