// Textures laid on the object, apart from its lighting; compiled once for every instruction set.
#if defined(LIMNER_TEXTURE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_TEXTURE_INL_H
#undef LIMNER_TEXTURE_INL_H
#else
#define LIMNER_TEXTURE_INL_H
#endif

#include "renderer/cpu/facts-inl.h" // names the target: before the formulas
#include "renderer/cpu/style-inl.h"

#include "core/optics/texture.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// Where samples lie on the object, and how squarely they face its axes.
struct TexturePlace {
    LaneFloats mm[3];
    LaneFloats weight[3]; ///< of the projections along x, y and z
    LaneFloats trusted;

    HWY_INLINE TexturePlace(const KernelScene& scene, const Vec3& q, const Vec3& normalEye, Floats trust)
        : trusted(trust) {
        for (int axis = 0; axis < 3; ++axis) {
            const float* m = scene.mmFromCell[axis];
            mm[axis] = hn::Add(dot(q, {splat(m[0]), splat(m[1]), splat(m[2])}), splat(m[3]));
        }
        const Vec3 n = turned(scene.mmFromEye, normalEye);
        const auto weights = optics::projectionWeights(optics::Vector3<Lanes>{Lanes{n.x}, Lanes{n.y}, Lanes{n.z}});
        weight[0] = weights.x.v;
        weight[1] = weights.y.v;
        weight[2] = weights.z.v;
    }
};

/// Bilinear, repeating; `u` and `v` in tiles (TextureTile::at).
HWY_INLINE Quad tileFactor(const KernelTexture& texture, float u, float v) {
    const auto along = [&](float tiles, std::int32_t& low, std::int32_t& high) HWY_ATTR {
        const float at = (tiles - std::floor(tiles)) * static_cast<float>(texture.size) - 0.5F;
        const float below = std::floor(at);
        low = static_cast<std::int32_t>(below) & (texture.size - 1);
        high = (low + 1) & (texture.size - 1);
        return hn::Set(kQuad, at - below);
    };
    std::int32_t left, right, upper, lower;
    const Quad across = along(u, left, right);
    const Quad down = along(v, upper, lower);
    const auto row = [&](std::int32_t line) HWY_ATTR {
        const float* texels = texture.texels + std::ptrdiff_t{4} * line * texture.size;
        const Quad a = hn::LoadU(kQuad, texels + std::ptrdiff_t{4} * left);
        const Quad b = hn::LoadU(kQuad, texels + std::ptrdiff_t{4} * right);
        return hn::MulAdd(hn::Sub(b, a), across, a);
    };
    const Quad top = row(upper);
    return hn::MulAdd(hn::Sub(row(lower), top), down, top);
}

/// One style's factor at one lane.
HWY_INLINE Quad laidFactor(const KernelTexture& texture, const TexturePlace& place, std::size_t lane) {
    const Quad one = hn::Set(kQuad, 1.0F);
    if (texture.texels == nullptr) {
        return one;
    }
    const float x = place.mm[0].at[lane] * texture.perMm;
    const float y = place.mm[1].at[lane] * texture.perMm;
    const float z = place.mm[2].at[lane] * texture.perMm;
    const float u[3] = {y, x, x};
    const float v[3] = {-z, -z, y};
    Quad laid = hn::Zero(kQuad);
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float weight = place.weight[axis].at[lane];
        if (weight > 0) {
            laid = hn::MulAdd(hn::Set(kQuad, weight), tileFactor(texture, u[axis], v[axis]), laid);
            sum += weight;
        }
    }
    const float seen = texture.strength * place.trusted.at[lane] * sum;
    return hn::MulAdd(hn::Sub(laid, one), hn::Set(kQuad, seen), one);
}

/// The textures of the blended styles as one factor of the colours; alpha stays.
HWY_NOINLINE inline void layTextures(const TexturePlace& place, const KernelTexture* textures, const NodeBlend& nodes,
                                     LaneColours& colours) {
    LaneInts node[4];
    LaneFloats weight[4];
    for (int i = 0; i < nodes.count; ++i) {
        node[i] = nodes.node[i];
        weight[i] = nodes.weight[i];
    }
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        Quad factor = hn::Zero(kQuad);
        for (int i = 0; i < nodes.count; ++i) {
            const float share = weight[i].at[lane];
            if (share > 0) {
                factor = hn::MulAdd(hn::Set(kQuad, share), laidFactor(textures[node[i].at[lane]], place, lane), factor);
            }
        }
        float* rgba = colours.rgba + 4 * lane;
        const float alpha = rgba[3];
        hn::Store(hn::Min(hn::Mul(hn::Load(kQuad, rgba), factor), hn::Set(kQuad, 1.0F)), kQuad, rgba);
        rgba[3] = alpha;
    }
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
