#include "renderer/plan/depth_cues.h"

#include "core/figure/light_frame.h"
#include "renderer/plan/coarse_opacity.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace limner {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr int kAmbientCells = 96; ///< on the longest axis: hollows are soft
constexpr int kEdgeCells = 160;   ///< halos and shadows have an edge
constexpr int kDraftCells = 64;   ///< ... which a moving picture may blur: an eighth of the time and less

/// A sweep along one direction, slice by slice from where the light comes.
class Sweep {
  public:
    Sweep(const CueField& opacity, const Grid& grid, const glm::dvec3& towardsMm, double reachMm)
        : dims_(opacity.dims) {
        const glm::dvec3 cells = grid.mmToVoxelMatrix() * towardsMm / static_cast<double>(opacity.voxelsPerCell);
        const glm::dvec3 size = glm::abs(cells);
        main_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        for (int i = 0, k = 0; i < 3; ++i) {
            if (i != main_) {
                across_[k] = i;
                shift_[k++] = cells[i] / size[main_];
            }
        }
        rising_ = cells[main_] > 0; // the light is at the far end: slices run down
        const double stepMm = 1 / size[main_];
        keep_ = static_cast<float>(std::exp(-stepMm / reachMm));
    }

    [[nodiscard]] std::vector<float> run(const std::vector<float>& opacity) const {
        std::vector<float> occlusion(opacity.size(), 0.0F);
        const int slices = dims_[main_];
        const auto plane = static_cast<std::size_t>(width() + 1) * static_cast<std::size_t>(height() + 1);
        std::vector<float> behind(plane, 0.0F); // one more of zeros along both axes
        for (int i = 0; i < slices; ++i) {
            const int slice = rising_ ? slices - 1 - i : i;
            if (i > 0) {
                project(behind, slice, occlusion);
            }
            gather(opacity, occlusion, slice, behind);
        }
        return occlusion;
    }

  private:
    [[nodiscard]] int width() const { return dims_[across_[0]]; }
    [[nodiscard]] int height() const { return dims_[across_[1]]; }
    [[nodiscard]] std::ptrdiff_t stride(int axis) const {
        return axis == 0 ? 1 : axis == 1 ? dims_.x : static_cast<std::ptrdiff_t>(dims_.x) * dims_.y;
    }

    /// What a slice and all before it take from the next.
    void gather(const std::vector<float>& opacity, const std::vector<float>& occlusion, int slice,
                std::vector<float>& behind) const {
        const std::ptrdiff_t first = slice * stride(main_);
        for (int v = 0; v < height(); ++v) {
            const std::ptrdiff_t row = first + v * stride(across_[1]);
            float* out = behind.data() + static_cast<std::ptrdiff_t>(v) * (width() + 1);
            for (int u = 0; u < width(); ++u) {
                const auto cell = static_cast<std::size_t>(row + u * stride(across_[0]));
                out[u] = opacity[cell] + (1 - opacity[cell]) * keep_ * occlusion[cell];
            }
        }
    }

    /// The slice's occlusion: the one before, read where the direction leads, bilinear; beside it there is light.
    void project(const std::vector<float>& behind, int slice, std::vector<float>& occlusion) const {
        const int du = static_cast<int>(std::floor(shift_[0]));
        const int dv = static_cast<int>(std::floor(shift_[1]));
        const auto fu = static_cast<float>(shift_[0] - du);
        const auto fv = static_cast<float>(shift_[1] - dv);
        const std::ptrdiff_t pitch = width() + 1;
        for (int v = std::max(0, -dv); v < height() && v + dv < height(); ++v) {
            const float* low = behind.data() + (v + dv) * pitch;
            const float* high = low + pitch;
            float* out = occlusion.data() + slice * stride(main_) + v * stride(across_[1]);
            for (int u = std::max(0, -du); u < width() && u + du < width(); ++u) {
                const int at = u + du;
                const float near = low[at] + fu * (low[at + 1] - low[at]);
                const float far = high[at] + fu * (high[at + 1] - high[at]);
                out[u * stride(across_[0])] = near + fv * (far - near);
            }
        }
    }

    glm::ivec3 dims_;
    int main_ = 0;
    int across_[2]{};
    double shift_[2]{};
    bool rising_ = false;
    float keep_ = 1;
};

/// Calls `add(i, occlusion)` for every direction, in their order, whatever thread swept it.
template <typename Add>
void sweepAll(const CueField& opacity, const Grid& grid, const std::vector<std::pair<glm::dvec3, double>>& sweeps,
              Task& task, const Add& add) {
    constexpr std::size_t kAtOnce = 8; // buffers held
    for (std::size_t first = 0; first < sweeps.size(); first += kAtOnce) {
        task.throwIfCancelled();
        const std::size_t count = std::min(kAtOnce, sweeps.size() - first);
        std::vector<std::vector<float>> results(count);
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
            if (task.cancelled()) {
                results[i].resize(opacity.values.size());
                return;
            }
            const auto& [direction, reach] = sweeps[first + i];
            results[i] = occlusionTowards(opacity, grid, direction, reach);
        });
        tbb::parallel_for(std::size_t{0}, opacity.values.size(), [&](std::size_t cell) {
            for (std::size_t i = 0; i < count; ++i) {
                add(first + i, cell, results[i][cell]);
            }
        });
    }
    task.throwIfCancelled();
}

CueField emptyLike(const CueField& opacity, int channels) {
    return {opacity.dims, opacity.voxelsPerCell, channels,
            std::vector<float>(opacity.values.size() * static_cast<std::size_t>(channels), 0.0F)};
}

/// The 26 directions to a cube's corners, edges and faces, weighted by the solid angle nearest to each: faces 0.0476,
/// edges 0.0381, corners 0.0321 of the sphere (the weights that integrate polynomials of degree 5 exactly are 1/21,
/// 4/105, 9/280).
struct CubeDirection {
    glm::dvec3 unit;
    double weight;
};
std::vector<CubeDirection> cubeDirections() {
    std::vector<CubeDirection> directions;
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const double squared = glm::dot(d, d);
        if (squared > 0) {
            directions.push_back({d / std::sqrt(squared), squared < 1.5   ? 1.0 / 21
                                                          : squared < 2.5 ? 4.0 / 105
                                                                          : 9.0 / 280});
        }
    }
    return directions;
}

CueField ambientField(const CueField& opacity, const Grid& grid, double reachMm, Task& task) {
    CueField field = emptyLike(opacity, 4);
    const std::vector<CubeDirection> directions = cubeDirections();
    std::vector<std::pair<glm::dvec3, double>> sweeps;
    for (const CubeDirection& direction : directions) {
        sweeps.emplace_back(direction.unit, reachMm);
    }
    sweepAll(opacity, grid, sweeps, task, [&](std::size_t i, std::size_t cell, float occlusion) {
        const glm::vec3 unit(directions[i].unit);
        const float share = occlusion * static_cast<float>(directions[i].weight);
        float* out = &field.values[4 * cell];
        out[0] += share;
        for (int axis = 0; axis < 3; ++axis) {
            out[1 + axis] += share * unit[axis];
        }
    });
    return field;
}

/// Directions around one, at an angle.
std::vector<glm::dvec3> ringAround(const glm::dvec3& axis, double angle, int count) {
    const glm::dvec3 other = std::abs(axis.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, other));
    const glm::dvec3 v = glm::cross(axis, u);
    std::vector<glm::dvec3> ring;
    for (int i = 0; i < count; ++i) {
        const double turn = 2 * 3.14159265358979323846 * i / count;
        ring.push_back(std::cos(angle) * axis + std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v));
    }
    return ring;
}

/// Mean over a cone of light.
CueField shadowField(const CueField& opacity, const Grid& grid, const glm::dvec3& lightMm, double softDeg,
                     double reachMm, Task& task) {
    CueField field = emptyLike(opacity, 1);
    std::vector<std::pair<glm::dvec3, double>> sweeps{{lightMm, reachMm}};
    if (softDeg > 0) {
        constexpr double kMiddle = 0.7; // of the cone's half angle: half of its solid angle lies inside
        for (const glm::dvec3& direction : ringAround(lightMm, kMiddle * glm::radians(softDeg), 6)) {
            sweeps.emplace_back(direction, reachMm);
        }
    }
    const float share = 1.0F / static_cast<float>(sweeps.size());
    sweepAll(opacity, grid, sweeps, task,
             [&](std::size_t, std::size_t cell, float occlusion) { field.values[cell] += share * occlusion; });
    return field;
}

/// What lies well in front of a place's surroundings and not of the place itself: occlusion towards the viewer, near
/// matter (within depthMm) less, on a ring around the line of sight less on it; at `depthMm` behind an edge the ring is
/// `widthMm` wide.
CueField haloField(const CueField& opacity, const Grid& grid, const glm::dvec3& viewerMm, double widthMm,
                   double depthMm, Task& task) {
    constexpr int kRing = 8;
    CueField field = emptyLike(opacity, 1);
    std::vector<glm::dvec3> directions = ringAround(viewerMm, std::atan2(widthMm, depthMm), kRing);
    directions.push_back(viewerMm);
    std::vector<std::pair<glm::dvec3, double>> sweeps;
    for (const glm::dvec3& direction : directions) {
        sweeps.emplace_back(direction, kUnbounded);
        sweeps.emplace_back(direction, depthMm);
    }
    sweepAll(opacity, grid, sweeps, task, [&](std::size_t i, std::size_t cell, float occlusion) {
        const float sign = i % 2 == 0 ? 1.0F : -1.0F;
        const float weight = i / 2 < kRing ? 2.0F / kRing : -2.0F; // an edge takes half of the ring
        field.values[cell] += sign * weight * occlusion;
    });
    for (float& v : field.values) {
        v = std::clamp(v, 0.0F, 1.0F);
    }
    return field;
}

} // namespace

std::vector<float> occlusionTowards(const CueField& opacity, const Grid& grid, const glm::dvec3& towardsMm,
                                    double reachMm) {
    return Sweep(opacity, grid, towardsMm, reachMm).run(opacity.values);
}

namespace {

/// The drawn layers without what does not change their opacity: a new colour must not sweep anew.
std::vector<Layer> whatMakesOpaque(const RenderPlan& plan) {
    std::vector<Layer> layers;
    for (const PlanLayer& planned : plan.layers) {
        const Layer& source = *planned.source;
        Layer layer;
        layer.opacity = source.opacity;
        layer.transfer = source.transfer;
        layer.transfer.nodes.clear();
        if (layer.transfer.grid) {
            layer.transfer.grid->styles.clear();
        }
        layer.gradientOpacity = source.gradientOpacity;
        layer.position = source.position;
        layer.labels = source.labels;
        layer.clip = source.clip;
        layers.push_back(std::move(layer));
    }
    return layers;
}

} // namespace

bool readNormals(const std::optional<DepthCues>& cues) {
    return cues && ((cues->ambientOcclusion && cues->ambientOcclusion->strength > 0) ||
                    (cues->shadow && cues->shadow->strength > 0));
}

const DepthCueFields::Field& DepthCueFields::opacity(const RenderPlan& plan, int mostCells, Task& task) {
    const int voxels = voxelsPerCell(plan.volume->grid(), mostCells);
    const bool fades = std::any_of(plan.layers.begin(), plan.layers.end(), [](const PlanLayer& layer) {
        return layer.parts && layer.parts->position && layer.parts->position->axis == "view";
    });
    const glm::dvec3 view = fades ? plan.figure->camera.direction : glm::dvec3(0);
    return opacities_.get({plan.volume, plan.labels, whatMakesOpaque(plan), plan.clip, view, voxels}, [&] {
        CueField field = coarseOpacity(plan, voxels, task);
        smooth(field);
        return std::make_shared<const CueField>(std::move(field));
    });
}

void DepthCueFields::add(RenderPlan& plan, CueDetail detail, Task& task) {
    if (!plan.figure->depthCues || plan.layers.empty()) {
        return;
    }
    const DepthCues& source = *plan.figure->depthCues;
    const Grid& grid = plan.volume->grid();
    const int edgeCells = detail == CueDetail::draft ? kDraftCells : kEdgeCells;
    PlanDepthCues cues;
    cues.source = &source;
    const auto kept = [](CueField field) { return std::make_shared<const CueField>(std::move(field)); };
    if (source.ambientOcclusion && source.ambientOcclusion->strength > 0) {
        const Field& coarse = opacity(plan, kAmbientCells, task);
        const double reach = source.ambientOcclusion->reachMm;
        cues.ambient = ambient_.get({coarse, reach}, [&] { return kept(ambientField(*coarse, grid, reach, task)); });
    }
    const glm::dmat3 mmFromEye = glm::transpose(plan.rays.eyeFromMm);
    if (source.shadow && source.shadow->strength > 0) {
        const Field& coarse = opacity(plan, edgeCells, task);
        const ContactShadow& shadow = *source.shadow;
        cues.lightEye = lightSeen(shadow.light, plan.figure->camera);
        // An object's light by its own numbers: turned to the eye and back it would differ from view to view.
        const bool own = shadow.light.kind == "object" && glm::length(shadow.light.direction) > 0;
        const glm::dvec3 light = own ? glm::normalize(shadow.light.direction) : mmFromEye * cues.lightEye;
        cues.shadow = shadow_.get({coarse, light, shadow.softDeg, shadow.reachMm}, [&] {
            return kept(shadowField(*coarse, grid, light, shadow.softDeg, shadow.reachMm, task));
        });
    }
    if (source.halo && source.halo->strength > 0 && !plan.rays.perspective) { // swept along parallel rays
        const Field& coarse = opacity(plan, edgeCells, task);
        const double width =
            source.halo->widthMm * plan.figure->camera.heightMm / plan.figure->output.heightMm; // on the object
        const glm::dvec3 viewer = mmFromEye[2];
        cues.halo = halo_.get({coarse, viewer, width, source.halo->depthMm}, [&] {
            return kept(haloField(*coarse, grid, viewer, width, source.halo->depthMm, task));
        });
    }
    if (cues.ambient || cues.shadow || cues.halo) {
        plan.cues = std::move(cues);
    }
}

} // namespace limner
