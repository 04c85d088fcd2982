#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"
#include "core/volume/import_xml.h"

#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>
#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <map>
#include <utility>

// VTK XML image data (.vti), one piece.

namespace limner::importing {

namespace {

struct VtiArray {
    std::string name;
    std::string type;
    std::string format;
    std::int64_t components = 1;
    std::uint64_t offset = 0;
    bool ofCells = false;
    std::string text; ///< of inline arrays
};

struct VtiHeader {
    bool bigEndian = false;
    bool wideHeader = false; ///< UInt64 block headers
    std::string compressor;
    std::vector<double> extent;
    std::vector<double> pieceExtent;
    std::vector<double> origin;
    std::vector<double> spacing;
    std::vector<double> direction;
    std::string wanted; ///< name of the active scalars
    std::vector<VtiArray> arrays;
    int pieces = 0;
    bool isImage = false;
    bool base64Appended = false;
    std::uint64_t appendedAt = 0; ///< byte of the file after "_"; 0: none
};

class VtiParser {
  public:
    explicit VtiParser(VtiHeader& header) : header_(header) {}

    bool parse(const std::string& xml) {
        XmlHandler handler;
        handler.started = [this](const XmlElement& element) { start(element); };
        handler.text = [this](std::string_view text) {
            if (inArray_) {
                header_.arrays.back().text += text;
            }
        };
        handler.ended = [this](std::string_view name) {
            inArray_ = inArray_ && name != "DataArray";
            if (name == "PointData" || name == "CellData") {
                section_.clear();
            }
        };
        return parseXml(xml, handler);
    }

  private:
    void start(const XmlElement& element) {
        if (element.name == "VTKFile") {
            header_.isImage = element.attribute("type") == "ImageData";
            header_.bigEndian = element.attribute("byte_order") == "BigEndian";
            header_.wideHeader = element.attribute("header_type") == "UInt64";
            header_.compressor = element.attribute("compressor");
        } else if (element.name == "ImageData") {
            header_.extent = parseNumbers(element.attribute("WholeExtent"));
            header_.origin = parseNumbers(element.attribute("Origin"));
            header_.spacing = parseNumbers(element.attribute("Spacing"));
            header_.direction = parseNumbers(element.attribute("Direction"));
        } else if (element.name == "Piece") {
            ++header_.pieces;
            header_.pieceExtent = parseNumbers(element.attribute("Extent"));
        } else if (element.name == "PointData" || element.name == "CellData") {
            section_ = element.name;
            if (header_.wanted.empty()) {
                header_.wanted = element.attribute("Scalars");
            }
        } else if (element.name == "DataArray" && !section_.empty()) {
            VtiArray array;
            array.name = element.attribute("Name");
            array.type = element.attribute("type");
            array.format = element.attribute("format");
            const auto components = element.attribute("NumberOfComponents");
            array.components = components.empty() ? 1 : parseInteger(components).value_or(0);
            array.offset = static_cast<std::uint64_t>(
                std::max<std::int64_t>(0, parseInteger(element.attribute("offset")).value_or(0)));
            array.ofCells = section_ == "CellData";
            header_.arrays.push_back(std::move(array));
            inArray_ = header_.arrays.back().format != "appended";
        }
    }

    VtiHeader& header_;
    std::string section_;
    bool inArray_ = false;
};

std::string readFile(const Context& context) {
    const std::uint64_t length = fileLength(context, context.path);
    if (length > context.budget) {
        context.refuse("the file is larger than the memory allowed");
    }
    return readText(context, context.path, length);
}

VtiHeader parseHeader(const Context& context, const std::string& file) {
    VtiHeader header;
    std::string xml;
    const std::size_t appended = file.find("<AppendedData");
    if (appended != std::string::npos) {
        const std::size_t mark = file.find('>', appended);
        const std::size_t underscore = mark == std::string::npos ? mark : file.find_first_not_of(" \t\r\n", mark + 1);
        if (underscore == std::string::npos || file[underscore] != '_') {
            context.refuse("its appended data have no beginning");
        }
        header.base64Appended = file.substr(appended, mark - appended).find("base64") != std::string::npos;
        header.appendedAt = underscore + 1;
        xml = file.substr(0, appended) + "</VTKFile>";
    }
    if (!VtiParser(header).parse(xml.empty() ? file : xml)) {
        context.refuse("its XML is damaged");
    }
    return header;
}

int base64Digit(char c) {
    if (c >= 'A' && c <= 'Z') {
        return c - 'A';
    }
    if (c >= 'a' && c <= 'z') {
        return c - 'a' + 26;
    }
    if (c >= '0' && c <= '9') {
        return c - '0' + 52;
    }
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Decodes one base64 run up to its padding, a character that is none, or `most` bytes; moves `text` past it.
std::vector<std::byte> decodeBase64(std::string_view& text, std::size_t most) {
    std::vector<std::byte> bytes;
    bytes.reserve(std::min(most, text.size() / 4 * 3 + 3));
    std::uint32_t bits = 0;
    int held = 0;
    std::size_t i = 0;
    for (; i < text.size() && bytes.size() < most; ++i) {
        const int digit = base64Digit(text[i]);
        if (digit < 0) {
            if (text[i] == ' ' || text[i] == '\n' || text[i] == '\r' || text[i] == '\t') {
                continue;
            }
            break;
        }
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        held += 6;
        if (held >= 8) {
            held -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> held & 0xff));
        }
    }
    while (i < text.size() && text[i] == '=') {
        ++i;
    }
    text.remove_prefix(i);
    return bytes;
}

/// The encoded bytes of an array: headers first, then data; base64 is undone.
struct Encoded {
    std::vector<std::byte> decoded; ///< owns what base64 gave
    std::span<const std::byte> bytes;
};

Encoded encodedOf(const Context& context, const VtiHeader& header, const VtiArray& array, const std::string& file) {
    Encoded encoded;
    std::string_view text;
    if (array.format == "appended") {
        if (header.appendedAt == 0 || array.offset > file.size() - header.appendedAt) {
            context.refuse("its appended data end before an array begins");
        }
        text = std::string_view(file).substr(header.appendedAt + array.offset);
        if (!header.base64Appended) {
            encoded.bytes = std::as_bytes(std::span(text));
            return encoded;
        }
    } else {
        text = trimmed(array.text);
    }
    // Compressed arrays are two base64 runs: the header ends in padding of its own or at a multiple of three bytes.
    const std::size_t word_ = header.wideHeader ? 8 : 4;
    if (header.compressor.empty()) {
        encoded.decoded = decodeBase64(text, std::numeric_limits<std::size_t>::max());
    } else {
        std::string_view peek = text;
        const auto first = decodeBase64(peek, word_);
        if (first.size() < word_) {
            context.refuse("its compressed data are cut off");
        }
        const std::uint64_t blocks = word_ == 8 ? word<std::uint64_t>(first, 0, header.bigEndian)
                                                : word<std::uint32_t>(first, 0, header.bigEndian);
        if (blocks > text.size()) {
            context.refuse("its compressed data promise more blocks than the file holds");
        }
        const std::size_t headerBytes = (3 + blocks) * word_;
        const std::size_t headerText = (headerBytes + 2) / 3 * 4;
        std::string_view headerPart = text.substr(0, headerText);
        encoded.decoded = decodeBase64(headerPart, headerBytes);
        text.remove_prefix(std::min(headerText, text.size()));
        const auto body = decodeBase64(text, std::numeric_limits<std::size_t>::max());
        if (encoded.decoded.size() < headerBytes) {
            context.refuse("its compressed data are cut off");
        }
        encoded.decoded.insert(encoded.decoded.end(), body.begin(), body.end());
    }
    encoded.bytes = encoded.decoded;
    return encoded;
}

struct Block {
    std::uint64_t from = 0; ///< in the encoded bytes
    std::uint64_t length = 0;
    std::uint64_t to = 0; ///< in the values
    std::uint64_t size = 0;
};

std::vector<Block> blocksOf(const Context& context, const VtiHeader& header, std::span<const std::byte> bytes,
                            std::uint64_t total) {
    const std::size_t width = header.wideHeader ? 8 : 4;
    const auto number = [&](std::uint64_t i) -> std::uint64_t {
        const std::size_t at = static_cast<std::size_t>(i) * width;
        return width == 8 ? word<std::uint64_t>(bytes, at, header.bigEndian)
                          : word<std::uint32_t>(bytes, at, header.bigEndian);
    };
    if (bytes.size() < 3 * width) {
        context.refuse("its compressed data are cut off");
    }
    const std::uint64_t count = number(0);
    const std::uint64_t size = number(1);
    const std::uint64_t lastSize = number(2) == 0 ? size : number(2);
    if (count == 0 || count > bytes.size() / width - 3 || size == 0 || size > total || lastSize > size ||
        (count - 1) > total / size || (count - 1) * size + lastSize != total) {
        context.refuse("its compressed blocks do not add up to its extent");
    }
    std::vector<Block> blocks;
    std::uint64_t from = (3 + count) * width;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t length = number(3 + i);
        const std::uint64_t blockSize = i + 1 < count ? size : lastSize;
        constexpr std::uint64_t kDeflateRatio = 1032; // deflate cannot do better
        if (length > bytes.size() - from || blockSize > (length + 16) * kDeflateRatio) {
            context.refuse("its compressed data are cut off");
        }
        blocks.push_back({from, length, i * size, blockSize});
        from += length;
    }
    return blocks;
}

ByteBuffer inflateBlocks(const Context& context, std::span<const std::byte> bytes, const std::vector<Block>& blocks,
                         std::uint64_t total) {
    ByteBuffer values(total);
    std::atomic<bool> damaged{false};
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
        const Block& block = blocks[i];
        if (damaged || context.task.cancelled()) {
            return;
        }
        uLongf made = block.size;
        const int state = uncompress(reinterpret_cast<Bytef*>(values.data() + block.to), &made,
                                     reinterpret_cast<const Bytef*>(bytes.data() + block.from), block.length);
        if (state != Z_OK || made != block.size) {
            damaged = true;
        }
    });
    context.task.throwIfCancelled();
    if (damaged) {
        context.refuse("its compressed data are damaged", "copy or export the file anew");
    }
    return values;
}

ByteBuffer readValues(const Context& context, const VtiHeader& header, const VtiArray& array, const std::string& file,
                      std::pair<ScalarType, std::uint64_t> shape) {
    const auto [type, count] = shape;
    const std::uint64_t total = count * bytesPerScalar(type);
    if (array.format == "ascii") {
        if (array.text.size() + 1 < 2 * count) {
            context.refuse("its text is too short for " + std::to_string(count) + " numbers");
        }
        ByteBuffer values(total);
        parseAscii(context, array.text, type, values.span());
        return values;
    }
    const Encoded encoded = encodedOf(context, header, array, file);
    ByteBuffer values;
    if (!header.compressor.empty()) {
        values = inflateBlocks(context, encoded.bytes, blocksOf(context, header, encoded.bytes, total), total);
    } else {
        const std::size_t width = header.wideHeader ? 8 : 4;
        if (encoded.bytes.size() < width || encoded.bytes.size() - width < total) {
            context.refuse("its extent promises " + std::to_string(total) + " bytes, the file does not hold them");
        }
        const std::uint64_t said = width == 8 ? word<std::uint64_t>(encoded.bytes, 0, header.bigEndian)
                                              : word<std::uint32_t>(encoded.bytes, 0, header.bigEndian);
        if (said != total) {
            context.refuse("its extent and the length of its data do not fit together");
        }
        values = ByteBuffer(total);
        std::copy_n(encoded.bytes.begin() + static_cast<std::ptrdiff_t>(width), total, values.data());
    }
    if (header.bigEndian) {
        swapBytes(values.span(), bytesPerScalar(type));
    }
    return values;
}

const VtiArray& chooseArray(const Context& context, const VtiHeader& header) {
    if (header.arrays.empty()) {
        context.refuse("it holds no array of values");
    }
    const auto named = std::find_if(header.arrays.begin(), header.arrays.end(),
                                    [&](const VtiArray& array) { return array.name == header.wanted; });
    const VtiArray& array = named != header.arrays.end() ? *named : header.arrays.front();
    if (header.arrays.size() > 1) {
        context.warn("of " + std::to_string(header.arrays.size()) + " arrays, '" + array.name.substr(0, 60) +
                     "' was read");
    }
    return array;
}

ScalarType typeOf(const Context& context, const VtiArray& array) {
    static const std::map<std::string, ScalarType> kTypes = {
        {"Int8", ScalarType::int8},      {"UInt8", ScalarType::uint8},   {"Int16", ScalarType::int16},
        {"UInt16", ScalarType::uint16},  {"Int32", ScalarType::int32},   {"UInt32", ScalarType::uint32},
        {"Int64", ScalarType::int64},    {"UInt64", ScalarType::uint64}, {"Float32", ScalarType::float32},
        {"Float64", ScalarType::float64}};
    const auto found = kTypes.find(array.type);
    if (found == kTypes.end()) {
        context.refuse("its type '" + array.type.substr(0, 40) + "' is none that Limner reads");
    }
    return found->second;
}

/// Sizes of the grid, and its geometry: origin and spacing belong to the point with index 0, which the extent may not
/// hold.
std::array<std::int64_t, 3> place(const Context& context, const VtiHeader& header, bool cells, StoredVolume& stored) {
    std::array<std::int64_t, 3> dims{};
    glm::dvec3 first(0);
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double low = header.extent[2 * n];
        const double high = header.extent[2 * n + 1];
        constexpr double kFarthest = 1e9; // fits an int; checkedDims has the last word on the size
        const bool sound = std::abs(low) < kFarthest && std::abs(high) < kFarthest && high >= low;
        dims[n] = sound ? static_cast<std::int64_t>(high - low) + 1 : 0;
        first[i] = sound ? low : 0;
        if (cells && dims[n] > 1) {
            --dims[n];
            first[i] += 0.5;
        }
    }
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double spacing = header.spacing.size() == 3 ? header.spacing[n] : 1;
        checkSpacing(context, spacing);
        glm::dvec3 axis(0);
        axis[i] = 1;
        if (header.direction.size() == 9) { // rows of the matrix; its columns are the axes
            axis = {header.direction[n], header.direction[3 + n], header.direction[6 + n]};
        }
        stored.axesMm[i] = axis * spacing;
    }
    const glm::dvec3 origin =
        header.origin.size() == 3 ? glm::dvec3(header.origin[0], header.origin[1], header.origin[2]) : glm::dvec3(0);
    stored.originMm = origin + stored.axesMm * first;
    return dims;
}

} // namespace

StoredVolume readVti(Context& context) {
    const std::string file = readFile(context);
    const VtiHeader header = parseHeader(context, file);
    if (!header.isImage || header.extent.size() != 6) {
        context.refuse("it holds no image data with an extent");
    }
    if (header.pieces != 1 || header.pieceExtent != header.extent) {
        context.refuse("it is split into pieces", "write it as one piece");
    }
    if (!header.compressor.empty() && header.compressor != "vtkZLibDataCompressor") {
        context.refuse("its compressor '" + header.compressor.substr(0, 40) + "' is none that Limner reads",
                       "write it with zlib or uncompressed");
    }
    const VtiArray& array = chooseArray(context, header);
    StoredVolume stored;
    stored.type = typeOf(context, array);
    const auto dims = place(context, header, array.ofCells, stored);
    const std::array<std::int64_t, 4> all = {dims[0], dims[1], dims[2], array.components};
    const std::uint64_t count = checkedVoxels(context, all, stored.type);
    stored.dims = checkedDims(context, dims, stored.type);
    const auto components = static_cast<std::uint64_t>(array.components);
    expectComponents(context, components, std::to_string(components) + " components per voxel");
    checkGeometry(context, stored);
    stored.values = readValues(context, header, array, file, {stored.type, count});
    keepFirstComponent(stored, components);
    context.report.format = "VTI";
    return stored;
}

} // namespace limner::importing
