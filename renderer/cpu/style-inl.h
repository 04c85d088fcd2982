// Colours by lit-sphere styles and by plain colours; compiled once for every instruction set.
#if defined(LIMNER_STYLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_STYLE_INL_H
#undef LIMNER_STYLE_INL_H
#else
#define LIMNER_STYLE_INL_H
#endif

#include "renderer/cpu/lanes-inl.h"
#include "renderer/scene/kernel_scene.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// Colours of the lanes of a sample, RGBA one after the other: alpha is the directional opacity. From here on a lane is
/// a vector of its own, because its table entry or texels lie side by side in memory and its pixel does too.
struct LaneColours {
    alignas(64) float rgba[kMaxLanes * 4];
};

using Quad = hn::Vec<hn::Simd<float, 4, 0>>;
constexpr hn::Simd<float, 4, 0> kQuad;
constexpr hn::Simd<std::int32_t, 4, 0> kQuadInts;
constexpr hn::Simd<std::int16_t, 8, 0> kQuadPairs;

/// The alpha of an RGBA.
HWY_INLINE auto alphaLane() {
    alignas(16) static constexpr std::uint32_t kBits[4] = {0, 0, 0, 0xFFFFFFFFU};
    return hn::MaskFromVec(hn::Load(kQuad, reinterpret_cast<const float*>(kBits)));
}

struct LaneInts {
    alignas(64) std::int32_t at[kMaxLanes];
    LaneInts() = default;
    HWY_INLINE explicit LaneInts(Ints v) { hn::Store(v, kI, at); }
    HWY_INLINE LaneInts& operator=(Ints v) { // a copy would move the unused lanes as well
        hn::Store(v, kI, at);
        return *this;
    }
};
struct LaneFloats {
    alignas(64) float at[kMaxLanes];
    LaneFloats() = default;
    HWY_INLINE explicit LaneFloats(Floats v) { hn::Store(v, kF, at); }
    HWY_INLINE LaneFloats& operator=(Floats v) {
        hn::Store(v, kF, at);
        return *this;
    }
};

/// One entry of a colour table and the next, interpolated.
HWY_INLINE Quad entryColour(const float* table, std::int32_t entry, float fraction) {
    const Quad here = hn::Load(kQuad, table + std::ptrdiff_t{4} * entry);
    const Quad next = hn::Load(kQuad, table + std::ptrdiff_t{4} * entry + 4);
    return hn::MulAdd(hn::Sub(next, here), hn::Set(kQuad, fraction), here);
}

/// A place in a table: whole entry and how far it is to the next.
struct EntryLanes {
    LaneInts entry;
    LaneFloats fraction;
    HWY_INLINE explicit EntryLanes(Floats tableEntry)
        : entry(truncate(tableEntry)), fraction(hn::Sub(tableEntry, toFloat(truncate(tableEntry)))) {}
};

/// The nodes of a transfer function around a place, with their weights: one, two of a line, or four of a grid.
struct NodeBlend {
    Ints node[4];
    Floats weight[4]; ///< sum 1
    int count = 1;
};

/// Where on a sphere's picture a normal looks: the upper left of four texels, and how far it is to the others.
struct SpherePlace {
    Ints texel; ///< row * size + column
    Floats right, down;
};

/// What a sample asks of every sphere.
struct SphereQuery {
    Floats x, y;    ///< on the disk, y up
    Floats level;   ///< mip level, up to the last; not read where there is only one
    Floats trusted; ///< as Facts
};

/// `size`: of the sphere's picture, texels.
HWY_INLINE SpherePlace spherePlace(Ints size, const SphereQuery& query) {
    const Floats whole = toFloat(size);
    const Floats half = hn::Mul(whole, splat(0.5F));
    const Floats middle = hn::Sub(half, splat(0.5F));
    const Floats last = hn::Sub(whole, splat(1));
    const auto inside = [&](Floats v) HWY_ATTR { return hn::Min(hn::Max(v, splat(0)), last); };
    const Floats u = inside(hn::MulAdd(query.x, half, middle));
    const Floats v = inside(hn::NegMulAdd(query.y, half, middle));
    const Ints column = truncate(u);
    const Ints row = truncate(v);
    return {hn::Add(hn::Mul(row, size), column), hn::Sub(u, toFloat(column)), hn::Sub(v, toFloat(row))};
}

constexpr float kWhole = 32767.0F; ///< weight 1 of the integer interpolation
constexpr float kUnit = 1.0F / (kWhole * kWhole);

/// A whole number of parts of `whole`, for a share from 0 to 1.
HWY_INLINE Ints shareOf(Ints whole, Floats share) { return truncate(hn::MulAdd(toFloat(whole), share, splat(0.5F))); }

/// Weights of a pair of neighbours, as pairs of 16-bit numbers in one word.
HWY_INLINE Ints pairOf(Ints whole, Floats right) {
    const Ints second = shareOf(whole, right);
    return hn::Or(hn::ShiftLeft<16>(second), hn::Sub(whole, second));
}

/// One sphere's texels and their weights, per lane.
struct SphereTaps {
    LaneInts texel; ///< of the atlas
    LaneInts upper; ///< weights of the upper pair of texels
    LaneInts lower;
    /// `first`: texel of the atlas at which the sphere's picture begins.
    HWY_INLINE void set(const SpherePlace& place, Ints first, Ints whole) {
        texel = hn::Add(first, place.texel);
        const Ints below = shareOf(whole, place.down);
        upper = pairOf(hn::Sub(whole, below), place.right);
        lower = pairOf(below, place.right);
    }
    /// Adds this sphere's part of a lane's colour, times kWhole^2: two multiply-adds of the four channels' pairs.
    /// `size`: of the picture, texels.
    HWY_INLINE void addTo(hn::Vec<decltype(kQuadInts)>& sum, const std::int16_t* texels, std::int32_t size,
                          std::size_t lane) const {
        const std::int16_t* at = texels + std::ptrdiff_t{4} * texel.at[lane];
        sum = added(sum, at, upper.at[lane]);
        sum = added(sum, at + std::ptrdiff_t{4} * size, lower.at[lane]);
    }

  private:
    static HWY_INLINE hn::Vec<decltype(kQuadInts)> added(hn::Vec<decltype(kQuadInts)> sum, const std::int16_t* texels,
                                                         std::int32_t weights) {
        alignas(16) static constexpr std::uint8_t kPairs[16] = {0, 1, 8, 9, 2, 3, 10, 11, 4, 5, 12, 13, 6, 7, 14, 15};
        const hn::Simd<std::uint8_t, 16, 0> bytes;
        const auto two = hn::BitCast(bytes, hn::LoadU(kQuadPairs, texels)); // r g b a of two neighbours
        const auto pairs = hn::BitCast(kQuadPairs, hn::TableLookupBytes(two, hn::Load(bytes, kPairs)));
        hn::Vec<decltype(kQuadInts)> rest = hn::Zero(kQuadInts);
        return hn::ReorderWidenMulAccumulate(kQuadInts, pairs, hn::BitCast(kQuadPairs, hn::Set(kQuadInts, weights)),
                                             sum, rest);
    }
};

HWY_INLINE void storeSum(hn::Vec<decltype(kQuadInts)> sum, float* rgba) {
    hn::Store(hn::Mul(hn::ConvertTo(kQuad, sum), hn::Set(kQuad, kUnit)), kQuad, rgba);
}

template <int Count>
HWY_INLINE void blendSpheres(const KernelAtlas& atlas, const SphereTaps* taps, LaneColours& out) {
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        hn::Vec<decltype(kQuadInts)> sum = hn::Zero(kQuadInts);
        for (int i = 0; i < Count; ++i) {
            taps[i].addTo(sum, atlas.texels, atlas.size, lane);
        }
        storeSum(sum, out.rgba + 4 * lane);
    }
}

/// The weights of several nodes in whole numbers that add up to kWhole.
struct WholeWeights {
    Ints at[4];
    HWY_INLINE explicit WholeWeights(const NodeBlend& nodes) {
        Ints rest = splatInt(static_cast<std::int32_t>(kWhole));
        for (int i = nodes.count - 1; i > 0; --i) {
            at[i] = hn::Min(shareOf(splatInt(static_cast<std::int32_t>(kWhole)), nodes.weight[i]), rest);
            rest = hn::Sub(rest, at[i]);
        }
        at[0] = rest;
    }
};

/// Where a normal means little, a style shows its mean: `trusted` 0 to 1.
HWY_NOINLINE inline void towardsMean(const KernelAtlas& atlas, const NodeBlend& slots, Floats trusted,
                                     LaneColours& out) {
    const LaneFloats share(trusted);
    LaneInts slot[4];
    LaneFloats weight[4];
    for (int i = 0; i < slots.count; ++i) {
        slot[i] = slots.node[i];
        weight[i] = slots.weight[i];
    }
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        if (share.at[lane] < 1) {
            Quad mean = hn::Zero(kQuad);
            for (int i = 0; i < slots.count; ++i) {
                const Quad one = hn::LoadU(kQuad, atlas.mean + std::ptrdiff_t{4} * slot[i].at[lane]);
                mean = hn::MulAdd(hn::Set(kQuad, weight[i].at[lane]), one, mean);
            }
            const Quad c = hn::Load(kQuad, out.rgba + 4 * lane);
            hn::Store(hn::MulAdd(hn::Sub(c, mean), hn::Set(kQuad, share.at[lane]), mean), kQuad, out.rgba + 4 * lane);
        }
    }
}

/// The blend of the spheres in some slots, each read from the atlas's finest pictures.
HWY_INLINE void finestColours(const KernelAtlas& atlas, const SphereQuery& query, const NodeBlend& slots,
                              LaneColours& out) {
    SphereTaps taps[4];
    const WholeWeights weights(slots);
    const SpherePlace place = spherePlace(splatInt(atlas.size), query);
    for (int i = 0; i < slots.count; ++i) {
        taps[i].set(place, hn::Mul(slots.node[i], splatInt(atlas.size * atlas.size)), weights.at[i]);
    }
    switch (slots.count) {
    case 1: blendSpheres<1>(atlas, taps, out); break;
    case 2: blendSpheres<2>(atlas, taps, out); break;
    default: blendSpheres<4>(atlas, taps, out); break;
    }
}

/// The same between the two mip levels around the one that each lane asks for.
HWY_NOINLINE inline void levelColours(const KernelAtlas& atlas, const SphereQuery& query, const NodeBlend& slots,
                                      LaneColours& out) {
    const Ints fine = truncate(query.level);
    const Floats beyond = hn::Sub(query.level, toFloat(fine));
    const int levels = hn::AllFalse(kF, hn::Gt(beyond, splat(0))) ? 1 : 2;
    const WholeWeights weights(slots);
    SphereTaps taps[2][4];
    LaneInts sizes[2];
    for (int k = 0; k < levels; ++k) {
        const Ints level = hn::Min(hn::Add(fine, splatInt(k)), splatInt(atlas.lastLevel));
        const Ints size = hn::Shr(splatInt(atlas.size), level);
        const Ints start = gatherAt(atlas.levelStart, hn::ShiftLeft<2>(level));
        const SpherePlace place = spherePlace(size, query);
        sizes[k] = size;
        for (int i = 0; i < slots.count; ++i) {
            const Ints coarse = shareOf(weights.at[i], beyond);
            const Ints first = hn::Add(start, hn::Mul(slots.node[i], hn::Mul(size, size)));
            taps[k][i].set(place, first, k == 0 ? hn::Sub(weights.at[i], coarse) : coarse);
        }
    }
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        hn::Vec<decltype(kQuadInts)> sum = hn::Zero(kQuadInts);
        for (int k = 0; k < levels; ++k) {
            for (int i = 0; i < slots.count; ++i) {
                taps[k][i].addTo(sum, atlas.texels, sizes[k].at[lane], lane);
            }
        }
        storeSum(sum, out.rgba + 4 * lane);
    }
}

/// `sft`: the blend of the spheres in some slots of the atlas at a normal; `slots.node` are slots.
HWY_INLINE void sphereColours(const KernelAtlas& atlas, const SphereQuery& query, const NodeBlend& slots,
                              LaneColours& out) {
    if (atlas.levelStart == nullptr) {
        finestColours(atlas, query, slots, out);
    } else {
        levelColours(atlas, query, slots, out);
    }
    if (!hn::AllTrue(kF, hn::Ge(query.trusted, splat(1)))) {
        towardsMean(atlas, slots, query.trusted, out);
    }
}

/// Slots of nodes. Where both nodes of a line have the same sphere, or the second has no weight, one look-up will do.
HWY_INLINE NodeBlend slotsOf(const std::int32_t* slotOfNode, const NodeBlend& nodes) {
    NodeBlend slots = nodes;
    for (int i = 0; i < nodes.count; ++i) {
        slots.node[i] = gatherAt(slotOfNode, hn::ShiftLeft<2>(nodes.node[i]));
    }
    if (nodes.count == 2) {
        const Mask same = hn::RebindMask(kF, hn::Eq(slots.node[0], slots.node[1]));
        slots.weight[1] = hn::IfThenZeroElse(same, slots.weight[1]);
        slots.weight[0] = hn::Sub(splat(1), slots.weight[1]);
        if (hn::AllFalse(kF, hn::Gt(slots.weight[1], splat(0)))) {
            slots.count = 1;
        }
    }
    return slots;
}

/// Plain colours of a table's entries.
struct PlainEntries {
    const float* table;
    EntryLanes at;
    HWY_INLINE PlainEntries(const float* colours, Floats tableEntry) : table(colours), at(tableEntry) {}
    HWY_INLINE Quad colour(std::size_t lane) const {
        return entryColour(table, at.entry.at[lane], at.fraction.at[lane]);
    }
};

/// One colour, whatever the entry.
struct PlainColour {
    Quad rgba;
    HWY_INLINE explicit PlainColour(const float* colour) : rgba(hn::Load(kQuad, colour)) {}
    [[nodiscard]] HWY_INLINE Quad colour(std::size_t /*lane*/) const { return rgba; }
};

/// The blend of the plain colours of some nodes.
struct PlainNodes {
    const float* colours;
    int count;
    LaneInts node[4];
    LaneFloats weight[4];
    HWY_INLINE PlainNodes(const float* nodeColours, const NodeBlend& nodes) : colours(nodeColours), count(nodes.count) {
        for (int i = 0; i < nodes.count; ++i) {
            node[i] = nodes.node[i];
            weight[i] = nodes.weight[i];
        }
    }
    HWY_INLINE Quad colour(std::size_t lane) const {
        Quad sum = hn::Zero(kQuad);
        for (int i = 0; i < count; ++i) {
            const Quad one = hn::Load(kQuad, colours + std::ptrdiff_t{4} * node[i].at[lane]);
            sum = hn::MulAdd(hn::Set(kQuad, weight[i].at[lane]), one, sum);
        }
        return sum;
    }
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
