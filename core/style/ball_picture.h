#pragma once

#include "core/style/lit_sphere.h"

#include <vector>

namespace limner {

/// A style as its ball is seen on white paper, `size` pixels square, top row first: opaque on a clear ground, its rim
/// smooth.
std::vector<Rgba> ballPicture(const LitSphere& sphere, int size);

} // namespace limner
