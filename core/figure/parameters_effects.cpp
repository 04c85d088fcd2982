#include "core/figure/describe.h"

/// Declarations of what acts on all layers: importance and depth cues; the rest is in parameters.cpp.

namespace limner::description {

template <>
std::span<const Field> fieldsOf<ImportanceWeights>() {
    using T = ImportanceWeights;
    // Composition is tested up to weights of 1e5 (importance-composition.md).
    static const Field fields[] = {
        field<&T::intensity>("intensity", {.label = "Intensity", .help = "Bright data matter.", .low = 0, .high = 1e5}),
        field<&T::extinction>("extinction",
                              {.label = "Extinction", .help = "Dense matter matters.", .low = 0, .high = 1e5}),
        field<&T::gradient>("gradient", {.label = "Gradient", .help = "Boundaries matter.", .low = 0, .high = 1e5}),
        field<&T::silhouette>("silhouette", {.label = "Silhouette", .help = "Outlines matter.", .low = 0, .high = 1e5}),
        field<&T::unocclusion>("unocclusion",
                               {.label = "Unocclusion", .help = "What nothing hides matters.", .low = 0, .high = 1e5}),
        field<&T::lighting>(
            "lighting",
            {.label = "Lighting", .help = "Shade and rim matter more than lit flats.", .low = 0, .high = 1e5}),
        field<&T::object>("object",
                          {.label = "Object", .help = "Labelled parts matter by their weight.", .low = 0, .high = 1e5}),
        field<&T::statistics>(
            "statistics",
            {.label = "Statistics", .help = "What differs from its surroundings matters.", .low = 0, .high = 1e5}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Lens>() {
    using T = Lens;
    static const Field fields[] = {
        field<&T::kind>("kind", {.label = "Kind",
                                 .help = "Edge of the lens: hard, soft or a screen of dots.",
                                 .choices = {"circular", "gaussian", "screendoor"}}),
        field<&T::center>(
            "center",
            {.label = "Centre", .help = "In figure coordinates.", .unit = "of the figure", .low = -1e3, .high = 1e3}),
        field<&T::radius>("radius", {.label = "Radius",
                                     .help = "As a share of the figure's height.",
                                     .unit = "of the figure",
                                     .low = 0,
                                     .high = 1e3,
                                     .lowExcluded = true}),
        field<&T::cell>("cell", {.label = "Cell",
                                 .help = "Size of the screen's dots.",
                                 .unit = "of the figure",
                                 .low = 0,
                                 .high = 1,
                                 .lowExcluded = true}),
        field<&T::shape>("shape", {.label = "Shape",
                                   .help = "Outline of the lens.",
                                   .choices = {"circle", "ellipse", "box"},
                                   .omitDefault = true}),
        field<&T::aspect>("aspect", {.label = "Aspect",
                                     .help = "Width over height, of an ellipse or a box.",
                                     .low = 0.01,
                                     .high = 100,
                                     .omitDefault = true}),
        field<&T::angleDeg>("angle_deg", {.label = "Angle",
                                          .help = "Turns an ellipse or a box counter-clockwise.",
                                          .unit = "deg",
                                          .low = -360,
                                          .high = 360,
                                          .omitDefault = true}),
        field<&T::soft>("soft", {.label = "Softness",
                                 .help = "Share of the radius over which a hard edge fades.",
                                 .low = 0,
                                 .high = 1,
                                 .omitDefault = true}),
        field<&T::inside>("inside", {.label = "Inside",
                                     .help = "Factor of the importance in the middle of the lens.",
                                     .low = 0,
                                     .high = 100,
                                     .omitDefault = true}),
        field<&T::outside>("outside", {.label = "Outside",
                                       .help = "Factor of the importance away from the lens.",
                                       .low = 0,
                                       .high = 100,
                                       .omitDefault = true}),
        field<&T::anchorMm>("anchor_mm", {.label = "Anchor",
                                          .help = "A point of the scan that the lens follows as the view turns.",
                                          .unit = "mm",
                                          .low = -1e6,
                                          .high = 1e6,
                                          .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<SilhouetteMeasure>() {
    using T = SilhouetteMeasure;
    static const Field fields[] = {
        field<&T::exponent>(
            "exponent",
            {.label = "Exponent", .help = "How much an outline's boundary must stand out.", .low = 0, .high = 100}),
        field<&T::range>("range", {.label = "Range",
                                   .help = "From no outline to all of one, by 1 less the cosine of normal and view.",
                                   .low = 0,
                                   .high = 1}),
        field<&T::darkening>(
            "darkening",
            {.label = "Darkening", .help = "How dark outlines are drawn; 0: not at all.", .low = 0, .high = 100}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<LightingMeasure>() {
    using T = LightingMeasure;
    static const Field fields[] = {
        field<&T::direction>(
            "direction",
            {.label = "Light", .help = "Direction to the light: right, up, towards the viewer.", .low = -1, .high = 1}),
        field<&T::highlight>(
            "highlight", {.label = "Highlight", .help = "Exponent of the highlight's part.", .low = 1, .high = 1000}),
        field<&T::diffuse>("diffuse",
                           {.label = "Diffuse", .help = "Exponent of the lit flats' part.", .low = 1, .high = 1000}),
        field<&T::gradient>(
            "gradient",
            {.label = "Gradient", .help = "Exponent of the part without boundary.", .low = 1, .high = 1000}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<ObjectImportance>() {
    using T = ObjectImportance;
    static const Field fields[] = {
        field<&T::label>("label", {.label = "Label", .help = "Number of the object's label.", .low = 0}),
        field<&T::weight>("weight", {.label = "Weight", .help = "How much the object matters.", .low = 0, .high = 1e5}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Importance>() {
    using T = Importance;
    static const Field fields[] = {
        field<&T::global>("global", {.label = "Importance",
                                     .help = "How much importance overrules what lies in front; 0: not at all.",
                                     .low = 0,
                                     .high = 1e5}),
        field<&T::weights>("weights", {.label = "Weights", .help = "What makes a sample important."}),
        field<&T::background>("background",
                              {.label = "Background", .help = "Importance of the paper.", .low = 0, .high = 1e5}),
        field<&T::lenses>("lenses", {.label = "Lenses",
                                     .help = "Places where importance acts; none: everywhere.",
                                     .cost = kPlan,
                                     .atMost = 64}),
        field<&T::silhouette>("silhouette",
                              {.label = "Outlines", .help = "What counts as an outline.", .omitDefault = true}),
        field<&T::lighting>("lighting", {.label = "Light", .help = "What counts as lit.", .omitDefault = true}),
        field<&T::objects>("objects", {.label = "Objects",
                                       .help = "Importance of labelled objects.",
                                       .cost = kPlan,
                                       .atMost = 255,
                                       .omitDefault = true}),
        field<&T::statisticsVoxels>("statistics_voxels", {.label = "Neighbourhood",
                                                          .help = "How far around a place its statistics are taken.",
                                                          .cost = kFields,
                                                          .unit = "voxels",
                                                          .low = 0.5,
                                                          .high = 32,
                                                          .omitDefault = true}),
        field<&T::cap>("cap", {.label = "Limit",
                               .help = "Greatest importance: at 8, matter needs an opacity of 0.03 % to show through "
                                       "all that is in front; at 20 the faintest haze does.",
                               .low = 0,
                               .high = 64}),
        field<&T::noiseFloor>("noise_floor", {.label = "Noise floor",
                                              .help = "Matter thinner than this never comes forward, so that noise "
                                                      "stays hidden.",
                                              .unit = "per voxel",
                                              .low = 0,
                                              .high = 1e3}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<AmbientOcclusion>() {
    using T = AmbientOcclusion;
    static const Field fields[] = {
        field<&T::strength>(
            "strength",
            {.label = "Strength", .help = "How dark hollows get; 0: not at all.", .cost = kPlan, .low = 0, .high = 1}),
        field<&T::reachMm>("reach_mm", {.label = "Reach",
                                        .help = "How far around a place matter takes its light.",
                                        .cost = kFields,
                                        .unit = "mm",
                                        .low = 0,
                                        .high = 1e4,
                                        .lowExcluded = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<ContactShadow>() {
    using T = ContactShadow;
    static const Field fields[] = {
        field<&T::light>("light", {.label = "Light", .help = "Where the shadow's light comes from.", .cost = kFields}),
        field<&T::strength>(
            "strength", {.label = "Strength", .help = "How dark the shadow is.", .cost = kPlan, .low = 0, .high = 1}),
        field<&T::reachMm>("reach_mm", {.label = "Reach",
                                        .help = "How far things cast their shadow.",
                                        .cost = kFields,
                                        .unit = "mm",
                                        .low = 0,
                                        .high = 1e4,
                                        .lowExcluded = true}),
        field<&T::softDeg>("soft_deg", {.label = "Softness",
                                        .help = "Half the angle under which the light is seen.",
                                        .cost = kFields,
                                        .unit = "deg",
                                        .low = 0,
                                        .high = 60}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Halo>() {
    using T = Halo;
    static const Field fields[] = {
        field<&T::rgb>("rgb", {.label = "Colour",
                               .help = "Colour of the seam: dark, or the paper's.",
                               .cost = kPlan,
                               .unit = "sRGB",
                               .low = 0,
                               .high = 1}),
        field<&T::strength>("strength", {.label = "Strength",
                                         .help = "How much of what lies behind the halo hides.",
                                         .cost = kPlan,
                                         .low = 0,
                                         .high = 1}),
        field<&T::widthMm>("width_mm", {.label = "Width",
                                        .help = "Of the seam around what is in front.",
                                        .cost = kFields,
                                        .unit = "mm on paper",
                                        .low = 0,
                                        .high = 100,
                                        .lowExcluded = true}),
        field<&T::depthMm>("depth_mm", {.label = "Depth",
                                        .help = "How far behind the seam reaches its full width.",
                                        .cost = kFields,
                                        .unit = "mm",
                                        .low = 0,
                                        .high = 1e4,
                                        .lowExcluded = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<DepthCues>() {
    using T = DepthCues;
    static const Field fields[] = {
        field<&T::ambientOcclusion>(
            "ambient_occlusion",
            {.label = "Ambient occlusion", .help = "Hollows and crevices are darker.", .cost = kPlan}),
        field<&T::shadow>(
            "shadow", {.label = "Contact shadow", .help = "A soft shadow on what lies close behind.", .cost = kPlan}),
        field<&T::halo>(
            "halo",
            {.label = "Halos", .help = "A seam that parts what is in front from what is behind.", .cost = kPlan}),
    };
    return fields;
}

} // namespace limner::description
