#pragma once

#include "core/style/extraction/picture.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace limner {

class Task;

/// Places on an artwork are in its own pixels, continuous: pixel (i, j) covers [i, i+1] x [j, j+1], y goes down.
struct ArtRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend bool operator==(const ArtRect&, const ArtRect&) = default;
};

/// A part of an artwork, reduced by a box filter.
struct ArtCut {
    ArtPicture picture;
    glm::dvec2 origin{0, 0}; ///< artwork place of the cut's top left corner
    double scale = 1;        ///< artwork pixels per pixel of the cut, at least 1

    [[nodiscard]] glm::dvec2 toArtwork(glm::dvec2 inCut) const { return origin + inCut * scale; }
    [[nodiscard]] glm::dvec2 toCut(glm::dvec2 onArtwork) const { return (onArtwork - origin) / scale; }
};

/// A scanned artwork of up to 30,000 x 30,000 pixels and more: any format OpenImageIO reads, 8 or 16 bits or float,
/// grey, RGB or CMYK, brought to sRGB by the profile that it carries. Read once, band by band; kept: a reduced copy,
/// and all of it (16 bits a channel) where it has at most `kKeptPixels`; of a larger one, cuts are read from the file
/// again, but for those that are much coarser than the reduced copy, which come from it. Immutable; all functions may
/// be called from any thread.
class Artwork {
  public:
    static constexpr int kReducedSide = 2048;               ///< longer side of the reduced copy, at most
    static constexpr std::int64_t kKeptPixels = 32'000'000; ///< 256 MB

    /// Throws Error(badInput), Error(noResources), Error(cancelled).
    Artwork(std::filesystem::path file, Task& task);
    /// Of pixels in memory: tests, and a picture pasted from the clipboard. `name` stands in for the file.
    Artwork(ArtPicture picture, std::string name);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] const ArtCut& reduced() const { return reduced_; }
    /// The part under `rect` (clipped to the artwork; empty where nothing is left), its longer side at most `longest`
    /// pixels. Throws Error(badInput) where the file has been damaged since, Error(cancelled).
    [[nodiscard]] ArtCut cut(ArtRect rect, int longest, Task& task) const;

  private:
    struct Kept; ///< 16 bits a channel
    std::filesystem::path file_;
    int width_ = 0;
    int height_ = 0;
    ArtCut reduced_;
    std::shared_ptr<const Kept> kept_;
};

} // namespace limner
