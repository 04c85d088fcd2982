#pragma once

#include "widgets/extraction_draft.h"

#include <glm/vec2.hpp>

#include <optional>

namespace limner {

/// Geometry of a draft's forms as functions from value to value: what the tools of the artwork canvas are made of.
/// Places are on the artwork unless a name says otherwise.

/// What an ellipse can be held by: its middle, the four ends of its axes, and a knob beyond the end of the first.
enum class EllipseHandle { centre, first, firstOpposite, second, secondOpposite, turn };

/// Unit vectors of the axes, y down.
glm::dvec2 firstAxis(const Ellipse& ellipse);
glm::dvec2 secondAxis(const Ellipse& ellipse);
/// Where the handle is; the knob stands `knob` artwork pixels beyond the first axis.
glm::dvec2 handlePlace(const Ellipse& ellipse, EllipseHandle handle, double knob);
/// The handle is pulled to `place`. `round`: both axes grow alike.
Ellipse withHandleAt(const Ellipse& ellipse, EllipseHandle handle, glm::dvec2 place, bool round);
bool contains(const Ellipse& ellipse, glm::dvec2 place);

/// How a drag draws a new ellipse.
struct EllipseDrag {
    bool circle = true;     ///< else the ellipse that the drag's box holds
    bool fromCentre = true; ///< else from edge to edge
};
Ellipse drawnEllipse(glm::dvec2 from, glm::dvec2 to, const EllipseDrag& how);

/// An empty mask over the plate's reduced copy.
Mask blankMask(const ArtworkPlate& plate);
bool marksAnything(const Mask& mask);

/// A round brush drawn from place to place over a mask, all in the mask's pixels; its edge is soft over one.
struct BrushStroke {
    glm::dvec2 from{0, 0};
    glm::dvec2 to{0, 0};
    double radius = 1;
    bool erases = false;
};
MaskPtr withStroke(const Mask& mask, const BrushStroke& stroke);
/// What the path (in the mask's pixels) encloses is added or taken away.
MaskPtr withEnclosed(const Mask& mask, const ArtPath& path, bool takeAway);
/// What is marked over a cut (in its own pixels) joins a mask over the plate.
MaskPtr withCutMarked(const ArtworkPlate& plate, const Mask& mask, const ArtCut& cut, const Mask& overCut);

/// Length of a path, and the place and direction (a unit vector) at half of it.
struct PathMiddle {
    glm::dvec2 place{0, 0};
    glm::dvec2 direction{1, 0};
};
PathMiddle middleOf(const ArtPath& path);
/// Distance from a place to the nearest part of a path; of an empty one, infinite.
double distanceTo(const ArtPath& path, glm::dvec2 place);

/// The mean colour within `radius` artwork pixels; absent where that is clear or beside the artwork.
std::optional<Rgba> colourAt(const ArtworkPlate& plate, glm::dvec2 place, double radius);

} // namespace limner
