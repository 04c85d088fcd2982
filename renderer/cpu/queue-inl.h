// The queue of samples that wait for their colour; compiled once for every instruction set.
#if defined(LIMNER_QUEUE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_QUEUE_INL_H
#undef LIMNER_QUEUE_INL_H
#else
#define LIMNER_QUEUE_INL_H
#endif

#include "renderer/cpu/cues-inl.h"
#include "renderer/cpu/importance-inl.h"
#include "renderer/cpu/layer-inl.h"
#include "renderer/cpu/slabs-inl.h"

#include "renderer/plan/importance_bricks.h"

#include <vector>

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

/// Samples that wait for their colour. They are shaded a full vector at a time, whichever rays they came from: about
/// half of the lanes of a packet contribute at a given step, so shading on the spot would throw half of the work away.
/// Each pixel's samples stay in order and each is composed by itself, so the sums do not depend on who else was in the
/// vector.
///
/// With early opacity (KernelScene::earlyOpacity) a sample comes with its weight in the pixel; else with its part of a
/// step alone, and the pixel's alpha is known only when its samples have been composed.
template <typename VoxelField>
class ShadeQueue {
    using Place = typename VoxelField::Place;
    using Offset = typename VoxelField::OffsetType;
    /// Places of wide stores are found anew: their offsets do not fit a vector.
    static constexpr bool kKeepsOffsets = sizeof(Offset) == 4;

  public:
    /// `rgba`: the block's pixels.
    ShadeQueue(const KernelScene& scene, const KernelBlock& block, float* rgba)
        : scene_(scene), byImportance_(block.ahead != nullptr), ahead_(block.ahead),
          earlyOpacity_(weighsAtOnce(scene, block)),
          readsPart_(!earlyOpacity_ || scene.layerCount > 1 || scene.preintegrated), field_{scene}, rgba_(rgba),
          composer_(scene, block, rgba) {
        if (readsPart_) {
            layers_.resize(static_cast<std::size_t>(scene.layerCount));
        }
    }

    /// Whether a sample's weight in its pixel is known before it is shaded.
    static bool weighsAtOnce(const KernelScene& scene, const KernelBlock& block) {
        return scene.earlyOpacity && block.ahead == nullptr;
    }

    struct Entry {
        const Place* place; ///< null: of a slab, whose place is found when it is shaded
        const Vec3& q;      ///< of a slab's front, wherever that is
        Floats tableEntry;
        Floats weight; ///< with early opacity
        Floats part;   ///< of a step
        Ints pixel;
        const Vec3& view;
        Floats back; ///< table entry at a slab's back; not read of a sample
    };

    /// Whether samples were composed on the way.
    HWY_INLINE bool push(const Entry& sample, Mask mask) {
        const Packer packer(mask);
        const auto keep = [&](Floats v, float* row) HWY_ATTR { hn::StoreU(packer.pack(v), kF, row + count_); };
        keep(sample.q.x, x_);
        keep(sample.q.y, y_);
        keep(sample.q.z, z_);
        keep(sample.tableEntry, tableEntry_);
        if (earlyOpacity_) {
            keep(sample.weight, weight_);
        }
        if (readsPart_) {
            keep(sample.part, part_);
        }
        hn::StoreU(packer.pack(sample.pixel), kI, pixel_ + count_);
        if constexpr (kKeepsOffsets) {
            if (sample.place != nullptr) {
                const Ints offsets = hn::BitCast(kI, hn::Load(kU, sample.place->offsets.at));
                hn::StoreU(packer.pack(offsets), kI, offset_ + count_);
            }
        }
        if (scene_.preintegrated) {
            keep(sample.back, back_);
        }
        if (scene_.perspective) {
            keep(sample.view.x, viewX_);
            keep(sample.view.y, viewY_);
            keep(sample.view.z, viewZ_);
        }
        count_ += packer.count();
        const int lanes = static_cast<int>(hn::Lanes(kF));
        if (count_ < lanes) {
            return false;
        }
        shade(lanes);
        moveUp(lanes);
        count_ -= lanes;
        return true;
    }

    /// Shades what is left, and leaves the pixels premultiplied.
    HWY_INLINE void finish() {
        if (count_ > 0) {
            shade(count_);
            count_ = 0;
        }
        if (byImportance_) {
            composer_.finish();
        }
    }

    /// Whether a pixel takes no more samples; not with early opacity.
    [[nodiscard]] HWY_INLINE bool done(std::int32_t pixel) const {
        return byImportance_ ? composer_.done(pixel) : rgba_[4 * pixel + 3] >= scene_.opaque;
    }

  private:
    HWY_NOINLINE void shade(int count) {
        // Lanes that nobody filled may hold anything.
        const Mask filled = hn::FirstN(kF, static_cast<std::size_t>(count));
        const auto load = [&](const float* row) HWY_ATTR { return hn::IfThenElseZero(filled, hn::Load(kF, row)); };
        const Vec3 q = {load(x_), load(y_), load(z_)};
        if (scene_.preintegrated) {
            addSlabs(q, {load(tableEntry_), load(back_)}, load(part_), count);
            return;
        }
        Place place;
        if constexpr (kKeepsOffsets) {
            const Ints offsets =
                hn::IfThenElse(hn::RebindMask(kI, filled), hn::Load(kI, offset_), splatInt(VoxelField::kFirstCell));
            place = VoxelField::placeAt(q, offsets);
        } else {
            place = field_.locate(q, filled);
        }
        const Vec3 view = viewOfLanes();
        Facts<VoxelField> facts(field_, place, members_, q, view, load(tableEntry_), load(part_));
        facts.measure();
        if (scene_.cues.any) {
            cues_.measure(facts);
        }
        if (earlyOpacity_ && !readsPart_) {
            addWeighted(facts, count);
        } else if (earlyOpacity_) {
            addLayersWeighted(facts, count);
        } else if (byImportance_) {
            composeByImportance(facts, count);
        } else {
            compose(facts, count);
        }
    }

    HWY_INLINE void addWeighted(const Facts<VoxelField>& facts, int count) {
        LaneColours colours;
        LayerEvaluation<VoxelField>(scene_, scene_.layers[0]).colourByValue(facts, colours);
        lightByCues(colours);
        for (int lane = 0; lane < count; ++lane) {
            float* pixel = rgba_ + 4 * pixel_[lane];
            const Quad weight = hn::Set(kQuad, weight_[lane]);
            hn::Store(hn::MulAdd(weight, hn::Load(kQuad, colours.rgba + 4 * lane), hn::Load(kQuad, pixel)), kQuad,
                      pixel);
        }
    }

    /// Several layers, each with its share of the samples' weight.
    HWY_NOINLINE void addLayersWeighted(const Facts<VoxelField>& facts, int count) {
        const Floats total =
            opacityOfLayers<VoxelField>(scene_, facts.tableEntry, facts.part, [&](int i, Floats opacity) HWY_ATTR {
                layers_[static_cast<std::size_t>(i)].opacity = opacity;
            });
        const Floats scale = hn::Div(hn::Load(kF, weight_), hn::Max(total, splat(1e-30F)));
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            const Floats share = hn::Mul(hn::Load(kF, layers_[i].opacity.at), scale);
            layers_[i].opacity = share;
            layers_[i].shows = !hn::AllFalse(kF, hn::Gt(share, splat(0)));
            if (layers_[i].shows) {
                LayerEvaluation<VoxelField>(scene_, scene_.layers[i]).colourByValue(facts, layers_[i].colours);
                lightByCues(layers_[i].colours);
            }
        }
        addShares(count);
    }

    /// Slabs, each layer's at the place where its matter is seen. `ends`: of the scene's table.
    HWY_NOINLINE void addSlabs(const Vec3& front, const SlabEnds& ends, Floats part, int count) {
        const Floats total = opacityOfSlabs(scene_, ends, part, [&](int i, Floats depth, Floats opacity) HWY_ATTR {
            layers_[static_cast<std::size_t>(i)].opacity = opacity;
            layers_[static_cast<std::size_t>(i)].depth = depth;
        });
        const Floats scale = hn::Div(hn::Load(kF, weight_), hn::Max(total, splat(1e-30F)));
        const Vec3 view = viewOfLanes();
        const Vec3 perMm = turned(scene_.cellFromEye, view);
        const Floats lengthMm = hn::Mul(part, splat(static_cast<float>(scene_.stepMm)));
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            const Floats share = hn::Mul(hn::Load(kF, layers_[i].opacity.at), scale);
            layers_[i].opacity = share;
            layers_[i].shows = !hn::AllFalse(kF, hn::Gt(share, splat(0)));
            if (!layers_[i].shows) {
                continue;
            }
            const KernelLayer& layer = scene_.layers[i];
            const Floats seen = seenPlaces(layer, endsIn(layer, ends), hn::Load(kF, layers_[i].depth.at));
            const Floats back = hn::Neg(hn::Mul(seen, lengthMm)); // the view looks towards the viewer
            const auto moved = [&](Floats from, Floats along, int axis) HWY_ATTR {
                const Floats to = hn::MulAdd(back, along, from);
                return hn::Min(hn::Max(to, splat(0)), splat(scene_.lastCell[axis]));
            };
            const Vec3 q = {moved(front.x, perMm.x, 0), moved(front.y, perMm.y, 1), moved(front.z, perMm.z, 2)};
            const Place place = field_.locate(q, hn::FirstN(kF, hn::Lanes(kF)));
            Facts<VoxelField> facts(field_, place, members_, q, view, lerp(ends.front, ends.back, seen), part);
            facts.measure();
            if (scene_.cues.any) {
                cues_.measure(facts);
            }
            LayerEvaluation<VoxelField>(scene_, layer).colourByValue(facts, layers_[i].colours);
            lightByCues(layers_[i].colours);
        }
        addShares(count);
    }

    /// The layers' colours by their shares of the samples' weight. Sample by sample: a pixel's sum must not depend on
    /// who else is in the vector.
    HWY_INLINE void addShares(int count) {
        for (int lane = 0; lane < count; ++lane) {
            float* pixel = rgba_ + 4 * pixel_[lane];
            Quad sum = hn::Load(kQuad, pixel);
            for (const Evaluated& layer : layers_) {
                if (layer.shows) {
                    const Quad c = hn::Load(kQuad, layer.colours.rgba + 4 * lane);
                    sum = hn::MulAdd(hn::Set(kQuad, layer.opacity.at[lane]), c, sum);
                }
            }
            hn::Store(sum, kQuad, pixel);
        }
    }

    /// What one layer makes of the samples.
    struct Evaluated {
        LaneColours colours;
        LaneFloats opacity;
        LaneFloats depth;     ///< optical; of slabs only
        bool shows = false;   ///< early opacity only: in any lane
        WeighedLanes weighed; ///< by importance only
    };

    /// All layers of each sample, one composited after the other; a pixel that is opaque takes no more samples.
    HWY_NOINLINE void compose(const Facts<VoxelField>& facts, int count) {
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            layers_[i].opacity = evaluate({scene_, scene_.layers[i]}, facts, layers_[i].colours);
        }
        for (int lane = 0; lane < count; ++lane) {
            float* pixel = rgba_ + 4 * pixel_[lane];
            if (pixel[3] >= scene_.opaque) {
                continue;
            }
            Quad sum = hn::Load(kQuad, pixel);
            float alpha = pixel[3];
            for (const Evaluated& layer : layers_) {
                const float opacity = layer.opacity.at[lane];
                if (opacity > 0) {
                    const float all = alpha + (1 - alpha) * opacity;
                    const float weight = all - alpha; // see March::look
                    const Quad c = hn::IfThenElse(alphaLane(), hn::Set(kQuad, 1.0F),
                                                  hn::Load(kQuad, layer.colours.rgba + 4 * lane));
                    sum = hn::MulAdd(hn::Set(kQuad, weight), c, sum);
                    alpha = all;
                }
            }
            hn::Store(sum, kQuad, pixel);
        }
    }

    /// The same by importance.
    HWY_NOINLINE void composeByImportance(const Facts<VoxelField>& facts, int count) {
        const KernelImportance& settings = scene_.importance;
        const Floats weight = composer_.weights(pixel_);
        const LaneFloats ahead(hn::GatherIndex(kF, ahead_, slabOf(facts.q)));
        const Floats shareAhead = composer_.shareAhead(weight, hn::Load(kF, ahead.at));
        const LaneFloats share(shareAhead);
        const bool settled = settings.settles && composer_.settled(pixel_, shareAhead, count);
        const ImportanceMeasures<VoxelField> measures(settings, facts, settled);
        for (std::size_t i = 0; i < layers_.size(); ++i) {
            const KernelLayer& kernelLayer = scene_.layers[i];
            const LayerEvaluation<VoxelField> layer(scene_, kernelLayer);
            const Floats opacity = evaluate(layer, facts, layers_[i].colours);
            layers_[i].opacity = opacity;
            if (settled) {
                layers_[i].weighed.exponential = splat(1); // e^0, no more than any ray has
            } else {
                composer_.weigh(measures, weight, kernelLayer.importanceWeight, opacity, layer.partOf(facts),
                                layers_[i].weighed);
            }
        }
        LaneFloats dark(splat(1));
        if (settings.silhouette > 0) {
            dark = measures.darkening(hn::Min(hn::Mul(weight, splat(settings.actsPerWeight)), splat(1)));
        }
        for (int lane = 0; lane < count; ++lane) {
            const std::int32_t pixel = pixel_[lane];
            if (composer_.done(pixel)) {
                continue;
            }
            for (std::size_t i = 0; i < layers_.size(); ++i) {
                const Evaluated& layer = layers_[i];
                if (layer.opacity.at[lane] > 0) {
                    const Quad colour =
                        hn::Mul(hn::Load(kQuad, layer.colours.rgba + 4 * lane), hn::Set(kQuad, dark.at[lane]));
                    composer_.add(pixel, colour, layer.opacity.at[lane], layer.weighed, static_cast<std::size_t>(lane),
                                  scene_.layers[i].importanceWeight);
                }
            }
            composer_.endWhereCertain(pixel, ahead.at[lane], share.at[lane]);
        }
    }

    /// One layer with the depth cues.
    HWY_INLINE Floats evaluate(const LayerEvaluation<VoxelField>& layer, const Facts<VoxelField>& facts,
                               LaneColours& out) const {
        if (layer.moves()) {
            return evaluateMoved(layer, facts, out);
        }
        const Floats opacity = layer.evaluate(facts, out);
        lightByCues(out);
        return opacity;
    }

    HWY_NOINLINE Floats evaluateMoved(const LayerEvaluation<VoxelField>& layer, const Facts<VoxelField>& facts,
                                      LaneColours& out) const {
        const Facts<VoxelField> own = layer.moved(facts);
        const Floats opacity = layer.evaluate(own, out);
        if (scene_.cues.any) {
            CueLanes<VoxelField> cues(scene_);
            cues.measure(own);
            cues.apply(out);
        }
        return opacity;
    }

    /// Directions to the viewer of the samples that wait.
    HWY_INLINE Vec3 viewOfLanes() const {
        return scene_.perspective ? Vec3{hn::Load(kF, viewX_), hn::Load(kF, viewY_), hn::Load(kF, viewZ_)}
                                  : Vec3{splat(0), splat(0), splat(1)};
    }

    HWY_INLINE void lightByCues(LaneColours& colours) const {
        if (scene_.cues.any) {
            cues_.apply(colours);
        }
    }

    HWY_INLINE Ints slabOf(const Vec3& q) const {
        const float* s = scene_.importance.slabFromCell;
        const Floats at = hn::Add(dot(q, {splat(s[0]), splat(s[1]), splat(s[2])}), splat(s[3]));
        return truncate(hn::Min(hn::Max(at, splat(0)), splat(ImportanceAhead::kSlabs - 1)));
    }

    HWY_INLINE void moveUp(int lanes) {
        for (float* row : {x_, y_, z_, tableEntry_, weight_}) {
            hn::Store(hn::LoadU(kF, row + lanes), kF, row);
        }
        if (readsPart_) {
            hn::Store(hn::LoadU(kF, part_ + lanes), kF, part_);
        }
        if (scene_.preintegrated) {
            hn::Store(hn::LoadU(kF, back_ + lanes), kF, back_);
        }
        if (scene_.perspective) {
            for (float* row : {viewX_, viewY_, viewZ_}) {
                hn::Store(hn::LoadU(kF, row + lanes), kF, row);
            }
        }
        hn::Store(hn::LoadU(kI, pixel_ + lanes), kI, pixel_);
        if constexpr (kKeepsOffsets) {
            hn::Store(hn::LoadU(kI, offset_ + lanes), kI, offset_);
        }
    }

    const KernelScene& scene_;
    bool byImportance_;
    const float* ahead_;
    bool earlyOpacity_;
    bool readsPart_;
    VoxelField field_;
    float* rgba_;
    ImportanceComposer composer_;
    std::vector<Evaluated> layers_;
    Members members_;
    CueLanes<VoxelField> cues_{scene_};
    int count_ = 0;
    static constexpr int kRoom = 3 * kMaxLanes; ///< a vector waiting, one pushed, and the over-write of its last store
    alignas(64) float x_[kRoom] = {};
    alignas(64) float y_[kRoom] = {};
    alignas(64) float z_[kRoom] = {};
    alignas(64) float tableEntry_[kRoom] = {};
    alignas(64) float weight_[kRoom] = {};
    alignas(64) float part_[kRoom] = {};
    alignas(64) float back_[kRoom] = {};
    alignas(64) float viewX_[kRoom] = {};
    alignas(64) float viewY_[kRoom] = {};
    alignas(64) float viewZ_[kRoom] = {};
    alignas(64) std::int32_t pixel_[kRoom] = {};
    alignas(64) std::int32_t offset_[kRoom] = {};
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
