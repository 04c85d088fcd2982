// The march along a packet of rays: skip empty space, sample, shade, compose; compiled once for every instruction set.
#if defined(LIMNER_MARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_MARCH_INL_H
#undef LIMNER_MARCH_INL_H
#else
#define LIMNER_MARCH_INL_H
#endif

#include "renderer/cpu/queue-inl.h"
#include "renderer/cpu/rays-inl.h"
#include "renderer/plan/skip_grid.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// A packet of rays on its way.
struct Stream {
    RayPacket ray;
    Ints pixel;    ///< of each lane, inside the block
    Floats k, end; ///< next lattice sample, and the first that is not wanted
    Floats red, green, blue, alpha;
    Mask alive;
    bool settled; ///< every living lane stands in a block that can contribute
};

/// Marches two packets at a time. One packet alone leaves the processor waiting: each step is a chain of about a
/// hundred cycles from position over voxels and table to the next decision. Two chains that know nothing of each other
/// overlap. Choices that hold for a whole figure are plain branches: every lane of every packet takes the same side, so
/// they cost next to nothing, while a template for each would multiply the code.
template <typename Voxel, typename Offset>
class March {
    using VoxelField = Field<Voxel, Offset>;
    using Place = typename VoxelField::Place;
    static constexpr int kBurst = 4; ///< steps between two looks at the skip grid: 4 to 8 measured best

  public:
    static constexpr int kStreams = 2;

    March(const KernelScene& scene, float* rgba)
        : scene_(scene), field_{scene}, queue_(scene, rgba),
          oneOpacity_(scene.layerCount == 1 && !scene.layers[0].directionalOpacity) {}

    HWY_INLINE void start(int stream, const RayPacket& ray, Ints pixel) {
        Stream& s = streams_[stream];
        s.ray = ray;
        s.pixel = pixel;
        s.red = s.green = s.blue = s.alpha = splat(0);
        s.k = hn::Floor(ray.first);
        s.end = hn::Ceil(ray.end);
        s.alive = hn::And(ray.hit, hn::Lt(s.k, s.end));
    }

    HWY_INLINE void run() {
        for (;;) {
            skipEmpty();
            bool living = false;
            bool edge = false;
            for (const Stream& s : streams_) {
                const Mask part = hn::Or(hn::Lt(s.k, s.ray.first), hn::Gt(hn::Add(s.k, splat(kBurst)), s.ray.end));
                living |= !hn::AllFalse(kF, s.alive);
                edge |= !hn::AllFalse(kF, hn::And(s.alive, part));
            }
            if (!living) {
                return;
            }
#pragma GCC unroll 1
            for (int i = 0; i < kBurst; ++i) {
                for (Stream& s : streams_) {
                    step(s, edge);
                }
            }
        }
    }

    /// Colours that were composed one by one; with one opacity the queue has added them to the picture instead.
    [[nodiscard]] bool hasColours() const { return !oneOpacity_; }
    [[nodiscard]] const Stream& stream(int i) const { return streams_[i]; }
    /// Shades what still waits; after the last packet of a block.
    HWY_INLINE void finish() { queue_.finish(); }
    [[nodiscard]] HWY_INLINE KernelCounts counts() const {
        return {static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(kI, samples_))), shaded_};
    }

  private:
    HWY_INLINE Vec3 position(const RayPacket& ray, Floats s) const {
        const auto clamped = [&](Floats start, Floats step, int axis)
                                 HWY_ATTR { return hn::Min(hn::MulAdd(step, s, start), splat(scene_.lastCell[axis])); };
        return {clamped(ray.start.x, ray.step.x, 0), clamped(ray.start.y, ray.step.y, 1),
                clamped(ray.start.z, ray.step.z, 2)};
    }

    /// The stretch of the lattice's sample that is inside the visible part: begin and length, in steps.
    struct Segment {
        Floats begin, length;
    };
    static HWY_INLINE Segment segment(const Stream& s) {
        const Floats begin = hn::Max(s.k, s.ray.first);
        return {begin, hn::Sub(hn::Min(hn::Add(s.k, splat(1)), s.ray.end), begin)};
    }

    /// Moves every lane on to its next sample in a block that can contribute.
    HWY_INLINE void skipEmpty() {
        for (Stream& s : streams_) {
            s.settled = hn::AllFalse(kF, s.alive);
        }
        bool moving = true;
        while (moving) {
            moving = false;
            for (Stream& s : streams_) {
                if (!s.settled) {
                    leap(s);
                    moving |= !s.settled;
                }
            }
        }
    }

    /// One leap out of the empty cube around each lane's block.
    HWY_INLINE void leap(Stream& s) {
        constexpr int log2 = MinMaxGrid::kLog2BlockCells;
        const Floats phase = splat(scene_.phase);
        const Segment part = segment(s);
        const Floats at = hn::MulAdd(part.length, phase, part.begin);
        const Vec3 q = position(s.ray, at);
        const Ints bx = hn::ShiftRight<log2>(truncate(q.x));
        const Ints by = hn::ShiftRight<log2>(truncate(q.y));
        const Ints bz = hn::ShiftRight<log2>(truncate(q.z));
        const Ints block =
            hn::Add(hn::Mul(hn::Add(hn::Mul(bz, splatInt(scene_.blocks[1])), by), splatInt(scene_.blocks[0])), bx);
        // Lanes that are done may stand anywhere; they read block 0.
        const Ints safe = hn::IfThenElseZero(hn::RebindMask(kI, s.alive), block);
        const Ints distance = hn::And(gatherAt(scene_.distance, safe), splatInt(255));
        const Mask empty = hn::And(s.alive, hn::RebindMask(kF, hn::Gt(distance, hn::Zero(kI))));
        if (hn::AllFalse(kF, empty)) {
            s.settled = true;
            return;
        }
        const auto exit = [&](Floats step, Floats inverse, Ints b, Floats x) HWY_ATTR {
            const Ints ahead = hn::Add(b, distance);
            const Ints behind = hn::Add(hn::Sub(b, distance), splatInt(1));
            const Ints wall = hn::IfThenElse(hn::RebindMask(kI, hn::Gt(step, splat(0))), ahead, behind);
            return hn::Mul(hn::Sub(toFloat(hn::ShiftLeft<log2>(wall)), x), inverse);
        };
        const RayPacket& ray = s.ray;
        const Floats leave =
            hn::Min(exit(ray.step.x, ray.inverse.x, bx, q.x),
                    hn::Min(exit(ray.step.y, ray.inverse.y, by, q.y), exit(ray.step.z, ray.inverse.z, bz, q.z)));
        // The first lattice sample past the wall.
        const Floats next = hn::Add(hn::Floor(hn::Sub(hn::Add(at, leave), phase)), splat(1));
        s.k = hn::IfThenElse(empty, hn::Max(next, hn::Add(s.k, splat(1))), s.k);
        s.alive = hn::And(s.alive, hn::Lt(s.k, s.end));
        s.settled = hn::AllFalse(kF, s.alive);
    }

    /// One sample of every living lane. `edge`: some lane is at the first or last, partial sample of its stretch.
    HWY_INLINE void step(Stream& s, bool edge) {
        Segment part = {s.k, splat(1)};
        if (edge) {
            part = segment(s);
        }
        const Vec3 q = position(s.ray, hn::MulAdd(part.length, splat(scene_.phase), part.begin));
        const Place place = field_.locate(q, s.alive);
        const Floats found = hn::MulAdd(field_.value(place), splat(scene_.tableScale), splat(scene_.tableBias));
        const Floats entry = hn::IfThenElseZero(s.alive, found); // the others may hold anything
        samples_ = hn::Sub(samples_, hn::BitCast(kI, hn::VecFromMask(kF, s.alive)));
        s.k = hn::Add(s.k, splat(1));
        const Mask inRange = hn::And(hn::Gt(entry, splat(scene_.visibleFrom)), hn::Lt(entry, splat(scene_.visibleTo)));
        if (!hn::AllFalse(kF, hn::And(inRange, s.alive))) {
            look(s, {place, entry, part.length}, edge);
        }
        s.alive = hn::And(s.alive, hn::Lt(s.k, s.end));
    }

    struct Sample {
        const Place& place;
        Floats entry; ///< of the transfer tables
        Floats part;  ///< share of a step that the sample stands for
    };

    /// Looks a sample up, and hands it on where it can be seen.
    HWY_INLINE void look(Stream& s, const Sample& sample, bool edge) {
        const TablePlace at(sample.entry);
        const Floats visible = hn::IfThenElseZero(s.alive, at.read(scene_.visibility));
        const Mask shows = hn::Gt(visible, splat(0));
        if (hn::AllFalse(kF, shows)) {
            return;
        }
        shaded_ += hn::CountTrue(kF, shows);
        if (oneOpacity_) {
            const Floats opacity = edge ? opacityOfPart(visible, sample.part) : visible;
            const Floats weight = hn::NegMulAdd(opacity, s.alpha, opacity);
            s.alpha = hn::Add(s.alpha, weight);
            queue_.push({sample.place, sample.entry, weight, s.pixel, s.ray.view}, shows);
        } else {
            for (int i = 0; i < scene_.layerCount; ++i) {
                composeLayer(s, scene_.layers[i], sample, edge);
            }
        }
        s.alive = hn::And(s.alive, hn::Lt(s.alpha, splat(scene_.opaque)));
    }

    HWY_NOINLINE void composeLayer(Stream& s, const KernelLayer& layer, const Sample& sample, bool edge) {
        const TablePlace at(sample.entry);
        Floats opacity = hn::IfThenElseZero(s.alive, at.read(layer.stepOpacity));
        if (hn::AllFalse(kF, hn::Gt(opacity, splat(0)))) {
            return;
        }
        LaneColours colours;
        sampleColours(field_, layer, sample.place, sample.entry, s.ray.view, colours);
        Floats r, g, b, directional;
        hn::LoadInterleaved4(kF, colours.rgba, r, g, b, directional);
        if (layer.directionalOpacity) {
            const Floats whole = hn::Mul(at.read(layer.opacity), directional);
            opacity = hn::IfThenElseZero(s.alive, opacityOfStep(scene_, whole, sample.part));
        } else if (edge) {
            opacity = opacityOfPart(opacity, sample.part);
        }
        const Floats weight = hn::NegMulAdd(opacity, s.alpha, opacity);
        s.red = hn::MulAdd(weight, r, s.red);
        s.green = hn::MulAdd(weight, g, s.green);
        s.blue = hn::MulAdd(weight, b, s.blue);
        s.alpha = hn::Add(s.alpha, weight);
    }

    const KernelScene& scene_;
    VoxelField field_;
    ShadeQueue<VoxelField, Offset> queue_;
    Stream streams_[kStreams];
    Ints samples_ = hn::Zero(kI);
    std::uint64_t shaded_ = 0;
    bool oneOpacity_; ///< a sample's opacity is known before its colour: no directional opacity, one layer
};

/// Packet of neighbouring rays: 2x2, 4x2 or 4x4.
struct PacketShape {
    int width, height;
};
HWY_INLINE PacketShape packetShape() {
    const int lanes = static_cast<int>(hn::Lanes(kF));
    const int width = lanes >= 8 ? 4 : lanes >= 4 ? 2 : 1;
    return {width, lanes / width};
}

/// Casts a block's packets and writes their pixels.
template <typename Voxel, typename Offset>
class BlockCaster {
    using BlockMarch = March<Voxel, Offset>;

  public:
    BlockCaster(const KernelScene& scene, const KernelBlock& block, float* rgba)
        : rays_(scene, block), march_(scene, rgba), block_(block), rgba_(rgba) {}

    HWY_INLINE KernelCounts run() {
        for (int y = 0; y < block_.height; y += shape_.height) {
            for (int x = 0; x < block_.width; x += shape_.width * BlockMarch::kStreams) {
                bool hit = false;
                for (int i = 0; i < BlockMarch::kStreams; ++i) {
                    hit |= start(i, x + i * shape_.width, y);
                }
                if (hit) {
                    march_.run();
                    for (int i = 0; i < BlockMarch::kStreams; ++i) {
                        keep(march_.stream(i));
                    }
                }
            }
        }
        march_.finish();
        for (int i = 0; i < KernelBlock::kSize * KernelBlock::kSize; ++i) {
            rgba_[4 * i + 3] = alpha_[i];
        }
        return march_.counts();
    }

  private:
    HWY_INLINE bool start(int stream, int x, int y) {
        alignas(64) float dx[kMaxLanes];
        alignas(64) float dy[kMaxLanes];
        alignas(64) std::int32_t pixel[kMaxLanes];
        for (int lane = 0; lane < shape_.width * shape_.height; ++lane) {
            const int column = x + lane % shape_.width;
            const int row = y + lane / shape_.width;
            dx[lane] = static_cast<float>(column) + 0.5F - 0.5F * KernelBlock::kSize;
            dy[lane] = static_cast<float>(row) + 0.5F - 0.5F * KernelBlock::kSize;
            pixel[lane] = row * KernelBlock::kSize + column;
        }
        const RayPacket packet = rays_.packet(hn::Load(kF, dx), hn::Load(kF, dy));
        march_.start(stream, packet, hn::Load(kI, pixel));
        return !hn::AllFalse(kF, packet.hit);
    }

    HWY_INLINE void keep(const Stream& s) {
        alignas(64) float channel[4][kMaxLanes];
        alignas(64) std::int32_t pixel[kMaxLanes];
        hn::Store(s.red, kF, channel[0]);
        hn::Store(s.green, kF, channel[1]);
        hn::Store(s.blue, kF, channel[2]);
        hn::Store(s.alpha, kF, channel[3]);
        hn::Store(s.pixel, kI, pixel);
        for (int lane = 0; lane < shape_.width * shape_.height; ++lane) {
            alpha_[pixel[lane]] = channel[3][lane];
            for (int c = 0; c < 3 && march_.hasColours(); ++c) {
                rgba_[4 * pixel[lane] + c] = channel[c][lane];
            }
        }
    }

    const PacketShape shape_ = packetShape();
    const RayBlock rays_;
    BlockMarch march_;
    const KernelBlock& block_;
    float* rgba_;
    // The queue adds colours late; opacities wait beside them.
    alignas(64) float alpha_[KernelBlock::kSize * KernelBlock::kSize] = {};
};

template <typename Voxel, typename Offset>
void castRays(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts) {
    BlockCaster<Voxel, Offset> caster(scene, block, rgba);
    counts = caster.run();
}

template <typename Voxel>
void castWidth(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts) {
    if (scene.wide) {
        castRays<Voxel, std::int64_t>(scene, block, rgba, counts);
    } else {
        castRays<Voxel, std::uint32_t>(scene, block, rgba, counts);
    }
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
