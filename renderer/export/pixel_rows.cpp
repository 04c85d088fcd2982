#include "renderer/export/pixel_rows.h"

#include "renderer/export/backdrop.h"

#include <OpenImageIO/half.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace limner {

float linearFromSrgb(float encoded) {
    const float magnitude = std::fabs(encoded);
    const float linear = magnitude <= 0.04045F ? magnitude / 12.92F : std::pow((magnitude + 0.055F) / 1.055F, 2.4F);
    return std::copysign(linear, encoded);
}

float srgbFromLinear(float linear) {
    const float magnitude = std::fabs(linear);
    const float encoded =
        magnitude <= 0.0031308F ? magnitude * 12.92F : 1.055F * std::pow(magnitude, 1 / 2.4F) - 0.055F;
    return std::copysign(encoded, linear);
}

namespace {

template <typename T>
T quantise(float value) {
    if constexpr (std::is_integral_v<T>) {
        constexpr float kMax = std::numeric_limits<T>::max();
        return static_cast<T>(std::clamp(value, 0.0F, 1.0F) * kMax + 0.5F);
    } else {
        return T(value);
    }
}

/// What lies behind a row of pixels: one colour, or one for each.
class Behind {
  public:
    Behind(const PixelLayout& layout, int width) : backdrop_(layout.backdrop.get()) {
        // The background colour as it looks on white paper.
        const glm::dvec4& rgba = layout.background;
        const auto channel = [&](double c) { return static_cast<float>(c * rgba.a + (1 - rgba.a)); };
        colour_ = {channel(rgba.r), channel(rgba.g), channel(rgba.b)};
        if (backdrop_ != nullptr) {
            row_.resize(static_cast<std::size_t>(width) * 3);
        }
    }

    void goTo(glm::ivec2 start) {
        if (backdrop_ == nullptr) {
            return;
        }
        for (std::size_t i = 0; i < row_.size(); ++i) {
            row_[i] = colour_[i % 3];
        }
        backdrop_->layOver(start, row_);
    }
    [[nodiscard]] const float* rgb() const { return backdrop_ != nullptr ? row_.data() : colour_.data(); }
    [[nodiscard]] int stride() const { return backdrop_ != nullptr ? 3 : 0; }

  private:
    const Backdrop* backdrop_;
    std::array<float, 3> colour_{};
    std::vector<float> row_;
};

template <typename T, AlphaForm kAlpha, bool kLinear>
std::uint64_t convertRow(const float* in, int count, const Behind& behind, T* out) {
    std::uint64_t notFinite = 0;
    const float* paper = behind.rgb();
    for (int x = 0; x < count; ++x, in += 4, paper += behind.stride()) {
        float c[3] = {in[0], in[1], in[2]};
        float a = in[3];
        // A sum is finite where all four are, but for sums that overflow, which are as bad.
        if (!std::isfinite(c[0] + c[1] + c[2] + a)) {
            ++notFinite;
            c[0] = c[1] = c[2] = a = 0;
        }
        a = std::clamp(a, 0.0F, 1.0F);
        if constexpr (kAlpha == AlphaForm::none || kAlpha == AlphaForm::opaque) {
            c[0] += (1 - a) * paper[0];
            c[1] += (1 - a) * paper[1];
            c[2] += (1 - a) * paper[2];
            a = 1;
        } else if constexpr (kAlpha == AlphaForm::unassociated || kLinear) {
            const float scale = a > 0 ? 1 / a : 0;
            c[0] *= scale;
            c[1] *= scale;
            c[2] *= scale;
        }
        for (float& channel : c) {
            if constexpr (kLinear) {
                channel = linearFromSrgb(channel);
                if constexpr (kAlpha == AlphaForm::premultiplied) {
                    channel *= a;
                }
            }
            *out++ = quantise<T>(channel);
        }
        if constexpr (kAlpha != AlphaForm::none) {
            *out++ = quantise<T>(a);
        }
    }
    return notFinite;
}

template <typename T, AlphaForm kAlpha, bool kLinear>
std::uint64_t convertTile(const Picture& tile, const PixelLayout& layout, const BandTarget& target) {
    const auto channels = static_cast<std::size_t>(layout.channels());
    T* const out = reinterpret_cast<T*>(target.bytes.data());
    return tbb::parallel_reduce(
        tbb::blocked_range<int>(0, tile.size().y, 8), std::uint64_t{0}, // 8 rows: some 10 us of work at least
        [&](const tbb::blocked_range<int>& rows, std::uint64_t notFinite) {
            Behind behind(layout, tile.size().x);
            for (int y = rows.begin(); y < rows.end(); ++y) {
                const auto row = static_cast<std::size_t>(target.origin.y + y);
                const std::size_t first =
                    row * static_cast<std::size_t>(target.width) + static_cast<std::size_t>(target.origin.x);
                behind.goTo(target.place + glm::ivec2(0, y));
                notFinite +=
                    convertRow<T, kAlpha, kLinear>(tile.pixel(0, y), tile.size().x, behind, out + first * channels);
            }
            return notFinite;
        },
        std::plus<>());
}

template <typename T>
std::uint64_t convertTyped(const Picture& tile, const PixelLayout& layout, const BandTarget& target) {
    switch (layout.alpha) {
    case AlphaForm::none:
        return layout.linear ? convertTile<T, AlphaForm::none, true>(tile, layout, target)
                             : convertTile<T, AlphaForm::none, false>(tile, layout, target);
    case AlphaForm::opaque: return convertTile<T, AlphaForm::opaque, false>(tile, layout, target);
    case AlphaForm::unassociated: return convertTile<T, AlphaForm::unassociated, false>(tile, layout, target);
    case AlphaForm::premultiplied:
        return layout.linear ? convertTile<T, AlphaForm::premultiplied, true>(tile, layout, target)
                             : convertTile<T, AlphaForm::premultiplied, false>(tile, layout, target);
    }
    return 0;
}

} // namespace

std::uint64_t writePixels(const Picture& tile, const PixelLayout& layout, const BandTarget& target) {
    assert(target.origin.x >= 0 && target.origin.x + tile.size().x <= target.width);
    assert(static_cast<std::size_t>(target.origin.y + tile.size().y) * static_cast<std::size_t>(target.width) *
               layout.bytesPerPixel() <=
           target.bytes.size());
    switch (layout.type) {
    case SampleType::uint8: return convertTyped<std::uint8_t>(tile, layout, target);
    case SampleType::uint16: return convertTyped<std::uint16_t>(tile, layout, target);
    case SampleType::half: return convertTyped<half>(tile, layout, target);
    case SampleType::float32: return convertTyped<float>(tile, layout, target);
    }
    return 0;
}

} // namespace limner
