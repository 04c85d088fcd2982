#include "core/style/picture_rows.h"

#include "core/base/error.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr int kPlainBand = 64;
/// Keeps a band of rows under a gigabyte, whatever the header says.
constexpr std::size_t kLargestBand = std::size_t{1} << 30;

/// How the channels of a picture give an RGBA value.
struct Channels {
    std::array<int, 3> colour{0, 0, 0};
    int alpha = -1; ///< none
    bool linear = false;
    bool premultiplied = false;
};

Channels channelsOf(const OIIO::ImageSpec& spec) {
    Channels channels;
    channels.alpha = spec.alpha_channel;
    if (channels.alpha < 0 && (spec.nchannels == 2 || spec.nchannels == 4)) {
        channels.alpha = spec.nchannels - 1;
    }
    if (spec.nchannels >= 3) {
        channels.colour = {0, 1, 2};
    }
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const bool floats = spec.format.is_floating_point();
    channels.linear = OIIO::Strutil::iequals(space, "linear") || (space.empty() && floats);
    channels.premultiplied = channels.alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
    return channels;
}

float encodeSrgb(float linear) {
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

/// NaN counts as 0.
float clampUnit(float value) { return value > 0 ? std::min(value, 1.0F) : 0.0F; }

Rgba rgbaOf(const float* texel, const Channels& channels) {
    const float alpha = channels.alpha >= 0 ? clampUnit(texel[channels.alpha]) : 1.0F;
    std::array<float, 3> colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        float value = texel[channels.colour[c]];
        if (channels.premultiplied && alpha > 0) {
            value /= alpha;
        }
        value = clampUnit(value);
        colour[c] = channels.linear ? encodeSrgb(value) : value;
    }
    return {colour[0], colour[1], colour[2], alpha};
}

} // namespace

struct PictureRows::Reader {
    fs::path file;
    Words words;
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    Channels channels;
    int band = 0;
    std::vector<float> samples; ///< of a band, as the file has them
    std::vector<Rgba> pixels;
};

PictureRows::PictureRows(fs::path file, Words words) : reader_(std::make_unique<Reader>()) {
    Reader& r = *reader_;
    r.file = std::move(file);
    r.words = std::move(words);
    // Alpha as the file has it: to multiply and divide again would cost the colour of clear texels.
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    r.input = OIIO::ImageInput::open(r.file.string(), &config);
    if (r.input == nullptr) {
        std::error_code unknown;
        fail(fs::exists(r.file, unknown) ? OIIO::geterror() : (OIIO::geterror(), std::string("no such file")),
             r.words.instead);
    }
    r.spec = r.input->spec();
    // RGBA and as many extra ones; more is a damaged header.
    if (r.spec.nchannels < 1 || r.spec.nchannels > 8 || r.spec.depth > 1) {
        fail(std::to_string(r.spec.nchannels) + " channels are not a picture", "use a grey, RGB or RGBA picture");
    }
    r.channels = channelsOf(r.spec);
    const bool tiled = r.spec.tile_width > 0;
    r.band = std::min(r.spec.height, tiled ? r.spec.tile_height : kPlainBand);
    const std::size_t bandBytes = static_cast<std::size_t>(r.spec.width) * static_cast<std::size_t>(r.band) *
                                  (static_cast<std::size_t>(r.spec.nchannels) * sizeof(float) + sizeof(Rgba));
    if (bandBytes > kLargestBand) {
        fail("rows of " + std::to_string(r.spec.width) + " pixels in tiles of " + std::to_string(r.band) + " rows",
             "save it with smaller tiles or none");
    }
}

PictureRows::~PictureRows() = default;

int PictureRows::width() const { return reader_->spec.width; }
int PictureRows::height() const { return reader_->spec.height; }
int PictureRows::bandRows() const { return reader_->band; }

std::span<const Rgba> PictureRows::read(int y) {
    Reader& r = *reader_;
    const OIIO::ImageSpec& spec = r.spec;
    const int end = std::min(y + r.band, spec.height);
    const auto depth = static_cast<std::size_t>(spec.nchannels);
    const std::size_t count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(end - y);
    r.samples.resize(count * depth);
    const bool read = spec.tile_width > 0
                          ? r.input->read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + y, spec.y + end, spec.z,
                                                spec.z + 1, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, r.samples.data())
                          : r.input->read_scanlines(0, 0, spec.y + y, spec.y + end, spec.z, 0, spec.nchannels,
                                                    OIIO::TypeDesc::FLOAT, r.samples.data());
    if (!read) {
        fail(r.input->geterror(), "the file is damaged or cut short; get it again");
    }
    r.pixels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        r.pixels[i] = rgbaOf(r.samples.data() + i * depth, r.channels);
    }
    return r.pixels;
}

void PictureRows::fail(const std::string& why, const std::string& remedy) const {
    throw Error(ErrorKind::badInput, {reader_->words.what, reader_->file.string(), why, remedy});
}

} // namespace limner
