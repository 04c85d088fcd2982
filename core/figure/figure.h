#pragma once

#include "core/figure/annotation.h"
#include "core/figure/camera.h"
#include "core/figure/effects.h"
#include "core/figure/layer.h"
#include "core/style/lit_sphere.h"
#include "core/style/texture_tile.h"
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

class BackgroundPicture;

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
    std::string path;                           ///< relative to the project where possible
    std::string absolutePath;                   ///< fallback when the project moved without the labels
    std::map<std::string, std::string> names;   ///< label id in decimal -> name
    std::map<std::string, std::string> colours; ///< label id in decimal -> "#rrggbb"
    std::shared_ptr<const Volume> data;
    friend bool operator==(const LabelReference&, const LabelReference&) = default;
};

enum class CleanupKind { keepLargest, keepAt, removeIslands, scissors, eraseLabel };

enum class ScissorsSide { inside, outside };

/// One non-destructive clean-up step; steps run in order when the figure is loaded.
struct CleanupStep {
    CleanupKind kind = CleanupKind::keepLargest;
    double above = 0;                ///< matter is what is above this value (islands)
    double belowMm3 = 1000;          ///< removeIslands: islands smaller than this go
    std::optional<glm::dvec3> atMm;  ///< keepAt: a point of the island that stays
    std::vector<glm::dvec2> polygon; ///< scissors: lasso in figure coordinates
    std::optional<Camera> camera;    ///< scissors: the view it was drawn in
    /// scissors: width / height of the figure it was drawn in; absent: the figure's own. Another format must not move
    /// the cut.
    std::optional<double> aspect;
    ScissorsSide side = ScissorsSide::inside; ///< scissors: which side is cut away
    int label = 0;                            ///< eraseLabel
    /// keepLargest: matter thinner than twice this does not connect, so that a headrest that touches the skin goes;
    /// 0: plain connection. Thin parts of what stays (ears, eyelids) are not lost.
    double openingMm = 0;
    friend bool operator==(const CleanupStep&, const CleanupStep&) = default;
};

/// A picture laid on the object, apart from the style's lighting: it stays in place when the camera turns.
struct StyleTexture {
    std::string file;                        ///< inside the project, or "bundled:ID"
    double sizeMm = 20;                      ///< edge of the tile on the object
    double strength = 1;                     ///< 0: not seen
    std::shared_ptr<const TextureTile> tile; ///< null until resolved; compared by identity
    friend bool operator==(const StyleTexture&, const StyleTexture&) = default;
};

struct StyleEntry {
    std::string id;   ///< what nodes refer to
    std::string file; ///< inside the project, relative to figure.json, or "bundled:ID"
    std::string name;
    std::string credit;
    std::string licence;
    std::shared_ptr<const LitSphere> sphere; ///< null until resolved; compared by identity
    std::string role =
        {}; ///< what a theme exchanges it by: "bone", "skin", "vessel", ...; empty: themes leave it alone
    std::optional<StyleTexture> texture = {};
    friend bool operator==(const StyleEntry&, const StyleEntry&) = default;
};

struct Background {
    std::string kind = "colour"; ///< colour, image
    glm::dvec4 rgba{1, 1, 1, 1};
    std::string file; ///< of an image: inside the project, beside it, or an absolute path
    std::shared_ptr<const BackgroundPicture> picture = nullptr; ///< null until resolved; compared by identity
    friend bool operator==(const Background&, const Background&) = default;
};

struct Output {
    double widthMm = 180;
    double heightMm = 180;
    double dpi = 300;
    bool transparent = false;
    friend bool operator==(const Output&, const Output&) = default;
    [[nodiscard]] glm::ivec2 sizePixels() const; ///< rounded, at least 1
    [[nodiscard]] double aspect() const { return widthMm / heightMm; }
};

enum class GradientEstimator { automatic, central, sobel, neumann, fourthOrder, bspline };

/// Between voxels. `tricubic`: the cubic B-spline that passes through the voxels; `smooth`: the one that the voxels
/// steer, which rounds what is finer than a voxel. `automatic`: smooth for thick slices, else linear.
enum class Interpolation { automatic, linear, tricubic, smooth };

/// How voxels are kept while drawing. `eightBits`: by the 256 levels that fit the scan best (Lloyd-Max), for scans that
/// would not fit otherwise.
enum class VoxelPrecision { full, eightBits };

/// What a tolerance bounds, against the same figure drawn without any error of sampling (spec accuracy.md 1.3, 1.9):
/// the colour difference CIEDE2000 that 95 % of the pixels stay below, the largest difference of a channel of a pixel,
/// or the root of the mean square of these; the last two as shares of the full range.
enum class ErrorMetric { ciede2000, largest, rootMeanSquare };

/// What trades error against time. The search for a tolerance (renderer/accuracy/tolerance.h) chooses among these.
struct Quality {
    double stepVoxels = 0.5; ///< of the smallest spacing
    GradientEstimator gradient = GradientEstimator::central;
    Interpolation interpolation = Interpolation::linear;
    double earlyTermination = 0.001; ///< a ray ends where its transmittance is below this
    int samplesPerPixel = 1;         ///< 1, 4 or 16, on a regular grid
    VoxelPrecision precision = VoxelPrecision::full;
    /// Opacity and place of colour by integrals over the values between two ends of a step instead of the value at its
    /// middle: thin peaks of a transfer function are not missed.
    bool preintegration = false;
    int tableEntries = 0; ///< of a transfer function; 0: as many as its narrowest feature needs
    std::optional<double> tolerance;
    ErrorMetric toleranceMetric = ErrorMetric::ciede2000;
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
    std::optional<DepthCues> depthCues;
    std::optional<Stipple> stipple;
    Background background;
    std::vector<Annotation> annotations;
    std::string annotationLayout = "columns"; ///< columns, ring, free: of labels without a place
    Output output;
    Quality quality;
    UnknownMembers unknown;
    friend bool operator==(const Figure&, const Figure&) = default;

    [[nodiscard]] const StyleEntry* findStyle(const std::string& id) const;
    /// Whether a layer of this figure is drawn: it is visible, and solo where any layer is.
    [[nodiscard]] bool draws(const Layer& layer) const;
};

} // namespace limner
