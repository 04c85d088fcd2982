#include "core/base/error.h"
#include "core/figure/description.h"
#include "core/figure/migration.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace limner {

using description::Facts;
using description::Field;
using description::Shape;
using description::ValueType;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t kLineLength = 110; ///< a part that fits such a line is written on one

/// Writes values as JSON; keeps the way there for messages.
class Writer {
  public:
    Json write(const ValueType& type, const void* value, const Facts& facts) {
        switch (type.shape) {
        case Shape::boolean: return *static_cast<const bool*>(value);
        case Shape::integer: return type.integer(value);
        case Shape::number: return number(*static_cast<const double*>(value));
        case Shape::text: return *static_cast<const std::string*>(value);
        case Shape::word: return facts.choices[type.integer(value)];
        case Shape::tuple:
        case Shape::list: return list(type, value, facts);
        case Shape::names: return names(*static_cast<const std::map<std::string, std::string>*>(value));
        case Shape::optional: return type.count(value) == 0 ? Json() : write(*type.item, type.itemAt(value, 0), facts);
        case Shape::object: return object(type, value);
        case Shape::opaque: break;
        }
        return {};
    }

  private:
    Json number(double value) const {
        if (!std::isfinite(value)) {
            std::string pointer;
            for (const std::string& token : path_) {
                pointer += "/" + description::escapedToken(token);
            }
            throw Error(ErrorKind::badInput,
                        {"cannot write the figure", pointer, "the number is not finite", "give it a finite value"});
        }
        constexpr double kWhole = 1e15; // whole numbers below are exact and read better without a point
        const bool whole = value == std::floor(value) && std::abs(value) < kWhole;
        const bool negativeZero = value == 0 && std::signbit(value);
        return whole && !negativeZero ? Json(static_cast<std::int64_t>(value)) : Json(value);
    }

    Json list(const ValueType& type, const void* value, const Facts& facts) {
        Json result = Json::array();
        for (std::size_t i = 0; i < type.count(value); ++i) {
            path_.push_back(std::to_string(i));
            result.push_back(write(*type.item, type.itemAt(value, i), facts));
            path_.pop_back();
        }
        return result;
    }

    static Json names(const std::map<std::string, std::string>& map) {
        Json result = Json::object();
        for (const auto& [key, name] : map) {
            result[key] = name;
        }
        return result;
    }

    Json object(const ValueType& type, const void* value) {
        Json result = Json::object();
        for (const Field& field : type.fields()) {
            if (field.name == nullptr || !isWritten(type, field, value)) {
                continue;
            }
            path_.emplace_back(field.name);
            result[field.name] = write(*field.type, field.of(value), field.facts);
            path_.pop_back();
        }
        return result;
    }

    static bool isWritten(const ValueType& owner, const Field& field, const void* object) {
        if (field.facts.written != nullptr) {
            return field.facts.written(object);
        }
        return !field.facts.omitDefault || !field.type->equal(field.of(object), field.of(owner.defaults()));
    }

    std::vector<std::string> path_;
};

/// Indented text in which small parts stand on one line.
class Layout {
  public:
    std::string text(const Json& value) {
        print(value, 0, 0);
        text_ += '\n';
        return std::move(text_);
    }

  private:
    static std::string compact(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

    /// `used`: what already stands on the line.
    void print(const Json& value, std::size_t indent, std::size_t used) {
        const bool open = value.is_structured() && !value.empty();
        if (!open || (indent > 0 && inlineLength(value) + indent + used < kLineLength)) {
            printInline(value);
            return;
        }
        const std::string margin(indent + 2, ' ');
        text_ += value.is_object() ? "{\n" : "[\n";
        bool first = true;
        for (const auto& item : value.items()) {
            text_ += first ? "" : ",\n";
            first = false;
            text_ += margin;
            std::size_t keyLength = 0;
            if (value.is_object()) {
                const std::string key = compact(item.key());
                text_ += key + ": ";
                keyLength = key.size() + 2;
            }
            print(item.value(), indent + 2, keyLength);
        }
        text_ += '\n' + std::string(indent, ' ') + (value.is_object() ? '}' : ']');
    }

    /// Length on one line, or a number past any line as soon as that is sure.
    static std::size_t inlineLength(const Json& value) {
        if (!value.is_structured()) {
            return compact(value).size();
        }
        std::size_t length = 2;
        for (const auto& item : value.items()) {
            length += 2 + (value.is_object() ? item.key().size() + 4 : 0) + inlineLength(item.value());
            if (length > kLineLength) {
                break;
            }
        }
        return length;
    }

    void printInline(const Json& value) {
        if (!value.is_structured() || value.empty()) {
            text_ += compact(value);
            return;
        }
        text_ += value.is_object() ? "{ " : "[";
        bool first = true;
        for (const auto& item : value.items()) {
            text_ += first ? "" : ", ";
            first = false;
            if (value.is_object()) {
                text_ += compact(item.key()) + ": ";
            }
            printInline(item.value());
        }
        text_ += value.is_object() ? " }" : "]";
    }

    std::string text_;
};

/// The value that a pointer without its last token leads to, or null.
Json* parentOf(Json& root, const std::vector<std::string>& tokens) {
    Json* place = &root;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (place->is_object() && place->contains(tokens[i])) {
            place = &(*place)[tokens[i]];
        } else if (place->is_array() && !tokens[i].empty() && tokens[i].size() < 9 &&
                   tokens[i].find_first_not_of("0123456789") == std::string::npos &&
                   std::stoul(tokens[i]) < place->size()) {
            place = &(*place)[std::stoul(tokens[i])];
        } else {
            return nullptr;
        }
    }
    return place;
}

/// Puts members back that this version does not know; those whose part is gone go with it.
void restoreUnknown(Json& root, const UnknownMembers& unknown) {
    for (const auto& [pointer, text] : unknown) {
        std::vector<std::string> tokens;
        if (!description::splitPointer(pointer, tokens) || tokens.empty()) {
            continue;
        }
        Json* parent = parentOf(root, tokens);
        Json value = Json::parse(text, nullptr, false);
        if (parent != nullptr && parent->is_object() && !parent->contains(tokens.back()) && !value.is_discarded()) {
            (*parent)[tokens.back()] = std::move(value);
        }
    }
}

} // namespace

std::string description::valueText(const ValueType& type, const void* value, const Facts& facts) {
    return Writer().write(type, value, facts).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string writeFigure(const Figure& figure) {
    Json document = Json::object();
    // A newer minor version of the file's writer stays on record with the members that only it knows.
    const auto version = figure.unknown.find(kVersionPointer);
    const Json newer = version == figure.unknown.end() ? Json() : Json::parse(version->second, nullptr, false);
    document["limner"] = newer.is_number() ? newer : Json(kFigureVersion);
    document.update(Writer().write(description::figureType(), &figure, {}));
    restoreUnknown(document, figure.unknown);
    return Layout().text(document);
}

} // namespace limner
