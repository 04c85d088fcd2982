#include "core/figure/annotation_edits.h"

#include <glm/common.hpp>

namespace limner {

Annotation newAnnotation(const std::string& kind) {
    Annotation annotation;
    annotation.kind = kind;
    return annotation;
}

void placeAnnotation(Figure& figure, std::size_t index, const glm::dvec2& at) {
    figure.annotations[index].at = glm::clamp(at, glm::dvec2(0), glm::dvec2(1));
}

} // namespace limner
