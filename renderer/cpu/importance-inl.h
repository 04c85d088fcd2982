// Composition by importance (paper 001); compiled once for every instruction set.
#if defined(LIMNER_IMPORTANCE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_IMPORTANCE_INL_H
#undef LIMNER_IMPORTANCE_INL_H
#else
#define LIMNER_IMPORTANCE_INL_H
#endif

#include "renderer/cpu/measures-inl.h" // names the target: before the formulas

#include "renderer/cpu/kernel.h"

#include "core/optics/importance.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// One number four times, beside an RGBA: a scalar type of the formulas that compiles to no branch.
struct Quads {
    Quad v;
    HWY_INLINE explicit Quads(double x) : v(hn::Set(kQuad, static_cast<float>(x))) {}
    HWY_INLINE explicit Quads(Quad x) : v(x) {}
};
using QuadMask = hn::Mask<hn::Simd<float, 4, 0>>;
HWY_INLINE Quads operator+(Quads a, Quads b) { return Quads(hn::Add(a.v, b.v)); }
HWY_INLINE Quads operator-(Quads a, Quads b) { return Quads(hn::Sub(a.v, b.v)); }
HWY_INLINE Quads operator*(Quads a, Quads b) { return Quads(hn::Mul(a.v, b.v)); }
HWY_INLINE Quads operator/(Quads a, Quads b) { return Quads(hn::Div(a.v, b.v)); }
HWY_INLINE QuadMask operator>(Quads a, Quads b) { return hn::Gt(a.v, b.v); }
HWY_INLINE Quads select(QuadMask mask, Quads yes, Quads no) { return Quads(hn::IfThenElse(mask, yes.v, no.v)); }
HWY_INLINE Quads max(Quads a, Quads b) { return Quads(hn::Max(a.v, b.v)); }

/// What the samples of a vector bring to composition by importance, for one layer.
struct WeighedLanes {
    LaneFloats exponential; ///< e^Is; with unocclusion: the sum of the other measures, weighted by the global weight
    LaneFloats gate;        ///< unocclusion only: factor of the importance of what can hardly be seen
    LaneFloats depth;       ///< unocclusion only: optical depth of the sample
};

/// The pixels of a block on their way.
struct WeighedPixels {
    static constexpr int kCount = KernelBlock::kSize * KernelBlock::kSize;
    float exponential[kCount]; ///< e^I
    float depth[kCount];       ///< optical
    bool done[kCount];         ///< nothing that follows can change them

    void begin() {
        std::fill(exponential, exponential + kCount, 1.0F);
        std::fill(depth, depth + kCount, 0.0F);
        std::fill(done, done + kCount, false);
    }
};

/// Composes samples of known importance into the pixels of a block, whose colours are not multiplied by their opacity
/// on the way.
class ImportanceComposer {
  public:
    ImportanceComposer(const KernelScene& scene, const KernelBlock& block, float* rgba)
        : settings_(scene.importance), block_(block), opaque_(scene.opaque), stepRatio_(scene.stepRatio), rgba_(rgba) {
        if (block.ahead != nullptr) {
            pixels_.begin();
        }
    }

    [[nodiscard]] bool done(std::int32_t pixel) const { return pixels_.done[pixel]; }

    /// Global weights of the pixels that the lanes belong to.
    HWY_INLINE Floats weights(const std::int32_t* pixel) const {
        return block_.weights == nullptr ? splat(settings_.global)
                                         : hn::GatherIndex(kF, block_.weights, hn::Load(kI, pixel));
    }

    /// `opacity`: of the samples, which are `part` of a step.
    template <typename Field>
    HWY_INLINE void weigh(const ImportanceMeasures<Field>& measures, Floats weight, float ofLayer, Floats opacity,
                          Floats part, WeighedLanes& out) const {
        const Floats depth = optics::opticalDepth(Lanes{opacity}).v;
        const Floats extinction = hn::Div(depth, hn::Mul(splat(stepRatio_), hn::Max(part, splat(1e-6F))));
        Lanes gate{splat(1)};
        if (!hn::AllTrue(kF, hn::Ge(extinction, splat(4 * settings_.noiseFloor)))) {
            gate = optics::importanceOfVisible(gate, Lanes{extinction}, Lanes{splat(settings_.noiseFloor)});
        }
        const Lanes factor{hn::Mul(weight, splat(ofLayer))};
        const Lanes sum{measures.sum(extinction)};
        if (settings_.unocclusion > 0) {
            out.exponential = hn::Mul(factor.v, sum.v);
            out.gate = gate.v;
            out.depth = hn::Min(depth, splat(1e6F));
            return;
        }
        const Floats total = hn::Min(optics::totalImportance(factor, sum).v, splat(settings_.limit));
        out.exponential = exp(Lanes{hn::Mul(total, gate.v)}).v;
    }

    /// Whether what lies ahead of every lane's sample, itself included, matters no more than what its ray has met;
    /// `share`: of `shareAhead`.
    HWY_INLINE bool settled(const std::int32_t* pixel, Floats share, int count) const {
        constexpr float kRounded = 1 + 1e-6F; // of the exponentials
        const Floats met = hn::GatherIndex(kF, pixels_.exponential, hn::Load(kI, pixel));
        const Mask nobody = hn::Not(hn::FirstN(kF, static_cast<std::size_t>(count)));
        return hn::AllTrue(kF, hn::Or(hn::Ge(hn::Mul(met, share), splat(kRounded)), nobody));
    }

    /// One layer of one lane's sample behind what its pixel has.
    HWY_INLINE void add(std::int32_t pixel, Quad colour, float opacity, const WeighedLanes& weighed, std::size_t lane,
                        float ofLayer) {
        float* rgba = rgba_ + 4 * pixel;
        float exponential = weighed.exponential.at[lane];
        if (settings_.unocclusion > 0) {
            const float weight = block_.weights == nullptr ? settings_.global : block_.weights[pixel];
            const float open = optics::unocclusionImportance(pixels_.depth[pixel]) * settings_.unocclusion;
            const float total = std::min(exponential + weight * ofLayer * open, settings_.limit);
            exponential = std::exp(total * weighed.gate.at[lane]);
            pixels_.depth[pixel] += weighed.depth.at[lane];
        }
        const Quad before = hn::Load(kQuad, rgba);
        optics::ExponentialState<Quads> state = {Quads(hn::Broadcast<3>(before)),
                                                 Quads(hn::Set(kQuad, pixels_.exponential[pixel]))};
        const Quads kept =
            optics::keptBehind(state, Quads(hn::Set(kQuad, opacity)), Quads(hn::Set(kQuad, exponential)));
        const Quad mixed = hn::MulAdd(hn::Sub(before, colour), kept.v, colour);
        // In one store: the pixel's next sample would wait for two of different lengths.
        hn::Store(hn::IfThenElse(alphaLane(), state.opacity.v, mixed), kQuad, rgba);
        pixels_.exponential[pixel] = hn::GetLane(state.exponential.v);
    }

    /// e^-Emax: what can still come behind a sample; `ahead`: greatest sum of measures there, but unocclusion.
    HWY_INLINE Floats shareAhead(Floats weight, Floats ahead) const {
        const Floats background = hn::Mul(weight, splat(settings_.background));
        const Floats most = hn::Min(hn::Mul(weight, ahead), splat(settings_.limit));
        const Floats greatest = hn::Min(hn::Max(most, background), splat(kMost));
        return exp(Lanes{hn::Neg(greatest)}).v;
    }

    /// Ends a pixel where no more than the picture's tolerance can change behind a sample; `ahead`: greatest sum of
    /// measures there, but unocclusion, and `share` what `shareAhead` makes of it.
    HWY_INLINE void endWhereCertain(std::int32_t pixel, float ahead, float share) {
        const float opacity = rgba_[4 * pixel + 3];
        if (opacity < opaque_) {
            return; // the bound is below the opacity
        }
        if (settings_.unocclusion > 0) {
            const float weight = block_.weights == nullptr ? settings_.global : block_.weights[pixel];
            const float open =
                settings_.unocclusion * optics::unocclusionImportance(pixels_.depth[pixel]) * settings_.layerMost;
            share = std::exp(-std::max(std::min(weight * (ahead + open), settings_.limit), backgroundOf(weight)));
        }
        pixels_.done[pixel] = opacity * std::min(1.0F, pixels_.exponential[pixel] * share) >= opaque_;
    }

    /// Makes the pixels premultiplied, the background's importance counted.
    void finish() {
        for (int i = 0; i < WeighedPixels::kCount; ++i) {
            float* rgba = rgba_ + std::ptrdiff_t{4} * i;
            const float background = backgroundOf(block_.weights == nullptr ? settings_.global : block_.weights[i]);
            const float alpha = std::min(rgba[3], pixels_.exponential[i] * std::exp(-background));
            for (int c = 0; c < 3; ++c) {
                rgba[c] *= alpha;
            }
            rgba[3] = alpha;
        }
    }

  private:
    static constexpr auto kMost = static_cast<float>(optics::kGreatestImportance);

    [[nodiscard]] float backgroundOf(float weight) const { return std::min(weight * settings_.background, kMost); }

    const KernelImportance& settings_;
    const KernelBlock& block_;
    float opaque_;
    float stepRatio_;
    float* rgba_;
    WeighedPixels pixels_;
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
