// Colours of samples: Phong, flat, and lit-sphere styles; compiled once for every instruction set.
#if defined(LIMNER_SHADE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_SHADE_INL_H
#undef LIMNER_SHADE_INL_H
#else
#define LIMNER_SHADE_INL_H
#endif

#include "renderer/cpu/field-inl.h"

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// The unit normal in eye space, out of dense matter, and how far it can be trusted.
struct Normal {
    Vec3 eye;
    Floats facing;    ///< normal . view
    Floats magnitude; ///< of the gradient, data's unit per mm
};

template <typename Field>
HWY_INLINE Normal normalAt(const Field& field, const typename Field::Place& place, const Vec3& view) {
    const auto& m = field.scene.eyeFromGradient;
    const Vec3 g = field.gradient(place);
    const auto component = [&](const float* row) HWY_ATTR {
        return hn::MulAdd(g.x, splat(row[0]), hn::MulAdd(g.y, splat(row[1]), hn::Mul(g.z, splat(row[2]))));
    };
    const Vec3 eye = {component(m[0]), component(m[1]), component(m[2])};
    const Floats squared = dot(eye, eye);
    Normal normal;
    normal.magnitude = hn::Sqrt(squared);
    // Where the gradient is zero the normal is too; 1e-18 only keeps the division defined.
    const Floats inverse = hn::Div(splat(-1.0F), hn::Max(normal.magnitude, splat(1e-18F)));
    normal.eye = {hn::Mul(eye.x, inverse), hn::Mul(eye.y, inverse), hn::Mul(eye.z, inverse)};
    normal.facing = dot(normal.eye, view);
    return normal;
}

/// x^n for x in [0, 1], n > 0; whole exponents by repeated squaring, others by exp and log.
HWY_NOINLINE inline Floats power(Floats x, float n) {
    const auto whole = static_cast<unsigned>(n);
    if (static_cast<float>(whole) != n || whole > 1024) {  // beyond, squaring costs as much as exp and log
        const Floats positive = hn::Max(x, splat(1e-30F)); // log of 0 is not wanted; 1e-30^n is as good as 0
        return hn::IfThenZeroElse(hn::Le(x, splat(0)), hn::Exp(kF, hn::Mul(splat(n), hn::Log(kF, positive))));
    }
    Floats result = splat(1);
    Floats square = x;
    for (unsigned bits = whole; bits != 0; bits >>= 1U) {
        if ((bits & 1U) != 0) {
            result = hn::Mul(result, square);
        }
        square = hn::Mul(square, square);
    }
    return result;
}

/// Colours of the lanes of a sample, RGBA one after the other: alpha is the directional opacity. From here on a lane is
/// a vector of its own, because its table entry or texels lie side by side in memory and its pixel does too.
struct LaneColours {
    alignas(64) float rgba[kMaxLanes * 4];
};

using Quad = hn::Vec<hn::Simd<float, 4, 0>>;
constexpr hn::Simd<float, 4, 0> kQuad;
constexpr hn::Simd<std::int32_t, 4, 0> kQuadInts;
constexpr hn::Simd<std::int16_t, 8, 0> kQuadPairs;

/// Four channels interpolated between two neighbours that lie interleaved (r0 r1 g0 g1 b0 b1 a0 a1, 15 bits each);
/// `weight`: (1-f, f) as pairWeights makes it. Times 32767^2.
HWY_INLINE Quad blendPairs(hn::Vec<decltype(kQuadPairs)> pairs, std::int32_t weight) {
    hn::Vec<decltype(kQuadInts)> rest = hn::Zero(kQuadInts);
    const auto weights = hn::BitCast(kQuadPairs, hn::Set(kQuadInts, weight));
    return hn::ConvertTo(kQuad, hn::ReorderWidenMulAccumulate(kQuadInts, pairs, weights, hn::Zero(kQuadInts), rest));
}

constexpr float kUnit = 1.0F / (32767.0F * 32767.0F);

/// One entry of a colour table and the next, interpolated.
HWY_INLINE Quad entryColour(const float* table, std::int32_t entry, float fraction) {
    const Quad here = hn::Load(kQuad, table + std::ptrdiff_t{4} * entry);
    const Quad next = hn::Load(kQuad, table + std::ptrdiff_t{4} * entry + 4);
    return hn::MulAdd(hn::Sub(next, here), hn::Set(kQuad, fraction), here);
}

/// Bilinear between four texels; two loads.
HWY_INLINE Quad texelColour(const KernelAtlas& atlas, std::ptrdiff_t texel, std::int32_t weight, float down) {
    const auto row = [&](std::ptrdiff_t first) HWY_ATTR {
        const auto two = hn::LoadU(kQuadPairs, atlas.texels + 4 * first); // r0 g0 b0 a0 r1 g1 b1 a1
        const auto swapped = hn::BitCast(kQuadPairs, hn::Shuffle1032(hn::BitCast(kQuadInts, two)));
        return blendPairs(hn::InterleaveLower(kQuadPairs, two, swapped), weight);
    };
    const Quad upper = row(texel);
    const Quad lower = row(texel + atlas.size);
    return hn::Mul(hn::MulAdd(hn::Sub(lower, upper), hn::Set(kQuad, down), upper), hn::Set(kQuad, kUnit));
}

struct LaneInts {
    alignas(64) std::int32_t at[kMaxLanes];
    HWY_INLINE explicit LaneInts(Ints v) { hn::Store(v, kI, at); }
};
struct LaneFloats {
    alignas(64) float at[kMaxLanes];
    HWY_INLINE explicit LaneFloats(Floats v) { hn::Store(v, kF, at); }
};

/// A place in a table: whole entry and how far it is to the next.
struct EntryLanes {
    LaneInts entry;
    LaneFloats fraction;
    HWY_INLINE explicit EntryLanes(Floats tableEntry)
        : entry(truncate(tableEntry)), fraction(hn::Sub(tableEntry, toFloat(truncate(tableEntry)))) {}
};

HWY_INLINE void flatColours(const KernelLayer& layer, Floats tableEntry, LaneColours& out) {
    const EntryLanes at(tableEntry);
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        hn::Store(entryColour(layer.colours, at.entry.at[lane], at.fraction.at[lane]), kQuad, out.rgba + 4 * lane);
    }
}

/// Head-light Phong as core/optics/phong.h has it: ambient 0.1, diffuse 0.7, and the layer's specular term.
HWY_INLINE void phongColours(const KernelLayer& layer, Floats tableEntry, Floats facing, LaneColours& out) {
    const Floats lit = hn::Min(layer.twoSided ? hn::Abs(facing) : hn::Max(facing, splat(0)), splat(1));
    const LaneFloats factor(hn::MulAdd(lit, splat(0.7F), splat(0.1F)));
    const LaneFloats highlight(hn::Mul(splat(layer.specularStrength), power(lit, layer.specularExponent)));
    const EntryLanes at(tableEntry);
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        const Quad c = entryColour(layer.colours, at.entry.at[lane], at.fraction.at[lane]);
        const Quad shaded = hn::MulAdd(c, hn::Set(kQuad, factor.at[lane]), hn::Set(kQuad, highlight.at[lane]));
        hn::Store(hn::Min(shaded, hn::Set(kQuad, 1.0F)), kQuad, out.rgba + 4 * lane);
    }
}

/// Where on the sphere's picture a normal looks: the upper left of four texels, and weights.
struct SpherePlace {
    Ints texel;     ///< row * size + column
    LaneInts right; ///< pairWeights
    LaneFloats down;
};

HWY_INLINE SpherePlace spherePlace(const KernelScene& scene, const KernelLayer& layer, const Normal& normal,
                                   const Vec3& view) {
    Floats x = normal.eye.x;
    Floats y = normal.eye.y;
    if (scene.perspective) { // the normal in the frame of the ray (spec style-transfer-functions 1)
        const Floats k = hn::Div(hn::Add(normal.facing, normal.eye.z), hn::Add(splat(1), view.z));
        x = hn::NegMulAdd(view.x, k, x);
        y = hn::NegMulAdd(view.y, k, y);
    }
    const float half = 0.5F * static_cast<float>(scene.atlas.size);
    Floats scale = splat(half);
    if (layer.twoSided) {
        scale = hn::CopySign(scale, normal.facing);
    }
    const Floats last = splat(static_cast<float>(scene.atlas.size - 1));
    const auto inside = [&](Floats v) HWY_ATTR { return hn::Min(hn::Max(v, splat(0)), last); };
    const Floats u = inside(hn::MulAdd(x, scale, splat(half - 0.5F)));
    const Floats v = inside(hn::NegMulAdd(y, scale, splat(half - 0.5F)));
    const Ints column = truncate(u);
    const Ints row = truncate(v);
    return {hn::Add(hn::Mul(row, splatInt(scene.atlas.size)), column),
            LaneInts(pairWeights(hn::Sub(u, toFloat(column)))), LaneFloats(hn::Sub(v, toFloat(row)))};
}

/// How far a normal is trusted: 0 at the gradient floor, 1 from twice of it on (numerics 2a).
HWY_INLINE Floats trust(const KernelScene& scene, Floats magnitude) {
    const Floats floor = splat(scene.gradientFloor);
    const Floats t =
        hn::Min(hn::Max(hn::Div(hn::Sub(magnitude, floor), hn::Max(floor, splat(1e-30F))), splat(0)), splat(1));
    return hn::Mul(hn::Mul(t, t), hn::NegMulAdd(splat(2), t, splat(3)));
}

/// Colours of one style per lane; where there is no normal, the style's mean.
HWY_INLINE void sphereColours(const KernelAtlas& atlas, const SpherePlace& place, Ints slot, Floats trusted,
                              LaneColours& out) {
    const LaneInts texel(hn::Add(hn::Mul(slot, splatInt(atlas.size * atlas.size)), place.texel));
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        const Quad c = texelColour(atlas, texel.at[lane], place.right.at[lane], place.down.at[lane]);
        hn::Store(c, kQuad, out.rgba + 4 * lane);
    }
    if (hn::AllTrue(kF, hn::Ge(trusted, splat(1)))) {
        return;
    }
    const LaneInts slots(slot);
    const LaneFloats share(trusted);
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        if (share.at[lane] < 1) {
            const Quad mean = hn::LoadU(kQuad, atlas.mean + std::ptrdiff_t{4} * slots.at[lane]);
            const Quad c = hn::Load(kQuad, out.rgba + 4 * lane);
            hn::Store(hn::MulAdd(hn::Sub(c, mean), hn::Set(kQuad, share.at[lane]), mean), kQuad, out.rgba + 4 * lane);
        }
    }
}

/// `sft(ift(tft(s)))`: the style or the blend of two, at a normal. Whole node indices cost one lookup.
HWY_INLINE void styleColours(const KernelScene& scene, const KernelLayer& layer, Floats tableEntry,
                             const Normal& normal, const Vec3& view, LaneColours& out) {
    const KernelAtlas& atlas = scene.atlas;
    const SpherePlace place = spherePlace(scene, layer, normal, view);
    const Floats trusted = trust(scene, normal.magnitude);
    if (layer.singleSlot >= 0) {
        sphereColours(atlas, place, splatInt(layer.singleSlot), trusted, out);
        return;
    }
    const Floats index = TablePlace(tableEntry).read(layer.index);
    const Ints node = truncate(index);
    const Ints next = hn::Min(hn::Add(node, splatInt(1)), splatInt(layer.lastNode));
    const Ints first = gatherAt(layer.slotOfNode, hn::ShiftLeft<2>(node));
    const Ints second = gatherAt(layer.slotOfNode, hn::ShiftLeft<2>(next));
    sphereColours(atlas, place, first, trusted, out);
    const Floats toSecond =
        hn::IfThenZeroElse(hn::RebindMask(kF, hn::Eq(first, second)), hn::Sub(index, toFloat(node)));
    if (hn::AllFalse(kF, hn::Gt(toSecond, splat(0)))) {
        return;
    }
    LaneColours other;
    sphereColours(atlas, place, second, trusted, other);
    const LaneFloats weight(toSecond);
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        const Quad c = hn::Load(kQuad, out.rgba + 4 * lane);
        const Quad towards = hn::Sub(hn::Load(kQuad, other.rgba + 4 * lane), c);
        hn::Store(hn::MulAdd(towards, hn::Set(kQuad, weight.at[lane]), c), kQuad, out.rgba + 4 * lane);
    }
}

/// Colours of a sample in one layer. Each lane's result depends on that lane alone.
template <typename Field>
HWY_NOINLINE void sampleColours(const Field& field, const KernelLayer& layer, const typename Field::Place& place,
                                Floats tableEntry, const Vec3& view, LaneColours& out) {
    if (layer.shading == Shading::flat) {
        flatColours(layer, tableEntry, out);
        return;
    }
    const Normal normal = normalAt(field, place, view);
    if (layer.shading == Shading::phong) {
        phongColours(layer, tableEntry, normal.facing, out);
    } else {
        styleColours(field.scene, layer, tableEntry, normal, view, out);
    }
}

/// Opacity of one step from that of the reference length.
HWY_NOINLINE inline Floats opacityOfStep(const KernelScene& scene, Floats opacity, Floats steps) {
    const Floats depth =
        hn::Mul(hn::Mul(splat(scene.stepRatio), steps), hn::Log1p(kF, hn::Neg(hn::Min(opacity, splat(1.0F - 1e-7F)))));
    return hn::IfThenElse(hn::Ge(opacity, splat(1.0F - 1e-7F)), splat(1), hn::Neg(hn::Expm1(kF, depth)));
}

/// Opacity of a part of a step from that of the whole.
HWY_NOINLINE inline Floats opacityOfPart(Floats opacity, Floats part) {
    const Floats depth = hn::Mul(part, hn::Log1p(kF, hn::Neg(hn::Min(opacity, splat(1.0F - 1e-7F)))));
    const Floats cut = hn::IfThenElse(hn::Ge(opacity, splat(1.0F - 1e-7F)), splat(1), hn::Neg(hn::Expm1(kF, depth)));
    return hn::IfThenElse(hn::Ge(part, splat(1)), opacity,
                          cut); // a whole step bit for bit, whoever else is in the vector
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
