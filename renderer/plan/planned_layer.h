#pragma once

#include "core/figure/figure.h"
#include "core/style/transfer_function.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limner {

/// What a RenderPlan says of one visible layer.

/// A layer's contours, ready to draw.
struct PlanContours {
    bool curvatureControlled = true;
    CurvatureEstimator curvature = CurvatureEstimator::hessian;
    double thicknessMm = 0; ///< of the pen in the target plane, on the object
    double probeMm = 1;     ///< CurvatureEstimator::normals: distance between the two
    /// Not controlled: where contours end, |n.v|: as on a ball of kUncontrolledRadiusMm on paper.
    double fixedWidth = 0;
};

/// Radius, mm on paper, of the ball on which contours that do not follow the curvature have their asked width.
inline constexpr double kUncontrolledRadiusMm = 10;

/// A style's texture, ready to draw; without a tile: none.
struct PlanTexture {
    std::shared_ptr<const TextureTile> tile; ///< no finer than a pixel
    double perMm = 1;                        ///< tiles
    double strength = 0;
};

/// A layer's parts beside its transfer function (paper 003; core/optics/layers.h), ready to draw. What would change
/// nothing is absent.
struct PlanParts {
    std::optional<Tone> tone;
    glm::dvec3 lightEye{0, 0, 1}; ///< unit, of tone and highlight: right, up, towards the viewer
    std::optional<Silhouette> silhouette;
    std::optional<Specular> specular; ///< on shading other than Phong's, which has its own
    std::optional<std::vector<glm::dvec2>> gradientOpacity;
    std::optional<std::vector<glm::dvec2>> lineGradientOpacity; ///< only beside a silhouette or a highlight
    std::optional<PositionRamp> position;
    glm::dvec4 placeOfVoxel{0}; ///< place on the ramp: dot(xyz, position in voxels) + w

    // The same as tables of kRampEntries, for backends that read tables (core/style/ramps.h); empty where absent.
    std::vector<glm::vec4> toneTable;
    std::vector<glm::vec4> positionTable;
    std::vector<float> gradientTable;
    std::vector<float> lineTable;
};

/// A layer's depth of field: how blurred a place is (optics::blurLevel).
struct PlanFocus {
    glm::dvec4 depthOfVoxel{0}; ///< as PlanParts::placeOfVoxel: 0 at the front of the scan's box, 1 at its back
    double focus = 0.5;
    double strength = 0;
};

/// Cuts by planes: kept is where dot(normalMm, position in mm) <= offsetMm.
struct PlanCut {
    struct Plane {
        glm::dvec3 normalMm{0}; ///< unit
        double offsetMm = 0;
        glm::dvec3 rgb{0}; ///< of its face, where `coloured`
    };
    std::vector<Plane> planes;
    bool faces = false;    ///< drawn flat, by the planes' normals
    bool coloured = false; ///< ... and in a colour of their own
};

/// One visible layer, ready to draw.
struct PlanLayer {
    std::string name;
    const Layer* source = nullptr; ///< in the plan's figure: what the reference evaluates
    Shading shading = Shading::style;
    bool twoSided = true;
    bool illustrative = false; ///< transparency by the 100-percent rule
    Specular specular;         ///< Phong's
    PhongLight light;          ///< Phong's
    std::optional<PlanContours> contours;
    TransferTable table;
    std::vector<float> stepOpacity; ///< of one whole step of the plan's lattice, entries as the table's
    std::vector<float> slabs;       ///< pre-integration alone: slab_table.h, over the table's entries
    StyleIndex styles;
    /// Parallel to `styles.styles`, at the plan's resolution; empty where none of them has one.
    std::vector<PlanTexture> textures;
    std::vector<int> atlasSlots; ///< distinct style -> slot of the atlas; empty unless shading is style with a sphere
    std::vector<std::uint8_t> shownSlots;     ///< label slot -> 1 where the label shows; empty: all show
    std::vector<std::int16_t> rowOfSlot;      ///< label slot -> row of the table, -1: none; empty: no label axis
    std::shared_ptr<const Volume> distance;   ///< axis "distance" from a label: mm; else null
    std::optional<glm::dvec3> distanceFromMm; ///< axis "distance" from a point
    std::optional<PlanParts> parts;
    std::optional<PlanFocus> focus;
    std::optional<PlanCut> cut; ///< of this layer alone
};

/// What a layer's evaluation reads beside the value.
bool readsNormal(const PlanLayer& layer);
/// Whether it asks how large a gradient is, beside its direction.
bool readsGradientScale(const PlanLayer& layer);
bool readsCurvature(const PlanLayer& layer);
/// Curvature by second derivatives: an axis always, contours by their choice.
bool readsSecondDerivatives(const PlanLayer& layer);
bool readsLabels(const PlanLayer& layer);
/// Whether a sample's opacity follows from its value alone, so that it is known before the sample is shaded.
bool opacityByValue(const PlanLayer& layer);
/// Whether the layer's transfer function reads an axis.
bool readsAxis(const PlanLayer& layer, TransferAxis axis);

} // namespace limner
