#include "renderer/export/picture_format.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>

namespace limner {

namespace {

// No format needs more than a million pixels an edge (which is also where libpng's readers stop by default): 85 m of
// paper at 300 dpi. The others' limits are those of their headers.
constexpr int kLongestEdge = 1'000'000;
constexpr int kLongestJpegEdge = 65'500;
constexpr int kLongestWebpEdge = 16'383;

constexpr std::array<FormatTraits, 5> kTraits{{
    {"PNG", "png", kLongestEdge, true, false, true, true},
    {"TIFF", "tiff", kLongestEdge, true, true, true, true},
    {"OpenEXR", "openexr", kLongestEdge, true, true, true, true},
    {"JPEG", "jpeg", kLongestJpegEdge, false, false, false, true},
    {"WebP", "webp", kLongestWebpEdge, false, false, true, false},
}};

} // namespace

std::size_t PixelLayout::bytesPerPixel() const {
    constexpr std::array<std::size_t, 4> kBytes{1, 2, 2, 4};
    return static_cast<std::size_t>(channels()) * kBytes[static_cast<std::size_t>(type)];
}

const FormatTraits& traitsOf(PictureFormat format) { return kTraits[static_cast<std::size_t>(format)]; }

PictureFormat pictureFormatOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".png") {
        return PictureFormat::png;
    }
    if (ending == ".tif" || ending == ".tiff") {
        return PictureFormat::tiff;
    }
    if (ending == ".exr") {
        return PictureFormat::exr;
    }
    if (ending == ".jpg" || ending == ".jpeg") {
        return PictureFormat::jpeg;
    }
    if (ending == ".webp") {
        return PictureFormat::webp;
    }
    const std::string why = ending.empty() ? "the name has no ending to tell the format from"
                                           : "this version writes no \"" + ending.substr(1) + "\" files";
    throw Error(ErrorKind::usage, {"cannot choose a picture format", path.string(), why,
                                   "use png, tif, exr, jpg or webp, or svg or pdf for a drawing"});
}

PixelLayout pixelLayout(PictureFormat format, const PictureOptions& options) {
    const FormatTraits& traits = traitsOf(format);
    PixelLayout layout;
    layout.background = options.background;
    layout.linear = format == PictureFormat::exr;
    const std::string name = traits.name;
    switch (options.depth) {
    case SampleDepth::automatic:
        layout.type = format == PictureFormat::exr ? SampleType::float32 : SampleType::uint8;
        break;
    case SampleDepth::eight:
        if (format == PictureFormat::exr) {
            throw Error(ErrorKind::usage, {"cannot write 8 bits a channel", name, "it holds half and float numbers",
                                           "use depth 16 (half) or float, or another format"});
        }
        layout.type = SampleType::uint8;
        break;
    case SampleDepth::sixteen:
        if (!traits.sixteen) {
            throw Error(ErrorKind::usage,
                        {"cannot write 16 bits a channel", name, "it holds 8 bits", "use png, tif or exr for 16 bits"});
        }
        layout.type = format == PictureFormat::exr ? SampleType::half : SampleType::uint16;
        break;
    case SampleDepth::floating:
        if (!traits.floating) {
            throw Error(ErrorKind::usage,
                        {"cannot write float numbers", name,
                         traits.sixteen ? "it holds 8 or 16 bits" : "it holds 8 bits", "use tif or exr for float"});
        }
        layout.type = SampleType::float32;
        break;
    }
    if (options.transparent && traits.alpha) {
        // The library's WebP writer takes premultiplied numbers only, and divides them itself.
        const bool premultiplied = format == PictureFormat::exr || format == PictureFormat::webp;
        layout.alpha = premultiplied ? AlphaForm::premultiplied : AlphaForm::unassociated;
    }
    return layout;
}

} // namespace limner
