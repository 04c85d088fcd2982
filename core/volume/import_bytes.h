#pragma once

#include "core/volume/import_parts.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

/// Bytes of files, plain and compressed. Internal to core/volume.
namespace limner::importing {

/// A stream of bytes that is read once, front to back.
class ByteStream {
  public:
    ByteStream() = default;
    ByteStream(const ByteStream&) = delete;
    ByteStream& operator=(const ByteStream&) = delete;
    virtual ~ByteStream() = default;

    /// Fills `out` as far as the stream reaches; returns the number of bytes.
    virtual std::size_t read(std::span<std::byte> out) = 0;
    /// Most bytes that may still come, judged by the length of the file alone.
    [[nodiscard]] virtual std::uint64_t atMost() const = 0;
};

enum class Compression { none, gzip, bzip2 };

/// Opens a regular file at `offset`; gzip also reads zlib streams. Refuses what cannot be opened.
std::unique_ptr<ByteStream> openStream(const Context& context, const std::filesystem::path& file,
                                       Compression compression, std::uint64_t offset = 0);

/// Whether the file starts as gzip does.
bool startsAsGzip(const std::filesystem::path& file);

/// The first bytes of a file, inflated where it is gzip; shorter where the file is.
std::string headOf(const std::filesystem::path& file, std::size_t length);

/// Fills `out` or refuses, in pieces, listening to cancellation.
void readAll(const Context& context, ByteStream& stream, std::span<std::byte> out);
void skipBytes(const Context& context, ByteStream& stream, std::uint64_t count);

/// Refuses where a stream cannot hold `bytes` (before anything of that size is allocated).
void expectBytes(const Context& context, const ByteStream& stream, std::uint64_t bytes);

/// Length of a regular file; refuses what is none.
std::uint64_t fileLength(const Context& context, const std::filesystem::path& file);

/// A whole small file as text; refuses more than `limit` bytes.
std::string readText(const Context& context, const std::filesystem::path& file, std::uint64_t limit);

/// A data file named in a header, relative to the header's folder. Refuses absolute paths and paths that climb out.
std::filesystem::path dataFile(const Context& context, std::string_view name);

/// The files that a header's "slice%03d.raw 1 27 1" names (printf pattern, first, last, step).
std::vector<std::filesystem::path> numberedFiles(const Context& context, std::string_view pattern);

void swapBytes(std::span<std::byte> bytes, std::size_t width);

/// Reads `count` numbers written as text.
void parseAscii(const Context& context, std::string_view text, ScalarType type, std::span<std::byte> out);

/// How a header's numbers lie in one or more files.
struct DataLayout {
    enum class Text { binary, ascii, hex };

    std::vector<std::filesystem::path> files; ///< each holds an equal share, in order
    Compression compression = Compression::none;
    Text text = Text::binary;
    std::uint64_t offset = 0;   ///< bytes of the file before the data
    std::uint64_t lineSkip = 0; ///< lines after `offset`
    std::int64_t byteSkip = 0;  ///< bytes after those, uncompressed; -1: the data are the last bytes of the file
    bool swapped = false;
    bool moreFollows = false; ///< other text may come after the numbers
};

/// The first `count` numbers of a layout that holds `total`; checks the files' lengths before it allocates.
ByteBuffer readNumbers(const Context& context, const DataLayout& layout, ScalarType type, std::uint64_t count,
                       std::uint64_t total);

/// SHA-256 in lower-case hex.
std::string sha256(std::span<const std::byte> bytes);

/// A number out of a header, turned where the file's byte order is not ours.
template <typename T>
T word(std::span<const std::byte> bytes, std::size_t offset, bool swapped) {
    std::array<std::byte, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes.data() + offset, sizeof(T));
    if (swapped) {
        swapBytes(raw, sizeof(T));
    }
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
}

} // namespace limner::importing
