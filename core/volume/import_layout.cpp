#include "core/volume/import_bytes.h"

#include <algorithm>
#include <fstream>

namespace limner::importing {

namespace {

std::uint64_t skipLines(const Context& context, const std::filesystem::path& file, std::uint64_t offset,
                        std::uint64_t lines) {
    if (lines == 0) {
        return offset;
    }
    std::ifstream in(file, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(offset));
    constexpr std::uint64_t kLongestSkip = 64 << 20; // headers of other programs are kilobytes
    for (std::uint64_t passed = 0; lines > 0; ++offset, ++passed) {
        const int c = in.get();
        if (c == std::ifstream::traits_type::eof() || passed > kLongestSkip) {
            context.refuse("its line skip leads past the end of " + file.filename().string());
        }
        lines -= c == '\n' ? 1 : 0;
    }
    return offset;
}

/// Text that must hold `count` numbers, each with a gap after it.
std::string dataText(const Context& context, const DataLayout& layout, const std::filesystem::path& file,
                     std::uint64_t count) {
    std::uint64_t offset = skipLines(context, file, layout.offset, layout.lineSkip);
    offset += static_cast<std::uint64_t>(std::max<std::int64_t>(layout.byteSkip, 0));
    const std::uint64_t length = fileLength(context, file);
    const std::uint64_t left = length - std::min(length, offset);
    constexpr std::uint64_t kLongestNumber = 64; // characters with gaps; the longest double takes 25
    if (left + 1 < 2 * count || (!layout.moreFollows && left > kLongestNumber * (count + 64))) {
        context.refuse("its header promises " + std::to_string(count) + " numbers, which " + std::to_string(left) +
                       " characters of text cannot be");
    }
    std::string text(left, '\0');
    std::ifstream in(file, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(offset));
    in.read(text.data(), static_cast<std::streamsize>(left));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    return text;
}

void parseHex(const Context& context, std::string_view text, std::span<std::byte> out) {
    int high = -1;
    std::size_t done = 0;
    for (const char c : text) {
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : -1;
        if (digit < 0 || done == out.size()) {
            continue;
        }
        if (high < 0) {
            high = digit;
        } else {
            out[done++] = static_cast<std::byte>(high * 16 + digit);
            high = -1;
        }
    }
    if (done < out.size()) {
        context.refuse("its hexadecimal data end after " + std::to_string(done) + " of " + std::to_string(out.size()) +
                       " bytes");
    }
}

void readBinary(const Context& context, const DataLayout& layout, const std::filesystem::path& file,
                std::uint64_t promised, std::span<std::byte> out) {
    std::uint64_t offset = skipLines(context, file, layout.offset, layout.lineSkip);
    if (layout.byteSkip == -1) {
        const std::uint64_t length = fileLength(context, file);
        if (layout.compression != Compression::none || length < promised) {
            context.refuse("the last " + std::to_string(promised) + " bytes of " + file.filename().string() +
                           " should be the data; it has " + std::to_string(length));
        }
        offset = length - promised;
    }
    auto stream = openStream(context, file, layout.compression, offset);
    const auto skip = static_cast<std::uint64_t>(std::max<std::int64_t>(layout.byteSkip, 0));
    expectBytes(context, *stream, promised + skip);
    skipBytes(context, *stream, skip);
    readAll(context, *stream, out);
}

/// A printf pattern with one %d. Refuses anything else.
std::string numbered(const Context& context, std::string_view pattern, std::int64_t number) {
    const std::size_t percent = pattern.find('%');
    std::size_t end = percent == std::string_view::npos ? percent : percent + 1;
    std::size_t width = 0;
    bool zeros = false;
    while (end < pattern.size() && pattern[end] >= '0' && pattern[end] <= '9' && width < 10) {
        zeros = zeros || (width == 0 && pattern[end] == '0');
        width = width * 10 + static_cast<std::size_t>(pattern[end] - '0');
        ++end;
    }
    const bool sound = end < pattern.size() && (pattern[end] == 'd' || pattern[end] == 'i' || pattern[end] == 'u') &&
                       width < 32 && pattern.find('%', end) == std::string_view::npos;
    if (!sound) {
        context.refuse("its file pattern '" + std::string(pattern.substr(0, 80)) + "' is none like slice%03d.raw");
    }
    std::string digits = std::to_string(number);
    if (digits.size() < width) {
        digits.insert(0, width - digits.size(), zeros ? '0' : ' ');
    }
    return std::string(pattern.substr(0, percent)) + digits + std::string(pattern.substr(end + 1));
}

} // namespace

std::vector<std::filesystem::path> numberedFiles(const Context& context, std::string_view pattern) {
    const auto parts = words(pattern);
    const auto part = [&](std::size_t i, std::int64_t otherwise) {
        return i < parts.size() ? parseInteger(parts[i]).value_or(0) : otherwise;
    };
    const std::int64_t first = part(1, 0);
    const std::int64_t last = part(2, -1);
    const std::int64_t step = part(3, 1);
    constexpr std::int64_t kLargestNumber = 1000000000;
    const bool sound = step != 0 && std::max({std::abs(first), std::abs(last), std::abs(step)}) <= kLargestNumber;
    if (!sound || (last - first) / step < 0 || (last - first) / step >= kLargestAxis || (last - first) * step < 0) {
        context.refuse("its data file pattern '" + std::string(pattern.substr(0, 80)) + "' names no sequence of files");
    }
    std::vector<std::filesystem::path> files;
    for (std::int64_t n = first; step > 0 ? n <= last : n >= last; n += step) {
        files.push_back(dataFile(context, numbered(context, parts[0], n)));
    }
    return files;
}

ByteBuffer readNumbers(const Context& context, const DataLayout& layout, ScalarType type, std::uint64_t count,
                       std::uint64_t total) {
    const std::size_t width = bytesPerScalar(type);
    const std::uint64_t files = layout.files.size();
    if (files == 0 || total % files != 0) {
        context.refuse(std::to_string(total) + " voxels cannot be shared by " + std::to_string(files) + " data files");
    }
    const std::uint64_t perFile = total / files;
    // Every file is looked at before anything is allocated.
    for (const auto& file : layout.files) {
        const std::uint64_t length = fileLength(context, file);
        if (layout.text == DataLayout::Text::hex && length / 2 < perFile * width) {
            context.refuse("the header promises " + std::to_string(perFile * width) + " bytes, " +
                           file.filename().string() + " is too short for them");
        }
        if (layout.text == DataLayout::Text::binary) {
            expectBytes(context, *openStream(context, file, layout.compression, std::min(layout.offset, length)),
                        perFile * width);
        } else if (length + 1 < perFile * 2) {
            context.refuse("the header promises " + std::to_string(perFile) + " numbers, " + file.filename().string() +
                           " is too short for them");
        }
    }
    ByteBuffer numbers(count * width);
    std::uint64_t done = 0;
    for (const auto& file : layout.files) {
        if (done >= count) {
            break;
        }
        const std::uint64_t part = std::min(perFile, count - done);
        const auto out = numbers.span().subspan(done * width, part * width);
        if (layout.text == DataLayout::Text::binary) {
            readBinary(context, layout, file, perFile * width, out);
        } else {
            const bool hex = layout.text == DataLayout::Text::hex;
            const std::string text = dataText(context, layout, file, hex ? perFile * width : perFile);
            if (hex) {
                parseHex(context, text, out);
            } else {
                parseAscii(context, text, type, out);
            }
        }
        done += part;
    }
    if (layout.swapped && layout.text != DataLayout::Text::ascii) {
        swapBytes(numbers.span(), width);
    }
    return numbers;
}

} // namespace limner::importing
