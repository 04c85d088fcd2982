#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

namespace limner::testing {

/// An entry as the bytes of a zip say it, true or not.
struct RawEntry {
    std::string name;
    std::string data;       ///< as it lies in the file
    std::uint32_t size = 0; ///< unpacked, as claimed
    std::uint32_t crc = 0;
    std::uint16_t method = 0; ///< 0 stored, 8 deflate
    std::uint16_t flags = 0;
    std::uint32_t attributes = 0; ///< external; the Unix mode in the upper half
    long sharedOffset = -1;       ///< >= 0: no data of its own, points at that local header
};

inline RawEntry storedEntry(const std::string& name, const std::string& data) {
    RawEntry entry;
    entry.name = name;
    entry.data = data;
    entry.size = static_cast<std::uint32_t>(data.size());
    entry.crc = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(data.data()), static_cast<uInt>(data.size())));
    return entry;
}

inline RawEntry deflatedEntry(const std::string& name, const std::string& data) {
    RawEntry entry = storedEntry(name, data);
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
    entry.data.resize(deflateBound(&stream, data.size()));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
    stream.avail_in = static_cast<uInt>(data.size());
    stream.next_out = reinterpret_cast<Bytef*>(entry.data.data());
    stream.avail_out = static_cast<uInt>(entry.data.size());
    deflate(&stream, Z_FINISH);
    entry.data.resize(stream.total_out);
    deflateEnd(&stream);
    entry.method = 8;
    return entry;
}

/// Bytes of a zip, little-endian, written as asked for and not as it should be.
inline std::string zipBytes(const std::vector<RawEntry>& entries, std::uint16_t claimedCount = 0) {
    std::string bytes;
    std::string directory;
    const auto put = [](std::string& text, std::uint64_t value, int count) {
        for (int i = 0; i < count; ++i) {
            text += static_cast<char>(value >> (8 * i));
        }
    };
    const auto common = [&](std::string& text, const RawEntry& entry) {
        put(text, 20, 2);
        put(text, entry.flags, 2);
        put(text, entry.method, 2);
        put(text, 0x21, 4); // a date
        put(text, entry.crc, 4);
        put(text, entry.data.size(), 4);
        put(text, entry.size, 4);
        put(text, entry.name.size(), 2);
        put(text, 0, 2);
    };
    for (const RawEntry& entry : entries) {
        const std::size_t offset =
            entry.sharedOffset >= 0 ? static_cast<std::size_t>(entry.sharedOffset) : bytes.size();
        if (entry.sharedOffset < 0) {
            bytes += "PK\x03\x04";
            common(bytes, entry);
            bytes += entry.name + entry.data;
        }
        directory += "PK\x01\x02";
        put(directory, 0x031e, 2); // made by Unix
        common(directory, entry);
        put(directory, 0, 6);
        put(directory, entry.attributes, 4);
        put(directory, offset, 4);
        directory += entry.name;
    }
    const std::size_t start = bytes.size();
    const std::size_t count = claimedCount != 0 ? claimedCount : entries.size();
    bytes += directory + "PK\x05\x06";
    put(bytes, 0, 4);
    put(bytes, count, 2);
    put(bytes, count, 2);
    put(bytes, directory.size(), 4);
    put(bytes, start, 4);
    put(bytes, 0, 2);
    return bytes;
}

} // namespace limner::testing
