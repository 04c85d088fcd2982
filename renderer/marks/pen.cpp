#include "renderer/marks/pen.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

/// Steps of smoothing on the surface, and on paper: the points' spacing is a third of a voxel there and kStepVoxels
/// here.
constexpr int kSurfaceSteps = 6;
constexpr int kPaperSteps = 3;
constexpr float kStepVoxels = 0.7F;
/// Changes between visible and hidden closer than this are noise.
constexpr float kLeastRunVoxels = 3;
/// Shorter lines behind matter tell nothing.
constexpr float kLeastHiddenVoxels = 12;
/// Points that the line hits without them are left out: mm on paper.
constexpr float kFlatMm = 0.004F;
/// A tapered line's width at its end, and the length of the taper in widths.
constexpr float kEndWidth = 0.3F;
constexpr float kTaperWidths = 10;
/// Dashes and gaps in widths of the pen; hidden lines' widths.
constexpr float kDashWidths = 7;
constexpr float kGapWidths = 4.5F;
constexpr float kDashedWidth = 0.8F;
constexpr float kThinWidth = 0.4F;

enum class Run : std::uint8_t { absent, hidden, visible };

void smoothOnSurface(SurfaceLine& line) {
    std::vector<LinePoint>& p = line.points;
    if (p.size() < 3) {
        return;
    }
    for (int step = 0; step < kSurfaceSteps; ++step) {
        const glm::dvec3 first = p.front().mm;
        glm::dvec3 before = line.closed ? p.back().mm : first;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::dvec3 own = p[i].mm;
            const bool end = !line.closed && (i == 0 || i + 1 == p.size());
            const glm::dvec3 after = i + 1 < p.size() ? p[i + 1].mm : first;
            if (!end) {
                p[i].mm = 0.5 * own + 0.25 * (before + after);
            }
            before = own;
        }
    }
}

/// Steps of equal length on paper; pieces behind the eye or not drawn at all break nothing, they are skipped later.
std::vector<PenPoint> evenSteps(const std::vector<PenPoint>& points, bool closed, float stepMm) {
    std::vector<PenPoint> even{points.front()};
    float left = stepMm;
    const std::size_t count = points.size() + (closed ? 1 : 0);
    for (std::size_t i = 1; i < count; ++i) {
        const PenPoint& a = points[i - 1];
        const PenPoint& b = points[i % points.size()];
        const float length = glm::distance(a.at.mm, b.at.mm);
        for (; left < length; left += stepMm) {
            const float t = left / length;
            even.push_back({{glm::mix(a.at.mm, b.at.mm, t), glm::mix(a.at.depthMm, b.at.depthMm, t),
                             glm::mix(a.at.scale, b.at.scale, t)},
                            glm::mix(a.width, b.width, t),
                            std::min(a.shown, b.shown) < 0 ? -1.0F : glm::mix(a.shown, b.shown, t)});
        }
        left -= length;
    }
    if (!closed) {
        even.push_back(points.back());
    } else if (even.size() > 3 && left < stepMm / 3) { // the last step all but meets the first point
        even.pop_back();
    }
    return even;
}

void smoothOnPaper(std::vector<PenPoint>& p, bool closed) {
    if (p.size() < 3) {
        return;
    }
    for (int step = 0; step < kPaperSteps; ++step) {
        const PenPoint first = p.front();
        PenPoint before = closed ? p.back() : first;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const PenPoint own = p[i];
            const PenPoint& after = i + 1 < p.size() ? p[i + 1] : first;
            if (closed || (i > 0 && i + 1 < p.size())) {
                p[i].at.mm = 0.5F * own.at.mm + 0.25F * (before.at.mm + after.at.mm);
                p[i].width = 0.5F * own.width + 0.25F * (before.width + after.width);
                p[i].shown = std::min({before.shown, own.shown, after.shown}) < 0
                                 ? own.shown
                                 : 0.5F * own.shown + 0.25F * (before.shown + after.shown);
            }
            before = own;
        }
    }
}

std::vector<Run> runsOf(const std::vector<PenPoint>& p, const glm::dvec2& paperMm) {
    const glm::vec2 margin(static_cast<float>(0.02 * std::max(paperMm.x, paperMm.y)));
    std::vector<Run> runs(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::vec2 at = p[i].at.mm;
        const bool onPaper = at.x > -margin.x && at.y > -margin.y && at.x < static_cast<float>(paperMm.x) + margin.x &&
                             at.y < static_cast<float>(paperMm.y) + margin.y;
        runs[i] = p[i].shown < 0 || !onPaper ? Run::absent : p[i].shown < 0.5F ? Run::hidden : Run::visible;
    }
    // Short runs between two longer ones become like those around them, hidden ones first.
    for (const Run flipped : {Run::hidden, Run::visible}) {
        const Run other = flipped == Run::hidden ? Run::visible : Run::hidden;
        for (std::size_t i = 0; i < runs.size();) {
            std::size_t end = i;
            while (end < runs.size() && runs[end] == runs[i]) {
                ++end;
            }
            if (runs[i] == flipped && static_cast<float>(end - i) * kStepVoxels < kLeastRunVoxels && i > 0 &&
                end < runs.size() && runs[i - 1] == other && runs[end] == other) {
                std::fill(runs.begin() + static_cast<std::ptrdiff_t>(i),
                          runs.begin() + static_cast<std::ptrdiff_t>(end), other);
            }
            i = end;
        }
    }
    return runs;
}

/// Cuts corners twice: the lines between the points would show in large prints. Ends stay, closed lines are closed.
std::vector<StrokePoint> rounded(std::vector<StrokePoint> p, bool closed) {
    for (int round = 0; round < 2 && p.size() > 2; ++round) {
        std::vector<StrokePoint> finer;
        finer.reserve(2 * p.size() + 2);
        if (!closed) {
            finer.push_back(p.front());
        }
        for (std::size_t i = 0; i + 1 < p.size(); ++i) {
            for (const float t : {0.25F, 0.75F}) {
                finer.push_back(
                    {glm::mix(p[i].placeMm, p[i + 1].placeMm, t), glm::mix(p[i].widthMm, p[i + 1].widthMm, t)});
            }
        }
        finer.push_back(closed ? finer.front() : p.back());
        p = std::move(finer);
    }
    return p;
}

/// Leaves out what lies on the line between its neighbours.
std::vector<StrokePoint> withoutFlat(const std::vector<StrokePoint>& p) {
    std::vector<StrokePoint> kept{p.front()};
    std::size_t from = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const glm::vec2 way = p[i + 1].placeMm - p[from].placeMm;
        const float length = glm::length(way);
        bool flat = length > 0;
        for (std::size_t k = from + 1; flat && k <= i; ++k) {
            const glm::vec2 d = p[k].placeMm - p[from].placeMm;
            const float t = glm::dot(d, way) / (length * length);
            const float off = std::abs(d.x * way.y - d.y * way.x) / length;
            const float width = glm::mix(p[from].widthMm, p[i + 1].widthMm, t);
            flat = t >= 0 && t <= 1 && off < kFlatMm && std::abs(width - p[k].widthMm) < 2 * kFlatMm;
        }
        if (!flat) {
            kept.push_back(p[i]);
            from = i;
        }
    }
    kept.push_back(p.back());
    return kept;
}

class Drawer {
  public:
    Drawer(const LineScene& scene, const Pen& pen) : scene_(scene), pen_(pen), paperMm_(scene.view.paperMm()) {}

    PennedLines draw(std::vector<PenPoint> points, bool closed) const {
        PennedLines lines;
        if (points.size() < 2) {
            return lines;
        }
        const auto stepMm =
            static_cast<float>(std::max(kStepVoxels * scene_.field.mmPerVoxel * scene_.view.scale(), 0.02));
        points = evenSteps(points, closed, stepMm);
        smoothOnPaper(points, closed);
        std::vector<Run> runs = runsOf(points, paperMm_);
        if (closed) {
            const auto change = std::adjacent_find(runs.begin(), runs.end(), std::not_equal_to<>());
            if (change != runs.end()) { // starts where it changes, so that no run passes through the start
                const std::ptrdiff_t by = change - runs.begin() + 1;
                std::rotate(runs.begin(), runs.begin() + by, runs.end());
                std::rotate(points.begin(), points.begin() + by, points.end());
            }
            runs.push_back(runs.front());
            points.push_back(points.front());
            closed = change == runs.end() - 1 || std::equal(runs.begin() + 1, runs.end(), runs.begin());
        }
        for (std::size_t i = 0; i < runs.size();) {
            std::size_t end = i;
            while (end < runs.size() && runs[end] == runs[i]) {
                ++end;
            }
            addRun({points.begin() + static_cast<std::ptrdiff_t>(i), points.begin() + static_cast<std::ptrdiff_t>(end)},
                   runs[i], closed, lines);
            i = end;
        }
        return lines;
    }

  private:
    void addRun(const std::vector<PenPoint>& points, Run run, bool closed, PennedLines& lines) const {
        if (points.size() < 2 || run == Run::absent || (run == Run::hidden && pen_.hiddenLines == "none")) {
            return;
        }
        if (run == Run::hidden && static_cast<float>(points.size()) * kStepVoxels < kLeastHiddenVoxels) {
            return;
        }
        const bool dashed = run == Run::hidden && pen_.hiddenLines == "dashed";
        const auto pen = static_cast<float>(pen_.widthMm);
        const float width = pen * (run == Run::visible ? 1.0F : dashed ? kDashedWidth : kThinWidth);
        std::vector<StrokePoint> line;
        line.reserve(points.size());
        for (const PenPoint& p : points) {
            line.push_back({p.at.mm, p.width * width});
        }
        line = rounded(std::move(line), closed);
        if (dashed) {
            addDashes(line, lines.hidden);
            return;
        }
        if (pen_.taper && !closed && run == Run::visible) {
            taper(line);
        }
        add(line, run == Run::visible ? lines.visible : lines.hidden);
    }

    void taper(std::vector<StrokePoint>& line) const {
        std::vector<float> along(line.size(), 0);
        for (std::size_t i = 1; i < line.size(); ++i) {
            along[i] = along[i - 1] + glm::distance(line[i - 1].placeMm, line[i].placeMm);
        }
        const float reach = std::min(kTaperWidths * static_cast<float>(pen_.widthMm), 0.35F * along.back());
        for (std::size_t i = 0; i < line.size() && reach > 0; ++i) {
            const float t = std::min(std::min(along[i], along.back() - along[i]) / reach, 1.0F);
            line[i].widthMm *= kEndWidth + (1 - kEndWidth) * t * (2 - t);
        }
    }

    void addDashes(const std::vector<StrokePoint>& line, MarkGroup& group) const {
        const auto pen = static_cast<float>(pen_.widthMm);
        std::vector<StrokePoint> dash{line.front()};
        bool inked = true;
        float left = kDashWidths * pen;
        for (std::size_t i = 1; i < line.size(); ++i) {
            StrokePoint from = line[i - 1];
            float length = glm::distance(from.placeMm, line[i].placeMm);
            while (length > left) {
                const float t = left / length;
                from = {glm::mix(from.placeMm, line[i].placeMm, t), glm::mix(from.widthMm, line[i].widthMm, t)};
                length -= left;
                dash.push_back(from);
                if (inked) {
                    add(dash, group);
                }
                dash = {from};
                inked = !inked;
                left = (inked ? kDashWidths : kGapWidths) * pen;
            }
            left -= length;
            dash.push_back(line[i]);
        }
        if (inked) {
            add(dash, group);
        }
    }

    void add(const std::vector<StrokePoint>& line, MarkGroup& group) const {
        if (line.size() < 2) {
            return;
        }
        const std::vector<StrokePoint> kept = withoutFlat(line);
        group.strokes.push_back(
            {static_cast<std::uint32_t>(group.points.size()), static_cast<std::uint32_t>(kept.size()), 1, scene_.ink});
        group.points.insert(group.points.end(), kept.begin(), kept.end());
    }

    const LineScene& scene_;
    const Pen& pen_;
    glm::dvec2 paperMm_;
};

/// One group of all parts, `of` a part's own.
template <typename Of>
MarkGroup gathered(std::size_t parts, const Of& of) {
    std::vector<std::size_t> firstPoint(parts + 1, 0);
    std::vector<std::size_t> firstStroke(parts + 1, 0);
    for (std::size_t i = 0; i < parts; ++i) {
        firstPoint[i + 1] = firstPoint[i] + of(i).points.size();
        firstStroke[i + 1] = firstStroke[i] + of(i).strokes.size();
    }
    MarkGroup all;
    all.points.resize(firstPoint.back());
    all.strokes.resize(firstStroke.back());
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t i) {
        const MarkGroup& own = of(i);
        std::copy(own.points.begin(), own.points.end(),
                  all.points.begin() + static_cast<std::ptrdiff_t>(firstPoint[i]));
        std::transform(own.strokes.begin(), own.strokes.end(),
                       all.strokes.begin() + static_cast<std::ptrdiff_t>(firstStroke[i]), [&](Stroke stroke) {
                           stroke.first += static_cast<std::uint32_t>(firstPoint[i]);
                           return stroke;
                       });
    });
    return all;
}

} // namespace

std::vector<PennedLines> drawWithPen(const LineScene& scene, std::vector<SurfaceLine> lines, const Pen& pen,
                                     const MeetsPen& meets) {
    const Drawer drawer(scene, pen);
    std::vector<PennedLines> drawn(lines.size());
    tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t i) {
        smoothOnSurface(lines[i]);
        std::vector<PenPoint> points;
        points.reserve(lines[i].points.size());
        for (const LinePoint& point : lines[i].points) {
            points.push_back(meets(point));
            if (!(points.back().at.scale > 0)) { // behind the eye: nowhere on paper
                points.pop_back();
            }
        }
        drawn[i] = drawer.draw(std::move(points), lines[i].closed);
    });
    const std::size_t layerCount = std::max<std::size_t>(scene.field.layerNames.size(), 1);
    std::vector<std::vector<PennedLines>> parts(lines.size(), std::vector<PennedLines>(layerCount));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        parts[i][std::min<std::size_t>(lines[i].layer, layerCount - 1)] = std::move(drawn[i]);
    }
    return inOneOrder(parts, layerCount);
}

std::vector<PennedLines> inOneOrder(const std::vector<std::vector<PennedLines>>& parts, std::size_t layers) {
    std::vector<PennedLines> all(layers);
    for (std::size_t layer = 0; layer < layers; ++layer) {
        all[layer].visible =
            gathered(parts.size(), [&](std::size_t i) -> const MarkGroup& { return parts[i][layer].visible; });
        all[layer].hidden =
            gathered(parts.size(), [&](std::size_t i) -> const MarkGroup& { return parts[i][layer].hidden; });
    }
    return all;
}

std::vector<MarkGroup> namedGroups(const LineScene& scene, std::vector<PennedLines> layers, const std::string& name) {
    std::vector<MarkGroup> groups;
    for (const bool hidden : {true, false}) {
        for (std::size_t i = 0; i < layers.size(); ++i) {
            MarkGroup& group = hidden ? layers[i].hidden : layers[i].visible;
            if (group.strokes.empty()) {
                continue;
            }
            group.name = scene.field.groupName(name + (hidden ? ", hidden" : ""), i);
            groups.push_back(std::move(group));
        }
    }
    return groups;
}

} // namespace limner
