#include "core/base/error.h"
#include "core/figure/description.h"
#include "core/figure/migration.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace limner {

using description::Facts;
using description::Field;
using description::Findings;
using description::Shape;
using description::ValueType;
using Json = nlohmann::ordered_json;

namespace {

// Limits far above any figure that people make, so that a hostile text costs neither the stack nor the memory.
constexpr std::size_t kLongestDocument = std::size_t{16} << 20; ///< bytes
constexpr std::size_t kMostValues = 1000000;
constexpr std::size_t kDeepest = 64;
constexpr std::size_t kLongestText = 65536; ///< bytes of one text
constexpr std::size_t kMostProblems = 1000; ///< more do not help anybody
constexpr std::size_t kQuotedBytes = 40;    ///< of a foreign text in a message

/// Foreign text for a message: short, in quotes, on one line.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text.substr(0, kQuotedBytes)) {
        result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
    if (text.size() > kQuotedBytes) {
        // Not in the middle of a character.
        while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0x80) != 0) {
            result.pop_back();
        }
        result += "...";
    }
    return result + "\"";
}

std::string pointerText(const std::vector<std::string>& path) {
    std::string pointer;
    for (const std::string& token : path) {
        pointer += "/" + description::escapedToken(token.size() > kQuotedBytes ? token.substr(0, kQuotedBytes) + "..."
                                                                               : token);
    }
    return pointer;
}

/// Builds the document while it is read, and stops at the first thing that is too much.
class DocumentBuilder : public nlohmann::json_sax<Json> {
  public:
    Json document;
    std::optional<Problem> problem;

    bool null() override { return add(Json()); }
    bool boolean(bool value) override { return add(Json(value)); }
    bool number_integer(number_integer_t value) override { return add(Json(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add(Json(value)); }
    bool number_float(number_float_t value, const string_t&) override { return add(Json(value)); }
    bool string(string_t& value) override {
        return value.size() > kLongestText ? fail("the text is too long", "write at most 65536 bytes")
                                           : add(Json(std::move(value)));
    }
    bool binary(binary_t&) override { return fail("binary data", "write JSON"); }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        Level& level = levels_.back();
        level.token = name;
        if (name.size() > kLongestText) {
            return fail("the key is too long", "write at most 65536 bytes");
        }
        return level.keys.insert(name).second || fail("the key appears twice", "keep one of them");
    }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
        std::string why = "it is not JSON";
        if (error.id == 406) { // the library's number for a literal past the range of double
            why = "the number is too large";
        }
        problem = Problem{"", why + " at byte " + std::to_string(position), "mend the text there", true};
        return false;
    }

  private:
    struct Level {
        Json* value = nullptr;
        std::string token; ///< key that is being read
        std::set<std::string> keys;
    };

    bool fail(const std::string& why, const std::string& mend) {
        std::vector<std::string> path;
        for (const Level& level : levels_) {
            path.push_back(level.value->is_array() ? std::to_string(level.value->size()) : level.token);
        }
        problem = Problem{pointerText(path), why, mend, true};
        return false;
    }

    Json* place(Json&& value) {
        if (levels_.empty()) {
            document = std::move(value);
            return &document;
        }
        Json& parent = *levels_.back().value;
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        // Doubles are already sorted out, so the map need not look for them, which would take the square of the time.
        Json::object_t::Container& members = parent.get_ref<Json::object_t&>();
        members.emplace_back(levels_.back().token, std::move(value));
        return &members.back().second;
    }

    bool add(Json&& value) {
        if (++values_ > kMostValues) {
            return fail("the document is too large", "it may hold a million values");
        }
        place(std::move(value));
        return true;
    }

    bool open(Json&& value) {
        if (levels_.size() >= kDeepest) {
            return fail("the parts are nested too deeply", "nest at most 64 levels");
        }
        if (++values_ > kMostValues) {
            return fail("the document is too large", "it may hold a million values");
        }
        Json* placed = place(std::move(value));
        levels_.push_back({placed, {}, {}});
        return true;
    }

    bool close() {
        levels_.pop_back();
        return true;
    }

    std::vector<Level> levels_;
    std::size_t values_ = 0;
};

/// The document, or nothing and a problem.
std::optional<Json> parsed(const std::string& text, std::vector<Problem>& problems) {
    if (text.size() > kLongestDocument) {
        problems.push_back({"", "the text has " + std::to_string(text.size()) + " bytes", "it may have 16 MiB", true});
        return std::nullopt;
    }
    if (text.find('\0') != std::string::npos) { // the parser would take it for the end
        problems.push_back({"", "it is not JSON: it holds a zero byte", "mend the text there", true});
        return std::nullopt;
    }
    DocumentBuilder builder;
    if (!Json::sax_parse(text, &builder) || builder.problem) {
        problems.push_back(builder.problem.value_or(Problem{"", "it is not JSON", "mend the text", true}));
        return std::nullopt;
    }
    return std::move(builder.document);
}

std::string describedValue(const Json& value) {
    switch (value.type()) {
    case Json::value_t::null: return "null";
    case Json::value_t::boolean: return value.get<bool>() ? "true" : "false";
    case Json::value_t::string: return quoted(value.get_ref<const std::string&>());
    case Json::value_t::array: return "a list of " + std::to_string(value.size());
    case Json::value_t::object: return "an object";
    default: return value.dump();
    }
}

/// Reads JSON into described values.
class Reader {
  public:
    Reader(Findings& findings, std::vector<std::string> path) : findings_(findings), path_(std::move(path)) {}

    void read(const ValueType& type, void* value, const Facts& facts, const Json& json) {
        switch (type.shape) {
        case Shape::boolean: return readBoolean(type, value, facts, json);
        case Shape::integer:
        case Shape::number: return readNumber(type, value, facts, json);
        case Shape::text: return readTextValue(type, value, facts, json);
        case Shape::word: return readWord(type, value, facts, json);
        case Shape::tuple: return readTuple(type, value, facts, json);
        case Shape::list: return readList(type, value, facts, json);
        case Shape::names: return readNames(type, value, facts, json);
        case Shape::optional:
            type.assign(value, type.defaults());
            if (!json.is_null()) {
                read(*type.item, type.append(value), facts, json);
            }
            return;
        case Shape::object: return readObject(type, value, facts, json);
        case Shape::opaque: return;
        }
    }

  private:
    void report(Problem problem) {
        if (findings_.problems.size() < kMostProblems) {
            findings_.problems.push_back(std::move(problem));
        }
    }

    void wrong(const ValueType& type, const Facts& facts, const Json& json) {
        report({pointerText(path_), "it is " + describedValue(json), "write " + description::legalText(type, facts),
                true});
    }

    void readBoolean(const ValueType& type, void* value, const Facts& facts, const Json& json) {
        if (json.is_boolean()) {
            *static_cast<bool*>(value) = json.get<bool>();
        } else {
            wrong(type, facts, json);
        }
    }

    void readNumber(const ValueType& type, void* value, const Facts& facts, const Json& json) {
        const double number = json.is_number() ? json.get<double>() : 0;
        bool good = json.is_number() && std::isfinite(number);
        good = good && (!facts.low || (facts.lowExcluded ? number > *facts.low : number >= *facts.low));
        good = good && (!facts.high || number <= *facts.high);
        if (type.shape == Shape::integer) {
            good = good && number == std::floor(number) && number >= type.low && number <= type.high;
        }
        if (!good) {
            wrong(type, facts, json);
        } else if (type.shape == Shape::integer) {
            type.setInteger(value, static_cast<std::int64_t>(number));
        } else {
            *static_cast<double*>(value) = number;
        }
    }

    static bool isChoice(const std::string& word, const Facts& facts) {
        const char* const* choice = facts.choices;
        while (*choice != nullptr && word != *choice) {
            ++choice;
        }
        return *choice != nullptr;
    }

    void readTextValue(const ValueType& type, void* value, const Facts& facts, const Json& json) {
        if (!json.is_string() ||
            (facts.choices[0] != nullptr && !isChoice(json.get_ref<const std::string&>(), facts))) {
            return wrong(type, facts, json);
        }
        const auto& text = json.get_ref<const std::string&>();
        if (text.find('\0') != std::string::npos) { // ends a path early for the system
            return report({pointerText(path_), "the text holds a zero byte", "leave it out", true});
        }
        *static_cast<std::string*>(value) = text;
    }

    void readWord(const ValueType& type, void* value, const Facts& facts, const Json& json) {
        if (!json.is_string() || !isChoice(json.get_ref<const std::string&>(), facts)) {
            return wrong(type, facts, json);
        }
        std::int64_t index = 0;
        while (json.get_ref<const std::string&>() != facts.choices[index]) {
            ++index;
        }
        type.setInteger(value, index);
    }

    void readTuple(const ValueType& type, void* value, const Facts& facts, const Json& json) {
        if (!json.is_array() || json.size() != type.size) {
            return wrong(type, facts, json);
        }
        for (std::size_t i = 0; i < type.size; ++i) {
            path_.push_back(std::to_string(i));
            read(*type.item, type.at(value, i), facts, json[i]);
            path_.pop_back();
        }
    }

    void readList(const ValueType& type, void* value, const Facts& facts, const Json& json) {
        type.assign(value, type.defaults());
        if (json.is_null()) {
            return;
        }
        if (!json.is_array()) {
            return wrong(type, facts, json);
        }
        if (json.size() > facts.atMost) {
            return report({pointerText(path_), "the list has " + std::to_string(json.size()) + " items",
                           "it may have " + std::to_string(facts.atMost), true});
        }
        for (std::size_t i = 0; i < json.size(); ++i) {
            path_.push_back(std::to_string(i));
            read(*type.item, type.append(value), facts, json[i]);
            path_.pop_back();
        }
    }

    void readNames(const ValueType& type, void* value, const Facts& facts, const Json& json) {
        auto& names = *static_cast<std::map<std::string, std::string>*>(value);
        names.clear();
        if (json.is_null()) {
            return;
        }
        if (!json.is_object() || json.size() > facts.atMost) {
            return wrong(type, facts, json);
        }
        for (const auto& item : json.items()) {
            path_.push_back(item.key());
            if (item.value().is_string()) {
                names[item.key()] = item.value().get<std::string>();
            } else {
                report({pointerText(path_), "it is " + describedValue(item.value()), "write text", true});
            }
            path_.pop_back();
        }
    }

    void readObject(const ValueType& type, void* value, const Facts& facts, const Json& json) {
        type.assign(value, type.defaults());
        if (json.is_null()) {
            return;
        }
        if (!json.is_object()) {
            return wrong(type, facts, json);
        }
        const std::vector<std::string> known = description::memberNames(type);
        for (const auto& item : json.items()) {
            path_.push_back(item.key());
            if (const Field* field = fieldFor(type, item.key(), item.value())) {
                read(*field->type, field->of(value), field->facts, item.value());
            } else {
                keepUnknown(item.key(), item.value(), known);
            }
            path_.pop_back();
        }
    }

    /// Of two members that share a name, objects are the optional part's and the rest the list's.
    static const Field* fieldFor(const ValueType& type, const std::string& name, const Json& json) {
        for (const Field& field : type.fields()) {
            const bool another = field.facts.sharesName && (field.type->shape == Shape::optional) != json.is_object();
            if (field.name != nullptr && name == field.name && !another) {
                return &field;
            }
        }
        return nullptr;
    }

    void keepUnknown(const std::string& key, const Json& json, const std::vector<std::string>& known) {
        std::string pointer;
        for (const std::string& token : path_) {
            pointer += "/" + description::escapedToken(token);
        }
        if (pointer == kVersionPointer) {
            return; // read on its own, before everything else
        }
        findings_.unknown[pointer] = json.dump();
        const std::string nearest = description::nearestWord(key, known);
        report({pointerText(path_), "this version does not know it; it is kept but has no effect",
                nearest.empty() ? "" : "did you mean \"" + nearest + "\"?", false});
    }

    Findings& findings_;
    std::vector<std::string> path_;
};

/// Version of a document: the major number, and the whole text where it is a newer minor one.
struct Version {
    int major = 0;
    std::string newerMinor;
};

std::optional<Version> versionOf(const Json& document, std::vector<Problem>& problems) {
    const auto entry = document.find("limner");
    if (entry == document.end()) {
        problems.push_back(
            {kVersionPointer, "the document has no version; it is read as version 1", "write \"limner\": 1", false});
        return Version{};
    }
    const double number = entry->is_number() ? entry->get<double>() : -1;
    if (!(number >= 0)) {
        problems.push_back({kVersionPointer, "it is " + describedValue(*entry), "write 1", true});
        return std::nullopt;
    }
    if (number >= kFigureVersion + 1) {
        problems.push_back({kVersionPointer,
                            "the document has version " + entry->dump() + ", this program reads up to " +
                                std::to_string(kFigureVersion),
                            "open it with a newer Limner", true});
        return std::nullopt;
    }
    return Version{static_cast<int>(number), number > kFigureVersion ? entry->dump() : ""};
}

/// Reads the whole document; all problems go to `findings`.
Figure readDocument(const std::string& text, Findings& findings) {
    Figure figure;
    std::optional<Json> document = parsed(text, findings.problems);
    if (!document) {
        return figure;
    }
    if (!document->is_object()) {
        findings.problems.push_back(
            {"", "it is " + describedValue(*document), "a figure is an object with \"limner\": 1", true});
        return figure;
    }
    const std::optional<Version> version = versionOf(*document, findings.problems);
    if (!version) {
        return figure;
    }
    if (version->major < kFigureVersion) {
        document =
            parsed(migrated(document->dump(), version->major, kFigureVersion, migrationSteps()), findings.problems);
        if (!document) {
            return figure;
        }
    }
    const ValueType& type = description::figureType();
    Reader(findings, {}).read(type, &figure, {}, *document);
    figure.unknown = findings.unknown;
    if (!version->newerMinor.empty()) {
        figure.unknown[kVersionPointer] = version->newerMinor;
    }
    return figure;
}

} // namespace

bool description::readText(const Place& place, const std::string& json, Findings& findings) {
    std::vector<Problem> problems;
    const std::optional<Json> value = parsed(json, problems);
    if (!value) {
        return false;
    }
    std::vector<std::string> path;
    splitPointer(place.pointer, path);
    Reader(findings, std::move(path)).read(*place.type, place.value, *place.facts, *value);
    return true;
}

Figure readFigure(const std::string& text, const std::string& where, std::vector<Problem>* notes) {
    Findings findings;
    Figure figure = readDocument(text, findings);
    for (Problem& problem : findings.problems) {
        if (problem.fatal) {
            const char* gap = where.empty() || problem.pointer.empty() ? "" : " ";
            throw Error(ErrorKind::badInput,
                        {"cannot read the figure", where + gap + problem.pointer, problem.why, problem.mend});
        }
        if (notes != nullptr) {
            notes->push_back(std::move(problem));
        }
    }
    return figure;
}

std::vector<Problem> validateText(const std::string& text) {
    Findings findings;
    const Figure figure = readDocument(text, findings);
    const bool sound = std::none_of(findings.problems.begin(), findings.problems.end(),
                                    [](const Problem& problem) { return problem.fatal; });
    if (sound) {
        const std::vector<Problem> senses = validateFigure(figure);
        findings.problems.insert(findings.problems.end(), senses.begin(), senses.end());
    }
    return std::move(findings.problems);
}

} // namespace limner
