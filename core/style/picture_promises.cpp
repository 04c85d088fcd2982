#include "core/style/picture_promises.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr std::array<char, 4> kPhotoshop{'8', 'B', 'P', 'S'};
constexpr std::array<char, 4> kOpenExr{'\x76', '\x2f', '\x31', '\x01'};

/// "8BPS", and at 24 the colour mode (4 is CMYK), at 26 how long the table of colours is, both big-endian.
void readPhotoshop(std::istream& stream, std::uintmax_t length, PicturePromises& promises) {
    std::array<char, 26> rest{};
    if (!stream.read(rest.data(), rest.size())) {
        return;
    }
    promises.photoshopInks = rest[20] == 0 && rest[21] == 4;
    std::uintmax_t colours = 0;
    for (std::size_t i = 22; i < rest.size(); ++i) {
        colours = colours << 8U | static_cast<unsigned char>(rest[i]);
    }
    if (colours > length) {
        promises.broken = "its table of colours is longer than the file";
    }
}

/// After the version, attributes: a name, a type, how many bytes follow (little-endian), and those; an empty name ends
/// the header.
void readOpenExr(std::istream& stream, std::uintmax_t length, PicturePromises& promises) {
    stream.ignore(4);
    const auto readText = [&] {
        std::string text;
        std::getline(stream, text, '\0');
        return text;
    };
    while (stream) {
        const std::string name = readText();
        if (name.empty()) {
            return;
        }
        readText();
        std::array<char, 4> bytes{};
        if (!stream.read(bytes.data(), bytes.size())) {
            return;
        }
        std::uintmax_t size = 0;
        for (std::size_t i = bytes.size(); i-- > 0;) {
            size = size << 8U | static_cast<unsigned char>(bytes[i]);
        }
        if (size > length) {
            promises.broken = "a part of its header is longer than the file";
            return;
        }
        stream.ignore(static_cast<std::streamsize>(size));
    }
}

} // namespace

PicturePromises promisesOf(const fs::path& file) {
    PicturePromises promises;
    std::error_code unknown;
    const std::uintmax_t length = fs::file_size(file, unknown);
    std::ifstream stream(file, std::ios::binary);
    std::array<char, 4> magic{};
    if (unknown || !stream.read(magic.data(), magic.size())) {
        return promises;
    }
    if (magic == kPhotoshop) {
        readPhotoshop(stream, length, promises);
    } else if (magic == kOpenExr) {
        readOpenExr(stream, length, promises);
    }
    return promises;
}

} // namespace limner
