#pragma once

#include "renderer/export/picture_file.h"

#include <filesystem>
#include <memory>
#include <string>

namespace limner {

enum class PictureFormat { png, tiff, exr, jpeg, webp };

/// How one pixel lies in a file.
enum class SampleType { uint8, uint16, half, float32 };
class Backdrop;

enum class AlphaForm {
    none,          ///< laid over the background, three channels
    opaque,        ///< laid over the background, alpha 1
    unassociated,  ///< colour not multiplied by alpha
    premultiplied, ///< colour multiplied by alpha
};
struct PixelLayout {
    SampleType type = SampleType::uint8;
    AlphaForm alpha = AlphaForm::none;
    bool linear = false; ///< linear light instead of sRGB-encoded
    glm::dvec4 background{1, 1, 1, 1};
    std::shared_ptr<const Backdrop> backdrop = nullptr; ///< over the background colour

    [[nodiscard]] bool keepsAlpha() const { return alpha != AlphaForm::none && alpha != AlphaForm::opaque; }
    [[nodiscard]] int channels() const { return alpha == AlphaForm::none ? 3 : 4; }
    [[nodiscard]] std::size_t bytesPerPixel() const;
};

/// What a format can do.
struct FormatTraits {
    const char* name;    ///< for people
    const char* library; ///< OpenImageIO's name of it
    int longestEdge;     ///< pixels
    bool sixteen;        ///< more than 8 bits
    bool floating;
    bool alpha;
    bool streams; ///< written row by row; otherwise the library keeps the whole picture
};

/// By the path's ending, in either case. Throws Error(usage) naming the endings there are.
PictureFormat pictureFormatOf(const std::filesystem::path& path);
const FormatTraits& traitsOf(PictureFormat format);

/// What the options mean in the format. Throws Error(usage) for a depth that it cannot hold.
PixelLayout pixelLayout(PictureFormat format, const PictureOptions& options);

} // namespace limner
