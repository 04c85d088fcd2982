// Pre-integration: what slabs between two ends show by a layer's table of integrals; compiled once for every
// instruction set.
#if defined(LIMNER_SLABS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_SLABS_INL_H
#undef LIMNER_SLABS_INL_H
#else
#define LIMNER_SLABS_INL_H
#endif

#include "renderer/cpu/optics_lanes-inl.h" // names the target: before the formulas
#include "renderer/cpu/style-inl.h"
#include "renderer/plan/slab_table.h"
#include "renderer/scene/kernel_scene.h"

#include "core/optics/opacity.h"
#include "core/optics/preintegration.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// The values at a slab's ends, in entries of a table.
struct SlabEnds {
    Floats front, back;
};

/// In entries of the layer's table instead of the scene's.
HWY_INLINE SlabEnds endsIn(const KernelLayer& layer, const SlabEnds& scene) {
    const auto entry = [&](Floats v) HWY_ATTR { return hn::MulAdd(v, splat(layer.x.scale), splat(layer.x.bias)); };
    return {entry(scene.front), entry(scene.back)};
}

/// A place in a layer's table.
struct SlabPlace {
    Floats depth, rest; ///< T up to the entry, in two parts
    Floats inside;      ///< and from there on
    Floats extinction;

    HWY_INLINE SlabPlace(const float* slabs, Floats entry) {
        const Ints whole = truncate(entry);
        const Floats share = hn::Sub(entry, toFloat(whole));
        constexpr int log2RowBytes = 5;
        static_assert(1 << log2RowBytes == kSlabFloats * sizeof(float));
        Offsets<std::uint32_t> row;
        store(hn::ShiftLeft<log2RowBytes>(whole), row);
        const WordPair ends = gatherPairs(slabs + static_cast<int>(SlabColumn::low), row);
        const WordPair sum = gatherPairs(slabs + static_cast<int>(SlabColumn::depth), row);
        const Floats low = hn::BitCast(kF, ends.low);
        const Floats high = hn::BitCast(kF, ends.high);
        depth = hn::BitCast(kF, sum.low);
        rest = hn::BitCast(kF, sum.high);
        inside = optics::integralsInside(Lanes{low}, Lanes{high}, Lanes{share}).depth.v;
        extinction = lerp(low, high, share);
    }
};

/// Optical depth of `part` of a step.
HWY_INLINE Floats slabDepth(const KernelScene& scene, const KernelLayer& layer, const SlabEnds& ends, Floats part) {
    const SlabPlace front(layer.slabs, ends.front);
    const SlabPlace back(layer.slabs, ends.back);
    // What is exact first: sums up to entries are multiples of one quantum.
    const Floats between = hn::Add(hn::Sub(back.depth, front.depth),
                                   hn::Add(hn::Sub(back.rest, front.rest), hn::Sub(back.inside, front.inside)));
    const Floats ofEnds = hn::Mul(hn::Add(front.extinction, back.extinction), splat(0.5F));
    const Floats mean = optics::meanExtinction(Lanes{ends.front}, Lanes{ends.back}, Lanes{between}, Lanes{ofEnds}).v;
    return hn::Mul(mean, hn::Mul(splat(scene.stepRatio), part));
}

/// Opacity of all layers in a slab, one behind the other; `share(i, depth, opacity)` gets the depth of layer i and what
/// it has of the opacity.
template <typename Share>
HWY_INLINE Floats opacityOfSlabs(const KernelScene& scene, const SlabEnds& ends, Floats part, const Share& share) {
    Floats through = splat(1);
    Floats total = splat(0);
    for (int i = 0; i < scene.layerCount; ++i) {
        const KernelLayer& layer = scene.layers[i];
        const Floats depth = slabDepth(scene, layer, endsIn(layer, ends), part);
        const Floats opacity = hn::Mul(through, optics::opacityOfDepth(Lanes{depth}).v);
        share(i, depth, opacity);
        total = hn::Add(total, opacity);
        through = hn::Sub(through, opacity);
    }
    return total;
}

/// All integrals up to a place of a layer's table, in double: the spread of a slab's matter is a small difference of
/// large numbers.
HWY_INLINE optics::SlabIntegrals<double> integralsUpTo(const float* slabs, float entry) {
    const auto whole = static_cast<std::int32_t>(entry);
    const float* row = slabs + std::ptrdiff_t{kSlabFloats} * whole;
    const auto sum = [row](SlabColumn column) {
        const float* parts = row + static_cast<int>(column);
        return static_cast<double>(parts[0]) + static_cast<double>(parts[1]);
    };
    const double share = static_cast<double>(entry) - whole;
    const double low = row[static_cast<int>(SlabColumn::low)];
    const double high = row[static_cast<int>(SlabColumn::high)];
    const optics::SlabIntegrals<double> inside =
        optics::countedFrom(optics::integralsInside(low, high, share), static_cast<double>(whole));
    return {sum(SlabColumn::depth) + inside.depth, sum(SlabColumn::first) + inside.first,
            sum(SlabColumn::second) + inside.second};
}

/// Where slabs are seen on average, 0 front to 1 back.
HWY_NOINLINE inline Floats seenPlaces(const KernelLayer& layer, const SlabEnds& ends, Floats depth) {
    const LaneFloats front(ends.front);
    const LaneFloats back(ends.back);
    LaneFloats mean;
    LaneFloats variance;
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        const optics::SlabIntegrals<double> a = integralsUpTo(layer.slabs, front.at[lane]);
        const optics::SlabIntegrals<double> b = integralsUpTo(layer.slabs, back.at[lane]);
        const optics::SlabMoments<double> moments = optics::momentsBetween<double>(
            front.at[lane], back.at[lane], {b.depth - a.depth, b.first - a.first, b.second - a.second});
        mean.at[lane] = static_cast<float>(moments.mean);
        variance.at[lane] = static_cast<float>(moments.variance);
    }
    const optics::SlabMoments<Lanes> moments = {Lanes{hn::Load(kF, mean.at)}, Lanes{hn::Load(kF, variance.at)}};
    return optics::seenPlace(moments, Lanes{depth}).v;
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
