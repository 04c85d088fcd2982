#include "renderer/annotations/paper_drawing.h"

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr double kPadMm = 0.8; ///< between a label's letters and the end of its leader

/// Blocks along the sheet's edges, then labels in what they leave.
class Drawing {
  public:
    Drawing(const Figure& figure, const AnnotationPaper& paper) : figure_(figure), paper_(paper) {
        out_.paperMm = {figure.output.widthMm, figure.output.heightMm};
        out_.lines.paperMm = out_.paperMm;
        out_.lines.order = MarkOrder::overLayers;
        out_.lines.groups = {{"Casing", {}, {}, {}}, {"Leaders", {}, {}, {}}, {"Points", {}, {}, {}}};
        out_.places.resize(figure.annotations.size());
        sheet_.sizeMm = out_.paperMm;
        sheet_.marginMm = kMarginMm;
        sheet_.layout = figure.annotationLayout == "ring"   ? LabelLayout::ring
                        : figure.annotationLayout == "free" ? LabelLayout::free
                                                            : LabelLayout::columns;
    }

    DrawnAnnotations draw() {
        for (std::size_t i = 0; i < figure_.annotations.size(); ++i) {
            out_.places[i].index = i;
        }
        each("title", [&](std::size_t i) { placeTitle(i, titleBlock(context(i))); });
        each("caption", [&](std::size_t i) { placeAtFoot(i, captionBlock(context(i)), foot_); });
        leftFoot_ = rightFoot_ = foot_;
        each("scale-bar", [&](std::size_t i) { placeAtFoot(i, scaleBarBlock(context(i)), leftFoot_); });
        each("orientation", [&](std::size_t i) { placeAtRight(i, orientationBlock(context(i)), false); });
        each("legend", [&](std::size_t i) { placeAtRight(i, legendBlock(context(i)), true); });
        drawLabels();
        return std::move(out_);
    }

  private:
    template <class Do>
    void each(const char* kind, Do act) {
        for (std::size_t i = 0; i < figure_.annotations.size(); ++i) {
            if (figure_.annotations[i].kind == kind) {
                act(i);
            }
        }
    }

    [[nodiscard]] BlockContext context(std::size_t i) const {
        const Annotation& annotation = figure_.annotations[i];
        return {figure_, annotation, inkOf(annotation, paper_), out_.paperMm};
    }

    void placeTitle(std::size_t i, PaperBlock block) {
        const glm::dvec2 corner((out_.paperMm.x - block.sizeMm.x) / 2, head_);
        const double below = head_ + block.sizeMm.y + kBetween;
        if (put(i, std::move(block), corner)) {
            head_ = below;
        }
    }
    void placeAtFoot(std::size_t i, PaperBlock block, double& foot) {
        const double top = out_.paperMm.y - foot - block.sizeMm.y;
        const double next = foot + block.sizeMm.y + kBetween;
        if (put(i, std::move(block), {kMarginMm, top})) {
            foot = next;
        }
    }
    void placeAtRight(std::size_t i, PaperBlock block, bool above) {
        const double height = block.sizeMm.y;
        const glm::dvec2 corner(out_.paperMm.x - kMarginMm - block.sizeMm.x,
                                above ? head_ + legends_ : out_.paperMm.y - rightFoot_ - height);
        if (put(i, std::move(block), corner)) {
            (above ? legends_ : rightFoot_) += height + kBetween;
        }
    }

    /// Puts a block there, or where the user wants it. Returns whether it took the place it was offered.
    bool put(std::size_t i, PaperBlock block, glm::dvec2 corner) {
        AnnotationPlace& place = out_.places[i];
        place.note = block.note;
        if (block.texts.empty() && block.lines.strokes.empty()) {
            return false;
        }
        const auto& at = figure_.annotations[i].at;
        if (at) {
            corner = *at * out_.paperMm - block.handleMm;
        }
        place.drawn = true;
        place.box = {corner, corner + block.sizeMm};
        place.at = (corner + block.handleMm) / out_.paperMm;
        sheet_.taken.push_back(place.box);
        add(block, corner);
        return !at;
    }

    void add(PaperBlock& block, const glm::dvec2& corner) {
        for (PaperText& text : block.texts) {
            text.atMm += corner;
            out_.texts.push_back(std::move(text));
        }
        for (PaperBar& bar : block.bars) {
            out_.bars.push_back({{bar.box.lowMm + corner, bar.box.highMm + corner}, bar.rgb});
        }
        for (PaperBall& ball : block.balls) {
            ball.centreMm += corner;
            out_.balls.push_back(std::move(ball));
        }
        for (const Stroke& stroke : block.lines.strokes) {
            const glm::dvec2 from(block.lines.points[stroke.first].placeMm);
            const glm::dvec2 to(block.lines.points[stroke.first + 1].placeMm);
            addLine(out_.lines.groups[1], corner + from, corner + to, block.lines.points[stroke.first].widthMm,
                    stroke.rgb);
        }
    }

    [[nodiscard]] TextStyle labelStyle(const Annotation& annotation) const {
        TextStyle style{annotation.font, sizePtOf(annotation), false, TextAlign::left, 0};
        constexpr double kShare = 0.28; // of the sheet: two columns leave the drawing its place
        constexpr double kLeast = 25;   // mm: a word or two
        style.wrapMm = std::max(kLeast, kShare * out_.paperMm.x);
        return style;
    }

    struct Label {
        std::size_t index;
        TextStyle style;
        TextBlock text;
    };

    void drawLabels() {
        std::vector<Label> labels;
        std::vector<LabelBox> boxes;
        each("label", [&](std::size_t i) {
            const Annotation& annotation = figure_.annotations[i];
            Label label{i, labelStyle(annotation), {}};
            label.text = setText(annotation.text, label.style);
            const auto seen = whereSeen(annotation, label.text, out_.places[i].note);
            if (!annotation.anchorMm && annotation.at && !label.text.runs.empty()) {
                PaperBlock block;
                block.sizeMm = label.text.sizeMm;
                block.handleMm = block.sizeMm / 2.0;
                block.texts.push_back({label.text, {0, 0}, context(i).ink});
                put(i, std::move(block), {0, 0});
            } else if (seen) {
                LabelBox box{label.text.sizeMm + glm::dvec2(2 * kPadMm, 0), label.text.firstMiddleMm, *seen};
                if (annotation.at) {
                    box.atMm = *annotation.at * out_.paperMm;
                }
                box.side = annotation.side == "left"    ? LabelSide::left
                           : annotation.side == "right" ? LabelSide::right
                                                        : LabelSide::automatic;
                labels.push_back(std::move(label));
                boxes.push_back(box);
            }
        });
        sheet_.gapMm = 0.6; // between lines that belong to two labels, a little more than between those of one
        const std::vector<PlacedLabel> placed = layOutLabels(sheet_, boxes);
        for (std::size_t k = 0; k < labels.size(); ++k) {
            drawLabel(labels[k], boxes[k], placed[k]);
        }
    }

    [[nodiscard]] std::optional<glm::dvec2> whereSeen(const Annotation& annotation, const TextBlock& text,
                                                      std::string& note) const {
        if (text.runs.empty()) {
            note = "it says nothing";
            return std::nullopt;
        }
        if (!annotation.anchorMm) {
            note = annotation.at ? "" : "it has neither a point nor a place";
            return std::nullopt;
        }
        const auto seen = onSheet(figure_.camera, figure_.output, *annotation.anchorMm);
        if (!seen) {
            note = "its point is not in the picture";
        }
        return seen;
    }

    void drawLabel(Label& label, const LabelBox& box, const PlacedLabel& placed) {
        AnnotationPlace& place = out_.places[label.index];
        place.drawn = true;
        place.box = placed.box;
        place.anchorMm = box.anchorMm;
        place.portMm = placed.portMm;
        place.at = placed.portMm / out_.paperMm;
        const InkColour ink = context(label.index).ink;
        const double across = (placed.portMm.x - placed.box.lowMm.x) / box.sizeMm.x;
        const TextAlign align = across < 0.01 ? TextAlign::left : across > 0.99 ? TextAlign::right : TextAlign::centre;
        if (align != label.style.align) {
            label.style.align = align;
            label.text = setText(figure_.annotations[label.index].text, label.style);
        }
        out_.texts.push_back({std::move(label.text), placed.box.lowMm + glm::dvec2(kPadMm, 0), ink});
        if (paper_.rgb) {
            constexpr float kCasing = 0.8F; // what lies below shows through a little: a line, no cut
            addLine(out_.lines.groups[0], placed.portMm, box.anchorMm, kLineMm + 2 * kCasingMm, inkColour(*paper_.rgb),
                    kCasing);
        }
        addLine(out_.lines.groups[1], placed.portMm, box.anchorMm, kLineMm, ink);
        constexpr float kPointMm = 0.35F; // radius
        out_.lines.groups[2].dots.push_back({glm::vec2(box.anchorMm), 0, kPointMm, 1, ink});
    }

    static constexpr double kBetween = 2; ///< mm, between blocks
    const Figure& figure_;
    const AnnotationPaper& paper_;
    LabelSheet sheet_;
    DrawnAnnotations out_;
    double head_ = kMarginMm; ///< what titles take at the top
    double foot_ = kMarginMm; ///< and captions at the bottom
    double leftFoot_ = 0;
    double rightFoot_ = 0;
    double legends_ = 0;
};

} // namespace

bool DrawnAnnotations::empty() const { return lines.empty() && bars.empty() && balls.empty() && texts.empty(); }

std::size_t DrawnAnnotations::count() const {
    return static_cast<std::size_t>(
        std::count_if(places.begin(), places.end(), [](const AnnotationPlace& place) { return place.drawn; }));
}

void addLine(MarkGroup& group, const glm::dvec2& from, const glm::dvec2& to, double widthMm, const InkColour& rgb,
             float opacity) {
    const auto width = static_cast<float>(widthMm);
    group.strokes.push_back({static_cast<std::uint32_t>(group.points.size()), 2, opacity, rgb});
    group.points.push_back({glm::vec2(from), width});
    group.points.push_back({glm::vec2(to), width});
}

InkColour inkColour(const glm::dvec3& rgb) { return InkColour(glm::clamp(rgb, 0.0, 1.0) * 255.0 + 0.5); }

InkColour inkOf(const Annotation& annotation, const AnnotationPaper& paper) {
    if (annotation.rgb) {
        return inkColour(*annotation.rgb);
    }
    constexpr double kDark = 0.45; // the encoded grey that black and white stand out from alike
    const glm::dvec3 rgb = paper.rgb.value_or(glm::dvec3(1));
    return 0.299 * rgb.r + 0.587 * rgb.g + 0.114 * rgb.b < kDark ? InkColour(255) : InkColour(0);
}

DrawnAnnotations drawAnnotations(const Figure& figure, const AnnotationPaper& paper) {
    return Drawing(figure, paper).draw();
}

std::vector<std::string> describeAnnotations(const Figure& figure, const DrawnAnnotations& annotations) {
    std::vector<std::string> lines;
    for (const AnnotationPlace& place : annotations.places) {
        const Annotation& annotation = figure.annotations[place.index];
        std::string line = annotation.kind;
        const std::string words = plainText(annotation.text);
        if (!words.empty()) {
            line += " \"" + words + "\"";
        }
        if (annotation.kind == "scale-bar") {
            const double scale = paperPerPatient(figure.camera, figure.output);
            const double length = annotation.lengthMm.value_or(roundBarMm(figure.output.widthMm / scale));
            line += " of " + lengthText(length);
        }
        line += place.drawn ? "" : ": not drawn";
        lines.push_back(line + (place.note.empty() ? "" : ": " + place.note));
    }
    return lines;
}

} // namespace limner
