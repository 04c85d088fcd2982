#pragma once

#include "core/figure/figure.h"

namespace limner {

/// A look is a figure without its subject: styles, layers, importance, depth cues, ink, paper. It is kept as a figure
/// file of its own, which can be given to others, and laid over figures of other scans.

/// Without scan, labels, camera, clips, clean-up, annotations and output. Lenses that hang on a point of the scan and
/// clips of layers are left out, for they belong to that scan. What the scan's values were is noted in the figure
/// ("look" in its file), so that `withLook` can carry the look over to values of another kind. Reads the volume once.
Figure lookOf(const Figure& figure);

/// The look laid over a figure, whose subject stays. Positions on the axis of values stay where both scans are in the
/// same named unit (HU); else they go along with the values between the first and the last hundredth of the voxels.
/// `notes` gets a line where that was done, or where nothing is known of the look's scan. Reads the volume once.
Figure withLook(const Figure& figure, const Figure& look, std::vector<std::string>& notes);

} // namespace limner
