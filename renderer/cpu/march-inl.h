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
    static constexpr int kBurst = 4; ///< steps between two looks at the skip grid: 4 to 8 measured best

  public:
    March(const KernelScene& scene, float* rgba) : scene_(scene), field_{scene}, queue_(scene, rgba), rgba_(rgba) {}

    HWY_INLINE void run(const RayPacket& ray, Ints pixel) {
        ray_ = &ray;
        pixel_ = pixel;
        alpha_ = splat(0);
        k_ = hn::Floor(ray.first);
        end_ = hn::Ceil(ray.end);
        alive_ = hn::And(ray.hit, hn::Lt(k_, end_));
        while (!hn::AllFalse(kF, alive_) && skipEmpty()) {
            const Mask edge =
                hn::And(alive_, hn::Or(hn::Lt(k_, ray.first), hn::Gt(hn::Add(k_, splat(kBurst)), ray.end)));
            burst(!hn::AllFalse(kF, edge));
        }
    }

    /// The packet's opacities; known here with one opacity only, else they are the picture's.
    [[nodiscard]] HWY_INLINE Floats alpha() const { return alpha_; }
    /// Shades what still waits; after the last packet of a block.
    HWY_INLINE void finish() { queue_.finish(); }
    [[nodiscard]] HWY_INLINE KernelCounts counts() const {
        return {static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(kI, samples_))), counts_.shaded};
    }

  private:
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

    /// Moves every lane on to the next sample in a block that can contribute. False: nothing is left.
    HWY_INLINE bool skipEmpty() {
        constexpr int log2 = MinMaxGrid::kLog2BlockCells;
        const Floats phase = splat(scene_.phase);
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
            const Mask empty = hn::And(alive_, hn::RebindMask(kF, hn::Gt(distance, hn::Zero(kI))));
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
            // The first lattice sample past the wall.
            const Floats next = hn::Add(hn::Floor(hn::Sub(hn::Add(s, leave), phase)), splat(1));
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
            const Mask inRange =
                hn::And(hn::Gt(entry, splat(scene_.visibleFrom)), hn::Lt(entry, splat(scene_.visibleTo)));
            if (!hn::AllFalse(kF, hn::And(inRange, alive_))) {
                look({place, q, entry, part.length}, edge);
            }
            alive_ = hn::And(alive_, hn::Lt(k_, end_));
            if (hn::AllFalse(kF, alive_)) {
                return;
            }
        }
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
        if (scene_.oneOpacity) {
            const Floats opacity = edge ? opacityOfPart(visible, sample.part) : visible;
            const Floats weight = hn::NegMulAdd(opacity, alpha_, opacity);
            alpha_ = hn::Add(alpha_, weight);
            queue_.push({sample.place, sample.q, entry, weight, pixel_, ray_->view}, shows);
            alive_ = hn::And(alive_, hn::Lt(alpha_, splat(scene_.opaque)));
        } else if (queue_.push({sample.place, sample.q, entry, sample.part, pixel_, ray_->view}, shows)) {
            endOpaque();
        }
    }

    /// Ends the rays whose pixels are opaque by now. Samples that went ahead of that are not composed.
    HWY_NOINLINE void endOpaque() {
        const LaneInts pixel(pixel_);
        LaneFloats alpha;
        for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
            alpha.at[lane] = rgba_[4 * pixel.at[lane] + 3];
        }
        alive_ = hn::And(alive_, hn::Lt(hn::Load(kF, alpha.at), splat(scene_.opaque)));
    }

    const KernelScene& scene_;
    VoxelField field_;
    ShadeQueue<VoxelField> queue_;
    float* rgba_;
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

template <typename Voxel, typename Offset>
void castRays(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts) {
    const PacketShape shape = packetShape();
    const RayBlock rays(scene, block);
    March<Voxel, Offset> march(scene, rgba);
    alignas(64) float dx[kMaxLanes];
    alignas(64) float dy[kMaxLanes];
    alignas(64) std::int32_t pixel[kMaxLanes];
    alignas(64) float packetAlpha[kMaxLanes];
    // The queue adds colours late; opacities that are known early wait beside them.
    alignas(64) float alpha[KernelBlock::kSize * KernelBlock::kSize] = {};
    const int lanes = shape.width * shape.height;
    for (int y = 0; y < block.height; y += shape.height) {
        for (int x = 0; x < block.width; x += shape.width) {
            for (int lane = 0; lane < lanes; ++lane) {
                const int column = x + lane % shape.width;
                const int row = y + lane / shape.width;
                dx[lane] = static_cast<float>(column) + 0.5F - 0.5F * KernelBlock::kSize;
                dy[lane] = static_cast<float>(row) + 0.5F - 0.5F * KernelBlock::kSize;
                pixel[lane] = row * KernelBlock::kSize + column;
            }
            const RayPacket packet = rays.packet(hn::Load(kF, dx), hn::Load(kF, dy));
            if (hn::AllFalse(kF, packet.hit)) {
                continue; // the picture starts out clear
            }
            march.run(packet, hn::Load(kI, pixel));
            hn::Store(march.alpha(), kF, packetAlpha);
            for (int lane = 0; lane < lanes; ++lane) {
                alpha[pixel[lane]] = packetAlpha[lane];
            }
        }
    }
    march.finish();
    for (int i = 0; scene.oneOpacity && i < KernelBlock::kSize * KernelBlock::kSize; ++i) {
        rgba[4 * i + 3] = alpha[i];
    }
    counts = march.counts();
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
