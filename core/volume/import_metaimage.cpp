#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"

#include <algorithm>
#include <cmath>
#include <map>

// MetaImage (.mha, .mhd): keys and values in text, LPS space.

namespace limner::importing {

namespace {

struct MetaHeader {
    std::map<std::string, std::string> keys; ///< in lower case
    std::vector<std::string> dataFiles;      ///< lines after "ElementDataFile = LIST"
    std::uint64_t length = 0;                ///< bytes up to local data

    [[nodiscard]] std::string value(std::initializer_list<const char*> names) const {
        for (const char* name : names) {
            if (const auto found = keys.find(name); found != keys.end()) {
                return found->second;
            }
        }
        return {};
    }
    [[nodiscard]] bool isTrue(std::initializer_list<const char*> names, bool otherwise) const {
        const std::string text = lowered(value(names));
        return text.empty() ? otherwise : text.front() == 't' || text.front() == 'y' || text.front() == '1';
    }
};

MetaHeader readHeader(const Context& context) {
    constexpr std::size_t kLongest = 4 << 20; // lists of slices take kilobytes
    const std::string text = headOf(context.path, kLongest);
    MetaHeader header;
    std::size_t at = 0;
    bool list = false;
    while (at < text.size()) {
        std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = trimmed(std::string_view(text).substr(at, end - at));
        at = std::min(end + 1, text.size());
        if (list) {
            if (!line.empty()) {
                header.dataFiles.emplace_back(line);
            }
            continue;
        }
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) {
            continue;
        }
        const std::string key = lowered(trimmed(line.substr(0, equals)));
        header.keys[key] = trimmed(line.substr(equals + 1));
        if (key == "elementdatafile") {
            header.length = at;
            list = header.keys[key].starts_with("LIST");
            if (!list) {
                return header;
            }
        }
    }
    if (header.length == 0) {
        context.refuse("its header does not say where the data are (ElementDataFile)");
    }
    return header;
}

ScalarType typeOf(const Context& context, const MetaHeader& header) {
    static const std::map<std::string, ScalarType> kTypes = {
        {"met_char", ScalarType::int8},       {"met_uchar", ScalarType::uint8},
        {"met_short", ScalarType::int16},     {"met_ushort", ScalarType::uint16},
        {"met_int", ScalarType::int32},       {"met_uint", ScalarType::uint32},
        {"met_long", ScalarType::int32},      {"met_ulong", ScalarType::uint32}, // four bytes, whatever the machine
        {"met_long_long", ScalarType::int64}, {"met_ulong_long", ScalarType::uint64},
        {"met_float", ScalarType::float32},   {"met_double", ScalarType::float64}};
    std::string name = lowered(header.value({"elementtype"}));
    if (name.ends_with("_array")) {
        name.resize(name.size() - 6);
    }
    const auto found = kTypes.find(name);
    if (found == kTypes.end()) {
        context.refuse("its element type '" + name.substr(0, 40) + "' is none that Limner reads");
    }
    return found->second;
}

void place(Context& context, const MetaHeader& header, std::size_t rank, StoredVolume& stored) {
    const auto matrix = parseNumbers(header.value({"transformmatrix", "rotation", "orientation"}));
    const auto origin = parseNumbers(header.value({"offset", "position", "origin"}));
    const std::string text = header.value({"elementspacing", "elementsize"});
    const auto spacing = parseNumbers(text);
    if (text.empty()) {
        context.warn("the file gives no spacing; 1 mm was taken");
    } else if (spacing.size() < std::min<std::size_t>(rank, 3)) {
        context.refuse("its spacing '" + text.substr(0, 40) + "' is no list of " + std::to_string(rank) + " numbers");
    }
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double step = n < rank && n < spacing.size() ? spacing[n] : 1;
        checkSpacing(context, step);
        glm::dvec3 axis(0);
        axis[i] = 1;
        if (n < rank && matrix.size() == rank * rank) {
            for (std::size_t j = 0; j < std::min<std::size_t>(3, rank); ++j) {
                axis[static_cast<int>(j)] = matrix[n * rank + j];
            }
        }
        stored.axesMm[i] = axis * step;
        if (n < rank && n < origin.size()) {
            stored.originMm[i] = origin[n];
        }
    }
}

void findData(const Context& context, const MetaHeader& header, DataLayout& layout) {
    const std::string data = header.value({"elementdatafile"});
    if (lowered(data) == "local") {
        layout.files = {context.path};
        layout.offset = header.length;
        return;
    }
    if (data.starts_with("LIST")) {
        for (const std::string& name : header.dataFiles) {
            layout.files.push_back(dataFile(context, name));
        }
        return;
    }
    if (data.find('%') == std::string::npos) {
        layout.files = {dataFile(context, data)};
        return;
    }
    layout.files = numberedFiles(context, data);
}

DataLayout layoutOf(const Context& context, const MetaHeader& header) {
    DataLayout layout;
    findData(context, header, layout);
    const std::string headerSize = header.value({"headersize"});
    layout.byteSkip = headerSize.empty() ? 0 : parseInteger(headerSize).value_or(-2);
    constexpr std::int64_t kLongestSkip = std::int64_t{1} << 40;
    if (layout.byteSkip < -1 || layout.byteSkip > kLongestSkip) {
        context.refuse("its HeaderSize is impossible");
    }
    if (header.isTrue({"compresseddata"}, false)) {
        layout.compression = Compression::gzip;
        if (layout.byteSkip > 0) { // before the compressed stream
            layout.offset += static_cast<std::uint64_t>(layout.byteSkip);
            layout.byteSkip = 0;
        }
    }
    if (!header.isTrue({"binarydata"}, true)) {
        layout.text = DataLayout::Text::ascii;
    }
    layout.swapped = header.isTrue({"binarydatabyteordermsb", "elementbyteordermsb"}, false);
    return layout;
}

void setMeaning(const Context& context, const MetaHeader& header, StoredVolume& stored) {
    const std::string modality = lowered(header.value({"modality"}));
    if (modality == "met_mod_ct" || modality == "met_mod_mr") {
        stored.modality = modality == "met_mod_ct" ? Modality::ct : Modality::mr;
        stored.modalityKnown = true;
    }
    const std::string slope = header.value({"elementtointensityfunctionslope"});
    const std::string intercept = header.value({"elementtointensityfunctionoffset"});
    const auto slopeNumber = slope.empty() ? std::optional(1.0) : parseNumber(slope);
    const auto interceptNumber = intercept.empty() ? std::optional(0.0) : parseNumber(intercept);
    if (!slopeNumber || !interceptNumber) {
        context.refuse("its intensity function is no pair of numbers");
    }
    stored.slope = *slopeNumber;
    stored.intercept = *interceptNumber;
}

} // namespace

StoredVolume readMetaImage(Context& context) {
    const MetaHeader header = readHeader(context);
    const std::string kind = lowered(header.value({"objecttype"}));
    if (!kind.empty() && kind != "image") {
        context.refuse("it holds a '" + kind.substr(0, 40) + "', no image");
    }
    StoredVolume stored;
    stored.type = typeOf(context, header);
    const auto rank = parseInteger(header.value({"ndims"})).value_or(0);
    std::vector<std::int64_t> sizes;
    const std::string dimSize = header.value({"dimsize"}); // the words point into it
    for (const std::string_view size : words(dimSize)) {
        sizes.push_back(parseInteger(size).value_or(0));
    }
    if (rank < 1 || rank > 6 || sizes.size() != static_cast<std::size_t>(rank)) {
        context.refuse("its NDims (1 to 6) and DimSize do not fit together");
    }
    const std::string channelText = header.value({"elementnumberofchannels"});
    const std::int64_t channels = channelText.empty() ? 1 : parseInteger(channelText).value_or(0);
    std::vector<std::int64_t> all = sizes;
    all.push_back(channels);
    const std::uint64_t total = checkedVoxels(context, all, stored.type);
    stored.dims = checkedDims(context, std::span(sizes).first(std::min<std::size_t>(3, sizes.size())), stored.type);
    std::uint64_t frames = 1;
    for (std::size_t i = 3; i < sizes.size(); ++i) {
        frames *= static_cast<std::uint64_t>(sizes[i]);
    }
    const auto components = static_cast<std::uint64_t>(channels);
    expectComponents(context, components, std::to_string(components) + " components per voxel");
    expectComponents(context, frames, std::to_string(frames) + " volumes (4D data)");
    place(context, header, static_cast<std::size_t>(rank), stored);
    setMeaning(context, header, stored);
    checkGeometry(context, stored);
    const DataLayout layout = layoutOf(context, header);
    stored.values = readNumbers(context, layout, stored.type, total / frames, total);
    keepFirstComponent(stored, components);
    context.report.format = "MetaImage";
    return stored;
}

} // namespace limner::importing
