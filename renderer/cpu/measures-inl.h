// How important a sample is; compiled once for every instruction set.
#if defined(LIMNER_MEASURES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_MEASURES_INL_H
#undef LIMNER_MEASURES_INL_H
#else
#define LIMNER_MEASURES_INL_H
#endif

#include "renderer/cpu/facts-inl.h" // names the target: before the formulas
#include "renderer/cpu/style-inl.h"

#include "core/optics/measures.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// The measures that all layers of a sample share; only those with a weight are taken.
template <typename Field>
class ImportanceMeasures {
  public:
    /// `settled`: no sample's importance will be read, only what is darkened.
    ImportanceMeasures(const KernelImportance& settings, const Facts<Field>& facts, bool settled = false)
        : settings_(settings) {
        if (settled) {
            silhouetteness_ = settings.silhouette > 0 ? silhouettenessOf(facts) : splat(0);
            return;
        }
        Floats sum = splat(0);
        const auto add = [&](float weight, const auto& measure) HWY_ATTR {
            if (weight > 0) {
                sum = hn::MulAdd(splat(weight), measure(), sum);
            }
        };
        add(settings.intensity, [&]() HWY_ATTR {
            const Floats value =
                hn::MulAdd(facts.tableEntry, splat(settings.intensityScale), splat(settings.intensityBias));
            return optics::intensityImportance(Lanes{value}).v;
        });
        add(settings.gradient, [&]() HWY_ATTR { return facts.unitMagnitude(); });
        add(settings.silhouette, [&]() HWY_ATTR {
            silhouetteness_ = silhouettenessOf(facts);
            return silhouetteness_;
        });
        add(settings.lighting, [&]() HWY_ATTR { return lightingOf(facts); });
        if (settings.weightOfSlot != nullptr) {
            sum = hn::Add(sum, objectsOf(facts));
        }
        if (settings.statistics != nullptr) {
            sum = hn::MulAdd(splat(settings.statisticsWeight), facts.other(settings.statistics), sum);
        }
        shared_ = sum;
    }

    /// Weighted sum for a layer, but unocclusion.
    HWY_INLINE Floats sum(Floats extinction) const {
        return settings_.extinction > 0
                   ? hn::MulAdd(splat(settings_.extinction), optics::extinctionImportance(Lanes{extinction}).v, shared_)
                   : shared_;
    }

    /// What colours are multiplied by, so that outlines show; `acts`: how much importance acts there, 0..1.
    HWY_INLINE Floats darkening(Floats acts) const {
        if (hn::AllFalse(kF, hn::Gt(silhouetteness_, splat(0)))) {
            return splat(1);
        }
        return exp(Lanes{hn::Mul(hn::Mul(splat(-settings_.darkening), acts), silhouetteness_)}).v;
    }

  private:
    HWY_NOINLINE Floats silhouettenessOf(const Facts<Field>& facts) const {
        const Floats turned = hn::Sub(splat(1), hn::Abs(facts.normal.facing));
        if (hn::AllFalse(kF, hn::Ge(turned, splat(settings_.silhouetteLow)))) {
            return splat(0);
        }
        const optics::SilhouetteTerms<Lanes> terms = {Lanes{splat(settings_.silhouetteExponent)},
                                                      Lanes{splat(settings_.silhouetteLow)},
                                                      Lanes{splat(settings_.silhouetteHigh)}};
        return optics::silhouetteness(Lanes{facts.unitMagnitude()}, Lanes{hn::Abs(facts.normal.facing)}, terms).v;
    }

    HWY_NOINLINE Floats lightingOf(const Facts<Field>& facts) const {
        const auto vector = [](const Vec3& v) HWY_ATTR {
            return optics::Vector3<Lanes>{Lanes{v.x}, Lanes{v.y}, Lanes{v.z}};
        };
        const Vec3 light = {splat(settings_.light[0]), splat(settings_.light[1]), splat(settings_.light[2])};
        const optics::Vector3<Lanes> half = optics::halfwayDirection(vector(light), vector(facts.view));
        const Vec3& n = facts.normal.eye;
        const auto turnedToViewer = [&](Floats cosine) HWY_ATTR { // two-sided
            return Lanes{hn::IfThenElse(hn::Lt(facts.normal.facing, splat(0)), hn::Neg(cosine), cosine)};
        };
        return optics::lightingImportance(turnedToViewer(dot(n, {half.x.v, half.y.v, half.z.v})),
                                          turnedToViewer(dot(n, light)), Lanes{facts.unitMagnitude()},
                                          {settings_.highlight, settings_.diffuse, settings_.flat})
            .v;
    }

    HWY_NOINLINE Floats objectsOf(const Facts<Field>& facts) const {
        LaneFloats sum(splat(0));
        for (int k = 0; k < facts.members.most; ++k) {
            for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
                sum.at[lane] += settings_.weightOfSlot[facts.members.slot[k][lane]] * facts.members.weight[k][lane];
            }
        }
        return hn::Mul(hn::Load(kF, sum.at), splat(settings_.object));
    }

    const KernelImportance& settings_;
    Floats shared_{};
    Floats silhouetteness_{};
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
