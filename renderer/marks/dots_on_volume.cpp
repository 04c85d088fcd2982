#include "renderer/marks/dot_pattern.h"
#include "renderer/marks/ink.h"
#include "renderer/marks/volume_dots.h"

#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

constexpr std::size_t kChunk = 16384; ///< voxels that one task draws

/// The voxels' points, laid on their tangent planes.
class VolumeDots {
  public:
    explicit VolumeDots(const MarkScene& scene)
        : scene_(scene), field_(scene.field), points_(scene.field, scene.stipple) {
        fading_ = scene.moving || scene.stipple.placing == "volume";
        linear_ = scene.view.linear();
        clipped_ = scene.plan.clip.boxMm || !scene.plan.clip.planes.empty();
    }

    void add(std::size_t i, std::vector<Dot>& dots) const {
        const VoxelInk& ink = scene_.ink[i];
        const MarkVoxel& voxel = field_.voxels[i];
        if (!(ink.dots > 0)) {
            return;
        }
        const auto end = static_cast<float>(static_cast<double>(ink.dots) / points_.capacity());
        const Frame frame = frameOf(voxel);
        const float fade = fading_ ? std::min(1 / static_cast<float>(points_.capacity()), kFadingPart * end) : 0.0F;
        const float edge = std::min(ink.facing / kWholeFacing, 1.0F);
        points_.forEachOf(voxel, frame.face, end + 0.5F * fade, [&](const FacePoint& point) {
            const float shown = fade > 0 ? edge * std::min((end - point.rank) / fade + 0.5F, 1.0F) : 1.0F;
            addDot(i, frame, point, shown, dots);
        });
    }

  private:
    struct Frame {
        MarkFace face;
        glm::dmat3 acrossMm{0}; ///< columns: the face's edges, a mm of the normal
        PlaceOnPaper middle;    ///< on paper
        glm::mat3 paper{0};     ///< columns: what these steps change on paper (mm right, mm down, depth), parallel rays
    };

    [[nodiscard]] Frame frameOf(const MarkVoxel& voxel) const {
        Frame frame;
        frame.face = field_.faceOf(voxel);
        frame.acrossMm = glm::dmat3(frame.face.edgeMm[0], frame.face.edgeMm[1], glm::dvec3(voxel.normalMm));
        frame.middle = scene_.view.place(frame.face.middleMm);
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

    void addDot(std::size_t i, const Frame& frame, const FacePoint& point, float shown, std::vector<Dot>& dots) const {
        const glm::vec3 step(point.onFace.x, point.onFace.y, point.chance() * points_.spreadMm());
        const auto inSpace = [&] { return frame.face.middleMm + frame.acrossMm * glm::dvec3(step); };
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
    FacePoints points_;
    bool fading_ = false;
    bool clipped_ = false;
    bool linear_ = true; ///< the view's rays are parallel
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
