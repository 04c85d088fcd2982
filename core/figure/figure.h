#pragma once

#include "core/style/lit_sphere.h"
#include "core/volume/volume.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limner {

/// The figure: everything a picture depends on, as one value (spec figure-document.md). Lengths in mm, angles in
/// degrees, colours sRGB 0..1, data values in the volume's own unit. Absent parts are `std::optional` without a value
/// and stay absent. Every member's JSON name, unit, range, default and help stand in core/figure/parameters.cpp and
/// nowhere else. Copying is cheap: volumes and style pictures are shared.

struct VolumeReference {
    std::string path;         ///< relative to the project where possible
    std::string absolutePath; ///< fallback when the project moved without the volume
    std::string sha256;       ///< of the stored numbers, as `info` prints it; empty: not checked
    std::int64_t bytes = 0;   ///< size of the file or files; 0: not known
    bool embedded = false;
    std::string raw;                    ///< description of headerless data: "256x256x230:uint16:le:0.5,0.5,0.7"
    std::string series;                 ///< DICOM series UID where a folder holds several
    std::shared_ptr<const Volume> data; ///< null until resolved; compared by identity
    friend bool operator==(const VolumeReference&, const VolumeReference&) = default;
};

struct LabelReference {
    std::string path;
    std::map<std::string, std::string> names; ///< label id in decimal -> name
    std::shared_ptr<const Volume> data;
    friend bool operator==(const LabelReference&, const LabelReference&) = default;
};

enum class Projection { orthographic, perspective };

/// The picture's right is `direction x up`. In perspective the plane through the target shows `heightMm`.
struct Camera {
    Projection projection = Projection::orthographic;
    glm::dvec3 targetMm{0};
    glm::dvec3 direction{0, 1, 0}; ///< the way the viewer looks; need not be unit
    glm::dvec3 up{0, 0, 1};
    double heightMm = 240;
    double fovDeg = 30; ///< full vertical angle; perspective only
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Cuts away where `dot(normal, position) > offsetMm`.
struct ClipPlane {
    glm::dvec3 normal{1, 0, 0};
    double offsetMm = 0;
    friend bool operator==(const ClipPlane&, const ClipPlane&) = default;
};

struct BoxMm {
    glm::dvec3 low{0};
    glm::dvec3 high{0};
    friend bool operator==(const BoxMm&, const BoxMm&) = default;
};

struct Clip {
    std::optional<BoxMm> boxMm; ///< JSON: [[x, y, z], [x, y, z]]; what is outside is cut away
    std::vector<ClipPlane> planes;
    friend bool operator==(const Clip&, const Clip&) = default;
};

enum class CleanupKind { keepLargest, keepAt, removeIslands, scissors, eraseLabel };
enum class ScissorsSide { inside, outside };

/// One non-destructive clean-up step; steps run in order when the figure is loaded.
struct CleanupStep {
    CleanupKind kind = CleanupKind::keepLargest;
    double above = 0;                         ///< matter is what is above this value (islands)
    double belowMm3 = 1000;                   ///< removeIslands: islands smaller than this go
    std::optional<glm::dvec3> atMm;           ///< keepAt: a point of the island that stays
    std::vector<glm::dvec2> polygon;          ///< scissors: lasso in figure coordinates
    std::optional<Camera> camera;             ///< scissors: the view it was drawn in
    ScissorsSide side = ScissorsSide::inside; ///< scissors: which side is cut away
    int label = 0;                            ///< eraseLabel
    /// keepLargest: matter thinner than twice this does not connect, so that a headrest that touches the skin goes;
    /// 0: plain connection. Thin parts of what stays (ears, eyelids) are not lost.
    double openingMm = 0;
    friend bool operator==(const CleanupStep&, const CleanupStep&) = default;
};

struct StyleEntry {
    std::string id;   ///< what nodes refer to
    std::string file; ///< inside the project, relative to figure.json, or "bundled:ID"
    std::string name;
    std::string credit;
    std::string licence;
    std::shared_ptr<const LitSphere> sphere; ///< null until resolved; compared by identity
    friend bool operator==(const StyleEntry&, const StyleEntry&) = default;
};

/// A node carries either a style or a plain colour.
struct TransferNode {
    double at = 0;
    std::string style;
    std::optional<glm::dvec3> rgb;
    friend bool operator==(const TransferNode&, const TransferNode&) = default;
};

enum class TransferKind { oneDimensional, twoDimensional };

/// Styles over a node grid; `styles[y][x]`.
struct TransferGrid {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<std::vector<std::string>> styles;
    friend bool operator==(const TransferGrid&, const TransferGrid&) = default;
};

struct OpacityShape {
    std::string shape = "rectangle"; ///< rectangle, trapezoid, ellipse, polygon, mask
    std::vector<double> x;
    std::vector<double> y;
    double opacity = 1;
    double soft = 0;
    friend bool operator==(const OpacityShape&, const OpacityShape&) = default;
};

struct Transfer {
    TransferKind kind = TransferKind::oneDimensional;
    std::string axis = "value";       ///< 1D
    std::vector<std::string> axes;    ///< 2D: two names
    std::vector<TransferNode> nodes;  ///< 1D, by rising `at`
    std::optional<TransferGrid> grid; ///< 2D; JSON "nodes" as well
    std::vector<glm::dvec2> opacity;  ///< 1D: (value, opacity), rising; two points at one value are a step
    std::vector<OpacityShape> opacity2d;
    friend bool operator==(const Transfer&, const Transfer&) = default;
};

enum class Shading { style, phong, flat };
enum class Transparency { uniform, illustrative };

struct Contours {
    double thicknessMm = 0.8;
    bool curvatureControlled = true;
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

/// Phong's terms; the head light sits at the eye.
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
    std::string axis = "view";
    std::vector<RampKey> ramp;
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
    double opacity = 1; ///< multiplies the transfer function's
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
    double importanceWeight = 1;
    friend bool operator==(const Layer&, const Layer&) = default;
};

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

struct Background {
    std::string kind = "colour"; ///< colour, image
    glm::dvec4 rgba{1, 1, 1, 1};
    std::string file;
    friend bool operator==(const Background&, const Background&) = default;
};

struct Annotation {
    std::string kind = "label"; ///< label, scale-bar, orientation, title, caption, legend
    std::string text;
    std::optional<glm::dvec3> anchorMm;
    std::optional<glm::dvec2> at;
    std::optional<double> lengthMm;
    friend bool operator==(const Annotation&, const Annotation&) = default;
};

struct Output {
    double widthMm = 180;
    double heightMm = 180;
    double dpi = 300;
    bool transparent = false;
    friend bool operator==(const Output&, const Output&) = default;
    [[nodiscard]] glm::ivec2 sizePixels() const; ///< rounded, at least 1
};

enum class GradientEstimator { automatic, central, sobel, neumann, fourthOrder, bspline };
enum class Interpolation { linear, tricubic };

struct Quality {
    double stepVoxels = 0.5; ///< of the smallest spacing
    GradientEstimator gradient = GradientEstimator::central;
    Interpolation interpolation = Interpolation::linear;
    double earlyTermination = 0.001; ///< a ray ends where its transmittance is below this
    int samplesPerPixel = 1;         ///< 1, 4 or 16, on a regular grid
    std::optional<double> tolerance;
    friend bool operator==(const Quality&, const Quality&) = default;
};

/// Members that this version does not know: JSON pointer -> text of the JSON value. Kept through a load and a save.
using UnknownMembers = std::map<std::string, std::string>;

struct Figure {
    std::string title;
    std::optional<VolumeReference> volume;
    std::optional<LabelReference> labels;
    std::optional<VolumeReference> secondVolume;
    Camera camera;
    Clip clip;
    std::vector<CleanupStep> cleanup;
    std::vector<StyleEntry> styles;
    std::vector<Layer> layers;
    std::optional<Importance> importance;
    std::optional<Stipple> stipple;
    Background background;
    std::vector<Annotation> annotations;
    Output output;
    Quality quality;
    UnknownMembers unknown;
    friend bool operator==(const Figure&, const Figure&) = default;

    [[nodiscard]] const StyleEntry* findStyle(const std::string& id) const;
};

} // namespace limner
