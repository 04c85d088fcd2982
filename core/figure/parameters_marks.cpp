#include "core/figure/describe.h"

/// Declarations of stipples and other marks of ink; the rest is in parameters.cpp.

namespace limner::description {

// The stipple factors' exponents and gains reach two powers of ten past the paper's values (stippling.md).

template <>
std::span<const Field> fieldsOf<StippleBoundary>() {
    using T = StippleBoundary;
    static const Field fields[] = {
        field<&T::kgc>("kgc", {.label = "Ground", .help = "Dots without any boundary.", .low = 0, .high = 100}),
        field<&T::kgs>("kgs", {.label = "Gain", .help = "Dots that a full boundary adds.", .low = 0, .high = 100}),
        field<&T::kge>("kge", {.label = "Exponent", .help = "How sharply boundaries count.", .low = 0, .high = 100}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StippleSilhouette>() {
    using T = StippleSilhouette;
    static const Field fields[] = {
        field<&T::ksc>("ksc",
                       {.label = "Ground", .help = "Dots where the surface faces the viewer.", .low = 0, .high = 100}),
        field<&T::kss>("kss", {.label = "Gain", .help = "Dots that the silhouette adds.", .low = 0, .high = 100}),
        field<&T::kse>("kse",
                       {.label = "Exponent", .help = "How sharply the silhouette counts.", .low = 0, .high = 100}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StippleResolution>() {
    using T = StippleResolution;
    static const Field fields[] = {
        field<&T::kre>("kre", {.label = "Exponent",
                               .help = "How fast dots thin out with distance from the viewer.",
                               .low = 0,
                               .high = 100}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StippleDistance>() {
    using T = StippleDistance;
    static const Field fields[] = {
        field<&T::kde>(
            "kde",
            {.label = "Exponent", .help = "Near parts get more dots; negative: far parts.", .low = -100, .high = 100}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StippleInterior>() {
    using T = StippleInterior;
    static const Field fields[] = {
        field<&T::kte>(
            "kte",
            {.label = "Exponent", .help = "How far the interior of matter is cleared of dots.", .low = 0, .high = 100}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StippleLighting>() {
    using T = StippleLighting;
    static const Field fields[] = {
        field<&T::kle>(
            "kle", {.label = "Exponent", .help = "How sharply lit parts are cleared of dots.", .low = 0, .high = 100}),
        field<&T::light>("light", {.label = "Light", .help = "Where the light comes from.", .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StippleCurves>() {
    using T = StippleCurves;
    static const Field fields[] = {
        field<&T::log>("log", {.label = "Edge threshold",
                               .help = "Bound of the Laplacian of Gaussian for a line.",
                               .low = -100,
                               .high = 100}),
        field<&T::eye>("eye", {.label = "Eye threshold",
                               .help = "Largest cosine between normal and view on a line.",
                               .low = 0,
                               .high = 1}),
        field<&T::gradient>(
            "gradient", {.label = "Gradient threshold", .help = "Smallest gradient on a line.", .low = 0, .high = 1}),
        field<&T::widthMm>("width_mm", {.label = "Line width",
                                        .help = "Width of the lines on paper.",
                                        .unit = "mm on paper",
                                        .low = 0,
                                        .high = 100}),
        field<&T::widthBy>("width_by", {.label = "Width by",
                                        .help = "Even, or thinner where the form is flat (curvature) or far (depth).",
                                        .choices = {"even", "curvature", "depth"},
                                        .omitDefault = true}),
        field<&T::hiddenLines>("hidden_lines", {.label = "Hidden lines",
                                                .help = "Lines behind matter are left out, dashed or thin.",
                                                .choices = {"none", "dashed", "thin"},
                                                .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StippleInnerLines>() {
    using T = StippleInnerLines;
    // A curvature of 1 turns by a radian within a voxel of the marks: nothing is sharper.
    static const Field fields[] = {
        field<&T::ridges>(
            "ridges",
            {.label = "Ridges", .help = "How sharp a ridge must be for a line; 0: no ridges.", .low = 0, .high = 10}),
        field<&T::valleys>("valleys", {.label = "Valleys",
                                       .help = "How sharp a valley must be for a line; 0: no valleys.",
                                       .low = 0,
                                       .high = 10}),
        field<&T::widthMm>("width_mm", {.label = "Line width",
                                        .help = "Width of the lines on paper.",
                                        .unit = "mm on paper",
                                        .low = 0,
                                        .high = 100}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StippleHatching>() {
    using T = StippleHatching;
    static const Field fields[] = {
        field<&T::lengthMm>("length_mm", {.label = "Stroke length",
                                          .help = "Length of the strokes on paper.",
                                          .unit = "mm on paper",
                                          .low = 0,
                                          .high = 1000,
                                          .lowExcluded = true}),
        field<&T::widthMm>("width_mm", {.label = "Stroke width",
                                        .help = "Width of the strokes on paper.",
                                        .unit = "mm on paper",
                                        .low = 0,
                                        .high = 100,
                                        .lowExcluded = true}),
        field<&T::cross>(
            "cross", {.label = "Crossing", .help = "Tone above which strokes cross; 1: never.", .low = 0, .high = 1}),
    };
    return fields;
}

namespace {

std::vector<Field> stippleDots() {
    using T = Stipple;
    return {
        field<&T::inkRgb>("ink_rgb",
                          {.label = "Ink", .help = "Colour of the dots.", .unit = "sRGB", .low = 0, .high = 1}),
        field<&T::fromStyle>(
            "from_style",
            {.label = "Ink from style", .help = "Dots take the colour of the style under them.", .cost = kPlan}),
        field<&T::kMax>("k_max", {.label = "Density",
                                  .help = "Factor on the number of dots; 0: no dots.",
                                  .cost = kFields,
                                  .low = 0,
                                  .high = 64}),
        field<&T::threshold>(
            "threshold",
            {.label = "Threshold", .help = "Smallest gradient that gets dots.", .cost = kFields, .low = 0, .high = 1}),
        field<&T::spreadVoxels>("spread_voxels", {.label = "Spread",
                                                  .help = "How far dots lie around the surface.",
                                                  .cost = kFields,
                                                  .unit = "voxels",
                                                  .low = 0,
                                                  .high = 64}),
        field<&T::sizeMm>("size_mm", {.label = "Dot size",
                                      .help = "Diameter of the largest dots on paper.",
                                      .unit = "mm on paper",
                                      .low = 0,
                                      .high = 100}),
    };
}

std::vector<Field> stippleChoices() {
    using T = Stipple;
    return {
        field<&T::hidden>("hidden", {.label = "Hidden dots",
                                     .help = "Dots behind matter are removed or shown.",
                                     .cost = kPlan,
                                     .choices = {"remove", "show"}}),
        field<&T::layerOpacity>("layer_opacity", {.label = "Layers",
                                                  .help = "Dots lie over the drawn layers or under their opacity, or "
                                                          "alone: the layers are not drawn.",
                                                  .cost = kPlan,
                                                  .choices = {"under", "over", "alone"}}),
        field<&T::matter>("matter", {.label = "Matter",
                                     .help = "What the dots take for matter: the data as they are, or what the layers "
                                             "show.",
                                     .cost = kFields,
                                     .choices = {"data", "layers"},
                                     .omitDefault = true}),
        field<&T::placing>("placing", {.label = "Placing",
                                       .help = "Dots lie evenly on paper, or on the volume, where they stay when it "
                                               "turns (a moving picture's always do).",
                                       .choices = {"paper", "volume"},
                                       .omitDefault = true}),
        field<&T::tone>("tone", {.label = "Tone",
                                 .help = "The tone is the share of inked paper, or the share of the most dots.",
                                 .choices = {"ink", "count"},
                                 .omitDefault = true}),
        field<&T::gradient>("gradient", {.label = "Gradient",
                                         .help = "How surfaces are found: by regression over 27 voxels (Neumann), or "
                                                 "by central differences.",
                                         .cost = kFields,
                                         .choices = {"neumann", "central"},
                                         .omitDefault = true}),
        field<&T::seed>("seed", {.label = "Seed",
                                 .help = "Another number spreads the dots otherwise.",
                                 .low = 0,
                                 .high = 1e9,
                                 .omitDefault = true}),
    };
}

std::vector<Field> stippleParts() {
    using T = Stipple;
    return {
        field<&T::boundary>("boundary", {.label = "Boundary", .help = "More dots on boundaries.", .cost = kPlan}),
        field<&T::silhouette>("silhouette",
                              {.label = "Silhouette", .help = "More dots on silhouettes.", .cost = kPlan}),
        field<&T::resolution>(
            "resolution", {.label = "Resolution", .help = "Fewer dots where the volume looks smaller.", .cost = kPlan}),
        field<&T::distance>("distance", {.label = "Distance", .help = "More dots on near parts.", .cost = kPlan}),
        field<&T::interior>("interior", {.label = "Interior", .help = "Fewer dots inside matter.", .cost = kPlan}),
        field<&T::lighting>("lighting", {.label = "Lighting", .help = "Fewer dots in the light.", .cost = kPlan}),
        field<&T::curves>("curves",
                          {.label = "Silhouette curves", .help = "Lines along the silhouettes.", .cost = kPlan}),
        field<&T::innerLines>("inner_lines",
                              {.label = "Inner lines", .help = "Lines along ridges and valleys.", .cost = kFields}),
        field<&T::hatching>("hatching",
                            {.label = "Hatching", .help = "Strokes along the form's curvature.", .cost = kFields}),
    };
}

} // namespace

template <>
std::span<const Field> fieldsOf<Stipple>() {
    static const std::vector<Field> fields = [] {
        std::vector<Field> all = stippleDots();
        for (const std::vector<Field>& more : {stippleChoices(), stippleParts()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return fields;
}

} // namespace limner::description
