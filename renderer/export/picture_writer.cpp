#include "renderer/export/picture_writer.h"

#include "core/base/error.h"
#include "renderer/export/srgb_profile.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <optional>
#include <vector>

#include <sys/types.h>

namespace limner {

namespace {

OIIO::TypeDesc typeOf(SampleType type) {
    switch (type) {
    case SampleType::uint8: return OIIO::TypeDesc::UINT8;
    case SampleType::uint16: return OIIO::TypeDesc::UINT16;
    case SampleType::half: return OIIO::TypeDesc::HALF;
    case SampleType::float32: return OIIO::TypeDesc::FLOAT;
    }
    return OIIO::TypeDesc::UINT8;
}

void setCompression(const PictureHeader& header, OIIO::ImageSpec& spec) {
    switch (header.format) {
    case PictureFormat::png:
        // Level 6 takes seven times as long for 4 % less (2126 x 2126 px of smooth shading).
        spec.attribute("png:compressionLevel", 4);
        break;
    case PictureFormat::tiff:
        spec.attribute("compression", "zip");
        spec.attribute("tiff:zipquality", 4); // level 6 takes six times as long for 4 % less
        // 2: horizontal differences of integers, 3: of floats' bytes
        spec.attribute("tiff:predictor", header.layout.type == SampleType::float32 ? 3 : 2);
        spec.attribute("tiff:RowsPerStrip", std::min(header.bandRows, 32)); // 32: the library packs strips in parallel
        break;
    case PictureFormat::exr: spec.attribute("compression", "zip"); break;
    case PictureFormat::jpeg:
        spec.attribute("compression", "jpeg:95");    // for print: no block to be seen at reading distance
        spec.attribute("jpeg:subsampling", "4:4:4"); // coloured lines stay sharp
        break;
    case PictureFormat::webp: spec.attribute("compression", "webp:95"); break;
    }
}

OIIO::ImageSpec specOf(const PictureHeader& header) {
    OIIO::ImageSpec spec(header.size.x, header.size.y, header.layout.channels(), typeOf(header.layout.type));
    if (header.layout.alpha == AlphaForm::unassociated) {
        spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    spec.attribute("XResolution", static_cast<float>(header.dpi));
    spec.attribute("YResolution", static_cast<float>(header.dpi));
    spec.attribute("ResolutionUnit", "in");
    spec.attribute("Software", "Limner");
    const auto profile = srgbProfile();
    if (!header.layout.linear && !profile.empty()) {
        spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                       profile.data());
    }
    setCompression(header, spec);
    return spec;
}

} // namespace

/// The caller's stream, which the library must not close.
class BorrowedStream : public OIIO::Filesystem::IOFile {
  public:
    explicit BorrowedStream(std::FILE* stream) : IOFile(stream, Write) {}
    void close() override { flush(); }
};

/// A stream that hands everything on to another and never reports a failure: libjpeg ends the process where a write
/// fails. The other stream remembers the failure, and whoever owns it looks there.
class ForgivingStream {
  public:
    explicit ForgivingStream(std::FILE* target) {
        cookie_io_functions_t functions{};
        functions.write = [](void* cookie, const char* bytes, std::size_t count) {
            static_cast<void>(std::fwrite(bytes, 1, count, static_cast<std::FILE*>(cookie)));
            return static_cast<ssize_t>(count);
        };
        stream_ = ::fopencookie(target, "wb", functions);
        if (stream_ == nullptr) {
            throw std::bad_alloc();
        }
    }
    ~ForgivingStream() { std::fclose(stream_); }
    ForgivingStream(const ForgivingStream&) = delete;
    ForgivingStream& operator=(const ForgivingStream&) = delete;
    [[nodiscard]] std::FILE* stream() const { return stream_; }

  private:
    std::FILE* stream_ = nullptr;
};

struct PictureWriter::Encoder {
    PictureHeader header;
    std::optional<ForgivingStream> forgiving; ///< JPEG only
    BorrowedStream file;
    std::unique_ptr<OIIO::ImageOutput> output;
    int nextRow = 0;

    Encoder(const PictureHeader& h, std::FILE* stream) : header(h), file(streamFor(stream)) {}

    std::FILE* streamFor(std::FILE* stream) {
        return header.format == PictureFormat::jpeg ? forgiving.emplace(stream).stream() : stream;
    }

    /// At the first rows: an output that was never opened has nothing to complain of when it is given up.
    void open() {
        if (output != nullptr) {
            return;
        }
        output = OIIO::ImageOutput::create(traitsOf(header.format).library);
        // The name is only for the library's messages: the bytes go to the stream.
        if (output == nullptr || !output->set_ioproxy(&file) || !output->open(header.name, specOf(header))) {
            fail();
        }
    }

    /// Lets go of a picture that is not finished. libpng complains on standard error of a file without a single coded
    /// block, so it is made to write one: noise, which no deflate keeps back beyond its buffers of 64 KiB.
    void abandon() {
        if (output == nullptr || header.format != PictureFormat::png) {
            return;
        }
        constexpr std::size_t kNoise = std::size_t{256} << 10;
        const std::size_t rowBytes = static_cast<std::size_t>(header.size.x) * header.layout.bytesPerPixel();
        std::vector<std::byte> row(rowBytes);
        std::uint32_t state = 1;
        for (std::byte& b : row) {
            state = state * 1664525U + 1013904223U; // Numerical Recipes' generator: any noise will do
            b = static_cast<std::byte>(state >> 24);
        }
        for (std::size_t written = 0; written < kNoise && nextRow < header.size.y; written += rowBytes, ++nextRow) {
            if (!output->write_scanline(nextRow, 0, typeOf(header.layout.type), row.data())) {
                return;
            }
        }
    }

    [[noreturn]] void fail() const {
        const std::string reason = output != nullptr ? output->geterror() : OIIO::geterror();
        throw Error(ErrorKind::noResources,
                    {"cannot write the picture", header.name,
                     reason.empty() ? std::string("the writer of ") + traitsOf(header.format).name + " gives no reason"
                                    : reason,
                     ""});
    }
};

PictureWriter::PictureWriter(const PictureHeader& header, std::FILE* stream)
    : encoder_(std::make_unique<Encoder>(header, stream)) {}

PictureWriter::~PictureWriter() { encoder_->abandon(); }

void PictureWriter::writeRows(std::span<const std::byte> bytes, int rows) {
    Encoder& e = *encoder_;
    e.open();
    if (!e.output->write_scanlines(e.nextRow, e.nextRow + rows, 0, typeOf(e.header.layout.type), bytes.data())) {
        e.fail();
    }
    e.nextRow += rows;
}

void PictureWriter::finish() {
    Encoder& e = *encoder_;
    e.open();
    if (!e.output->close()) {
        e.fail();
    }
    e.output.reset();
    e.file.flush();
}

} // namespace limner
