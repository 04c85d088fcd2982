#pragma once

#include "renderer/marks/line_scene.h"
#include "renderer/marks/zero_lines.h"

#include <functional>
#include <string>
#include <vector>

namespace limner {

/// Lines of a surface drawn with a pen on the figure's paper.

/// A point of a line as the pen meets it.
struct PenPoint {
    PlaceOnPaper at;
    float width = 1; ///< share of the pen's
    float shown = 1; ///< 0: matter is in front of it; below 0: not drawn at all
};

struct Pen {
    double widthMm = 0.2;
    std::string hiddenLines = "none"; ///< none, dashed, thin
    bool taper = true;                ///< lines end thin
};

/// Visible lines and, where they are drawn, hidden ones of one layer.
struct PennedLines {
    MarkGroup visible;
    MarkGroup hidden;
};

using MeetsPen = std::function<PenPoint(const LinePoint& point)>;

/// Smooths the lines, cuts them where they are hidden and draws them, each layer's on its own (by its index in the
/// field). Parallel; the same for any number of threads.
std::vector<PennedLines> drawWithPen(const LineScene& scene, std::vector<SurfaceLine> lines, const Pen& pen,
                                     const MeetsPen& meets);

/// The layers' lines of parts of the marks, part after part.
std::vector<PennedLines> inOneOrder(const std::vector<std::vector<PennedLines>>& parts, std::size_t layers);

/// The groups that are not empty, named for people: hidden lines of all layers first.
std::vector<MarkGroup> namedGroups(const LineScene& scene, std::vector<PennedLines> layers, const std::string& name);

} // namespace limner
