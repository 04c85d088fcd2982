#include "renderer/gl/scene_uniforms.h"

#include "renderer/gl/scene_program.h"
#include "renderer/scene/scene_builder.h"

#include <algorithm>

namespace limner::gl {

namespace {

template <typename Number>
glm::vec3 vector(const Number* v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

glm::vec4 linear(const float (&v)[4]) { return {v[0], v[1], v[2], v[3]}; }

/// From rows, as the kernel has them.
glm::mat3 matrix(const float (&rows)[3][3], float factor = 1) {
    glm::mat3 m;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            m[column][row] = rows[row][column] * factor;
        }
    }
    return m;
}

void setField(Program& program, const KernelScene& scene) {
    const float unit = kernelScale(scene.type); // the shader's interpolated numbers are the stored ones
    program.set("lastCell", vector(scene.lastCell));
    program.set("entryOfStored", glm::vec2(scene.tableScale * unit, scene.tableBias));
    program.set("visibleEntries", glm::vec2(scene.visibleFrom, scene.visibleTo));
    program.set("gapEntries", glm::vec2(scene.gapFrom, scene.gapTo));
    program.set("lastEntry", scene.lastEntry);
    program.set("eyeFromGradient", matrix(scene.eyeFromGradient, scene.gradient == KernelGradient::taps ? 1.0F : unit));
    program.set("gradientRounding", scene.gradientRounding);
    program.set("gradientFloor", scene.gradientFloor);
    program.set("perGradientMax", scene.perGradientMax);
    program.set("eyeFromBend", matrix(scene.eyeFromBend));
    program.set("depthFromCell", linear(scene.depthFromCell));
    program.set("cellFromEye", matrix(scene.cellFromEye));
    program.set("mmFromEye", matrix(scene.mmFromEye));
    float mm[3][3];
    glm::vec3 origin;
    for (int row = 0; row < 3; ++row) {
        std::copy(scene.mmFromCell[row], scene.mmFromCell[row] + 3, mm[row]);
        origin[row] = scene.mmFromCell[row][3];
    }
    program.set("mmFromCell", matrix(mm));
    program.set("mmOrigin", origin);
    for (int k = 0; k < 3; ++k) {
        const std::string index = "[" + std::to_string(k) + "]";
        program.set("entryOfBlur" + index, glm::vec2(scene.blurs[k].entryScale, scene.blurs[k].entryBias));
        program.set("eyeFromBlur" + index, matrix(scene.blurs[k].eyeFromSlope));
    }
}

void setMeasures(Program& program, const KernelImportance& m, const std::string& instance) {
    program.set("intensityWeight" + instance, m.intensity);
    program.set("intensityOfEntry" + instance, glm::vec2(m.intensityScale, m.intensityBias));
    program.set("gradientWeight" + instance, m.gradient);
    program.set("silhouetteWeight" + instance, m.silhouette);
    program.set("silhouetteTerms" + instance, glm::vec3(m.silhouetteExponent, m.silhouetteLow, m.silhouetteHigh));
    program.set("lightingWeight" + instance, m.lighting);
    program.set("importanceLight" + instance, vector(m.light));
    program.set("lightingExponents" + instance, glm::ivec3(m.highlight, m.diffuse, m.flat));
    program.set("objectWeight" + instance, m.object);
    program.set("extinctionWeight" + instance, m.extinction);
}

void setImportance(Program& program, const KernelScene& scene) {
    const KernelImportance& m = scene.importance;
    setMeasures(program, m, "0");
    setMeasures(program, scene.axisImportance, "1");
    program.set("globalWeight", m.global);
    program.set("importanceLimit", m.limit);
    program.set("backgroundImportance", m.background);
    program.set("noiseFloor", m.noiseFloor);
    program.set("darkening", m.darkening);
    program.set("actsPerWeight", m.actsPerWeight);
    program.set("unocclusionWeight", m.unocclusion);
    program.set("layerMost", m.layerMost);
    program.set("slabOfCell", linear(m.slabFromCell));
}

void setCue(Program& program, const std::string& name, const KernelCue& cue, float strength) {
    program.set(name + "Size", vector(cue.dims));
    program.set(name + "Cell", glm::vec3(cue.perCell, cue.bias, cue.outMm));
    program.set(name + "Strength", strength);
}

void setCues(Program& program, const KernelScene& scene) {
    setCue(program, "ambient", scene.cues.ambient, scene.cues.ambientStrength);
    setCue(program, "shadow", scene.cues.shadow, scene.cues.shadowStrength);
    setCue(program, "halo", scene.cues.halo, scene.cues.haloStrength);
    program.set("shadowLight", vector(scene.cues.light));
    program.set("haloRgb", vector(scene.cues.haloRgb));
}

void setAxis(Program& program, const std::string& number, const KernelLayer& layer) {
    program.set("axisX" + number, glm::vec3(layer.x.scale, layer.x.bias, layer.x.last));
    program.set("axisY" + number, glm::vec3(layer.y.scale, layer.y.bias, layer.y.last));
    const KernelAxis& distance = layer.x.axis == TransferAxis::distance ? layer.x : layer.y;
    program.set("mmFromCellOfAxis" + number, matrix(distance.mmFromCell));
    program.set("axisFrom" + number, vector(distance.from));
}

void setParts(Program& program, const std::string& number, const KernelLayer& layer) {
    const KernelParts& parts = layer.parts;
    program.set("lastRampEntry" + number, parts.lastEntry);
    program.set("partLight" + number, vector(parts.light));
    program.set("placeOnRamp" + number, linear(parts.placeFromCell));
    program.set("silhouette" + number, glm::vec3(parts.silhouetteOpacity, parts.silhouetteFull, parts.silhouetteNone));
    program.set("silhouetteRgb" + number, vector(parts.silhouetteRgb));
    program.set("specular" + number, glm::vec2(parts.specularStrength, parts.specularExponent));
    if (layer.cut != nullptr) {
        program.set("cutPlanes" + number, layer.cut->count);
        program.set("cutColoured" + number, layer.cut->coloured ? 1 : 0);
        program.set("cutPerVoxel", layer.cut->perVoxel);
    }
    program.set("depthPlace" + number, linear(layer.depthFromCell));
    program.set("focus" + number, glm::vec2(layer.focus, layer.focusStrength));
}

void setLayer(Program& program, const std::string& number, const KernelLayer& layer) {
    program.set("valueOfEntry" + number, glm::vec2(layer.x.scale, layer.x.bias));
    program.set("rowStride" + number, static_cast<int>(layer.rowStride));
    program.set("rows" + number, layer.rows);
    program.set("lastNode" + number, glm::ivec2(layer.lastColumn, layer.lastRow));
    program.set("nodeStride" + number, glm::ivec2(layer.columnStride, layer.nodeRowStride));
    program.set("singleSlot" + number, static_cast<int>(layer.singleSlot));
    program.set("light" + number,
                glm::vec4(layer.ambient, layer.diffuse, layer.specularStrength, layer.specularExponent));
    program.set("contour" + number,
                glm::vec3(layer.contours.thicknessMm, layer.contours.fixedWidth, layer.contours.probeMm));
    program.set("importanceOfLayer" + number, layer.importanceWeight);
    setAxis(program, number, layer);
    setParts(program, number, layer);
}

} // namespace

void setScene(Program& program, const RenderPlan& plan, const KernelScene& scene) {
    setField(program, scene);
    setImportance(program, scene);
    setCues(program, scene);
    for (std::size_t i = 0; i < plan.layers.size(); ++i) {
        setLayer(program, std::to_string(i), scene.layers[i]);
    }
    if (scene.faces != nullptr) {
        program.set("facePlanes", scene.faces->count);
        program.set("facesColoured", scene.faces->coloured ? 1 : 0);
        program.set("cutPerVoxel", scene.faces->perVoxel);
    }
    program.set("lastLevel", static_cast<float>(scene.atlas.lastLevel));
    program.set("radiusTexels", scene.atlas.radiusTexels);
    program.set("footprintVoxels", scene.atlas.footprintVoxels);
    program.set("voxelMm", scene.atlas.voxelMm);
    program.set("opaque", scene.opaque);
    program.set("stepRatio", scene.stepRatio);
    program.set("stepMm", static_cast<float>(scene.stepMm));
    program.set("phase", scene.phase);
    program.set("boxLow", vector(scene.boxLow));
    program.set("boxHigh", vector(scene.boxHigh));
    program.set("clipPlanes", scene.planeCount);
}

void setTile(Program& program, const KernelScene& scene, const glm::ivec2& corner) {
    const glm::dvec2 middle = glm::dvec2(corner) + 0.5 * kTile;
    glm::dvec3 origin;
    glm::dvec3 direction;
    double along = 0;
    double squared = 0;
    for (int i = 0; i < 3; ++i) {
        const double across = middle.x * scene.right[i] + middle.y * scene.down[i];
        origin[i] = scene.origin[i] + (scene.perspective ? 0 : across);
        direction[i] = scene.forward[i] + (scene.perspective ? across : 0);
        const double centre = 0.5 * (scene.boxLow[i] + scene.boxHigh[i]);
        along += (centre - origin[i]) * direction[i];
        squared += direction[i] * direction[i];
    }
    // The tile's reference lies where its middle ray passes the box's middle, but never behind the eye.
    const double nearest = scene.perspective ? std::max(along / squared, 0.0) : along / squared;
    const double spread = scene.perspective ? nearest : 1;
    program.set("tileStart", glm::vec3(origin + nearest * direction));
    program.set("tileDirection", glm::vec3(direction));
    const glm::dvec3 right(scene.right[0], scene.right[1], scene.right[2]);
    const glm::dvec3 down(scene.down[0], scene.down[1], scene.down[2]);
    program.set("startRight", glm::vec3(right * spread));
    program.set("startDown", glm::vec3(down * spread));
    program.set("directionRight", glm::vec3(right));
    program.set("directionDown", glm::vec3(down));
    program.set("middleEye", glm::vec3(scene.forwardEye[0] + middle.x * scene.rightEye,
                                       scene.forwardEye[1] + middle.y * scene.downEye, scene.forwardEye[2]));
    program.set("perPixelEye", glm::vec2(scene.rightEye, scene.downEye));
    program.set("nearest", static_cast<float>(nearest));
}

} // namespace limner::gl
