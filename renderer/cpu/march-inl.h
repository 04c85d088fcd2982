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

/// Marches one packet. Choices that hold for a whole figure are plain branches: every lane of every packet takes the
/// same side, so they cost next to nothing, while a template for each would multiply the code.
template <typename Voxel, typename Offset>
class March {
    using VoxelField = Field<Voxel, Offset>;
    using Place = typename VoxelField::Place;
    static constexpr int kBurst = 8; ///< steps between two looks at the skip grid: 8 to 16 measured best

  public:
    March(const KernelScene& scene, const KernelBlock& block, float* rgba)
        : scene_(scene), earlyOpacity_(ShadeQueue<VoxelField>::weighsAtOnce(scene, block)), field_{scene},
          queue_(scene, block, rgba) {}

    /// A packet on its way.
    struct Traveller {
        RayPacket ray;
        Ints pixel;
        Floats k, end; ///< next sample and the one past the last
        Floats alpha;  ///< known here with early opacity only, else it is the picture's
        Floats alive;  ///< a mask's bits: not every instruction set can keep masks in memory
    };

    HWY_INLINE void begin(Traveller& packet, const RayPacket& ray, Ints pixel) const {
        packet.ray = ray;
        packet.pixel = pixel;
        packet.alpha = splat(0);
        packet.k = hn::Floor(ray.first);
        packet.end = hn::Ceil(ray.end);
        packet.alive = bitsOf(hn::And(ray.hit, hn::Lt(packet.k, packet.end)));
    }

    /// Marches on up to sample `until`, about. False: the packet has arrived.
    HWY_INLINE bool advance(Traveller& packet, Floats until) {
        const RayPacket& ray = packet.ray;
        ray_ = &ray;
        pixel_ = packet.pixel;
        alpha_ = packet.alpha;
        k_ = packet.k;
        end_ = packet.end;
        alive_ = hn::MaskFromVec(packet.alive);
        bool more = !hn::AllFalse(kF, alive_);
        while (more && !hn::AllFalse(kF, hn::And(alive_, hn::Lt(k_, until)))) {
            more = skipEmpty();
            if (more) {
                const Mask edge =
                    hn::And(alive_, hn::Or(hn::Lt(k_, ray.first), hn::Gt(hn::Add(k_, splat(kBurst)), ray.end)));
                if (scene_.preintegrated) {
                    burstOfSlabs(!hn::AllFalse(kF, edge));
                } else {
                    burst(!hn::AllFalse(kF, edge));
                }
                more = !hn::AllFalse(kF, alive_);
            }
        }
        packet.alpha = alpha_;
        packet.k = k_;
        packet.alive = bitsOf(alive_);
        return more;
    }

    /// Shades what still waits; after the last packet of a block.
    HWY_INLINE void finish() { queue_.finish(); }
    [[nodiscard]] HWY_INLINE KernelCounts counts() const {
        return {static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(kI, samples_))), counts_.shaded};
    }

  private:
    static HWY_INLINE Floats bitsOf(Mask mask) { return hn::VecFromMask(kF, mask); }

    HWY_INLINE Vec3 position(Floats s) const {
        const auto clamped = [&](Floats start, Floats step, int axis)
                                 HWY_ATTR { return hn::Min(hn::MulAdd(step, s, start), splat(scene_.lastCell[axis])); };
        return {clamped(ray_->start.x, ray_->step.x, 0), clamped(ray_->start.y, ray_->step.y, 1),
                clamped(ray_->start.z, ray_->step.z, 2)};
    }

    /// The stretch of the lattice's sample that is inside the visible part: begin and length, in steps.
    struct Segment {
        Floats begin, length;
    };
    HWY_INLINE Segment segment() const {
        const Floats begin = hn::Max(k_, ray_->first);
        return {begin, hn::Sub(hn::Min(hn::Add(k_, splat(1)), ray_->end), begin)};
    }

    /// Moves every lane on to the next sample in a block that can contribute. False: nothing is left. A slab is passed
    /// over only where all of it lies in blocks that show nothing.
    HWY_INLINE bool skipEmpty() {
        constexpr int log2 = MinMaxGrid::kLog2BlockCells;
        const Floats phase = splat(scene_.preintegrated ? 0 : scene_.phase); // of the place that is asked for
        const Floats last = splat(scene_.preintegrated ? 1 : scene_.phase);  // of what must still be in the block
        for (;;) {
            const Segment part = segment();
            const Floats s = hn::MulAdd(part.length, phase, part.begin);
            const Vec3 q = position(s);
            const Ints bx = hn::ShiftRight<log2>(truncate(q.x));
            const Ints by = hn::ShiftRight<log2>(truncate(q.y));
            const Ints bz = hn::ShiftRight<log2>(truncate(q.z));
            const Ints block =
                hn::Add(hn::Mul(hn::Add(hn::Mul(bz, splatInt(scene_.blocks[1])), by), splatInt(scene_.blocks[0])), bx);
            // Lanes that are done may stand anywhere; they read block 0.
            const Ints safe = hn::IfThenElseZero(hn::RebindMask(kI, alive_), block);
            const Ints distance = hn::And(gatherAt(scene_.distance, safe), splatInt(255));
            Mask empty = hn::And(alive_, hn::RebindMask(kF, hn::Gt(distance, hn::Zero(kI))));
            if (hn::AllFalse(kF, empty)) {
                return true;
            }
            const auto exit = [&](Floats step, Floats inverse, Ints b, Floats x) HWY_ATTR {
                const Ints ahead = hn::Add(b, distance);
                const Ints behind = hn::Add(hn::Sub(b, distance), splatInt(1));
                const Ints wall = hn::IfThenElse(hn::RebindMask(kI, hn::Gt(step, splat(0))), ahead, behind);
                return hn::Mul(hn::Sub(toFloat(hn::ShiftLeft<log2>(wall)), x), inverse);
            };
            const Floats leave = hn::Min(
                exit(ray_->step.x, ray_->inverse.x, bx, q.x),
                hn::Min(exit(ray_->step.y, ray_->inverse.y, by, q.y), exit(ray_->step.z, ray_->inverse.z, bz, q.z)));
            if (scene_.preintegrated) {
                empty = hn::And(empty, hn::Ge(leave, part.length));
                if (hn::AllFalse(kF, empty)) {
                    return true;
                }
            }
            // The first lattice sample past the wall.
            const Floats next = hn::Add(hn::Floor(hn::Sub(hn::Add(s, leave), last)), splat(1));
            k_ = hn::IfThenElse(empty, hn::Max(next, hn::Add(k_, splat(1))), k_);
            alive_ = hn::And(alive_, hn::Lt(k_, end_));
            if (hn::AllFalse(kF, alive_)) {
                return false;
            }
        }
    }

    /// `edge`: some lane is at the first or last, partial sample of its stretch.
    HWY_INLINE void burst(bool edge) {
        for (int i = 0; i < kBurst; ++i) {
            Segment part = {k_, splat(1)};
            if (edge) {
                part = segment();
            }
            Vec3 q = position(hn::MulAdd(part.length, splat(scene_.phase), part.begin));
            Mask located = alive_;
            if (scene_.spline) { // reads before the cell: lanes that are done stand in the first one
                q = {hn::IfThenElseZero(alive_, q.x), hn::IfThenElseZero(alive_, q.y), hn::IfThenElseZero(alive_, q.z)};
                located = hn::FirstN(kF, hn::Lanes(kF));
            }
            const Place place = field_.locate(q, located);
            const Floats found = hn::MulAdd(field_.value(place), splat(scene_.tableScale), splat(scene_.tableBias));
            Floats entry = hn::IfThenElseZero(alive_, found); // the others may hold anything
            if (scene_.spline) {
                entry = hn::Min(hn::Max(entry, splat(0)), splat(scene_.lastEntry));
            }
            samples_ = hn::Sub(samples_, hn::BitCast(kI, hn::VecFromMask(kF, alive_)));
            k_ = hn::Add(k_, splat(1));
            if (!hn::AllFalse(kF, hn::And(inRange(entry, entry), alive_))) {
                look({place, q, entry, part.length}, edge);
            }
            alive_ = hn::And(alive_, hn::Lt(k_, end_));
            if (hn::AllFalse(kF, alive_)) {
                return;
            }
        }
    }

    /// The same with slabs: from each sample's front to its back.
    HWY_INLINE void burstOfSlabs(bool edge) {
        Floats front = entryAt(edge ? hn::Max(k_, ray_->first) : k_);
        for (int i = 0; i < kBurst; ++i) {
            Segment part = {k_, splat(1)};
            Floats end = hn::Add(k_, splat(1));
            if (edge) {
                part = segment();
                end = hn::Min(end, ray_->end);
            }
            const Floats back = entryAt(end);
            samples_ = hn::Sub(samples_, hn::BitCast(kI, hn::VecFromMask(kF, alive_)));
            k_ = hn::Add(k_, splat(1));
            if (!hn::AllFalse(kF, hn::And(inRange(hn::Min(front, back), hn::Max(front, back)), alive_))) {
                lookAtSlab(part, {front, back});
            }
            front = back;
            alive_ = hn::And(alive_, hn::Lt(k_, end_));
            if (hn::AllFalse(kF, alive_)) {
                return;
            }
        }
    }

    /// Whether anything may show from one entry to another.
    HWY_INLINE Mask inRange(Floats low, Floats high) const {
        const Mask within = hn::And(hn::Gt(high, splat(scene_.visibleFrom)), hn::Lt(low, splat(scene_.visibleTo)));
        return hn::And(within, hn::Or(hn::Lt(low, splat(scene_.gapFrom)), hn::Gt(high, splat(scene_.gapTo))));
    }

    /// Of the scene's table, `s` steps along the rays; the first entry for lanes that are done.
    HWY_INLINE Floats entryAt(Floats s) const {
        const Vec3 found = position(s);
        const Vec3 q = {hn::IfThenElseZero(alive_, found.x), hn::IfThenElseZero(alive_, found.y),
                        hn::IfThenElseZero(alive_, found.z)};
        const Floats value = field_.value(field_.locate(q, hn::FirstN(kF, hn::Lanes(kF))));
        const Floats entry = hn::MulAdd(value, splat(scene_.tableScale), splat(scene_.tableBias));
        return hn::IfThenElseZero(alive_, hn::Min(hn::Max(entry, splat(0)), splat(scene_.lastEntry)));
    }

    HWY_INLINE void lookAtSlab(const Segment& part, const SlabEnds& ends) {
        const Floats all = opacityOfSlabs(scene_, ends, part.length, [](int, Floats, Floats) {});
        const Floats opacity = hn::IfThenElseZero(alive_, all);
        const Mask shows = hn::Gt(opacity, splat(0));
        if (hn::AllFalse(kF, shows)) {
            return;
        }
        counts_.shaded += hn::CountTrue(kF, shows);
        const Floats covered = hn::Add(alpha_, hn::NegMulAdd(opacity, alpha_, opacity));
        const Floats weight = hn::Sub(covered, alpha_); // as for samples at a point
        alpha_ = covered;
        // Where the slab begins, on or off the outermost voxels: its place in the slab is counted from there.
        const Vec3 front = {hn::MulAdd(ray_->step.x, part.begin, ray_->start.x),
                            hn::MulAdd(ray_->step.y, part.begin, ray_->start.y),
                            hn::MulAdd(ray_->step.z, part.begin, ray_->start.z)};
        queue_.push({nullptr, front, ends.front, weight, part.length, pixel_, ray_->view, ends.back}, shows);
        alive_ = hn::And(alive_, hn::Lt(alpha_, splat(scene_.opaque)));
    }

    struct Sample {
        const Place& place;
        const Vec3& q;
        Floats entry; ///< of the transfer tables
        Floats part;  ///< share of a step that the sample stands for
    };

    /// Looks a sample up, and hands it on where it can be seen.
    HWY_INLINE void look(const Sample& sample, bool edge) {
        // Rounding puts the data's lowest value up to a thousandth of an entry before the table's begin: opacities
        // would be extrapolated past 1.
        const Floats entry = hn::Max(sample.entry, splat(0));
        const TablePlace at(entry);
        const Floats visible = hn::IfThenElseZero(alive_, at.read(scene_.visibility));
        const Mask shows = hn::Gt(visible, splat(0));
        if (hn::AllFalse(kF, shows)) {
            return;
        }
        counts_.shaded += hn::CountTrue(kF, shows);
        if (earlyOpacity_) {
            Floats opacity = visible;
            if (scene_.layerCount > 1) {
                const Floats all = opacityOfLayers<VoxelField>(scene_, entry, sample.part, [](int, Floats) {});
                opacity = hn::IfThenElseZero(shows, all);
            } else if (edge) {
                const StepOpacity step = {scene_.visibility, scene_.layers[0].opacity, scene_.stepRatio};
                opacity = hn::IfThenElseZero(shows, step.read(at, sample.part));
            }
            const Floats covered = hn::Add(alpha_, hn::NegMulAdd(opacity, alpha_, opacity));
            // What the opacity took in: near 1 it stands still, and thousands of colours would go on adding up.
            const Floats weight = hn::Sub(covered, alpha_);
            alpha_ = covered;
            queue_.push({&sample.place, sample.q, entry, weight, sample.part, pixel_, ray_->view, entry}, shows);
            alive_ = hn::And(alive_, hn::Lt(alpha_, splat(scene_.opaque)));
        } else if (queue_.push({&sample.place, sample.q, entry, splat(0), sample.part, pixel_, ray_->view, entry},
                               shows)) {
            endOpaque();
        }
    }

    /// Ends the rays whose pixels are done by now. Samples that went ahead of that are not composed.
    HWY_NOINLINE void endOpaque() {
        const LaneInts pixel(pixel_);
        LaneFloats done;
        for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
            done.at[lane] = queue_.done(pixel.at[lane]) ? 1.0F : 0.0F;
        }
        alive_ = hn::And(alive_, hn::Lt(hn::Load(kF, done.at), splat(1)));
    }

    const KernelScene& scene_;
    bool earlyOpacity_;
    VoxelField field_;
    ShadeQueue<VoxelField> queue_;
    KernelCounts counts_;
    const RayPacket* ray_ = nullptr;
    Ints pixel_{};
    Ints samples_ = hn::Zero(kI);
    Floats k_{}, end_{}, alpha_{};
    Mask alive_{};
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

/// A block's rays in tiles of kTile x kTile, whose packets march together, kStride samples at a time: what one packet
/// has brought into the first-level cache the others find there.
template <typename Voxel, typename Offset>
class BlockCaster {
    using Marching = March<Voxel, Offset>;
    static constexpr int kTile = 8;
    static constexpr int kStride = 16;
    static constexpr int kMostPackets = kTile * kTile; ///< with packets of one ray

  public:
    BlockCaster(const KernelScene& scene, const KernelBlock& block, float* rgba)
        : block_(block), rays_(scene, block), march_(scene, block, rgba) {}

    void run() {
        for (int y = 0; y < block_.height; y += kTile) {
            for (int x = 0; x < block_.width; x += kTile) {
                castTile(x, y);
            }
        }
        march_.finish();
    }

    [[nodiscard]] KernelCounts counts() const { return march_.counts(); }
    [[nodiscard]] float alpha(int pixel) const { return alpha_[pixel]; }

  private:
    void castTile(int left, int top) {
        const PacketShape shape = packetShape();
        int packets = 0;
        for (int y = top; y < top + kTile && y < block_.height; y += shape.height) {
            for (int x = left; x < left + kTile && x < block_.width; x += shape.width) {
                packets += begin(shape, x, y, packets_[packets]) ? 1 : 0;
            }
        }
        bool more = packets > 0;
        for (int until = kStride; more; until += kStride) {
            more = false;
            for (int i = 0; i < packets; ++i) {
                more = march_.advance(packets_[i], splat(static_cast<float>(until))) || more;
            }
        }
        alignas(64) std::int32_t pixel[kMaxLanes];
        alignas(64) float opacity[kMaxLanes];
        for (int i = 0; i < packets; ++i) {
            hn::Store(packets_[i].pixel, kI, pixel);
            hn::Store(packets_[i].alpha, kF, opacity);
            for (int lane = 0; lane < shape.width * shape.height; ++lane) {
                alpha_[pixel[lane]] = opacity[lane];
            }
        }
    }

    /// False: the rays of this packet miss the volume.
    bool begin(PacketShape shape, int x, int y, typename Marching::Traveller& packet) {
        alignas(64) float dx[kMaxLanes];
        alignas(64) float dy[kMaxLanes];
        alignas(64) std::int32_t pixel[kMaxLanes];
        for (int lane = 0; lane < shape.width * shape.height; ++lane) {
            const int column = x + lane % shape.width;
            const int row = y + lane / shape.width;
            dx[lane] = static_cast<float>(column) + 0.5F - 0.5F * KernelBlock::kSize;
            dy[lane] = static_cast<float>(row) + 0.5F - 0.5F * KernelBlock::kSize;
            pixel[lane] = row * KernelBlock::kSize + column;
        }
        const RayPacket rays = rays_.packet(hn::Load(kF, dx), hn::Load(kF, dy));
        if (hn::AllFalse(kF, rays.hit)) {
            return false; // the picture starts out clear
        }
        march_.begin(packet, rays, hn::Load(kI, pixel));
        return true;
    }

    const KernelBlock& block_;
    RayBlock rays_;
    Marching march_;
    typename Marching::Traveller packets_[kMostPackets];
    // The queue adds colours late; opacities that are known early wait beside them.
    alignas(64) float alpha_[KernelBlock::kSize * KernelBlock::kSize] = {};
};

template <typename Voxel, typename Offset>
void castRays(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts) {
    BlockCaster<Voxel, Offset> caster(scene, block, rgba);
    caster.run();
    const bool earlyOpacity = ShadeQueue<Field<Voxel, Offset>>::weighsAtOnce(scene, block);
    for (int i = 0; earlyOpacity && i < KernelBlock::kSize * KernelBlock::kSize; ++i) {
        rgba[4 * i + 3] = caster.alpha(i);
    }
    counts = caster.counts();
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
