#include "core/style/png_writing.h"

#include "core/base/error.h"
#include "core/base/pending_file.h"
#include "core/style/texture_tile.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cassert>
#include <cstddef>
#include <vector>

namespace limner {
namespace {

namespace fs = std::filesystem;

/// Compresses in memory; fails only where that runs out.
std::string encoded(OIIO::ImageSpec spec, OIIO::TypeDesc given, const void* pixels) {
    spec.attribute("oiio:ColorSpace", "sRGB");
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput sink(bytes);
    const auto output = OIIO::ImageOutput::create("png");
    const bool written = output != nullptr && output->set_ioproxy(&sink) && output->open("picture.png", spec) &&
                         output->write_image(given, pixels) && output->close();
    if (!written) {
        throw Error(ErrorKind::noResources,
                    {"cannot write the picture", "", output == nullptr ? OIIO::geterror() : output->geterror(),
                     "close other programs or make it smaller"});
    }
    return {bytes.begin(), bytes.end()};
}

} // namespace

std::string pngBytes(glm::ivec2 size, std::span<const Rgba> pixels) {
    assert(pixels.size() == static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    OIIO::ImageSpec spec(size.x, size.y, 4, OIIO::TypeDesc::UINT16);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return encoded(spec, OIIO::TypeDesc::FLOAT, pixels.data());
}

std::string pngBytes(const LitSphere& sphere) { return pngBytes({sphere.size(), sphere.size()}, sphere.pixels()); }

std::string pngBytes(const TextureTile& tile) {
    std::vector<Rgba> pixels = tile.pixels();
    for (Rgba& texel : pixels) {
        texel = {texel.r / 2, texel.g / 2, texel.b / 2, 1};
    }
    return pngBytes({tile.size(), tile.size()}, pixels);
}

std::string pngBytes(glm::ivec2 size, std::span<const std::uint8_t> values) {
    assert(values.size() == static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    return encoded(OIIO::ImageSpec(size.x, size.y, 1, OIIO::TypeDesc::UINT8), OIIO::TypeDesc::UINT8, values.data());
}

void writeWholeFile(const fs::path& file, const std::string& bytes) {
    PendingFile pending(file);
    std::fwrite(bytes.data(), 1, bytes.size(), pending.stream());
    pending.commit();
}

} // namespace limner
