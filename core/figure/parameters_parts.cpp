#include "core/figure/describe.h"

/// Declarations of the optional parts of layers, contours to depth of field; the rest is in parameters.cpp.

namespace limner::description {

template <>
std::span<const Field> fieldsOf<Contours>() {
    using T = Contours;
    static const Field fields[] = {
        field<&T::thicknessMm>("thickness_mm", {.label = "Contour thickness",
                                                .help = "Width of the pen on paper.",
                                                .unit = "mm on paper",
                                                .low = 0,
                                                .high = 100}),
        field<&T::curvatureControlled>(
            "curvature_controlled",
            {.label = "Even width", .help = "The pen keeps its width on flat and bent surfaces alike.", .cost = kPlan}),
        field<&T::curvature>("curvature", {.label = "Curvature",
                                           .help = "Measured from second derivatives, or from two normals on the ray.",
                                           .cost = kPlan,
                                           .choices = {"hessian", "normals"}}),
        field<&T::probeVoxels>("probe_voxels", {.label = "Probe",
                                                .help = "Distance over which the curvature is measured.",
                                                .unit = "voxels",
                                                .low = 0,
                                                .high = 64,
                                                .lowExcluded = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Light>() {
    using T = Light;
    static const Field fields[] = {
        field<&T::kind>(
            "kind",
            {.label = "Light", .help = "Fixed to the viewer's head, or to the object.", .choices = {"head", "object"}}),
        field<&T::direction>(
            "direction",
            {.label = "Direction", .help = "From the object towards the light.", .low = -kFarMm, .high = kFarMm}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<ColourKey>() {
    using T = ColourKey;
    static const Field fields[] = {
        field<&T::at>("at", {.label = "Position",
                             .help = "Where on the ramp, from shade (0) to light (1).",
                             .cost = kTables,
                             .low = 0,
                             .high = 1}),
        field<&T::rgb>(
            "rgb",
            {.label = "Colour", .help = "Colour at the key.", .cost = kTables, .unit = "sRGB", .low = 0, .high = 1}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Tone>() {
    using T = Tone;
    static const Field fields[] = {
        field<&T::light>("light", {.label = "Light", .help = "Where the tone's light comes from."}),
        field<&T::keys>(
            "keys",
            {.label = "Key colours", .help = "Colour ramp from shade to light.", .cost = kTables, .atMost = 256}),
        field<&T::saturation>("saturation", {.label = "Saturation",
                                             .help = "Strength of the tone's colour; 0 leaves only its brightness.",
                                             .low = 0,
                                             .high = 4}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Silhouette>() {
    using T = Silhouette;
    static const Field fields[] = {
        field<&T::rgb>("rgb",
                       {.label = "Colour", .help = "Colour of the outline.", .unit = "sRGB", .low = 0, .high = 1}),
        field<&T::range>("range", {.label = "Range",
                                   .help = "From full to none, by the cosine between normal and view.",
                                   .low = 0,
                                   .high = 1}),
        field<&T::opacity>("opacity", {.label = "Opacity", .help = "Opacity of the outline.", .low = 0, .high = 1}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<PhongLight>() {
    using T = PhongLight;
    static const Field fields[] = {
        field<&T::ambient>(
            "ambient",
            {.label = "Ambient", .help = "Light that reaches every place.", .cost = kPlan, .low = 0, .high = 4}),
        field<&T::diffuse>(
            "diffuse",
            {.label = "Diffuse", .help = "Light on what faces the viewer.", .cost = kPlan, .low = 0, .high = 4}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Specular>() {
    using T = Specular;
    static const Field fields[] = {
        field<&T::strength>("strength",
                            {.label = "Highlight", .help = "Strength of the highlight.", .low = 0, .high = 10}),
        field<&T::exponent>(
            "exponent",
            {.label = "Shininess", .help = "The higher, the smaller the highlight.", .low = 0, .high = 10000}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<RampKey>() {
    using T = RampKey;
    static const Field fields[] = {
        field<&T::at>(
            "at",
            {.label = "Position", .help = "Where along the axis, from 0 to 1.", .cost = kTables, .low = 0, .high = 1}),
        field<&T::rgba>("rgba", {.label = "Tint",
                                 .help = "Factors of red, green, blue and opacity; above 1 brightens.",
                                 .cost = kTables,
                                 .low = 0,
                                 .high = 16}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<PositionRamp>() {
    using T = PositionRamp;
    static const Field fields[] = {
        field<&T::axis>("axis", {.label = "Axis",
                                 .help = "Along the view, or along an axis of the patient.",
                                 .cost = kPlan,
                                 .choices = {"view", "x", "y", "z", "direction"}}),
        field<&T::ramp>("ramp", {.label = "Ramp", .help = "Tints along the axis.", .cost = kTables, .atMost = 256}),
        field<&T::direction>("direction", {.label = "Direction",
                                           .help = "Of the axis \"direction\", in the patient's coordinates.",
                                           .cost = kPlan,
                                           .low = -kFarMm,
                                           .high = kFarMm,
                                           .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<DepthOfField>() {
    using T = DepthOfField;
    static const Field fields[] = {
        field<&T::focus>("focus", {.label = "Focus",
                                   .help = "Depth that is sharp, from the front (0) to the back (1).",
                                   .low = 0,
                                   .high = 1}),
        field<&T::strength>(
            "strength",
            {.label = "Blur", .help = "How fast the layer blurs away from the focus.", .low = 0, .high = 100}),
    };
    return fields;
}

} // namespace limner::description
