// Weights over the four voxels of each axis around a place, and rows of four voxels; compiled once for every
// instruction set.
#if defined(LIMNER_TAPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_TAPS_INL_H
#undef LIMNER_TAPS_INL_H
#else
#define LIMNER_TAPS_INL_H
#endif

#include "core/volume/volume.h"
#include "renderer/cpu/lanes-inl.h"
#include "renderer/scene/kernel_scene.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// From one voxel before the cell to one behind.
struct Taps {
    Floats at[4];
};

/// A value and its derivative along one axis.
struct AxisTaps {
    Taps value, slope;
};

HWY_INLINE Taps splineTaps(Floats f) {
    const Floats g = hn::Sub(splat(1), f);
    const auto outer = [](Floats x) HWY_ATTR { return hn::Mul(hn::Mul(hn::Mul(x, x), x), splat(1.0F / 6)); };
    const auto inner = [](Floats x) HWY_ATTR { // 2/3 - x^2 (2 - x) / 2
        return hn::NegMulAdd(hn::Mul(x, x), hn::NegMulAdd(splat(0.5F), x, splat(1)), splat(2.0F / 3));
    };
    return {{outer(g), inner(f), inner(g), outer(f)}};
}

HWY_INLINE Taps splineSlopeTaps(Floats f) {
    const Floats g = hn::Sub(splat(1), f);
    const auto outer = [](Floats x) HWY_ATTR { return hn::Mul(hn::Mul(x, x), splat(0.5F)); };
    const auto inner = [](Floats x) HWY_ATTR { return hn::Mul(x, hn::MulSub(splat(1.5F), x, splat(2))); };
    return {{hn::Neg(outer(g)), inner(f), hn::Neg(inner(g)), outer(f)}};
}

HWY_INLINE Taps splineBendTaps(Floats f) {
    const Floats three = splat(3);
    return {{hn::Sub(splat(1), f), hn::MulSub(three, f, splat(2)), hn::NegMulAdd(three, f, splat(1)), f}};
}

/// Central differences at the cell's corners, interpolated.
HWY_INLINE Taps differenceTaps(Floats f) {
    const Floats half = splat(0.5F);
    const Floats after = hn::Mul(half, f);
    const Floats before = hn::Sub(half, after);
    return {{hn::Neg(before), hn::Neg(after), before, after}};
}

/// (1, centre, 1) / (2 + centre) at the cell's corners, interpolated.
HWY_INLINE Taps smoothingTaps(Floats f, float centre) {
    const float share = 1 / (2 + centre);
    const Floats g = hn::Sub(splat(1), f);
    return {{hn::Mul(g, splat(share)), hn::MulAdd(g, splat(centre * share), hn::Mul(f, splat(share))),
             hn::MulAdd(f, splat(centre * share), hn::Mul(g, splat(share))), hn::Mul(f, splat(share))}};
}

HWY_INLINE AxisTaps gradientTaps(KernelTaps kind, Floats f) {
    switch (kind) {
    case KernelTaps::sobel: return {smoothingTaps(f, 2), differenceTaps(f)};
    case KernelTaps::neumann: return {smoothingTaps(f, 1), differenceTaps(f)};
    case KernelTaps::spline: break;
    }
    return {splineTaps(f), splineSlopeTaps(f)};
}

/// Four voxels of a row, as numbers.
struct RowVoxels {
    Floats at[4];
};

HWY_INLINE Floats weighted(const RowVoxels& row, const Taps& taps) {
    return hn::MulAdd(
        row.at[0], taps.at[0],
        hn::MulAdd(row.at[1], taps.at[1], hn::MulAdd(row.at[2], taps.at[2], hn::Mul(row.at[3], taps.at[3]))));
}

/// First and second derivatives, stored units per voxel and per voxel squared.
struct BendSums {
    Floats x, y, z, xx, yy, zz, xy, xz, yz;
};

/// The 4^3 voxels around a cell in a store of `Store`s; offsets in bytes to the cell's lower voxel. All lie in the
/// cell's own brick (see BrickLayout).
template <typename Store, typename Offset>
class Rows {
  public:
    HWY_INLINE Rows(const std::uint8_t* bricks, const Offsets<Offset>& offsets)
        : base_(bricks - (1 + BrickLayout::kRow + BrickLayout::kSlice) * kBytes), offsets_(offsets) {}

    /// Row (y, z) of the neighbourhood, each 0..3.
    [[nodiscard]] HWY_INLINE RowVoxels row(int y, int z) const {
        const std::uint8_t* base = base_ + (y * BrickLayout::kRow + z * BrickLayout::kSlice) * kBytes;
        if constexpr (kBytes == 1) {
            const Ints word = gatherWords(base, offsets_);
            const Ints byte = splatInt(255);
            return {{toFloat(hn::And(word, byte)), toFloat(hn::And(hn::ShiftRight<8>(word), byte)),
                     toFloat(hn::And(hn::ShiftRight<16>(word), byte)),
                     toFloat(hn::And(hn::ShiftRight<24>(word), byte))}};
        } else if constexpr (kBytes == 2) {
            const WordPair four = gatherPairs(base, offsets_);
            const auto low = [](Ints v) HWY_ATTR { return toFloat(hn::ShiftRight<16>(hn::ShiftLeft<16>(v))); };
            const auto high = [](Ints v) HWY_ATTR { return toFloat(hn::ShiftRight<16>(v)); };
            return {{low(four.low), high(four.low), low(four.high), high(four.high)}};
        } else {
            const WordPair first = gatherPairs(base, offsets_);
            const WordPair second = gatherPairs(base + 2 * kBytes, offsets_);
            return {{hn::BitCast(kF, first.low), hn::BitCast(kF, first.high), hn::BitCast(kF, second.low),
                     hn::BitCast(kF, second.high)}};
        }
    }

  private:
    static constexpr int kBytes = sizeof(Store);
    const std::uint8_t* base_;
    Offsets<Offset> offsets_;
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
