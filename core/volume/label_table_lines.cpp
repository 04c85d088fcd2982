#include "core/volume/import_parts.h"
#include "core/volume/label_table_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

// Tables of labels as text: "26 vertebrae_S1", "1 Precentral_L 2001", FreeSurfer's "17 Left-Hippocampus 220 216 20 0",
// 3D Slicer's colour tables of the same form, and ITK-SNAP's label descriptions 'IDX R G B A VIS MESH "LABEL"'.

namespace limner::importing {

namespace {

/// A line as words: its number, then numbers, then the name's words, then numbers.
struct Line {
    int label = 0;
    std::vector<std::string_view> rest; ///< after the number; a quoted name or a field between tabs is one word
    std::size_t nameFrom = 0;           ///< in `rest`
    std::size_t nameTo = 0;

    [[nodiscard]] std::string name(std::size_t cut) const {
        std::string text;
        for (std::size_t i = nameFrom; i < rest.size() - cut; ++i) {
            text += (text.empty() ? "" : " ") + std::string(rest[i]);
        }
        return cleanLabelName(text);
    }
    [[nodiscard]] std::size_t numbersAfter() const { return rest.size() - nameTo; }
};

std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> result;
    const bool tabs = line.find('\t') != std::string_view::npos && line.find('"') == std::string_view::npos;
    const std::string_view between = tabs ? "\t" : " \t,;";
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        if (line.front() == '"') {
            const std::size_t end = std::min(line.find('"', 1), line.size());
            result.push_back(line.substr(1, end - 1));
            line.remove_prefix(std::min(end + 1, line.size()));
            continue;
        }
        const std::size_t end = std::min(line.find_first_of(between), line.size());
        if (end > 0) {
            result.push_back(trimmed(line.substr(0, end)));
        }
        line.remove_prefix(std::min(std::max<std::size_t>(end, 1), line.size()));
    }
    return result;
}

std::optional<Line> lineOf(std::string_view text) {
    Line line;
    line.rest = wordsOf(text);
    const auto label = line.rest.size() < 2 ? std::nullopt : labelNumber(line.rest.front());
    if (!label) {
        return std::nullopt;
    }
    line.label = *label;
    line.rest.erase(line.rest.begin());
    const auto isName = [](std::string_view word) { // "Inf" is one
        return !std::isfinite(parseNumber(word).value_or(std::numeric_limits<double>::infinity()));
    };
    const auto first = std::find_if(line.rest.begin(), line.rest.end(), isName);
    const auto last = std::find_if(line.rest.rbegin(), line.rest.rend(), isName).base();
    if (first == line.rest.end()) {
        return std::nullopt; // numbers alone
    }
    line.nameFrom = static_cast<std::size_t>(first - line.rest.begin());
    line.nameTo = static_cast<std::size_t>(last - line.rest.begin());
    return line;
}

/// The colour that the first three of a run of numbers make.
std::string colourOf(const Line& line, std::size_t from, std::size_t to) {
    constexpr double kHighest = 255;
    std::array<double, 3> rgb{};
    if (to - from < rgb.size()) {
        return {};
    }
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        const auto part = parseInteger(line.rest[from + i]);
        if (!part || *part < 0 || *part > kHighest) {
            return {};
        }
        rgb[i] = static_cast<double>(*part) / kHighest;
    }
    return hexColour(rgb);
}

/// How many numbers at the end of every line are columns and no part of the name ("Area 44"): as many as all lines
/// have, where they make a colour or the names differ without them.
std::size_t columnsAfter(const std::vector<Line>& lines) {
    std::size_t columns = std::numeric_limits<std::size_t>::max();
    for (const Line& line : lines) {
        columns = std::min(columns, line.numbersAfter());
    }
    constexpr std::size_t kColour = 3;
    for (; columns > 0 && columns < kColour; --columns) {
        std::set<std::string> names;
        for (const Line& line : lines) {
            names.insert(line.name(columns));
        }
        if (names.size() == lines.size()) {
            break;
        }
    }
    return columns;
}

} // namespace

LabelTable parseLabelText(std::string_view text, const std::string& name) {
    LabelTable table;
    std::vector<Line> lines;
    std::size_t odd = 0;
    while (!text.empty() && lines.size() <= LabelTable::kMostEntries) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view one = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (one.empty() || one.starts_with('#') || one.starts_with("//")) {
            continue;
        }
        if (auto line = lineOf(one)) {
            lines.push_back(std::move(*line));
        } else {
            ++odd;
        }
    }
    if (lines.size() < std::max<std::size_t>(odd, 1)) {
        return table; // a text about something else
    }
    if (odd > 1) { // one is a heading
        table.warnings.push_back(std::to_string(odd) + " lines of " + name + " name no label");
    }
    const std::size_t columns = columnsAfter(lines);
    for (const Line& line : lines) {
        const std::string before = colourOf(line, 0, line.nameFrom);
        const std::string after = colourOf(line, line.rest.size() - columns, line.rest.size());
        if (!addLabel(table, line.label, {line.name(columns), before.empty() ? after : before})) {
            break;
        }
    }
    return table;
}

} // namespace limner::importing
