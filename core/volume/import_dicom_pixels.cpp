#include "core/volume/import_bytes.h"
#include "core/volume/import_dicom.h"

#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

namespace limner::importing {

namespace {

constexpr std::uint32_t kPixelData = dicomTag(0x7fe0, 0x0010);

bool isNative(const DicomFile& file) {
    return file.transferSyntax == "1.2.840.10008.1.2" || file.transferSyntax == "1.2.840.10008.1.2.1" ||
           file.transferSyntax == "1.2.840.10008.1.2.2";
}

const DicomElement* pixelElement(const DicomFile& file, const DicomPixels& pixels) {
    const std::uint32_t element = pixels.floatBits == 32 ? 0x0008 : pixels.floatBits == 64 ? 0x0009 : 0x0010;
    return file.data.find(dicomTag(0x7fe0, element));
}

std::uint64_t frameBits(const DicomPixels& pixels) {
    return static_cast<std::uint64_t>(pixels.framePixels()) * static_cast<std::uint64_t>(pixels.samples) *
           static_cast<std::uint64_t>(pixels.bitsAllocated);
}

/// Bytes of the frame's code stream, its fragments joined.
std::vector<std::byte> codeStream(const Context& context, const DicomElement& element, const DicomPixels& pixels,
                                  int frame) {
    const auto count = element.fragments.size() - std::min<std::size_t>(1, element.fragments.size());
    const auto frames = static_cast<std::size_t>(pixels.frames);
    std::size_t first = 1;
    std::size_t last = count + 1;
    if (count == frames) {
        first = static_cast<std::size_t>(frame) + 1;
        last = first + 1;
    } else if (frames > 1) {
        // Fragments of a frame follow each other; the offset table says where frames start.
        const std::span<const std::byte> table =
            element.fragments.empty() ? std::span<const std::byte>() : element.fragments[0];
        if (table.size() < frames * 4) {
            context.refuse("its compressed frames cannot be told apart (no offset table)");
        }
        const std::uint32_t from = word<std::uint32_t>(table, static_cast<std::size_t>(frame) * 4, false);
        const std::uint32_t to = static_cast<std::size_t>(frame) + 1 < frames
                                     ? word<std::uint32_t>(table, static_cast<std::size_t>(frame) * 4 + 4, false)
                                     : 0xffffffffU;
        std::uint64_t offset = 0;
        first = last = count + 1;
        for (std::size_t i = 1; i <= count; ++i) {
            first = offset == from ? i : first;
            last = offset >= to && last == count + 1 ? i : last;
            offset += element.fragments[i].size() + 8;
        }
    }
    std::vector<std::byte> bytes;
    for (std::size_t i = first; i < last && i < element.fragments.size(); ++i) {
        bytes.insert(bytes.end(), element.fragments[i].begin(), element.fragments[i].end());
    }
    if (bytes.empty()) {
        context.refuse("frame " + std::to_string(frame + 1) + " of its compressed pixels is missing");
    }
    return bytes;
}

/// One byte plane of DICOM's run-length coding (PS3.5 annex G). Returns whether it fills the plane.
bool unpackRuns(std::span<const std::byte> runs, std::span<std::byte> plane) {
    std::size_t at = 0;
    std::size_t done = 0;
    while (done < plane.size() && at < runs.size()) {
        const int code = static_cast<signed char>(runs[at++]);
        if (code >= 0) {
            const std::size_t n = std::min({static_cast<std::size_t>(code) + 1, plane.size() - done, runs.size() - at});
            std::copy_n(runs.begin() + static_cast<std::ptrdiff_t>(at), n,
                        plane.begin() + static_cast<std::ptrdiff_t>(done));
            at += n;
            done += n;
        } else if (code != -128 && at < runs.size()) {
            const std::size_t n = std::min(static_cast<std::size_t>(1 - code), plane.size() - done);
            std::fill_n(plane.begin() + static_cast<std::ptrdiff_t>(done), n, runs[at++]);
            done += n;
        }
    }
    return done == plane.size();
}

/// Run-length coded frame to planar samples, least significant byte first.
void decodeRle(const Context& context, std::span<const std::byte> stream, const DicomPixels& pixels,
               std::span<std::byte> out) {
    const std::size_t bytes = static_cast<std::size_t>(pixels.bitsAllocated) / 8;
    const std::size_t segments = bytes * static_cast<std::size_t>(pixels.samples);
    constexpr std::size_t kHeader = 64;
    if (stream.size() < kHeader || word<std::uint32_t>(stream, 0, false) != segments || segments > 15) {
        context.refuse("its run-length coded pixels do not fit their description");
    }
    std::vector<std::byte> plane(pixels.framePixels());
    for (std::size_t s = 0; s < segments; ++s) {
        const std::size_t from = word<std::uint32_t>(stream, 4 + 4 * s, false);
        const std::size_t to = s + 1 < segments ? word<std::uint32_t>(stream, 8 + 4 * s, false) : stream.size();
        if (from < kHeader || to < from || to > stream.size() || !unpackRuns(stream.subspan(from, to - from), plane)) {
            context.refuse("its run-length coded pixels are damaged");
        }
        const std::size_t sample = s / bytes;
        const std::size_t byte = bytes - 1 - s % bytes;
        for (std::size_t i = 0; i < plane.size(); ++i) {
            out[(sample * plane.size() + i) * bytes + byte] = plane[i];
        }
    }
}

struct CodeStreamSize {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t components = 0;
    std::uint32_t bits = 0;
};

/// Size that a JPEG, JPEG-LS or JPEG 2000 code stream itself gives; the decoder is run only where it fits.
std::optional<CodeStreamSize> sizeOf(std::span<const std::byte> s) {
    const auto u8 = [&](std::size_t i) { return std::to_integer<std::uint32_t>(s[i]); };
    const auto u16 = [&](std::size_t i) { return u8(i) << 8 | u8(i + 1); };
    const auto u32 = [&](std::size_t i) { return u16(i) << 16 | u16(i + 2); };
    if (s.size() < 4 || u8(0) != 0xff) {
        return std::nullopt;
    }
    if (u8(1) == 0x4f) { // JPEG 2000: SIZ follows at once
        if (s.size() < 50 || u16(2) != 0xff51) {
            return std::nullopt;
        }
        // Reference grid minus image offset.
        return CodeStreamSize{u32(8) - u32(16), u32(12) - u32(20), u16(40), (u8(42) & 0x7f) + 1};
    }
    for (std::size_t at = 2; at + 10 <= s.size();) {
        if (u8(at) != 0xff) {
            return std::nullopt;
        }
        const std::uint32_t marker = u8(at + 1);
        if (marker == 0xff) {
            ++at;
            continue;
        }
        const bool startOfFrame =
            (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) || marker == 0xf7;
        if (startOfFrame) {
            return CodeStreamSize{u16(at + 7), u16(at + 5), u8(at + 9), u8(at + 4)};
        }
        if (marker == 0xda || marker == 0xd9) {
            return std::nullopt;
        }
        at += 2 + u16(at + 2);
    }
    return std::nullopt;
}

std::optional<gdcm::TransferSyntax::TSType> codecOf(const std::string& uid) {
    using TS = gdcm::TransferSyntax;
    static const std::map<std::string, TS::TSType> kCodecs = {
        {"1.2.840.10008.1.2.4.50", TS::JPEGBaselineProcess1},  {"1.2.840.10008.1.2.4.51", TS::JPEGExtendedProcess2_4},
        {"1.2.840.10008.1.2.4.57", TS::JPEGLosslessProcess14}, {"1.2.840.10008.1.2.4.70", TS::JPEGLosslessProcess14_1},
        {"1.2.840.10008.1.2.4.80", TS::JPEGLSLossless},        {"1.2.840.10008.1.2.4.81", TS::JPEGLSNearLossless},
        {"1.2.840.10008.1.2.4.90", TS::JPEG2000Lossless},      {"1.2.840.10008.1.2.4.91", TS::JPEG2000},
        {"1.2.840.10008.1.2.4.201", TS::JPEG2000Lossless}, // high-throughput JPEG 2000: OpenJPEG reads it
        {"1.2.840.10008.1.2.4.202", TS::JPEG2000Lossless},     {"1.2.840.10008.1.2.4.203", TS::JPEG2000}};
    const auto found = kCodecs.find(uid);
    return found == kCodecs.end() ? std::nullopt : std::optional(found->second);
}

/// Whether a JPEG-LS stream has its end: the decoder looks very long for one that is missing.
bool hasEnd(std::span<const std::byte> stream) {
    constexpr std::size_t kPadding = 16; // zeros that may follow
    const std::size_t from = stream.size() - std::min(stream.size(), kPadding);
    for (std::size_t i = from; i + 1 < stream.size(); ++i) {
        if (stream[i] == std::byte{0xff} && stream[i + 1] == std::byte{0xd9}) {
            return true;
        }
    }
    return false;
}

void decodeWithGdcm(const Context& context, std::span<const std::byte> stream, const DicomFile& file,
                    const DicomPixels& pixels, std::span<std::byte> out) {
    const auto codec = codecOf(file.transferSyntax);
    if (!codec) {
        context.refuse("its pixels are compressed in a way Limner does not read (" + file.transferSyntax.substr(0, 64) +
                           ")",
                       "convert it to an uncompressed transfer syntax");
    }
    const auto size = sizeOf(stream);
    const bool fits = size && size->columns == static_cast<std::uint32_t>(pixels.columns) &&
                      size->rows == static_cast<std::uint32_t>(pixels.rows) &&
                      size->components == static_cast<std::uint32_t>(pixels.samples) && size->bits >= 1 &&
                      size->bits <= static_cast<std::uint32_t>(pixels.bitsAllocated) &&
                      (size->bits > 8) == (pixels.bitsAllocated > 8);
    const bool jpegLs =
        *codec == gdcm::TransferSyntax::JPEGLSLossless || *codec == gdcm::TransferSyntax::JPEGLSNearLossless;
    if (jpegLs && !hasEnd(stream)) {
        context.refuse("its compressed pixels are cut off", "copy or export the file anew");
    }
    if (!fits) {
        context.refuse("its compressed pixels do not have the size its header gives");
    }
    static std::once_flag quiet;
    std::call_once(quiet, [] {
        gdcm::Trace::WarningOff();
        gdcm::Trace::ErrorOff();
        gdcm::Trace::DebugOff();
    });
    // The code stream's own depth: GDCM picks its JPEG decoder by it.
    const std::uint32_t bits = size->bits;
    gdcm::Image image;
    image.SetNumberOfDimensions(2);
    image.SetDimension(0, static_cast<unsigned>(pixels.columns));
    image.SetDimension(1, static_cast<unsigned>(pixels.rows));
    image.SetPixelFormat(gdcm::PixelFormat(
        static_cast<unsigned short>(pixels.samples), static_cast<unsigned short>(pixels.bitsAllocated),
        static_cast<unsigned short>(bits), static_cast<unsigned short>(bits - 1), pixels.isSigned ? 1 : 0));
    image.SetPhotometricInterpretation(pixels.samples == 1 ? gdcm::PhotometricInterpretation::MONOCHROME2
                                                           : gdcm::PhotometricInterpretation::RGB);
    image.SetTransferSyntax(*codec);
    gdcm::Fragment fragment;
    std::vector<char> even(reinterpret_cast<const char*>(stream.data()),
                           reinterpret_cast<const char*>(stream.data()) + stream.size());
    even.resize((even.size() + 1) / 2 * 2);
    fragment.SetByteValue(even.data(), gdcm::VL(static_cast<std::uint32_t>(even.size())));
    const gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = new gdcm::SequenceOfFragments;
    fragments->AddFragment(fragment);
    gdcm::DataElement data(gdcm::Tag(0x7fe0, 0x0010));
    data.SetVR(gdcm::VR::OB);
    data.SetValue(*fragments);
    image.SetDataElement(data);
    if (image.GetBufferLength() != out.size() || !image.GetBuffer(reinterpret_cast<char*>(out.data()))) {
        context.refuse("its compressed pixels are damaged", "copy or export the file anew");
    }
}

/// Picks the stored bits out of each allocated number and extends the sign.
template <typename T>
void maskBits(std::span<T> values, const DicomPixels& pixels) {
    const int allocated = static_cast<int>(sizeof(T)) * 8;
    const int left = allocated - 1 - pixels.highBit;
    const int right = allocated - pixels.bitsStored;
    if (left == 0 && right == 0) {
        return;
    }
    using Unsigned = std::make_unsigned_t<T>;
    for (T& value : values) {
        const auto shifted = static_cast<T>(static_cast<Unsigned>(static_cast<Unsigned>(value) << left));
        value = static_cast<T>(shifted >> right);
    }
}

/// First sample of each pixel; native bytes of the frame in `raw`.
void takeFirstSample(std::span<const std::byte> raw, const DicomPixels& pixels, bool planar, std::span<std::byte> out) {
    const std::size_t width = static_cast<std::size_t>(pixels.bitsAllocated) / 8;
    const std::size_t step = planar ? width : width * static_cast<std::size_t>(pixels.samples);
    for (std::size_t i = 0; i < pixels.framePixels(); ++i) {
        std::memcpy(out.data() + i * width, raw.data() + i * step, width);
    }
}

void unpackBits(std::span<const std::byte> bytes, const DicomPixels& pixels, int frame, std::span<std::byte> out) {
    const std::uint64_t first = static_cast<std::uint64_t>(frame) * pixels.framePixels();
    for (std::size_t i = 0; i < pixels.framePixels(); ++i) {
        const std::uint64_t bit = first + i;
        out[i] = bytes[bit / 8] >> (bit % 8) & std::byte{1};
    }
}

} // namespace

ScalarType DicomPixels::scalar() const {
    if (floatBits != 0) {
        return floatBits == 32 ? ScalarType::float32 : ScalarType::float64;
    }
    if (bitsAllocated <= 8) {
        return isSigned ? ScalarType::int8 : ScalarType::uint8;
    }
    if (bitsAllocated == 16) {
        return isSigned ? ScalarType::int16 : ScalarType::uint16;
    }
    return isSigned ? ScalarType::int32 : ScalarType::uint32;
}

DicomPixels dicomPixelsOf(const Context& context, const DicomFile& file) {
    const DicomDataSet& data = file.data;
    DicomPixels pixels;
    pixels.rows = data.number16(dicomTag(0x0028, 0x0010)).value_or(0);
    pixels.columns = data.number16(dicomTag(0x0028, 0x0011)).value_or(0);
    pixels.samples = data.number16(dicomTag(0x0028, 0x0002)).value_or(1);
    pixels.planar = data.number16(dicomTag(0x0028, 0x0006)).value_or(0) == 1;
    pixels.bitsAllocated = data.number16(dicomTag(0x0028, 0x0100)).value_or(0);
    pixels.bitsStored =
        data.number16(dicomTag(0x0028, 0x0101)).value_or(static_cast<std::uint16_t>(pixels.bitsAllocated));
    pixels.highBit =
        data.number16(dicomTag(0x0028, 0x0102)).value_or(static_cast<std::uint16_t>(pixels.bitsStored - 1));
    pixels.isSigned = data.number16(dicomTag(0x0028, 0x0103)).value_or(0) == 1;
    pixels.photometric = data.text(dicomTag(0x0028, 0x0004));
    pixels.floatBits = data.find(dicomTag(0x7fe0, 0x0008)) != nullptr   ? 32
                       : data.find(dicomTag(0x7fe0, 0x0009)) != nullptr ? 64
                                                                        : 0;
    const double frames = data.decimal(dicomTag(0x0028, 0x0008)).value_or(1);
    pixels.frames = frames >= 1 && frames <= static_cast<double>(kLargestAxis) ? static_cast<int>(frames) : 0;
    const bool bits = pixels.bitsAllocated == 1 || pixels.bitsAllocated == 8 || pixels.bitsAllocated == 16 ||
                      pixels.bitsAllocated == 32 || (pixels.floatBits == 64 && pixels.bitsAllocated == 64);
    if (pixels.rows < 1 || pixels.columns < 1 || pixels.frames < 1 || pixels.samples < 1 || pixels.samples > 4 ||
        !bits) {
        context.refuse("its header describes no picture that Limner reads");
    }
    if (pixels.bitsStored < 1 || pixels.bitsStored > pixels.bitsAllocated || pixels.highBit >= pixels.bitsAllocated ||
        pixels.highBit + 1 < pixels.bitsStored) {
        context.refuse("its bits allocated, bits stored and high bit do not fit together");
    }
    return pixels;
}

void checkDicomPixels(const Context& context, const DicomFile& file, const DicomPixels& pixels,
                      const std::string& name) {
    const DicomElement* element = pixelElement(file, pixels);
    if (element == nullptr) {
        context.refuse(name + " holds no pixels");
    }
    if (!isNative(file)) {
        if (element->fragments.size() < 2) {
            context.refuse("the compressed pixels of " + name + " are missing");
        }
        if (element->cutOff) {
            context.refuse(name + " is cut off inside its compressed pixels", "copy or export the file anew");
        }
        return;
    }
    const std::uint64_t bytes = (frameBits(pixels) * static_cast<std::uint64_t>(pixels.frames) + 7) / 8;
    if (element->value.size() < bytes) {
        context.refuse("the header of " + name + " promises " + std::to_string(bytes) + " bytes of pixels, it holds " +
                           std::to_string(element->value.size()),
                       "copy or export the file anew");
    }
}

void readDicomFrame(const Context& context, const DicomFile& file, const DicomPixels& pixels, int frame,
                    std::span<std::byte> out) {
    const DicomElement& element = *pixelElement(file, pixels);
    const std::size_t frameBytes = frameBits(pixels) / 8;
    if (isNative(file) && pixels.bitsAllocated == 1) {
        unpackBits(element.value, pixels, frame, out);
        return;
    }
    if (isNative(file)) {
        const auto raw = element.value.subspan(static_cast<std::size_t>(frame) * frameBytes, frameBytes);
        takeFirstSample(raw, pixels, pixels.planar, out);
        if (file.data.bigEndian) {
            swapBytes(out, static_cast<std::size_t>(pixels.bitsAllocated) / 8);
        }
    } else {
        if (pixels.bitsAllocated == 1 || pixels.floatBits != 0) {
            context.refuse("its pixels are compressed in a way Limner does not read");
        }
        const std::vector<std::byte> stream = codeStream(context, element, pixels, frame);
        const bool rle = file.transferSyntax == "1.2.840.10008.1.2.5";
        // Run-length coding makes at most 128 bytes of two; the other codecs a constant picture of a few bytes.
        const std::uint64_t atMost = rle ? stream.size() * 64 : (stream.size() + 16) << 16;
        if (frameBytes > atMost || (!rle && !sizeOf(stream))) {
            context.refuse("its compressed pixels are damaged", "copy or export the file anew");
        }
        std::vector<std::byte> raw(frameBytes);
        if (rle) {
            decodeRle(context, stream, pixels, raw);
        } else {
            decodeWithGdcm(context, stream, file, pixels, raw);
        }
        takeFirstSample(raw, pixels, rle, out);
    }
    if (pixels.floatBits == 0) {
        withScalar(pixels.scalar(), [&](auto zero) {
            using T = decltype(zero);
            if constexpr (std::is_integral_v<T>) {
                maskBits(std::span(reinterpret_cast<T*>(out.data()), out.size() / sizeof(T)), pixels);
            }
        });
    }
}

} // namespace limner::importing
