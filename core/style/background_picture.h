#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

namespace limner {

/// The part of a picture that covers an output, reduced to what the output can show. Immutable.
struct CoveringCopy {
    glm::ivec2 size{0};
    std::vector<std::uint16_t> rgba; ///< premultiplied, sRGB-encoded, 65535 = 1; top row first
    glm::dvec2 first{0};             ///< where the output's left upper corner lies, in texels of the copy
    double texelsPerPixel = 1;       ///< of the output
};

/// A picture behind a figure: an artwork, a sheet of paper (paper 000, figure 1). It stays in its file, however large;
/// copies reduced to an output's size are made when they are asked for, by averaging areas of the premultiplied encoded
/// values, and the newest few are kept. Thread-safe.
class BackgroundPicture {
  public:
    /// Longest edge of a copy: beyond it, what lies behind a figure is enlarged instead.
    static constexpr int kLongestCopy = 8192;

    /// Reads the header only. `owner` is kept as long as the picture: of a file that goes with it. Throws
    /// Error(badInput).
    explicit BackgroundPicture(std::filesystem::path file, std::shared_ptr<const void> owner = nullptr);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] glm::ivec2 size() const { return size_; }

    /// Scaled to cover an output of that size, centred. Never larger than the output, `kLongestCopy` an edge or
    /// `maxBytes` (one texel at least); a picture that is smaller than the output comes at its own resolution. The same
    /// for the same arguments whatever was asked before. Throws Error(badInput) where the file is damaged or gone.
    [[nodiscard]] std::shared_ptr<const CoveringCopy> covering(glm::ivec2 output, std::size_t maxBytes) const;
    /// Bytes of what `covering` gives.
    [[nodiscard]] std::size_t coveringBytes(glm::ivec2 output, std::size_t maxBytes) const;

  private:
    struct Kept {
        glm::ivec2 output{0};
        std::size_t maxBytes = 0;
        std::shared_ptr<const CoveringCopy> copy;
    };

    std::filesystem::path file_;
    std::shared_ptr<const void> owner_;
    glm::ivec2 size_{0};
    mutable std::mutex mutex_;
    mutable std::vector<Kept> kept_; ///< newest last
};

} // namespace limner
