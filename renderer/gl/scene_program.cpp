#include "renderer/gl/scene_program.h"

namespace limner::gl {

namespace {

/// Choices that are numbers in the shaders.
enum Constant { none = 0, fixedWidth = 1, bend = 2, normals = 3 };

void defineConstants(ProgramSource& source) {
    source.define("GRADIENT_CENTRAL", static_cast<int>(KernelGradient::central))
        .define("GRADIENT_TAPS", static_cast<int>(KernelGradient::taps))
        .define("GRADIENT_FOURTH_ORDER", static_cast<int>(KernelGradient::fourthOrder))
        .define("KERNEL_SPLINE", static_cast<int>(KernelTaps::spline))
        .define("KERNEL_SOBEL", static_cast<int>(KernelTaps::sobel))
        .define("KERNEL_NEUMANN", static_cast<int>(KernelTaps::neumann))
        .define("CONTOURS_FIXED", Constant::fixedWidth)
        .define("CONTOURS_BEND", Constant::bend)
        .define("CONTOURS_NORMALS", Constant::normals)
        .define("AXIS_VALUE", static_cast<int>(TransferAxis::value))
        .define("AXIS_GRADIENT", static_cast<int>(TransferAxis::gradient))
        .define("AXIS_CURVATURE", static_cast<int>(TransferAxis::curvature))
        .define("AXIS_DISTANCE", static_cast<int>(TransferAxis::distance))
        .define("AXIS_SECOND", static_cast<int>(TransferAxis::second))
        .define("AXIS_IMPORTANCE", static_cast<int>(TransferAxis::importance));
}

void flag(ProgramSource& source, const std::string& name, bool on) { source.define(name, on ? 1 : 0); }

void defineMeasures(ProgramSource& source, const KernelImportance& measures, const std::string& instance) {
    flag(source, "M_INTENSITY_" + instance, measures.intensity > 0);
    flag(source, "M_GRADIENT_" + instance, measures.gradient > 0);
    flag(source, "M_SILHOUETTE_" + instance, measures.silhouette > 0);
    flag(source, "M_LIGHTING_" + instance, measures.lighting > 0);
    flag(source, "M_OBJECT_" + instance, measures.weightOfSlot != nullptr);
    flag(source, "M_STATISTICS_" + instance, measures.statistics != nullptr);
    flag(source, "M_EXTINCTION_" + instance, measures.extinction > 0);
}

int contoursOf(const KernelContours& contours) {
    if (!contours.on) {
        return Constant::none;
    }
    return !contours.controlled ? Constant::fixedWidth : contours.normals ? Constant::normals : Constant::bend;
}

void defineParts(ProgramSource& source, const KernelLayer& layer, const std::string& number) {
    const KernelParts& parts = layer.parts;
    flag(source, "PARTS_" + number, parts.any);
    flag(source, "TONE_" + number, parts.tone != nullptr);
    flag(source, "POSITION_" + number, parts.position != nullptr);
    flag(source, "GRADIENT_OPACITY_" + number, parts.gradientOpacity != nullptr);
    flag(source, "LINE_OPACITY_" + number, parts.lineOpacity != nullptr);
    flag(source, "SILHOUETTE_" + number, parts.silhouetteOpacity > 0);
    flag(source, "SPECULAR_" + number, parts.specularStrength > 0);
    flag(source, "OWN_LIGHT_" + number, parts.ownLight);
    flag(source, "CUT_" + number, layer.cut != nullptr);
    flag(source, "CUT_FACES_" + number, layer.cut != nullptr && layer.cut->faces);
    flag(source, "FOCUS_" + number, layer.focusStrength > 0);
}

void defineLayer(ProgramSource& source, const KernelLayer& layer, const std::string& number) {
    flag(source, "BY_VALUE_" + number, layer.opacityByValue);
    flag(source, "ROWS_" + number, layer.rows > 0);
    flag(source, "LABEL_AXIS_" + number, layer.rowOfSlot != nullptr);
    flag(source, "SHOWN_" + number, layer.shownSlots != nullptr);
    flag(source, "STYLE_" + number, layer.shading == Shading::style);
    flag(source, "PHONG_" + number, layer.shading == Shading::phong);
    flag(source, "TWO_SIDED_" + number, layer.twoSided);
    flag(source, "ILLUSTRATIVE_" + number, layer.illustrative);
    flag(source, "DIRECTIONAL_" + number, layer.directionalOpacity);
    flag(source, "SINGLE_" + number, layer.singleSlot >= 0);
    flag(source, "TEXTURES_" + number, layer.textures != nullptr);
    flag(source, "CURVED_LEVELS_" + number, layer.curvedLevels);
    flag(source, "STORED_AXIS_" + number,
         (layer.x.axis == TransferAxis::distance && layer.x.bricks != nullptr) ||
             (layer.y.axis == TransferAxis::distance && layer.y.bricks != nullptr));
    source.define("CONTOURS_" + number, contoursOf(layer.contours));
    source.define("AXIS_X_" + number, static_cast<int>(layer.x.axis));
    source.define("AXIS_Y_" + number, static_cast<int>(layer.y.axis));
    defineParts(source, layer, number);
}

void defineFigure(ProgramSource& source, const RenderPlan& plan, const KernelScene& scene) {
    flag(source, "PERSPECTIVE", scene.perspective);
    flag(source, "SPLINE", scene.spline);
    flag(source, "SLABS", scene.preintegrated);
    flag(source, "READS_NORMAL", scene.readsNormal);
    flag(source, "READS_SCALE", scene.readsGradientScale);
    flag(source, "BEND", scene.readsBend);
    source.define("GRADIENT", static_cast<int>(scene.gradient));
    source.define("GRADIENT_KERNEL", static_cast<int>(scene.gradientTaps));
    flag(source, "LABELS", scene.labels != nullptr);
    flag(source, "SECOND_VOLUME", plan.secondVolume != nullptr);
    flag(source, "AXIS_MEASURES", plan.axisMeasures.has_value());
    flag(source, "MIP_LEVELS", scene.atlas.levelStart != nullptr);
    flag(source, "BLURS", !plan.blurs.empty());
    flag(source, "FACES", scene.faces != nullptr);
    bool cuts = scene.faces != nullptr;
    for (int i = 0; i < scene.layerCount; ++i) {
        cuts = cuts || scene.layers[i].cut != nullptr;
    }
    flag(source, "CUTS", cuts);
    flag(source, "CUES", scene.cues.any);
    flag(source, "CUE_AMBIENT", scene.cues.ambient.values != nullptr);
    flag(source, "CUE_SHADOW", scene.cues.shadow.values != nullptr);
    flag(source, "CUE_HALO", scene.cues.halo.values != nullptr);
    flag(source, "UNOCCLUSION", scene.importance.unocclusion > 0);
}

bool anyLayer(const KernelScene& scene, bool (*holds)(const KernelLayer&)) {
    for (int i = 0; i < scene.layerCount; ++i) {
        if (holds(scene.layers[i])) {
            return true;
        }
    }
    return false;
}

/// What layers are made of, each file once.
void addFigure(ProgramSource& source, const RenderPlan& plan, const KernelScene& scene, bool byImportance) {
    for (const char* name : {"math.glsl", "formulas.glsl", "tables.glsl", "rays.glsl", "field.glsl", "facts.glsl"}) {
        source.add(name);
    }
    if (scene.preintegrated) {
        source.add("slabs.glsl");
    }
    if (plan.atlas) {
        source.add("style.glsl");
    }
    if (anyLayer(scene, [](const KernelLayer& layer) { return layer.textures != nullptr; })) {
        source.add("texture.glsl");
    }
    if (plan.secondVolume) {
        source.add("second_volume.glsl");
    }
    if (byImportance) {
        source.add("measures.glsl", 0);
    }
    if (plan.axisMeasures) {
        source.add("measures.glsl", 1);
    }
    if (scene.cues.any) {
        source.add("cues.glsl");
    }
}

} // namespace

ProgramSource castingProgram(const RenderPlan& plan, const KernelScene& scene, const ProgramChoices& choices) {
    ProgramSource source;
    defineConstants(source);
    defineFigure(source, plan, scene);
    flag(source, "PAGED", choices.paged);
    flag(source, "IMPORTANCE", choices.byImportance);
    flag(source, "MARCH_THEN_SHADE", choices.marchThenShade);
    flag(source, "LENSES", choices.lenses);
    defineMeasures(source, scene.importance, "0");
    defineMeasures(source, scene.axisImportance, "1");
    source.define("kHalfTile", kTile / 2);
    for (int i = 0; i < scene.layerCount; ++i) {
        defineLayer(source, scene.layers[i], std::to_string(i));
    }
    addFigure(source, plan, scene, choices.byImportance);
    for (int i = 0; i < scene.layerCount; ++i) {
        source.add("parts.glsl", i).add("layer.glsl", i);
    }
    source.add("compose.glsl").add("sample_begin.glsl");
    for (int i = 0; i < scene.layerCount; ++i) {
        source.add("sample_layer.glsl", i);
    }
    return source.add("sample_end.glsl").add("march.glsl");
}

ProgramSource wholeTarget() {
    ProgramSource source;
    return source.add("whole_target.vert");
}

} // namespace limner::gl
