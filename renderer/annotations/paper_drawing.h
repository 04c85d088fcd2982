#pragma once

#include "renderer/annotations.h"

namespace limner {

/// What the parts of `drawAnnotations` share.

constexpr double kMarginMm = 4;   ///< free along the sheet's edges
constexpr double kLineMm = 0.18;  ///< half a point: what plates are drawn with
constexpr double kCasingMm = 0.2; ///< paper on either side of a leader, so that it shows on dark matter

/// An annotation that is measured and not yet placed: its parts lie as if its box began at (0, 0).
struct PaperBlock {
    glm::dvec2 sizeMm{0};
    glm::dvec2 handleMm{0}; ///< of the point that `Annotation::at` names
    std::vector<PaperText> texts;
    std::vector<PaperBar> bars;
    std::vector<PaperBall> balls;
    MarkGroup lines;
    std::string note;
};

struct BlockContext {
    const Figure& figure;
    const Annotation& annotation;
    InkColour ink{0};
    glm::dvec2 paperMm{0};
    [[nodiscard]] TextStyle style() const;
};

PaperBlock titleBlock(const BlockContext& context);
PaperBlock captionBlock(const BlockContext& context);
PaperBlock scaleBarBlock(const BlockContext& context);
PaperBlock orientationBlock(const BlockContext& context);
PaperBlock legendBlock(const BlockContext& context);

void addLine(MarkGroup& group, const glm::dvec2& from, const glm::dvec2& to, double widthMm, const InkColour& rgb,
             float opacity = 1);

/// The ink of an annotation: its own, or what shows on the paper.
InkColour inkOf(const Annotation& annotation, const AnnotationPaper& paper);
InkColour inkColour(const glm::dvec3& rgb);

} // namespace limner
