#pragma once

#include "core/style/lit_sphere.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace limner {

/// Reads a picture file band by band, so that memory grows with what the file really holds. Any format OpenImageIO
/// reads; grey, RGB or CMYK, with or without alpha; brought to sRGB by the ICC profile that the file carries (of CMYK
/// JPEG and Photoshop files by none: their readers give RGB); linear pictures come sRGB-encoded; NaN counts as 0. One
/// thread.
class PictureRows {
  public:
    /// For messages: what went wrong ("cannot read the style"), and what to use instead where it is no picture at all.
    struct Words {
        std::string what;
        std::string instead;
    };

    /// Reads the header only. Throws Error(badInput).
    PictureRows(std::filesystem::path file, Words words);
    ~PictureRows();
    PictureRows(const PictureRows&) = delete;
    PictureRows& operator=(const PictureRows&) = delete;

    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;
    /// Rows to read at a time: a band starts at a multiple of it. About 64, or the height of the file's tiles or
    /// strips.
    [[nodiscard]] int bandRows() const;
    /// The band that starts at row `y`: `bandRows` rows, or what is left. Valid until the next call. Throws
    /// Error(badInput) where the file is damaged.
    std::span<const Rgba> read(int y) { return read(y, 0, width()); }
    /// Of that band the columns from `left` on and before `right`, row by row; within the picture, one at least.
    std::span<const Rgba> read(int y, int left, int right);
    /// Whether the file is long enough to hold what its header promises: beyond a gigabyte, no more than any packing
    /// achieves on a picture of one colour. Some formats' libraries unpack the whole picture at once.
    void failWhereTooShort() const;
    [[noreturn]] void fail(const std::string& why, const std::string& remedy) const;

  private:
    void checkHeader() const;
    void checkMemory() const;
    struct Reader;
    std::unique_ptr<Reader> reader_;
};

} // namespace limner
