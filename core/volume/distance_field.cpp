#include "core/volume/derived_fields.h"
#include "core/volume/field_parts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace limner {

namespace {

using fields::Numbers;

constexpr float kNowhere = std::numeric_limits<float>::infinity();
constexpr int kLanes = 16; // lines read together: one cache line a step

/// Squared distances along one axis, from those within the planes across it: the lower envelope of the parabolas that
/// stand on a line's voxels (Felzenszwalb and Huttenlocher 2012, section 2.1).
class LowerEnvelope {
  public:
    LowerEnvelope(int count, double spacing)
        : squared_(spacing * spacing), vertex_(count), from_(count), height_(count), perStep_(count) {
        for (int step = 1; step < count; ++step) {
            perStep_[static_cast<std::size_t>(step)] = 1 / (2 * squared_ * step);
        }
    }

    /// Replaces the squared distances of a line by those that count this axis too.
    void apply(float* line) {
        const std::ptrdiff_t parabolas = build(line);
        if (parabolas == 0) {
            return; // nothing anywhere in the planes: infinite as before
        }
        const int count = static_cast<int>(vertex_.size());
        std::ptrdiff_t k = 0;
        for (int q = 0; q < count; ++q) {
            while (k + 1 < parabolas && from_[k + 1] < q) {
                ++k;
            }
            const double steps = q - vertex_[k];
            line[q] = static_cast<float>(squared_ * steps * steps + height_[k]);
        }
    }

  private:
    /// Finds the parabolas that are lowest somewhere; returns how many.
    std::ptrdiff_t build(const float* line) {
        const int count = static_cast<int>(vertex_.size());
        std::ptrdiff_t used = 0;
        for (int q = 0; q < count; ++q) {
            if (line[q] == kNowhere) {
                continue;
            }
            const double height = line[q];
            double from = -std::numeric_limits<double>::infinity();
            while (used > 0) {
                const int v = vertex_[used - 1];
                // Where the new parabola passes below the last: to the right of it.
                from = 0.5 * (q + v) + (height - height_[used - 1]) * perStep_[q - v];
                if (from > from_[used - 1]) {
                    break;
                }
                --used;
            }
            vertex_[used] = q;
            height_[used] = height;
            from_[used] = used == 0 ? -std::numeric_limits<double>::infinity() : from;
            ++used;
        }
        return used;
    }

    double squared_;
    std::vector<int> vertex_;     ///< step of a parabola
    std::vector<double> from_;    ///< where it becomes the lowest
    std::vector<double> height_;  ///< at its vertex
    std::vector<double> perStep_; ///< by the distance of two vertices: 1 / (2 * squared_ * distance)
};

/// Squared distances within the row; infinite without a marked voxel.
void alongRow(const std::uint8_t* marked, int count, double spacing, float* out) {
    const auto sweep = [&](int x, int& since) {
        since = marked[x] != 0 ? 0 : since < count ? since + 1 : count;
        return since;
    };
    const auto squared = static_cast<float>(spacing * spacing);
    int since = count; // steps since the last marked voxel; count: none yet
    for (int x = 0; x < count; ++x) {
        out[x] = static_cast<float>(sweep(x, since));
    }
    since = count;
    for (int x = count - 1; x >= 0; --x) {
        const float steps = std::min(out[x], static_cast<float>(sweep(x, since)));
        out[x] = steps < static_cast<float>(count) ? squared * steps * steps : kNowhere;
    }
}

/// Applies the envelope to every line that starts in the row at `first` and whose steps lie `stride` apart.
void across(float* first, int rowLength, std::size_t stride, int count, double spacing) {
    LowerEnvelope envelope(count, spacing);
    std::vector<float> lines(static_cast<std::size_t>(kLanes) * static_cast<std::size_t>(count));
    const auto step = static_cast<std::ptrdiff_t>(stride);
    for (int x = 0; x < rowLength; x += kLanes) {
        const std::ptrdiff_t lanes = std::min(kLanes, rowLength - x);
        for (std::ptrdiff_t k = 0; k < count; ++k) {
            for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) {
                lines[lane * count + k] = first[x + k * step + lane];
            }
        }
        for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) {
            envelope.apply(lines.data() + lane * count);
        }
        for (std::ptrdiff_t k = 0; k < count; ++k) {
            for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) {
                first[x + k * step + lane] = lines[lane * count + k];
            }
        }
    }
}

/// Squared distances to the marked voxels in `spacing`'s unit.
Numbers<float> squaredDistances(const Numbers<std::uint8_t>& marked, const glm::dvec3& spacing, Task& task) {
    const glm::ivec3 dims = marked.dims();
    const auto rowStride = static_cast<std::size_t>(dims.x);
    Numbers<float> field(dims);
    tbb::parallel_for(0, dims.z, [&](int z) {
        task.throwIfCancelled();
        for (int y = 0; y < dims.y; ++y) {
            alongRow(marked.row(y, z), dims.x, spacing.x, field.row(y, z));
        }
        across(field.row(0, z), dims.x, rowStride, dims.y, spacing.y);
    });
    task.progress(0.5);
    tbb::parallel_for(0, dims.y, [&](int y) {
        task.throwIfCancelled();
        across(field.row(y, 0), dims.x, rowStride * static_cast<std::size_t>(dims.y), dims.z, spacing.z);
    });
    task.progress(0.9);
    return field;
}

} // namespace

std::shared_ptr<const Volume> distanceToLabel(const Volume& labels, int label, Task& task) {
    return fields::withinMemory([&]() -> std::shared_ptr<const Volume> {
        const Grid& grid = labels.grid();
        // In units of the largest spacing, so that no squared distance leaves the range of float32.
        const double unitMm = std::max({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z});
        Numbers<float> field =
            squaredDistances(fields::labelBytes(
                                 labels, [&](std::optional<int> at) { return at == label ? 1 : 0; }, task),
                             grid.spacingMm / unitMm, task);
        if (field.span().front() == kNowhere) {
            return nullptr; // one voxel of the label is enough to make every distance finite
        }
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, field.span().size(), 1 << 16), [&](const auto& part) {
            for (float& number : field.span().subspan(part.begin(), part.size())) {
                number = std::sqrt(number);
            }
        });
        Volume::Contents contents;
        contents.grid = grid;
        contents.unit = "mm";
        return fields::keptAsInt16(std::move(contents), field, unitMm, 0);
    });
}

} // namespace limner
