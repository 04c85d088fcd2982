#pragma once

#include "core/style/extraction/artwork.h"
#include "core/style/extraction/forms.h"
#include "core/style/extraction/sphere_edits.h"
#include "core/style/texture_tile.h"

#include <memory>
#include <optional>
#include <variant>

namespace limner {

/// What to take a style from, and how. Places are on the artwork.
struct ExtractionRequest {
    std::variant<Ellipse, FormRegion> form;
    Mask ignored;              ///< over the whole artwork, any resolution: not to be looked at; may be empty
    bool skipLettering = true; ///< also leave out letters and leader lines that `findLettering` finds
    bool removePaperCast = false;
    bool separateTexture = false; ///< make a tile of what the lighting does not explain
    int size = 512;               ///< of the sphere's picture, 16..2048
    SphereEdits edits;            ///< done to the sphere after the figures are taken
};

/// How good it is. Nothing is hidden by the filling: residuals are over places that had votes.
struct ExtractionFigures {
    double coverage = 0; ///< share of the disk that had votes
    /// RMSE of the region shaded again with its normals by a sphere taken from the other half of the region, so that
    /// noise, wrong normals and texture all count.
    double residualRmse = 0;
    double largestHoleDegrees = 0; ///< widest gap between directions that had votes
    /// What cannot be seen in the residual: RMSE between this sphere and the one that a likely mistake would have
    /// given. Of an ellipse: its outline against the one snapped to the picture's edge; absent where there is no edge.
    /// Of a region: its depth, which no picture tells, against a form deeper by a quarter.
    std::optional<double> formRmse;
};

struct Extraction {
    SpherePtr sphere;
    std::shared_ptr<const TextureTile> texture; ///< null where not asked for, or the form is too small
    ExtractionFigures figures;
    ArtCut cut;            ///< what was looked at
    ArtPicture reshaded;   ///< over the cut: the region shaded again; alpha 0 outside
    ArtPicture difference; ///< over the cut: 1/2 + (artwork - reshaded) / 2; alpha 0 outside
    Mask covered;          ///< over the sphere's picture
    SpherePtr unedited;    ///< before `edits`: let a dialog change those without extracting again
};

/// Takes a style from an artwork (spec style-extraction.md; after Sloan, Martin, Gooch, Gooch 2001). Below a second on
/// two cores once the artwork is loaded. Throws Error(badInput) with a plain word where there is nothing to take: a
/// region of a few pixels, none of it opaque, outside the scan, no tone in it (blank paper, line art);
/// Error(usage) for a size out of range; Error(cancelled).
Extraction extractStyle(const Artwork& artwork, const ExtractionRequest& request, Task& task);

/// A matcap picture as a style: the disk is found (by its alpha, its edge, else it fills the square), the ground behind
/// it removed. Throws Error(badInput).
SpherePtr importMatcap(const std::filesystem::path& file, Task& task);

} // namespace limner
