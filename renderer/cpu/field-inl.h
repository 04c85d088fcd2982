// The volume as a field: trilinear value and its central difference; compiled once for every instruction set.
#if defined(LIMNER_FIELD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_FIELD_INL_H
#undef LIMNER_FIELD_INL_H
#else
#define LIMNER_FIELD_INL_H
#endif

#include "renderer/cpu/kernel.h"
#include "renderer/cpu/lanes-inl.h"
#include "renderer/cpu/taps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// Weights (1-f, f) of a linear interpolation as a pair of 15-bit integers in one word.
HWY_INLINE Ints pairWeights(Floats f) {
    const Ints high = truncate(hn::MulAdd(f, splat(32767.0F), splat(0.5F)));
    return hn::Add(hn::Sub(hn::ShiftLeft<16>(high), high), splatInt(32767));
}

/// A cell and the place inside it, one per lane.
template <typename Offset>
struct CellPlace {
    Offsets<Offset> offsets; ///< bytes from the store's begin to the cell's lower voxel
    Floats fx, fy, fz;

    /// The same voxel in a store of the same layout, `Bytes` a voxel instead of `Own`.
    template <int Bytes, int Own>
    [[nodiscard]] HWY_INLINE Offsets<Offset> offsetsIn() const {
        Offsets<Offset> other;
        for (std::size_t lane = 0; lane < hn::Lanes(kI); ++lane) {
            other.at[lane] = offsets.at[lane] / Own * Bytes;
        }
        return other;
    }
};

/// `Voxel`: std::uint8_t, std::int16_t or float. Values and gradients come in the kernel's own units: for integer
/// voxels times kScale (the weights of the integer interpolation), gradients twice that (differences over two voxels).
template <typename Voxel, typename Offset>
struct Field {
    static constexpr bool kInteger = !std::is_same_v<Voxel, float>;
    static constexpr int kBytes = sizeof(Voxel);
    static constexpr int kRowBytes = BrickLayout::kRow * kBytes;
    static constexpr int kSliceBytes = BrickLayout::kSlice * kBytes;
    /// Offset of the first cell: its neighbours may be read too, those of offset 0 may not.
    static constexpr int kFirstCell = kSliceBytes + kRowBytes + kBytes;
    static constexpr float kScale = kInteger ? 32767.0F : 1.0F;
    using Place = CellPlace<Offset>;
    using OffsetType = Offset;

    /// Spline coefficients beside these voxels: see KernelScene::gradientOfOwnType.
    using Coefficient = std::conditional_t<kInteger, std::int16_t, float>;

    const KernelScene& scene;

    /// Lanes outside `live` may stand anywhere; they look at the store's begin, where a cell may be read but nothing
    /// before it: good for trilinear values alone.
    HWY_INLINE Place locate(const Vec3& q, Mask live) const {
        const Ints ix = truncate(q.x);
        const Ints iy = truncate(q.y);
        const Ints iz = truncate(q.z);
        Place place;
        place.fx = hn::Sub(q.x, toFloat(ix));
        place.fy = hn::Sub(q.y, toFloat(iy));
        place.fz = hn::Sub(q.z, toFloat(iz));
        constexpr int log2 = BrickLayout::kLog2BrickCells;
        const Ints brick =
            hn::Add(hn::Add(hn::ShiftRight<log2>(ix), hn::Mul(hn::ShiftRight<log2>(iy), splatInt(scene.brickStep[1]))),
                    hn::Mul(hn::ShiftRight<log2>(iz), splatInt(scene.brickStep[2])));
        const Ints inside = splatInt(BrickLayout::kBrickCells - 1);
        // Voxel 1 of the brick's own count is the lower voxel of cell 0.
        const Ints local = hn::Add(hn::Add(hn::Mul(hn::And(iz, inside), splatInt(kSliceBytes)),
                                           hn::Mul(hn::And(iy, inside), splatInt(kRowBytes))),
                                   hn::Add(hn::Mul(hn::And(ix, inside), splatInt(kBytes)), splatInt(kFirstCell)));
        const auto masked = [&](Ints v, int otherwise)
                                HWY_ATTR { return hn::IfThenElse(hn::RebindMask(kI, live), v, splatInt(otherwise)); };
        constexpr std::int64_t brickBytes = std::int64_t{BrickLayout::kBrickVoxels} * kBytes;
        if constexpr (sizeof(Offset) == 4) {
            store(masked(hn::Add(hn::Mul(brick, splatInt(static_cast<std::int32_t>(brickBytes))), local), kFirstCell),
                  place.offsets);
        } else {
            alignas(64) std::int32_t bricks[kMaxLanes];
            alignas(64) std::int32_t locals[kMaxLanes];
            hn::Store(masked(brick, 0), kI, bricks);
            hn::Store(masked(local, kFirstCell), kI, locals);
            for (std::size_t lane = 0; lane < hn::Lanes(kI); ++lane) {
                place.offsets.at[lane] = bricks[lane] * brickBytes + locals[lane];
            }
        }
        return place;
    }

    /// The place at a position whose cell is known by its (32-bit) offset.
    static HWY_INLINE Place placeAt(const Vec3& q, Ints offsets) {
        const auto inCell = [](Floats v) HWY_ATTR { return hn::Sub(v, toFloat(truncate(v))); };
        Place place;
        place.fx = inCell(q.x);
        place.fy = inCell(q.y);
        place.fz = inCell(q.z);
        store(offsets, place.offsets);
        return place;
    }

    /// a*(1-f) + b*f of a pair of 16-bit voxels in one instruction, times 32767.
    static HWY_INLINE Ints blend(Ints pair, Ints weight) {
        const hn::Repartition<std::int16_t, IntTag> shorts;
        Ints rest = hn::Zero(kI);
        return hn::ReorderWidenMulAccumulate(kI, hn::BitCast(shorts, pair), hn::BitCast(shorts, weight), hn::Zero(kI),
                                             rest);
    }
    /// Bytes N and N+1 of every word as two 16-bit numbers.
    template <int N>
    static HWY_INLINE Ints bytePair(Ints word) {
        const hn::Repartition<std::uint8_t, IntTag> bytes;
        constexpr std::uint32_t k = std::uint32_t(N) | 0x8000U | std::uint32_t(N + 1) << 16 | 0x80000000U;
        alignas(16) static constexpr std::uint32_t order[4] = {k, k + 0x00040004U, k + 0x00080008U, k + 0x000c000cU};
        return hn::BitCast(kI,
                           hn::TableLookupBytes(hn::BitCast(bytes, word),
                                                hn::LoadDup128(bytes, reinterpret_cast<const std::uint8_t*>(order))));
    }

    /// The two voxels of a row, interpolated along x; `shift`: bytes from the cell's lower voxel.
    HWY_INLINE Floats row(const Place& place, int shift, Ints weight) const {
        const std::uint8_t* base = scene.bricks + shift;
        if constexpr (kBytes == 1) {
            return toFloat(blend(bytePair<0>(gatherWords(base, place.offsets)), weight));
        } else if constexpr (kInteger) {
            return toFloat(blend(gatherWords(base, place.offsets), weight));
        } else {
            const WordPair pair = gatherPairs(base, place.offsets);
            return lerp(hn::BitCast(kF, pair.low), hn::BitCast(kF, pair.high), place.fx);
        }
    }

    HWY_INLINE Floats value(const Place& place) const { return scene.spline ? splineValue(place) : trilinear(place); }

    HWY_INLINE Floats trilinear(const Place& place) const {
        const Ints weight = pairWeights(place.fx);
        const Floats low = lerp(row(place, 0, weight), row(place, kRowBytes, weight), place.fy);
        const Floats high =
            lerp(row(place, kSliceBytes, weight), row(place, kSliceBytes + kRowBytes, weight), place.fy);
        return lerp(low, high, place.fz);
    }

    HWY_NOINLINE Floats splineValue(const Place& place) const {
        const Taps x = splineTaps(place.fx);
        const Taps y = splineTaps(place.fy);
        const Taps z = splineTaps(place.fz);
        const Rows<Voxel, Offset> rows(scene.bricks, place.offsets);
        Floats sum = splat(0);
        for (int k = 0; k < 4; ++k) {
            Floats slice = splat(0);
            for (int j = 0; j < 4; ++j) {
                slice = hn::MulAdd(y.at[j], weighted(rows.row(j, k), x), slice);
            }
            sum = hn::MulAdd(z.at[k], slice, sum);
        }
        return hn::Mul(sum, splat(kScale));
    }

    /// A row's interpolated value and its difference between one voxel further and one voxel before.
    struct RowSlope {
        Floats value, slope;
    };
    HWY_INLINE RowSlope rowSlope(const Place& place, int shift, Ints weight) const {
        const std::uint8_t* base = scene.bricks + shift - kBytes;
        if constexpr (kBytes == 1) {
            const Ints word = gatherWords(base, place.offsets);
            return {toFloat(blend(bytePair<1>(word), weight)),
                    toFloat(hn::Sub(blend(bytePair<2>(word), weight), blend(bytePair<0>(word), weight)))};
        } else if constexpr (kInteger) {
            const WordPair four = gatherPairs(base, place.offsets);
            const Ints middle = hn::Or(hn::ShiftLeft<16>(four.high), shiftRightLogical16(four.low));
            return {toFloat(blend(middle, weight)),
                    toFloat(hn::Sub(blend(four.high, weight), blend(four.low, weight)))};
        } else {
            const WordPair before = gatherPairs(base, place.offsets);
            const WordPair after = gatherPairs(base + 2 * kBytes, place.offsets);
            const Floats v0 = hn::BitCast(kF, before.low);
            const Floats v1 = hn::BitCast(kF, before.high);
            const Floats v2 = hn::BitCast(kF, after.low);
            const Floats v3 = hn::BitCast(kF, after.high);
            return {lerp(v1, v2, place.fx), lerp(hn::Sub(v2, v0), hn::Sub(v3, v1), place.fx)};
        }
    }

    /// By the scene's estimator, in the units that its matrix expects. `q`: where the place is.
    HWY_INLINE Vec3 gradient(const Place& place, const Vec3& q) const {
        if (scene.gradient == KernelGradient::central) {
            return centralGradient(place);
        }
        return scene.gradient == KernelGradient::taps ? tapsGradient(place) : fourthOrderGradient(q);
    }

    HWY_NOINLINE Vec3 tapsGradient(const Place& place) const {
        const AxisTaps x = gradientTaps(scene.gradientTaps, place.fx);
        const AxisTaps y = gradientTaps(scene.gradientTaps, place.fy);
        const AxisTaps z = gradientTaps(scene.gradientTaps, place.fz);
        return scene.gradientOfOwnType ? tapsGradientOf<Voxel>(place, x, y, z)
                                       : tapsGradientOf<Coefficient>(place, x, y, z);
    }

    HWY_NOINLINE BendSums bends(const Place& place) const {
        return scene.bendOfOwnType ? bendsOf<Voxel>(place) : bendsOf<Coefficient>(place);
    }

    /// (8 (f(q + 1) - f(q - 1)) - (f(q + 2) - f(q - 2))) / 6 along each axis: like a difference over two voxels.
    HWY_NOINLINE Vec3 fourthOrderGradient(const Vec3& q) const {
        const auto over = [&](float x, float y, float z) HWY_ATTR {
            const auto at = [&](float sign) HWY_ATTR {
                const auto moved = [&](Floats from, float by, int axis) HWY_ATTR {
                    const Floats to = hn::Add(from, splat(sign * by));
                    return hn::Min(hn::Max(to, splat(0)), splat(scene.lastCell[axis]));
                };
                const Mask all = hn::FirstN(kF, hn::Lanes(kF));
                return trilinear(locate({moved(q.x, x, 0), moved(q.y, y, 1), moved(q.z, z, 2)}, all));
            };
            return hn::Sub(at(1), at(-1));
        };
        const auto along = [&](float x, float y, float z) HWY_ATTR {
            const Floats near = over(x, y, z);
            const Floats far = over(2 * x, 2 * y, 2 * z);
            return hn::Mul(hn::NegMulAdd(splat(0.125F), far, near), splat(4.0F / 3));
        };
        return {along(1, 0, 0), along(0, 1, 0), along(0, 0, 1)};
    }

    /// f(q + 1) - f(q - 1) along each axis, exactly for the trilinear field: 12 rows instead of 6 * 8 corners.
    /// Everything in line: called, its rows would go through memory (5 to 9 % of a picture).
    HWY_INLINE Vec3 centralGradient(const Place& place) const {
        const Ints weight = pairWeights(place.fx);
        constexpr int sy = kRowBytes;
        constexpr int sz = kSliceBytes;
        const RowSlope r00 = rowSlope(place, 0, weight);
        const RowSlope r10 = rowSlope(place, sy, weight);
        const RowSlope r01 = rowSlope(place, sz, weight);
        const RowSlope r11 = rowSlope(place, sy + sz, weight);
        Vec3 g;
        g.x = lerp(lerp(r00.slope, r10.slope, place.fy), lerp(r01.slope, r11.slope, place.fy), place.fz);
        const auto along = [&](int step, const RowSlope* r, int across, Floats f, Floats g0) HWY_ATTR
            __attribute__((always_inline)) {
            // r: the rows at (0, 0), (1, 0), (0, 1), (1, 1) of (step, across).
            const Floats below0 = hn::Sub(r[1].value, row(place, -step, weight));
            const Floats above0 = hn::Sub(row(place, 2 * step, weight), r[0].value);
            const Floats below1 = hn::Sub(r[3].value, row(place, across - step, weight));
            const Floats above1 = hn::Sub(row(place, across + 2 * step, weight), r[2].value);
            return lerp(lerp(below0, above0, f), lerp(below1, above1, f), g0);
        };
        const RowSlope inY[4] = {r00, r10, r01, r11};
        const RowSlope inZ[4] = {r00, r01, r10, r11};
        g.y = along(sy, inY, sz, place.fy, place.fz);
        g.z = along(sz, inZ, sy, place.fz, place.fy);
        return g;
    }

  private:
    template <typename Store>
    HWY_INLINE Vec3 tapsGradientOf(const Place& place, const AxisTaps& x, const AxisTaps& y, const AxisTaps& z) const {
        const Rows<Store, Offset> rows = rowsOf<Store>(scene.gradientBricks, place);
        Vec3 g = {splat(0), splat(0), splat(0)};
        for (int k = 0; k < 4; ++k) {
            Vec3 slice = {splat(0), splat(0), splat(0)}; // slope along x, along y, value
            for (int j = 0; j < 4; ++j) {
                const RowVoxels row = rows.row(j, k);
                const Floats value = weighted(row, x.value);
                slice.x = hn::MulAdd(y.value.at[j], weighted(row, x.slope), slice.x);
                slice.y = hn::MulAdd(y.slope.at[j], value, slice.y);
                slice.z = hn::MulAdd(y.value.at[j], value, slice.z);
            }
            g.x = hn::MulAdd(z.value.at[k], slice.x, g.x);
            g.y = hn::MulAdd(z.value.at[k], slice.y, g.y);
            g.z = hn::MulAdd(z.slope.at[k], slice.z, g.z);
        }
        const auto sound = [&](Floats v) HWY_ATTR {
            return hn::IfThenElseZero(hn::Gt(hn::Abs(v), splat(scene.gradientRounding)), v);
        };
        return {sound(g.x), sound(g.y), sound(g.z)};
    }

    template <typename Store>
    HWY_INLINE BendSums bendsOf(const Place& place) const {
        const AxisTaps x = gradientTaps(KernelTaps::spline, place.fx);
        const AxisTaps y = gradientTaps(KernelTaps::spline, place.fy);
        const AxisTaps z = gradientTaps(KernelTaps::spline, place.fz);
        const Taps xx = splineBendTaps(place.fx);
        const Taps yy = splineBendTaps(place.fy);
        const Taps zz = splineBendTaps(place.fz);
        const Rows<Store, Offset> rows = rowsOf<Store>(scene.bendBricks, place);
        const Floats zero = splat(0);
        BendSums sum = {zero, zero, zero, zero, zero, zero, zero, zero, zero};
        for (int k = 0; k < 4; ++k) {
            Floats value = zero, alongX = zero, alongY = zero, xxSlice = zero, yySlice = zero, xySlice = zero;
            for (int j = 0; j < 4; ++j) {
                const RowVoxels row = rows.row(j, k);
                const Floats rowValue = weighted(row, x.value);
                const Floats rowSlope = weighted(row, x.slope);
                value = hn::MulAdd(y.value.at[j], rowValue, value);
                alongX = hn::MulAdd(y.value.at[j], rowSlope, alongX);
                alongY = hn::MulAdd(y.slope.at[j], rowValue, alongY);
                xxSlice = hn::MulAdd(y.value.at[j], weighted(row, xx), xxSlice);
                yySlice = hn::MulAdd(yy.at[j], rowValue, yySlice);
                xySlice = hn::MulAdd(y.slope.at[j], rowSlope, xySlice);
            }
            sum.x = hn::MulAdd(z.value.at[k], alongX, sum.x);
            sum.y = hn::MulAdd(z.value.at[k], alongY, sum.y);
            sum.z = hn::MulAdd(z.slope.at[k], value, sum.z);
            sum.xx = hn::MulAdd(z.value.at[k], xxSlice, sum.xx);
            sum.yy = hn::MulAdd(z.value.at[k], yySlice, sum.yy);
            sum.zz = hn::MulAdd(zz.at[k], value, sum.zz);
            sum.xy = hn::MulAdd(z.value.at[k], xySlice, sum.xy);
            sum.xz = hn::MulAdd(z.slope.at[k], alongX, sum.xz);
            sum.yz = hn::MulAdd(z.slope.at[k], alongY, sum.yz);
        }
        return sum;
    }

    /// Of a store beside the voxels.
    template <typename Store>
    static HWY_INLINE Rows<Store, Offset> rowsOf(const std::uint8_t* bricks, const Place& place) {
        return Rows<Store, Offset>(bricks, place.template offsetsIn<sizeof(Store), kBytes>());
    }
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
