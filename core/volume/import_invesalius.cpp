#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"
#include "core/volume/import_xml.h"

#include <algorithm>
#include <map>
#include <utility>

// InVesalius projects (.inv3): a gzip tar of main.plist (XML) and a raw matrix whose rows run from the back to the
// front.

namespace limner::importing {

namespace {

constexpr std::uint64_t kTarBlock = 512;

struct TarEntry {
    std::string name; ///< without folders
    std::uint64_t size = 0;
    bool isFile = false;
};

/// Walks a tar archive entry by entry.
class TarReader {
  public:
    explicit TarReader(const Context& context)
        : context_(context), stream_(openStream(context, context.path,
                                                startsAsGzip(context.path) ? Compression::gzip : Compression::none)) {}

    std::optional<TarEntry> next() {
        skipBytes(context_, *stream_, left_ + padding_);
        left_ = padding_ = 0;
        constexpr int kMostEntries = 10000; // a project has a dozen
        std::array<std::byte, kTarBlock> header;
        if (++entries_ > kMostEntries || stream_->read(header) < header.size() || header[0] == std::byte{0}) {
            return std::nullopt;
        }
        const char* text = reinterpret_cast<const char*>(header.data());
        TarEntry entry;
        std::string path(text, std::find(text, text + 100, '\0'));
        entry.name = path.substr(path.find_last_of('/') + 1);
        for (int i = 0; i < 12; ++i) {
            const char digit = text[124 + i];
            if (digit >= '0' && digit <= '7') {
                entry.size = entry.size * 8 + static_cast<std::uint64_t>(digit - '0');
            }
        }
        entry.isFile = text[156] == '0' || text[156] == '\0';
        // A size that the whole file cannot inflate to is a lie.
        if (entry.size > stream_->atMost()) {
            context_.refuse("its archive promises a file of " + std::to_string(entry.size) +
                            " bytes that it cannot hold");
        }
        left_ = entry.size;
        padding_ = (kTarBlock - entry.size % kTarBlock) % kTarBlock;
        return entry;
    }

    void read(std::span<std::byte> out) {
        readAll(context_, *stream_, out);
        left_ -= out.size();
    }

  private:
    const Context& context_;
    std::unique_ptr<ByteStream> stream_;
    std::uint64_t left_ = 0;
    std::uint64_t padding_ = 0;
    int entries_ = 0;
};

/// A property list, flat: "matrix/shape/0" -> "108".
std::map<std::string, std::string> parsePlist(const Context& context, const std::string& xml) {
    std::map<std::string, std::string> values;
    struct Level {
        bool isArray = false;
        int next = 0;
        std::string key;
    };
    std::vector<Level> levels;
    std::string text;
    const auto path = [&] {
        std::string joined;
        for (const Level& level : levels) {
            joined += (joined.empty() ? "" : "/") + (level.isArray ? std::to_string(level.next) : level.key);
        }
        return joined;
    };
    XmlHandler handler;
    handler.started = [&](const XmlElement& element) {
        text.clear();
        if (element.name == "dict" || element.name == "array") {
            levels.push_back({element.name == "array", 0, {}});
        }
    };
    handler.text = [&](std::string_view piece) { text += piece; };
    handler.ended = [&](std::string_view name) {
        if (name == "key" && !levels.empty()) {
            levels.back().key = text;
            return;
        }
        if (name == "dict" || name == "array") {
            levels.pop_back();
        } else if (name != "plist" && !levels.empty()) {
            values[path()] = text;
        }
        if (!levels.empty() && levels.back().isArray) {
            ++levels.back().next;
        }
    };
    if (!parseXml(xml, handler)) {
        context.refuse("its main.plist is damaged XML");
    }
    return values;
}

std::map<std::string, std::string> readMain(const Context& context) {
    TarReader archive(context);
    while (const auto entry = archive.next()) {
        if (entry->name != "main.plist" || !entry->isFile) {
            continue;
        }
        constexpr std::uint64_t kLongest = 4 << 20; // real ones are kilobytes
        if (entry->size > kLongest) {
            context.refuse("its main.plist is too long");
        }
        std::string xml(entry->size, '\0');
        archive.read(std::as_writable_bytes(std::span(xml)));
        return parsePlist(context, xml);
    }
    context.refuse("it is no InVesalius project: main.plist is missing");
}

ScalarType typeOf(const Context& context, const std::string& name) {
    for (const ScalarType type : {ScalarType::uint8, ScalarType::int8, ScalarType::uint16, ScalarType::int16,
                                  ScalarType::int32, ScalarType::float32, ScalarType::float64}) {
        if (name == nameOf(type)) {
            return type;
        }
    }
    context.refuse("its matrix type '" + name.substr(0, 40) + "' is none that Limner reads");
}

/// Turns the rows round: file order is back to front, LPS front to back.
void flipRows(StoredVolume& stored) {
    const std::size_t row = static_cast<std::size_t>(stored.dims.x) * bytesPerScalar(stored.type);
    const auto rows = static_cast<std::size_t>(stored.dims.y);
    std::byte* data = stored.values.data();
    for (std::size_t z = 0; z < static_cast<std::size_t>(stored.dims.z); ++z) {
        std::byte* slice = data + z * rows * row;
        for (std::size_t y = 0; y < rows / 2; ++y) {
            std::swap_ranges(slice + y * row, slice + (y + 1) * row, slice + (rows - 1 - y) * row);
        }
    }
}

} // namespace

StoredVolume readInvesalius(Context& context) {
    const auto plist = readMain(context);
    const auto value = [&](const std::string& key) {
        const auto found = plist.find(key);
        return found == plist.end() ? std::string() : found->second;
    };
    StoredVolume stored;
    stored.type = typeOf(context, value("matrix/dtype"));
    std::array<std::int64_t, 3> dims{};
    for (std::size_t i = 0; i < 3; ++i) { // the shape is z, y, x
        dims[2 - i] = parseInteger(value("matrix/shape/" + std::to_string(i))).value_or(0);
    }
    const std::uint64_t bytes = checkedVoxels(context, dims, stored.type) * bytesPerScalar(stored.type);
    stored.dims = checkedDims(context, dims, stored.type);
    for (int i = 0; i < 3; ++i) {
        const auto spacing = parseNumber(value("spacing/" + std::to_string(i)));
        checkSpacing(context, spacing.value_or(0));
        stored.axesMm[i] *= *spacing;
    }
    const std::string modality = lowered(value("modality"));
    stored.modalityKnown = modality == "ct" || modality == "mri" || modality == "mr";
    stored.modality = modality == "ct" ? Modality::ct : stored.modalityKnown ? Modality::mr : Modality::unknown;

    const std::string matrix = value("matrix/filename");
    TarReader archive(context);
    while (const auto entry = archive.next()) {
        if (entry->name != matrix || !entry->isFile) {
            continue;
        }
        if (entry->size != bytes) {
            context.refuse("its matrix has " + std::to_string(entry->size) + " bytes, its shape asks for " +
                           std::to_string(bytes));
        }
        stored.values = ByteBuffer(bytes);
        archive.read(stored.values.span());
        flipRows(stored);
        context.report.format = "InVesalius project";
        return stored;
    }
    context.refuse("its matrix '" + matrix.substr(0, 60) + "' is missing");
}

} // namespace limner::importing
