#include "renderer/export/bands.h"

#include "core/base/error.h"
#include "renderer/export/backdrop.h"

#include <algorithm>
#include <string>

namespace limner {

namespace {

// Enough for thousands of ray packets a thread, a tenth of a second or so of work.
constexpr std::size_t kBandPixels = std::size_t{1} << 20;
constexpr int kSmallestBand = 64; // rows, where the budget allows: keeps strips and tiles whole
constexpr int kStripRows = 32;
constexpr std::size_t kPictureBytes = 16; // a rendered pixel: four floats
// Bands in their file form: one being filled, one being written, one inside the format's library.
constexpr std::size_t kEncodedCopies = 3;
// Libraries, threads' stacks and compression buffers.
constexpr std::size_t kFixedBytes = std::size_t{16} << 20;
// WebP's encoder: the picture, its YUV planes and the coded bytes.
constexpr std::size_t kWebpBytesPerPixel = 4 + 4 + 4;

std::string mebibytes(std::size_t bytes) { return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB"; }

[[noreturn]] void failOverBudget(std::size_t needed, const PictureOptions& options, const char* why,
                                 const char* remedy) {
    throw Error(ErrorKind::noResources,
                {"the picture does not fit the memory budget", "",
                 "it needs " + mebibytes(needed) + " of " + mebibytes(options.memoryBudget) + why, remedy});
}

} // namespace

BandLayout chooseBands(glm::ivec2 size, PictureFormat format, const PixelLayout& layout,
                       const PictureOptions& options) {
    const auto width = static_cast<std::size_t>(size.x);
    std::size_t fixed = kFixedBytes + backdropBytes(options, layout, size);
    if (!traitsOf(format).streams) {
        fixed += width * static_cast<std::size_t>(size.y) * kWebpBytesPerPixel;
        if (fixed > options.memoryBudget) {
            failOverBudget(fixed, options, ": WebP is only written whole", "use png or tif, or allow more memory");
        }
    }
    const int wished = options.tile > 0
                           ? options.tile
                           : std::max(kSmallestBand, static_cast<int>(kBandPixels / width) / kStripRows * kStripRows);
    BandLayout bands;
    bands.tileWidth = options.tile > 0 ? std::min(options.tile, size.x) : size.x;
    const std::size_t left = options.memoryBudget > fixed ? options.memoryBudget - fixed : 0;
    const std::size_t rowBytes =
        width * layout.bytesPerPixel() * kEncodedCopies + static_cast<std::size_t>(bands.tileWidth) * kPictureBytes;
    const std::size_t affordable = left / rowBytes;
    if (affordable == 0) {
        failOverBudget(fixed + rowBytes, options, " for a single row", "make it smaller or allow more memory");
    }
    bands.rows =
        static_cast<int>(std::min<std::size_t>(affordable, static_cast<std::size_t>(std::min(wished, size.y))));
    if (bands.rows > kStripRows && bands.rows < size.y) {
        bands.rows = bands.rows / kStripRows * kStripRows;
    }
    bands.bytes = fixed + rowBytes * static_cast<std::size_t>(bands.rows);
    return bands;
}

} // namespace limner
