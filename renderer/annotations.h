#pragma once

#include "core/figure/annotation_layout.h"
#include "renderer/backend.h"
#include "renderer/marks/marks.h"
#include "renderer/text/text_block.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limner {

/// What is written over the finished picture: one drawing in mm on paper, which pictures of any size, vector files and
/// the screen show alike.

struct PaperText {
    TextBlock block;
    glm::dvec2 atMm{0}; ///< of the block's top left corner
    InkColour rgb{0};
};

/// A filled rectangle: scale bars.
struct PaperBar {
    SheetBox box;
    InkColour rgb{0};
};

/// A style's ball, or a plain colour's disc.
struct PaperBall {
    glm::dvec2 centreMm{0};
    double radiusMm = 0;
    std::shared_ptr<const LitSphere> sphere; ///< null: `rgb`
    InkColour rgb{0};
};

/// Where one of the figure's annotations came to stand; for handles and lists.
struct AnnotationPlace {
    std::size_t index = 0; ///< in Figure::annotations
    bool drawn = false;
    SheetBox box;                       ///< mm on paper
    std::optional<glm::dvec2> anchorMm; ///< of a label's point, where it is drawn
    std::optional<glm::dvec2> portMm;   ///< of a label's end of the leader
    glm::dvec2 at{0};                   ///< what `Annotation::at` would be to keep it there
    std::string note;                   ///< why it is not drawn, or what is to be known of it; may be empty
};

struct DrawnAnnotations {
    glm::dvec2 paperMm{0};
    Marks lines; ///< leaders and marks, under the text
    std::vector<PaperBar> bars;
    std::vector<PaperBall> balls;
    std::vector<PaperText> texts;
    std::vector<AnnotationPlace> places; ///< one for each annotation

    [[nodiscard]] bool empty() const;
    [[nodiscard]] std::size_t count() const; ///< of those drawn
};

/// The paper that annotations stand on.
struct AnnotationPaper {
    std::optional<glm::dvec3> rgb; ///< sRGB; absent: not known, the picture is transparent
};

/// Throws Error(noResources) where there is text and the system has no font. Thread-safe.
DrawnAnnotations drawAnnotations(const Figure& figure, const AnnotationPaper& paper);

/// Lays them over a tile of a picture of `size` pixels. Any tiling gives the same bits.
void layAnnotations(const DrawnAnnotations& annotations, glm::ivec2 size, const Tile& tile, Picture& picture);

/// One line for each annotation: what it is, what it says, and its note.
std::vector<std::string> describeAnnotations(const Figure& figure, const DrawnAnnotations& annotations);

} // namespace limner
