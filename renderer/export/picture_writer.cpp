#include "renderer/export/picture_writer.h"

#include "core/base/error.h"
#include "renderer/export/srgb_profile.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>

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

struct PictureWriter::Encoder {
    PictureHeader header;
    BorrowedStream file;
    std::unique_ptr<OIIO::ImageOutput> output;
    int nextRow = 0;

    Encoder(const PictureHeader& h, std::FILE* stream) : header(h), file(stream) {}

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
    : encoder_(std::make_unique<Encoder>(header, stream)) {
    Encoder& e = *encoder_;
    e.output = OIIO::ImageOutput::create(traitsOf(header.format).library);
    // The name is only for the library's messages: the bytes go to the stream.
    if (e.output == nullptr || !e.output->set_ioproxy(&e.file) || !e.output->open(header.name, specOf(header))) {
        e.fail();
    }
}

PictureWriter::~PictureWriter() = default;

void PictureWriter::writeRows(std::span<const std::byte> bytes, int rows) {
    Encoder& e = *encoder_;
    if (!e.output->write_scanlines(e.nextRow, e.nextRow + rows, 0, typeOf(e.header.layout.type), bytes.data())) {
        e.fail();
    }
    e.nextRow += rows;
}

void PictureWriter::finish() {
    Encoder& e = *encoder_;
    if (!e.output->close()) {
        e.fail();
    }
    e.output.reset();
}

} // namespace limner
