#include "core/optics/opacity.h"
#include "renderer/backend.h"
#include "renderer/plan/plan_importance.h"
#include "renderer/reference/field.h"
#include "renderer/reference/importance.h"
#include "renderer/reference/layer_optics.h"
#include "renderer/reference/ray.h"
#include "renderer/reference/slab.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cassert>

namespace limner {

namespace {

using Gathered = optics::Accumulated<double>;

/// Marches the rays of one plan: double precision, exact evaluation, every sample taken.
class Marcher {
  public:
    explicit Marcher(const RenderPlan& plan) : plan_(plan) {}

    struct Counts {
        std::uint64_t samples = 0;
        std::uint64_t shaded = 0;
    };

    /// Box average over the pixel's sub-pixels.
    Gathered pixel(glm::ivec2 at, Counts& counts, const Task& task) const {
        Gathered sum{0, 0, 0, 0};
        const int n = plan_.subPixels;
        for (int sub = 0; sub < n * n; ++sub) {
            task.throwIfCancelled();
            const glm::dvec2 inside((sub % n + 0.5) / n, (sub / n + 0.5) / n);
            const glm::dvec2 place = glm::dvec2(at) + inside;
            if (const auto ray = reference::rayThrough(plan_, place)) {
                const double weight = globalWeightAt(plan_, place);
                const Gathered one = weight > 0 ? marchByImportance(*ray, weight, counts) : march(*ray, counts);
                sum = {sum.r + one.r, sum.g + one.g, sum.b + one.b, sum.a + one.a};
            }
        }
        const double share = 1.0 / (n * n);
        return {sum.r * share, sum.g * share, sum.b * share, sum.a * share};
    }

  private:
    Gathered march(const reference::Ray& ray, Counts& counts) const {
        Gathered gathered{0, 0, 0, 0};
        const reference::SampleSpan span = reference::samplesOf(ray, plan_.lattice);
        for (long k = span.first; k < span.end && 1 - gathered.a >= plan_.earlyTermination && gathered.a < 1; ++k) {
            const reference::Segment segment = reference::segmentOf(ray, plan_.lattice, k);
            if (segment.lengthMm > 0) {
                ++counts.samples;
                gathered = plan_.preintegrated ? behindSlab(gathered, reference::slabAt(plan_, ray, k), counts)
                                               : behind(gathered, ray, segment, counts);
            }
        }
        return gathered;
    }

    static Gathered behindSlab(Gathered gathered, const std::vector<reference::SlabPart>& slab, Counts& counts) {
        counts.shaded += slab.empty() ? 0 : 1;
        for (const reference::SlabPart& part : slab) {
            gathered = optics::compositeBehind(gathered, part.colour, part.opacity);
        }
        return gathered;
    }

    Gathered marchByImportance(const reference::Ray& ray, double weight, Counts& counts) const {
        reference::ImportanceRay gathered(plan_, weight);
        const reference::SampleSpan span = reference::samplesOf(ray, plan_.lattice);
        for (long k = span.first; k < span.end && 1 - gathered.certain() >= plan_.earlyTermination; ++k) {
            const reference::Segment segment = reference::segmentOf(ray, plan_.lattice, k);
            if (segment.lengthMm > 0) {
                ++counts.samples;
                addTo(gathered, ray, segment, counts);
            }
        }
        return gathered.result();
    }

    void addTo(reference::ImportanceRay& gathered, const reference::Ray& ray, const reference::Segment& segment,
               Counts& counts) const {
        const double value = reference::valueAt(plan_, ray.positionVoxel(segment.positionMm));
        if (!mayShow(value)) {
            return;
        }
        ++counts.shaded;
        const reference::SampleFacts facts = reference::sampleFacts(plan_, ray, segment, value);
        for (const PlanLayer& layer : plan_.layers) {
            gathered.add(layer, facts, reference::shadeLayer(plan_, layer, facts));
        }
    }

    /// All layers at one sample, each composited after the other.
    Gathered behind(Gathered gathered, const reference::Ray& ray, const reference::Segment& segment,
                    Counts& counts) const {
        const double value = reference::valueAt(plan_, ray.positionVoxel(segment.positionMm));
        if (!mayShow(value)) {
            return gathered;
        }
        ++counts.shaded;
        const reference::SampleFacts facts = reference::sampleFacts(plan_, ray, segment, value);
        for (const PlanLayer& layer : plan_.layers) {
            const reference::LayerSample sample = reference::shadeLayer(plan_, layer, facts);
            if (sample.opacity > 0) {
                gathered = optics::compositeBehind(gathered, sample.colour,
                                                   optics::opacityOfLength(sample.opacity, sample.lengthRatio));
            }
        }
        return gathered;
    }

    /// Whether any layer can show at a value: false only where it is certain and cheap to tell.
    [[nodiscard]] bool mayShow(double value) const {
        return std::any_of(plan_.layers.begin(), plan_.layers.end(), [value](const PlanLayer& layer) {
            return !opacityByValue(layer) || reference::opacityOf(layer, value) > 0;
        });
    }

    const RenderPlan& plan_;
};

class ReferenceBackend final : public Backend {
  public:
    [[nodiscard]] std::string name() const override { return "reference"; }

    RenderResult render(const RenderPlan& plan, const Tile& tile, Task& task) const override {
        assert(plan.volume && plan.figure && plan.subPixels > 0);
        RenderResult result;
        result.picture = Picture(tile.size);
        const Marcher marcher(plan);
        std::atomic<std::uint64_t> samples{0};
        std::atomic<std::uint64_t> shaded{0};
        std::atomic<int> rowsDone{0};
        task.throwIfCancelled();
        tbb::parallel_for(0, tile.size.y, [&](int y) {
            Marcher::Counts counts;
            for (int x = 0; x < tile.size.x; ++x) {
                const Gathered c = marcher.pixel(tile.origin + glm::ivec2(x, y), counts, task);
                const double rgba[4] = {c.r, c.g, c.b, c.a};
                std::transform(rgba, rgba + 4, result.picture.pixel(x, y),
                               [](double v) { return static_cast<float>(v); });
            }
            samples += counts.samples;
            shaded += counts.shaded;
            task.progress(static_cast<double>(++rowsDone) / tile.size.y);
        });
        result.samples = samples;
        result.shaded = shaded;
        return result;
    }
};

} // namespace

std::unique_ptr<Backend> makeReferenceBackend() { return std::make_unique<ReferenceBackend>(); }

} // namespace limner
