#include "core/style/square_picture.h"

#include "core/base/error.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace limner {
namespace {

namespace fs = std::filesystem;

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

/// Refuses a picture.
class Refusal {
  public:
    Refusal(const fs::path& file, const PictureRules& rules) : file_(file), rules_(rules) {}
    [[noreturn]] void operator()(const std::string& why, const std::string& remedy) const {
        throw Error(ErrorKind::badInput, {rules_.what, file_.string(), why, remedy});
    }
    void checkSize(const OIIO::ImageSpec& spec) const;

  private:
    const fs::path& file_;
    const PictureRules& rules_;
};

void Refusal::checkSize(const OIIO::ImageSpec& spec) const {
    const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels";
    if (spec.width != spec.height) {
        (*this)(size + " are not square", rules_.crop);
    }
    if (spec.width < rules_.widths[0] || spec.width > rules_.widths[1]) {
        (*this)(size + " are out of range", rules_.resize);
    }
    // RGBA and as many extra ones; more is a damaged header.
    if (spec.nchannels < 1 || spec.nchannels > 8 || spec.depth > 1) {
        (*this)(std::to_string(spec.nchannels) + " channels are not a picture", "use a grey, RGB or RGBA picture");
    }
    // Keeps the band of rows read at once under 256 MiB, whatever the header says.
    if (spec.tile_height > 1024) {
        (*this)("tiles of " + std::to_string(spec.tile_height) + " rows", "save it with smaller tiles or none");
    }
}

SquarePicture readPicture(const fs::path& file, const PictureRules& rules) {
    const Refusal refuse(file, rules);
    // Alpha as the file has it: to multiply and divide again would cost the colour of clear texels.
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file.string(), &config);
    if (input == nullptr) {
        std::error_code unknown;
        refuse(fs::exists(file, unknown) ? OIIO::geterror() : (OIIO::geterror(), std::string("no such file")),
               rules.formats);
    }
    const OIIO::ImageSpec spec = input->spec();
    refuse.checkSize(spec);
    const Channels channels = channelsOf(spec);
    // Row bands, so that memory grows with what the file really holds.
    const bool tiled = spec.tile_width > 0;
    const int band = std::min(spec.height, tiled ? spec.tile_height : 64);
    const auto width = static_cast<std::size_t>(spec.width);
    const auto depth = static_cast<std::size_t>(spec.nchannels);
    std::vector<Rgba> pixels;
    std::vector<float> rows(width * static_cast<std::size_t>(band) * depth);
    for (int y = 0; y < spec.height; y += band) {
        const int end = std::min(y + band, spec.height);
        const bool read = tiled ? input->read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + y, spec.y + end, spec.z,
                                                    spec.z + 1, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, rows.data())
                                : input->read_scanlines(0, 0, spec.y + y, spec.y + end, spec.z, 0, spec.nchannels,
                                                        OIIO::TypeDesc::FLOAT, rows.data());
        if (!read) {
            refuse(input->geterror(), "the file is damaged or cut short; get it again");
        }
        for (std::size_t i = 0; i < width * static_cast<std::size_t>(end - y); ++i) {
            pixels.push_back(rgbaOf(rows.data() + i * depth, channels));
        }
    }
    return {spec.width, std::move(pixels)};
}

} // namespace

SquarePicture readSquarePicture(const fs::path& file, const PictureRules& rules) {
    try {
        return readPicture(file, rules);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources, {rules.what, file.string(), "out of memory", "use a smaller picture"});
    }
}

} // namespace limner
