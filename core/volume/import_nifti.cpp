#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// NIfTI-1 and -2 (nifti.nimh.nih.gov) and Analyze 7.5. World axes of the files are RAS; Limner's are LPS.

namespace limner::importing {

namespace {

constexpr std::size_t kHeader1 = 348;
constexpr std::size_t kHeader2 = 540;

struct NiftiHeader {
    int version = 1; ///< 0: Analyze
    bool swapped = false;
    bool pair = false;
    std::array<std::int64_t, 8> dim{};
    int datatype = 0;
    std::array<double, 8> pixdim{};
    double voxOffset = 0;
    double slope = 0;
    double intercept = 0;
    int units = 0;
    int qformCode = 0;
    int sformCode = 0;
    glm::dvec3 quaternion{0};
    glm::dvec3 qOffset{0};
    glm::dmat3 sAxes{1}; ///< columns
    glm::dvec3 sOrigin{0};
};

NiftiHeader parseHeader1(std::span<const std::byte> b, bool swapped) {
    NiftiHeader h;
    h.swapped = swapped;
    const auto real = [&](std::size_t at) { return static_cast<double>(word<float>(b, at, swapped)); };
    const std::string magic(reinterpret_cast<const char*>(b.data()) + 344, 3);
    h.version = magic == "n+1" || magic == "ni1" ? 1 : 0;
    h.pair = magic != "n+1";
    for (std::size_t i = 0; i < 8; ++i) {
        h.dim[i] = word<std::int16_t>(b, 40 + 2 * i, swapped);
        h.pixdim[i] = real(76 + 4 * i);
    }
    h.datatype = word<std::int16_t>(b, 70, swapped);
    h.voxOffset = real(108);
    if (h.version == 0) {
        return h; // the other fields are NIfTI's
    }
    h.slope = real(112);
    h.intercept = real(116);
    h.units = static_cast<int>(b[123]);
    h.qformCode = word<std::int16_t>(b, 252, swapped);
    h.sformCode = word<std::int16_t>(b, 254, swapped);
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(i);
        h.quaternion[i] = real(256 + 4 * n);
        h.qOffset[i] = real(268 + 4 * n);
        for (int column = 0; column < 3; ++column) {
            h.sAxes[column][i] = real(280 + 16 * n + 4 * static_cast<std::size_t>(column));
        }
        h.sOrigin[i] = real(280 + 16 * n + 12);
    }
    return h;
}

NiftiHeader parseHeader2(std::span<const std::byte> b, bool swapped) {
    NiftiHeader h;
    h.version = 2;
    h.swapped = swapped;
    const auto real = [&](std::size_t at) { return word<double>(b, at, swapped); };
    h.pair = static_cast<char>(b[5]) != '+';
    h.datatype = word<std::int16_t>(b, 12, swapped);
    for (std::size_t i = 0; i < 8; ++i) {
        h.dim[i] = word<std::int64_t>(b, 16 + 8 * i, swapped);
        h.pixdim[i] = real(104 + 8 * i);
    }
    h.voxOffset = static_cast<double>(word<std::int64_t>(b, 168, swapped));
    h.slope = real(176);
    h.intercept = real(184);
    h.qformCode = word<std::int32_t>(b, 344, swapped);
    h.sformCode = word<std::int32_t>(b, 348, swapped);
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(i);
        h.quaternion[i] = real(352 + 8 * n);
        h.qOffset[i] = real(376 + 8 * n);
        for (int column = 0; column < 3; ++column) {
            h.sAxes[column][i] = real(400 + 32 * n + 8 * static_cast<std::size_t>(column));
        }
        h.sOrigin[i] = real(400 + 32 * n + 24);
    }
    h.units = word<std::int32_t>(b, 500, swapped);
    return h;
}

struct Sample {
    ScalarType type;
    std::uint64_t components;
};

Sample sampleOf(const Context& context, int datatype) {
    switch (datatype) {
    case 2: return {ScalarType::uint8, 1};
    case 4: return {ScalarType::int16, 1};
    case 8: return {ScalarType::int32, 1};
    case 16: return {ScalarType::float32, 1};
    case 32: return {ScalarType::float32, 2}; // complex
    case 64: return {ScalarType::float64, 1};
    case 128: return {ScalarType::uint8, 3};
    case 256: return {ScalarType::int8, 1};
    case 512: return {ScalarType::uint16, 1};
    case 768: return {ScalarType::uint32, 1};
    case 1024: return {ScalarType::int64, 1};
    case 1280: return {ScalarType::uint64, 1};
    case 1792: return {ScalarType::float64, 2}; // complex
    case 2304: return {ScalarType::uint8, 4};
    default: context.refuse("it has the data type " + std::to_string(datatype) + ", which Limner does not read");
    }
}

/// Rotation of the qform (NIfTI-1 standard, "method 2"); nothing where the quaternion is none.
std::optional<glm::dmat3> rotationOf(const glm::dvec3& q) {
    const double rest = 1 - glm::dot(q, q);
    constexpr double kSlack = 1e-5; // single precision of three numbers near 1
    if (!(rest > -kSlack)) {
        return std::nullopt;
    }
    const double a = std::sqrt(std::max(rest, 0.0));
    const double b = q.x;
    const double c = q.y;
    const double d = q.z;
    return glm::dmat3(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c), //
                      2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b), //
                      2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - c * c - b * b);
}

struct Affine {
    glm::dmat3 axes{1};
    glm::dvec3 origin{0};
};

glm::dvec3 spacingOf(const Context& context, const NiftiHeader& h, int used) {
    glm::dvec3 spacing(1);
    for (int i = 0; i < 3; ++i) {
        // A negative pixdim is an old way to mark a flip; the forms say it properly.
        const double pixdim = std::abs(h.pixdim[static_cast<std::size_t>(i) + 1]);
        if (i < used) {
            checkSpacing(context, pixdim);
            spacing[i] = pixdim;
        } else if (std::isfinite(pixdim) && pixdim > 0) {
            spacing[i] = pixdim;
        }
    }
    return spacing;
}

std::optional<Affine> qform(const NiftiHeader& h, const glm::dvec3& spacing) {
    const auto rotation = rotationOf(h.quaternion);
    if (!rotation) {
        return std::nullopt;
    }
    const double handed = h.pixdim[0] < 0 ? -1 : 1;
    return Affine{
        glm::dmat3((*rotation)[0] * spacing.x, (*rotation)[1] * spacing.y, (*rotation)[2] * spacing.z * handed),
        h.qOffset};
}

/// Neither form: x grows to the left, as Analyze's radiological tradition has it, and the middle is the origin.
Affine formless(const glm::dvec3& spacing, const glm::ivec3& dims) {
    const glm::dvec3 signedSpacing = spacing * glm::dvec3(-1, 1, 1);
    Affine affine;
    for (int i = 0; i < 3; ++i) {
        affine.axes[i] = glm::dvec3(0);
        affine.axes[i][i] = signedSpacing[i];
        affine.origin[i] = -signedSpacing[i] * (dims[i] - 1) / 2;
    }
    return affine;
}

bool differ(const Affine& a, const Affine& b, const glm::dvec3& spacing) {
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        worst = std::max(worst, glm::length(a.axes[i] - b.axes[i]) / spacing[i]);
    }
    return worst > 0.01; // a hundredth of a voxel per voxel: more than rounding
}

Affine chooseAffine(const Context& context, const NiftiHeader& h, const glm::dvec3& spacing, const glm::ivec3& dims) {
    const auto q = h.qformCode > 0 ? qform(h, spacing) : std::nullopt;
    if (h.sformCode > 0) {
        const Affine s{h.sAxes, h.sOrigin};
        if (q && differ(s, *q, spacing)) {
            context.warn("its sform and qform are at odds; the sform was followed");
        }
        return s;
    }
    if (q) {
        return *q;
    }
    if (h.qformCode > 0) {
        context.warn("its qform is damaged and was left out");
    }
    context.warn(
        "the file gives no orientation: x is taken to grow to the patient's left, y to the front, z to the head");
    return formless(spacing, dims);
}

void place(Context& context, const NiftiHeader& h, int used, StoredVolume& stored) {
    const glm::dvec3 spacing = spacingOf(context, h, used);
    const Affine affine = chooseAffine(context, h, spacing, stored.dims);
    const int space = h.units & 7;
    const double mm = space == 1 ? 1000 : space == 3 ? 0.001 : 1;
    const glm::dvec3 lpsFromRas = glm::dvec3(-1, -1, 1) * mm;
    for (int i = 0; i < 3; ++i) {
        stored.axesMm[i] = affine.axes[i] * lpsFromRas;
    }
    stored.originMm = affine.origin * lpsFromRas;
}

/// The other half of a .hdr/.img pair.
std::filesystem::path partner(const Context& context, const std::filesystem::path& path, const std::string& ending) {
    const bool gz = lowered(path.extension().string()) == ".gz";
    std::filesystem::path stem = gz ? path.parent_path() / path.stem() : path;
    for (const std::string& candidate : {ending, ending + ".gz"}) {
        std::filesystem::path other = stem;
        other.replace_extension(candidate);
        if (std::filesystem::is_regular_file(other)) {
            return other;
        }
    }
    context.refuse("there is no " + stem.stem().string() + ending + " beside it",
                   "keep the .hdr and the .img together");
}

/// The file that holds the header.
std::filesystem::path headerFile(const Context& context) {
    const std::string name = lowered(context.path.filename().string());
    const bool isImage = name.ends_with(".img") || name.ends_with(".img.gz");
    return isImage ? partner(context, context.path, ".hdr") : context.path;
}

Compression compressionOf(const std::filesystem::path& file) {
    return startsAsGzip(file) ? Compression::gzip : Compression::none;
}

NiftiHeader readHeader(const Context& context, ByteStream& stream, std::size_t& length) {
    std::array<std::byte, kHeader2> bytes{};
    readAll(context, stream, std::span(bytes).first(kHeader1));
    const auto size = word<std::int32_t>(bytes, 0, false);
    const bool second =
        size == static_cast<int>(kHeader2) || word<std::int32_t>(bytes, 0, true) == static_cast<int>(kHeader2);
    const bool swapped = size != static_cast<int>(kHeader1) && size != static_cast<int>(kHeader2);
    length = second ? kHeader2 : kHeader1;
    if (!second) {
        return parseHeader1(bytes, swapped);
    }
    readAll(context, stream, std::span(bytes).subspan(kHeader1));
    return parseHeader2(bytes, swapped);
}

/// Shape of the header: axes used (1 to 3), components by further axes.
void readShape(const Context& context, const NiftiHeader& h, ScalarType type, StoredVolume& stored, int& used,
               std::uint64_t& frames) {
    const std::int64_t rank = h.dim[0];
    if (rank < 1 || rank > 7) {
        context.refuse("its header gives " + std::to_string(rank) + " dimensions");
    }
    const std::span axes(h.dim.data() + 1, static_cast<std::size_t>(rank));
    checkedVoxels(context, axes, type);
    stored.dims = checkedDims(context, axes.first(std::min<std::size_t>(3, axes.size())), type);
    used = static_cast<int>(std::min<std::int64_t>(rank, 3));
    frames = 1;
    for (std::size_t i = 3; i < axes.size(); ++i) {
        frames *= static_cast<std::uint64_t>(axes[i]);
    }
}

void setScaling(const Context& context, const NiftiHeader& h, StoredVolume& stored) {
    if (!std::isfinite(h.slope) || !std::isfinite(h.intercept)) {
        context.warn("its slope or intercept is no number; the values were left as stored");
    } else if (h.slope != 0) {
        stored.slope = h.slope;
        stored.intercept = h.intercept;
    }
}

std::uint64_t dataOffset(const Context& context, const NiftiHeader& h) {
    constexpr double kLongestHeader = 1 << 30;
    if (!(h.voxOffset >= 0 && h.voxOffset <= kLongestHeader)) {
        context.refuse("its data should start at an impossible place");
    }
    return static_cast<std::uint64_t>(h.voxOffset);
}

/// The extensions in what follows the header: four bytes, of which the first says whether there are any, then size
/// (with the eight bytes of size and code), code and content of each.
std::vector<std::string> splitExtensions(const Context& context, std::span<const std::byte> all, bool swapped) {
    constexpr std::size_t kStart = 4;
    constexpr std::size_t kHead = 8;
    std::vector<std::string> result;
    std::size_t at = kStart;
    while (at + kHead <= all.size() && std::to_integer<int>(all[0]) != 0) {
        const auto size = static_cast<std::int64_t>(word<std::int32_t>(all, at, swapped));
        if (size == 0) {
            break; // the rest up to the data
        }
        if (size < static_cast<std::int64_t>(kHead) || static_cast<std::size_t>(size) > all.size() - at) {
            context.warn("a header extension of " + std::to_string(size) + " bytes, where " +
                         std::to_string(all.size() - at) + " are left, was left out");
            break;
        }
        std::string text(reinterpret_cast<const char*>(all.data()) + at + kHead,
                         static_cast<std::size_t>(size) - kHead);
        text.resize(text.find_last_not_of('\0') + 1);
        result.push_back(std::move(text));
        at += static_cast<std::size_t>(size);
    }
    return result;
}

} // namespace

bool startsAsNifti(const std::string& head) {
    if (head.size() < 348) {
        return false;
    }
    const auto bytes = std::as_bytes(std::span(head));
    for (const bool swapped : {false, true}) {
        const auto size = word<std::int32_t>(bytes, 0, swapped);
        if (size == 348 || (size == 540 && head.compare(4, 2, "n+") == 0) ||
            (size == 540 && head.compare(4, 2, "ni") == 0)) {
            return true;
        }
    }
    return false;
}

std::vector<std::string> niftiExtensions(const Context& context) {
    constexpr std::uint64_t kLargest = 16 << 20; // tables of labels take kilobytes
    const std::filesystem::path header = headerFile(context);
    const auto stream = openStream(context, header, compressionOf(header));
    std::size_t headerLength = 0;
    const NiftiHeader h = readHeader(context, *stream, headerLength);
    if (h.version == 0) {
        return {}; // Analyze has none
    }
    // Of a pair, the rest of the header's file.
    const std::uint64_t offset = h.pair ? headerLength + kLargest : dataOffset(context, h);
    if (offset <= headerLength || offset - headerLength > kLargest) {
        return {};
    }
    ByteBuffer bytes(std::min(offset - headerLength, stream->atMost()));
    const std::size_t length = stream->read(bytes.span());
    return splitExtensions(context, std::as_const(bytes).span().first(length), h.swapped);
}

StoredVolume readNifti(Context& context) {
    const std::filesystem::path header = headerFile(context);
    auto stream = openStream(context, header, compressionOf(header));
    std::size_t headerLength = 0;
    const NiftiHeader h = readHeader(context, *stream, headerLength);

    StoredVolume stored;
    const Sample sample = sampleOf(context, h.datatype);
    int used = 3;
    std::uint64_t frames = 1;
    stored.type = sample.type;
    readShape(context, h, sample.type, stored, used, frames);
    expectComponents(context, sample.components,
                     sample.components == 2 ? "complex numbers" : std::to_string(sample.components) + " colours");
    expectComponents(context, frames, std::to_string(frames) + " volumes (4D data)");
    place(context, h, used, stored);
    setScaling(context, h, stored);
    checkGeometry(context, stored);

    std::uint64_t offset = dataOffset(context, h);
    if (h.pair) {
        const std::filesystem::path image = partner(context, context.path, ".img");
        stream = openStream(context, image, compressionOf(image));
        skipBytes(context, *stream, offset);
    } else {
        offset = std::max<std::uint64_t>(offset, headerLength); // 0 is found in the wild
        skipBytes(context, *stream, offset - headerLength);
    }
    const std::int64_t dims[] = {stored.dims.x, stored.dims.y, stored.dims.z,
                                 static_cast<std::int64_t>(sample.components)};
    const std::uint64_t bytes = checkedVoxels(context, dims, sample.type) * bytesPerScalar(sample.type);
    expectBytes(context, *stream, bytes * frames);
    stored.values = ByteBuffer(bytes);
    readAll(context, *stream, stored.values.span());
    if (h.swapped) {
        swapBytes(stored.values.span(), bytesPerScalar(stored.type));
    }
    keepFirstComponent(stored, sample.components);
    context.report.format = h.version == 2 ? "NIfTI-2" : h.version == 1 ? "NIfTI-1" : "Analyze 7.5";
    return stored;
}

} // namespace limner::importing
