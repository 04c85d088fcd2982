#pragma once

#include "core/style/lit_sphere.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace limner {

/// How the channels of a picture file give an RGBA value. Internal to core/style.
struct PictureChannels {
    enum class Colour { grey, rgb, cmyk };
    Colour colour = Colour::rgb;
    int count = 3;                     ///< of a pixel's samples
    std::array<int, 4> at{0, 1, 2, 3}; ///< of the colour; of grey, the first
    int alpha = -1;                    ///< none
    bool premultiplied = false;
    bool linear = false; ///< only where there is no profile
    int steps = 0;       ///< of a sample between 0 and 1: 255, 65535; 0: not whole ones
};

/// Brings samples as a file has them to sRGB, by the ICC profile that it carries. A profile that is damaged, or made
/// for other channels, is as good as none; one that says sRGB changes nothing at all. CMYK without a profile: inks that
/// take away what they cover. Internal to core/style.
class PictureColour {
  public:
    PictureColour(const PictureChannels& channels, std::span<const std::uint8_t> profile);
    ~PictureColour();
    PictureColour(PictureColour&&) noexcept;
    PictureColour& operator=(PictureColour&&) noexcept;

    [[nodiscard]] const PictureChannels& channels() const { return channels_; }
    /// `samples`: `out.size()` times `channels().count`, 0..1 as a rule; NaN counts as 0. Any thread.
    void toRgba(std::span<const float> samples, std::span<Rgba> out) const;

  private:
    class Transform;
    PictureChannels channels_;
    std::unique_ptr<Transform> transform_; ///< null: nothing to change
};

} // namespace limner
