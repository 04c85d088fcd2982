#include "core/figure/quantity.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>

namespace limner {

namespace {

[[noreturn]] void fail(const char* what, const std::string& text, const std::string& where, const char* remedy) {
    // Hostile input must not fill the screen.
    const std::string shown = text.size() <= 60 ? text : text.substr(0, 57) + "...";
    throw Error(ErrorKind::usage, {what, where, "\"" + shown + "\" is none", remedy});
}

/// A finite decimal number at the start of `text`, which is moved past it.
std::optional<double> takeNumber(std::string_view& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) {
        return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::optional<int> unitPower(std::string_view unit) {
    std::string lower(unit);
    std::erase(lower, ' ');
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::string_view kLetters = "kmgt";
    if (lower.empty() || lower == "b") {
        return 0;
    }
    const auto power = kLetters.find(lower[0]);
    const std::string rest = lower.substr(1);
    if (power == std::string_view::npos || !(rest.empty() || rest == "b" || rest == "ib")) {
        return std::nullopt;
    }
    return static_cast<int>(power) + 1;
}

std::optional<glm::dvec4> hexColour(std::string_view digits) {
    const auto isHex = [](unsigned char c) { return std::isxdigit(c) != 0; };
    if (!std::all_of(digits.begin(), digits.end(), isHex) ||
        !(digits.size() == 3 || digits.size() == 6 || digits.size() == 8)) {
        return std::nullopt;
    }
    const std::size_t width = digits.size() == 3 ? 1 : 2;
    glm::dvec4 colour(0, 0, 0, 1);
    for (std::size_t i = 0; i * width < digits.size(); ++i) {
        int value = 0;
        const std::string_view part = digits.substr(i * width, width);
        std::from_chars(part.data(), part.data() + part.size(), value, 16);
        colour[static_cast<int>(i)] = value / (width == 1 ? 15.0 : 255.0);
    }
    return colour;
}

std::optional<glm::dvec4> listedColour(std::string_view text) {
    glm::dvec4 colour(0, 0, 0, 1);
    int count = 0;
    for (; count < 4; ++count) {
        while (!text.empty() && text.front() == ' ') {
            text.remove_prefix(1);
        }
        const auto value = takeNumber(text);
        if (!value || *value < 0 || *value > 1) {
            return std::nullopt;
        }
        colour[count] = *value;
        if (text.empty()) {
            return count >= 2 ? std::optional(colour) : std::nullopt;
        }
        if (text.front() != ',') {
            return std::nullopt;
        }
        text.remove_prefix(1);
    }
    return std::nullopt; // more than four
}

} // namespace

std::uint64_t parseBytes(const std::string& text, const std::string& where) {
    std::string_view rest = text;
    const auto number = takeNumber(rest);
    const auto power = unitPower(rest);
    const double bytes = number && power ? std::ldexp(*number, 10 * *power) : 0;
    // 2^53: above it a double no longer counts single bytes, and no machine has as much memory.
    if (!(bytes >= 1 && bytes <= 0x1p53)) {
        fail("cannot read an amount of memory", text, where, "write for example 512M or 4G");
    }
    return static_cast<std::uint64_t>(bytes);
}

glm::ivec2 parsePixelSize(const std::string& text, const std::string& where) {
    glm::ivec2 size{0};
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.x);
    const bool cross = width.ec == std::errc() && width.ptr != end && (*width.ptr == 'x' || *width.ptr == 'X');
    const auto height = cross ? std::from_chars(width.ptr + 1, end, size.y) : width;
    if (!cross || height.ec != std::errc() || height.ptr != end || size.x < 1 || size.y < 1) {
        fail("cannot read a size in pixels", text, where, "write width and height, for example 2126x1417");
    }
    return size;
}

glm::dvec4 parseColour(const std::string& text, const std::string& where) {
    struct Named {
        std::string_view name;
        glm::dvec4 rgba;
    };
    static const std::array<Named, 4> kNamed{
        {{"white", {1, 1, 1, 1}}, {"black", {0, 0, 0, 1}}, {"grey", {0.5, 0.5, 0.5, 1}}, {"gray", {0.5, 0.5, 0.5, 1}}}};
    for (const Named& named : kNamed) {
        if (text == named.name) {
            return named.rgba;
        }
    }
    const auto colour =
        !text.empty() && text.front() == '#' ? hexColour(std::string_view(text).substr(1)) : listedColour(text);
    if (!colour) {
        fail("cannot read a colour", text, where,
             "write #rrggbb, r,g,b with numbers from 0 to 1, white, grey or black");
    }
    return *colour;
}

std::optional<glm::dvec3> plainColour(const std::string& text) {
    constexpr std::size_t kLength = 7;
    if (text.size() != kLength || text.front() != '#') {
        return std::nullopt;
    }
    const auto colour = hexColour(std::string_view(text).substr(1));
    return colour ? std::optional(glm::dvec3(*colour)) : std::nullopt;
}

std::string formatBytes(std::uint64_t bytes) {
    constexpr std::array<const char*, 5> kUnits{"bytes", "KiB", "MiB", "GiB", "TiB"};
    double number = static_cast<double>(bytes);
    std::size_t unit = 0;
    while (number >= 1024 && unit + 1 < kUnits.size()) {
        number /= 1024;
        ++unit;
    }
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), unit == 0 ? "%.0f %s" : "%.1f %s", number, kUnits[unit]);
    return text.data();
}

} // namespace limner
