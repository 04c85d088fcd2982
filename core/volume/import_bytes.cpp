#include "core/volume/import_bytes.h"

#include "core/base/error.h"

#include <bzlib.h>
#include <openssl/evp.h>
#include <tbb/parallel_for.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <new>

namespace limner::importing {

static_assert(std::endian::native == std::endian::little, "hashes and headers are read as little-endian");

namespace {

constexpr std::size_t kChunk = 1 << 18;          // compressed bytes in hand at a time
constexpr std::size_t kCancelBytes = 4 << 20;    // between two looks at the task: a few ms of inflating
constexpr std::uint64_t kDeflateRatio = 1032;    // deflate cannot do better (zlib's technical notes)
constexpr std::uint64_t kBzip2Ratio = 900 * 400; // 900 kB of one byte make about 40 bytes; ten times that to be safe

class FileStream final : public ByteStream {
  public:
    FileStream(const Context& context, const std::filesystem::path& path, std::uint64_t offset)
        : left_(fileLength(context, path)), file_(path, std::ios::binary) {
        if (!file_) {
            context.refuse("cannot open " + path.filename().string());
        }
        if (offset > left_) {
            context.refuse("the data should start at byte " + std::to_string(offset) + ", the file has " +
                           std::to_string(left_));
        }
        left_ -= offset;
        file_.seekg(static_cast<std::streamoff>(offset));
    }
    std::size_t read(std::span<std::byte> out) override {
        file_.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(out.size()));
        const auto got = static_cast<std::size_t>(file_.gcount());
        left_ -= std::min<std::uint64_t>(left_, got);
        return got;
    }
    [[nodiscard]] std::uint64_t atMost() const override { return left_; }

  private:
    std::uint64_t left_;
    std::ifstream file_;
};

/// gzip (also several members in a row) or zlib.
class InflateStream final : public ByteStream {
  public:
    InflateStream(const Context& context, const std::filesystem::path& path, std::uint64_t offset)
        : source_(context, path, offset), chunk_(kChunk) {
        constexpr int kAnyHeader = 15 + 32; // largest window; gzip and zlib headers are told apart
        if (inflateInit2(&zlib_, kAnyHeader) != Z_OK) {
            throw std::bad_alloc();
        }
    }
    ~InflateStream() override { inflateEnd(&zlib_); }

    std::size_t read(std::span<std::byte> out) override {
        std::size_t got = 0;
        while (got < out.size() && !ended_) {
            if (zlib_.avail_in == 0) {
                zlib_.next_in = reinterpret_cast<Bytef*>(chunk_.data());
                zlib_.avail_in = static_cast<uInt>(source_.read(chunk_));
            }
            if (zlib_.avail_in == 0) {
                break;
            }
            const std::size_t want = std::min<std::size_t>(out.size() - got, std::numeric_limits<uInt>::max());
            zlib_.next_out = reinterpret_cast<Bytef*>(out.data() + got);
            zlib_.avail_out = static_cast<uInt>(want);
            const int state = inflate(&zlib_, Z_NO_FLUSH);
            got += want - zlib_.avail_out;
            if (state == Z_STREAM_END) {
                // Another member may follow; anything else after the end is padding.
                ended_ = zlib_.avail_in == 0 || *zlib_.next_in != 0x1f || inflateReset(&zlib_) != Z_OK;
            } else if (state != Z_OK) {
                ended_ = true;
            }
        }
        return got;
    }
    [[nodiscard]] std::uint64_t atMost() const override {
        return (source_.atMost() + zlib_.avail_in + kDeflateRatio) * kDeflateRatio;
    }

  private:
    FileStream source_;
    std::vector<std::byte> chunk_;
    z_stream zlib_{};
    bool ended_ = false;
};

class BunzipStream final : public ByteStream {
  public:
    BunzipStream(const Context& context, const std::filesystem::path& path, std::uint64_t offset)
        : source_(context, path, offset), chunk_(kChunk) {
        if (BZ2_bzDecompressInit(&bzip2_, 0, 0) != BZ_OK) {
            throw std::bad_alloc();
        }
    }
    ~BunzipStream() override { BZ2_bzDecompressEnd(&bzip2_); }

    std::size_t read(std::span<std::byte> out) override {
        std::size_t got = 0;
        while (got < out.size() && !ended_) {
            if (bzip2_.avail_in == 0) {
                bzip2_.next_in = reinterpret_cast<char*>(chunk_.data());
                bzip2_.avail_in = static_cast<unsigned>(source_.read(chunk_));
            }
            const bool starved = bzip2_.avail_in == 0;
            const auto want = static_cast<unsigned>(std::min<std::size_t>(out.size() - got, 1U << 30));
            bzip2_.next_out = reinterpret_cast<char*>(out.data() + got);
            bzip2_.avail_out = want;
            const int state = BZ2_bzDecompress(&bzip2_);
            const std::size_t made = want - bzip2_.avail_out;
            got += made;
            ended_ = state != BZ_OK || (starved && made == 0);
        }
        return got;
    }
    [[nodiscard]] std::uint64_t atMost() const override {
        return (source_.atMost() + bzip2_.avail_in + 1) * kBzip2Ratio;
    }

  private:
    FileStream source_;
    std::vector<std::byte> chunk_;
    bz_stream bzip2_{};
    bool ended_ = false;
};

} // namespace

ByteBuffer::ByteBuffer(std::size_t size) : size_(size) {
    bytes_.reset(new (std::nothrow) std::byte[size]);
    if (bytes_ == nullptr) {
        throw Error(ErrorKind::noResources,
                    {"not enough memory for the volume", "", std::to_string(size >> 20) + " MiB could not be had",
                     "close other programs or load a part of it"});
    }
}

std::uint64_t fileLength(const Context& context, const std::filesystem::path& file) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) {
        context.refuse(std::filesystem::exists(file, failed) ? file.filename().string() + " is no ordinary file"
                                                             : "there is no file " + file.filename().string());
    }
    const auto length = std::filesystem::file_size(file, failed);
    if (failed) {
        context.refuse("cannot read " + file.filename().string());
    }
    return length;
}

std::unique_ptr<ByteStream> openStream(const Context& context, const std::filesystem::path& file,
                                       Compression compression, std::uint64_t offset) {
    switch (compression) {
    case Compression::gzip: return std::make_unique<InflateStream>(context, file, offset);
    case Compression::bzip2: return std::make_unique<BunzipStream>(context, file, offset);
    case Compression::none: break;
    }
    return std::make_unique<FileStream>(context, file, offset);
}

bool startsAsGzip(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return in.get() == 0x1f && in.get() == 0x8b;
}

std::string headOf(const std::filesystem::path& file, std::size_t length) {
    std::string head(length, '\0');
    if (startsAsGzip(file)) {
        const gzFile in = gzopen(file.c_str(), "rb");
        const int got = in != nullptr ? gzread(in, head.data(), static_cast<unsigned>(length)) : 0;
        gzclose(in);
        head.resize(static_cast<std::size_t>(std::max(got, 0)));
        return head;
    }
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(length));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

void readAll(const Context& context, ByteStream& stream, std::span<std::byte> out) {
    std::size_t done = 0;
    while (done < out.size()) {
        context.task.throwIfCancelled();
        const std::size_t want = std::min(kCancelBytes, out.size() - done);
        const std::size_t got = stream.read(out.subspan(done, want));
        done += got;
        if (got < want) {
            context.refuse("the data end after " + std::to_string(done) + " of " + std::to_string(out.size()) +
                               " bytes, or their compression is damaged",
                           "copy or export the file anew");
        }
        context.task.progress(static_cast<double>(done) / static_cast<double>(out.size()));
    }
}

void skipBytes(const Context& context, ByteStream& stream, std::uint64_t count) {
    std::array<std::byte, 4096> sink;
    while (count > 0) {
        context.task.throwIfCancelled();
        const auto want = static_cast<std::size_t>(std::min<std::uint64_t>(count, sink.size()));
        if (stream.read(std::span(sink).first(want)) < want) {
            context.refuse("the file ends before its data start", "copy or export the file anew");
        }
        count -= want;
    }
}

void expectBytes(const Context& context, const ByteStream& stream, std::uint64_t bytes) {
    if (bytes > stream.atMost()) {
        context.refuse("the header promises " + std::to_string(bytes) +
                           " bytes of voxels, the file cannot hold more than " + std::to_string(stream.atMost()),
                       "copy or export the file anew");
    }
}

std::string readText(const Context& context, const std::filesystem::path& file, std::uint64_t limit) {
    const std::uint64_t length = fileLength(context, file);
    if (length > limit) {
        context.refuse(file.filename().string() + " is too long to be a header");
    }
    std::string text(length, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(text.data(), static_cast<std::streamsize>(length));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    return text;
}

std::filesystem::path dataFile(const Context& context, std::string_view name) {
    std::string plain(name);
    std::replace(plain.begin(), plain.end(), '\\', '/');
    const auto relative = std::filesystem::path(plain).lexically_normal();
    const bool drive = plain.size() > 1 && plain[1] == ':';
    if (plain.empty() || plain.find('\0') != std::string::npos || relative.is_absolute() || drive ||
        (!relative.empty() && *relative.begin() == "..")) {
        context.refuse("its data file '" + plain.substr(0, 80) + "' lies outside the header's own folder",
                       "put header and data into one folder and name the data by its file name");
    }
    return context.path.parent_path() / relative;
}

void swapBytes(std::span<std::byte> bytes, std::size_t width) {
    for (std::size_t i = 0; i + width <= bytes.size(); i += width) {
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                     bytes.begin() + static_cast<std::ptrdiff_t>(i + width));
    }
}

namespace {

/// The next number of a text as T; moves `text` past it.
template <typename T>
bool nextNumber(std::string_view& text, T& value) {
    const auto isGap = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ','; };
    while (!text.empty() && isGap(text.front())) {
        text.remove_prefix(1);
    }
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
    }
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if constexpr (std::is_floating_point_v<T>) {
        if (parsed.ec == std::errc::result_out_of_range) {
            // Too small or too large for T: strtod's answer (0 or infinity) is what writers of such text meant.
            value = static_cast<T>(std::strtod(std::string(text.data(), parsed.ptr).c_str(), nullptr));
        } else if (parsed.ec != std::errc()) {
            return false;
        }
    } else if (parsed.ec != std::errc()) {
        return false;
    }
    text.remove_prefix(static_cast<std::size_t>(parsed.ptr - text.data()));
    return text.empty() || isGap(text.front());
}

} // namespace

void parseAscii(const Context& context, std::string_view text, ScalarType type, std::span<std::byte> out) {
    withScalar(type, [&](auto zero) {
        using T = decltype(zero);
        for (std::size_t i = 0; i < out.size(); i += sizeof(T)) {
            T value{};
            if (!nextNumber(text, value)) {
                context.refuse("number " + std::to_string(i / sizeof(T) + 1) + " of its text is missing or is no " +
                               nameOf(type));
            }
            std::memcpy(out.data() + i, &value, sizeof(T));
            if ((i & 0xfffff) == 0) {
                context.task.throwIfCancelled();
            }
        }
    });
}

std::string sha256(std::span<const std::byte> bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned length = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
        throw std::bad_alloc(); // the library fails for want of memory alone
    }
    constexpr const char* kHex = "0123456789abcdef";
    std::string text;
    for (unsigned i = 0; i < length; ++i) {
        text += kHex[digest[i] >> 4];
        text += kHex[digest[i] & 15];
    }
    return text;
}

} // namespace limner::importing
