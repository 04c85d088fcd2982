#include "core/volume/label_table.h"

#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"
#include "core/volume/import_xml.h"
#include "core/volume/label_table_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace limner {

namespace importing {

namespace {

/// Bytes of the UTF-8 sequence at the start of `text`, by RFC 3629; 0 where there is none.
std::size_t sequenceLength(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    if (length == 0 || first > 0xf4 || length > text.size()) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) {
            return 0;
        }
    }
    const bool wrong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f) ||
                       (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) > 0x8f);
    return wrong ? 0 : length;
}

} // namespace

std::string cleanLabelName(std::string_view text) {
    std::string name;
    text = trimmed(text);
    while (!text.empty()) {
        const std::size_t length = sequenceLength(text);
        const std::string_view one = length == 0 ? std::string_view("?") : text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
        const auto first = static_cast<unsigned char>(one[0]);
        const bool control =
            first < 0x20 || first == 0x7f || (first == 0xc2 && static_cast<unsigned char>(one[1]) < 0xa0);
        if (control) {
            continue;
        }
        if (name.size() + one.size() > LabelTable::kLongestName) {
            break;
        }
        name += one;
    }
    return std::string(trimmed(name));
}

std::string hexColour(const std::array<double, 3>& rgb) {
    std::string text = "#";
    for (const double part : rgb) {
        if (!std::isfinite(part)) {
            return {};
        }
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02x",
                      static_cast<unsigned>(std::lround(std::clamp(part, 0.0, 1.0) * 255)));
        text += digits;
    }
    return text;
}

std::optional<int> labelNumber(std::string_view text) {
    const auto number = parseInteger(text);
    const bool fits =
        number && *number >= std::numeric_limits<int>::min() && *number <= std::numeric_limits<int>::max();
    return fits ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

bool addLabel(LabelTable& table, int label, LabelEntry entry) {
    if (table.entries.size() >= LabelTable::kMostEntries && table.entries.count(label) == 0) {
        const std::string tooMany =
            "only the first " + std::to_string(LabelTable::kMostEntries) + " labels of its table were read";
        if (table.warnings.empty() || table.warnings.back() != tooMany) {
            table.warnings.push_back(tooMany);
        }
        return false;
    }
    table.entries.try_emplace(label, std::move(entry));
    return true;
}

void readCaretLabels(std::string_view xml, LabelTable& table) {
    std::optional<int> label;
    LabelEntry entry;
    XmlHandler handler;
    handler.started = [&](const XmlElement& element) {
        label.reset();
        if (element.name != "Label") {
            return;
        }
        const std::string_view key = element.attribute("Key");
        label = labelNumber(key.empty() ? element.attribute("Index") : key); // Index: GIFTI's first drafts
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        entry = {"", hexColour({parseNumber(element.attribute("Red")).value_or(kNone),
                                parseNumber(element.attribute("Green")).value_or(kNone),
                                parseNumber(element.attribute("Blue")).value_or(kNone)})};
    };
    handler.text = [&](std::string_view text) {
        constexpr std::size_t kEnough = 4 * LabelTable::kLongestName; // before it is cleaned
        if (label && entry.name.size() < kEnough) {
            entry.name += text.substr(0, kEnough);
        }
    };
    handler.ended = [&](std::string_view) {
        if (label) {
            addLabel(table, *label, {cleanLabelName(entry.name), entry.colour});
        }
        label.reset();
    };
    if (!parseXml(xml, handler)) {
        table.warnings.emplace_back("the header extension with its label names is damaged");
    }
}

namespace {

constexpr std::string_view kNumberKey = "_LabelValue";

/// 3D Slicer: Segment0_LabelValue, Segment0_Name, Segment0_Color ("r g b" of 0..1), Segment0_Layer.
void readSegments(const std::map<std::string, std::string>& keys, LabelTable& table) {
    for (const auto& [key, value] : keys) {
        if (!key.starts_with("Segment") || !key.ends_with(kNumberKey)) {
            continue;
        }
        const std::string segment = key.substr(0, key.size() - kNumberKey.size());
        const auto word = [&](const char* name) -> std::string_view {
            const auto found = keys.find(segment + name);
            return found == keys.end() ? std::string_view() : trimmed(found->second);
        };
        const auto label = labelNumber(value);
        // Layers are components of the voxels, of which the first is read; their numbers start anew in each.
        if (!label || (!word("_Layer").empty() && word("_Layer") != "0")) {
            continue;
        }
        const std::vector<double> rgb = parseNumbers(word("_Color"));
        addLabel(table, *label,
                 {cleanLabelName(word("_Name")), rgb.size() == 3 ? hexColour({rgb[0], rgb[1], rgb[2]}) : ""});
    }
}

void readHeader(Context& context, LabelTable& table) {
    const std::string head = headOf(context.path, 1024);
    const std::string name = lowered(context.path.filename().string());
    if (head.starts_with("NRRD000")) {
        readSegments(nrrdKeys(context), table);
    } else if (startsAsNifti(head) || name.ends_with(".img") || name.ends_with(".img.gz")) {
        for (const std::string& text : niftiExtensions(context)) {
            if (text.find("<LabelTable") != std::string::npos) {
                readCaretLabels(text, table);
            }
        }
    }
}

std::filesystem::path withoutEndings(const std::filesystem::path& path) {
    const std::string ending = lowered(path.extension().string());
    return ending == ".gz" || ending == ".bz2" ? path.parent_path() / path.stem().stem()
                                               : path.parent_path() / path.stem();
}

/// Takes what the table lacks from the text file beside the volume.
void readSidecar(Context& context, LabelTable& table) {
    constexpr std::uint64_t kLongest = 8 << 20; // 65,536 lines of 128 bytes
    const std::filesystem::path stem = withoutEndings(context.path);
    for (const char* ending : {".txt", ".label", ".lut", ".ctbl"}) {
        const std::filesystem::path beside = stem.string() + ending;
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(beside, ignored)) {
            continue;
        }
        if (std::filesystem::file_size(beside, ignored) > kLongest) {
            context.warn(beside.filename().string() + " is too long for a table of labels and was left out");
            continue;
        }
        LabelTable text = parseLabelText(readText(context, beside, kLongest), beside.filename().string());
        for (auto& [label, entry] : text.entries) {
            LabelEntry& kept = table.entries[label];
            kept.name = kept.name.empty() ? entry.name : kept.name;
            kept.colour = kept.colour.empty() ? entry.colour : kept.colour;
        }
        table.warnings.insert(table.warnings.end(), text.warnings.begin(), text.warnings.end());
        if (!text.entries.empty()) {
            return;
        }
    }
}

/// Runs a part whose failure is a warning.
template <typename Read>
void attempt(LabelTable& table, const Read& read) {
    try {
        read();
    } catch (const std::exception& problem) {
        table.warnings.push_back(std::string("its table of labels could not be read: ") + problem.what());
    }
}

} // namespace

} // namespace importing

LabelTable readLabelTable(const std::filesystem::path& path) {
    using namespace importing;
    LabelTable table;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        return table;
    }
    const ImportOptions options;
    Task task;
    ImportReport report;
    Context context{path, options, task, report, std::uint64_t{64} << 20};
    attempt(table, [&] { readHeader(context, table); });
    attempt(table, [&] { readSidecar(context, table); });
    table.warnings.insert(table.warnings.end(), report.warnings.begin(), report.warnings.end());
    return table;
}

} // namespace limner
