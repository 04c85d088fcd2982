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

struct Colour {
    Floats r, g, b;
};

/// The unit normal in eye space, out of dense matter, and how far it can be trusted.
struct Normal {
    Vec3 eye;
    Floats facing;    ///< normal . view
    Floats magnitude; ///< of the gradient, data's unit per mm
};

template <typename Field>
HWY_NOINLINE Normal normalAt(const Field& field, const typename Field::Place& place, const Vec3& view) {
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

HWY_INLINE Colour tableColour(const KernelLayer& layer, const TablePlace& at) {
    return {at.read(layer.red), at.read(layer.green), at.read(layer.blue)};
}

/// Head-light Phong as core/optics/phong.h has it: ambient 0.1, diffuse 0.7, and the layer's specular term.
HWY_INLINE Colour phong(const KernelLayer& layer, Colour c, Floats facing) {
    const Floats lit = layer.twoSided ? hn::Abs(facing) : hn::Max(facing, splat(0));
    const Floats clamped = hn::Min(lit, splat(1));
    const Floats factor = hn::MulAdd(clamped, splat(0.7F), splat(0.1F));
    const Floats highlight = hn::Mul(splat(layer.specularStrength), power(clamped, layer.specularExponent));
    const auto one = [&](Floats v) HWY_ATTR { return hn::Min(hn::MulAdd(v, factor, highlight), splat(1)); };
    return {one(c.r), one(c.g), one(c.b)};
}

/// Where on the sphere's picture a normal looks: texel coordinates of the upper left of four, and weights.
struct SpherePlace {
    Ints texel; ///< row * size + column
    Floats fx, fy;
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
    return {hn::Add(hn::Mul(row, splatInt(scene.atlas.size)), column), hn::Sub(u, toFloat(column)),
            hn::Sub(v, toFloat(row))};
}

HWY_INLINE Floats bilinear(Floats a, Floats b, Floats c, Floats d, const SpherePlace& at) {
    return lerp(lerp(a, b, at.fx), lerp(c, d, at.fx), at.fy);
}

/// One style's colour: two loads of two neighbouring texels.
HWY_INLINE Colour sphereColour(const KernelAtlas& atlas, const SpherePlace& at, Ints firstTexel) {
    Offsets<std::int32_t> offsets;
    store(hn::ShiftLeft<2>(hn::Add(firstTexel, at.texel)), offsets);
    const WordPair upper = gatherPairs(atlas.rgb, offsets);
    const WordPair lower = gatherPairs(atlas.rgb + atlas.size, offsets);
    const auto red = [](Ints w) HWY_ATTR { return toFloat(hn::And(w, splatInt(2047))); };
    const auto green = [](Ints w) HWY_ATTR { return toFloat(hn::And(hn::ShiftRight<11>(w), splatInt(2047))); };
    const auto blue = [](Ints w) HWY_ATTR { return toFloat(hn::BitCast(kI, hn::ShiftRight<22>(hn::BitCast(kU, w)))); };
    const Floats r = bilinear(red(upper.low), red(upper.high), red(lower.low), red(lower.high), at);
    const Floats g = bilinear(green(upper.low), green(upper.high), green(lower.low), green(lower.high), at);
    const Floats b = bilinear(blue(upper.low), blue(upper.high), blue(lower.low), blue(lower.high), at);
    return {hn::Mul(r, splat(1.0F / 2047)), hn::Mul(g, splat(1.0F / 2047)), hn::Mul(b, splat(1.0F / 1023))};
}

HWY_INLINE Floats sphereAlpha(const KernelAtlas& atlas, const SpherePlace& at, Ints firstTexel) {
    Offsets<std::int32_t> offsets;
    store(hn::ShiftLeft<1>(hn::Add(firstTexel, at.texel)), offsets);
    const Ints upper = gatherWords(atlas.alpha, offsets);
    const Ints lower = gatherWords(atlas.alpha + atlas.size, offsets);
    const auto low = [](Ints w) HWY_ATTR { return toFloat(hn::And(w, splatInt(65535))); };
    const auto high = [](Ints w) HWY_ATTR { return toFloat(shiftRightLogical16(w)); };
    return hn::Mul(bilinear(low(upper), high(upper), low(lower), high(lower), at), splat(1.0F / 65535));
}

/// Where the normal is undefined a sample takes the style's mean, blended over [floor, 2 floor] (numerics 2a).
HWY_INLINE Floats trust(const KernelScene& scene, Floats magnitude) {
    const Floats floor = splat(scene.gradientFloor);
    const Floats t =
        hn::Min(hn::Max(hn::Div(hn::Sub(magnitude, floor), hn::Max(floor, splat(1e-30F))), splat(0)), splat(1));
    return hn::Mul(hn::Mul(t, t), hn::NegMulAdd(splat(2), t, splat(3)));
}

struct StyleSample {
    Colour colour;
    Floats alpha; ///< directional opacity
};

HWY_INLINE StyleSample mix(const StyleSample& a, const StyleSample& b, Floats t) {
    return {{lerp(a.colour.r, b.colour.r, t), lerp(a.colour.g, b.colour.g, t), lerp(a.colour.b, b.colour.b, t)},
            lerp(a.alpha, b.alpha, t)};
}

HWY_INLINE StyleSample choose(Mask mask, const StyleSample& yes, const StyleSample& no) {
    return {{hn::IfThenElse(mask, yes.colour.r, no.colour.r), hn::IfThenElse(mask, yes.colour.g, no.colour.g),
             hn::IfThenElse(mask, yes.colour.b, no.colour.b)},
            hn::IfThenElse(mask, yes.alpha, no.alpha)};
}

HWY_NOINLINE inline StyleSample sphereSample(const KernelScene& scene, const KernelLayer& layer, const SpherePlace& at,
                                             Ints slot, Floats trusted) {
    const KernelAtlas& atlas = scene.atlas;
    const Ints first = hn::Mul(slot, splatInt(atlas.size * atlas.size));
    StyleSample sample;
    sample.colour = sphereColour(atlas, at, first);
    sample.alpha = layer.directionalOpacity ? sphereAlpha(atlas, at, first) : splat(1);
    if (!hn::AllTrue(kF, hn::Ge(trusted, splat(1)))) {
        const Ints entry = hn::ShiftLeft<2>(slot);
        const StyleSample mean = {
            {gatherFloats(atlas.mean, entry), gatherFloats(atlas.mean + 1, entry), gatherFloats(atlas.mean + 2, entry)},
            gatherFloats(atlas.mean + 3, entry)};
        const Mask whole = hn::Ge(trusted, splat(1)); // exactly the sample, whoever else is in the vector
        return choose(whole, sample, mix(mean, sample, trusted));
    }
    return sample;
}

/// `sft(ift(tft(s)))`: the style or the blend of two, at a normal. A whole index costs one lookup.
HWY_INLINE StyleSample styleSample(const KernelScene& scene, const KernelLayer& layer, const TablePlace& at,
                                   const Normal& normal, const Vec3& view) {
    const SpherePlace place = spherePlace(scene, layer, normal, view);
    const Floats trusted = trust(scene, normal.magnitude);
    if (layer.singleSlot >= 0) {
        return sphereSample(scene, layer, place, splatInt(layer.singleSlot), trusted);
    }
    const Floats index = at.read(layer.index);
    const Ints node = truncate(index);
    const Floats weight = hn::Sub(index, toFloat(node));
    const Ints next = hn::Min(hn::Add(node, splatInt(1)), splatInt(layer.lastNode));
    const Ints slot0 = gatherAt(layer.slotOfNode, hn::ShiftLeft<2>(node));
    const Ints slot1 = gatherAt(layer.slotOfNode, hn::ShiftLeft<2>(next));
    const StyleSample first = sphereSample(scene, layer, place, slot0, trusted);
    const Mask blended = hn::And(hn::Gt(weight, splat(0)), hn::RebindMask(kF, hn::Ne(slot0, slot1)));
    if (hn::AllFalse(kF, blended)) {
        return first;
    }
    return mix(first, sphereSample(scene, layer, place, slot1, trusted), weight);
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

/// Colour of a sample whose opacity does not depend on it.
template <typename Field>
HWY_INLINE Colour sampleColour(const Field& field, const KernelLayer& layer, const typename Field::Place& place,
                               const TablePlace& at, const Vec3& view) {
    if (layer.shading == Shading::flat) {
        return tableColour(layer, at);
    }
    const Normal normal = normalAt(field, place, view);
    if (layer.shading == Shading::phong) {
        return phong(layer, tableColour(layer, at), normal.facing);
    }
    return styleSample(field.scene, layer, at, normal, view).colour;
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
