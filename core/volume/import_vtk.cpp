#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"

#include <map>

// Legacy VTK files (VTK's "File Formats"): structured points, binary (big-endian) or text.

namespace limner::importing {

namespace {

struct LegacyHeader {
    bool binary = false;
    std::vector<double> dims;
    std::vector<double> spacing;
    std::vector<double> origin;
    bool cells = false;
    std::uint64_t tuples = 0;
    std::string type;
    std::int64_t components = 1;
    std::uint64_t dataOffset = 0;
};

std::optional<ScalarType> legacyType(const std::string& name) {
    static const std::map<std::string, ScalarType> kTypes = {{"char", ScalarType::int8},
                                                             {"signed_char", ScalarType::int8},
                                                             {"unsigned_char", ScalarType::uint8},
                                                             {"short", ScalarType::int16},
                                                             {"unsigned_short", ScalarType::uint16},
                                                             {"int", ScalarType::int32},
                                                             {"unsigned_int", ScalarType::uint32},
                                                             {"long", ScalarType::int64},
                                                             {"unsigned_long", ScalarType::uint64},
                                                             {"vtktypeint64", ScalarType::int64},
                                                             {"vtktypeuint64", ScalarType::uint64},
                                                             {"float", ScalarType::float32},
                                                             {"double", ScalarType::float64}};
    const auto found = kTypes.find(name);
    return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

/// Reads one header line; returns whether the data follow.
bool readLine(const Context& context, LegacyHeader& header, std::string_view line) {
    const auto parts = words(line);
    if (parts.empty()) {
        return false;
    }
    const std::string key = lowered(parts[0]);
    const std::string second = parts.size() > 1 ? lowered(parts[1]) : std::string();
    const std::string_view rest = line.substr(line.find(parts[0]) + parts[0].size());
    if (key == "binary" || key == "ascii") {
        header.binary = key == "binary";
    } else if (key == "dataset" && second != "structured_points") {
        context.refuse("it holds '" + second.substr(0, 40) + "', no structured points");
    } else if (key == "dimensions") {
        header.dims = parseNumbers(rest);
    } else if (key == "spacing" || key == "aspect_ratio") {
        header.spacing = parseNumbers(rest);
    } else if (key == "origin") {
        header.origin = parseNumbers(rest);
    } else if (key == "point_data" || key == "cell_data") {
        header.cells = key == "cell_data";
        header.tuples = static_cast<std::uint64_t>(std::max<std::int64_t>(0, parseInteger(second).value_or(0)));
    } else if (key == "scalars") {
        header.type = parts.size() > 2 ? lowered(parts[2]) : std::string();
        header.components = parts.size() > 3 ? parseInteger(parts[3]).value_or(0) : 1;
    } else if (key == "lookup_table") {
        return !header.type.empty();
    } else if (key == "vectors" || key == "normals" || key == "tensors" || key == "color_scalars" || key == "field") {
        context.refuse("its first array is '" + key + "', not SCALARS", "write the scalars first");
    }
    return false;
}

LegacyHeader readHeader(const Context& context) {
    constexpr std::size_t kLongest = 1 << 16; // a dozen short lines
    const std::string text = headOf(context.path, kLongest);
    LegacyHeader header;
    std::size_t at = 0;
    for (int line = 0; at < text.size(); ++line) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos) {
            break;
        }
        const std::string_view content = std::string_view(text).substr(at, end - at);
        at = end + 1;
        if (line >= 2 && readLine(context, header, content)) { // version and title come first
            header.dataOffset = at;
            return header;
        }
    }
    context.refuse("its header names no scalars");
}

} // namespace

StoredVolume readLegacyVtk(Context& context) {
    const LegacyHeader header = readHeader(context);
    const auto type = legacyType(header.type);
    if (!type || header.dims.size() != 3 || header.components < 1 || header.components > 4) {
        context.refuse("its dimensions or scalars are none that Limner reads");
    }
    StoredVolume stored;
    stored.type = *type;
    std::array<std::int64_t, 3> dims{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double points = header.dims[i];
        constexpr double kMost = 1e9; // checkedDims has the last word
        dims[i] = points >= 1 && points < kMost ? static_cast<std::int64_t>(points) : 0;
        if (header.cells && dims[i] > 1) {
            --dims[i];
        }
    }
    const std::array<std::int64_t, 4> all = {dims[0], dims[1], dims[2], header.components};
    const std::uint64_t count = checkedVoxels(context, all, *type);
    stored.dims = checkedDims(context, dims, *type);
    if (header.tuples * static_cast<std::uint64_t>(header.components) != count) {
        context.refuse("its dimensions and its number of values do not fit together");
    }
    expectComponents(context, static_cast<std::uint64_t>(header.components),
                     std::to_string(header.components) + " components per voxel");
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double spacing = header.spacing.size() == 3 ? header.spacing[n] : 1;
        checkSpacing(context, spacing);
        stored.axesMm[i] = glm::dvec3(0);
        stored.axesMm[i][i] = spacing;
        const double origin = header.origin.size() == 3 ? header.origin[n] : 0;
        stored.originMm[i] =
            origin + (header.cells && header.dims[n] > 1 ? spacing / 2 : 0); // centre of the first cell
    }
    checkGeometry(context, stored);
    DataLayout layout;
    layout.files = {context.path};
    layout.offset = header.dataOffset;
    layout.swapped = header.binary;
    if (!header.binary) {
        layout.text = DataLayout::Text::ascii;
        layout.moreFollows = true;
    }
    stored.values = readNumbers(context, layout, *type, count, count);
    keepFirstComponent(stored, static_cast<std::uint64_t>(header.components));
    context.report.format = "VTK structured points";
    return stored;
}

} // namespace limner::importing
