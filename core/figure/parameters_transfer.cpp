#include "core/figure/describe.h"

/// Declarations of the transfer functions of layers. The rest is in parameters.cpp.

namespace limner::description {
namespace {

/// Whether a field that belongs to some kinds only is written: for those kinds, or so that nothing set is lost.
template <bool (*Written)(const Transfer&)>
bool asked(const void* object) {
    return Written(*static_cast<const Transfer*>(object));
}

bool isTwoDimensional(const Transfer& t) { return t.kind == TransferKind::twoDimensional; }
bool writesGrid(const Transfer& t) { return t.grid && (isTwoDimensional(t) || t.nodes.empty()); }
bool writesNodes(const Transfer& t) { return !writesGrid(t) && (!isTwoDimensional(t) || !t.nodes.empty()); }
bool writesAxis(const Transfer& t) { return !isTwoDimensional(t) || t.axis != Transfer{}.axis; }
bool writesAxes(const Transfer& t) { return isTwoDimensional(t) || !t.axes.empty(); }
bool writesOpacity(const Transfer& t) { return !isTwoDimensional(t) || !t.opacity.empty(); }
bool writesOpacity2d(const Transfer& t) { return isTwoDimensional(t) || !t.opacity2d.empty(); }

} // namespace

template <>
std::span<const Field> fieldsOf<TransferNode>() {
    using T = TransferNode;
    static const Field fields[] = {
        field<&T::at>("at", {.label = "Value", .help = "Data value of the node.", .cost = kTables, .unit = kDataUnit}),
        field<&T::style>(
            "style",
            {.label = "Style", .help = "Id of a style in the figure's list.", .cost = kTables, .omitDefault = true}),
        field<&T::rgb>("rgb", {.label = "Colour",
                               .help = "Plain colour instead of a style.",
                               .cost = kTables,
                               .unit = "sRGB",
                               .low = 0,
                               .high = 1,
                               .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<TransferGrid>() {
    using T = TransferGrid;
    static const Field fields[] = {
        field<&T::x>("x", {.label = "First axis",
                           .help = "Rising positions of the grid's columns.",
                           .cost = kTables,
                           .atMost = 1024}),
        field<&T::y>(
            "y",
            {.label = "Second axis", .help = "Rising positions of the grid's rows.", .cost = kTables, .atMost = 1024}),
        field<&T::styles>("styles", {.label = "Styles",
                                     .help = "Style ids, a row per position of the second axis.",
                                     .cost = kTables,
                                     .atMost = 1024}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<OpacityShape>() {
    using T = OpacityShape;
    static const Field fields[] = {
        field<&T::shape>("shape", {.label = "Shape",
                                   .help = "Shape in the plane of the two axes.",
                                   .cost = kTables,
                                   .choices = {"rectangle", "trapezoid", "ellipse", "polygon", "mask"}}),
        field<&T::x>("x", {.label = "Along the first axis",
                           .help = "Positions of the shape's corners on the first axis.",
                           .cost = kTables}),
        field<&T::y>("y", {.label = "Along the second axis",
                           .help = "Positions of the shape's corners on the second axis.",
                           .cost = kTables}),
        field<&T::opacity>(
            "opacity", {.label = "Opacity", .help = "Opacity inside the shape.", .cost = kTables, .low = 0, .high = 1}),
        field<&T::soft>("soft", {.label = "Softness",
                                 .help = "Width of the soft border as a share of the shape.",
                                 .cost = kTables,
                                 .low = 0,
                                 .high = 1,
                                 .omitDefault = true}),
        field<&T::columns>("columns", {.label = "Columns",
                                       .help = "Numbers in a row of a mask.",
                                       .cost = kTables,
                                       .low = 0,
                                       .high = 1024,
                                       .omitDefault = true}),
        field<&T::values>("values", {.label = "Mask",
                                     .help = "The painted mask, row by row from the low end of the second axis.",
                                     .cost = kTables,
                                     .low = 0,
                                     .high = 1,
                                     .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<DistanceOrigin>() {
    using T = DistanceOrigin;
    static const Field fields[] = {
        field<&T::fromMm>("from_mm", {.label = "From",
                                      .help = "The point that distances are measured from.",
                                      .unit = "mm",
                                      .low = -kFarMm,
                                      .high = kFarMm,
                                      .omitDefault = true}),
        field<&T::label>("label", {.label = "Label",
                                   .help = "Without a point: the label that distances are measured from.",
                                   .cost = kFields,
                                   .low = 0,
                                   .omitDefault = true}),
    };
    return fields;
}

template <>
std::span<const Field> fieldsOf<Transfer>() {
    using T = Transfer;
    static const Field fields[] = {
        field<&T::kind>("kind", {.label = "Kind",
                                 .help = "Styles by one measure of the data, or by two.",
                                 .cost = kPlan,
                                 .choices = {"1d", "2d"}}),
        field<&T::axis>("axis",
                        {.label = "Axis",
                         .help = "The measure that picks style and opacity.",
                         .cost = kPlan,
                         .choices = {"value", "gradient", "label", "distance", "importance", "curvature", "second"},
                         .written = asked<writesAxis>}),
        field<&T::axes>("axes",
                        {.label = "Axes",
                         .help = "The two measures that pick style and opacity.",
                         .cost = kPlan,
                         .choices = {"value", "gradient", "label", "distance", "importance", "curvature", "second"},
                         .atMost = 2,
                         .written = asked<writesAxes>}),
        field<&T::nodes>("nodes",
                         {.label = "Nodes",
                          .help = "Styles or colours along the axis, by rising value (1d), or a grid of styles (2d).",
                          .cost = kTables,
                          .atMost = 4096,
                          .written = asked<writesNodes>,
                          .sharesName = true}),
        field<&T::grid>("nodes", {.label = "Node grid",
                                  .help = "Styles over a grid of nodes (2d).",
                                  .cost = kTables,
                                  .written = asked<writesGrid>,
                                  .sharesName = true}),
        field<&T::opacity>("opacity", {.label = "Opacity curve",
                                       .help = "Points (value, opacity) by rising value; two at one value are a step.",
                                       .cost = kTables,
                                       .unit = kDataUnit,
                                       .written = asked<writesOpacity>}),
        field<&T::curve>("opacity_curve", {.label = "Course of the curve",
                                           .help = "How opacity goes from point to point of the curve.",
                                           .cost = kTables,
                                           .choices = {"linear", "smooth", "step"},
                                           .omitDefault = true}),
        field<&T::opacity2d>("opacity_2d", {.label = "Opacity shapes",
                                            .help = "Shapes in the plane of the two axes (2d).",
                                            .cost = kTables,
                                            .atMost = 1024,
                                            .written = asked<writesOpacity2d>}),
        field<&T::distance>("distance", {.label = "Distance from",
                                         .help = "Where the axis \"distance\" starts.",
                                         .cost = kPlan,
                                         .omitDefault = true}),
    };
    return fields;
}

} // namespace limner::description
