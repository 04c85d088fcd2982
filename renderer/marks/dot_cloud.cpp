#include "renderer/marks/dot_cloud.h"

#include "core/optics/stipple.h"
#include "renderer/marks/volume_dots.h"

#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limner {

namespace {

constexpr std::size_t kChunk = 16384;  ///< voxels that one task looks at
constexpr double kRounding = 1.0001;   ///< that a bound must not fall short by
constexpr double kBetweenSteps = 1.03; ///< the same of a largest value that is looked for at steps

/// The most dots that a voxel asks for in any view: the factors that depend on the view at their largest.
class Bounds {
  public:
    Bounds(const Stipple& stipple, const MarkField& field, double density, double headroom)
        : stipple_(stipple), density_(density) {
        const double scale = field.paperPerMm * field.zoom * headroom * field.mmPerVoxel;
        perFace_ = kRounding * scale * scale / std::max(largestDotArea(stipple), 1e-12);
    }

    [[nodiscard]] double dotsOf(const MarkVoxel& voxel) const {
        float tone = 1;
        float size = voxel.gradient;
        if (stipple_.matter == "layers") {
            tone = optics::smoothStep<float>(kFaintMatter, kFullMatter, voxel.value);
        }
        if (const auto& k = stipple_.boundary) {
            tone *= optics::boundaryFactor<float>(voxel.value, voxel.gradient, curve(k->kgc, k->kgs, k->kge));
        }
        if (const auto& k = stipple_.interior) {
            const auto factor = optics::interiorFactor<float>(voxel.gradient, static_cast<float>(k->kte));
            tone *= factor;
            size *= factor;
        }
        return static_cast<double>(voxel.share) * perFace_ * largestOverSlants(voxel, tone, size);
    }

  private:
    static optics::StippleCurve<float> curve(double c, double s, double e) {
        return {static_cast<float>(c), static_cast<float>(s), static_cast<float>(e)};
    }

    /// A surface's area on paper goes with |n.e|, and so may its tone.
    [[nodiscard]] double largestOverSlants(const MarkVoxel& voxel, float tone, float size) const {
        if (!stipple_.silhouette) {
            return largestOverDepths(tone, size);
        }
        constexpr int kSteps = 8;
        const auto& k = *stipple_.silhouette;
        double largest = 0;
        for (int i = 1; i <= kSteps; ++i) {
            const float facing = static_cast<float>(i) / kSteps;
            const float factor = optics::silhouetteFactor<float>(voxel.value, facing, curve(k.ksc, k.kss, k.kse));
            largest = std::max(largest, static_cast<double>(facing) * largestOverDepths(tone * factor, size));
        }
        return kBetweenSteps * largest;
    }

    /// Farther dots are smaller and of less tone.
    [[nodiscard]] double largestOverDepths(float tone, float size) const {
        if (!stipple_.distance) {
            return shareOf(tone, size);
        }
        constexpr int kSteps = 4;
        const float least =
            std::min(kSmallestDot / std::max(size, kSmallestDot), 1.0F); // below it there are only fewer
        double largest = 0;
        for (int i = 0; i <= kSteps; ++i) {
            const float factor = least + (1 - least) * static_cast<float>(i) / kSteps;
            largest = std::max(largest, shareOf(tone * factor, size * factor));
        }
        return kBetweenSteps * largest;
    }

    [[nodiscard]] double shareOf(float tone, float size) const {
        const double asked = kRounding * density_ * static_cast<double>(tone);
        const auto drawn = static_cast<double>(std::max(size, kSmallestDot));
        if (stipple_.tone == "ink") {
            return dotPattern().densityFor(std::min(asked, kFullestTone)) / (drawn * drawn);
        }
        const double shrunk = static_cast<double>(size) / drawn;
        return asked * shrunk * shrunk;
    }

    const Stipple& stipple_;
    double density_;
    double perFace_;
};

} // namespace

std::size_t DotCloud::dotCount() const {
    return std::accumulate(dots.begin(), dots.end(), std::size_t{0},
                           [](std::size_t sum, const auto& part) { return sum + part.size(); });
}

double dotHeadroom(const RenderPlan& plan, const MarkField& field, const MarkView& view) {
    double scale = view.scale();
    if (!view.linear()) {
        constexpr double kNearest = 0.1; // of the way from the eye to the target
        const double nearest = static_cast<double>(view.place(plan.volume->grid().centreMm()).depthMm) +
                               0.5 * glm::length(plan.volume->grid().sizeMm());
        const double left = 1 - nearest / view.frame().eyeDistanceMm;
        if (!(left > kNearest)) {
            return 0;
        }
        scale /= left;
    }
    constexpr double kSlack = 1e-6; // a view at the very scale of the next step's begin
    constexpr double kPerDoubling = 4;
    const double steps = std::ceil(kPerDoubling * std::log2(scale / (field.paperPerMm * field.zoom)) - kSlack);
    return std::exp2(std::max(steps, 0.0) / kPerDoubling) * (1 + kSlack);
}

std::shared_ptr<const DotCloud> makeDotCloud(const Stipple& stipple, const MarkField& field, double density,
                                             double headroom, std::size_t most, Task& task) {
    auto cloud = std::make_shared<DotCloud>();
    cloud->headroom = headroom;
    for (std::size_t i = 0; i < field.voxels.size(); ++i) {
        if (field.voxels[i].share > 0) {
            cloud->voxels.push_back(static_cast<std::uint32_t>(i));
        }
    }
    const FacePoints points(field, stipple);
    const double capacity = points.capacity();
    const Bounds bounds(stipple, field, density, headroom);
    std::vector<float> ends(cloud->voxels.size());
    tbb::parallel_for(std::size_t{0}, ends.size(), [&](std::size_t i) {
        const auto end = static_cast<float>(bounds.dotsOf(field.voxels[cloud->voxels[i]]) / capacity);
        ends[i] = std::min(end + 0.5F * std::min(1 / static_cast<float>(capacity), kFadingPart * end), 1.0F);
    });
    double expected = 0;
    for (const float end : ends) {
        expected += static_cast<double>(end) * capacity;
    }
    if (expected > static_cast<double>(most)) {
        return nullptr;
    }
    cloud->dots.resize((ends.size() + kChunk - 1) / kChunk);
    tbb::parallel_for(std::size_t{0}, cloud->dots.size(), [&](std::size_t chunk) {
        std::vector<DotCandidate>& dots = cloud->dots[chunk];
        const std::size_t first = chunk * kChunk;
        const std::size_t last = std::min(first + kChunk, ends.size());
        double wanted = 0;
        for (std::size_t i = first; i < last; ++i) {
            wanted += static_cast<double>(ends[i]) * capacity;
        }
        dots.reserve(static_cast<std::size_t>(1.05 * wanted) + 64);
        for (std::size_t i = first; i < last && !task.cancelled(); ++i) {
            const MarkVoxel& voxel = field.voxels[cloud->voxels[i]];
            points.forEachOf(voxel, field.faceOf(voxel), ends[i], [&](const FacePoint& point) {
                const auto rank = static_cast<std::uint32_t>(point.rank * static_cast<float>(DotPattern::kCount));
                dots.push_back({point.onFace, static_cast<std::uint32_t>(i), rank << 16U | point.random});
            });
        }
    });
    task.throwIfCancelled();
    return cloud;
}

} // namespace limner
