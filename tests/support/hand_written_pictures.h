#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace limner::testing {

/// Bytes in one order or the other.
inline void appendNumber(std::string& out, std::uint32_t value, int bytes, bool bigEndian) {
    for (int i = 0; i < bytes; ++i) {
        const int shift = 8 * (bigEndian ? bytes - 1 - i : i);
        out.push_back(static_cast<char>(value >> static_cast<unsigned>(shift)));
    }
}

/// A picture as its file is to say, by hand: the libraries under test have no part in it.
struct HandWritten {
    int width = 4;
    int height = 4;
    int bits = 8; ///< 8 or 16
    int channels = 4;
    std::vector<std::uint32_t> samples; ///< row by row, a pixel's channels together; may be missing
    std::string profile = {};
};

struct TiffTag {
    std::uint32_t id;
    std::uint32_t type; ///< 3: 16 bits, 4: 32 bits, 7: bytes
    std::vector<std::uint32_t> values;
};

/// A directory of tags that starts at `place` in its file, and the values that do not fit into it.
inline std::string tiffDirectory(const std::vector<TiffTag>& tags, std::size_t place) {
    std::string directory;
    std::string beyond;
    const std::size_t end = place + 2 + 12 * tags.size() + 4;
    appendNumber(directory, static_cast<std::uint32_t>(tags.size()), 2, false);
    for (const TiffTag& tag : tags) {
        std::string values;
        for (const std::uint32_t value : tag.values) {
            appendNumber(values, value, tag.type == 3 ? 2 : (tag.type == 4 ? 4 : 1), false);
        }
        appendNumber(directory, tag.id, 2, false);
        appendNumber(directory, tag.type, 2, false);
        appendNumber(directory, static_cast<std::uint32_t>(tag.values.size()), 4, false);
        if (values.size() <= 4) {
            values.resize(4);
            directory += values;
        } else {
            appendNumber(directory, static_cast<std::uint32_t>(end + beyond.size()), 4, false);
            values.resize((values.size() + 1) / 2 * 2);
            beyond += values;
        }
    }
    appendNumber(directory, 0, 4, false);
    return directory + beyond;
}

/// Little-endian, uncompressed. `photometric`: 1 grey, 2 RGB, 5 inks. `tile`: edge of its tiles, a divisor of the size;
/// 0: one strip.
inline std::string tiffOf(const HandWritten& picture, std::uint32_t photometric, int tile = 0) {
    using Numbers = std::vector<std::uint32_t>;
    const auto number = [](int value) { return static_cast<std::uint32_t>(value); };
    std::string pixels;
    Numbers offsets;
    const int across = tile > 0 ? tile : picture.width;
    const int down = tile > 0 ? tile : picture.height;
    for (int top = 0; top < picture.height; top += down) {
        for (int left = 0; left < picture.width; left += across) {
            offsets.push_back(static_cast<std::uint32_t>(8 + pixels.size()));
            for (int y = top; y < top + down && !picture.samples.empty(); ++y) {
                for (int i = left * picture.channels; i < (left + across) * picture.channels; ++i) {
                    const int at = y * picture.width * picture.channels + i;
                    appendNumber(pixels, picture.samples[static_cast<std::size_t>(at)], picture.bits / 8, false);
                }
            }
        }
    }
    const Numbers counts(offsets.size(), static_cast<std::uint32_t>(pixels.size() / offsets.size()));
    pixels.resize((pixels.size() + 1) / 2 * 2);
    std::vector<TiffTag> tags{{256, 4, {number(picture.width)}},
                              {257, 4, {number(picture.height)}},
                              {258, 3, Numbers(static_cast<std::size_t>(picture.channels), number(picture.bits))},
                              {259, 3, {1}},
                              {262, 3, {photometric}}};
    const std::vector<TiffTag> strips{
        {273, 4, offsets}, {277, 3, {number(picture.channels)}}, {278, 4, {number(picture.height)}}, {279, 4, counts}};
    const std::vector<TiffTag> tiles{{277, 3, {number(picture.channels)}},
                                     {322, 4, {number(tile)}},
                                     {323, 4, {number(tile)}},
                                     {324, 4, offsets},
                                     {325, 4, counts}};
    const auto& parts = tile > 0 ? tiles : strips;
    tags.insert(tags.end(), parts.begin(), parts.end());
    if (!picture.profile.empty()) {
        tags.push_back({34675, 7, Numbers(picture.profile.begin(), picture.profile.end())});
    }
    std::string out = "II";
    appendNumber(out, 42, 2, false);
    appendNumber(out, static_cast<std::uint32_t>(8 + pixels.size()), 4, false);
    return out + pixels + tiffDirectory(tags, 8 + pixels.size());
}

/// A Photoshop file of one flat picture. `mode`: 1 grey, 3 RGB, 4 CMYK, whose inks are stored upside down.
inline std::string psdOf(const HandWritten& picture, std::uint32_t mode) {
    std::string out = "8BPS";
    const auto put = [&](std::uint32_t value, int bytes) { appendNumber(out, value, bytes, true); };
    put(1, 2);
    out.append(6, '\0');
    put(static_cast<std::uint32_t>(picture.channels), 2);
    put(static_cast<std::uint32_t>(picture.height), 4);
    put(static_cast<std::uint32_t>(picture.width), 4);
    put(static_cast<std::uint32_t>(picture.bits), 2);
    put(mode, 2);
    put(0, 4); // no palette
    std::string resources;
    if (!picture.profile.empty()) {
        resources = "8BIM";
        appendNumber(resources, 1039, 2, true); // an ICC profile
        appendNumber(resources, 0, 2, true);
        appendNumber(resources, static_cast<std::uint32_t>(picture.profile.size()), 4, true);
        resources += picture.profile;
        resources.resize((resources.size() + 1) / 2 * 2);
    }
    put(static_cast<std::uint32_t>(resources.size()), 4);
    out += resources;
    put(0, 4); // no layers
    put(0, 2); // not compressed
    for (int c = 0; c < picture.channels; ++c) {
        for (std::size_t i = static_cast<std::size_t>(c); i < picture.samples.size();
             i += static_cast<std::size_t>(picture.channels)) {
            put(picture.samples[i], picture.bits / 8);
        }
    }
    return out;
}

inline std::filesystem::path writeBytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

} // namespace limner::testing
