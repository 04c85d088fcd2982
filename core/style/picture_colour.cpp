#include "core/style/picture_colour.h"

#include <lcms2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace limner {
namespace {

using Colour = PictureChannels::Colour;

static_assert(sizeof(Rgba) == 4 * sizeof(float));

/// Pixels that are converted at a time: what they need fits into the caches.
constexpr std::size_t kChunk = 1024;

float encodeSrgb(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

/// NaN counts as 0.
float clampUnit(float value) { return value > 0 ? std::min(value, 1.0F) : 0.0F; }

float alphaOf(const float* texel, const PictureChannels& channels) {
    return channels.alpha >= 0 ? clampUnit(texel[channels.alpha]) : 1.0F;
}

/// A colour sample, not premultiplied.
float sampleOf(const float* texel, std::size_t i, float alpha, const PictureChannels& channels) {
    float value = texel[channels.at[i]];
    if (channels.premultiplied && alpha > 0) {
        value /= alpha;
    }
    return clampUnit(value);
}

Rgba plainRgba(const float* texel, const PictureChannels& channels) {
    const float alpha = alphaOf(texel, channels);
    std::array<float, 3> colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        const float value = sampleOf(texel, channels.colour == Colour::grey ? 0 : c, alpha, channels);
        colour[c] = channels.linear ? encodeSrgb(value) : value;
    }
    return {colour[0], colour[1], colour[2], alpha};
}

/// As other programs show it: every ink multiplies what the black leaves, in the file's own steps.
Rgba plainCmyk(const float* texel, const PictureChannels& channels) {
    const float alpha = alphaOf(texel, channels);
    std::array<float, 4> left{};
    for (std::size_t c = 0; c < 4; ++c) {
        left[c] = 1 - sampleOf(texel, c, alpha, channels);
    }
    const auto stepped = [&](float value) {
        const auto steps = static_cast<float>(channels.steps);
        return channels.steps > 0 ? std::floor(value * steps + 0.5F) / steps : value;
    };
    return {stepped(left[0] * left[3]), stepped(left[1] * left[3]), stepped(left[2] * left[3]), alpha};
}

struct CloseProfile {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, CloseProfile>;

struct DeleteTransform {
    void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using Handle = std::unique_ptr<void, DeleteTransform>;

/// What Little CMS takes and gives.
enum class Samples { bytes, words, floats };

/// Whole samples where that loses nothing: Little CMS is much faster with them. Of 16-bit RGB and grey it makes a table
/// that is coarse near black and at the edge of sRGB (`Sums` is better and as fast); inks come from a table anyway.
Samples samplesFor(const PictureChannels& channels) {
    if (channels.steps == 255 && !channels.premultiplied) {
        return Samples::bytes;
    }
    return channels.steps > 0 && channels.colour == Colour::cmyk ? Samples::words : Samples::floats;
}

std::size_t inksOf(Colour colour) { return colour == Colour::grey ? 1 : (colour == Colour::rgb ? 3 : 4); }

cmsUInt32Number inputFormat(Colour colour, Samples samples) {
    switch (samples) {
    case Samples::bytes:
        return colour == Colour::grey ? TYPE_GRAY_8 : (colour == Colour::rgb ? TYPE_RGB_8 : TYPE_CMYK_8);
    case Samples::words:
        return colour == Colour::grey ? TYPE_GRAY_16 : (colour == Colour::rgb ? TYPE_RGB_16 : TYPE_CMYK_16);
    case Samples::floats: break;
    }
    return colour == Colour::grey ? TYPE_GRAY_FLT : (colour == Colour::rgb ? TYPE_RGB_FLT : TYPE_CMYK_FLT);
}

cmsColorSpaceSignature spaceOf(Colour colour) {
    return colour == Colour::grey ? cmsSigGrayData : (colour == Colour::rgb ? cmsSigRgbData : cmsSigCmykData);
}

template <typename Sample, typename Scaled>
void pack(std::span<const float> texels, const PictureChannels& channels, Sample* out, Scaled scaled) {
    const std::size_t inks = inksOf(channels.colour);
    const auto count = static_cast<std::size_t>(channels.count);
    for (std::size_t i = 0; i + count <= texels.size(); i += count) {
        const float* texel = texels.data() + i;
        const float alpha = alphaOf(texel, channels);
        for (std::size_t c = 0; c < inks; ++c) {
            *out++ = scaled(sampleOf(texel, c, alpha, channels));
        }
    }
}

} // namespace

namespace {

/// A transform of grey or RGB to linear sRGB in which every channel adds its share, whatever the others are: what a
/// profile of curves and a matrix does, black point and all. Read from Little CMS once, as tables.
class Sums {
  public:
    /// Absent where the profile is of another kind.
    static std::optional<Sums> of(void* toLinear, std::size_t inks) {
        Sums sums;
        const auto run = [&](const std::array<float, 3>& from) {
            std::array<float, 3> to{};
            cmsDoTransform(toLinear, from.data(), to.data(), 1);
            return to;
        };
        sums.zero_ = run({0, 0, 0});
        for (std::size_t ink = 0; ink < inks; ++ink) {
            for (std::size_t i = 0; i <= kSteps; ++i) {
                std::array<float, 3> from{};
                from[ink] = static_cast<float>(i) / kSteps;
                std::array<float, 3> to = run(from);
                for (std::size_t c = 0; c < 3; ++c) {
                    to[c] -= sums.zero_[c];
                }
                sums.shares_[ink].push_back(to);
            }
        }
        for (int i = 0; i < 64; ++i) {
            const auto level = [&](int times) { return static_cast<float>(i * times % 64) / 63; };
            const std::array<float, 3> from{level(1), level(23), level(41)};
            const std::array<float, 3> to = run(from);
            const std::array<float, 3> sum = sums.linear(from.data(), inks);
            for (std::size_t c = 0; c < 3; ++c) {
                if (!(std::abs(sum[c] - to[c]) < kExact)) {
                    return std::nullopt;
                }
            }
        }
        return sums;
    }

    /// `samples`: 0..1.
    [[nodiscard]] std::array<float, 3> encoded(const float* samples, std::size_t inks) const {
        std::array<float, 3> colour = linear(samples, inks);
        for (float& value : colour) {
            value = encodedByTable(clampUnit(value));
        }
        return colour;
    }

  private:
    static constexpr std::size_t kSteps = 4096;
    static constexpr float kExact = 1e-4F;

    [[nodiscard]] std::array<float, 3> linear(const float* samples, std::size_t inks) const {
        std::array<float, 3> sum = zero_;
        for (std::size_t ink = 0; ink < inks; ++ink) {
            const float at = samples[ink] * kSteps;
            const std::size_t below = std::min(static_cast<std::size_t>(at), kSteps - 1);
            const float beyond = at - static_cast<float>(below);
            const auto& low = shares_[ink][below];
            const auto& high = shares_[ink][below + 1];
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += low[c] + (high[c] - low[c]) * beyond;
            }
        }
        return sum;
    }

    static float encodedByTable(float value) {
        constexpr std::size_t kCodes = 16384;
        static const std::vector<float> codes = [] {
            std::vector<float> table;
            for (std::size_t i = 0; i <= kCodes; ++i) {
                table.push_back(encodeSrgb(static_cast<float>(i) / kCodes));
            }
            return table;
        }();
        const float at = value * kCodes;
        const std::size_t below = std::min(static_cast<std::size_t>(at), kCodes - 1);
        return codes[below] + (codes[below + 1] - codes[below]) * (at - static_cast<float>(below));
    }

    std::array<float, 3> zero_{};
    std::array<std::vector<std::array<float, 3>>, 3> shares_;
};

/// sRGB without its curve.
Profile linearSrgb() {
    const cmsCIExyY white{0.3127, 0.3290, 1};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
    cmsToneCurve* straight = cmsBuildGamma(nullptr, 1);
    cmsToneCurve* const curves[] = {straight, straight, straight};
    Profile profile(cmsCreateRGBProfile(&white, &primaries, curves));
    cmsFreeToneCurve(straight);
    return profile;
}

} // namespace

/// From the profile's colours to sRGB.
class PictureColour::Transform {
  public:
    static std::unique_ptr<Transform> make(const PictureChannels& channels, std::span<const std::uint8_t> bytes) {
        const Profile profile(
            bytes.empty() ? nullptr : cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
        if (profile == nullptr || cmsGetColorSpace(profile.get()) != spaceOf(channels.colour)) {
            return nullptr;
        }
        std::unique_ptr<Transform> transform(new Transform);
        transform->samples_ = samplesFor(channels);
        // Black stays black: what a scan's profile calls black is the darkest that its paper holds.
        constexpr cmsUInt32Number kFlags = cmsFLAGS_NOCACHE | cmsFLAGS_BLACKPOINTCOMPENSATION | cmsFLAGS_HIGHRESPRECALC;
        const auto make = [&](const Profile& to, Samples samples) {
            return cmsCreateTransform(profile.get(), inputFormat(channels.colour, samples), to.get(),
                                      samples == Samples::floats ? TYPE_RGB_FLT : TYPE_RGB_16,
                                      INTENT_RELATIVE_COLORIMETRIC, kFlags);
        };
        if (transform->samples_ == Samples::floats) {
            const Handle toLinear(make(linearSrgb(), Samples::floats));
            transform->sums_ = toLinear == nullptr ? std::nullopt : Sums::of(toLinear.get(), inksOf(channels.colour));
            if (transform->sums_) {
                return transform;
            }
            transform->samples_ = channels.steps > 0 ? Samples::words : Samples::floats;
        }
        transform->handle_.reset(make(Profile(cmsCreate_sRGBProfile()), transform->samples_));
        return transform->handle_ == nullptr ? nullptr : std::move(transform);
    }

    /// At most `kChunk` pixels.
    void run(const PictureChannels& channels, std::span<const float> texels, std::span<Rgba> out) const {
        std::array<float, kChunk * 4> in{}; // large enough for whole samples too
        std::array<float, kChunk * 3> rgb{};
        pack(channels, texels, in.data());
        if (sums_) {
            const std::size_t inks = inksOf(channels.colour);
            for (std::size_t i = 0; i < out.size(); ++i) {
                const auto colour = sums_->encoded(in.data() + i * inks, inks);
                out[i] = {colour[0], colour[1], colour[2],
                          alphaOf(texels.data() + i * static_cast<std::size_t>(channels.count), channels)};
            }
            return;
        }
        cmsDoTransform(handle_.get(), in.data(), rgb.data(), static_cast<cmsUInt32Number>(out.size()));
        const auto* words = reinterpret_cast<const std::uint16_t*>(rgb.data());
        for (std::size_t i = 0; i < out.size(); ++i) {
            const auto value = [&](std::size_t c) {
                const std::size_t at = 3 * i + c;
                return samples_ == Samples::floats ? clampUnit(rgb[at]) : static_cast<float>(words[at]) / 65535.0F;
            };
            out[i] = {value(0), value(1), value(2),
                      alphaOf(texels.data() + i * static_cast<std::size_t>(channels.count), channels)};
        }
    }

  private:
    Transform() = default;

    void pack(const PictureChannels& channels, std::span<const float> texels, float* in) const {
        switch (samples_) {
        case Samples::bytes:
            limner::pack(texels, channels, reinterpret_cast<std::uint8_t*>(in),
                         [](float v) { return static_cast<std::uint8_t>(v * 255 + 0.5F); });
            break;
        case Samples::words:
            limner::pack(texels, channels, reinterpret_cast<std::uint16_t*>(in),
                         [](float v) { return static_cast<std::uint16_t>(v * 65535 + 0.5F); });
            break;
        case Samples::floats:
            // Little CMS counts ink in percent.
            limner::pack(texels, channels, in,
                         [scale = channels.colour == Colour::cmyk ? 100.0F : 1.0F](float v) { return v * scale; });
            break;
        }
    }

    Samples samples_ = Samples::floats;
    Handle handle_;
    std::optional<Sums> sums_; ///< instead of `handle_`
};

namespace {

/// Whether colours come out as they went in, to less than what the eye or an 8-bit picture tells.
bool changesNothing(const PictureColour& colour) {
    constexpr int kLevels = 9;
    constexpr float kSmall = 1.25F / 255;
    PictureChannels channels = colour.channels();
    const bool grey = channels.colour == Colour::grey;
    std::vector<float> samples;
    std::vector<Rgba> expected;
    for (int i = 0; i < kLevels * kLevels * kLevels; ++i) {
        const auto level = [](int step) { return std::floor(255.0F * static_cast<float>(step) / (kLevels - 1)) / 255; };
        const Rgba rgb{level(i % kLevels), level(i / kLevels % kLevels), level(i / kLevels / kLevels)};
        std::vector<float> texel(static_cast<std::size_t>(channels.count), 1.0F);
        texel[static_cast<std::size_t>(channels.at[0])] = rgb.r;
        if (!grey) {
            texel[static_cast<std::size_t>(channels.at[1])] = rgb.g;
            texel[static_cast<std::size_t>(channels.at[2])] = rgb.b;
        }
        samples.insert(samples.end(), texel.begin(), texel.end());
        expected.push_back(grey ? Rgba{rgb.r, rgb.r, rgb.r} : rgb);
    }
    std::vector<Rgba> got(expected.size());
    colour.toRgba(samples, got);
    return std::equal(got.begin(), got.end(), expected.begin(), [&](const Rgba& a, const Rgba& b) {
        return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) <= kSmall;
    });
}

} // namespace

PictureColour::PictureColour(const PictureChannels& channels, std::span<const std::uint8_t> profile)
    : channels_(channels), transform_(Transform::make(channels, profile)) {
    if (transform_ == nullptr) {
        return;
    }
    channels_.linear = false;
    if (channels.colour != Colour::cmyk && changesNothing(*this)) {
        transform_.reset();
    }
}

PictureColour::~PictureColour() = default;
PictureColour::PictureColour(PictureColour&&) noexcept = default;
PictureColour& PictureColour::operator=(PictureColour&&) noexcept = default;

void PictureColour::toRgba(std::span<const float> samples, std::span<Rgba> out) const {
    const auto count = static_cast<std::size_t>(channels_.count);
    if (transform_ != nullptr) {
        for (std::size_t i = 0; i < out.size(); i += kChunk) {
            const std::size_t pixels = std::min(kChunk, out.size() - i);
            transform_->run(channels_, samples.subspan(i * count, pixels * count), out.subspan(i, pixels));
        }
        return;
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float* texel = samples.data() + i * count;
        out[i] = channels_.colour == Colour::cmyk ? plainCmyk(texel, channels_) : plainRgba(texel, channels_);
    }
}

} // namespace limner
