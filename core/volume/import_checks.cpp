#include "core/base/error.h"
#include "core/volume/import_parts.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>

namespace limner::importing {

std::size_t bytesPerScalar(ScalarType type) {
    return withScalar(type, [](auto zero) { return sizeof(zero); });
}

const char* nameOf(ScalarType type) {
    switch (type) {
    case ScalarType::uint8: return "uint8";
    case ScalarType::int8: return "int8";
    case ScalarType::uint16: return "uint16";
    case ScalarType::int16: return "int16";
    case ScalarType::uint32: return "uint32";
    case ScalarType::int32: return "int32";
    case ScalarType::uint64: return "uint64";
    case ScalarType::int64: return "int64";
    case ScalarType::float32: return "float32";
    case ScalarType::float64: return "float64";
    }
    return "";
}

void Context::refuse(const std::string& why, const std::string& remedy) const {
    throw Error(ErrorKind::badInput, {"cannot read the volume", path.filename().string(), why, remedy});
}

void Context::warn(const std::string& message) const {
    if (std::find(report.warnings.begin(), report.warnings.end(), message) == report.warnings.end()) {
        report.warnings.push_back(message);
        task.warn(message);
    }
}

std::uint64_t checkedVoxels(const Context& context, std::span<const std::int64_t> dims, ScalarType type) {
    unsigned __int128 voxels = 1;
    std::string product;
    for (const std::int64_t axis : dims) {
        if (axis < 1 || axis > kLargestAxis) {
            context.refuse("an axis of " + std::to_string(axis) + " voxels is outside 1 to " +
                           std::to_string(kLargestAxis));
        }
        voxels *= static_cast<unsigned __int128>(axis); // at most 2^112: seven axes of 2^16
        product += (product.empty() ? "" : " x ") + std::to_string(axis);
    }
    // As read, as kept (at most four bytes), and in bricks with their apron (1.5 times).
    const unsigned __int128 bytes =
        voxels * (bytesPerScalar(type) + std::min<std::size_t>(4, bytesPerScalar(type)) * 5 / 2);
    if (dims.size() > 7 || bytes > context.budget) {
        throw Error(ErrorKind::noResources,
                    {"cannot read the volume", context.path.filename().string(),
                     product + " voxels need more than the " + std::to_string(context.budget >> 20) + " MiB allowed",
                     "load a smaller part or raise the memory limit"});
    }
    return static_cast<std::uint64_t>(voxels);
}

glm::ivec3 checkedDims(const Context& context, std::span<const std::int64_t> dims, ScalarType type) {
    checkedVoxels(context, dims, type);
    glm::ivec3 result(1);
    for (std::size_t axis = 0; axis < std::min<std::size_t>(3, dims.size()); ++axis) {
        result[static_cast<int>(axis)] = static_cast<int>(dims[axis]);
    }
    return result;
}

void checkSpacing(const Context& context, double spacingMm) {
    constexpr double kSmallestMm = 1e-9; // an atom is 1e-7 mm: beyond any scanner, and far from overflow below
    constexpr double kLargestMm = 1e9;
    if (!(spacingMm >= kSmallestMm && spacingMm <= kLargestMm)) {
        std::string text = std::to_string(spacingMm);
        if (spacingMm != 0 && std::abs(spacingMm) < kSmallestMm) {
            text = "almost 0";
        } else if (std::abs(spacingMm) > kLargestMm) {
            text = "more than 1000 km";
        }
        context.refuse("a voxel spacing of " + text + " mm is impossible", "correct the spacing in its header");
    }
}

void checkGeometry(const Context& context, const StoredVolume& stored) {
    for (int axis = 0; axis < 3; ++axis) {
        checkSpacing(context, glm::length(stored.axesMm[axis]));
    }
    const glm::dmat3 unit(glm::normalize(stored.axesMm[0]), glm::normalize(stored.axesMm[1]),
                          glm::normalize(stored.axesMm[2]));
    constexpr double kFlat = 1e-3; // axes within 0.06 degrees of one plane span no volume
    if (!(std::abs(glm::determinant(unit)) > kFlat)) {
        context.refuse("its axes lie in one plane", "correct the orientation in its header");
    }
    constexpr double kFarthestMm = 1e12;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(stored.originMm[axis]) < kFarthestMm)) {
            context.refuse("its origin is no position", "correct the origin in its header");
        }
    }
    if (!std::isfinite(stored.slope) || stored.slope == 0 || !std::isfinite(stored.intercept)) {
        context.refuse("its slope and intercept are no numbers", "correct them in its header");
    }
}

void expectComponents(const Context& context, std::uint64_t components, const std::string& what) {
    if (components > 1 && !context.options.firstComponent) {
        context.refuse("it holds " + what + ", Limner draws one number per voxel",
                       "ask for the first component (--first-component) or convert it to grey");
    }
    if (components > 1) {
        context.warn("only the first component of " + what + " was read");
    }
}

void keepFirstComponent(StoredVolume& stored, std::uint64_t components) {
    if (components <= 1) {
        return;
    }
    const std::size_t width = bytesPerScalar(stored.type);
    const std::size_t voxels = stored.values.size() / (width * components);
    ByteBuffer first(voxels * width);
    for (std::size_t i = 0; i < voxels; ++i) {
        std::memcpy(first.data() + i * width, stored.values.data() + i * width * components, width);
    }
    stored.values = std::move(first);
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n\v\f";
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::string lowered(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::vector<std::string_view> words(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> result;
    std::size_t from = 0;
    while ((from = text.find_first_not_of(separators, from)) != std::string_view::npos) {
        const std::size_t to = std::min(text.find_first_of(separators, from), text.size());
        result.push_back(text.substr(from, to - from));
        from = to;
    }
    return result;
}

std::optional<double> parseNumber(std::string_view text) {
    text = trimmed(text);
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
    }
    double value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

std::optional<std::int64_t> parseInteger(std::string_view text) {
    text = trimmed(text);
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
    }
    std::int64_t value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

std::vector<double> parseNumbers(std::string_view text, std::string_view separators) {
    std::vector<double> result;
    for (const std::string_view one : words(text, separators)) {
        const auto value = parseNumber(one);
        if (!value) {
            break;
        }
        result.push_back(*value);
    }
    return result;
}

} // namespace limner::importing
