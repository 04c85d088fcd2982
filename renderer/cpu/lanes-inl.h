// Vector helpers of the ray-casting kernel; compiled once for every instruction set.
#if defined(LIMNER_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_LANES_INL_H
#undef LIMNER_LANES_INL_H
#else
#define LIMNER_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::ScalableTag<std::int32_t>;
using UintTag = hn::ScalableTag<std::uint32_t>;
using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;
using Mask = hn::Mask<FloatTag>;

constexpr FloatTag kF;
constexpr IntTag kI;
constexpr UintTag kU;
constexpr int kMaxLanes = HWY_MAX_BYTES / 4;

HWY_INLINE Floats splat(float v) { return hn::Set(kF, v); }
HWY_INLINE Ints splatInt(std::int32_t v) { return hn::Set(kI, v); }
HWY_INLINE Floats toFloat(Ints v) { return hn::ConvertTo(kF, v); }
/// Towards zero, for values that fit. (Highway's own mends what does not fit, five instructions more each time.)
HWY_INLINE Ints truncate(Floats v) {
#if HWY_TARGET == HWY_AVX3
    return Ints{_mm512_cvttps_epi32(v.raw)};
#elif HWY_TARGET == HWY_AVX2
    return Ints{_mm256_cvttps_epi32(v.raw)};
#elif HWY_TARGET == HWY_SSE4
    return Ints{_mm_cvttps_epi32(v.raw)};
#else
    return hn::ConvertTo(kI, v);
#endif
}
HWY_INLINE Floats lerp(Floats a, Floats b, Floats t) { return hn::MulAdd(hn::Sub(b, a), t, a); }
HWY_INLINE Ints shiftRightLogical16(Ints v) { return hn::BitCast(kI, hn::ShiftRight<16>(hn::BitCast(kU, v))); }

struct Vec3 {
    Floats x, y, z;
};
HWY_INLINE Floats dot(const Vec3& a, const Vec3& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

/// Two 32-bit words per lane: those at a byte offset and at the offset + 4.
struct WordPair {
    Ints low, high;
};

/// Byte offsets of a gather, one per lane (unsigned: no sign extension each time), kept in memory: hardware gathers are
/// microcoded on several processors, a load and an insert per lane is faster, and the scalar addresses come from here
/// (shared/perf: 2.6 against 3.3 G fetches/s).
template <typename Offset>
struct Offsets {
    alignas(64) Offset at[kMaxLanes];
};

HWY_INLINE void store(Ints offsets, Offsets<std::uint32_t>& out) { hn::Store(hn::BitCast(kU, offsets), kU, out.at); }

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

template <typename Offset>
HWY_INLINE __m128i fourWords(const std::uint8_t* base, const Offset* at) {
    const auto word = [&](int lane) HWY_ATTR {
        std::int32_t w;
        std::memcpy(&w, base + at[lane], sizeof(w));
        return w;
    };
    return _mm_insert_epi32(_mm_insert_epi32(_mm_insert_epi32(_mm_cvtsi32_si128(word(0)), word(1), 1), word(2), 2),
                            word(3), 3);
}

template <typename Offset>
HWY_INLINE __m256i eightWords(const std::uint8_t* base, const Offset* at) {
    return _mm256_inserti128_si256(_mm256_castsi128_si256(fourWords(base, at)), fourWords(base, at + 4), 1);
}

/// Two lanes' pairs of words side by side.
template <typename Offset>
HWY_INLINE __m128i twoPairs(const std::uint8_t* base, const Offset* at, int a, int b) {
    const __m128i first = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(base + at[a]));
    return _mm_castps_si128(_mm_loadh_pi(_mm_castsi128_ps(first), reinterpret_cast<const __m64*>(base + at[b])));
}

struct EightPairs {
    __m256i low, high;
};
template <typename Offset>
HWY_INLINE EightPairs eightPairs(const std::uint8_t* base, const Offset* at) {
    const __m256i first =
        _mm256_inserti128_si256(_mm256_castsi128_si256(twoPairs(base, at, 0, 1)), twoPairs(base, at, 4, 5), 1);
    const __m256i second =
        _mm256_inserti128_si256(_mm256_castsi128_si256(twoPairs(base, at, 2, 3)), twoPairs(base, at, 6, 7), 1);
    const __m256 a = _mm256_castsi256_ps(first);
    const __m256 b = _mm256_castsi256_ps(second);
    return {_mm256_castps_si256(_mm256_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0))),
            _mm256_castps_si256(_mm256_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)))};
}

#if HWY_TARGET == HWY_AVX3
HWY_INLINE Ints join(__m256i low, __m256i high) {
    return Ints{_mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1)};
}
template <typename Offset>
HWY_INLINE Ints gatherWords(const void* base, const Offsets<Offset>& offsets) {
    const auto* b = static_cast<const std::uint8_t*>(base);
    return join(eightWords(b, offsets.at), eightWords(b, offsets.at + 8));
}
template <typename Offset>
HWY_INLINE WordPair gatherPairs(const void* base, const Offsets<Offset>& offsets) {
    const auto* b = static_cast<const std::uint8_t*>(base);
    const EightPairs first = eightPairs(b, offsets.at);
    const EightPairs second = eightPairs(b, offsets.at + 8);
    return {join(first.low, second.low), join(first.high, second.high)};
}
#else
template <typename Offset>
HWY_INLINE Ints gatherWords(const void* base, const Offsets<Offset>& offsets) {
    return Ints{eightWords(static_cast<const std::uint8_t*>(base), offsets.at)};
}
template <typename Offset>
HWY_INLINE WordPair gatherPairs(const void* base, const Offsets<Offset>& offsets) {
    const EightPairs pairs = eightPairs(static_cast<const std::uint8_t*>(base), offsets.at);
    return {Ints{pairs.low}, Ints{pairs.high}};
}
#endif

#else

template <typename Offset>
HWY_INLINE Ints gatherWords(const void* base, const Offsets<Offset>& offsets) {
    const auto* b = static_cast<const std::uint8_t*>(base);
    alignas(64) std::int32_t words[kMaxLanes];
    for (std::size_t lane = 0; lane < hn::Lanes(kI); ++lane) {
        std::memcpy(&words[lane], b + offsets.at[lane], sizeof(std::int32_t));
    }
    return hn::Load(kI, words);
}
template <typename Offset>
HWY_INLINE WordPair gatherPairs(const void* base, const Offsets<Offset>& offsets) {
    const auto* b = static_cast<const std::uint8_t*>(base);
    return {gatherWords(b, offsets), gatherWords(b + 4, offsets)};
}

#endif

/// So many lanes' RGBA fill a vector: a block of four channels each.
constexpr std::size_t kBlocks = hn::MaxLanes(kF) / 4;

/// Blocks of 16 bytes that begin with kBlocks of an array's elements.
template <typename Element>
HWY_INLINE Ints gatherBlocks(const Element* array, const std::int32_t* elements) {
    const auto block = [&](int i) HWY_ATTR {
        return hn::LoadU(hn::Simd<std::int32_t, 4, 0>(), reinterpret_cast<const std::int32_t*>(array + elements[i]));
    };
#if HWY_TARGET == HWY_AVX3
    const auto two = [&](int i) HWY_ATTR {
        return _mm256_inserti128_si256(_mm256_castsi128_si256(block(i).raw), block(i + 1).raw, 1);
    };
    return join(two(0), two(2));
#elif HWY_TARGET == HWY_AVX2
    return Ints{_mm256_inserti128_si256(_mm256_castsi128_si256(block(0).raw), block(1).raw, 1)};
#else
    return block(0);
#endif
}

/// Lanes `from` to `from` + kBlocks - 1, each in all four places of its block.
HWY_INLINE Ints spread(Ints v, std::size_t from) {
    struct Order {
        alignas(64) std::int32_t lane[4 * kMaxLanes];
    };
    static constexpr Order order = [] {
        Order lanes{};
        for (int i = 0; i < 4 * kMaxLanes; ++i) {
            lanes.lane[i] = i / 4;
        }
        return lanes;
    }();
    return hn::TableLookupLanes(v, hn::IndicesFromVec(kI, hn::Load(kI, order.lane + 4 * from)));
}
HWY_INLINE Floats spread(Floats v, std::size_t from) { return hn::BitCast(kF, spread(hn::BitCast(kI, v), from)); }

/// Words at 32-bit byte offsets.
HWY_INLINE Ints gatherAt(const void* base, Ints byteOffsets) {
    Offsets<std::uint32_t> offsets;
    store(byteOffsets, offsets);
    return gatherWords(base, offsets);
}

HWY_INLINE Floats gatherFloats(const float* table, Ints entries) {
    return hn::BitCast(kF, gatherAt(table, hn::ShiftLeft<2>(entries)));
}

/// A place in a table that is read by linear interpolation.
struct TablePlace {
    Offsets<std::uint32_t> offsets;
    Floats fraction;
    HWY_INLINE explicit TablePlace(Floats entry) {
        const Ints whole = truncate(entry);
        fraction = hn::Sub(entry, toFloat(whole));
        store(hn::ShiftLeft<2>(whole), offsets);
    }
    HWY_INLINE Floats read(const float* table) const {
        const WordPair pair = gatherPairs(table, offsets);
        return lerp(hn::BitCast(kF, pair.low), hn::BitCast(kF, pair.high), fraction);
    }
    /// The same place in a row of a table of rows, `shift` entries further on.
    HWY_INLINE Floats readAt(const float* table, Ints shift) const {
        TablePlace moved = *this;
        store(hn::Add(hn::BitCast(kI, hn::Load(kU, offsets.at)), hn::ShiftLeft<2>(shift)), moved.offsets);
        return moved.read(table);
    }
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
