#include "renderer/marks/dot_pattern.h"
#include "renderer/marks/ink.h"
#include "renderer/marks/mixed_bits.h"

#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

constexpr std::size_t kChunk = 16384; ///< voxels that one task draws
/// A drawing is of dots, not of greys: most of them are whole.
constexpr float kFadingPart = 0.3F;
/// |n.e| at which a dot on the edge of a form is whole: none comes or goes all at once as the form turns.
constexpr float kWholeFacing = 0.03F;
constexpr float kFaintest = 0.02F; ///< opacity that nobody sees

/// A voxel's points: those of the pattern over the face of the voxel that its surface crosses most squarely, laid on
/// the tangent plane. Neighbours share the plane's pattern, so that there is no seam between them.
class VolumeDots {
  public:
    explicit VolumeDots(const MarkScene& scene) : scene_(scene), field_(scene.field) {
        const double dot = largestDotArea(scene.stipple);
        const double scale = field_.paperPerMm * field_.zoom * kZoomHeadroom;
        const double densest = DotPattern::kMostDensity / static_cast<double>(kSmallestDot * kSmallestDot);
        capacity_ = field_.mmPerVoxel * field_.mmPerVoxel * scale * scale / dot * densest;
        edge_ = std::sqrt(capacity_);
        fading_ = scene.moving || scene.stipple.placing == "volume";
        linear_ = scene.view.linear();
        spreadMm_ = static_cast<float>(scene.stipple.spreadVoxels * field_.mmPerVoxel);
        clipped_ = scene.plan.clip.boxMm || !scene.plan.clip.planes.empty();
    }

    void add(std::size_t i, std::vector<Dot>& dots) const {
        const VoxelInk& ink = scene_.ink[i];
        const MarkVoxel& voxel = field_.voxels[i];
        if (!(ink.dots > 0)) {
            return;
        }
        const auto end = static_cast<float>(static_cast<double>(ink.dots) / capacity_);
        const Frame frame = frameOf(voxel);
        // A dot fades over the last unit of N, or over a part of a smaller N: the mean ink stays N.
        const float fade = fading_ ? std::min(1 / static_cast<float>(capacity_), kFadingPart * end) : 0.0F;
        const auto perEdge = static_cast<float>(1 / edge_);
        const float edge = std::min(ink.facing / kWholeFacing, 1.0F);
        const glm::dvec2 low(frame.cell.x * edge_ + frame.offset.x, frame.cell.y * edge_ + frame.offset.y);
        dotPattern().forEachIn(
            low, low + edge_, end + 0.5F * fade, [&](const glm::vec2& place, float rank, std::uint32_t number) {
                const float shown = fade > 0 ? edge * std::min((end - rank) / fade + 0.5F, 1.0F) : 1.0F;
                const glm::vec2 f = place * perEdge - 0.5F;
                addDot(i, frame, f, number, shown, dots);
            });
    }

  private:
    static constexpr double kZoomHeadroom = 1.5; ///< a field serves views up to the square root of 2 nearer

    struct Frame {
        glm::dvec2 cell{0};
        glm::dvec2 offset{0}; ///< of the plane's pattern
        glm::dvec3 middleMm{0};
        glm::dmat3 acrossMm{0}; ///< columns: the face's edges, a mm of the normal
        PlaceOnPaper middle;    ///< on paper
        glm::mat3 paper{0};     ///< columns: what these steps change on paper (mm right, mm down, depth), parallel rays
    };

    [[nodiscard]] Frame frameOf(const MarkVoxel& voxel) const {
        Frame frame;
        const MarkFace face = field_.faceOf(voxel);
        frame.acrossMm = glm::dmat3(face.edgeMm[0], face.edgeMm[1], glm::dvec3(voxel.normalMm));
        frame.cell = {static_cast<double>(voxel.cell[face.across[0]]), static_cast<double>(voxel.cell[face.across[1]])};
        // A body's front and back have patterns of their own: they may lie behind one another.
        const auto side = static_cast<std::uint32_t>(2 * face.axis + (face.rising ? 1 : 0));
        frame.offset = DotPattern::offsetOf(mixedBits(seedBits(scene_.stipple) + side));
        frame.middleMm = face.middleMm;
        frame.middle = scene_.view.place(frame.middleMm);
        if (scene_.view.linear()) {
            const float scale = frame.middle.scale;
            for (int k = 0; k < 3; ++k) {
                frame.paper[k] = scene_.view.seen(glm::vec3(frame.acrossMm[k])) * glm::vec3(scale, -scale, 1);
            }
        }
        return frame;
    }

    static PlaceOnPaper placed(const Frame& frame, const glm::vec3& step) {
        const glm::vec3 moved = frame.paper * step;
        return {frame.middle.mm + glm::vec2(moved), frame.middle.depthMm + moved.z, frame.middle.scale};
    }

    void addDot(std::size_t i, const Frame& frame, const glm::vec2& f, std::uint32_t number, float shown,
                std::vector<Dot>& dots) const {
        const float jitter = static_cast<float>(number >> 16) * 0x1p-15F - 1;
        const glm::vec3 step(f.x, f.y, jitter * spreadMm_);
        const auto inSpace = [&] { return frame.middleMm + frame.acrossMm * glm::dvec3(step); };
        if (clipped_ && !scene_.view.kept(inSpace())) {
            return;
        }
        const PlaceOnPaper at = linear_ ? placed(frame, step) : scene_.view.place(inSpace());
        float opacity = shown * scene_.depth.visible(at, scene_.ink[i].facing);
        if (!fading_) {
            opacity = opacity >= 0.5F ? 1.0F : 0.0F;
        }
        if (opacity >= kFaintest && at.scale > 0) {
            dots.push_back({at.mm, at.depthMm, scene_.ink[i].radiusMm, opacity, scene_.colourOf(i)});
        }
    }

    const MarkScene& scene_;
    const MarkField& field_;
    double capacity_ = 1; ///< points of a voxel's face in the pattern
    double edge_ = 1;     ///< of the face in the pattern's plane
    bool fading_ = false;
    bool clipped_ = false;
    bool linear_ = true; ///< the view's rays are parallel
    float spreadMm_ = 0; ///< of dots before and behind the surface
};

} // namespace

void addDotsOnVolume(const MarkScene& scene, Marks& marks, Task& task) {
    const VolumeDots volume(scene);
    const std::size_t layers = scene.field.layerNames.size();
    const std::size_t chunks = (scene.field.voxels.size() + kChunk - 1) / kChunk;
    std::vector<std::vector<Dot>> dots(chunks * layers);
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
        const std::size_t last = std::min((chunk + 1) * kChunk, scene.field.voxels.size());
        if (layers == 1) {
            float expected = 0;
            for (std::size_t i = chunk * kChunk; i < last; ++i) {
                expected += scene.ink[i].dots;
            }
            dots[chunk].reserve(static_cast<std::size_t>(1.2F * expected) + 64);
        }
        for (std::size_t i = chunk * kChunk; i < last && !task.cancelled(); ++i) {
            volume.add(i, dots[chunk * layers + scene.field.voxels[i].layer]);
        }
    });
    task.throwIfCancelled();
    for (std::size_t layer = 0; layer < layers; ++layer) {
        const std::string name = scene.field.groupName("Stipples", layer);
        MarkGroup whole;
        whole.name = name;
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
            std::vector<Dot>& part = dots[chunk * layers + layer];
            if (scene.moving && !part.empty()) {
                marks.groups.push_back({name, std::move(part), {}, {}}); // nobody counts groups: no copy
            } else {
                whole.dots.insert(whole.dots.end(), part.begin(), part.end());
            }
        }
        if (!whole.dots.empty()) {
            marks.groups.push_back(std::move(whole));
        }
    }
}

} // namespace limner
