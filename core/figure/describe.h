#pragma once

#include "core/figure/described_types.h"

#include <type_traits>

namespace limner::description {

/// Makes the descriptions of C++ types; used where settings are declared.

// What the declarations share.
constexpr auto kNone = ChangeCost::none;
constexpr auto kRedraw = ChangeCost::redraw;
constexpr auto kTables = ChangeCost::newTables;
constexpr auto kPlan = ChangeCost::newPlan;
constexpr auto kFields = ChangeCost::newFields;
constexpr auto kVolume = ChangeCost::newVolume;
constexpr const char* kDataUnit = "HU or the volume's unit";
constexpr double kFarMm = 1e9; ///< a thousand kilometres: squares of lengths stay far from overflow

template <class T>
const ValueType& valueType();

namespace detail {

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {
    using Item = T;
};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {
    using Item = T;
};
template <class T>
struct IsTuple : std::false_type {};
template <>
struct IsTuple<glm::dvec2> : std::true_type {
    using Item = double;
};
template <>
struct IsTuple<glm::dvec3> : std::true_type {
    using Item = double;
};
template <>
struct IsTuple<glm::dvec4> : std::true_type {
    using Item = double;
};
template <>
struct IsTuple<BoxMm> : std::true_type {
    using Item = glm::dvec3;
};
template <class T>
struct IsShared : std::false_type {};
template <class T>
struct IsShared<std::shared_ptr<T>> : std::true_type {};

/// The members of a tuple as addresses.
inline void* tupleItem(BoxMm& box, std::size_t index) { return index == 0 ? &box.low : &box.high; }
template <glm::length_t N>
void* tupleItem(glm::vec<N, double, glm::defaultp>& v, std::size_t index) {
    return &v[static_cast<glm::length_t>(index)];
}

template <class T>
void describeInteger(ValueType& type) {
    type.integer = [](const void* v) { return static_cast<std::int64_t>(*static_cast<const T*>(v)); };
    type.setInteger = [](void* v, std::int64_t i) { *static_cast<T*>(v) = static_cast<T>(i); };
    // Beyond 2^53 a JSON number is no longer exact everywhere.
    constexpr double kExact = 9007199254740992.0;
    if constexpr (std::is_same_v<T, std::int64_t>) {
        type.low = -kExact;
        type.high = kExact;
    } else {
        type.low = -2147483648.0;
        type.high = 2147483647.0;
    }
}

template <class T>
void describeList(ValueType& type) {
    using Item = typename IsVector<T>::Item;
    type.item = &valueType<Item>();
    type.count = [](const void* v) { return static_cast<const T*>(v)->size(); };
    type.at = [](void* v, std::size_t i) -> void* { return &(*static_cast<T*>(v))[i]; };
    type.append = [](void* v) -> void* { return &static_cast<T*>(v)->emplace_back(); };
    type.erase = [](void* v, std::size_t i) {
        auto& list = *static_cast<T*>(v);
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    };
}

template <class T>
void describeOptional(ValueType& type) {
    type.item = &valueType<typename IsOptional<T>::Item>();
    type.count = [](const void* v) -> std::size_t { return static_cast<const T*>(v)->has_value() ? 1 : 0; };
    type.at = [](void* v, std::size_t) -> void* { return &**static_cast<T*>(v); };
    type.append = [](void* v) -> void* { return &static_cast<T*>(v)->emplace(); };
}

template <class T>
void describeTuple(ValueType& type) {
    using Item = typename IsTuple<T>::Item;
    type.item = &valueType<Item>();
    type.size = sizeof(T) / sizeof(Item);
    type.count = [](const void*) -> std::size_t { return sizeof(T) / sizeof(Item); };
    type.at = [](void* v, std::size_t i) { return tupleItem(*static_cast<T*>(v), i); };
}

template <class T>
ValueType makeType() {
    ValueType type;
    type.equal = [](const void* a, const void* b) { return *static_cast<const T*>(a) == *static_cast<const T*>(b); };
    type.assign = [](void* to, const void* from) { *static_cast<T*>(to) = *static_cast<const T*>(from); };
    type.defaults = []() -> const void* {
        static const T fresh{};
        return &fresh;
    };
    if constexpr (std::is_same_v<T, bool>) {
        type.shape = Shape::boolean;
    } else if constexpr (std::is_same_v<T, double>) {
        type.shape = Shape::number;
    } else if constexpr (std::is_enum_v<T> || std::is_integral_v<T>) {
        type.shape = std::is_enum_v<T> ? Shape::word : Shape::integer;
        describeInteger<T>(type);
    } else if constexpr (std::is_same_v<T, std::string>) {
        type.shape = Shape::text;
    } else if constexpr (std::is_same_v<T, std::map<std::string, std::string>>) {
        type.shape = Shape::names;
    } else if constexpr (IsVector<T>::value) {
        type.shape = Shape::list;
        describeList<T>(type);
    } else if constexpr (IsOptional<T>::value) {
        type.shape = Shape::optional;
        describeOptional<T>(type);
    } else if constexpr (IsTuple<T>::value) {
        type.shape = Shape::tuple;
        describeTuple<T>(type);
    } else if constexpr (!IsShared<T>::value) {
        type.shape = Shape::object;
        type.fields = [] { return fieldsOf<T>(); };
    }
    return type;
}

template <class>
struct MemberOf;
template <class Owner, class Member>
struct MemberOf<Member Owner::*> {
    using Object = Owner;
    using Value = Member;
};

} // namespace detail

template <class T>
const ValueType& valueType() {
    static const ValueType type = detail::makeType<T>();
    return type;
}

/// Describes the member `Pointer` under its JSON name.
template <auto Pointer>
Field field(const char* name, const Facts& facts) {
    using Traits = detail::MemberOf<decltype(Pointer)>;
    return {name, facts, &valueType<typename Traits::Value>(),
            [](void* object) -> void* { return &(static_cast<typename Traits::Object*>(object)->*Pointer); }};
}

/// Describes a member that is no part of the document, with what its change costs.
template <auto Pointer>
Field outside(ChangeCost cost) {
    Facts facts;
    facts.cost = cost;
    return field<Pointer>(nullptr, facts);
}

} // namespace limner::description
