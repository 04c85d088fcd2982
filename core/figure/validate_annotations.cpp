#include "core/figure/validate_annotations.h"

#include "core/figure/annotation_layout.h"

namespace limner {

void checkAnnotations(const Figure& figure, std::vector<Problem>& problems) {
    for (std::size_t i = 0; i < figure.annotations.size(); ++i) {
        const Annotation& annotation = figure.annotations[i];
        const std::string pointer = "/annotations/" + std::to_string(i);
        const auto note = [&](const char* member, const char* why, const char* mend) {
            problems.push_back({pointer + member, why, mend, false});
        };
        const bool says = !annotation.text.empty() || (annotation.kind == "title" && !figure.title.empty());
        const bool mustSay = annotation.kind == "label" || annotation.kind == "title" || annotation.kind == "caption";
        if (mustSay && !says) {
            note("/text", "it says nothing, so it is not drawn", "write a text");
        }
        if (annotation.kind == "label" && !annotation.anchorMm && !annotation.at) {
            note("/anchor_mm", "the label has neither a point nor a place, so it is not drawn",
                 "give it a point of the patient, or a place \"at\" in the figure");
        }
        const double shownMm = figure.camera.heightMm * figure.output.aspect();
        if (annotation.kind == "scale-bar" && annotation.lengthMm.value_or(0) > shownMm) {
            note("/length_mm", "the bar is longer than the sheet is wide", "make it shorter, or leave it out");
        }
    }
}

} // namespace limner
