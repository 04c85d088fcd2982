#include "core/figure/description.h"

#include <algorithm>

namespace limner {

using description::Facts;
using description::Field;
using description::Shape;
using description::ValueType;

namespace {

ChangeCost changeCost(const ValueType& type, const void* before, const void* after, const Facts& facts);

ChangeCost membersCost(const ValueType& type, const void* before, const void* after) {
    ChangeCost dearest = ChangeCost::none;
    for (const Field& field : type.fields()) {
        dearest = std::max(dearest, changeCost(*field.type, field.of(before), field.of(after), field.facts));
    }
    return dearest;
}

/// Lists and optional parts: their own cost when something comes or goes, else what changed inside.
ChangeCost itemsCost(const ValueType& type, const void* before, const void* after, const Facts& facts) {
    const std::size_t count = type.count(before);
    if (count != type.count(after)) {
        return facts.cost;
    }
    ChangeCost dearest = ChangeCost::none;
    for (std::size_t i = 0; i < count; ++i) {
        dearest = std::max(dearest, changeCost(*type.item, type.itemAt(before, i), type.itemAt(after, i), facts));
    }
    return dearest;
}

ChangeCost changeCost(const ValueType& type, const void* before, const void* after, const Facts& facts) {
    if (type.equal(before, after)) {
        return ChangeCost::none;
    }
    ChangeCost inside = facts.cost;
    if (type.shape == Shape::object) {
        inside = membersCost(type, before, after);
    } else if (type.shape == Shape::list || type.shape == Shape::optional) {
        inside = itemsCost(type, before, after, facts);
    }
    return facts.whole ? std::max(inside, facts.cost) : inside;
}

} // namespace

ChangeCost diff(const Figure& before, const Figure& after) {
    return changeCost(description::figureType(), &before, &after, {});
}

} // namespace limner
