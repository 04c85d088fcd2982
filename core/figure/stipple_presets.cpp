#include "core/figure/stipple_presets.h"

namespace limner {
namespace {

/// Ink alone, on what the layers show: as illustrators draw.
Stipple inkAlone() {
    Stipple result;
    result.layerOpacity = "alone";
    result.matter = "layers";
    return result;
}

/// The engine block of the stippling paper, figure 1b.
Stipple boundariesAndSilhouettes() {
    Stipple result = inkAlone();
    result.boundary = StippleBoundary{0.39, 0.51, 1};
    result.silhouette = StippleSilhouette{0.279, 0.45, 1.11};
    result.curves = StippleCurves{};
    return result;
}

/// Half as many dots as the paper gives every surface: there is nothing that thins them out.
Stipple plainStipple() {
    Stipple result = inkAlone();
    result.boundary = StippleBoundary{0.15, 0.5, 1};
    return result;
}

Stipple nearParts() {
    Stipple result = inkAlone();
    result.boundary = StippleBoundary{0.39, 0.51, 1};
    result.silhouette = StippleSilhouette{0.5, 0.5, 1};
    result.distance = StippleDistance{1.5};
    return result;
}

/// Light from the upper left, as drawings have it by convention.
Stipple litFromUpperLeft() {
    Stipple result = inkAlone();
    result.boundary = StippleBoundary{0.6, 0.4, 1};
    result.lighting = StippleLighting{1.2, Light{"head", {-0.4, 0.6, 0.7}}};
    result.curves = StippleCurves{.widthMm = 0.15};
    return result;
}

Stipple penAndInk() {
    Stipple result = litFromUpperLeft();
    result.kMax = 0;
    result.curves->widthMm = 0.25;
    result.curves->widthBy = "curvature";
    result.hatching = StippleHatching{};
    return result;
}

Stipple seeThrough() {
    Stipple result = inkAlone();
    result.hidden = "show";
    result.boundary = StippleBoundary{0.39, 0.51, 1};
    result.silhouette = StippleSilhouette{0.08, 0.9, 2};
    result.interior = StippleInterior{1};
    return result;
}

Stipple outlinesOnly() {
    Stipple result = inkAlone();
    result.kMax = 0;
    result.curves = StippleCurves{.widthMm = 0.3};
    result.innerLines = StippleInnerLines{};
    return result;
}

} // namespace

const std::vector<PartPreset<Stipple>>& stipplePresets() {
    static const std::vector<PartPreset<Stipple>> presets{
        {"boundaries-and-silhouettes", "Boundaries and silhouettes",
         "Dots gather on boundaries and where surfaces turn away, with lines along the silhouettes.",
         boundariesAndSilhouettes()},
        {"plain-stipple", "Plain stipple", "Dots on every surface alike, the more the sharper it is.", plainStipple()},
        {"near-parts-darker", "Near parts darker", "Near parts are dark and far ones fade into the paper.",
         nearParts()},
        {"lit-from-upper-left", "Lit from the upper left", "Dots lie in the shade; what faces the light stays paper.",
         litFromUpperLeft()},
        {"pen-and-ink", "Pen and ink (hatching)", "Strokes follow the form and cross in the shade; no dots.",
         penAndInk()},
        {"see-through", "See-through", "Outer surfaces clear in the middle, so that inner ones show.", seeThrough()},
        {"outlines-only", "Outlines only", "Lines along silhouettes, ridges and valleys; no dots.", outlinesOnly()},
    };
    return presets;
}

Stipple stippleInLook(const std::optional<Stipple>& now, const Stipple& look) {
    if (!now)
        return look;
    Stipple result = look;
    result.inkRgb = now->inkRgb;
    result.fromStyle = now->fromStyle;
    result.threshold = now->threshold;
    result.spreadVoxels = now->spreadVoxels;
    result.sizeMm = now->sizeMm;
    result.layerOpacity = now->layerOpacity;
    result.matter = now->matter;
    result.placing = now->placing;
    result.tone = now->tone;
    result.gradient = now->gradient;
    result.seed = now->seed;
    return result;
}

} // namespace limner
