#pragma once

#include "core/figure/figure_json.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limner::description {

/// How the value types of figure.h are made, told once (parameters.cpp) and read by everything that handles settings:
/// JSON both ways, `--set`, validation, `diff`, the parameter table. Type-erased, so that none of these is a template.
/// Internal to core/figure. Immutable after the first call, thread-safe.

struct ValueType;

/// What a setting is, apart from its name and place.
struct Facts {
    const char* label = "";
    const char* help = "";
    ChangeCost cost = ChangeCost::redraw; ///< of a change of this value; of a part: of its coming or going
    const char* unit = "";
    std::optional<double> low = std::nullopt; ///< of each number inside
    std::optional<double> high = std::nullopt;
    bool lowExcluded = false;
    const char* choices[10] = {}; ///< legal words, null-terminated; for an enum in its order
    std::size_t atMost = 65536;   ///< longest list: far above any sane figure, so that a file cannot exhaust us
    bool omitDefault = false;     ///< left out of the file while it has its default
    bool whole = false;           ///< any change inside costs `cost` at least
    bool (*written)(const void*) = nullptr; ///< of the owning object, instead of `omitDefault`
    bool sharesName = false;                ///< two members, one name: told apart by array or object
};

/// A member. Without a name it is not part of the document (loaded data), but still of `diff`.
struct Field {
    const char* name = nullptr;
    Facts facts;
    const ValueType* type = nullptr;
    void* (*member)(void* object) = nullptr;

    [[nodiscard]] void* of(void* object) const { return member(object); }
    [[nodiscard]] const void* of(const void* object) const { return member(const_cast<void*>(object)); }
};

enum class Shape {
    boolean,
    integer,
    number,
    text,
    word,     ///< an enum, written as one of the field's choices
    tuple,    ///< a fixed count of equal items: vectors, boxes
    list,     ///< any count of equal items
    names,    ///< std::map<std::string, std::string>
    optional, ///< absent or one item
    object,   ///< fields
    opaque,   ///< shared data: compared, never written
};

/// The operations on one C++ type; those that a shape lacks are null.
struct ValueType {
    Shape shape = Shape::opaque;
    std::size_t size = 0; ///< tuple: how many items
    const ValueType* item = nullptr;
    std::span<const Field> (*fields)() = nullptr;
    bool (*equal)(const void*, const void*) = nullptr;
    void (*assign)(void*, const void*) = nullptr;
    const void* (*defaults)() = nullptr; ///< a value as a fresh one of this type is
    std::int64_t (*integer)(const void*) = nullptr;
    void (*setInteger)(void*, std::int64_t) = nullptr;
    double low = 0; ///< integer: what the type can hold
    double high = 0;
    std::size_t (*count)(const void*) = nullptr; ///< list, tuple; optional: 0 or 1
    void* (*at)(void*, std::size_t) = nullptr;
    void* (*append)(void*) = nullptr; ///< list: a new last item; optional: makes it present
    void (*erase)(void*, std::size_t) = nullptr;

    [[nodiscard]] const void* itemAt(const void* value, std::size_t index) const {
        return at(const_cast<void*>(value), index);
    }
};

/// What is legal for a value, in words: "a number > 0 mm".
std::string legalText(const ValueType& type, const Facts& facts);

/// JSON text of a value as the document writes it; compact. Throws Error(badInput) for a number that is not finite.
std::string valueText(const ValueType& type, const void* value, const Facts& facts);

/// What reading found: problems in document order, and members that are not described, by pointer.
struct Findings {
    std::vector<Problem> problems;
    UnknownMembers unknown;
};

/// A value inside a figure.
struct Place {
    const ValueType* type = nullptr;
    void* value = nullptr;
    const Facts* facts = nullptr;
    std::string pointer;
};

/// Reads JSON text into a place; what is wrong stays at its default and is reported. False where the text is no JSON.
bool readText(const Place& place, const std::string& json, Findings& findings);

/// The known word nearest to a mistyped one, or empty where none is near.
std::string nearestWord(const std::string& word, std::span<const std::string> known);

/// Names of an object's members, in document order.
std::vector<std::string> memberNames(const ValueType& object);

/// Tokens of a JSON pointer, unescaped; "" has none. False for text that is no pointer.
bool splitPointer(std::string_view pointer, std::vector<std::string>& tokens);
std::string escapedToken(const std::string& token);

/// The type of `Figure` itself.
const ValueType& figureType();

} // namespace limner::description
