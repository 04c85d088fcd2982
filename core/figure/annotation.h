#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>

namespace limner {

/// Something written over the finished picture. Text is in points and lines in millimetres on paper, so that every size
/// of the picture shows the same drawing; text may hold the markup of rich_text.h.
struct Annotation {
    std::string kind = "label"; ///< label, scale-bar, orientation, title, caption, legend
    std::string text; ///< of a title: empty takes the figure's; of a scale bar: its length; of a legend: a heading
    std::optional<glm::dvec3> anchorMm; ///< label: the point in the patient; without one it is plain text
    /// Figure coordinates: a label's end of the leader, a scale bar's left end, the middle of all else. Absent: laid
    /// out automatically.
    std::optional<glm::dvec2> at;
    std::optional<double> lengthMm; ///< scale bar, in the patient; absent: a round length near a fifth of the width
    std::optional<double> sizePt;   ///< of the letters on paper; absent: what is usual for the kind
    std::optional<glm::dvec3> rgb;  ///< absent: black, or white on dark paper
    std::string font;               ///< family; empty: DejaVu Sans
    std::string side = "auto";      ///< auto, left, right: the column of a label that is laid out automatically
    friend bool operator==(const Annotation&, const Annotation&) = default;
};

/// Size of an annotation's letters in points.
double sizePtOf(const Annotation& annotation);

/// The length of a scale bar that shows `millimetresPerSheet` of the patient across the sheet, where none is given: 1,
/// 2 or 5 times a power of ten, near a fifth of it.
double roundBarMm(double millimetresPerSheet);

/// "50 mm", "2.5 mm", "200 µm".
std::string lengthText(double lengthMm);

} // namespace limner
