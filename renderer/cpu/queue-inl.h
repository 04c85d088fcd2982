// The queue of samples that wait for their colour; compiled once for every instruction set.
#if defined(LIMNER_QUEUE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_QUEUE_INL_H
#undef LIMNER_QUEUE_INL_H
#else
#define LIMNER_QUEUE_INL_H
#endif

#include "renderer/cpu/shade-inl.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2
/// For each of the 256 masks, which lanes are set, lowest first.
struct LaneLists {
    alignas(64) std::uint8_t lanes[256][8];
};
constexpr LaneLists makeLaneLists() {
    LaneLists lists{};
    for (int mask = 0; mask < 256; ++mask) {
        int count = 0;
        for (int lane = 0; lane < 8; ++lane) {
            if ((mask >> lane & 1) != 0) {
                lists.lanes[mask][count++] = static_cast<std::uint8_t>(lane);
            }
        }
    }
    return lists;
}
inline constexpr LaneLists kLaneLists = makeLaneLists();
#endif

/// Moves the lanes of a mask to the front. One look-up serves all vectors of a sample (AVX2 has no such instruction,
/// and Highway's own would look the mask up for each vector).
class Packer {
  public:
#if HWY_TARGET == HWY_AVX2
    HWY_INLINE explicit Packer(Mask mask) {
        const auto bits = static_cast<unsigned>(_mm256_movemask_ps(hn::VecFromMask(kF, mask).raw));
        order_ = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(kLaneLists.lanes[bits])));
        count_ = _mm_popcnt_u32(bits);
    }
    HWY_INLINE Floats pack(Floats v) const { return Floats{_mm256_permutevar8x32_ps(v.raw, order_)}; }
#else
    HWY_INLINE explicit Packer(Mask mask) : mask_(mask), count_(static_cast<int>(hn::CountTrue(kF, mask))) {}
    HWY_INLINE Floats pack(Floats v) const { return hn::Compress(v, mask_); }
#endif
    HWY_INLINE Ints pack(Ints v) const { return hn::BitCast(kI, pack(hn::BitCast(kF, v))); }
    [[nodiscard]] HWY_INLINE int count() const { return count_; }

  private:
#if HWY_TARGET == HWY_AVX2
    __m256i order_;
#else
    Mask mask_;
#endif
    int count_;
};

/// Samples of one layer whose weight in their pixel is known and whose colour is not. They are shaded a full vector at
/// a time, whichever rays they came from: about half of the lanes of a packet contribute at a given step, so shading on
/// the spot would throw half of the work away. Each pixel's samples stay in order and each is added by itself, so the
/// sums do not depend on who else was in the vector.
template <typename VoxelField, typename Offset>
class ShadeQueue {
    using Place = typename VoxelField::Place;

  public:
    ShadeQueue(const KernelScene& scene, float* rgba) : scene_(scene), field_{scene}, rgba_(rgba) {}

    struct Entry {
        const Place& place;
        Floats tableEntry;
        Floats weight;
        Ints pixel;
        const Vec3& view;
    };

    HWY_INLINE void push(const Entry& sample, Mask mask) {
        const Packer packer(mask);
        const auto keep = [&](Floats v, float* row) HWY_ATTR { hn::StoreU(packer.pack(v), kF, row + count_); };
        keep(sample.place.fx, fx_);
        keep(sample.place.fy, fy_);
        keep(sample.place.fz, fz_);
        keep(sample.tableEntry, tableEntry_);
        keep(sample.weight, weight_);
        hn::StoreU(packer.pack(sample.pixel), kI, pixel_ + count_);
        if (scene_.perspective) {
            keep(sample.view.x, viewX_);
            keep(sample.view.y, viewY_);
            keep(sample.view.z, viewZ_);
        }
        if constexpr (sizeof(Offset) == 4) {
            const Ints offsets = hn::BitCast(kI, hn::Load(kU, sample.place.offsets.at));
            hn::StoreU(hn::BitCast(kU, packer.pack(offsets)), kU, offset_ + count_);
        } else {
            alignas(64) std::uint8_t bits[8] = {};
            hn::StoreMaskBits(kF, mask, bits);
            int at = count_;
            for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
                if ((bits[lane / 8] >> (lane % 8) & 1) != 0) {
                    offset_[at++] = sample.place.offsets.at[lane];
                }
            }
        }
        count_ += packer.count();
        const int lanes = static_cast<int>(hn::Lanes(kF));
        if (count_ >= lanes) {
            shade(lanes);
            moveUp(lanes);
            count_ -= lanes;
        }
    }

    /// Shades what is left.
    HWY_INLINE void finish() {
        if (count_ > 0) {
            shade(count_);
            count_ = 0;
        }
    }

  private:
    HWY_NOINLINE void shade(int count) {
        Place place;
        place.fx = hn::Load(kF, fx_);
        place.fy = hn::Load(kF, fy_);
        place.fz = hn::Load(kF, fz_);
        for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
            place.offsets.at[lane] = offset_[lane];
        }
        Vec3 view = {splat(0), splat(0), splat(1)};
        if (scene_.perspective) {
            view = {hn::Load(kF, viewX_), hn::Load(kF, viewY_), hn::Load(kF, viewZ_)};
        }
        LaneColours colours;
        sampleColours(field_, scene_.layers[0], place, hn::Load(kF, tableEntry_), view, colours);
        for (int lane = 0; lane < count; ++lane) {
            float* pixel = rgba_ + 4 * pixel_[lane];
            const Quad weight = hn::Set(kQuad, weight_[lane]);
            hn::Store(hn::MulAdd(weight, hn::Load(kQuad, colours.rgba + 4 * lane), hn::Load(kQuad, pixel)), kQuad,
                      pixel);
        }
    }

    HWY_INLINE void moveUp(int lanes) {
        for (float* row : {fx_, fy_, fz_, tableEntry_, weight_}) {
            hn::Store(hn::LoadU(kF, row + lanes), kF, row);
        }
        if (scene_.perspective) {
            for (float* row : {viewX_, viewY_, viewZ_}) {
                hn::Store(hn::LoadU(kF, row + lanes), kF, row);
            }
        }
        hn::Store(hn::LoadU(kI, pixel_ + lanes), kI, pixel_);
        for (int lane = 0; lane < lanes; ++lane) {
            offset_[lane] = offset_[lane + lanes];
        }
    }

    const KernelScene& scene_;
    VoxelField field_;
    float* rgba_;
    int count_ = 0;
    static constexpr int kRoom = 3 * kMaxLanes; ///< a vector waiting, one pushed, and the over-write of its last store
    alignas(64) float fx_[kRoom] = {};
    alignas(64) float fy_[kRoom] = {};
    alignas(64) float fz_[kRoom] = {};
    alignas(64) float tableEntry_[kRoom] = {};
    alignas(64) float weight_[kRoom] = {};
    alignas(64) float viewX_[kRoom] = {};
    alignas(64) float viewY_[kRoom] = {};
    alignas(64) float viewZ_[kRoom] = {};
    alignas(64) std::int32_t pixel_[kRoom] = {};
    alignas(64) Offset offset_[kRoom] = {};
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
