#include "renderer/marks/mark_field.h"

#include "core/base/error.h"
#include "core/figure/view_frame.h"
#include "renderer/marks/coarse_values.h"
#include "renderer/plan/coarse_opacity.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limner {

namespace {

/// Edge of a mark voxel on paper, in diameters of the largest dots. Moving: the paper's five pixels at dots of two.
/// Still: its reason, a voxel's points are to make a pattern, is not ours, whose pattern runs through all voxels; edges
/// are sharper and small things are there.
constexpr double kDotsPerVoxelMoving = 2.5;
constexpr double kDotsPerVoxelStill = 1.5;
constexpr double kSmallestDotMm = 0.02; ///< what no press prints: finer voxels would serve nobody
constexpr double kMostCells = 48e6;     ///< of the marks' grid: two numbers each are held while it is made
constexpr double kFarthestZoom = 64;
constexpr int kReach = 10; ///< cells to either side: a boundary that is thicker has marks all the way through

/// Cells along the volume's axes, so that a mark voxel is about a cube of `edgeMm`, or short of that by `tolerance` of
/// a voxel of the volume.
glm::ivec3 cellSize(const Grid& grid, double edgeMm, double tolerance) {
    glm::ivec3 n(1);
    for (int i = 0; i < 3; ++i) {
        n[i] = static_cast<int>(
            std::clamp(std::ceil(edgeMm / grid.spacingMm[i] - tolerance), 1.0, static_cast<double>(grid.dims[i])));
    }
    return n;
}

double cellsOf(const Grid& grid, const glm::ivec3& n) {
    const glm::ivec3 cells = (grid.dims + n - 1) / n;
    return static_cast<double>(cells.x) * cells.y * cells.z;
}

/// mm on paper per mm of the volume where the whole volume just shows.
double wholeViewScale(const RenderPlan& plan) {
    const glm::dvec3 size = plan.volume->grid().sizeMm();
    const Output& output = plan.figure->output;
    return std::min(output.widthMm, output.heightMm) / std::max({size.x, size.y, size.z});
}

/// What is computed before single voxels are looked at.
class FieldMaker {
  public:
    FieldMaker(const RenderPlan& plan, const MarkDetail& detail, Task& task)
        : plan_(plan), stipple_(*plan.figure->stipple), task_(task), field_(std::make_shared<MarkField>()) {
        chooseGrid(detail);
    }

    std::shared_ptr<const MarkField> run() {
        values_ = boxFiltered(*plan_.volume, field_->voxelsPerCell, task_);
        task_.progress(0.2);
        addOpacity();
        task_.progress(0.3);
        measureGradients();
        task_.progress(0.5);
        collect();
        task_.progress(0.7);
        tbb::parallel_for(std::size_t{0}, field_->voxels.size(), [&](std::size_t i) { complete(i); });
        task_.throwIfCancelled();
        if (field_->voxels.empty()) {
            field_->warnings.push_back("no voxel has enough gradient for marks of ink: lower /stipple/threshold");
        }
        return field_;
    }

  private:
    void chooseGrid(const MarkDetail& detail) {
        const Grid& grid = plan_.volume->grid();
        double edge = (detail.moving ? kDotsPerVoxelMoving : kDotsPerVoxelStill) *
                      std::max(stipple_.sizeMm, kSmallestDotMm) / (wholeViewScale(plan_) * detail.zoom);
        const double tolerance = detail.moving ? 0.05 : 0.25;
        glm::ivec3 n = cellSize(grid, edge, tolerance);
        for (; cellsOf(grid, n) > kMostCells; n = cellSize(grid, edge, tolerance)) {
            edge = std::max(edge, grid.smallestSpacingMm()) * 1.25;
        }
        constexpr int most = std::numeric_limits<std::uint16_t>::max();
        field_->voxelsPerCell = n;
        field_->grid = coarseGrid(grid, n);
        field_->stepMm = field_->grid.voxelToMmMatrix();
        if (glm::any(glm::greaterThan(field_->grid.dims, glm::ivec3(most)))) {
            throw Error(ErrorKind::badInput, {"the volume is too long for marks of ink", "/volume",
                                              "an axis has over 65535 voxels", "crop or resample it"});
        }
        const glm::dvec3 s = field_->grid.spacingMm;
        field_->mmPerVoxel = std::cbrt(s.x * s.y * s.z);
        field_->paperPerMm = wholeViewScale(plan_);
        field_->zoom = detail.zoom;
        mmFromIndex_ = glm::mat3(glm::transpose(glm::inverse(field_->grid.voxelToMmMatrix())));
    }

    /// v where the layers are the matter, and which layer it is of.
    void addOpacity() {
        field_->layerNames = {""};
        if (stipple_.matter != "layers") {
            return;
        }
        field_->layerNames.clear();
        const glm::ivec3 n = field_->voxelsPerCell;
        const int voxels = std::min({n.x, n.y, n.z});
        for (const PlanLayer& layer : plan_.layers) {
            RenderPlan alone = plan_;
            alone.layers = {layer};
            opacity_.push_back(coarseOpacity(alone, voxels, task_));
            smooth(opacity_.back());
            field_->layerNames.push_back(layer.name);
            if (field_->layerNames.size() == std::numeric_limits<std::uint8_t>::max()) {
                break;
            }
        }
    }

    /// Opacity of one layer at a mark voxel.
    [[nodiscard]] float opacityAt(const CueField& field, const glm::ivec3& cell) const {
        const glm::dvec3 voxel = glm::dvec3(cell * field_->voxelsPerCell) + 0.5 * glm::dvec3(field_->voxelsPerCell - 1);
        const glm::ivec3 c = glm::clamp(glm::ivec3((voxel + 0.5) / static_cast<double>(field.voxelsPerCell)),
                                        glm::ivec3(0), field.dims - 1);
        return field.values[(static_cast<std::size_t>(c.z) * static_cast<std::size_t>(field.dims.y) +
                             static_cast<std::size_t>(c.y)) *
                                static_cast<std::size_t>(field.dims.x) +
                            static_cast<std::size_t>(c.x)];
    }

    struct Matter {
        float value = 0;
        std::uint8_t layer = 0;
    };
    [[nodiscard]] Matter matterAt(const glm::ivec3& cell, float dataValue) const {
        if (stipple_.matter != "layers") {
            return {dataValue, 0};
        }
        Matter matter;
        float clear = 1;
        float largest = 0;
        for (std::size_t i = 0; i < opacity_.size(); ++i) {
            const float opacity = opacityAt(opacity_[i], cell);
            clear *= 1 - opacity;
            if (opacity > largest) {
                largest = opacity;
                matter.layer = static_cast<std::uint8_t>(i);
            }
        }
        matter.value = 1 - clear;
        return matter;
    }

    [[nodiscard]] CellSlope slopeAt(const glm::ivec3& cell) const {
        return stipple_.gradient == "central" ? centralSlope(values_, cell) : neumannSlope(values_, cell);
    }

    /// Gradient magnitudes per mm of all cells; their 99.9th percentile.
    void measureGradients() {
        const glm::ivec3 dims = values_.dims();
        magnitudes_ = CoarseValues(dims);
        tbb::parallel_for(0, dims.z, [&](int z) {
            if (task_.cancelled()) {
                return;
            }
            for (int y = 0; y < dims.y; ++y) {
                float* out = magnitudes_.row(y, z);
                for (int x = 0; x < dims.x; ++x) {
                    out[x] = glm::length(mmFromIndex_ * slopeAt({x, y, z}).gradient);
                }
            }
        });
        task_.throwIfCancelled();
        magnitudes_.fillApron();
        std::vector<float> all;
        all.reserve(static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) *
                    static_cast<std::size_t>(dims.z));
        for (int z = 0; z < dims.z; ++z) {
            for (int y = 0; y < dims.y; ++y) {
                all.insert(all.end(), magnitudes_.row(y, z), magnitudes_.row(y, z) + dims.x);
            }
        }
        const auto place = all.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(all.size() - 1) * 0.999);
        std::nth_element(all.begin(), place, all.end());
        // Where a thousandth of a large empty scan is all there is, the largest counts.
        largest_ = *place > 0 ? *place : *std::max_element(all.begin(), all.end());
    }

    /// The cells that get marks, row by row.
    void collect() {
        const glm::ivec3 dims = values_.dims();
        const auto rows = static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z);
        field_->rowStart.assign(rows + 1, 0);
        if (!(largest_ > 0)) {
            return;
        }
        least_ = std::max(static_cast<float>(stipple_.threshold), 1e-6F) * largest_;
        std::vector<std::vector<MarkVoxel>> slices(static_cast<std::size_t>(dims.z));
        tbb::parallel_for(0, dims.z, [&](int z) {
            auto& slice = slices[static_cast<std::size_t>(z)];
            for (int y = 0; y < dims.y; ++y) {
                const float* magnitudes = magnitudes_.row(y, z);
                const std::size_t before = slice.size();
                for (int x = 0; x < dims.x; ++x) {
                    if (magnitudes[x] >= least_) {
                        MarkVoxel voxel;
                        voxel.cell = glm::u16vec3(x, y, z);
                        slice.push_back(voxel);
                    }
                }
                field_->rowStart[static_cast<std::size_t>(z) * static_cast<std::size_t>(dims.y) +
                                 static_cast<std::size_t>(y) + 1] = static_cast<std::uint32_t>(slice.size() - before);
            }
        });
        for (std::size_t i = 0; i < rows; ++i) {
            field_->rowStart[i + 1] += field_->rowStart[i];
        }
        field_->voxels.reserve(field_->rowStart.back());
        for (const auto& slice : slices) {
            field_->voxels.insert(field_->voxels.end(), slice.begin(), slice.end());
        }
        if (stipple_.innerLines || stipple_.hatching || stipple_.curves) {
            field_->curvatures.resize(field_->voxels.size());
        }
    }

    void complete(std::size_t i) {
        if (task_.cancelled()) {
            return;
        }
        MarkVoxel& voxel = field_->voxels[i];
        const glm::ivec3 cell(voxel.cell);
        const CellSlope slope = slopeAt(cell);
        const glm::vec3 g = mmFromIndex_ * slope.gradient;
        voxel.normalMm = -g / std::max(glm::length(g), std::numeric_limits<float>::min());
        voxel.layer = matterAt(cell, slope.value).layer;
        if (stipple_.curves) {
            voxel.edge = laplacianOfGaussian(values_, cell);
        }
        lookThroughSurface(voxel);
        if (!field_->curvatures.empty()) {
            field_->curvatures[i] = curvatureAt(cell, g);
        }
    }

    /// Cells of a column on one side of a cell that are of its surface.
    struct Side {
        double weight = 0;
        double value = 0;   ///< times weight
        double data = 0;    ///< the same of the scan's own value over its range
        double largest = 0; ///< weight
        float magnitude = 0;
    };

    /// What a cell counts in its surface, 0 where it has no marks: matter counts more than what is around it.
    [[nodiscard]] Side weightAt(const glm::ivec3& cell) const {
        if (glm::any(glm::lessThan(cell, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(cell, values_.dims()))) {
            return {};
        }
        Side side;
        side.magnitude = magnitudes_.at(cell.x, cell.y, cell.z);
        if (side.magnitude >= least_) {
            const float data = values_.at(cell.x, cell.y, cell.z);
            const auto v = static_cast<double>(matterAt(cell, data).value);
            side.weight = static_cast<double>(side.magnitude) * v;
            side.value = side.weight * v;
            side.data = side.weight * static_cast<double>(data);
        }
        return side;
    }

    [[nodiscard]] Side side(glm::ivec3 cell, const Side& own, int axis, int step) const {
        Side sum;
        double before = own.weight;
        bool falling = false;
        for (int k = 1; k <= kReach; ++k) {
            cell[axis] += step;
            const Side next = weightAt(cell);
            if (!(next.weight > 0) || (falling && next.weight > before)) {
                break; // out of it, or another surface
            }
            falling = falling || next.weight < before;
            sum.weight += next.weight;
            sum.value += next.value;
            sum.data += next.data;
            sum.largest = std::max(sum.largest, next.weight);
            sum.magnitude = std::max(sum.magnitude, next.magnitude);
            before = next.weight;
        }
        return sum;
    }

    /// To where the gradient is largest along an axis: uphill to the largest cell, then a parabola. The same place for
    /// all cells of a column.
    [[nodiscard]] float cellsToEdge(const glm::ivec3& from, int axis) const {
        const auto magnitude = [&](int cells) {
            glm::ivec3 cell = from;
            cell[axis] = std::clamp(cell[axis] + cells, 0, values_.dims()[axis] - 1);
            return magnitudes_.at(cell.x, cell.y, cell.z);
        };
        int top = 0;
        const int step = magnitude(1) > magnitude(-1) ? 1 : -1;
        while (std::abs(top) < kReach && magnitude(top + step) > magnitude(top)) {
            top += step;
        }
        const float bend = magnitude(top - 1) - 2 * magnitude(top) + magnitude(top + 1);
        const float offset = bend < 0 ? 0.5F * (magnitude(top - 1) - magnitude(top + 1)) / bend : 0.0F;
        return static_cast<float>(top) + std::clamp(offset, -0.5F, 0.5F);
    }

    /// What the surface is that the voxel is of: value and gradient over the column of cells along the axis that
    /// crosses it most squarely; and whether the voxel is the one that draws it.
    void lookThroughSurface(MarkVoxel& voxel) const {
        const glm::dvec3 rises = glm::dvec3(voxel.normalMm) * field_->stepMm; // mm along the normal per cell
        const int axis = crossingAxis(rises);
        const glm::ivec3 cell(voxel.cell);
        const Side own = weightAt(cell);
        const Side low = side(cell, own, axis, -1);
        const Side high = side(cell, own, axis, 1);
        const double sum = low.weight + own.weight + high.weight;
        if (!(own.weight > 0)) {
            return; // beside matter
        }
        voxel.value = static_cast<float>((low.value + own.value + high.value) / sum);
        const ValueRange range = plan_.volume->range();
        voxel.dataValue =
            static_cast<float>(range.low + (low.data + own.data + high.data) / sum * (range.high - range.low));
        voxel.gradient = std::min(std::max({low.magnitude, own.magnitude, high.magnitude}) / largest_, 1.0F);
        voxel.edgeOffsetMm = cellsToEdge(cell, axis) * static_cast<float>(rises[axis]);
        // The surface over a face, in faces of a cube of the cell's volume.
        const glm::dvec3 s = field_->grid.spacingMm;
        const double face = s.x * s.y * s.z / (s[axis] * field_->mmPerVoxel * field_->mmPerVoxel);
        const double slant = s[axis] / std::max(std::abs(rises[axis]), 0.5 * s[axis]);
        if (own.weight > low.largest && own.weight >= high.largest) {
            voxel.share = static_cast<float>(face * slant);
        }
    }

    /// Principal curvatures of the level surface: the gradient's own slope, in the tangent plane, over its length.
    [[nodiscard]] MarkCurvature curvatureAt(const glm::ivec3& cell, const glm::vec3& g) const {
        glm::mat3 index(0);
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 step(0);
            step[axis] = 1;
            const glm::ivec3 low = glm::max(cell - step, glm::ivec3(0));
            const glm::ivec3 high = glm::min(cell + step, values_.dims() - 1);
            const int apart = high[axis] - low[axis];
            if (apart > 0) {
                index[axis] = (neumannSlope(values_, high).gradient - neumannSlope(values_, low).gradient) /
                              static_cast<float>(apart);
            }
        }
        const glm::mat3 hessian =
            mmFromIndex_ * (0.5F * (index + glm::transpose(index))) * glm::transpose(mmFromIndex_);
        const float length = glm::length(g);
        if (!(length > 0)) {
            return {};
        }
        const glm::vec3 n = g / length;
        const glm::vec3 u = glm::normalize(std::abs(n.x) < 0.6F ? glm::cross(n, glm::vec3(1, 0, 0))
                                                                : glm::cross(n, glm::vec3(0, 1, 0)));
        const glm::vec3 w = glm::cross(n, u);
        const float uu = -glm::dot(u, hessian * u) / length;
        const float uw = -glm::dot(u, hessian * w) / length;
        const float ww = -glm::dot(w, hessian * w) / length;
        const float mean = 0.5F * (uu + ww);
        const float apart = std::hypot(0.5F * (uu - ww), uw);
        MarkCurvature curvature;
        curvature.most = mean >= 0 ? mean + apart : mean - apart;
        curvature.least = mean >= 0 ? mean - apart : mean + apart;
        // Directions of a sphere or a plane are anybody's.
        if (apart > 0.05F * std::abs(curvature.most)) {
            const float half = 0.5F * std::atan2(uw, 0.5F * (uu - ww));
            const float angle = mean >= 0 ? half : half + 0.5F * std::numbers::pi_v<float>;
            curvature.directionMm = std::cos(angle) * u + std::sin(angle) * w;
        }
        return curvature;
    }

    const RenderPlan& plan_;
    const Stipple& stipple_;
    Task& task_;
    std::shared_ptr<MarkField> field_;
    glm::mat3 mmFromIndex_{1}; ///< gradients per mm in patient coordinates from those per cell along the axes
    CoarseValues values_;
    CoarseValues magnitudes_;
    float largest_ = 0; ///< 99.9th percentile
    float least_ = 0;   ///< of a cell with marks
    std::vector<CueField> opacity_;
};

} // namespace

std::size_t MarkField::bytes() const {
    return voxels.size() * sizeof(MarkVoxel) + curvatures.size() * sizeof(MarkCurvature) +
           rowStart.size() * sizeof(std::uint32_t);
}

int crossingAxis(const glm::dvec3& risesMm) {
    const glm::dvec3 size = glm::abs(risesMm);
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

MarkFace MarkField::faceOf(const MarkVoxel& voxel) const {
    const glm::dvec3 rises = glm::dvec3(voxel.normalMm) * stepMm;
    MarkFace face;
    face.axis = crossingAxis(rises);
    face.rising = rises[face.axis] > 0;
    face.middleMm = placeMm(voxel);
    const glm::dvec3 up = stepMm[face.axis];
    const double rise = rises[face.axis];
    if (std::abs(rise) > 0) {
        face.middleMm += up * (static_cast<double>(voxel.edgeOffsetMm) / rise);
    }
    for (int i = 0, k = 0; i < 3; ++i) {
        if (i != face.axis) {
            face.across[k] = i;
            face.edgeMm[k++] = stepMm[i] - (std::abs(rise) > 0 ? rises[i] / rise : 0) * up;
        }
    }
    return face;
}

std::string MarkField::groupName(const std::string& family, std::size_t layer) const {
    const std::string name = layer < layerNames.size() ? layerNames[layer] : "";
    return name.empty() ? family : family + " - " + name;
}

std::int64_t MarkField::find(const glm::ivec3& cell) const {
    if (glm::any(glm::lessThan(cell, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(cell, grid.dims))) {
        return -1;
    }
    const std::size_t row =
        static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(grid.dims.y) + static_cast<std::size_t>(cell.y);
    const auto first = voxels.begin() + rowStart[row];
    const auto last = voxels.begin() + rowStart[row + 1];
    const auto found = std::lower_bound(
        first, last, cell.x, [](const MarkVoxel& voxel, int x) { return static_cast<int>(voxel.cell.x) < x; });
    return found != last && static_cast<int>(found->cell.x) == cell.x ? found - voxels.begin() : -1;
}

double markZoom(const RenderPlan& plan) {
    const ViewFrame frame(plan.figure->camera, plan.figure->output.aspect());
    const double zoom = plan.figure->output.heightMm / frame.heightMm / wholeViewScale(plan);
    double scale = 1;
    while (scale < kFarthestZoom && zoom > scale * std::numbers::sqrt2) {
        scale *= 2;
    }
    return scale;
}

std::shared_ptr<const MarkField> computeMarkField(const RenderPlan& plan, const MarkDetail& detail, Task& task) {
    return FieldMaker(plan, detail, task).run();
}

} // namespace limner
