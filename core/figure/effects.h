#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace limner {

/// Parts of a figure that act on all layers: importance with its lenses, and stippling.

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

struct Lens {
    std::string kind = "gaussian"; ///< circular, gaussian, screendoor
    glm::dvec2 center{0.5, 0.5};   ///< figure coordinates
    double radius = 0.18;          ///< of the figure's height
    double cell = 0.004;           ///< screendoor
    friend bool operator==(const Lens&, const Lens&) = default;
};

struct Importance {
    double global = 1;
    ImportanceWeights weights;
    double background = 0;
    std::vector<Lens> lenses;
    friend bool operator==(const Importance&, const Importance&) = default;
};

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
    friend bool operator==(const StippleLighting&, const StippleLighting&) = default;
};

struct StippleCurves {
    double log = 0.12, eye = 0.3, gradient = 0.2, widthMm = 0.2;
    friend bool operator==(const StippleCurves&, const StippleCurves&) = default;
};

struct Stipple {
    glm::dvec3 inkRgb{0};
    bool fromStyle = false;
    double kMax = 1;
    double threshold = 0.1;
    double spreadVoxels = 0.5;
    double sizeMm = 0.35;
    std::string hidden = "remove";      ///< remove, show
    std::string layerOpacity = "under"; ///< under, over
    std::optional<StippleBoundary> boundary;
    std::optional<StippleSilhouette> silhouette;
    std::optional<StippleResolution> resolution;
    std::optional<StippleDistance> distance;
    std::optional<StippleInterior> interior;
    std::optional<StippleLighting> lighting;
    std::optional<StippleCurves> curves;
    friend bool operator==(const Stipple&, const Stipple&) = default;
};

} // namespace limner
