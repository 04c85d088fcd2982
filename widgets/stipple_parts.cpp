#include "widgets/stipple_parts.h"

namespace limner {
namespace {

using Useful = ParameterRow::Useful;

constexpr Useful kShare{0, 1, 3};
constexpr Useful kExponent{0, 5, 2, 2}; // what changes a drawing lies below 1; the box goes on
constexpr Useful kPen{0, 2, 2, 2};

/// How a form reaches a part of the stipples.
template <auto Member,
          class Part = typename std::remove_reference_t<decltype(std::declval<Stipple>().*Member)>::value_type>
typename PartFormOf<Part>::Access stipplePart() {
    return {[](const Figure& figure, std::size_t) {
                return figure.stipple ? (*figure.stipple).*Member : std::optional<Part>();
            },
            [](Figure& figure, std::size_t, std::optional<Part> part) {
                if (figure.stipple)
                    (*figure.stipple).*Member = std::move(part);
            },
            [](const Figure&) { return Part{}; }};
}

PartForm* boundaryForm() {
    using T = StippleBoundary;
    auto* form = new PartFormOf<T>("/stipple/boundary", stipplePart<&Stipple::boundary>());
    form->addNumber("/stipple/boundary/kgc", kShare, [](T& t) -> double& { return t.kgc; });
    form->addNumber("/stipple/boundary/kgs", kShare, [](T& t) -> double& { return t.kgs; });
    form->addNumber("/stipple/boundary/kge", kExponent, [](T& t) -> double& { return t.kge; });
    return form;
}

PartForm* silhouetteForm() {
    using T = StippleSilhouette;
    auto* form = new PartFormOf<T>("/stipple/silhouette", stipplePart<&Stipple::silhouette>());
    form->addNumber("/stipple/silhouette/ksc", kShare, [](T& t) -> double& { return t.ksc; });
    form->addNumber("/stipple/silhouette/kss", kShare, [](T& t) -> double& { return t.kss; });
    form->addNumber("/stipple/silhouette/kse", kExponent, [](T& t) -> double& { return t.kse; });
    return form;
}

PartForm* lightingForm() {
    using T = StippleLighting;
    auto* form = new PartFormOf<T>("/stipple/lighting", stipplePart<&Stipple::lighting>());
    form->addNumber("/stipple/lighting/kle", kExponent, [](T& t) -> double& { return t.kle; });
    form->addLight("/stipple/lighting/light", [](T& t) -> Light& { return t.light; });
    return form;
}

PartForm* distanceForm() {
    using T = StippleDistance;
    auto* form = new PartFormOf<T>("/stipple/distance", stipplePart<&Stipple::distance>());
    form->addNumber("/stipple/distance/kde", {-5, 5, 2}, [](T& t) -> double& { return t.kde; });
    return form;
}

PartForm* interiorForm() {
    using T = StippleInterior;
    auto* form = new PartFormOf<T>("/stipple/interior", stipplePart<&Stipple::interior>());
    form->addNumber("/stipple/interior/kte", kExponent, [](T& t) -> double& { return t.kte; });
    return form;
}

PartForm* resolutionForm() {
    using T = StippleResolution;
    auto* form = new PartFormOf<T>("/stipple/resolution", stipplePart<&Stipple::resolution>());
    form->addNumber("/stipple/resolution/kre", kExponent, [](T& t) -> double& { return t.kre; });
    return form;
}

PartForm* curvesForm() {
    using T = StippleCurves;
    auto* form = new PartFormOf<T>("/stipple/curves", stipplePart<&Stipple::curves>());
    form->addNumber("/stipple/curves/width_mm", kPen, [](T& t) -> double& { return t.widthMm; });
    form->addChoice("/stipple/curves/width_by",
                    {{"even", PartForm::tr("Nothing: even lines")},
                     {"curvature", PartForm::tr("Curvature: thin where flat")},
                     {"depth", PartForm::tr("Depth: thin where far")}},
                    [](T& t) -> std::string& { return t.widthBy; });
    form->addChoice(
        "/stipple/curves/hidden_lines",
        {{"none", PartForm::tr("Left out")}, {"dashed", PartForm::tr("Dashed")}, {"thin", PartForm::tr("Thin")}},
        [](T& t) -> std::string& { return t.hiddenLines; });
    form->addNumber("/stipple/curves/eye", {0, 1, 2}, [](T& t) -> double& { return t.eye; });
    form->addNumber("/stipple/curves/gradient", {0, 1, 2}, [](T& t) -> double& { return t.gradient; });
    form->addNumber("/stipple/curves/log", {-1, 1, 3}, [](T& t) -> double& { return t.log; });
    return form;
}

PartForm* innerLinesForm() {
    using T = StippleInnerLines;
    auto* form = new PartFormOf<T>("/stipple/inner_lines", stipplePart<&Stipple::innerLines>());
    form->addNumber("/stipple/inner_lines/width_mm", kPen, [](T& t) -> double& { return t.widthMm; });
    form->addNumber("/stipple/inner_lines/ridges", {0, 1, 2}, [](T& t) -> double& { return t.ridges; });
    form->addNumber("/stipple/inner_lines/valleys", {0, 1, 2}, [](T& t) -> double& { return t.valleys; });
    return form;
}

PartForm* hatchingForm() {
    using T = StippleHatching;
    auto* form = new PartFormOf<T>("/stipple/hatching", stipplePart<&Stipple::hatching>());
    form->addNumber("/stipple/hatching/length_mm", {0, 20, 2, 2}, [](T& t) -> double& { return t.lengthMm; });
    form->addNumber("/stipple/hatching/width_mm", kPen, [](T& t) -> double& { return t.widthMm; });
    form->addNumber("/stipple/hatching/cross", {0, 1, 2}, [](T& t) -> double& { return t.cross; });
    return form;
}

} // namespace

std::vector<PartForm*> stippleFactorForms() {
    return {boundaryForm(), silhouetteForm(), lightingForm(), distanceForm(), interiorForm(), resolutionForm()};
}

std::vector<PartForm*> stippleLineForms() { return {curvesForm(), innerLinesForm(), hatchingForm()}; }

} // namespace limner
