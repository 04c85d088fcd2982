#include "renderer/plan/coarse_opacity.h"

#include "core/optics/layers.h"
#include "core/style/ramps.h"
#include "renderer/plan/plan_parts.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limner {

namespace {

/// A slab of values in the data's unit: slices z0 to z1, clamped to the volume.
class Slab {
  public:
    Slab(const Volume& volume, int z0, int z1) : dims_(volume.grid().dims), z0_(z0) {
        const glm::ivec3 dims = dims_;
        values_.resize(static_cast<std::size_t>(z1 - z0 + 1) * static_cast<std::size_t>(dims.x) *
                       static_cast<std::size_t>(dims.y));
        std::vector<std::byte> row(static_cast<std::size_t>(dims.x) * bytesPerVoxel(volume.type()));
        double* out = values_.data();
        for (int z = z0; z <= z1; ++z) {
            for (int y = 0; y < dims.y; ++y, out += dims.x) {
                volume.copyRow(y, std::clamp(z, 0, dims.z - 1), row.data());
                read(volume, row.data(), out);
            }
        }
    }

    [[nodiscard]] double at(int x, int y, int z) const {
        const auto column = static_cast<std::size_t>(std::clamp(x, 0, dims_.x - 1));
        const auto row = static_cast<std::size_t>(std::clamp(y, 0, dims_.y - 1));
        const auto slice = static_cast<std::size_t>(z - z0_);
        return values_[(slice * static_cast<std::size_t>(dims_.y) + row) * static_cast<std::size_t>(dims_.x) + column];
    }

    /// Data's unit per mm, by central differences.
    [[nodiscard]] double gradientAt(int x, int y, int z, const glm::dvec3& spacing) const {
        const glm::dvec3 twice(at(x + 1, y, z) - at(x - 1, y, z), at(x, y + 1, z) - at(x, y - 1, z),
                               at(x, y, z + 1) - at(x, y, z - 1));
        return glm::length(0.5 * twice / spacing);
    }

  private:
    void read(const Volume& volume, const std::byte* stored, double* out) const {
        const auto convert = [&](const auto* numbers) {
            for (int x = 0; x < dims_.x; ++x) {
                out[x] = volume.valueFromStored(static_cast<double>(numbers[x]));
            }
        };
        switch (volume.type()) {
        case VoxelType::uint8: convert(reinterpret_cast<const std::uint8_t*>(stored)); break;
        case VoxelType::int16: convert(reinterpret_cast<const std::int16_t*>(stored)); break;
        case VoxelType::float32: convert(reinterpret_cast<const float*>(stored)); break;
        }
    }

    glm::ivec3 dims_;
    int z0_;
    std::vector<double> values_; ///< a unit may be smaller than single precision knows
};

/// Opacity of a layer at a voxel, of a column as long as a cell.
class ColumnOpacity {
  public:
    ColumnOpacity(const RenderPlan& plan, const PlanLayer& layer, int voxels)
        : plan_(plan), layer_(layer), table_(layer.table), counts_(countsInCues(layer)) {
        const auto column = [&](float a) {
            return a >= 1 ? 1.0F : static_cast<float>(-std::expm1(voxels * std::log1p(-static_cast<double>(a))));
        };
        const std::vector<float>& source = table_.rows > 0 ? table_.opacity2d : table_.opacity;
        columns_.resize(source.size());
        std::transform(source.begin(), source.end(), columns_.begin(), column);
        const bool byValue = table_.axisX == TransferAxis::value;
        low_ = byValue ? entryUnit(table_.low) : table_.low;
        const double span = (byValue ? entryUnit(table_.high) : table_.high) - low_;
        perUnit_ = span != 0 ? static_cast<double>(table_.opacity.size() - 1) / span : 0;
        thins_ = layer.parts && layer.parts->gradientOpacity;
    }

    [[nodiscard]] float at(const Slab& slab, const glm::ivec3& voxel) const {
        if (!counts_) {
            return 0;
        }
        std::size_t row = 0;
        if (!layer_.shownSlots.empty() || !layer_.rowOfSlot.empty()) {
            const auto slot = static_cast<std::size_t>(plan_.labels->storedAt(voxel));
            const int own = layer_.rowOfSlot.empty() ? 0 : layer_.rowOfSlot[slot];
            if (own < 0 || (!layer_.shownSlots.empty() && layer_.shownSlots[slot] == 0)) {
                return 0;
            }
            row = static_cast<std::size_t>(own);
        }
        if (table_.rows > 0 && table_.axisY != TransferAxis::label) {
            const double share = (along(table_.axisY, slab, voxel) - table_.lowY) /
                                 std::max(table_.highY - table_.lowY, std::numeric_limits<double>::min());
            row = nearest(share * (table_.rows - 1), static_cast<std::size_t>(table_.rows));
        }
        const double entry = (along(table_.axisX, slab, voxel) - low_) * perUnit_;
        const std::size_t entries = table_.opacity.size();
        const float opacity = columns_[row * entries + nearest(entry, entries)];
        return thins_ && opacity > 0 ? opacity * gradientFactor(unitGradient(slab, voxel)) : opacity;
    }

  private:
    static std::size_t nearest(double place, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(count - 1)) + 0.5);
    }

    /// What a table's entries lie evenly over: the value, or the codes of uneven levels.
    [[nodiscard]] double entryUnit(double value) const {
        const Volume& volume = *plan_.volume;
        return volume.contents().levels.empty() ? value : volume.storedFromValue(value);
    }

    [[nodiscard]] double unitGradient(const Slab& slab, const glm::ivec3& v) const {
        return std::min(slab.gradientAt(v.x, v.y, v.z, plan_.volume->grid().spacingMm) / plan_.gradientMax, 1.0);
    }

    /// Place on an axis.
    [[nodiscard]] double along(TransferAxis axis, const Slab& slab, const glm::ivec3& voxel) const {
        switch (axis) {
        case TransferAxis::gradient: return unitGradient(slab, voxel);
        case TransferAxis::second: return plan_.secondVolume->valueAt(voxel);
        case TransferAxis::distance:
            return layer_.distance ? layer_.distance->valueAt(voxel)
                                   : glm::distance(plan_.volume->grid().mmFromVoxel(glm::dvec3(voxel)),
                                                   layer_.distanceFromMm.value_or(glm::dvec3(0)));
        case TransferAxis::value:
        case TransferAxis::label:
        case TransferAxis::curvature:
        case TransferAxis::importance: break; // the last two: see countsInCues
        }
        return entryUnit(slab.at(voxel.x, voxel.y, voxel.z));
    }

    [[nodiscard]] float gradientFactor(double unit) const {
        const std::vector<float>& factors = layer_.parts->gradientTable;
        return factors[nearest(unit * static_cast<double>(factors.size() - 1), factors.size())];
    }

    const RenderPlan& plan_;
    const PlanLayer& layer_;
    const TransferTable& table_;
    bool counts_;
    std::vector<float> columns_;
    double low_ = 0;
    double perUnit_ = 0; ///< entries
    bool thins_ = false;
};

/// Share of a cell's opacity that the figure's and the layer's cuts and the layer's fading by position leave.
double keptOfCell(const RenderPlan& plan, const PlanLayer& layer, const PlanCut& figures, const glm::dvec3& voxel,
                  double cellMm) {
    const glm::dvec3 p = plan.volume->grid().mmFromVoxel(voxel);
    double kept = 1;
    for (const PlanCut* cut : {&figures, layer.cut ? &*layer.cut : nullptr}) {
        for (std::size_t i = 0; cut != nullptr && i < cut->planes.size(); ++i) {
            const PlanCut::Plane& plane = cut->planes[i];
            kept = std::min(kept, optics::keptByPlane(plane.offsetMm - glm::dot(plane.normalMm, p), cellMm));
        }
    }
    if (layer.parts && layer.parts->position) {
        const double place = glm::dot(layer.parts->placeOfVoxel, glm::dvec4(voxel, 1));
        kept *= std::min(positionTintAt(*layer.parts->position, place).a, 1.0);
    }
    return kept;
}

/// (1 2 1) / 4 along an axis, the border repeated.
void smoothAlong(CueField& field, int axis) {
    const std::vector<float> before = field.values;
    const glm::ivec3 dims = field.dims;
    const std::ptrdiff_t strides[] = {1, dims.x, static_cast<std::ptrdiff_t>(dims.x) * dims.y};
    tbb::parallel_for(0, dims.z, [&](int z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const glm::ivec3 cell(x, y, z);
                const std::ptrdiff_t at = x + y * strides[1] + z * strides[2];
                const float* v = before.data() + at;
                const float low = cell[axis] > 0 ? v[-strides[axis]] : v[0];
                const float high = cell[axis] < dims[axis] - 1 ? v[strides[axis]] : v[0];
                field.values[static_cast<std::size_t>(at)] = 0.25F * low + 0.5F * v[0] + 0.25F * high;
            }
        }
    });
}

} // namespace

void smooth(CueField& field) {
    for (int axis = 0; axis < 3; ++axis) {
        smoothAlong(field, axis);
    }
}

int voxelsPerCell(const Grid& grid, int mostCells) {
    const int longest = std::max({grid.dims.x, grid.dims.y, grid.dims.z});
    return std::max(1, (longest + mostCells - 1) / mostCells);
}

bool countsInCues(const PlanLayer& layer) {
    return !readsAxis(layer, TransferAxis::curvature) && !readsAxis(layer, TransferAxis::importance);
}

CueField coarseOpacity(const RenderPlan& plan, int voxels, Task& task) {
    const Volume& volume = *plan.volume;
    const glm::ivec3 dims = volume.grid().dims;
    CueField field{(dims + voxels - 1) / voxels, voxels, 1, {}};
    field.values.assign(static_cast<std::size_t>(field.dims.x) * static_cast<std::size_t>(field.dims.y) *
                            static_cast<std::size_t>(field.dims.z),
                        0.0F);
    std::vector<ColumnOpacity> layers;
    for (const PlanLayer& layer : plan.layers) {
        layers.emplace_back(plan, layer, voxels);
    }
    const PlanCut figures = planCut(plan.clip, *plan.figure, plan.rays);
    const double cellMm = voxels * volume.grid().smallestSpacingMm();
    tbb::parallel_for(0, field.dims.z, [&](int cz) {
        if (task.cancelled()) {
            return;
        }
        const int z0 = cz * voxels;
        const int z1 = std::min(z0 + voxels, dims.z);
        const Slab slab(volume, z0 - 1, z1);
        std::size_t cell = static_cast<std::size_t>(cz) * static_cast<std::size_t>(field.dims.x) *
                           static_cast<std::size_t>(field.dims.y);
        for (int cy = 0; cy < field.dims.y; ++cy) {
            for (int cx = 0; cx < field.dims.x; ++cx, ++cell) {
                const glm::ivec3 low(cx * voxels, cy * voxels, z0);
                const glm::ivec3 high = glm::min(low + voxels, dims);
                double clear = 1;
                for (std::size_t i = 0; i < layers.size(); ++i) {
                    double sum = 0;
                    for (int z = low.z; z < high.z; ++z)
                        for (int y = low.y; y < high.y; ++y)
                            for (int x = low.x; x < high.x; ++x) {
                                sum += layers[i].at(slab, {x, y, z});
                            }
                    const glm::ivec3 size = high - low;
                    const double mean = sum / (static_cast<double>(size.x) * size.y * size.z);
                    if (mean > 0) {
                        const glm::dvec3 middle = (glm::dvec3(low) + glm::dvec3(high) - 1.0) * 0.5;
                        clear *= 1 - mean * keptOfCell(plan, plan.layers[i], figures, middle, cellMm);
                    }
                }
                field.values[cell] = static_cast<float>(1 - clear);
            }
        }
    });
    task.throwIfCancelled();
    return field;
}

} // namespace limner
