// Rays of a packet, set up relative to their block in double; compiled once for every instruction set.
#if defined(LIMNER_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_RAYS_INL_H
#undef LIMNER_RAYS_INL_H
#else
#define LIMNER_RAYS_INL_H
#endif

#include "renderer/cpu/kernel.h"
#include "renderer/cpu/lanes-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// Steps along an axis below this are rounding noise of a ray parallel to its faces (numerics 2f).
constexpr float kParallel = 1e-20F;

/// One ray per lane. Position of parameter s (in steps, lattice sample k stands for [k, k+1)): start + s * step.
struct RayPacket {
    Vec3 start;
    Vec3 step;
    Vec3 inverse;      ///< 1 / step, finite
    Vec3 view;         ///< unit, eye space, towards the viewer
    Floats first, end; ///< the visible stretch, in steps; first >= 0
    Mask hit;
};

/// The block's own frame. A float holds an offset of some hundred voxels to 1e-5, but not an eye 10^4 boxes away, so
/// what is common to the block is worked out in double and lanes only add small offsets (numerics 2f, 32k posters).
class RayBlock {
  public:
    RayBlock(const KernelScene& scene, const KernelBlock& block) : scene_(scene) {
        const double cx = block.x + 0.5 * KernelBlock::kSize;
        const double cy = block.y + 0.5 * KernelBlock::kSize;
        double alongSquared = 0;
        double towards = 0;
        for (int i = 0; i < 3; ++i) {
            const double across = cx * scene.right[i] + cy * scene.down[i];
            origin_[i] = scene.origin[i] + (scene.perspective ? 0 : across);
            direction_[i] = scene.forward[i] + (scene.perspective ? across : 0);
            const double centre = 0.5 * (scene.boxLow[i] + scene.boxHigh[i]);
            towards += (centre - origin_[i]) * direction_[i];
            alongSquared += direction_[i] * direction_[i];
        }
        // The block's reference lies where its middle ray passes the box's centre, but never behind the eye.
        nearest_ = towards / alongSquared;
        if (scene.perspective) {
            nearest_ = std::max(nearest_, 0.0);
            eyeX_ = scene.forwardEye[0] + cx * scene.rightEye;
            eyeY_ = scene.forwardEye[1] + cy * scene.downEye;
        }
    }

    /// `dx`, `dy`: sub-pixels from the block's centre.
    HWY_INLINE RayPacket packet(Floats dx, Floats dy) const {
        RayPacket ray;
        if (scene_.perspective) {
            perspective(dx, dy, ray);
        } else {
            orthographic(dx, dy, ray);
        }
        const auto inverse = [](Floats d) HWY_ATTR {
            const Floats tiny = splat(kParallel); // keeps infinities out; enterBox() has an inside test for such rays
            return hn::Div(splat(1), hn::IfThenElse(hn::Lt(hn::Abs(d), tiny), tiny, d));
        };
        ray.inverse = {inverse(ray.step.x), inverse(ray.step.y), inverse(ray.step.z)};
        enterBox(ray);
        for (int i = 0; i < scene_.planeCount; ++i) {
            cut(scene_.planes[i], ray);
        }
        ray.hit = hn::Lt(ray.first, ray.end);
        return ray;
    }

  private:
    HWY_INLINE Floats offset(int axis, double scale, Floats dx, Floats dy) const {
        return hn::MulAdd(dx, splat(static_cast<float>(scene_.right[axis] * scale)),
                          hn::Mul(dy, splat(static_cast<float>(scene_.down[axis] * scale))));
    }
    HWY_INLINE Floats at(int axis) const {
        return splat(static_cast<float>(origin_[axis] + nearest_ * direction_[axis]));
    }

    HWY_INLINE void orthographic(Floats dx, Floats dy, RayPacket& ray) const {
        const double h = scene_.stepMm;
        ray.start = {hn::Add(at(0), offset(0, 1, dx, dy)), hn::Add(at(1), offset(1, 1, dx, dy)),
                     hn::Add(at(2), offset(2, 1, dx, dy))};
        ray.step = {splat(static_cast<float>(direction_[0] * h)), splat(static_cast<float>(direction_[1] * h)),
                    splat(static_cast<float>(direction_[2] * h))};
        ray.view = {splat(0), splat(0), splat(1)};
        ray.first = splat(-1e30F); // no eye: the ray reaches back without end
        ray.end = splat(1e30F);
    }

    HWY_INLINE void perspective(Floats dx, Floats dy, RayPacket& ray) const {
        const Floats ex = hn::MulAdd(dx, splat(static_cast<float>(scene_.rightEye)), splat(static_cast<float>(eyeX_)));
        const Floats ey = hn::MulAdd(dy, splat(static_cast<float>(scene_.downEye)), splat(static_cast<float>(eyeY_)));
        const Floats ez = splat(static_cast<float>(scene_.forwardEye[2]));
        const Floats inverseLength = hn::Div(splat(1), hn::Sqrt(dot({ex, ey, ez}, {ex, ey, ez})));
        const Floats perStep = hn::Mul(splat(static_cast<float>(scene_.stepMm)), inverseLength);
        const auto start = [&](int i) HWY_ATTR { return hn::Add(at(i), offset(i, nearest_, dx, dy)); };
        const auto step = [&](int i) HWY_ATTR {
            return hn::Mul(perStep, hn::Add(splat(static_cast<float>(direction_[i])), offset(i, 1, dx, dy)));
        };
        ray.start = {start(0), start(1), start(2)};
        ray.step = {step(0), step(1), step(2)};
        ray.view = {hn::Mul(hn::Neg(ex), inverseLength), hn::Mul(hn::Neg(ey), inverseLength),
                    hn::Mul(hn::Neg(ez), inverseLength)};
        ray.first = hn::Div(splat(static_cast<float>(-nearest_)), perStep); // the eye
        ray.end = splat(1e30F);
    }

    /// Finds the stretch inside the box and moves the packet's start to its entry, where the lattice begins.
    HWY_INLINE void enterBox(RayPacket& ray) const {
        const auto slab = [&](Floats start, Floats step, Floats inverse, int axis) HWY_ATTR {
            const Floats low = splat(static_cast<float>(scene_.boxLow[axis]));
            const Floats high = splat(static_cast<float>(scene_.boxHigh[axis]));
            const Floats a = hn::Mul(hn::Sub(low, start), inverse);
            const Floats b = hn::Mul(hn::Sub(high, start), inverse);
            // A ray along a face is inside or outside as a whole; a division would cut it in two where it starts.
            const Mask along = hn::Lt(hn::Abs(step), splat(kParallel));
            const Mask inside = hn::And(hn::Ge(start, low), hn::Le(start, high));
            const Floats without = hn::IfThenElse(inside, splat(1e30F), splat(-1e30F));
            ray.first = hn::Max(ray.first, hn::IfThenElse(along, hn::Neg(without), hn::Min(a, b)));
            ray.end = hn::Min(ray.end, hn::IfThenElse(along, without, hn::Max(a, b)));
        };
        slab(ray.start.x, ray.step.x, ray.inverse.x, 0);
        slab(ray.start.y, ray.step.y, ray.inverse.y, 1);
        slab(ray.start.z, ray.step.z, ray.inverse.z, 2);
        const Mask hit = hn::Lt(ray.first, ray.end);
        const Floats entry = hn::IfThenElseZero(hit, ray.first);
        ray.start = {hn::MulAdd(ray.step.x, entry, ray.start.x), hn::MulAdd(ray.step.y, entry, ray.start.y),
                     hn::MulAdd(ray.step.z, entry, ray.start.z)};
        ray.end = hn::IfThenElse(hit, hn::Sub(ray.end, entry), splat(-1));
        ray.first = splat(0);
    }

    HWY_INLINE void cut(const KernelPlane& plane, RayPacket& ray) const {
        const Vec3 normal = {splat(static_cast<float>(plane.normal[0])), splat(static_cast<float>(plane.normal[1])),
                             splat(static_cast<float>(plane.normal[2]))};
        const Floats along = dot(normal, ray.step);
        const Floats rest = hn::Sub(splat(static_cast<float>(plane.offset)), dot(normal, ray.start));
        const Floats tiny = splat(kParallel);
        const Mask leaving = hn::Gt(along, tiny);
        const Mask entering = hn::Lt(along, hn::Neg(tiny));
        const Floats t = hn::Div(rest, hn::IfThenElse(hn::Or(leaving, entering), along, splat(1)));
        ray.end = hn::IfThenElse(leaving, hn::Min(ray.end, t), ray.end);
        ray.first = hn::IfThenElse(entering, hn::Max(ray.first, t), ray.first);
        const Mask outside = hn::AndNot(hn::Or(leaving, entering), hn::Lt(rest, splat(0)));
        ray.end = hn::IfThenElse(outside, splat(-1), ray.end);
    }

    const KernelScene& scene_;
    double origin_[3]{};
    double direction_[3]{};
    double nearest_ = 0;
    double eyeX_ = 0;
    double eyeY_ = 0;
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
