#include "support/part_scenes.h"

namespace limner::testing {

namespace {

using Features = std::vector<TransferFeature>;

Layer& styled(Figure& figure) {
    Layer& layer = figure.layers.front();
    layer.shading = Shading::style;
    makeLine(layer, "value");
    return layer;
}

// Keys and knots lie on entries of the tables (thirds of 1023), so that tables are exact.

Tone warmTone(const char* light) {
    Tone tone;
    tone.light.kind = light;
    tone.light.direction = {-0.5, 0.4, 0.6};
    tone.keys = {{0, {0.2, 0.3, 0.8}}, {1.0 / 3, {0.6, 0.5, 0.6}}, {1, {1, 0.95, 0.7}}};
    tone.saturation = 1.4;
    return tone;
}

std::vector<glm::dvec2> risingCurve() { return {{0, 0.1}, {1.0 / 3, 0.9}, {1, 0.4}}; }

PositionRamp fadingRamp(const char* axis) {
    PositionRamp ramp;
    ramp.axis = axis;
    ramp.direction = {0.3, -0.5, 0.8};
    ramp.ramp = {{0, {1.1, 1, 0.8, 1}}, {2.0 / 3, {0.7, 0.8, 1, 0.6}}, {1, {0.4, 0.5, 0.9, 0.1}}};
    return ramp;
}

Clip slantedClip() {
    Clip clip;
    clip.planes = {{{0.3, -1, 0.5}, 1.5}, {{-1, 0.2, 0.1}, 4}};
    return clip;
}

void addLayerParts(Features& features) {
    for (const char* light : {"head", "object"}) {
        features.push_back({light == std::string("head") ? "toneHead" : "toneObject",
                            [light](Figure& figure) { styled(figure).tone = warmTone(light); }});
    }
    for (const auto& [name, shading] :
         {std::pair("silhouetteFlat", Shading::flat), std::pair("silhouettePhong", Shading::phong),
          std::pair("silhouetteStyle", Shading::style)}) {
        features.push_back({name, [shading = shading](Figure& figure) {
                                Layer& layer = styled(figure);
                                layer.shading = shading;
                                makeLine(layer, "value");
                                layer.silhouette = Silhouette{{0.1, 0.05, 0.3}, {0.1, 0.6}, 0.8};
                                layer.lineGradientOpacity = risingCurve();
                            }});
    }
    features.push_back({"highlight", [](Figure& figure) { styled(figure).specular = Specular{0.4, 12}; }});
    features.push_back({"highlightOfTone", [](Figure& figure) {
                            Layer& layer = styled(figure);
                            layer.tone = warmTone("object");
                            layer.specular = Specular{0.5, 7.5};
                            layer.lineGradientOpacity = risingCurve();
                            layer.twoSided = false;
                        }});
    features.push_back({"gradientOpacity", [](Figure& figure) { styled(figure).gradientOpacity = risingCurve(); }});
    features.push_back({"phongLight", [](Figure& figure) {
                            figure.layers.front().shading = Shading::phong;
                            makeLine(figure.layers.front(), "value");
                            figure.layers.front().phong = PhongLight{0.35, 0.4};
                        }});
    for (const char* axis : {"view", "y", "direction"}) {
        features.push_back(
            {std::string("position_") + axis, [axis](Figure& figure) { styled(figure).position = fadingRamp(axis); }});
    }
    features.push_back({"depthOfField", [](Figure& figure) { styled(figure).depthOfField = DepthOfField{0.3, 1.5}; }});
    features.push_back({"depthOfFieldFlat", [](Figure& figure) {
                            figure.layers.front().depthOfField = DepthOfField{0.6, 3};
                        }});
}

void addCuts(Features& features) {
    const auto add = [&](const char* name, auto change) {
        features.push_back({name, [change](Figure& figure) {
                                Layer& layer = styled(figure);
                                Layer behind = layer;
                                behind.name = "behind";
                                behind.shading = Shading::flat;
                                makeLine(behind, "value");
                                layer.clip = slantedClip();
                                figure.layers.push_back(behind);
                                change(figure);
                            }});
    };
    add("layerClip", [](Figure&) {});
    add("layerClipBox", [](Figure& figure) {
        figure.layers.front().clip = Clip{BoxMm{{-6, -9, -4}, {5, 3, 7}}, {}, {}};
    });
    add("layerFaces", [](Figure& figure) { figure.layers.front().clip->face.emplace(); });
    add("layerFacesInStyle", [](Figure& figure) { figure.layers.front().clip->face = CutFace{"b", {}}; });
    add("figureFaces", [](Figure& figure) {
        figure.layers.front().clip.reset();
        figure.clip = slantedClip();
        figure.clip.face.emplace();
    });
    add("figureFacesInDepthOfField", [](Figure& figure) {
        figure.layers.front().clip.reset();
        figure.layers.front().depthOfField = DepthOfField{0.3, 1.5};
        figure.clip = slantedClip();
        figure.clip.face = CutFace{"", glm::dvec3(0.2, 0.3, 0.9)};
    });
    add("figureAndLayerFaces", [](Figure& figure) {
        figure.clip.planes = {{{0, 0, 1}, 5}};
        figure.clip.face = CutFace{"", glm::dvec3(0.9, 0.3, 0.2)};
        figure.layers.front().clip->face = CutFace{"a", {}};
        figure.layers.front().contours.emplace();
    });
}

DepthCues allCues() {
    DepthCues cues;
    cues.ambientOcclusion = AmbientOcclusion{0.8, 6};
    cues.shadow = ContactShadow{{"head", {-0.5, 0.5, 0.6}}, 0.6, 9, 15};
    cues.halo = Halo{{0.1, 0.2, 0.3}, 0.9, 2, 8};
    return cues;
}

void addCues(Features& features) {
    features.push_back({"ambientOcclusion", [](Figure& figure) {
                            styled(figure);
                            figure.depthCues.emplace().ambientOcclusion = allCues().ambientOcclusion;
                        }});
    features.push_back({"contactShadow", [](Figure& figure) {
                            styled(figure);
                            figure.depthCues.emplace().shadow = allCues().shadow;
                        }});
    features.push_back({"halo", [](Figure& figure) { figure.depthCues.emplace().halo = allCues().halo; }});
}

void drawAll(Figure& figure) {
    Layer& layer = styled(figure);
    layer.tone = warmTone("head");
    layer.silhouette = Silhouette{{0, 0, 0}, {0.05, 0.5}, 0.7};
    layer.specular = Specular{0.3, 20};
    layer.gradientOpacity = risingCurve();
    layer.lineGradientOpacity = risingCurve();
    layer.position = fadingRamp("view");
    layer.clip = slantedClip();
    layer.clip->face = CutFace{"b", {}};
    layer.depthOfField = DepthOfField{0.4, 1};
    layer.contours.emplace();
    figure.depthCues = allCues();
}

} // namespace

void addPartFeatures(Features& features) {
    addLayerParts(features);
    addCuts(features);
    addCues(features);
    features.push_back({"allParts", drawAll});
    features.push_back({"allPartsByLabels", [](Figure& figure) {
                            drawAll(figure);
                            makePlane(figure.layers.front(), "value", "label");
                        }});
    features.push_back({"allPartsByImportance", [](Figure& figure) {
                            drawAll(figure);
                            figure.quality.earlyTermination = 1e-5; // backends may end rays at different depths
                            figure.importance.emplace();
                            figure.importance->weights.gradient = 2;
                            figure.importance->weights.unocclusion = 0.1;
                        }});
}

void addSlabFeatures(std::vector<TransferFeature>& features) {
    const auto add = [&](const std::string& name, const std::function<void(Figure&)>& change, bool onEntries = true) {
        features.push_back({"slabs" + name,
                            [change](Figure& figure) {
                                figure.quality.preintegration = true;
                                figure.layers.front().shading = Shading::style;
                                makeLine(figure.layers.front(), "value");
                                change(figure);
                            },
                            onEntries});
    };
    add("Flat", [](Figure& figure) { figure.layers.front().shading = Shading::flat; });
    add("Phong", [](Figure& figure) { figure.layers.front().shading = Shading::phong; });
    add("Style", [](Figure&) {});
    add("Contours", [](Figure& figure) { figure.layers.front().contours.emplace(); });
    add("Spline", [](Figure& figure) {
        figure.quality.interpolation = Interpolation::tricubic;
        figure.quality.gradient = GradientEstimator::bspline;
    });
    add("LongSteps", [](Figure& figure) { figure.quality.stepVoxels = 2.7; });
    add(
        "SmoothCurve", [](Figure& figure) { figure.layers.front().transfer.curve = OpacityCurve::smooth; }, false);
    add("Clipped", [](Figure& figure) { figure.clip.planes = {{{0.3, -0.8, 0.5}, 1.3}}; });
    add("Layers", [](Figure& figure) {
        Layer core = figure.layers.front();
        core.shading = Shading::phong;
        core.transfer.opacity = {{0.5, 0}, {0.7, 0.6}, {0.9, 0.1}};
        core.transfer.nodes = {{0.5, "", glm::dvec3(0.9, 0.2, 0.1)},
                               {0.7, "", glm::dvec3(0.2, 0.6, 0.9)},
                               {0.9, "", glm::dvec3(0.8, 0.8, 0.2)}};
        figure.layers.push_back(core);
    });
}

} // namespace limner::testing
