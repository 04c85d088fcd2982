#pragma once

#include "core/figure/figure.h"
#include "support/dice.h"

#include <string>

namespace limner::testing {

/// What extreme figures (extreme_figures.h) do to everything but the data and the view.

/// One to three layers, each with one or two of the features of transfer_scenes.h, and what these want of the figure.
Figure extremeLayers(Dice& dice, std::string& story);

/// Opacities of 0, 1e-8 and 1, steps of no width, smooth and stepped curves.
void pushTransfers(Dice& dice, Figure& figure, std::string& story);

/// Opacities no greater than that. A peak of opacity 1 that is narrower than an entry of the table is as wide as the
/// entry, which is much of the depth along a ray where steps are far shorter than a voxel.
void keepPeaksBelow(Figure& figure, double opacity);

/// Weights up to a million, lenses, cues, contours, estimators, ends of rays.
void pushParts(Dice& dice, Figure& figure, std::string& story);

/// The figure over data whose values are `factor` value + `offset`.
void moveValues(Figure& figure, double factor, double offset);

/// Everything that a transfer function places along an axis, moved.
void shiftAlong(Transfer& transfer, const std::string& axis, double by);

/// The figure with all lengths in the patient multiplied; what is measured on paper stays.
void scaleLengths(Figure& figure, double factor);

} // namespace limner::testing
