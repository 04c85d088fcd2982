#include "core/figure/variants.h"

#include "core/figure/figure_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

namespace limner {
namespace {

using Json = nlohmann::ordered_json;

/// Members of a figure whose numbers are looked at; the others are its subject, or lists of places.
constexpr const char* kVariedParts[] = {"layers", "importance", "depth_cues", "stipple"};
constexpr double kFar = 1e3; // a setting with a farther end has no range worth trying but the one around what it is

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

void setRange(VariedSetting& setting, const Parameter& parameter) {
    const double low = *parameter.low;
    const double high = *parameter.high;
    // From a quarter to twice what it is; where it is nothing, all that is legal, or the first unit of it.
    setting.from = setting.now > 0 ? setting.now / 4 : low;
    setting.to = setting.now > 0 ? setting.now * 2 : std::min(high, high - low > kFar ? low + 1 : high);
    if (setting.now < 0) {
        setting.from = setting.now * 2;
        setting.to = -setting.now * 2;
    }
    setting.from = std::clamp(setting.from, low, high);
    setting.to = std::clamp(setting.to, low, high);
    if (parameter.lowExcluded && setting.from <= low)
        setting.from = low + (setting.to - low) / 16;
}

/// The pointer with `*` for places in lists, as the parameter table writes it.
std::string patternOf(const std::string& pointer) {
    std::string pattern;
    for (std::size_t at = 0; at < pointer.size();) {
        const std::size_t end = std::min(pointer.find('/', at + 1), pointer.size());
        const bool place = pointer.find_first_not_of("0123456789", at + 1) >= end;
        pattern += place ? "/*" : pointer.substr(at, end - at);
        at = end;
    }
    return pattern;
}

struct Collector {
    std::vector<VariedSetting> settings;

    /// The numbers of an object, also those that are not written because they are as always; then of the objects in it.
    void walk(const Json& json, const std::string& pointer, const std::string& owner) {
        const std::string inside = patternOf(pointer) + "/";
        for (const Parameter& parameter : parameterTable()) {
            if (!parameter.pointer.starts_with(inside) ||
                parameter.pointer.find('/', inside.size()) != std::string::npos)
                continue;
            const std::string name = parameter.pointer.substr(inside.size());
            const Json now = json.contains(name) ? json[name] : Json::parse(parameter.defaultJson, nullptr, false);
            if (now.is_number())
                add(parameter, now.get<double>(), {pointer + "/" + name, owner});
        }
        for (const auto& [key, value] : json.items())
            if (value.is_object())
                walk(value, pointer + "/" + key, owner);
    }

    struct Place {
        std::string pointer;
        std::string owner;
    };
    void add(const Parameter& parameter, double now, const Place& place) {
        const bool varies = parameter.type == ParameterType::number && parameter.low && parameter.high &&
                            *parameter.low < *parameter.high;
        if (!varies)
            return;
        const std::string label = (place.owner.empty() ? "" : place.owner + ": ") + parameter.label;
        VariedSetting setting{place.pointer, label, parameter.unit, now, 0, 1};
        setRange(setting, parameter);
        if (setting.from < setting.to)
            settings.push_back(setting);
    }
};

} // namespace

std::vector<VariedSetting> variedSettings(const Figure& figure) {
    const Json json = Json::parse(writeFigure(figure));
    Collector collector;
    for (const char* part : kVariedParts) {
        if (!json.contains(part) || json[part].is_null())
            continue;
        const std::string pointer = std::string("/") + part;
        if (std::string(part) != "layers") {
            collector.walk(json[part], pointer, {});
            continue;
        }
        for (std::size_t i = 0; i < json[part].size(); ++i)
            collector.walk(json[part][i], pointer + "/" + std::to_string(i), figure.layers[i].name);
    }
    return collector.settings;
}

std::vector<Variant> variantsOf(const Figure& figure, const VariedSetting& setting, int count) {
    assert(count >= 2);
    std::vector<Variant> variants;
    for (int i = 0; i < count; ++i) {
        const double value = setting.from + (setting.to - setting.from) * i / (count - 1);
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", value);
        variants.push_back({number(value) + (setting.unit.empty() || setting.unit == "sRGB" ? "" : " " + setting.unit),
                            withSetting(figure, setting.pointer + "=" + text)});
    }
    return variants;
}

} // namespace limner
