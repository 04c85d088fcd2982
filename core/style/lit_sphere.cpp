#include "core/style/lit_sphere.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace limner {
namespace {

/// Corner nearest to and farthest from the centre of a texel's square, squared distances in units of the disk.
struct Reach {
    double nearest2 = 0;
    double farthest2 = 0;
};

Reach reachOf(int size, int x, int y) {
    const auto axis = [size](int i) {
        const double low = 2.0 * i / size - 1;
        const double high = 2.0 * (i + 1) / size - 1;
        const double nearest = low > 0 ? low : (high < 0 ? -high : 0);
        return std::array<double, 2>{nearest, std::max(std::abs(low), std::abs(high))};
    };
    const auto [nearX, farX] = axis(x);
    const auto [nearY, farY] = axis(y);
    return {nearX * nearX + nearY * nearY, farX * farX + farY * farY};
}

/// Share of a texel that the disk covers; rim texels by counting points, which is good to 1/256: ample for a weight.
double coverage(int size, int x, int y) {
    const Reach reach = reachOf(size, x, y);
    if (reach.farthest2 <= 1) {
        return 1;
    }
    if (reach.nearest2 >= 1) {
        return 0;
    }
    constexpr int kPoints = 16;
    int inside = 0;
    for (int j = 0; j < kPoints; ++j) {
        const double v = 2 * (y + (j + 0.5) / kPoints) / size - 1;
        for (int i = 0; i < kPoints; ++i) {
            const double u = 2 * (x + (i + 0.5) / kPoints) / size - 1;
            inside += u * u + v * v <= 1 ? 1 : 0;
        }
    }
    return inside / static_cast<double>(kPoints * kPoints);
}

/// Whether a texel of a picture from outside can be believed: rim texels often carry some of the ground behind the
/// ball.
bool trusted(int size, int x, int y) {
    // So few texels that asking for the whole square would leave next to nothing.
    constexpr int kTiny = 8;
    if (size < kTiny) {
        const double u = (2.0 * x + 1) / size - 1;
        const double v = (2.0 * y + 1) / size - 1;
        return u * u + v * v <= 1 || size <= 2;
    }
    return reachOf(size, x, y).farthest2 <= 1;
}

std::size_t offsetOf(int size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
}

/// Gives every texel for which `inside` is false the value of the first true one on its way to the centre.
template <typename Inside>
void continueRim(int size, std::vector<Rgba>& pixels, Inside inside) {
    const double centre = (size - 1) / 2.0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            if (inside(x, y)) {
                continue;
            }
            const double dx = centre - x;
            const double dy = centre - y;
            const double length = std::hypot(dx, dy);
            // No texel whose centre is more than one texel outside the rim is inside by any rule, so start there, then
            // half a texel at a time: no texel on the way is stepped over by much.
            const double start = std::max(0.5, length - size / 2.0 - 1);
            for (double way = start; way < length; way += 0.5) {
                const int px = static_cast<int>(std::lround(x + dx / length * way));
                const int py = static_cast<int>(std::lround(y + dy / length * way));
                if (inside(px, py)) {
                    pixels[offsetOf(size, x, y)] = pixels[offsetOf(size, px, py)];
                    break;
                }
            }
        }
    }
}

/// Weighted mean of texels: alpha by coverage, colour by coverage times alpha (or by coverage where all is clear).
class Averager {
  public:
    void add(const Rgba& texel, double weight) {
        const double opaque = weight * texel.a;
        weight_ += weight;
        opaque_ += opaque;
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = c == 0 ? texel.r : (c == 1 ? texel.g : texel.b);
            colour_[c] += opaque * value;
            plain_[c] += weight * value;
        }
    }
    [[nodiscard]] bool empty() const { return weight_ <= 0; }
    [[nodiscard]] Rgba mean() const {
        const auto& sum = opaque_ > 0 ? colour_ : plain_;
        const double scale = opaque_ > 0 ? opaque_ : weight_;
        return {static_cast<float>(sum[0] / scale), static_cast<float>(sum[1] / scale),
                static_cast<float>(sum[2] / scale), static_cast<float>(opaque_ / weight_)};
    }

  private:
    double weight_ = 0;
    double opaque_ = 0;
    std::array<double, 3> colour_{};
    std::array<double, 3> plain_{};
};

float mix(float a, float b, double weight) {
    // In this form equal ends give back exactly that value.
    return static_cast<float>(a + weight * (static_cast<double>(b) - a));
}

Rgba mix(const Rgba& a, const Rgba& b, double weight) {
    return {mix(a.r, b.r, weight), mix(a.g, b.g, weight), mix(a.b, b.b, weight), mix(a.a, b.a, weight)};
}

/// Length that the intervals [a0, a1] and [b0, b1] share.
double overlap(double a0, double a1, double b0, double b1) {
    return std::max(0.0, std::min(a1, b1) - std::max(a0, b0));
}

/// Mean of the part of the disk under texel (x, y) of a picture of `coarse` texels per side; empty outside the disk.
Averager averageUnder(const LitSphere& fine, int coarse, int x, int y) {
    const int size = fine.size();
    const double scale = static_cast<double>(size) / coarse;
    const double left = x * scale;
    const double top = y * scale;
    Averager average;
    for (int j = static_cast<int>(top); j < size && j < top + scale; ++j) {
        const double high = overlap(top, top + scale, j, j + 1);
        for (int i = static_cast<int>(left); i < size && i < left + scale; ++i) {
            const double weight = high * overlap(left, left + scale, i, i + 1) * coverage(size, i, j);
            if (weight > 0) {
                average.add(fine.pixels()[offsetOf(size, i, j)], weight);
            }
        }
    }
    return average;
}

} // namespace

LitSphere::LitSphere(int size, std::vector<Rgba> pixels) : size_(size), pixels_(std::move(pixels)) {
    assert(size >= 1 && pixels_.size() == offsetOf(size, 0, size));
    continueRim(size_, pixels_, [size](int x, int y) { return trusted(size, x, y); });
    summarise();
}

LitSphere::LitSphere(Filtered, int size, std::vector<Rgba> pixels) : size_(size), pixels_(std::move(pixels)) {
    summarise();
}

void LitSphere::summarise() {
    Averager average;
    for (int y = 0; y < size_; ++y) {
        for (int x = 0; x < size_; ++x) {
            const double weight = coverage(size_, x, y);
            if (weight > 0) {
                const Rgba& texel = pixels_[offsetOf(size_, x, y)];
                average.add(texel, weight);
                directionalOpacity_ = directionalOpacity_ || texel.a < 1;
            }
        }
    }
    mean_ = average.mean();
}

Rgba LitSphere::at(double x, double y) const {
    const double length = std::hypot(x, y);
    const double scale = length > 1 ? 1 / length : 1;
    const double last = size_ - 1;
    const double column = std::clamp((0.5 + 0.5 * x * scale) * size_ - 0.5, 0.0, last);
    const double row = std::clamp((0.5 - 0.5 * y * scale) * size_ - 0.5, 0.0, last);
    const int x0 = static_cast<int>(column);
    const int y0 = static_cast<int>(row);
    const int x1 = std::min(x0 + 1, size_ - 1);
    const int y1 = std::min(y0 + 1, size_ - 1);
    const Rgba top = mix(pixels_[offsetOf(size_, x0, y0)], pixels_[offsetOf(size_, x1, y0)], column - x0);
    const Rgba bottom = mix(pixels_[offsetOf(size_, x0, y1)], pixels_[offsetOf(size_, x1, y1)], column - x0);
    return mix(top, bottom, row - y0);
}

std::shared_ptr<const LitSphere> LitSphere::half() const {
    if (size_ <= 1) {
        return nullptr;
    }
    const int coarse = size_ / 2;
    std::vector<Rgba> pixels(offsetOf(coarse, 0, coarse));
    std::vector<bool> covered(pixels.size());
    for (int y = 0; y < coarse; ++y) {
        for (int x = 0; x < coarse; ++x) {
            const Averager average = averageUnder(*this, coarse, x, y);
            covered[offsetOf(coarse, x, y)] = !average.empty();
            if (!average.empty()) {
                pixels[offsetOf(coarse, x, y)] = average.mean();
            }
        }
    }
    continueRim(coarse, pixels, [&](int x, int y) { return covered[offsetOf(coarse, x, y)]; });
    return std::shared_ptr<const LitSphere>(new LitSphere(Filtered{}, coarse, std::move(pixels)));
}

} // namespace limner
