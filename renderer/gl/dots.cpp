#include "renderer/gl/dots.h"

#include "renderer/gl/scene_program.h"
#include "renderer/marks/dot_stencils.h"
#include "renderer/marks/volume_dots.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace limner::gl {

namespace {

constexpr int kAcross = 2048;                         ///< voxels, or listed dots, in a row of a texture
constexpr std::size_t kMostDots = 16'000'000;         ///< a quarter of a gigabyte
constexpr std::size_t kPiece = std::size_t{1} << 19U; ///< dots drawn between two looks at the task
constexpr float kNothing = -3e38F;                    ///< depth where there is no matter
constexpr TextureForm kNumbers{GL_TEXTURE_2D, GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST, {1, 1, 1}};
constexpr TextureForm kNumber{GL_TEXTURE_2D, GL_R32F, GL_RED, GL_FLOAT, GL_NEAREST, {1, 1, 1}};

glm::ivec2 texelsFor(std::size_t count) {
    return {kAcross, std::max(1, static_cast<int>((count + kAcross - 1) / kAcross))};
}

/// Rows: right, up, towards the viewer.
glm::dmat3 axesOf(const ViewFrame& frame) { return glm::transpose(glm::dmat3(frame.right, frame.up, -frame.forward)); }

double pixelsPerMm(const RenderPlan& plan, const MarkView& view) {
    const glm::dvec2 scale = glm::dvec2(plan.size) / view.paperMm();
    return std::sqrt(scale.x * scale.y);
}

/// Of the largest dot, pixels.
double largestRadius(const RenderPlan& plan, const MarkView& view) {
    return 0.5 * plan.figure->stipple->sizeMm * pixelsPerMm(plan, view);
}

/// How far from its middle a dot's point reaches, pixels.
int dotReach(const RenderPlan& plan, const MarkView& view) {
    return std::max(DotStencils::kEdge, static_cast<int>(largestRadius(plan, view)) + 4);
}

/// The same of a voxel's disc, cells of the paper; `headroom`: of the dots.
int discReach(const MarkField& field, const MarkDepth::Shape& depth, double headroom) {
    const double scale = headroom * field.paperPerMm * field.zoom;
    return static_cast<int>(static_cast<double>(depth.discMm) * scale / depth.cellMm) + 2;
}

std::vector<glm::vec4> cutsSeen(const Clip& clip, const ViewFrame& frame) {
    std::vector<glm::vec4> cuts;
    const auto add = [&](const glm::dvec3& normal, double offset) {
        cuts.emplace_back(glm::vec3(axesOf(frame) * normal),
                          static_cast<float>(offset - glm::dot(normal, frame.targetMm)));
    };
    for (int i = 0; i < 3 && clip.boxMm; ++i) {
        glm::dvec3 axis(0);
        axis[i] = 1;
        add(axis, clip.boxMm->high[i]);
        add(-axis, -clip.boxMm->low[i]);
    }
    for (const ClipPlane& plane : clip.planes) {
        add(plane.normal, plane.offsetMm);
    }
    return cuts;
}

/// Leaves what a cloud is made from: lines, light and colour have no part in it.
void keepCloudSettings(Stipple& stipple) {
    stipple.curves.reset();
    stipple.innerLines.reset();
    stipple.hatching.reset();
    stipple.lighting.reset();
    stipple.inkRgb = {};
}

} // namespace

bool canDrawDots(const ContextFacts& facts, const RenderPlan& plan) {
    if (!plan.marks || !plan.marks->moving || plan.marks->field->voxels.empty()) {
        return false;
    }
    const Stipple& stipple = *plan.figure->stipple;
    const MarkField& field = *plan.marks->field;
    const MarkView view(plan);
    const MarkDepth::Shape depth = MarkDepth::shapeOf(field, view, stipple.matter == "layers");
    const double headroom = dotHeadroom(plan, field, view);
    if (!(stipple.kMax > 0 && stipple.sizeMm > 0) || stipple.fromStyle || !(headroom > 0)) {
        return false;
    }
    const int dots = dotReach(plan, view);
    const int discs = discReach(field, depth, headroom);
    const auto fits = [&](glm::ivec2 size, int reach) {
        return std::max(size.x, size.y) + 2 * reach <= facts.largest2d && 2 * reach + 1 <= facts.largestPoint;
    };
    const bool hides = stipple.hidden == "remove";
    return fits(plan.size, dots) && (!hides || fits(depth.size, discs)) &&
           field.voxels.size() / kAcross < static_cast<std::size_t>(facts.largest2d);
}

DotDrawing::DotDrawing(Device& device, DotMemory& memory, const RenderPlan& plan, Task& task)
    : device_(device), gl_(device.gl()), memory_(memory), plan_(plan), field_(*plan.marks->field),
      stipple_(*plan.figure->stipple), task_(task), view_(plan), ink_(inkView(plan, field_, view_, task)),
      depth_(MarkDepth::shapeOf(field_, view_, stipple_.matter == "layers")), hides_(stipple_.hidden == "remove"),
      cuts_(cutsSeen(plan.clip, view_.frame())) {
    for (const std::string& warning : field_.warnings) {
        task.warn(warning);
    }
}

std::optional<std::vector<float>> DotDrawing::drawTile(const Tile& tile) {
    std::vector<float> through(static_cast<std::size_t>(tile.size.x) * static_cast<std::size_t>(tile.size.y), 1.0F);
    if (through.empty()) {
        return through;
    }
    if (!prepare(false)) {
        return std::nullopt;
    }
    resize(memory_.canvas, tile.size, kNumber, 1);
    constexpr std::array<float, 4> kClear = {1, 1, 1, 1};
    gl_.ClearBufferfv(GL_COLOR, 0, kClear.data());
    Program& drawing = program("dot.vert", "dot.frag");
    TextureUnits units(device_, drawing);
    setCandidates(drawing, units);
    const int reach = dotReach(plan_, view_);
    drawing.set("pixelsPerMm", glm::vec2(glm::dvec2(plan_.size) / view_.paperMm()));
    drawing.set("tileOrigin", tile.origin);
    drawing.set("tileSize", glm::vec2(tile.size));
    drawing.set("guard", static_cast<float>(reach));
    units.bind("stencils", GL_TEXTURE_2D, memory_.stencils.id());
    gl_.Viewport(-reach, -reach, tile.size.x + 2 * reach, tile.size.y + 2 * reach);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
    drawCandidates();
    gl_.Disable(GL_BLEND);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl_.ReadPixels(0, 0, tile.size.x, tile.size.y, GL_RED, GL_FLOAT, through.data());
    device_.check("to draw dots");
    return through;
}

std::vector<Dot> DotDrawing::list() {
    std::vector<Dot> dots;
    if (!prepare(true)) {
        return dots;
    }
    const glm::ivec2 size = texelsFor(memory_.cloud->dotCount());
    resize(memory_.list, size, kNumbers, 2);
    constexpr std::array<float, 4> kClear = {0, 0, 0, 0};
    gl_.ClearBufferfv(GL_COLOR, 0, kClear.data());
    Program& listing = program("dot_list.vert", "dot_list.frag");
    TextureUnits units(device_, listing);
    setCandidates(listing, units);
    listing.set("listSize", glm::vec2(size));
    gl_.Viewport(0, 0, size.x, size.y);
    drawCandidates();
    const std::size_t texels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    std::vector<glm::vec4> placed(texels);
    std::vector<glm::vec4> radius(texels);
    gl_.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl_.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, placed.data());
    gl_.ReadBuffer(GL_COLOR_ATTACHMENT1);
    gl_.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, radius.data());
    device_.check("to list dots");
    const double perPixel = 1 / pixelsPerMm(plan_, view_);
    for (std::size_t i = 0; i < texels; ++i) {
        if (placed[i].w > 0) {
            const double mm = static_cast<double>(radius[i].x) * perPixel;
            dots.push_back({{placed[i].x, placed[i].y}, placed[i].z, static_cast<float>(mm), placed[i].w, {}});
        }
    }
    return dots;
}

/// All that does not depend on the tile; false: there is no cloud.
bool DotDrawing::prepare(bool atOnce) {
    if (!makeCloud(atOnce)) {
        return false;
    }
    if (!memory_.none) {
        memory_.none = VertexArray(gl_);
        memory_.vertices = VertexArray(gl_);
        const auto stencils = DotStencils::instance().all();
        TextureForm form{GL_TEXTURE_2D, GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, GL_NEAREST};
        form.size = {DotStencils::kPhases * DotStencils::kPhases * DotStencils::kEdge, DotStencils::kSizes, 1};
        memory_.stencils = device_.makeTexture(form);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, form.inside, form.size.x, form.size.y, 0, form.format, form.type,
                       stencils.data());
        const auto coverage = dotPattern().coverageTable();
        form = kNumber;
        form.size = {static_cast<int>(coverage.size()), 1, 1};
        memory_.coverage = device_.makeTexture(form);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, form.inside, form.size.x, 1, 0, form.format, form.type, coverage.data());
    }
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_PROGRAM_POINT_SIZE);
    uploadVoxels();
    drawCounts();
    if (hides_) {
        drawNearest();
    }
    return true;
}

bool DotSource::is(const DotSource& other) const {
    return field.lock() == other.field.lock() && settings == other.settings && density == other.density;
}

bool DotDrawing::makeCloud(bool atOnce) {
    const double headroom = dotHeadroom(plan_, field_, view_);
    DotSource source{plan_.marks->field, stipple_, ink_.density};
    keepCloudSettings(source.settings);
    constexpr double kTooDense = 2; // times as much headroom
    if (memory_.cloud && memory_.source.is(source) && memory_.cloud->headroom >= headroom &&
        memory_.cloud->headroom < kTooDense * headroom) {
        return true;
    }
    memory_.cloud.reset();
    const bool again = memory_.asked.is(source);
    memory_.asked = source;
    if (!again && !atOnce) {
        return false;
    }
    // The voxels' textures and the dots are wanted at the same time, beside what the layers read.
    const std::uint64_t voxels = 3 * sizeof(glm::vec4) * (field_.voxels.size() + kAcross);
    const std::uint64_t room = (std::max(device_.room() / 2, voxels) - voxels) / sizeof(DotCandidate);
    memory_.cloud =
        makeDotCloud(stipple_, field_, ink_.density, headroom, std::min<std::uint64_t>(room, kMostDots), task_);
    memory_.source = source;
    return memory_.cloud != nullptr;
}

GLuint DotDrawing::voxelTexture(const char* part, const std::function<glm::vec4(const MarkVoxel&)>& texel) {
    TextureForm form = kNumbers;
    const glm::ivec2 size = voxelTexels();
    form.size = {size, 1};
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    return device_.texture(memory_.cloud, part, count * sizeof(glm::vec4), [&](Texture& texture) {
        std::vector<glm::vec4> texels(count, glm::vec4(0));
        const auto& voxels = memory_.cloud->voxels;
        tbb::parallel_for(std::size_t{0}, voxels.size(),
                          [&](std::size_t i) { texels[i] = texel(field_.voxels[voxels[i]]); });
        texture = device_.makeTexture(form);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, form.inside, size.x, size.y, 0, form.format, form.type, texels.data());
    });
}

void DotDrawing::uploadVoxels() {
    const glm::dvec3 middle = plan_.volume->grid().centreMm();
    places_ = voxelTexture("places", [&](const MarkVoxel& voxel) {
        return glm::vec4(glm::vec3(field_.placeMm(voxel) - middle), voxel.value);
    });
    normals_ =
        voxelTexture("normals", [](const MarkVoxel& voxel) { return glm::vec4(voxel.normalMm, voxel.gradient); });
    surfaces_ = voxelTexture("surfaces", [&](const MarkVoxel& voxel) {
        const glm::dvec3 rises = glm::dvec3(voxel.normalMm) * field_.stepMm;
        const int axis = crossingAxis(rises);
        const auto offset = static_cast<double>(voxel.edgeOffsetMm);
        const double cells = std::abs(rises[axis]) > 0 ? offset / rises[axis] : 0;
        return glm::vec4(voxel.share, voxel.edgeOffsetMm, static_cast<float>(cells), static_cast<float>(axis));
    });
}

Program& DotDrawing::program(const char* vertex, const char* fragment) {
    const auto defined = [&] {
        ProgramSource source;
        source.define("kAcross", kAcross)
            .define("CUTS", static_cast<int>(cuts_.size()))
            .define("HIDES", hides_ ? 1 : 0);
        return source;
    };
    ProgramSource first = defined();
    first.add("math.glsl").add("dot_view.glsl");
    if (std::strcmp(vertex, "dot_disc.vert") != 0) {
        first.add("dot_place.glsl");
    }
    Program& made = device_.program(first.add(vertex), defined().add(fragment));
    made.use();
    return made;
}

void DotDrawing::setView(Program& program, TextureUnits& units) {
    const ViewFrame& frame = view_.frame();
    const glm::dmat3 axes = axesOf(frame);
    program.set("paperMm", glm::vec2(view_.paperMm()));
    program.set("paperScale", static_cast<float>(view_.scale()));
    program.set("perEyeDistance", view_.linear() ? 0.0F : static_cast<float>(1 / frame.eyeDistanceMm));
    program.set("viewAxes", glm::mat3(axes));
    program.set("viewMiddle", glm::vec3(axes * (plan_.volume->grid().centreMm() - frame.targetMm)));
    program.set("stepSeen", glm::mat3(axes * field_.stepMm));
    program.set("cuts", std::span<const glm::vec4>(cuts_));
    program.set("cellMm", static_cast<float>(depth_.cellMm));
    units.bind("voxelPlaces", GL_TEXTURE_2D, places_);
    units.bind("voxelNormals", GL_TEXTURE_2D, normals_);
    units.bind("voxelSurfaces", GL_TEXTURE_2D, surfaces_);
}

/// A fragment for each voxel.
void DotDrawing::drawCounts() {
    resize(memory_.counts, voxelTexels(), kNumbers, 2);
    ProgramSource source;
    source.define("kAcross", kAcross).define("CUTS", static_cast<int>(cuts_.size()));
    source.define("FACING_ONLY", ink_.facingOnly ? 1 : 0).define("OF_LAYERS", stipple_.matter == "layers" ? 1 : 0);
    source.define("COUNT_TONE", stipple_.tone == "ink" ? 0 : 1).define("BOUNDARY", stipple_.boundary ? 1 : 0);
    source.define("SILHOUETTE", stipple_.silhouette ? 1 : 0).define("RESOLUTION", stipple_.resolution ? 1 : 0);
    source.define("DISTANCE", stipple_.distance ? 1 : 0).define("INTERIOR", stipple_.interior ? 1 : 0);
    source.define("LIGHTING", stipple_.lighting ? 1 : 0);
    source.add("math.glsl").add("formulas.glsl").add("dot_view.glsl").add("dot_counts.frag");
    Program& counting = device_.program(wholeTarget(), source);
    counting.use();
    TextureUnits units(device_, counting);
    setView(counting, units);
    units.bind("coverage", GL_TEXTURE_2D, memory_.coverage.id());
    setCounts(counting);
    gl_.BindVertexArray(memory_.none.id());
    gl_.Viewport(0, 0, memory_.counts.size.x, memory_.counts.size.y);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void DotDrawing::setCounts(Program& program) {
    const auto curve = [](double c, double s, double e) { return glm::vec3(glm::dvec3(c, s, e)); };
    program.set("wholeScale", ink_.wholeScale);
    program.set("density", static_cast<float>(ink_.density));
    program.set("perFace", static_cast<float>(ink_.perFace));
    program.set("perPoint", static_cast<float>(1 / FacePoints(field_, stipple_).capacity()));
    program.set("fadingPart", kFadingPart);
    program.set("wholeFacing", kWholeFacing);
    program.set("smallestDot", kSmallestDot);
    program.set("fullestTone", static_cast<float>(kFullestTone));
    program.set("mostDensity", static_cast<float>(DotPattern::kMostDensity));
    program.set("largestRadius", static_cast<float>(largestRadius(plan_, view_)));
    program.set("tolerance", glm::vec2(depth_.toleranceMm, MarkDepth::kSlantTolerance));
    program.set("leastFacing", MarkDepth::kLeastFacing);
    program.set("matterRamp", glm::vec2(kFaintMatter, kFullMatter));
    program.set("centreDepth", ink_.centreDepth);
    program.set("light", ink_.light);
    if (const auto& k = stipple_.boundary) {
        program.set("boundary", curve(k->kgc, k->kgs, k->kge));
    }
    if (const auto& k = stipple_.silhouette) {
        program.set("silhouette", curve(k->ksc, k->kss, k->kse));
    }
    if (const auto& k = stipple_.resolution) {
        program.set("resolution", static_cast<float>(k->kre));
    }
    if (const auto& k = stipple_.distance) {
        program.set("distance_", glm::vec2(static_cast<float>(k->kde), ink_.halfDepth));
    }
    if (const auto& k = stipple_.interior) {
        program.set("interior", static_cast<float>(k->kte));
    }
    if (const auto& k = stipple_.lighting) {
        program.set("lighting", static_cast<float>(k->kle));
    }
}

/// A point for each voxel.
void DotDrawing::drawNearest() {
    resize(memory_.nearest, depth_.size, kNumber, 1);
    constexpr std::array<float, 4> kClear = {kNothing, kNothing, kNothing, kNothing};
    gl_.ClearBufferfv(GL_COLOR, 0, kClear.data());
    Program& covering = program("dot_disc.vert", "dot_disc.frag");
    TextureUnits units(device_, covering);
    setView(covering, units);
    const int reach = discReach(field_, depth_, memory_.cloud->headroom);
    covering.set("least", depth_.least);
    covering.set("discMm", depth_.discMm);
    covering.set("cells", glm::vec2(depth_.size));
    covering.set("guard", static_cast<float>(reach));
    gl_.BindVertexArray(memory_.none.id());
    gl_.Viewport(-reach, -reach, depth_.size.x + 2 * reach, depth_.size.y + 2 * reach);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_MAX);
    gl_.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(memory_.cloud->voxels.size()));
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.Disable(GL_BLEND);
}

void DotDrawing::setCandidates(Program& program, TextureUnits& units) {
    setView(program, units);
    const glm::mat3 steps(field_.stepMm);
    program.set("stepX", steps[0]);
    program.set("stepY", steps[1]);
    program.set("stepZ", steps[2]);
    program.set("spreadMm", FacePoints(field_, stipple_).spreadMm());
    program.set("faintest", kFaintest);
    units.bind("voxelCounts", GL_TEXTURE_2D, memory_.counts.textures[0].id());
    units.bind("voxelFaces", GL_TEXTURE_2D, memory_.counts.textures[1].id());
    if (hides_) {
        units.bind("nearest", GL_TEXTURE_2D, memory_.nearest.textures[0].id());
    }
}

void DotDrawing::drawCandidates() {
    const std::size_t count = memory_.cloud->dotCount();
    const std::uint64_t bytes = count * sizeof(DotCandidate);
    gl_.BindVertexArray(memory_.vertices.id());
    const GLuint id = device_.buffer(memory_.cloud, "dots", bytes, [&](Buffer& buffer) {
        buffer = Buffer(gl_);
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
        gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STATIC_DRAW);
        GLintptr at = 0;
        for (const auto& part : memory_.cloud->dots) {
            const auto size = static_cast<GLsizeiptr>(part.size() * sizeof(DotCandidate));
            gl_.BufferSubData(GL_ARRAY_BUFFER, at, size, part.data());
            at += size;
        }
    });
    gl_.BindBuffer(GL_ARRAY_BUFFER, id);
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(DotCandidate), at(offsetof(DotCandidate, onFace)));
    gl_.VertexAttribIPointer(1, 2, GL_UNSIGNED_INT, sizeof(DotCandidate), at(offsetof(DotCandidate, voxel)));
    gl_.EnableVertexAttribArray(0);
    gl_.EnableVertexAttribArray(1);
    for (std::size_t first = 0; first < count; first += kPiece) {
        task_.throwIfCancelled();
        gl_.DrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(std::min(kPiece, count - first)));
        gl_.Finish();
    }
}

void DotDrawing::resize(DotMemory::Target& target, glm::ivec2 size, const TextureForm& form, int textures) const {
    if (target.size != size) {
        target = {{}, Framebuffer(gl_), size};
        gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
        TextureForm sized = form;
        sized.size = {size, 1};
        std::vector<GLenum> all;
        for (int i = 0; i < textures; ++i) {
            target.textures.push_back(device_.makeTexture(sized));
            all.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
            gl_.FramebufferTexture2D(GL_FRAMEBUFFER, all.back(), GL_TEXTURE_2D, target.textures.back().id(), 0);
        }
        gl_.DrawBuffers(textures, all.data());
        device_.check("to make room for dots");
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
}

glm::ivec2 DotDrawing::voxelTexels() const { return texelsFor(memory_.cloud->voxels.size()); }

} // namespace limner::gl
