#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

// NRRD 1 to 5 (teem.sourceforge.net/nrrd/format.html).

namespace limner::importing {

namespace {

struct NrrdHeader {
    std::map<std::string, std::string> fields; ///< names in lower case without spaces: "spacedirections"
    std::map<std::string, std::string> keys;   ///< key:=value
    std::vector<std::string> dataFiles;        ///< lines after "data file: LIST"
    std::uint64_t length = 0;                  ///< bytes up to the attached data

    [[nodiscard]] std::string field(const std::string& name) const {
        const auto found = fields.find(name);
        return found == fields.end() ? std::string() : found->second;
    }
};

/// Where the spatial axes stand among all.
struct Axes {
    std::vector<std::int64_t> sizes;
    std::vector<std::size_t> spatial;
    std::vector<std::optional<glm::dvec3>> directions; ///< per axis; empty where the header gives none
    std::uint64_t components = 1;                      ///< faster than the spatial axes
    std::uint64_t frames = 1;                          ///< slower
};

std::string compact(std::string_view name) {
    std::string result = lowered(trimmed(name));
    std::erase(result, ' ');
    return result;
}

void readLine(NrrdHeader& header, std::string_view line) {
    // A key may hold ": ", a field's name never holds ":=".
    const std::size_t key = line.find(":=");
    const std::size_t field = line.find(": ");
    if (key != std::string_view::npos && (field == std::string_view::npos || key < field)) {
        header.keys[std::string(line.substr(0, key))] = line.substr(key + 2);
    } else if (const std::size_t colon = line.find(':'); colon != std::string_view::npos) {
        header.fields[compact(line.substr(0, colon))] = trimmed(line.substr(colon + 1));
    }
}

NrrdHeader readHeader(const Context& context) {
    constexpr std::size_t kLongest = 4 << 20; // lists of data files and label tables take kilobytes
    const std::string text = headOf(context.path, kLongest);
    NrrdHeader header;
    std::size_t at = 0;
    bool list = false;
    for (std::size_t n = 0; at < text.size(); ++n) {
        std::size_t end = text.find('\n', at);
        end = end == std::string::npos ? text.size() : end;
        std::string_view line = std::string_view(text).substr(at, end - at);
        at = std::min(end + 1, text.size());
        if (line.ends_with('\r')) {
            line.remove_suffix(1);
        }
        if (line.empty()) {
            header.length = at;
            return header;
        }
        if (n == 0 || line.front() == '#') {
            continue;
        }
        if (list) {
            header.dataFiles.emplace_back(trimmed(line));
            continue;
        }
        readLine(header, line);
        list = header.field("datafile").starts_with("LIST");
    }
    if (text.size() >= kLongest) {
        context.refuse("its header has no end");
    }
    if (header.field("datafile").empty()) {
        context.refuse("its header ends without data and without naming a data file");
    }
    header.length = text.size();
    return header;
}

ScalarType typeOf(const Context& context, const NrrdHeader& header) {
    static const std::map<std::string, ScalarType> kTypes = {{"signedchar", ScalarType::int8},
                                                             {"int8", ScalarType::int8},
                                                             {"int8_t", ScalarType::int8},
                                                             {"char", ScalarType::int8},
                                                             {"uchar", ScalarType::uint8},
                                                             {"unsignedchar", ScalarType::uint8},
                                                             {"uint8", ScalarType::uint8},
                                                             {"uint8_t", ScalarType::uint8},
                                                             {"short", ScalarType::int16},
                                                             {"shortint", ScalarType::int16},
                                                             {"signedshort", ScalarType::int16},
                                                             {"signedshortint", ScalarType::int16},
                                                             {"int16", ScalarType::int16},
                                                             {"int16_t", ScalarType::int16},
                                                             {"ushort", ScalarType::uint16},
                                                             {"unsignedshort", ScalarType::uint16},
                                                             {"unsignedshortint", ScalarType::uint16},
                                                             {"uint16", ScalarType::uint16},
                                                             {"uint16_t", ScalarType::uint16},
                                                             {"int", ScalarType::int32},
                                                             {"signedint", ScalarType::int32},
                                                             {"int32", ScalarType::int32},
                                                             {"int32_t", ScalarType::int32},
                                                             {"uint", ScalarType::uint32},
                                                             {"unsignedint", ScalarType::uint32},
                                                             {"uint32", ScalarType::uint32},
                                                             {"uint32_t", ScalarType::uint32},
                                                             {"longlong", ScalarType::int64},
                                                             {"longlongint", ScalarType::int64},
                                                             {"signedlonglong", ScalarType::int64},
                                                             {"signedlonglongint", ScalarType::int64},
                                                             {"int64", ScalarType::int64},
                                                             {"int64_t", ScalarType::int64},
                                                             {"ulonglong", ScalarType::uint64},
                                                             {"unsignedlonglong", ScalarType::uint64},
                                                             {"unsignedlonglongint", ScalarType::uint64},
                                                             {"uint64", ScalarType::uint64},
                                                             {"uint64_t", ScalarType::uint64},
                                                             {"float", ScalarType::float32},
                                                             {"double", ScalarType::float64}};
    const auto found = kTypes.find(compact(header.field("type")));
    if (found == kTypes.end()) {
        context.refuse("its type '" + header.field("type").substr(0, 40) + "' is none that Limner reads");
    }
    return found->second;
}

/// One vector per axis: "(1,0,0) none (0,1,0)".
std::vector<std::optional<glm::dvec3>> readVectors(const Context& context, std::string_view text) {
    std::vector<std::optional<glm::dvec3>> result;
    while (!(text = trimmed(text)).empty()) {
        if (text.front() == '(') {
            const std::size_t close = text.find(')');
            if (close == std::string_view::npos) {
                context.refuse("its space directions have an open bracket");
            }
            const auto numbers = parseNumbers(text.substr(1, close - 1));
            if (numbers.size() < 2 || numbers.size() > 4) {
                context.refuse("its space directions are no vectors of space");
            }
            const glm::dvec3 vector(numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 0);
            const bool ofTime = numbers.size() == 4 && numbers[3] != 0 && vector == glm::dvec3(0);
            result.push_back(ofTime ? std::nullopt : std::optional(vector));
            text.remove_prefix(close + 1);
        } else {
            const std::size_t end = std::min(text.find_first_of(" \t("), text.size());
            result.push_back(std::nullopt);
            text.remove_prefix(std::max<std::size_t>(end, 1));
        }
    }
    return result;
}

bool isSpatialKind(const std::string& kind) { return kind == "domain" || kind == "space" || kind == "???"; }

Axes axesOf(const Context& context, const NrrdHeader& header) {
    Axes axes;
    const auto dimension = parseInteger(header.field("dimension"));
    const std::string sizes = header.field("sizes"); // the words point into it
    for (const std::string_view size : words(sizes)) {
        axes.sizes.push_back(parseInteger(size).value_or(0));
    }
    if (!dimension || *dimension < 1 || *dimension > 7 || axes.sizes.size() != static_cast<std::size_t>(*dimension)) {
        context.refuse("its dimension (1 to 7) and sizes do not fit together");
    }
    axes.directions = readVectors(context, header.field("spacedirections"));
    if (!axes.directions.empty() && axes.directions.size() != axes.sizes.size()) {
        context.refuse("it has " + std::to_string(axes.sizes.size()) + " axes and " +
                       std::to_string(axes.directions.size()) + " space directions");
    }
    const std::string kindsField = header.field("kinds"); // the words point into it
    const auto kinds = words(kindsField);
    const bool hasKinds = kinds.size() == axes.sizes.size();
    for (std::size_t i = 0; i < axes.sizes.size(); ++i) {
        const bool spatial = !axes.directions.empty() ? axes.directions[i].has_value()
                             : hasKinds               ? isSpatialKind(lowered(kinds[i]))
                                                      : true;
        if (spatial && axes.spatial.size() < 3) {
            axes.spatial.push_back(i);
        }
    }
    if (axes.spatial.empty()) {
        context.refuse("none of its axes lies in space");
    }
    for (std::size_t i = 0; i < axes.sizes.size(); ++i) {
        if (std::find(axes.spatial.begin(), axes.spatial.end(), i) != axes.spatial.end()) {
            continue;
        }
        const auto size = static_cast<std::uint64_t>(std::max<std::int64_t>(axes.sizes[i], 0));
        if (i < axes.spatial.front()) {
            axes.components *= size;
        } else if (i > axes.spatial.back()) {
            axes.frames *= size;
        } else if (size != 1) {
            context.refuse("an axis of components lies between the axes of space");
        }
    }
    return axes;
}

/// Signs that turn the header's space into LPS.
glm::dvec3 lpsFromSpace(const Context& context, const NrrdHeader& header) {
    std::string space = lowered(header.field("space"));
    if (space.ends_with("-time")) {
        space.resize(space.size() - 5);
    }
    if (space == "right-anterior-superior" || space == "ras" || space == "rast") {
        return {-1, -1, 1};
    }
    if (space == "left-anterior-superior" || space == "las" || space == "last") {
        return {1, -1, 1};
    }
    if (space == "3d-left-handed") {
        context.warn("its left-handed space names no anatomy: the last axis is taken to grow downward");
        return {1, 1, -1};
    }
    const bool known = space.empty() || space == "left-posterior-superior" || space == "lps" || space == "lpst" ||
                       space == "3d-right-handed" || space == "scanner-xyz";
    if (!known) {
        context.warn("its space '" + space.substr(0, 40) + "' is unknown and was taken as left-posterior-superior");
    }
    return {1, 1, 1};
}

double mmPerUnit(const Context& context, const NrrdHeader& header) {
    const std::string units = header.field("spaceunits");
    const auto quoted = words(units, " \"\t");
    if (quoted.empty() || quoted[0] == "mm") {
        return 1;
    }
    if (quoted[0] == "m") {
        return 1000;
    }
    if (quoted[0] == "cm") {
        return 10;
    }
    if (quoted[0] == "um" || quoted[0] == "microns" || quoted[0] == "micron" || quoted[0] == "\xc2\xb5m") {
        return 0.001;
    }
    context.warn("its space unit '" + std::string(quoted[0].substr(0, 20)) + "' is unknown and was taken as mm");
    return 1;
}

/// Spacing of an axis without a direction.
double spacingOf(const Context& context, const NrrdHeader& header, const Axes& axes, std::size_t axis) {
    const std::string text = header.field("spacings");
    const auto spacings = words(text);
    if (axis < spacings.size()) {
        const auto spacing = parseNumber(spacings[axis]);
        if (!spacing) {
            context.refuse("its spacing '" + std::string(spacings[axis].substr(0, 40)) + "' is no number");
        }
        return *spacing;
    }
    const auto low = parseNumbers(header.field("axismins"));
    const auto high = parseNumbers(header.field("axismaxs"));
    if (axis < low.size() && axis < high.size()) {
        const std::string centres =
            header.field("centers").empty() ? header.field("centerings") : header.field("centers");
        const auto kinds = words(centres);
        const bool node = axis < kinds.size() && lowered(kinds[axis]) == "node";
        const auto steps = static_cast<double>(std::max<std::int64_t>(1, axes.sizes[axis] - (node ? 1 : 0)));
        return std::abs(high[axis] - low[axis]) / steps;
    }
    context.warn("the file gives no spacing; 1 mm was taken");
    return 1;
}

void place(Context& context, const NrrdHeader& header, const Axes& axes, StoredVolume& stored) {
    const glm::dvec3 toLps = lpsFromSpace(context, header) * mmPerUnit(context, header);
    for (int n = 0; n < 3; ++n) {
        const auto i = static_cast<std::size_t>(n);
        if (i < axes.spatial.size() && !axes.directions.empty()) {
            stored.axesMm[n] = *axes.directions[axes.spatial[i]] * toLps;
            continue;
        }
        glm::dvec3 axis(0);
        axis[n] = 1;
        if (i < axes.spatial.size()) {
            axis[n] = spacingOf(context, header, axes, axes.spatial[i]);
            checkSpacing(context, axis[n]);
        } else if (!axes.directions.empty() && axes.spatial.size() == 2) {
            axis = glm::cross(stored.axesMm[0], stored.axesMm[1]);
            axis = glm::length(axis) > 0 ? glm::normalize(axis) : axis;
            stored.axesMm[n] = axis;
            continue;
        }
        stored.axesMm[n] = axis * toLps;
    }
    const auto origin = parseNumbers(header.field("spaceorigin"));
    if (origin.size() >= 3) {
        stored.originMm = glm::dvec3(origin[0], origin[1], origin[2]) * toLps;
    }
}

/// Modality, as 3D Slicer and others write it.
void readKeys(const NrrdHeader& header, StoredVolume& stored) {
    for (const auto& [key, value] : header.keys) {
        const std::string name = lowered(key);
        if (name == "modality" || name == "dicom_0008_0060") {
            const std::string modality = lowered(trimmed(value));
            stored.modalityKnown = true;
            stored.modality = modality == "ct" ? Modality::ct : modality == "mr" ? Modality::mr : Modality::unknown;
        }
    }
}

void findData(const Context& context, const NrrdHeader& header, DataLayout& layout) {
    const std::string data = header.field("datafile");
    if (data.empty()) {
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

DataLayout layoutOf(const Context& context, const NrrdHeader& header, ScalarType type) {
    DataLayout layout;
    findData(context, header, layout);
    const std::string encoding = lowered(header.field("encoding"));
    if (encoding == "gzip" || encoding == "gz") {
        layout.compression = Compression::gzip;
    } else if (encoding == "bzip2" || encoding == "bz2") {
        layout.compression = Compression::bzip2;
    } else if (encoding == "ascii" || encoding == "text" || encoding == "txt") {
        layout.text = DataLayout::Text::ascii;
    } else if (encoding == "hex") {
        layout.text = DataLayout::Text::hex;
    } else if (encoding != "raw") {
        context.refuse("its encoding '" + encoding.substr(0, 40) + "' is none that Limner reads");
    }
    const std::string lineSkip = header.field("lineskip");
    const std::string byteSkip = header.field("byteskip");
    const auto lines = lineSkip.empty() ? 0 : parseInteger(lineSkip).value_or(-1);
    layout.byteSkip = byteSkip.empty() ? 0 : parseInteger(byteSkip).value_or(-2);
    constexpr std::int64_t kLongestSkip = std::int64_t{1} << 40;
    if (lines < 0 || layout.byteSkip < -1 || lines > kLongestSkip || layout.byteSkip > kLongestSkip) {
        context.refuse("its line skip or byte skip is impossible");
    }
    layout.lineSkip = static_cast<std::uint64_t>(lines);
    const std::string endian = lowered(header.field("endian"));
    layout.swapped = endian == "big";
    if (endian.empty() && bytesPerScalar(type) > 1 && layout.text != DataLayout::Text::ascii) {
        context.warn("the file does not give its byte order; little-endian was taken");
    }
    return layout;
}

} // namespace

std::map<std::string, std::string> nrrdKeys(const Context& context) { return readHeader(context).keys; }

StoredVolume readNrrd(Context& context) {
    const NrrdHeader header = readHeader(context);
    StoredVolume stored;
    stored.type = typeOf(context, header);
    const Axes axes = axesOf(context, header);
    const std::uint64_t total = checkedVoxels(context, axes.sizes, stored.type);
    for (std::size_t i = 0; i < axes.spatial.size(); ++i) {
        stored.dims[static_cast<int>(i)] = static_cast<int>(axes.sizes[axes.spatial[i]]);
    }
    expectComponents(context, axes.components, std::to_string(axes.components) + " components per voxel");
    expectComponents(context, axes.frames, std::to_string(axes.frames) + " volumes (4D data)");
    place(context, header, axes, stored);
    readKeys(header, stored);
    checkGeometry(context, stored);
    const DataLayout layout = layoutOf(context, header, stored.type);
    stored.values = readNumbers(context, layout, stored.type, total / axes.frames, total);
    keepFirstComponent(stored, axes.components);
    context.report.format = "NRRD";
    return stored;
}

} // namespace limner::importing
