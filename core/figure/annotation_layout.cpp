#include "core/figure/annotation_layout.h"

#include "core/figure/label_places.h"
#include "core/figure/view_frame.h"

#include <algorithm>

namespace limner {
namespace {

/// Twice the area of a triangle, positive to the left of a to b (y down: to the right).
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool within(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y &&
           c.y <= std::max(a.y, b.y);
}

} // namespace

namespace label_places {

PlacedLabel besidePort(const LabelBox& label, const glm::dvec2& port, bool toTheLeft) {
    const glm::dvec2 low(toTheLeft ? port.x - label.sizeMm.x : port.x, port.y - label.portDownMm);
    return {{low, low + label.sizeMm}, port};
}

bool disturbs(const Scene& scene, std::size_t label, std::span<const std::size_t> others,
              const std::vector<PlacedLabel>& placed) {
    const PlacedLabel& mine = placed[label];
    const glm::dvec2 gap(scene.sheet.gapMm);
    const SheetBox wide{mine.box.lowMm - gap, mine.box.highMm + gap};
    const auto meets = [&](const SheetBox& box) { return wide.overlaps(box); };
    if (std::any_of(scene.sheet.taken.begin(), scene.sheet.taken.end(), meets)) {
        return true;
    }
    return std::any_of(others.begin(), others.end(), [&](std::size_t other) {
        return other != label &&
               (meets(placed[other].box) || leadersCross(mine.portMm, scene.labels[label].anchorMm,
                                                         placed[other].portMm, scene.labels[other].anchorMm));
    });
}

} // namespace label_places

bool leadersCross(const glm::dvec2& portA, const glm::dvec2& anchorA, const glm::dvec2& portB,
                  const glm::dvec2& anchorB) {
    if (anchorA == anchorB || portA == portB) {
        return false; // they meet where they belong together
    }
    const double a = turn(portA, anchorA, portB);
    const double b = turn(portA, anchorA, anchorB);
    const double c = turn(portB, anchorB, portA);
    const double d = turn(portB, anchorB, anchorA);
    if (((a > 0 && b < 0) || (a < 0 && b > 0)) && ((c > 0 && d < 0) || (c < 0 && d > 0))) {
        return true;
    }
    return (a == 0 && within(portA, anchorA, portB)) || (b == 0 && within(portA, anchorA, anchorB)) ||
           (c == 0 && within(portB, anchorB, portA)) || (d == 0 && within(portB, anchorB, anchorA));
}

std::vector<PlacedLabel> layOutLabels(const LabelSheet& sheet, std::span<const LabelBox> labels) {
    const label_places::Scene scene{sheet, labels};
    std::vector<PlacedLabel> placed(labels.size());
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i].atMm) {
            const glm::dvec2 port = *labels[i].atMm;
            placed[i] = label_places::besidePort(labels[i], port, port.x < labels[i].anchorMm.x);
        } else {
            free.push_back(i);
        }
    }
    if (sheet.layout == LabelLayout::ring && label_places::layRing(scene, free, placed)) {
        return placed;
    }
    if (sheet.layout == LabelLayout::free && label_places::layFree(scene, free, placed)) {
        return placed;
    }
    label_places::layColumns(scene, free, placed);
    return placed;
}

std::optional<glm::dvec2> onSheet(const Camera& camera, const Output& output, const glm::dvec3& pointMm) {
    const glm::dvec3 seen = ViewFrame(camera, output.aspect()).project(pointMm);
    if (!(seen.z > 0)) {
        return std::nullopt;
    }
    const glm::dvec2 place = glm::dvec2(seen) / seen.z;
    if (!(place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1)) {
        return std::nullopt;
    }
    return place * glm::dvec2(output.widthMm, output.heightMm);
}

double paperPerPatient(const Camera& camera, const Output& output) { return output.heightMm / camera.heightMm; }

} // namespace limner
