#include "core/figure/describe.h"

/// Rows of the parameter table for what is written over the picture.

namespace limner::description {

template <>
std::span<const Field> fieldsOf<Annotation>() {
    using T = Annotation;
    static const Field fields[] = {
        field<&T::kind>("kind", {.label = "Kind",
                                 .help = "What stands on the figure.",
                                 .choices = {"label", "scale-bar", "orientation", "title", "caption", "legend"}}),
        field<&T::text>("text", {.label = "Text",
                                 .help = "What it says; <b>, <i>, <sub> and <sup> mark parts of it.",
                                 .omitDefault = true}),
        field<&T::anchorMm>("anchor_mm", {.label = "Anchor",
                                          .help = "The point in the patient that the leader points to.",
                                          .unit = "mm",
                                          .low = -kFarMm,
                                          .high = kFarMm,
                                          .omitDefault = true}),
        field<&T::at>("at", {.label = "Place",
                             .help = "Place in figure coordinates; absent: found automatically.",
                             .unit = "of the figure",
                             .low = -1e3,
                             .high = 1e3,
                             .omitDefault = true}),
        field<&T::lengthMm>("length_mm", {.label = "Length",
                                          .help = "Length in the patient that the scale bar stands for.",
                                          .unit = "mm",
                                          .low = 0,
                                          .high = kFarMm,
                                          .lowExcluded = true,
                                          .omitDefault = true}),
        field<&T::sizePt>("size_pt", {.label = "Letters",
                                      .help = "Size of the letters on paper; absent: what is usual for the kind.",
                                      .unit = "pt",
                                      .low = 0,
                                      .high = 1000, // 35 cm: a banner's
                                      .lowExcluded = true,
                                      .omitDefault = true}),
        field<&T::rgb>("rgb", {.label = "Colour",
                               .help = "Colour of letters and lines; absent: black, or white on dark paper.",
                               .unit = "sRGB",
                               .low = 0,
                               .high = 1,
                               .omitDefault = true}),
        field<&T::font>("font", {.label = "Font",
                                 .help = "Family of the letters, as the system knows it; empty: DejaVu Sans.",
                                 .omitDefault = true}),
        field<&T::side>("side", {.label = "Side",
                                 .help = "The column that a label stands in while it is laid out automatically.",
                                 .choices = {"auto", "left", "right"},
                                 .omitDefault = true}),
    };
    return fields;
}

} // namespace limner::description
