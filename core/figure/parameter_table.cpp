#include "core/figure/description.h"

#include <algorithm>
#include <numeric>

namespace limner {

using description::Facts;
using description::Field;
using description::Shape;
using description::ValueType;

namespace {

ParameterType parameterType(const ValueType& type, const Facts& facts) {
    switch (type.shape) {
    case Shape::boolean: return ParameterType::boolean;
    case Shape::integer: return ParameterType::integer;
    case Shape::number: return ParameterType::number;
    case Shape::text: return facts.choices[0] != nullptr ? ParameterType::choice : ParameterType::text;
    case Shape::word: return ParameterType::choice;
    case Shape::tuple: return type.item->shape == Shape::number ? ParameterType::vector : ParameterType::list;
    case Shape::list:
        // Pairs of numbers: a curve or an outline.
        return type.item->shape == Shape::tuple && type.item->size == 2 ? ParameterType::curve : ParameterType::list;
    case Shape::optional: return parameterType(*type.item, facts);
    case Shape::names:
    case Shape::object:
    case Shape::opaque: break;
    }
    return ParameterType::object;
}

/// Walks the description and lists what it meets.
class TableBuilder {
  public:
    std::vector<Parameter> build() {
        addMembers(description::figureType(), "", ChangeCost::none);
        return std::move(table_);
    }

  private:
    /// `floor`: what any change costs at least, told by an enclosing part.
    void addMembers(const ValueType& object, const std::string& pointer, ChangeCost floor) {
        for (const Field& field : object.fields()) {
            if (field.name != nullptr) {
                add(object, field, pointer + "/" + field.name, floor);
            }
        }
    }

    void add(const ValueType& owner, const Field& field, const std::string& pointer, ChangeCost floor) {
        const ValueType& type = *field.type;
        const bool known = !table_.empty() && std::any_of(table_.begin(), table_.end(),
                                                          [&](const Parameter& p) { return p.pointer == pointer; });
        if (!known) {
            const std::string fresh = description::valueText(type, field.of(owner.defaults()), field.facts);
            table_.push_back(parameter(type, field.facts, pointer, std::max(floor, field.facts.cost)));
            table_.back().defaultJson = fresh;
        }
        addInside(type, field.facts, pointer, field.facts.whole ? std::max(floor, field.facts.cost) : floor);
    }

    void addInside(const ValueType& type, const Facts& facts, const std::string& pointer, ChangeCost floor) {
        if (type.shape == Shape::object) {
            addMembers(type, pointer, floor);
        } else if (type.shape == Shape::optional) {
            addInside(*type.item, facts, pointer, floor);
        } else if (type.shape == Shape::list && type.item->shape == Shape::object) {
            table_.push_back(parameter(*type.item, facts, pointer + "/*", std::max(floor, facts.cost)));
            table_.back().defaultJson = "{}";
            addMembers(*type.item, pointer + "/*", floor);
        } else if (type.shape == Shape::names) {
            table_.push_back(parameter(type, facts, pointer + "/*", std::max(floor, facts.cost)));
            table_.back().type = ParameterType::text;
            table_.back().defaultJson = "\"\"";
        }
    }

    static Parameter parameter(const ValueType& type, const Facts& facts, const std::string& pointer, ChangeCost cost) {
        Parameter result;
        result.pointer = pointer;
        result.type = parameterType(type, facts);
        result.unit = facts.unit;
        result.low = facts.low;
        result.high = facts.high;
        result.lowExcluded = facts.lowExcluded;
        for (const char* const* word = facts.choices; *word != nullptr; ++word) {
            result.choices.emplace_back(*word);
        }
        result.label = facts.label;
        result.help = facts.help;
        result.cost = cost;
        return result;
    }

    std::vector<Parameter> table_;
};

bool isIndex(const std::string& token) {
    return token == "-" || (!token.empty() && token.find_first_not_of("0123456789") == std::string::npos);
}

/// Edits that make one word of the other: insertions, deletions and exchanged letters.
std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::span<const Parameter> parameterTable() {
    static const std::vector<Parameter> table = TableBuilder().build();
    return table;
}

const Parameter* findParameter(std::string_view pointer) {
    std::vector<std::string> tokens;
    if (!description::splitPointer(pointer, tokens)) {
        return nullptr;
    }
    for (const Parameter& parameter : parameterTable()) {
        std::vector<std::string> pattern;
        description::splitPointer(parameter.pointer, pattern);
        const auto fits = [&](const std::string& want, const std::string& token) {
            // Names of labels are numbers too, so `*` always stands for a number.
            return want == token || (want == "*" && isIndex(token));
        };
        if (std::equal(pattern.begin(), pattern.end(), tokens.begin(), tokens.end(), fits)) {
            return &parameter;
        }
    }
    return nullptr;
}

namespace description {

std::string nearestWord(const std::string& word, std::span<const std::string> known) {
    constexpr std::size_t kLongest = 64; // no key is that long: not a slip of the finger
    std::string nearest;
    // A slip or two, or a third of the letters: "thicknes", "heightmm", "opacty".
    std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (const std::string& candidate : known) {
        const std::size_t distance = word.size() > kLongest ? least : editDistance(word, candidate);
        if (distance < least && distance < candidate.size()) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::vector<std::string> memberNames(const ValueType& object) {
    std::vector<std::string> names;
    for (const Field& field : object.fields()) {
        if (field.name != nullptr && (names.empty() || names.back() != field.name)) {
            names.emplace_back(field.name);
        }
    }
    return names;
}

bool splitPointer(std::string_view pointer, std::vector<std::string>& tokens) {
    tokens.clear();
    if (pointer.empty()) {
        return true;
    }
    if (pointer.front() != '/') {
        return false;
    }
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        const char c = pointer[i];
        if (c == '/') {
            tokens.emplace_back();
        } else if (c != '~') {
            tokens.back() += c;
        } else if (i + 1 < pointer.size() && (pointer[i + 1] == '0' || pointer[i + 1] == '1')) {
            tokens.back() += pointer[++i] == '0' ? '~' : '/';
        } else {
            return false;
        }
    }
    return true;
}

std::string escapedToken(const std::string& token) {
    std::string escaped;
    for (const char c : token) {
        escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    }
    return escaped;
}

namespace {

std::string shortNumber(double value) {
    std::string text = std::to_string(value);
    if (value >= 1e6 || value <= -1e6) {
        char buffer[32];
        std::snprintf(buffer, sizeof buffer, "%g", value);
        return buffer;
    }
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
        text.pop_back();
    }
    return text;
}

std::string rangeText(const Facts& facts) {
    std::string text;
    if (facts.low && facts.high) {
        text = facts.lowExcluded ? " > " + shortNumber(*facts.low) + " up to " + shortNumber(*facts.high)
                                 : " from " + shortNumber(*facts.low) + " to " + shortNumber(*facts.high);
    } else if (facts.low) {
        text = (facts.lowExcluded ? " > " : " >= ") + shortNumber(*facts.low);
    } else if (facts.high) {
        text = " <= " + shortNumber(*facts.high);
    }
    return *facts.unit == '\0' ? text : text + " (" + facts.unit + ")";
}

std::string choicesText(const Facts& facts) {
    std::string text = "one of ";
    for (const char* const* word = facts.choices; *word != nullptr; ++word) {
        text += (word == facts.choices ? "\"" : ", \"") + std::string(*word) + "\"";
    }
    return text;
}

std::string objectText(const ValueType& type) {
    std::string text = "an object with ";
    for (const std::string& name : memberNames(type)) {
        text += (text.back() == ' ' ? "" : ", ") + name;
    }
    return text;
}

} // namespace

std::string legalText(const ValueType& type, const Facts& facts) {
    switch (type.shape) {
    case Shape::boolean: return "true or false";
    case Shape::integer: return "a whole number" + rangeText(facts);
    case Shape::number: return "a number" + rangeText(facts);
    case Shape::text: return facts.choices[0] != nullptr ? choicesText(facts) : "text";
    case Shape::word: return choicesText(facts);
    case Shape::tuple:
        return "a list of " + std::to_string(type.size) +
               (type.item->shape == Shape::number ? " numbers" + rangeText(facts)
                                                  : ", each " + legalText(*type.item, facts));
    case Shape::list: return "a list, each item " + legalText(*type.item, facts);
    case Shape::names: return "an object of numbers and their names";
    case Shape::optional: return legalText(*type.item, facts) + ", or null";
    case Shape::object: return objectText(type);
    case Shape::opaque: break;
    }
    return "";
}

} // namespace description
} // namespace limner
