#include "renderer/marks/dot_pattern.h"
#include "renderer/marks/ink.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limner {

namespace {

constexpr double kMostCells = 16e6; ///< of the paper's grid
constexpr int kBandRows = 32;       ///< that one task sums up
constexpr int kSteps = 3;           ///< places along each edge of a voxel's face that stand for it
/// Half width of the tents that spread a place's ink, in voxels: two steps, so that a face adds up evenly.
constexpr float kTentVoxels = 2.0F / kSteps;

/// What the marks ask of the paper, summed over cells of about half a dot.
class PaperTone {
  public:
    explicit PaperTone(const MarkScene& scene) : scene_(scene), layers_(scene.field.layerNames.size()) {
        const glm::dvec2 paper = scene.view.paperMm();
        cell_ = std::max(0.5 * scene.stipple.sizeMm, std::sqrt(paper.x * paper.y / kMostCells));
        size_ = glm::max(glm::ivec2(glm::ceil(paper / cell_)), glm::ivec2(1));
        channels_ = 2 + (layers_ > 1 ? layers_ : 0) + (scene.colours.empty() ? 0 : 3);
        sums_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * channels_, 0.0F);
    }

    /// The same sums for any number of threads: a band of rows adds the voxels that reach it in their order.
    void addAll(Task& task) {
        const int bands = (size_.y + kBandRows - 1) / kBandRows;
        std::vector<std::vector<std::uint32_t>> members(static_cast<std::size_t>(bands));
        for (std::size_t i = 0; i < scene_.ink.size(); ++i) {
            const VoxelInk& ink = scene_.ink[i];
            if (!(ink.dots > 0)) {
                continue;
            }
            // A face reaches a diagonal past its middle, the shift onto the surface one more, a tent its width.
            const double reach = (1.8 + static_cast<double>(kTentVoxels)) * scene_.field.mmPerVoxel * longest() *
                                     static_cast<double>(ink.at.scale) +
                                 cell_;
            const double top = (static_cast<double>(ink.at.mm.y) - reach) / cell_ / kBandRows;
            const double bottom = (static_cast<double>(ink.at.mm.y) + reach) / cell_ / kBandRows;
            for (int band = std::max(0, static_cast<int>(std::floor(top)));
                 band <= std::min(bands - 1, static_cast<int>(std::floor(bottom))); ++band) {
                members[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(i));
            }
        }
        tbb::parallel_for(0, bands, [&](int band) {
            for (const std::uint32_t i : members[static_cast<std::size_t>(band)]) {
                if (task.cancelled()) {
                    return;
                }
                addVoxel(i, band * kBandRows, std::min((band + 1) * kBandRows, size_.y));
            }
        });
        task.throwIfCancelled();
    }

    struct Asked {
        float density = 0; ///< dots' area over paper
        float radiusMm = 0;
        std::size_t layer = 0;
        InkColour rgb{0};
    };

    [[nodiscard]] Asked at(const glm::dvec2& mm) const {
        const glm::dvec2 place = glm::clamp(mm / cell_ - 0.5, glm::dvec2(0), glm::dvec2(size_ - 1));
        const glm::ivec2 c = glm::min(glm::ivec2(place), glm::max(size_ - 2, glm::ivec2(0)));
        const glm::ivec2 next = glm::min(c + 1, size_ - 1);
        const glm::vec2 f(place - glm::dvec2(c));
        const float* corners[] = {sums(c.x, c.y), sums(next.x, c.y), sums(c.x, next.y), sums(next.x, next.y)};
        const float weights[] = {(1 - f.x) * (1 - f.y), f.x * (1 - f.y), (1 - f.x) * f.y, f.x * f.y};
        const auto mean = [&](std::size_t channel) {
            return weights[0] * corners[0][channel] + weights[1] * corners[1][channel] +
                   weights[2] * corners[2][channel] + weights[3] * corners[3][channel];
        };
        Asked asked;
        const float ink = mean(0);
        if (!(ink > 0)) {
            return asked;
        }
        asked.density = ink / static_cast<float>(cell_ * cell_);
        asked.radiusMm = mean(1) / ink;
        std::size_t channel = 2;
        if (layers_ > 1) {
            float most = 0;
            for (std::size_t i = 0; i < layers_; ++i, ++channel) {
                if (const float own = mean(channel); own > most) {
                    most = own;
                    asked.layer = i;
                }
            }
        }
        asked.rgb = scene_.plain;
        if (!scene_.colours.empty()) {
            const glm::vec3 rgb(mean(channel), mean(channel + 1), mean(channel + 2));
            asked.rgb = InkColour(glm::clamp(rgb / ink + 0.5F, 0.0F, 255.0F));
        }
        return asked;
    }

  private:
    [[nodiscard]] double longest() const {
        const glm::dvec3 s = scene_.field.grid.spacingMm;
        return std::max({s.x, s.y, s.z}) / scene_.field.mmPerVoxel;
    }
    [[nodiscard]] const float* sums(int x, int y) const {
        return sums_.data() +
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x)) *
                   channels_;
    }

    void addVoxel(std::size_t i, int firstRow, int endRow) {
        const MarkField& field = scene_.field;
        const MarkVoxel& voxel = field.voxels[i];
        const VoxelInk& ink = scene_.ink[i];
        const MarkFace face = field.faceOf(voxel);
        const float area = ink.dots * std::numbers::pi_v<float> * ink.radiusMm * ink.radiusMm / (kSteps * kSteps);
        for (int a = 0; a < kSteps; ++a) {
            for (int b = 0; b < kSteps; ++b) {
                const glm::dvec3 mm = face.middleMm + ((a + 0.5) / kSteps - 0.5) * face.edgeMm[0] +
                                      ((b + 0.5) / kSteps - 0.5) * face.edgeMm[1];
                if (!scene_.view.kept(mm)) {
                    continue;
                }
                const PlaceOnPaper at = scene_.view.place(mm);
                if (const float seen = scene_.depth.visible(at, ink.facing); seen > 0 && at.scale > 0) {
                    spread(i, at, area * seen, firstRow, endRow);
                }
            }
        }
    }

    /// Adds the ink of a place as a tent.
    void spread(std::size_t i, const PlaceOnPaper& at, float area, int firstRow, int endRow) {
        const auto cell = static_cast<float>(cell_);
        const float reach = std::max(kTentVoxels * static_cast<float>(scene_.field.mmPerVoxel) * at.scale / cell, 1.0F);
        const glm::vec2 middle = at.mm / cell - 0.5F;
        const auto low = glm::ivec2(glm::floor(middle - reach)) + 1;
        const auto high = glm::ivec2(glm::ceil(middle + reach)) - 1;
        // The tent's sum over the cells is not quite its integral; all of the ink is to arrive.
        glm::vec2 sum(0);
        for (int k = 0; k < 2; ++k) {
            for (int c = low[k]; c <= high[k]; ++c) {
                sum[k] += 1 - std::abs(static_cast<float>(c) - middle[k]) / reach;
            }
        }
        const float scale = area / (sum.x * sum.y);
        const VoxelInk& ink = scene_.ink[i];
        const InkColour rgb = scene_.colourOf(i);
        for (int y = std::max(low.y, firstRow); y <= std::min(high.y, endRow - 1); ++y) {
            const float rowShare = scale * (1 - std::abs(static_cast<float>(y) - middle.y) / reach);
            for (int x = std::max(low.x, 0); x <= std::min(high.x, size_.x - 1); ++x) {
                const float share = rowShare * (1 - std::abs(static_cast<float>(x) - middle.x) / reach);
                float* out = sums_.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
                                             static_cast<std::size_t>(x)) *
                                                channels_;
                *out++ += share;
                *out++ += share * ink.radiusMm;
                if (layers_ > 1) {
                    out[scene_.field.voxels[i].layer] += share;
                    out += layers_;
                }
                if (!scene_.colours.empty()) {
                    for (int k = 0; k < 3; ++k) {
                        out[k] += share * static_cast<float>(rgb[k]);
                    }
                }
            }
        }
    }

    const MarkScene& scene_;
    std::size_t layers_;
    double cell_ = 1;
    glm::ivec2 size_{0};
    std::size_t channels_ = 2;
    std::vector<float> sums_; ///< a cell's side by side: ink, ink x radius, ink of each layer, ink x colour
};

} // namespace

void addDotsOnPaper(const MarkScene& scene, Marks& marks, Task& task) {
    if (!(scene.stipple.sizeMm > 0)) {
        return;
    }
    PaperTone tone(scene);
    tone.addAll(task);
    const DotPattern& pattern = dotPattern();
    const double densest = DotPattern::kMostDensity / static_cast<double>(kSmallestDot * kSmallestDot);
    const double unit = std::sqrt(largestDotArea(scene.stipple) / densest); // mm of paper to a unit of the pattern
    const glm::dvec2 paper = scene.view.paperMm();
    const glm::dvec2 end = paper / unit;
    // Another seed looks at another part of the pattern.
    const glm::dvec2 offset = DotPattern::offsetOf(seedBits(scene.stipple));
    const std::size_t layers = scene.field.layerNames.size();
    const auto rows = static_cast<std::size_t>(std::ceil(end.y / kBandRows));
    std::vector<std::vector<Dot>> dots(rows * layers);
    const auto largest = static_cast<float>(largestDotArea(scene.stipple));
    tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
        if (task.cancelled()) {
            return;
        }
        const double top = static_cast<double>(row) * kBandRows;
        const glm::dvec2 low(offset.x, offset.y + top);
        const glm::dvec2 high(offset.x + end.x, offset.y + std::min(top + kBandRows, end.y));
        pattern.forEachIn(low, high, 1, [&](const glm::vec2& place, float rank, std::uint32_t) {
            const glm::dvec2 mm = glm::dvec2(place.x, static_cast<double>(place.y) + top) * unit;
            const PaperTone::Asked asked = tone.at(mm);
            const float area = std::numbers::pi_v<float> * asked.radiusMm * asked.radiusMm;
            // Dots to a unit of the pattern's plane, of which rank 1 has one.
            if (asked.density > 0 && rank * static_cast<float>(densest) * area < asked.density * largest) {
                dots[row * layers + asked.layer].push_back({glm::vec2(mm), 0, asked.radiusMm, 1, asked.rgb});
            }
        });
    });
    task.throwIfCancelled();
    for (std::size_t layer = 0; layer < layers; ++layer) {
        MarkGroup group;
        group.name = scene.field.groupName("Stipples", layer);
        for (std::size_t row = 0; row < rows; ++row) {
            const auto& part = dots[row * layers + layer];
            group.dots.insert(group.dots.end(), part.begin(), part.end());
        }
        if (!group.dots.empty()) {
            marks.groups.push_back(std::move(group));
        }
    }
}

} // namespace limner
