// Depth cues over the layers' colours; compiled once for every instruction set.
#if defined(LIMNER_CUES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_CUES_INL_H
#undef LIMNER_CUES_INL_H
#else
#define LIMNER_CUES_INL_H
#endif

#include "renderer/cpu/facts-inl.h" // names the target: before the formulas
#include "renderer/cpu/style-inl.h"

#include "core/optics/layers.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// The eight cells of a cue's field around a sample, with their weights.
struct CuePlace {
    Ints cell[8];
    Floats weight[8];

    HWY_INLINE CuePlace(const KernelCue& cue, const Vec3& q) {
        Ints low[3], high[3];
        Floats share[3];
        const Floats at[3] = {q.x, q.y, q.z};
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t last = cue.dims[axis] - 1;
            const Floats cells = hn::MulAdd(at[axis], splat(cue.perCell), splat(cue.bias));
            const Floats inside = hn::Min(hn::Max(cells, splat(0)), splat(static_cast<float>(last)));
            low[axis] = truncate(inside);
            share[axis] = hn::Sub(inside, toFloat(low[axis]));
            high[axis] = hn::Min(hn::Add(low[axis], splatInt(1)), splatInt(last));
        }
        for (int i = 0; i < 8; ++i) {
            const auto step = [&](int axis) { return (i >> axis & 1) != 0; };
            const auto index = [&](int axis) HWY_ATTR { return step(axis) ? high[axis] : low[axis]; };
            const auto part = [&](int axis)
                                  HWY_ATTR { return step(axis) ? share[axis] : hn::Sub(splat(1), share[axis]); };
            const Ints row = hn::Add(hn::Mul(index(2), splatInt(cue.dims[1])), index(1));
            cell[i] = hn::Add(hn::Mul(row, splatInt(cue.dims[0])), index(0));
            weight[i] = hn::Mul(hn::Mul(part(0), part(1)), part(2));
        }
    }

    /// Of a field with one channel.
    HWY_INLINE Floats read(const float* values) const {
        Floats sum = splat(0);
        for (int i = 0; i < 8; ++i) {
            sum = hn::MulAdd(weight[i], gatherFloats(values, cell[i]), sum);
        }
        return sum;
    }

    /// Of a field with four.
    HWY_INLINE void readFour(const float* values, Floats& mean, Vec3& vector) const {
        LaneColours sums;
        for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
            hn::Store(hn::Zero(kQuad), kQuad, sums.rgba + 4 * lane);
        }
        for (int i = 0; i < 8; ++i) {
            const LaneInts at(cell[i]);
            const LaneFloats share(weight[i]);
            for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
                const Quad four = hn::LoadU(kQuad, values + std::ptrdiff_t{4} * at.at[lane]);
                float* sum = sums.rgba + 4 * lane;
                hn::Store(hn::MulAdd(four, hn::Set(kQuad, share.at[lane]), hn::Load(kQuad, sum)), kQuad, sum);
            }
        }
        hn::LoadInterleaved4(kF, sums.rgba, mean, vector.x, vector.y, vector.z);
    }
};

/// What the depth cues leave of the colours of a vector of samples, and what they lay over them.
template <typename Field>
class CueLanes {
  public:
    explicit CueLanes(const KernelScene& scene) : scene_(scene), cues_(scene.cues) {}

    HWY_NOINLINE void measure(const Facts<Field>& facts) {
        Floats lit = splat(1);
        if (cues_.ambient.values != nullptr) {
            lit = hn::Sub(lit, hn::Mul(splat(cues_.ambientStrength), ambient(facts)));
        }
        if (cues_.shadow.values != nullptr) {
            const Floats occlusion = CuePlace(cues_.shadow, outside(cues_.shadow, facts)).read(cues_.shadow.values);
            const Vec3 light = {splat(cues_.light[0]), splat(cues_.light[1]), splat(cues_.light[2])};
            const Lanes dark =
                optics::shadowed(Lanes{occlusion}, Lanes{dot(facts.normal.eye, light)}, Lanes{facts.trusted});
            lit = hn::Mul(lit, hn::NegMulAdd(splat(cues_.shadowStrength), dark.v, splat(1)));
        }
        Floats halo = splat(0);
        if (cues_.halo.values != nullptr) {
            halo = hn::Mul(splat(cues_.haloStrength), CuePlace(cues_.halo, facts.q).read(cues_.halo.values));
        }
        lit_ = hn::Mul(lit, hn::Sub(splat(1), halo));
        halo_ = halo;
    }

    HWY_INLINE void apply(LaneColours& out) const {
        const Quad rgb = hn::LoadU(kQuad, cues_.haloRgb);
        for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
            const Quad over = hn::Mul(rgb, hn::Set(kQuad, halo_.at[lane]));
            const Quad c = hn::Load(kQuad, out.rgba + 4 * lane);
            hn::Store(hn::MulAdd(c, hn::Set(kQuad, lit_.at[lane]), over), kQuad, out.rgba + 4 * lane);
        }
    }

  private:
    HWY_INLINE Vec3 outside(const KernelCue& cue, const Facts<Field>& facts) const {
        const Vec3 out = turned(scene_.cellFromEye, facts.normal.eye);
        const Floats mm = hn::Mul(facts.trusted, splat(cue.outMm));
        return {hn::MulAdd(out.x, mm, facts.q.x), hn::MulAdd(out.y, mm, facts.q.y), hn::MulAdd(out.z, mm, facts.q.z)};
    }

    HWY_INLINE Floats ambient(const Facts<Field>& facts) const {
        Floats mean;
        Vec3 vector;
        CuePlace(cues_.ambient, outside(cues_.ambient, facts)).readFour(cues_.ambient.values, mean, vector);
        const Floats along = dot(turned(scene_.mmFromEye, facts.normal.eye), vector);
        return optics::ambientOcclusion(Lanes{mean}, Lanes{along}, Lanes{facts.trusted}).v;
    }

    const KernelScene& scene_;
    const KernelCues& cues_;
    LaneFloats lit_;
    LaneFloats halo_;
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
