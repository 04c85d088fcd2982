#pragma once

#include "core/figure/camera.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>
#include <string>
#include <vector>

namespace limner {

/// A layer of a figure: a style transfer function and the parts that draw with it. Absent parts stay absent.

/// A node carries either a style or a plain colour.
struct TransferNode {
    double at = 0;
    std::string style;
    std::optional<glm::dvec3> rgb;
    friend bool operator==(const TransferNode&, const TransferNode&) = default;
};

enum class TransferKind { oneDimensional, twoDimensional };

/// Styles over a node grid; `styles[y][x]` is the id of a style, or a plain colour "#rrggbb". On the axis "label" the
/// positions are label numbers, each row or column holds for its label alone, and -1 stands for all labels that have
/// none of their own.
struct TransferGrid {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<std::vector<std::string>> styles;
    friend bool operator==(const TransferGrid&, const TransferGrid&) = default;
};

/// A shape of opacity in the plane of two axes. Corners: rectangle and ellipse (its bounding box): x and y of (low,
/// high); trapezoid: x and y of (start, full, full, end), the product of the two ramps; polygon: its points; mask: x
/// and y of (low, high), painted with `values`, `columns` of them a row, first row at the low end of y.
struct OpacityShape {
    std::string shape = "rectangle"; ///< rectangle, trapezoid, ellipse, polygon, mask
    std::vector<double> x;
    std::vector<double> y;
    double opacity = 1;
    double soft = 0; ///< width of the ramp inside the border, as a share of half the shape's extent
    int columns = 0;
    std::vector<double> values; ///< mask: 0..1
    friend bool operator==(const OpacityShape&, const OpacityShape&) = default;
};

/// What the axis "distance" measures from, in mm: a point, or else the nearest voxel of a label.
struct DistanceOrigin {
    std::optional<glm::dvec3> fromMm;
    int label = 0;
    friend bool operator==(const DistanceOrigin&, const DistanceOrigin&) = default;
};

/// How opacity goes from point to point of a curve.
enum class OpacityCurve {
    linear,
    smooth, ///< without corners, never past the points: monotone cubics that are level at peaks and ends
    step,   ///< each point's opacity holds up to the next point
};

/// Axes: "value" in the data's unit; "gradient", |gradient| over its 99.9th percentile, 0..1; "label", label number;
/// "distance", mm; "curvature", 1/mm along the view; "second", value of the second volume; "importance".
struct Transfer {
    TransferKind kind = TransferKind::oneDimensional;
    std::string axis = "value";       ///< 1D
    std::vector<std::string> axes;    ///< 2D: two names
    std::vector<TransferNode> nodes;  ///< 1D, by rising `at`
    std::optional<TransferGrid> grid; ///< 2D; JSON "nodes" as well
    /// (position, opacity) along the (first) axis, rising; two points at one position are a step. 2D: multiplies the
    /// shapes, or stands alone where there are none.
    std::vector<glm::dvec2> opacity;
    OpacityCurve curve = OpacityCurve::linear;
    std::vector<OpacityShape> opacity2d; ///< the greatest counts
    std::optional<DistanceOrigin> distance;
    friend bool operator==(const Transfer&, const Transfer&) = default;
};

enum class Shading { style, phong, flat };

enum class Transparency { uniform, illustrative };

/// How the curvature along the view is measured.
enum class CurvatureEstimator {
    hessian, ///< second derivatives of the smoothed scan
    normals, ///< angle between two normals along the ray, `Contours::probeVoxels` apart (paper 000)
};

struct Contours {
    double thicknessMm = 0.8;
    bool curvatureControlled = true;
    CurvatureEstimator curvature = CurvatureEstimator::hessian;
    double probeVoxels = 1;
    friend bool operator==(const Contours&, const Contours&) = default;
};

struct Light {
    std::string kind = "head"; ///< head, object
    glm::dvec3 direction{-0.4, 0.6, 0.7};
    friend bool operator==(const Light&, const Light&) = default;
};

struct ColourKey {
    double at = 0;
    glm::dvec3 rgb{0};
    friend bool operator==(const ColourKey&, const ColourKey&) = default;
};

struct Tone {
    Light light;
    std::vector<ColourKey> keys;
    double saturation = 1;
    friend bool operator==(const Tone&, const Tone&) = default;
};

struct Silhouette {
    glm::dvec3 rgb{0};
    glm::dvec2 range{0, 0.25};
    double opacity = 1;
    friend bool operator==(const Silhouette&, const Silhouette&) = default;
};

/// Phong's shares of ambient and diffuse light; the head light sits at the eye.
struct PhongLight {
    double ambient = 0.1;
    double diffuse = 0.7;
    friend bool operator==(const PhongLight&, const PhongLight&) = default;
};

/// Phong's highlight, or one on any other shading, under the light of the layer's tone.
struct Specular {
    double strength = 0.2;
    double exponent = 10;
    friend bool operator==(const Specular&, const Specular&) = default;
};

struct RampKey {
    double at = 0;
    glm::dvec4 rgba{1};
    friend bool operator==(const RampKey&, const RampKey&) = default;
};

struct PositionRamp {
    std::string axis = "view"; ///< view, x, y, z, direction; 0 and 1 are the ends of the scan's box
    std::vector<RampKey> ramp;
    glm::dvec3 direction{0, 0, 1}; ///< axis "direction": in patient coordinates
    friend bool operator==(const PositionRamp&, const PositionRamp&) = default;
};

struct DepthOfField {
    double focus = 0.5;
    double strength = 1;
    friend bool operator==(const DepthOfField&, const DepthOfField&) = default;
};

struct Layer {
    std::string name;
    bool visible = true;
    bool solo = false;   ///< where any layer has it, the others are not drawn
    bool locked = false; ///< the studio leaves it as it is
    double opacity = 1;  ///< multiplies the transfer function's
    Transfer transfer;
    Shading shading = Shading::style;
    bool twoSided = true;
    std::optional<Contours> contours;
    Transparency transparency = Transparency::uniform;
    std::optional<Tone> tone;
    std::optional<Silhouette> silhouette;
    std::optional<Specular> specular;
    std::optional<std::vector<glm::dvec2>> gradientOpacity;
    std::optional<std::vector<glm::dvec2>> lineGradientOpacity;
    std::optional<PositionRamp> position;
    std::optional<DepthOfField> depthOfField;
    std::optional<std::vector<int>> labels; ///< only these labels show
    std::optional<PhongLight> phong = {};
    std::optional<Clip> clip = {}; ///< of this layer alone, beside the figure's
    double importanceWeight = 1;
    friend bool operator==(const Layer&, const Layer&) = default;
};

} // namespace limner
