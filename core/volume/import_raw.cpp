#include "core/base/error.h"
#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"

#include <map>

// Headerless bytes, described by the user: "256x256x230:uint16:le:0.5,0.5,0.7".

namespace limner::importing {

namespace {

[[noreturn]] void refuseDescription(const Context& context, const std::string& why) {
    throw Error(ErrorKind::usage, {"cannot understand --raw " + context.options.raw.substr(0, 80), "", why,
                                   "write it like 256x256x230:uint16:le:0.5,0.5,0.7"});
}

ScalarType typeOf(const Context& context, std::string_view name) {
    for (const ScalarType type :
         {ScalarType::uint8, ScalarType::int8, ScalarType::uint16, ScalarType::int16, ScalarType::uint32,
          ScalarType::int32, ScalarType::uint64, ScalarType::int64, ScalarType::float32, ScalarType::float64}) {
        if (lowered(name) == nameOf(type)) {
            return type;
        }
    }
    refuseDescription(context, "'" + std::string(name) + "' is no type of numbers");
}

/// Headers of unknown kind stand before the data.
std::uint64_t headerBytes(Context& context, std::uint64_t length, std::uint64_t bytes) {
    if (length < bytes) {
        context.refuse("it has " + std::to_string(length) + " bytes, the description asks for " + std::to_string(bytes),
                       "correct --raw");
    }
    if (length > bytes) {
        context.warn(std::to_string(length - bytes) + " bytes at the beginning of the file were skipped as a header");
    }
    return length - bytes;
}

} // namespace

StoredVolume readRaw(Context& context) {
    const auto parts = words(context.options.raw, ":");
    if (parts.size() < 2 || parts.size() > 4) {
        refuseDescription(context, "it should have two to four parts");
    }
    std::vector<std::int64_t> dims;
    for (const std::string_view size : words(parts[0], "xX")) {
        dims.push_back(parseInteger(size).value_or(0));
    }
    if (dims.size() != 3) {
        refuseDescription(context, "'" + std::string(parts[0]) + "' is no size like 256x256x230");
    }
    StoredVolume stored;
    stored.type = typeOf(context, parts[1]);
    const std::string order = parts.size() > 2 ? lowered(parts[2]) : "le";
    if (order != "le" && order != "be") {
        refuseDescription(context, "'" + order + "' is neither le nor be");
    }
    const auto spacing = parts.size() > 3 ? parseNumbers(parts[3], ",x") : std::vector<double>{1, 1, 1};
    if (spacing.size() != 3) {
        refuseDescription(context, "'" + std::string(parts[3]) + "' are no three spacings like 0.5,0.5,0.7");
    }
    const std::uint64_t count = checkedVoxels(context, dims, stored.type);
    stored.dims = checkedDims(context, dims, stored.type);
    for (int i = 0; i < 3; ++i) {
        checkSpacing(context, spacing[static_cast<std::size_t>(i)]);
        stored.axesMm[i] *= spacing[static_cast<std::size_t>(i)];
    }
    DataLayout layout;
    layout.files = {context.path};
    layout.swapped = order == "be";
    if (startsAsGzip(context.path)) {
        layout.compression = Compression::gzip;
    } else {
        layout.offset = headerBytes(context, fileLength(context, context.path), count * bytesPerScalar(stored.type));
    }
    stored.values = readNumbers(context, layout, stored.type, count, count);
    context.report.format = "raw";
    return stored;
}

} // namespace limner::importing
