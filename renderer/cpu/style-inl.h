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

/// Weights of the upper and the lower two of four texels, per lane: a pair of 16-bit numbers each, all four together
/// kWhole.
struct TexelWeights {
    Ints upper, lower;
    HWY_INLINE explicit TexelWeights(const SpherePlace& place) {
        const hn::Repartition<std::int16_t, IntTag> shorts;
        const auto whole = [](Floats share)
                               HWY_ATTR { return truncate(hn::MulAdd(share, splat(kWhole), splat(0.5F))); };
        const Ints right = whole(place.right);
        const Ints down = whole(place.down);
        const Ints left = hn::Sub(splatInt(static_cast<std::int32_t>(kWhole)), right);
        const auto across = hn::BitCast(shorts, hn::Or(hn::ShiftLeft<16>(right), left));
        const auto along = hn::BitCast(shorts, hn::Or(hn::ShiftLeft<16>(down), down));
        const auto below = hn::MulFixedPoint15(across, along);
        lower = hn::BitCast(kI, below);
        upper = hn::BitCast(kI, hn::Sub(across, below));
    }
};

/// Adds two neighbouring texels of kBlocks lanes by their weights: a multiply-add of the channels' pairs.
/// `at`: four times the number of the left one.
HWY_INLINE Ints addedPairs(Ints sum, const std::int16_t* texels, const std::int32_t* at, Ints weights) {
    alignas(16) static constexpr std::uint8_t kPairs[16] = {0, 1, 8, 9, 2, 3, 10, 11, 4, 5, 12, 13, 6, 7, 14, 15};
    const hn::Repartition<std::uint8_t, IntTag> bytes;
    const hn::Repartition<std::int16_t, IntTag> shorts;
    const auto two = hn::BitCast(bytes, gatherBlocks(texels, at)); // r g b a of both
    const auto pairs = hn::BitCast(shorts, hn::TableLookupBytes(two, hn::LoadDup128(bytes, kPairs)));
    Ints rest = hn::Zero(kI);
    return hn::ReorderWidenMulAccumulate(kI, pairs, hn::BitCast(shorts, weights), sum, rest);
}

/// Of one sphere: its colour at the four texels, times kWhole^2.
HWY_INLINE Floats bilinear(const std::int16_t* upper, const std::int32_t* upperAt, const std::int16_t* lower,
                           const std::int32_t* lowerAt, const TexelWeights& weights, std::size_t lane) {
    const Ints sum = addedPairs(hn::Zero(kI), upper, upperAt + lane, spread(weights.upper, lane));
    return toFloat(addedPairs(sum, lower, lowerAt + lane, spread(weights.lower, lane)));
}

/// What each of some slots' spheres, and what its mean, has of a sample: where a normal means little, a style shows its
/// mean.
struct SphereShares {
    Floats sphere[4];
    Floats mean[4];
    bool means; ///< some lane shows some
    HWY_INLINE SphereShares(const NodeBlend& slots, Floats trusted)
        : means(!hn::AllTrue(kF, hn::Ge(trusted, splat(1)))) {
        for (int i = 0; i < slots.count; ++i) {
            sphere[i] = hn::Mul(slots.weight[i], trusted);
            mean[i] = hn::Sub(slots.weight[i], sphere[i]);
        }
    }
};

/// A slot's mean by lanes, without a branch: in a noisy scan every other one would mispredict.
HWY_INLINE Floats addedMean(Floats sum, const KernelAtlas& atlas, const LaneInts& slot, Floats share,
                            std::size_t lane) {
    const Floats mean = hn::BitCast(kF, gatherBlocks(atlas.mean, slot.at + lane));
    return hn::MulAdd(spread(share, lane), mean, sum);
}

/// The blend of some slots' spheres, each read from the atlas's finest pictures.
template <int Count>
HWY_INLINE void finestColours(const KernelAtlas& atlas, const SphereQuery& query, const NodeBlend& slots,
                              const SphereShares& shares, LaneColours& out) {
    const SpherePlace place = spherePlace(splatInt(atlas.size), query);
    const TexelWeights weights(place);
    // Normals that mean nothing point anywhere: they would fetch what nobody needs.
    const auto sound = hn::RebindMask(kI, hn::Gt(query.trusted, splat(0)));
    LaneInts texel[Count];
    LaneInts meanOf[Count];
    Floats share[Count];
    for (int i = 0; i < Count; ++i) {
        const Ints first = hn::Mul(slots.node[i], splatInt(atlas.size * atlas.size));
        texel[i] = hn::IfThenElseZero(sound, hn::ShiftLeft<2>(hn::Add(first, place.texel)));
        meanOf[i] = hn::ShiftLeft<2>(slots.node[i]);
        share[i] = hn::Mul(shares.sphere[i], splat(kUnit));
    }
    const std::int16_t* below = atlas.texels + std::ptrdiff_t{4} * atlas.size;
    for (std::size_t lane = 0; lane < hn::Lanes(kF); lane += kBlocks) {
        Floats sum = splat(0);
        for (int i = 0; i < Count && shares.means; ++i) {
            sum = addedMean(sum, atlas, meanOf[i], shares.mean[i], lane);
        }
        for (int i = 0; i < Count; ++i) {
            const Floats one = bilinear(atlas.texels, texel[i].at, below, texel[i].at, weights, lane);
            sum = hn::MulAdd(one, spread(share[i], lane), sum);
        }
        hn::Store(sum, kF, out.rgba + 4 * lane);
    }
}

/// Adds one mip level of each lane's own. `part`: of the level.
HWY_INLINE void addLevel(const KernelAtlas& atlas, const SphereQuery& query, Ints level, Floats part,
                         const NodeBlend& slots, const SphereShares& shares, LaneColours& out) {
    const Ints size = hn::Shr(splatInt(atlas.size), level);
    const Ints start = gatherAt(atlas.levelStart, hn::ShiftLeft<2>(level));
    const SpherePlace place = spherePlace(size, query);
    const TexelWeights weights(place);
    for (int i = 0; i < slots.count; ++i) {
        const Ints first = hn::Add(start, hn::Mul(slots.node[i], hn::Mul(size, size)));
        const Ints texel = hn::Add(first, place.texel);
        const LaneInts upper(hn::ShiftLeft<2>(texel));
        const LaneInts lower(hn::ShiftLeft<2>(hn::Add(texel, size)));
        const Floats share = hn::Mul(hn::Mul(shares.sphere[i], part), splat(kUnit));
        for (std::size_t lane = 0; lane < hn::Lanes(kF); lane += kBlocks) {
            const Floats one = bilinear(atlas.texels, upper.at, atlas.texels, lower.at, weights, lane);
            float* rgba = out.rgba + 4 * lane;
            hn::Store(hn::MulAdd(one, spread(share, lane), hn::Load(kF, rgba)), kF, rgba);
        }
    }
}

/// The blend between the two mip levels around the one that each lane asks for.
HWY_NOINLINE inline void levelColours(const KernelAtlas& atlas, const SphereQuery& query, const NodeBlend& slots,
                                      const SphereShares& shares, LaneColours& out) {
    LaneInts meanOf[4];
    for (int i = 0; i < slots.count; ++i) {
        meanOf[i] = hn::ShiftLeft<2>(slots.node[i]);
    }
    for (std::size_t lane = 0; lane < hn::Lanes(kF); lane += kBlocks) {
        Floats sum = splat(0);
        for (int i = 0; i < slots.count && shares.means; ++i) {
            sum = addedMean(sum, atlas, meanOf[i], shares.mean[i], lane);
        }
        hn::Store(sum, kF, out.rgba + 4 * lane);
    }
    const Ints fine = truncate(query.level);
    const Floats beyond = hn::Sub(query.level, toFloat(fine));
    const auto add = [&](int further, Floats part) HWY_ATTR {
        const Ints level = hn::Min(hn::Add(fine, splatInt(further)), splatInt(atlas.lastLevel));
        addLevel(atlas, query, level, part, slots, shares, out);
    };
    add(0, hn::Sub(splat(1), beyond));
    if (!hn::AllFalse(kF, hn::Gt(beyond, splat(0)))) {
        add(1, beyond);
    }
}

/// `sft`: the blend of the spheres in some slots of the atlas at a normal; `slots.node` are slots.
HWY_INLINE void sphereColours(const KernelAtlas& atlas, const SphereQuery& query, const NodeBlend& slots,
                              LaneColours& out) {
    const SphereShares shares(slots, query.trusted);
    if (atlas.levelStart != nullptr) {
        levelColours(atlas, query, slots, shares, out);
        return;
    }
    switch (slots.count) {
    case 1: finestColours<1>(atlas, query, slots, shares, out); break;
    case 2: finestColours<2>(atlas, query, slots, shares, out); break;
    default: finestColours<4>(atlas, query, slots, shares, out); break;
    }
}

/// Elements of a short table; at least kMostLanes of it can be read. As many as there are lanes lie in one vector.
HWY_INLINE Ints lookUp(const std::int32_t* table, int count, Ints at) {
    static_assert(hn::MaxLanes(kI) <= kMostLanes);
    if (count <= static_cast<int>(hn::Lanes(kI))) {
        return hn::TableLookupLanes(hn::LoadU(kI, table), hn::IndicesFromVec(kI, at));
    }
    return gatherAt(table, hn::ShiftLeft<2>(at));
}
HWY_INLINE Floats lookUp(const float* table, int count, Ints at) {
    return hn::BitCast(kF, lookUp(reinterpret_cast<const std::int32_t*>(table), count, at));
}

/// The node at or before a place on an axis, and how far it is to the next one.
struct NodePlace {
    Ints node;
    Floats beyond;
};

HWY_INLINE NodePlace nodePlace(const KernelNodes& nodes, Floats entry) {
    Ints node = hn::Zero(kI);
    for (int i = 1; i < nodes.count; ++i) {
        node = hn::IfThenElse(hn::RebindMask(kI, hn::Ge(entry, splat(nodes.from[i]))), splatInt(i), node);
    }
    const Floats from = lookUp(nodes.from, nodes.count, node);
    const Floats share = hn::Mul(hn::Sub(entry, from), lookUp(nodes.perEntry, nodes.count, node));
    return {node, hn::Min(hn::Max(share, splat(0)), splat(1))};
}

/// The same by a fractional index.
HWY_INLINE NodePlace nodePlaceOf(Floats index) {
    const Ints node = truncate(index);
    return {node, hn::Sub(index, toFloat(node))};
}

/// Slots of nodes. Those of the first node's sphere are added to it, so that one sphere is the same however many nodes
/// have it; where the others have no weight, one look-up will do.
HWY_INLINE NodeBlend slotsOf(const KernelLayer& layer, const NodeBlend& nodes) {
    NodeBlend slots = nodes;
    slots.node[0] = lookUp(layer.slotOfNode, layer.nodes, nodes.node[0]);
    Floats others = splat(0);
    for (int i = 1; i < nodes.count; ++i) {
        slots.node[i] = lookUp(layer.slotOfNode, layer.nodes, nodes.node[i]);
        const Mask same = hn::RebindMask(kF, hn::Eq(slots.node[0], slots.node[i]));
        slots.weight[i] = hn::IfThenZeroElse(same, slots.weight[i]);
        others = hn::Add(others, slots.weight[i]);
    }
    slots.weight[0] = hn::Sub(splat(1), others);
    if (hn::AllFalse(kF, hn::Gt(others, splat(0)))) {
        slots.count = 1;
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
