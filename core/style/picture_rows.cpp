#include "core/style/picture_rows.h"

#include "core/base/error.h"
#include "core/style/picture_colour.h"
#include "core/style/picture_promises.h"

#include <OpenImageIO/imageio.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <optional>
#include <vector>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr int kPlainBand = 64;
/// Keeps a band of rows under that many bytes, whatever the header says.
constexpr std::size_t kLargestBand = std::size_t{640} << 20;
/// Samples and strips that are unpacked at a time.
constexpr std::size_t kLargestPiece = std::size_t{64} << 20;
constexpr std::size_t kSerialPixels = std::size_t{1} << 16;
/// Formats whose libraries unpack a picture as a whole must not do so on a header's word alone.
constexpr double kUnpackedFreely = 1U << 30U;
constexpr double kBestPacking = 2000;
/// What a library may hold of a file at once, where it cannot do with less.
constexpr double kLargestWhole = 512U << 20U;

constexpr int kTiffSeparated = 5; ///< PhotometricInterpretation: inks
/// Others that libtiff brings to RGB itself, for which it unpacks the whole picture: CIE L*a*b* (three), LogLuv (two).
constexpr std::array<int, 5> kTiffUnpackedWhole{8, 9, 10, 32844, 32845};

bool isFormat(const OIIO::ImageInput& input, const char* name) {
    return OIIO::Strutil::iequals(input.format_name(), name);
}

/// A TIFF file whose pixels libtiff brings to RGB itself.
bool unpackedWhole(const OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
    if (!isFormat(input, "tiff")) {
        return false;
    }
    const int meaning = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
    const bool jpeg = spec.get_string_attribute("compression") == "jpeg";
    return (jpeg && spec.nchannels != 3) ||
           std::find(kTiffUnpackedWhole.begin(), kTiffUnpackedWhole.end(), meaning) != kTiffUnpackedWhole.end();
}

/// Whether a file must be asked for its inks, lest they come as RGB by a rule of the reader's own.
bool holdsInks(const OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
    return isFormat(input, "tiff") && spec.get_int_attribute("tiff:PhotometricInterpretation") == kTiffSeparated;
}

PictureChannels channelsOf(const OIIO::ImageSpec& spec, bool inks) {
    PictureChannels channels;
    channels.count = spec.nchannels;
    channels.alpha = spec.alpha_channel;
    channels.steps = spec.format == OIIO::TypeDesc::UINT8 ? 255 : (spec.format == OIIO::TypeDesc::UINT16 ? 65535 : 0);
    if (inks) {
        channels.colour = PictureChannels::Colour::cmyk;
        channels.alpha = -1; // a fifth channel may be anything
        return channels;
    }
    if (channels.alpha < 0 && (spec.nchannels == 2 || spec.nchannels == 4)) {
        channels.alpha = spec.nchannels - 1;
    }
    if (spec.nchannels < 3) {
        channels.colour = PictureChannels::Colour::grey;
    }
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const bool floats = spec.format.is_floating_point();
    channels.linear = OIIO::Strutil::iequals(space, "linear") || (space.empty() && floats);
    channels.premultiplied = channels.alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
    return channels;
}

std::span<const std::uint8_t> profileOf(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
    if (profile == nullptr || profile->type().basetype != OIIO::TypeDesc::UINT8) {
        return {};
    }
    return {static_cast<const std::uint8_t*>(profile->data()), profile->type().size()};
}

/// Of a TIFF file without tiles; of other formats, 1: they are read by the row.
int stripRowsOf(const OIIO::ImageSpec& spec) {
    const bool tiff = spec.find_attribute("tiff:Compression") != nullptr;
    const int rows = spec.get_int_attribute("tiff:RowsPerStrip", tiff ? spec.height : 1);
    return std::clamp(rows, 1, std::max(1, spec.height));
}

/// Rows that are read at a time: whole tiles or, where they are not too large, whole strips, which are read in any
/// order.
int bandRowsOf(const OIIO::ImageSpec& spec) {
    if (spec.tile_width > 0) {
        return std::min(spec.height, spec.tile_height);
    }
    const std::size_t rowBytes = static_cast<std::size_t>(std::max(spec.width, 1)) * sizeof(Rgba);
    const auto most = static_cast<int>(std::clamp<std::size_t>(kLargestPiece / rowBytes, 1, 8192));
    const int strip = stripRowsOf(spec);
    const int rows = std::min(kPlainBand, most);
    return std::min(spec.height, strip <= most ? std::max(1, rows / strip) * strip : rows);
}

} // namespace

struct PictureRows::Reader {
    fs::path file;
    Words words;
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    bool tiff = false;
    std::optional<PictureColour> colour;
    int band = 0;
    std::vector<float> samples; ///< of a piece of a band, as the file has them
    std::vector<Rgba> pixels;

    void open(bool inks);
    /// Why the rows from `y` on and before `end` cannot be read; empty where they were.
    std::string readSamples(int y, int end, int left, int right);
};

/// Leaves `input` null where that fails.
void PictureRows::Reader::open(bool inks) {
    // Alpha as the file has it: to multiply and divide again would cost the colour of clear texels.
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    if (inks) {
        config.attribute("oiio:RawColor", 1);
    }
    input = OIIO::ImageInput::open(file.string(), &config);
    if (input != nullptr) {
        spec = input->spec();
        tiff = isFormat(*input, "tiff");
        input->threads(1); // several at a time do not notice damage either
    }
}

std::string PictureRows::Reader::readSamples(int y, int end, int left, int right) {
    const bool tiled = spec.tile_width > 0;
    const std::size_t rowSamples = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.nchannels);
    // Several rows of a deflated TIFF file at once would be unpacked by a way that does not notice damage.
    const int rows = !tiled && tiff && spec.get_string_attribute("compression") == "zip" ? 1 : end - y;
    bool read = true;
    try {
        for (int row = y; read && row < end; row += rows) {
            const int top = spec.y + row;
            float* out = samples.data() + static_cast<std::size_t>(row - y) * rowSamples;
            read = tiled ? input->read_tiles(0, 0, spec.x + left, spec.x + right, top, top + rows, spec.z, spec.z + 1,
                                             0, spec.nchannels, OIIO::TypeDesc::FLOAT, out)
                         : input->read_scanlines(0, 0, top, top + rows, spec.z, 0, spec.nchannels,
                                                 OIIO::TypeDesc::FLOAT, out);
        }
    } catch (const std::exception& problem) { // a damaged header asks for more memory than there is
        return problem.what();
    }
    // Some readers only mumble about what is missing, and fill it up: TIFF's about nothing else, JPEG's about much that
    // does no harm too.
    const std::string message = input->geterror();
    const bool cutShort = message.find("Premature end") != std::string::npos || (tiff && !message.empty());
    return read && !cutShort ? std::string() : (message.empty() ? std::string("no pixels") : message);
}

PictureRows::PictureRows(fs::path file, Words words) : reader_(std::make_unique<Reader>()) {
    Reader& r = *reader_;
    r.file = std::move(file);
    r.words = std::move(words);
    const PicturePromises promises = promisesOf(r.file);
    if (!promises.broken.empty()) {
        fail(promises.broken, "the file is damaged; get it again");
    }
    r.open(false);
    const bool inks = r.input != nullptr && holdsInks(*r.input, r.spec);
    if (inks) {
        r.open(true);
    }
    if (r.input == nullptr) {
        std::error_code unknown;
        fail(fs::exists(r.file, unknown) ? OIIO::geterror() : (OIIO::geterror(), std::string("no such file")),
             r.words.instead);
    }
    // The reader of Photoshop files takes what is not there for the alpha of CMYK.
    if (promises.photoshopInks && r.spec.nchannels == 4) {
        fail("CMYK with transparency cannot be read from a Photoshop file", "flatten it, or save it as RGB");
    }
    checkHeader();
    // Such a file's inks have become RGB already.
    const bool converted = unpackedWhole(*r.input, r.spec);
    r.colour.emplace(channelsOf(r.spec, inks && !converted && r.spec.nchannels >= 4),
                     converted ? std::span<const std::uint8_t>{} : profileOf(r.spec));
    r.band = bandRowsOf(r.spec);
}

PictureRows::~PictureRows() = default;

void PictureRows::checkHeader() const {
    const OIIO::ImageSpec& spec = reader_->spec;
    // RGBA and as many extra ones; more is a damaged header.
    if (spec.nchannels < 1 || spec.nchannels > 8 || spec.depth > 1) {
        fail(std::to_string(spec.nchannels) + " channels are not a picture", "use a grey, RGB or RGBA picture");
    }
    const auto bytesOf = [](int width, int height, std::size_t pixel) {
        return static_cast<double>(width) * height * static_cast<double>(pixel);
    };
    const int rows = spec.tile_width > 0 ? spec.tile_height : 1;
    const std::size_t pixelBytes = static_cast<std::size_t>(spec.nchannels) * sizeof(float);
    if (bytesOf(spec.width, std::min(rows, spec.height), sizeof(Rgba)) > kLargestBand ||
        bytesOf(spec.tile_width, rows, pixelBytes) > kLargestBand) {
        fail("rows of " + std::to_string(spec.width) + " pixels in tiles of " + std::to_string(spec.tile_width) +
                 " x " + std::to_string(rows),
             "save it with smaller tiles or none");
    }
    checkMemory();
}

/// Where a library must hold much of a file at once: pixels of a kind that it converts itself, long strips.
void PictureRows::checkMemory() const {
    const OIIO::ImageSpec& spec = reader_->spec;
    if (unpackedWhole(*reader_->input, spec) && 4.0 * spec.width * spec.height > kLargestWhole) {
        fail("pixels of this kind can only be read all at once, and these are too many", "save it as RGB");
    }
    if (spec.tile_width > 0 || !reader_->tiff) {
        return;
    }
    const bool planes = spec.get_string_attribute("planarconfig") == "separate";
    const int rows = stripRowsOf(spec);
    const double strips = std::ceil(spec.height / static_cast<double>(rows)) * (planes ? spec.nchannels : 1);
    std::error_code unknown;
    const auto bytes = static_cast<double>(fs::file_size(reader_->file, unknown));
    // Planes in long strips would be unpacked from their beginning for every row.
    if ((!unknown && bytes / strips > kLargestWhole) || (planes && rows > bandRowsOf(spec))) {
        fail("its strips of " + std::to_string(rows) + " rows are too long to be read one by one",
             "save it in tiles or shorter strips, its channels together");
    }
}

int PictureRows::width() const { return reader_->spec.width; }
int PictureRows::height() const { return reader_->spec.height; }
int PictureRows::bandRows() const { return reader_->band; }

std::span<const Rgba> PictureRows::read(int y, int left, int right) {
    Reader& r = *reader_;
    const OIIO::ImageSpec& spec = r.spec;
    const int end = std::min(y + r.band, spec.height);
    const auto rows = static_cast<std::size_t>(end - y);
    const auto depth = static_cast<std::size_t>(spec.nchannels);
    const auto width = static_cast<std::size_t>(right - left);
    // Rows are unpacked whole, tiles by the column, so that high ones do not all lie in memory as samples.
    const bool tiled = spec.tile_width > 0;
    const int tile = tiled ? spec.tile_width : spec.width;
    const std::size_t tileBytes = rows * depth * sizeof(float) * static_cast<std::size_t>(tile);
    const int step = tile * (tiled ? static_cast<int>(std::clamp<std::size_t>(kLargestPiece / tileBytes, 1, 256)) : 1);
    const int last = std::min(spec.width, (right + tile - 1) / tile * tile);
    r.pixels.resize(rows * width);
    for (int from = left / tile * tile; from < last; from += step) {
        const int to = std::min(from + step, last);
        const auto across = static_cast<std::size_t>(to - from);
        r.samples.resize(rows * across * depth);
        if (const std::string problem = r.readSamples(y, end, from, to); !problem.empty()) {
            fail(problem, "the file is damaged or cut short; get it again");
        }
        const int begin = std::max(from, left);
        const auto count = static_cast<std::size_t>(std::min(to, right) - begin);
        const auto convert = [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t row = range.begin(); row < range.end(); ++row) {
                const std::size_t at = row * across + static_cast<std::size_t>(begin - from);
                const std::size_t out = row * width + static_cast<std::size_t>(begin - left);
                r.colour->toRgba(std::span(r.samples).subspan(at * depth, count * depth),
                                 std::span(r.pixels).subspan(out, count));
            }
        };
        // Isolated: whoever reads may hold a lock that other work in the same threads waits for.
        tbb::this_task_arena::isolate(
            [&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows, 1 + kSerialPixels / count), convert); });
    }
    return r.pixels;
}

void PictureRows::failWhereTooShort() const {
    std::error_code unknown;
    const auto bytes = static_cast<double>(fs::file_size(reader_->file, unknown));
    const double unpacked = 3.0 * width() * height();
    if (width() < 1 || height() < 1 || unknown || (unpacked > kUnpackedFreely && unpacked > kBestPacking * bytes)) {
        fail("its header promises " + std::to_string(width()) + " x " + std::to_string(height()) +
                 " pixels, which the file cannot hold",
             "the file is damaged; get it again");
    }
}

void PictureRows::fail(const std::string& why, const std::string& remedy) const {
    throw Error(ErrorKind::badInput, {reader_->words.what, reader_->file.string(), why, remedy});
}

} // namespace limner
