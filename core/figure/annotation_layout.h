#pragma once

#include "core/figure/figure.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace limner {

/// Where labels stand, in mm on paper from the sheet's top left corner, y down. Knows boxes, no fonts.

struct SheetBox {
    glm::dvec2 lowMm{0};
    glm::dvec2 highMm{0};
    [[nodiscard]] glm::dvec2 sizeMm() const { return highMm - lowMm; }
    [[nodiscard]] bool overlaps(const SheetBox& other) const {
        return lowMm.x < other.highMm.x && other.lowMm.x < highMm.x && lowMm.y < other.highMm.y &&
               other.lowMm.y < highMm.y;
    }
    friend bool operator==(const SheetBox&, const SheetBox&) = default;
};

enum class LabelSide { automatic, left, right };

/// A label's measured box and what it belongs to.
struct LabelBox {
    glm::dvec2 sizeMm{0};
    double portDownMm = 0;               ///< from the box's top to the height of the first line's middle: the leader's
    glm::dvec2 anchorMm{0};              ///< of the point on the sheet
    std::optional<glm::dvec2> atMm = {}; ///< where the user put the leader's end
    LabelSide side = LabelSide::automatic;
};

struct PlacedLabel {
    SheetBox box;
    glm::dvec2 portMm{0}; ///< where the leader leaves the box
    friend bool operator==(const PlacedLabel&, const PlacedLabel&) = default;
};

enum class LabelLayout { columns, ring, free };

struct LabelSheet {
    glm::dvec2 sizeMm{0};
    double marginMm = 4; ///< kept free along the edges
    double gapMm = 1;    ///< at least, between boxes
    LabelLayout layout = LabelLayout::columns;
    std::vector<SheetBox> taken = {}; ///< by titles, scale bars and the like
};

/// Places for all labels, in their order. Those with a place keep it. The others get places without overlaps among the
/// boxes and without crossings among the straight leaders, inside the sheet as long as there is room for that; a ring
/// that has none becomes columns. Depends on nothing but its arguments.
std::vector<PlacedLabel> layOutLabels(const LabelSheet& sheet, std::span<const LabelBox> labels);

/// Whether two leaders meet anywhere but in a common end.
bool leadersCross(const glm::dvec2& portA, const glm::dvec2& anchorA, const glm::dvec2& portB,
                  const glm::dvec2& anchorB);

/// A point of the patient on the sheet, in mm from its top left corner; nothing behind the eye or beside the sheet.
/// Throws Error(badInput) for a camera that spans no view.
std::optional<glm::dvec2> onSheet(const Camera& camera, const Output& output, const glm::dvec3& pointMm);

/// Millimetres on paper for one in the patient, in the plane through the camera's target.
double paperPerPatient(const Camera& camera, const Output& output);

} // namespace limner
