#include "renderer/export/vector_file.h"

#include "core/base/error.h"
#include "core/style/ball_picture.h"
#include "renderer/export/backdrop.h"
#include "renderer/export/bands.h"
#include "renderer/export/pixel_rows.h"
#include "renderer/export/vector_page.h"
#include "renderer/marks/draw_marks.h"
#include "renderer/marks/mark_field.h"
#include "renderer/marks/marked_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>

namespace limner {

namespace {

constexpr std::size_t kMarksPerLook = 4096; ///< at cancellation and at the disk

/// What is drawn, and with what.
struct Drawing {
    const Marks& marks;
    const RenderPlan& plan;
    const Backend& backend;
    const PictureOptions& options;
    VectorPage& page;
    Task& task;
    std::function<void()> look; ///< throws where it must end
    ExportFacts facts;
};

bool reaches(const glm::vec2& low, const glm::vec2& high, const glm::dvec2& paperMm) {
    return high.x > 0 && high.y > 0 && low.x < paperMm.x && low.y < paperMm.y; // false for what is no number
}

bool usable(const Dot& dot, const glm::dvec2& paperMm) {
    return dot.radiusMm > 0 && std::isfinite(dot.radiusMm) && dot.opacity > 0 && std::isfinite(dot.depthMm) &&
           reaches(dot.placeMm - dot.radiusMm, dot.placeMm + dot.radiusMm, paperMm);
}

/// The points without repeated places; empty where one is not finite or none is on the paper.
void usablePoints(std::span<const StrokePoint> points, const glm::dvec2& paperMm, std::vector<OutlinePoint>& out) {
    constexpr float kSame = 1e-3F; // files hold whole micrometres
    constexpr float kFar = 1e6F;
    out.clear();
    bool onPaper = false;
    for (const StrokePoint& point : points) {
        const float radius = 0.5F * point.widthMm;
        const bool sound =
            std::abs(point.placeMm.x) < kFar && std::abs(point.placeMm.y) < kFar && radius >= 0 && radius < kFar;
        if (!sound) {
            out.clear();
            return;
        }
        if (!out.empty() && glm::distance(out.back().place, point.placeMm) < kSame)
            out.back().radius = std::max(out.back().radius, radius);
        else
            out.push_back({point.placeMm, radius});
    }
    glm::vec2 low(kFar);
    glm::vec2 high(-kFar);
    for (const OutlinePoint& point : out) {
        low = glm::min(low, point.place - point.radius);
        high = glm::max(high, point.place + point.radius);
        onPaper = onPaper || point.radius > 0;
    }
    if (!onPaper || !reaches(low, high, paperMm))
        out.clear();
}

bool oneColour(const Marks& marks) {
    std::optional<InkColour> first;
    const auto same = [&](const auto& mark) {
        return mark.rgb == first.value_or(mark.rgb) && (first = mark.rgb, true);
    };
    return std::all_of(marks.groups.begin(), marks.groups.end(), [&](const MarkGroup& group) {
        return std::all_of(group.dots.begin(), group.dots.end(), same) &&
               std::all_of(group.strokes.begin(), group.strokes.end(), same);
    });
}

/// Dots as pictures lay them: the farthest first where colours differ.
void drawDots(const MarkGroup& group, bool byDepth, Drawing& drawing) {
    std::vector<std::uint32_t> order;
    if (byDepth) {
        order.resize(group.dots.size());
        std::iota(order.begin(), order.end(), 0U);
        std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            const float x = group.dots[a].depthMm;
            const float y = group.dots[b].depthMm;
            return std::isnan(y) ? !std::isnan(x) : x < y; // no numbers last: they are not drawn
        });
    }
    for (std::size_t i = 0; i < group.dots.size(); ++i) {
        if (i % kMarksPerLook == 0)
            drawing.look();
        const Dot& dot = group.dots[byDepth ? order[i] : i];
        if (!usable(dot, drawing.marks.paperMm))
            continue;
        drawing.page.dot(dot);
        ++drawing.facts.dots;
    }
}

void drawStrokes(const MarkGroup& group, Drawing& drawing) {
    std::vector<OutlinePoint> points;
    for (std::size_t i = 0; i < group.strokes.size(); ++i) {
        if (i % kMarksPerLook == 0)
            drawing.look();
        const Stroke& stroke = group.strokes[i];
        if (!(stroke.opacity > 0) || stroke.first + std::size_t{stroke.count} > group.points.size())
            continue;
        usablePoints(std::span(group.points).subspan(stroke.first, stroke.count), drawing.marks.paperMm, points);
        if (points.empty())
            continue;
        const float radius = points.front().radius;
        if (points.size() == 1)
            drawing.page.dot({points.front().place, 0, radius, stroke.opacity, stroke.rgb});
        else if (std::all_of(points.begin(), points.end(), [&](const OutlinePoint& p) { return p.radius == radius; }))
            drawing.page.line(points, stroke);
        else
            drawing.page.outline(points, stroke);
        ++drawing.facts.strokes;
    }
}

void drawMarkLayers(Drawing& drawing) {
    const bool byDepth = !oneColour(drawing.marks);
    for (const MarkGroup& group : drawing.marks.groups) {
        drawing.page.beginLayer(group.name);
        drawDots(group, byDepth, drawing);
        drawStrokes(group, drawing);
        drawing.page.endLayer();
    }
}

/// A picture over the whole page, band by band.
void drawPicture(Drawing& drawing, const PixelLayout& layout,
                 const std::function<Picture(const Tile& tile, Task& task)>& render) {
    const glm::ivec2 size = drawing.plan.size;
    const BandLayout bands = chooseBands(size, PictureFormat::png, layout, drawing.options);
    std::vector<std::byte> rows;
    drawing.page.beginPicture(size, drawing.options.dpi);
    for (int row = 0; row < size.y; row += bands.rows) {
        const int count = std::min(bands.rows, size.y - row);
        rows.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(count) * layout.bytesPerPixel());
        for (int x = 0; x < size.x; x += bands.tileWidth) {
            drawing.look();
            const Tile tile{{x, row}, {std::min(bands.tileWidth, size.x - x), count}};
            const auto doneAt = [&](int column) {
                return (row + static_cast<double>(column) / size.x * count) / size.y;
            };
            Task part(drawing.task, doneAt(x), doneAt(x + tile.size.x));
            drawing.facts.notFinite += writePixels(render(tile, part), layout, {rows, size.x, {x, 0}, tile.origin});
            part.progress(1);
        }
        drawing.page.pictureRows(rows, count);
    }
    drawing.page.endPicture();
}

void drawPaper(Drawing& drawing) {
    const PictureOptions& options = drawing.options;
    if (options.transparent)
        return;
    drawing.page.beginLayer("Paper");
    const glm::dvec4& rgba = options.background;
    drawing.page.fill(glm::dvec3(rgba) * rgba.a + (1 - rgba.a)); // as it looks on white paper
    if (options.backgroundPicture) {
        PixelLayout layout;
        layout.alpha = AlphaForm::opaque;
        layout.background = options.background;
        layout.backdrop = makeBackdrop(options, layout, drawing.plan.size);
        drawPicture(drawing, layout, [](const Tile& tile, Task&) { return Picture(tile.size); });
    }
    drawing.page.endLayer();
}

void drawLayersPicture(Drawing& drawing) {
    drawing.task.beginPhase("Rendering");
    drawing.page.beginLayer("Layers");
    PixelLayout layout;
    layout.alpha = AlphaForm::unassociated;
    drawPicture(drawing, layout, [&](const Tile& tile, Task& part) {
        RenderResult result = drawing.backend.render(drawing.plan, tile, part);
        drawing.facts.samples += result.samples;
        drawing.facts.shaded += result.shaded;
        return std::move(result.picture);
    });
    drawing.page.endLayer();
    drawing.facts.layersEmbedded = true;
}

/// Over all else, in a layer of their own.
void drawAnnotationLayer(Drawing& drawing) {
    const DrawnAnnotations annotations = annotationsOf(drawing.plan, drawing.options);
    if (annotations.empty())
        return;
    drawing.page.beginLayer("Annotations");
    const Marks& lines = annotations.lines;
    for (const MarkGroup& group : lines.groups) {
        Drawing part{// whose facts are its own: leaders are no strokes of ink
                     lines,        drawing.plan, drawing.backend, drawing.options,
                     drawing.page, drawing.task, drawing.look,    {}};
        drawDots(group, false, part);
        drawStrokes(group, part);
    }
    for (const PaperBar& bar : annotations.bars)
        drawing.page.bar(bar);
    for (const PaperBall& ball : annotations.balls)
        drawing.page.ball(ball);
    for (const PaperText& text : annotations.texts)
        drawing.page.text(text);
    drawing.page.endLayer();
    drawing.facts.annotations = annotations.count();
}

PageHeader headerOf(const Marks& marks, const RenderPlan& plan) {
    PageHeader header;
    header.paperMm = marks.paperMm;
    header.title = plan.figure && !plan.figure->title.empty() ? plan.figure->title : "Figure";
    header.description = "Drawn by Limner: " + std::to_string(marks.dotCount()) + " dots, " +
                         std::to_string(marks.strokeCount()) + " strokes";
    std::string names;
    for (const PlanLayer& layer : plan.layers)
        if (layer.source != nullptr && !layer.source->name.empty())
            names += (names.empty() ? "" : ", ") + layer.source->name;
    if (!names.empty())
        header.description += "; layers: " + names;
    return header;
}

void drawAll(Drawing& drawing) {
    const bool under = drawing.marks.order == MarkOrder::underLayers;
    const bool layers = !drawing.plan.marks || drawing.plan.marks->layersDrawn;
    drawPaper(drawing);
    if (layers && !under)
        drawLayersPicture(drawing);
    drawing.task.beginPhase("Writing marks");
    drawMarkLayers(drawing);
    if (layers && under)
        drawLayersPicture(drawing);
    drawAnnotationLayer(drawing);
    drawing.page.finish();
    drawing.look();
}

} // namespace

std::vector<std::uint8_t> ballBytes(const LitSphere& sphere) {
    std::vector<std::uint8_t> bytes;
    for (const Rgba& pixel : ballPicture(sphere, kBallPixels))
        for (const float channel : {pixel.r, pixel.g, pixel.b, pixel.a})
            bytes.push_back(static_cast<std::uint8_t>(std::clamp(channel, 0.0F, 1.0F) * 255 + 0.5F));
    return bytes;
}

std::optional<VectorFormat> vectorFormatOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".svg")
        return VectorFormat::svg;
    if (ending == ".pdf")
        return VectorFormat::pdf;
    return std::nullopt;
}

void checkVectorOptions(const std::filesystem::path& path, const PictureOptions& options) {
    if (options.depth != SampleDepth::automatic)
        throw Error(ErrorKind::usage, {"cannot choose the numbers' depth", path.string(),
                                       "a drawing has none, and a picture inside of it has 8 bits a channel",
                                       "leave the depth out, or write tif, png or exr"});
}

ExportFacts writeVectorMarks(const Marks& marks, const RenderPlan& plan, const Backend& backend,
                             const PictureOptions& options, VectorFormat format, PendingFile& file, Task& task) {
    const PageHeader header = headerOf(marks, plan);
    const auto page =
        format == VectorFormat::svg ? makeSvgPage(header, file.stream()) : makePdfPage(header, file.stream());
    Drawing drawing{marks,
                    plan,
                    backend,
                    options,
                    *page,
                    task,
                    [&] {
                        task.throwIfCancelled();
                        file.check();
                    },
                    {}};
    drawing.facts.size = plan.size;
    drawAll(drawing);
    return drawing.facts;
}

ExportFacts writeVectorFile(const RenderPlan& plan, const Backend& backend, const std::filesystem::path& path,
                            const PictureOptions& options, Task& task) {
    PendingFile file(path);
    Marks marks;
    if (plan.marks)
        marks = drawMarks(plan, task);
    else
        marks.paperMm = {plan.figure->output.widthMm, plan.figure->output.heightMm};
    const ExportFacts facts = writeVectorMarks(marks, plan, backend, options, *vectorFormatOf(path), file, task);
    file.commit();
    return facts;
}

} // namespace limner
