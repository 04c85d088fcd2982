#include "core/figure/describe.h"

/// The one place where settings are declared: a row per member of figure.h, in the order of the document. The optional
/// parts' rows are in parameters_parts.cpp.

namespace limner::description {
namespace {

constexpr Facts kOpening{.label = "Opening",
                         .help = "Matter thinner than twice this does not connect, so that a headrest that touches the "
                                 "skin goes; 0: plain connection.",
                         .cost = kFields,
                         .unit = "mm",
                         .low = 0,
                         .high = 100,
                         .omitDefault = true};

/// Whether a field that belongs to some kinds only is written: for those kinds, or so that nothing set is lost.
template <class Object, bool (*Written)(const Object&)>
bool asked(const void* object) {
    return Written(*static_cast<const Object*>(object));
}

bool writesAbove(const CleanupStep& s) {
    return s.kind == CleanupKind::keepLargest || s.kind == CleanupKind::keepAt ||
           s.kind == CleanupKind::removeIslands || s.above != CleanupStep{}.above;
}
bool writesIslandSize(const CleanupStep& s) {
    return s.kind == CleanupKind::removeIslands || s.belowMm3 != CleanupStep{}.belowMm3;
}
bool writesPolygon(const CleanupStep& s) { return s.kind == CleanupKind::scissors || !s.polygon.empty(); }
bool writesSide(const CleanupStep& s) { return s.kind == CleanupKind::scissors || s.side != CleanupStep{}.side; }
bool writesLabel(const CleanupStep& s) { return s.kind == CleanupKind::eraseLabel || s.label != 0; }

} // namespace

template <>
std::span<const Field> fieldsOf<VolumeReference>() {
    using T = VolumeReference;
    static const Field fields[] = {
        field<&T::path>(
            "path", {.label = "Scan", .help = "File or folder of the scan, relative to the project.", .cost = kVolume}),
        field<&T::absolutePath>("absolute_path", {.label = "Scan, full path",
                                                  .help = "Tried when the project moved without its scan.",
                                                  .cost = kNone,
                                                  .omitDefault = true}),
        field<&T::sha256>("sha256", {.label = "Check sum",
                                     .help = "SHA-256 of the stored numbers; tells when the scan has changed.",
                                     .cost = kNone}),
        field<&T::bytes>("bytes", {.label = "File size",
                                   .help = "Size of the scan's file or files; 0: not known.",
                                   .cost = kNone,
                                   .unit = "bytes",
                                   .low = 0,
                                   .omitDefault = true}),
        field<&T::embedded>("embedded",
                            {.label = "Embedded", .help = "The scan lies inside the project file.", .cost = kNone}),
        field<&T::raw>("raw", {.label = "Raw layout",
                               .help = "Layout of headerless data: 256x256x230:uint16:le:0.5,0.5,0.7.",
                               .cost = kVolume,
                               .omitDefault = true}),
        field<&T::series>("series", {.label = "Series",
                                     .help = "DICOM series where the folder holds several.",
                                     .cost = kVolume,
                                     .omitDefault = true}),
        outside<&T::data>(kVolume),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<LabelReference>() {
    using T = LabelReference;
    static const Field fields[] = {
        field<&T::path>(
            "path", {.label = "Labels", .help = "Volume of label numbers, relative to the project.", .cost = kFields}),
        field<&T::absolutePath>("absolute_path", {.label = "Labels, full path",
                                                  .help = "Tried when the project moved without its labels.",
                                                  .cost = kNone,
                                                  .omitDefault = true}),
        field<&T::names>("names", {.label = "Names", .help = "Name of each label number.", .cost = kNone}),
        field<&T::colours>("colours", {.label = "Colours",
                                       .help = "Colour of each label number, as #rrggbb.",
                                       .cost = kNone,
                                       .omitDefault = true}),
        outside<&T::data>(kFields),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Camera>() {
    using T = Camera;
    static const Field fields[] = {
        field<&T::projection>("projection", {.label = "Projection",
                                             .help = "Parallel rays, or rays from an eye.",
                                             .cost = kPlan,
                                             .choices = {"orthographic", "perspective"}}),
        field<&T::targetMm>("target_mm",
                            {.label = "Target",
                             .help = "The point in the middle of the picture, in patient coordinates (LPS).",
                             .unit = "mm",
                             .low = -kFarMm,
                             .high = kFarMm}),
        field<&T::direction>("direction", {.label = "Direction",
                                           .help = "The way the viewer looks; any length but zero.",
                                           .low = -kFarMm,
                                           .high = kFarMm}),
        field<&T::up>("up", {.label = "Up",
                             .help = "What is up in the picture; not along the direction.",
                             .low = -kFarMm,
                             .high = kFarMm}),
        field<&T::heightMm>("height_mm", {.label = "Height",
                                          .help = "Height of what the picture shows at the target.",
                                          .unit = "mm",
                                          .low = 0,
                                          .high = kFarMm,
                                          .lowExcluded = true}),
        field<&T::fovDeg>("fov_deg", {.label = "Field of view",
                                      .help = "Full vertical angle of a perspective view.",
                                      .unit = "deg",
                                      .low = 0,
                                      .high = 170,
                                      .lowExcluded = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<ClipPlane>() {
    using T = ClipPlane;
    static const Field fields[] = {
        field<&T::normal>(
            "normal",
            {.label = "Normal", .help = "Points to the side that is cut away.", .low = -kFarMm, .high = kFarMm}),
        field<&T::offsetMm>("offset_mm", {.label = "Offset",
                                          .help = "Where normal · position is larger, matter is cut away.",
                                          .unit = "mm",
                                          .low = -kFarMm,
                                          .high = kFarMm}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<CutFace>() {
    using T = CutFace;
    static const Field fields[] = {
        field<&T::style>("style", {.label = "Style", .help = "Style of the cut.", .cost = kPlan, .omitDefault = true}),
        field<&T::rgb>("rgb", {.label = "Colour",
                               .help = "Plain colour of the cut.",
                               .cost = kPlan,
                               .unit = "sRGB",
                               .low = 0,
                               .high = 1,
                               .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Clip>() {
    using T = Clip;
    static const Field fields[] = {
        field<&T::boxMm>("box_mm", {.label = "Clip box",
                                    .help = "Low and high corner; what is outside is cut away.",
                                    .cost = kRedraw,
                                    .unit = "mm",
                                    .low = -kFarMm,
                                    .high = kFarMm}),
        field<&T::planes>("planes", {.label = "Clip planes",
                                     .help = "Half spaces that are cut away.",
                                     .cost = kRedraw,
                                     .atMost = 64}), // each costs every ray
        field<&T::face>("face", {.label = "Cut faces",
                                 .help = "Cuts are drawn flat, in a style of their own or the layer's.",
                                 .cost = kPlan,
                                 .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<CleanupStep>() {
    using T = CleanupStep;
    static const Field fields[] = {
        field<&T::kind>("kind", {.label = "Step",
                                 .help = "What is removed before drawing.",
                                 .cost = kFields,
                                 .choices = {"keep-largest", "keep-at", "remove-islands", "scissors", "erase-label"}}),
        field<&T::above>("above", {.label = "Matter above",
                                   .help = "What is above this value counts as matter.",
                                   .cost = kFields,
                                   .unit = kDataUnit,
                                   .written = asked<T, writesAbove>}),
        field<&T::belowMm3>("below_mm3", {.label = "Smallest island",
                                          .help = "Islands with less volume than this are removed.",
                                          .cost = kFields,
                                          .unit = "mm³",
                                          .low = 0,
                                          .written = asked<T, writesIslandSize>}),
        field<&T::atMm>("at_mm", {.label = "Island at",
                                  .help = "A point of the island that stays.",
                                  .cost = kFields,
                                  .unit = "mm",
                                  .low = -kFarMm,
                                  .high = kFarMm,
                                  .omitDefault = true}),
        field<&T::polygon>("polygon", {.label = "Lasso",
                                       .help = "Outline in figure coordinates, at least three points.",
                                       .cost = kFields,
                                       .unit = "of the figure",
                                       .low = -1e3,
                                       .high = 1e3,
                                       .written = asked<T, writesPolygon>}),
        field<&T::camera>("camera", {.label = "Lasso's view",
                                     .help = "The view in which the outline was drawn.",
                                     .cost = kFields,
                                     .omitDefault = true,
                                     .whole = true}),
        field<&T::aspect>("aspect", {.label = "Lasso's format",
                                     .help = "Width over height of the figure in which the outline was drawn.",
                                     .cost = kFields,
                                     .low = 1e-3,
                                     .high = 1e3,
                                     .omitDefault = true}),
        field<&T::side>("side", {.label = "Cut away",
                                 .help = "Which side of the outline is cut away.",
                                 .cost = kFields,
                                 .choices = {"inside", "outside"},
                                 .written = asked<T, writesSide>}),
        field<&T::label>("label", {.label = "Label",
                                   .help = "Number of the label to erase.",
                                   .cost = kFields,
                                   .low = 0,
                                   .written = asked<T, writesLabel>}),
        field<&T::openingMm>("opening_mm", kOpening),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StyleTexture>() {
    using T = StyleTexture;
    static const Field fields[] = {
        field<&T::file>("file",
                        {.label = "Picture", .help = "Picture inside the project, or bundled:ID.", .cost = kTables}),
        field<&T::sizeMm>("size_mm", {.label = "Size",
                                      .help = "Edge of the tile on the object.",
                                      .unit = "mm",
                                      .low = 0,
                                      .high = kFarMm,
                                      .lowExcluded = true}),
        field<&T::strength>("strength", {.label = "Strength", .help = "0: not seen.", .low = 0, .high = 1}),
        outside<&T::tile>(kTables),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<StyleEntry>() {
    using T = StyleEntry;
    static const Field fields[] = {
        field<&T::id>("id", {.label = "Id", .help = "What transfer functions call the style.", .cost = kTables}),
        field<&T::file>("file",
                        {.label = "Picture", .help = "Picture inside the project, or bundled:ID.", .cost = kTables}),
        field<&T::name>("name", {.label = "Name", .help = "Name for people.", .cost = kNone}),
        field<&T::credit>("credit", {.label = "Credit", .help = "Who made the artwork.", .cost = kNone}),
        field<&T::licence>("licence", {.label = "Licence", .help = "Terms of the artwork.", .cost = kNone}),
        field<&T::role>("role", {.label = "Role",
                                 .help = "What themes exchange the style by: bone, skin, vessel ...",
                                 .cost = kNone,
                                 .omitDefault = true}),
        field<&T::texture>("texture", {.label = "Texture",
                                       .help = "A picture laid on the object, apart from the lighting.",
                                       .cost = kPlan,
                                       .omitDefault = true}),
        outside<&T::sphere>(kTables),
    };
    return fields;
}

namespace {

std::vector<Field> layerBasics() {
    using T = Layer;
    return {
        field<&T::name>("name", {.label = "Name", .help = "Name of the layer.", .cost = kNone}),
        field<&T::visible>("visible", {.label = "Visible", .help = "Whether the layer is drawn.", .cost = kPlan}),
        field<&T::solo>("solo", {.label = "Solo",
                                 .help = "Layers without it are not drawn while any layer has it.",
                                 .cost = kPlan,
                                 .omitDefault = true}),
        field<&T::locked>("locked", {.label = "Locked",
                                     .help = "The layer is safe from changes in the studio.",
                                     .cost = kNone,
                                     .omitDefault = true}),
        field<&T::opacity>("opacity", {.label = "Opacity",
                                       .help = "Multiplies the opacity of the whole layer.",
                                       .cost = kTables,
                                       .low = 0,
                                       .high = 1,
                                       .omitDefault = true}),
        field<&T::transfer>(
            "transfer",
            {.label = "Transfer function", .help = "Which styles and opacity the data get.", .cost = kPlan}),
        field<&T::shading>("shading", {.label = "Shading",
                                       .help = "Drawn styles, Phong's light, or flat colour.",
                                       .cost = kPlan,
                                       .choices = {"style", "phong", "flat"}}),
        field<&T::twoSided>(
            "two_sided",
            {.label = "Two-sided", .help = "The back of a surface is drawn like its front.", .cost = kPlan}),
    };
}

std::vector<Field> layerParts() {
    using T = Layer;
    return {
        field<&T::contours>("contours",
                            {.label = "Contours", .help = "Lines where the surface turns away.", .cost = kPlan}),
        field<&T::transparency>("transparency", {.label = "Transparency",
                                                 .help = "The same everywhere, or clearing flat regions first.",
                                                 .cost = kPlan,
                                                 .choices = {"uniform", "illustrative"}}),
        field<&T::tone>("tone",
                        {.label = "Tone", .help = "Warm light and cool shade over the colours.", .cost = kPlan}),
        field<&T::silhouette>("silhouette",
                              {.label = "Silhouette", .help = "Outline in a colour of its own.", .cost = kPlan}),
        field<&T::specular>(
            "specular", {.label = "Highlights", .help = "Highlights as of a wet or polished surface.", .cost = kPlan}),
        field<&T::gradientOpacity>("gradient_opacity", {.label = "Opacity by gradient",
                                                        .help = "Points (gradient 0 to 1, factor of the opacity).",
                                                        .cost = kPlan,
                                                        .low = 0,
                                                        .high = 1}),
        field<&T::lineGradientOpacity>("line_gradient_opacity", {.label = "Line opacity by gradient",
                                                                 .help = "The same for silhouette and highlights.",
                                                                 .cost = kPlan,
                                                                 .low = 0,
                                                                 .high = 1}),
        field<&T::position>("position", {.label = "Colour by position",
                                         .help = "Tints along the view or an axis: aerial perspective.",
                                         .cost = kPlan}),
        field<&T::depthOfField>(
            "depth_of_field",
            {.label = "Depth of field", .help = "The layer blurs away from the focus.", .cost = kFields}),
        field<&T::labels>("labels",
                          {.label = "Labels", .help = "Only these label numbers show.", .cost = kFields, .low = 0}),
        field<&T::phong>("phong", {.label = "Phong's light",
                                   .help = "Shares of ambient and diffuse light.",
                                   .cost = kPlan,
                                   .omitDefault = true}),
        field<&T::clip>("clip", {.label = "Clipping",
                                 .help = "What is cut away from this layer alone.",
                                 .cost = kPlan,
                                 .omitDefault = true}),
        field<&T::importanceWeight>(
            "importance_weight",
            {.label = "Importance", .help = "Weight of the layer in importance composition.", .low = 0, .high = 1e5}),
    };
}

} // namespace

template <>
std::span<const Field> fieldsOf<Layer>() {
    static const std::vector<Field> fields = [] {
        std::vector<Field> all = layerBasics();
        const std::vector<Field> parts = layerParts();
        all.insert(all.end(), parts.begin(), parts.end());
        return all;
    }();
    return fields;
}

template <>
std::span<const Field> fieldsOf<Background>() {
    using T = Background;
    static const Field fields[] = {
        field<&T::kind>(
            "kind",
            {.label = "Kind", .help = "A colour or a picture behind the figure.", .choices = {"colour", "image"}}),
        field<&T::rgba>(
            "rgba",
            {.label = "Colour", .help = "Colour and opacity of the paper.", .unit = "sRGB", .low = 0, .high = 1}),
        field<&T::file>("file",
                        {.label = "Picture", .help = "Picture inside the project, or a path.", .omitDefault = true}),
        outside<&T::picture>(kRedraw),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Output>() {
    using T = Output;
    // 100 m and 100,000 dpi: more than any press; the product is checked by `validateFigure`.
    static const Field fields[] = {
        field<&T::widthMm>("width_mm", {.label = "Width",
                                        .help = "Width of the printed figure.",
                                        .unit = "mm on paper",
                                        .low = 0,
                                        .high = 1e5,
                                        .lowExcluded = true}),
        field<&T::heightMm>("height_mm", {.label = "Height",
                                          .help = "Height of the printed figure.",
                                          .unit = "mm on paper",
                                          .low = 0,
                                          .high = 1e5,
                                          .lowExcluded = true}),
        field<&T::dpi>("dpi", {.label = "Resolution",
                               .help = "Pixels per inch of paper.",
                               .unit = "dpi",
                               .low = 0,
                               .high = 1e5,
                               .lowExcluded = true}),
        field<&T::transparent>("transparent", {.label = "Transparent", .help = "No paper behind the figure."}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Quality>() {
    using T = Quality;
    static const Field fields[] = {
        field<&T::stepVoxels>("step_voxels", {.label = "Step",
                                              .help = "Distance of samples on a ray, in smallest voxel spacings.",
                                              .unit = "voxels",
                                              .low = 0.001,
                                              .high = 64}),
        field<&T::gradient>("gradient",
                            {.label = "Gradient",
                             .help = "How surface directions are measured.",
                             .cost = kFields,
                             .choices = {"auto", "central", "sobel", "neumann", "fourth-order", "b-spline"}}),
        field<&T::interpolation>("interpolation", {.label = "Interpolation",
                                                   .help = "Between voxels.",
                                                   .cost = kPlan,
                                                   .choices = {"auto", "linear", "tricubic", "smooth"}}),
        field<&T::earlyTermination>("early_termination",
                                    {.label = "Early end",
                                     .help = "A ray ends where less than this share of light is left; 0: never.",
                                     .low = 0,
                                     .high = 0.5}),
        field<&T::samplesPerPixel>("samples_per_pixel",
                                   {.label = "Smoothing", .help = "Rays per pixel: 1, 4 or 16.", .low = 1, .high = 16}),
        field<&T::precision>("precision", {.label = "Voxels",
                                           .help = "As they are, or drawn from a copy in the 256 levels that fit the "
                                                   "scan best: half as large, at an error that is shown.",
                                           .cost = kFields,
                                           .choices = {"full", "8-bit"},
                                           .omitDefault = true}),
        field<&T::preintegration>("preintegration",
                                  {.label = "Pre-integration",
                                   .help = "Opacity from all values between two samples, not from one at their "
                                           "middle: thin peaks of a transfer function are not missed.",
                                   .omitDefault = true}),
        field<&T::tableEntries>("table_entries",
                                {.label = "Table entries",
                                 .help = "Of a transfer function; 0: as many as its narrowest feature needs.",
                                 .cost = kPlan,
                                 .low = 0,
                                 .high = 1 << 20,
                                 .omitDefault = true}),
        field<&T::tolerance>("tolerance", {.label = "Tolerance",
                                           .help = "Largest error asked for; step and other settings are chosen to "
                                                   "meet it. As a colour difference 3 is a draft, 1.5 fits screens, "
                                                   "0.7 print.",
                                           .low = 0,
                                           .high = 100,
                                           .lowExcluded = true}),
        field<&T::toleranceMetric>("tolerance_metric",
                                   {.label = "Measured as",
                                    .help = "What the tolerance bounds: the colour difference CIEDE2000 that 95 % of "
                                            "the pixels stay below, the largest difference of a pixel's channel "
                                            "(0 to 1), or the root mean square of these.",
                                    .choices = {"ciede2000", "max", "rmse"},
                                    .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Figure>() {
    using T = Figure;
    static const Field fields[] = {
        field<&T::title>("title", {.label = "Title", .help = "Title of the figure.", .cost = kNone}),
        field<&T::volume>("volume", {.label = "Scan", .help = "The scan that is drawn.", .cost = kVolume}),
        field<&T::labels>("labels", {.label = "Labels", .help = "Segmentation of the scan.", .cost = kFields}),
        field<&T::secondVolume>("second_volume",
                                {.label = "Second scan",
                                 .help = "Another scan on the same grid, for two-dimensional transfer functions.",
                                 .cost = kVolume}),
        field<&T::camera>("camera", {.label = "Camera", .help = "From where the figure is seen."}),
        field<&T::clip>("clip", {.label = "Clipping", .help = "What is cut away to see inside."}),
        field<&T::cleanup>("cleanup", {.label = "Clean-up",
                                       .help = "Steps that remove what is not wanted; the scan itself stays as it is.",
                                       .cost = kFields,
                                       .atMost = 1024,
                                       .whole = true}),
        field<&T::styles>(
            "styles", {.label = "Styles", .help = "The styles that the figure uses.", .cost = kTables, .atMost = 4096}),
        field<&T::layers>("layers", {.label = "Layers",
                                     .help = "What is drawn, one after the other at every sample.",
                                     .cost = kPlan,
                                     .atMost = 256}),
        field<&T::importance>(
            "importance",
            {.label = "Importance", .help = "What matters shows through what lies in front.", .cost = kPlan}),
        field<&T::depthCues>("depth_cues", {.label = "Depth cues",
                                            .help = "Ambient occlusion, contact shadow and halos.",
                                            .cost = kPlan,
                                            .omitDefault = true}),
        field<&T::stipple>("stipple", {.label = "Stipples", .help = "Dots of ink.", .cost = kPlan}),
        field<&T::background>("background", {.label = "Background", .help = "The paper."}),
        field<&T::annotations>("annotations",
                               {.label = "Annotations",
                                .help = "Lettering, scale bar and orientation marks.",
                                .atMost = 256}), // more no sheet holds, and laying them out would take long
        field<&T::annotationLayout>("annotation_layout",
                                    {.label = "Layout of labels",
                                     .help = "Where labels without a place stand: in columns at the sides, on a ring "
                                             "around the middle, or free beside their points.",
                                     .choices = {"columns", "ring", "free"},
                                     .omitDefault = true}),
        field<&T::output>("output", {.label = "Output", .help = "Size and resolution of the printed figure."}),
        field<&T::quality>("quality", {.label = "Quality", .help = "Accuracy against time."}),
        outside<&T::unknown>(kNone),
    };
    return fields;
}

const ValueType& figureType() { return valueType<Figure>(); }

} // namespace limner::description
