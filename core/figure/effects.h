#pragma once

#include "core/figure/layer.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace limner {

/// Parts of a figure that act on all layers: importance with its lenses, depth cues, and stippling.

struct ImportanceWeights {
    double intensity = 0;
    double extinction = 0;
    double gradient = 0;
    double silhouette = 0;
    double unocclusion = 0;
    double lighting = 0;
    double object = 0;
    double statistics = 0;
    friend bool operator==(const ImportanceWeights&, const ImportanceWeights&) = default;
};

/// Where importance acts. Lengths are shares of the figure's height.
struct Lens {
    std::string kind = "gaussian"; ///< circular, gaussian, screendoor
    glm::dvec2 center{0.5, 0.5};   ///< figure coordinates
    double radius = 0.18;
    double cell = 0.004;          ///< screendoor: edge of one grain of the screen
    std::string shape = "circle"; ///< circle, ellipse, box (with round corners)
    double aspect = 1;            ///< ellipse and box: width over height
    double angleDeg = 0;          ///< ellipse and box: counter-clockwise
    double soft = 0;              ///< circular: share of the radius over which the edge fades
    double inside = 1;            ///< factors of the global weight
    double outside = 0;
    std::optional<glm::dvec3> anchorMm = {}; ///< a point of the volume that the lens stays on; `center` is not read
    friend bool operator==(const Lens&, const Lens&) = default;
};

/// Settings of single measures (spec importance-composition.md, "Measures").
struct SilhouetteMeasure {
    double exponent = 1.7;    ///< of the gradient
    glm::dvec2 range{0.4, 1}; ///< edges of the step, in 1 - |n.v|
    double darkening = 4;     ///< colours on silhouettes are multiplied by exp(-darkening silhouetteness)
    friend bool operator==(const SilhouetteMeasure&, const SilhouetteMeasure&) = default;
};

struct LightingMeasure {
    glm::dvec3 direction{-0.4, 0.6, 0.7}; ///< to the light: right, up, towards the viewer
    int highlight = 50;                   ///< exponents
    int diffuse = 5;
    int gradient = 30;
    friend bool operator==(const LightingMeasure&, const LightingMeasure&) = default;
};

/// Importance of the object with a label.
struct ObjectImportance {
    int label = 1;
    double weight = 1;
    friend bool operator==(const ObjectImportance&, const ObjectImportance&) = default;
};

struct Importance {
    double global = 1;
    ImportanceWeights weights;
    double background = 0;
    std::vector<Lens> lenses;
    SilhouetteMeasure silhouette = {};
    LightingMeasure lighting = {};
    std::vector<ObjectImportance> objects = {}; ///< labels that are not here weigh nothing
    double statisticsVoxels = 2;                ///< standard deviation of the neighbourhood's weights
    double cap = 8;           ///< no sample is more important: e^-8 of opacity is the least that shows through
    double noiseFloor = 0.02; ///< extinction per voxel below which a sample matters to nobody
    friend bool operator==(const Importance&, const Importance&) = default;
};

/// Matter around a place takes its light away (local ambient occlusion).
struct AmbientOcclusion {
    double strength = 0.6;
    double reachMm = 12; ///< where what is around counts 1/e
    friend bool operator==(const AmbientOcclusion&, const AmbientOcclusion&) = default;
};

/// A soft shadow where one thing lies close to another.
struct ContactShadow {
    Light light;
    double strength = 0.5;
    double reachMm = 20;
    double softDeg = 20; ///< half angle of the light
    friend bool operator==(const ContactShadow&, const ContactShadow&) = default;
};

/// A seam around what is in front, over what lies behind it: the deeper, the stronger.
struct Halo {
    glm::dvec3 rgb{0};
    double strength = 0.7;
    double widthMm = 1.5; ///< on paper, behind at `depthMm`
    double depthMm = 20;  ///< how far behind the halo is whole
    friend bool operator==(const Halo&, const Halo&) = default;
};

/// What helps the eye with depth, over all layers.
struct DepthCues {
    std::optional<AmbientOcclusion> ambientOcclusion;
    std::optional<ContactShadow> shadow;
    std::optional<Halo> halo;
    friend bool operator==(const DepthCues&, const DepthCues&) = default;
};

/// Stipples and other marks of ink (paper 004; core/optics/stipple.h). A mark's tone is the share of paper that it asks
/// to be covered: the product of the factors that are there.

struct StippleBoundary {
    double kgc = 0.39, kgs = 0.51, kge = 1;
    friend bool operator==(const StippleBoundary&, const StippleBoundary&) = default;
};

struct StippleSilhouette {
    double ksc = 0.279, kss = 0.45, kse = 1.11;
    friend bool operator==(const StippleSilhouette&, const StippleSilhouette&) = default;
};

struct StippleResolution {
    double kre = 1.1;
    friend bool operator==(const StippleResolution&, const StippleResolution&) = default;
};

struct StippleDistance {
    double kde = 1.5;
    friend bool operator==(const StippleDistance&, const StippleDistance&) = default;
};

struct StippleInterior {
    double kte = 0.5;
    friend bool operator==(const StippleInterior&, const StippleInterior&) = default;
};

struct StippleLighting {
    double kle = 2.7;
    Light light = {};
    friend bool operator==(const StippleLighting&, const StippleLighting&) = default;
};

/// Lines where the surface turns away from the viewer.
struct StippleCurves {
    double log = 0.12, eye = 0.3, gradient = 0.2, widthMm = 0.2;
    std::string widthBy = "even";     ///< even, curvature (thin where the form is flat), depth (thin where it is far)
    std::string hiddenLines = "none"; ///< none, dashed, thin: what matter in front hides
    friend bool operator==(const StippleCurves&, const StippleCurves&) = default;
};

/// Lines along ridges and valleys of the surface. Strengths: smallest curvature times the voxel of the marks.
struct StippleInnerLines {
    double ridges = 0.25, valleys = 0.25; ///< 0: none of these
    double widthMm = 0.15;
    friend bool operator==(const StippleInnerLines&, const StippleInnerLines&) = default;
};

/// Strokes along the principal curvature directions, as many as the tone asks for.
struct StippleHatching {
    double lengthMm = 4, widthMm = 0.2;
    double cross = 0.55; ///< tone above which strokes cross; 1: never
    friend bool operator==(const StippleHatching&, const StippleHatching&) = default;
};

struct Stipple {
    glm::dvec3 inkRgb{0};
    bool fromStyle = false;
    double kMax = 1; ///< 0: no dots
    double threshold = 0.1;
    double spreadVoxels = 0.5;
    double sizeMm = 0.35;
    std::string hidden = "remove";      ///< remove, show
    std::string layerOpacity = "under"; ///< under, over, alone: the layers are not drawn
    std::string matter = "data";        ///< data, layers: what the factors' data value is
    std::string placing = "paper";    ///< paper: still pictures' dots lie evenly there; volume: where they turn with it
    std::string tone = "ink";         ///< ink: dots that overlap are made up for; count: the paper's counts
    std::string gradient = "neumann"; ///< neumann, central
    int seed = 1;
    std::optional<StippleBoundary> boundary;
    std::optional<StippleSilhouette> silhouette;
    std::optional<StippleResolution> resolution;
    std::optional<StippleDistance> distance;
    std::optional<StippleInterior> interior;
    std::optional<StippleLighting> lighting;
    std::optional<StippleCurves> curves;
    std::optional<StippleInnerLines> innerLines;
    std::optional<StippleHatching> hatching;
    friend bool operator==(const Stipple&, const Stipple&) = default;
};

} // namespace limner
