#include "core/base/error.h"
#include "core/figure/describe.h"
#include "core/figure/figure_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>
#include <sstream>

namespace limner {
namespace {

using Json = nlohmann::json;
using description::Field;
using description::fieldsOf;

template <class... Members>
std::size_t count(Members&...) {
    return sizeof...(Members);
}

/// A member more in a value type does not compile here (structured bindings name every one), and then fails the
/// comparison below until it is described.
template <class T>
std::size_t described() {
    const auto fields = fieldsOf<T>();
    std::set<void*> members;
    T object{};
    for (const Field& field : fields) {
        members.insert(field.of(&object));
        EXPECT_TRUE(field.name == nullptr || (*field.facts.label != '\0' && *field.facts.help != '\0')) << field.name;
    }
    EXPECT_EQ(members.size(), fields.size()) << "a member is described twice";
    return members.size();
}

#define EXPECT_ALL_DESCRIBED(Type, ...)                                                                                \
    do {                                                                                                               \
        Type object{};                                                                                                 \
        auto& [__VA_ARGS__] = object;                                                                                  \
        EXPECT_EQ(described<Type>(), count(__VA_ARGS__)) << #Type;                                                     \
    } while (false)

TEST(Description, CoversEveryMember) {
    EXPECT_ALL_DESCRIBED(VolumeReference, a, b, c, d, e, f, g, h);
    EXPECT_ALL_DESCRIBED(Camera, a, b, c, d, e, f);
    EXPECT_ALL_DESCRIBED(ClipPlane, a, b);
    EXPECT_ALL_DESCRIBED(CutFace, a, b);
    EXPECT_ALL_DESCRIBED(Clip, a, b, c);
    EXPECT_ALL_DESCRIBED(CleanupStep, a, b, c, d, e, f, g, h, i, j);
    EXPECT_ALL_DESCRIBED(LabelReference, a, b, c, d, e);
    EXPECT_ALL_DESCRIBED(StyleTexture, a, b, c, d);
    EXPECT_ALL_DESCRIBED(StyleEntry, a, b, c, d, e, f, g, h);
    EXPECT_ALL_DESCRIBED(TransferNode, a, b, c);
    EXPECT_ALL_DESCRIBED(TransferGrid, a, b, c);
    EXPECT_ALL_DESCRIBED(OpacityShape, a, b, c, d, e, f, g);
    EXPECT_ALL_DESCRIBED(DistanceOrigin, a, b);
    EXPECT_ALL_DESCRIBED(Transfer, a, b, c, d, e, f, g, h, i);
    EXPECT_ALL_DESCRIBED(Contours, a, b, c, d);
    EXPECT_ALL_DESCRIBED(Light, a, b);
    EXPECT_ALL_DESCRIBED(ColourKey, a, b);
    EXPECT_ALL_DESCRIBED(Tone, a, b, c);
    EXPECT_ALL_DESCRIBED(Silhouette, a, b, c);
    EXPECT_ALL_DESCRIBED(PhongLight, a, b);
    EXPECT_ALL_DESCRIBED(Specular, a, b);
    EXPECT_ALL_DESCRIBED(RampKey, a, b);
    EXPECT_ALL_DESCRIBED(PositionRamp, a, b, c);
    EXPECT_ALL_DESCRIBED(DepthOfField, a, b);
    EXPECT_ALL_DESCRIBED(Layer, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u);
    EXPECT_ALL_DESCRIBED(ImportanceWeights, a, b, c, d, e, f, g, h);
    EXPECT_ALL_DESCRIBED(Lens, a, b, c, d, e, f, g, h, i, j, k);
    EXPECT_ALL_DESCRIBED(SilhouetteMeasure, a, b, c);
    EXPECT_ALL_DESCRIBED(LightingMeasure, a, b, c, d);
    EXPECT_ALL_DESCRIBED(ObjectImportance, a, b);
    EXPECT_ALL_DESCRIBED(Importance, a, b, c, d, e, f, g, h, i, j);
    EXPECT_ALL_DESCRIBED(AmbientOcclusion, a, b);
    EXPECT_ALL_DESCRIBED(ContactShadow, a, b, c, d);
    EXPECT_ALL_DESCRIBED(Halo, a, b, c, d);
    EXPECT_ALL_DESCRIBED(DepthCues, a, b, c);
    EXPECT_ALL_DESCRIBED(StippleBoundary, a, b, c);
    EXPECT_ALL_DESCRIBED(StippleSilhouette, a, b, c);
    EXPECT_ALL_DESCRIBED(StippleResolution, a);
    EXPECT_ALL_DESCRIBED(StippleDistance, a);
    EXPECT_ALL_DESCRIBED(StippleInterior, a);
    EXPECT_ALL_DESCRIBED(StippleLighting, a, b);
    EXPECT_ALL_DESCRIBED(StippleCurves, a, b, c, d, e, f);
    EXPECT_ALL_DESCRIBED(StippleInnerLines, a, b, c);
    EXPECT_ALL_DESCRIBED(StippleHatching, a, b, c);
    EXPECT_ALL_DESCRIBED(Stipple, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v);
    EXPECT_ALL_DESCRIBED(Background, a, b, c, d);
    EXPECT_ALL_DESCRIBED(Annotation, a, b, c, d, e, f, g, h, i);
    EXPECT_ALL_DESCRIBED(Output, a, b, c, d);
    EXPECT_ALL_DESCRIBED(Quality, a, b, c, d, e, f, g, h, i, j);
    EXPECT_ALL_DESCRIBED(Figure, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r);
}

TEST(ParameterTable, IsInOrderAndComplete) {
    std::set<std::string> pointers;
    for (const Parameter& parameter : parameterTable()) {
        EXPECT_TRUE(pointers.insert(parameter.pointer).second) << parameter.pointer;
        EXPECT_FALSE(parameter.label.empty()) << parameter.pointer;
        EXPECT_TRUE(parameter.help.ends_with('.')) << parameter.pointer;
        EXPECT_EQ(parameter.type == ParameterType::choice,
                  !parameter.choices.empty() && parameter.pointer.find("axes") == std::string::npos)
            << parameter.pointer;
        EXPECT_TRUE(Json::accept(parameter.defaultJson)) << parameter.pointer << " " << parameter.defaultJson;
        const std::size_t slash = parameter.pointer.rfind('/');
        EXPECT_TRUE(slash == 0 || pointers.count(parameter.pointer.substr(0, slash)) > 0) << parameter.pointer;
    }
    EXPECT_GT(pointers.size(), 150u);
    EXPECT_EQ(parameterTable().front().pointer, "/title");
    EXPECT_EQ(parameterTable().back().pointer, "/quality/tolerance_metric");
}

TEST(ParameterTable, FindsConcretePointers) {
    const Parameter* thickness = findParameter("/layers/0/contours/thickness_mm");
    ASSERT_NE(thickness, nullptr);
    EXPECT_EQ(thickness->pointer, "/layers/*/contours/thickness_mm");
    EXPECT_EQ(thickness->type, ParameterType::number);
    EXPECT_EQ(thickness->defaultJson, "0.8");
    EXPECT_EQ(findParameter("/layers/-/name")->pointer, "/layers/*/name");
    EXPECT_EQ(findParameter("/layers/bone/name"), nullptr);
    EXPECT_EQ(findParameter("/camera/zoom"), nullptr);
    EXPECT_EQ(findParameter("camera"), nullptr);
    EXPECT_EQ(findParameter("/camera/target_mm")->type, ParameterType::vector);
    EXPECT_EQ(findParameter("/layers/1/transfer/opacity")->type, ParameterType::curve);
    EXPECT_EQ(findParameter("/quality/gradient")->choices.front(), "auto");
    EXPECT_EQ(findParameter("/labels/names/12")->type, ParameterType::text);
    // A camera of a lasso decides what matter is left.
    EXPECT_EQ(findParameter("/cleanup/0/camera/height_mm")->cost, ChangeCost::newFields);
    EXPECT_EQ(findParameter("/camera/height_mm")->cost, ChangeCost::redraw);
}

/// Every part present, so that every setting can be reached.
Figure fullFigure() {
    std::ifstream file(std::string(LIMNER_SOURCE_DIR) + "/tests/core/figure/example_figure.json");
    std::ostringstream text;
    text << file.rdbuf();
    return readFigure(text.str(), "example");
}

std::string concrete(std::string pointer) {
    for (std::size_t star = pointer.find('*'); star != std::string::npos; star = pointer.find('*')) {
        pointer.replace(star, 1, pointer.starts_with("/labels/names") ? "1" : "0");
    }
    return pointer;
}

/// Some legal value that differs from `now`.
std::string otherValue(const Parameter& parameter, const Json& now) {
    switch (parameter.type) {
    case ParameterType::boolean: return now == true ? "false" : "true";
    case ParameterType::choice: return parameter.choices[now == parameter.choices[0] ? 1 : 0];
    case ParameterType::text: return "another text";
    case ParameterType::integer:
    case ParameterType::number: {
        const double low = parameter.low.value_or(0);
        const double high = parameter.high.value_or(low + 10);
        const double step = parameter.type == ParameterType::integer ? 1 : std::min(1.0, (high - low) / 4);
        return Json(now == low + step ? low + 2 * step : low + step).dump();
    }
    case ParameterType::vector: {
        const double inside = parameter.low && parameter.high ? (*parameter.low + 3 * *parameter.high) / 4 : 0.75;
        const std::size_t size = now.is_array() ? now.size() : Json::parse(parameter.defaultJson).size();
        return Json(std::vector<double>(size == 0 ? 3 : size, inside)).dump(); // an absent one is a point or a colour
    }
    case ParameterType::curve: return "[[0.5, 0.5]]";
    default: return "";
    }
}

TEST(ParameterTable, EverySettingIsSetWrittenAndReadBack) {
    const Figure base = fullFigure();
    int settings = 0;
    for (const Parameter& parameter : parameterTable()) {
        const std::string pointer = concrete(parameter.pointer);
        const Json document = Json::parse(writeFigure(base));
        const Json::json_pointer place(pointer);
        const Json now = document.contains(place) ? document[place] : Json::parse(parameter.defaultJson);
        std::string value = otherValue(parameter, now);
        if (pointer.ends_with("/at") && pointer.starts_with("/annotations")) {
            value = "[0.25, 0.75]";
        }
        if (value.empty()) {
            continue; // lists and parts: their members are settings
        }
        // Grids and plain nodes share a key, and so do not stand in one layer.
        const bool ofGrid =
            pointer.find("/transfer/nodes/") != std::string::npos && pointer.find("/nodes/0") == std::string::npos;
        const Figure start = ofGrid ? withSetting(base, "/layers/0/transfer={\"kind\": \"2d\"}") : base;
        const Figure changed = withSetting(start, pointer + "=" + value);
        EXPECT_NE(changed, start) << pointer << "=" << value;
        const Figure again = readFigure(writeFigure(changed), pointer);
        EXPECT_EQ(again, changed) << pointer << "=" << value;
        EXPECT_EQ(findParameter(pointer), &parameter);
        EXPECT_LE(diff(start, changed), ChangeCost::newVolume);
        if (Json::parse(writeFigure(start)).contains(place)) {
            EXPECT_EQ(diff(start, changed), parameter.cost) << pointer;
        }
        ++settings;
    }
    EXPECT_GT(settings, 120);
}

TEST(ParameterTable, RangesHoldInBothDirections) {
    const Figure base = fullFigure();
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.type != ParameterType::number && parameter.type != ParameterType::integer) {
            continue;
        }
        const std::string pointer = concrete(parameter.pointer);
        if (parameter.low) {
            EXPECT_THROW(withSetting(base, pointer + "=" + Json(*parameter.low - 1).dump()), Error) << pointer;
            const std::string bound = pointer + "=" + Json(*parameter.low).dump();
            if (parameter.lowExcluded) {
                EXPECT_THROW(withSetting(base, bound), Error) << pointer;
            } else {
                EXPECT_NO_THROW(withSetting(base, bound)) << pointer;
            }
        }
        if (parameter.high) {
            EXPECT_THROW(withSetting(base, pointer + "=" + Json(*parameter.high + 1).dump()), Error) << pointer;
            EXPECT_NO_THROW(withSetting(base, pointer + "=" + Json(*parameter.high).dump())) << pointer;
        }
        EXPECT_THROW(withSetting(base, pointer + "=twelve"), Error) << pointer;
        EXPECT_THROW(withSetting(base, pointer + "=1e999"), Error) << pointer;
    }
}

} // namespace
} // namespace limner
