#include "renderer/reference/ray_parts.h"

#include "core/optics/opacity.h"
#include "renderer/plan/plan_importance.h"
#include "renderer/reference/field.h"
#include "renderer/reference/importance.h"
#include "renderer/reference/slab.h"

#include <optional>

namespace limner::reference {

namespace {

class RayWalk {
  public:
    RayWalk(const RenderPlan& plan, const Ray& ray, double importance) : plan_(plan), ray_(ray) {
        if (importance > 0) {
            weighed_.emplace(plan, importance);
        }
    }

    std::vector<RayPart> parts() {
        const SampleSpan span = samplesOf(ray_, plan_.lattice);
        for (long k = span.first; k < span.end; ++k) {
            const double certain = weighed_ ? weighed_->certain() : opacity_;
            if (1 - certain < plan_.earlyTermination || certain >= 1) {
                break;
            }
            const Segment segment = segmentOf(ray_, plan_.lattice, k);
            if (segment.lengthMm > 0 && plan_.preintegrated) {
                addSlab(k);
            } else if (segment.lengthMm > 0) {
                addSample(segment, k);
            }
        }
        if (weighed_) { // importance scales all of a ray's colour before its background alike
            const double alpha = weighed_->result().a;
            for (RayPart& part : parts_) {
                part.weight *= alpha;
            }
        }
        return std::move(parts_);
    }

  private:
    void addSlab(long k) {
        for (const SlabPart& part : slabAt(plan_, ray_, k)) {
            const double weight = (1 - opacity_) * part.opacity;
            opacity_ += weight;
            const auto layer = static_cast<std::size_t>(part.layer - plan_.layers.data());
            parts_.push_back({layer, k, part.positionVoxel, part.value, weight});
        }
    }

    void addSample(const Segment& segment, long k) {
        const glm::dvec3 position = ray_.positionVoxel(segment.positionMm);
        const double value = valueAt(plan_, position);
        const SampleFacts facts = sampleFacts(plan_, ray_, segment, value);
        for (std::size_t i = 0; i < plan_.layers.size(); ++i) {
            const LayerSample sample = shadeLayer(plan_, plan_.layers[i], facts);
            double weight = 0;
            if (weighed_) {
                const double kept = weighed_->add(plan_.layers[i], facts, sample);
                for (RayPart& part : parts_) {
                    part.weight *= kept;
                }
                weight = 1 - kept;
            } else {
                weight = (1 - opacity_) * optics::opacityOfLength(sample.opacity, sample.lengthRatio);
                opacity_ += weight;
            }
            if (weight > 0) {
                parts_.push_back({i, k, position, value, weight});
            }
        }
    }

    const RenderPlan& plan_;
    const Ray& ray_;
    std::optional<ImportanceRay> weighed_;
    double opacity_ = 0;
    std::vector<RayPart> parts_;
};

} // namespace

std::vector<RayPart> rayParts(const RenderPlan& plan, const glm::dvec2& positionPixel) {
    const auto ray = rayThrough(plan, positionPixel);
    if (!ray) {
        return {};
    }
    return RayWalk(plan, *ray, globalWeightAt(plan, positionPixel)).parts();
}

} // namespace limner::reference
