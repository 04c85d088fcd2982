// A layer's parts beside its transfer function; compiled once for every instruction set.
#if defined(LIMNER_PARTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_PARTS_INL_H
#undef LIMNER_PARTS_INL_H
#else
#define LIMNER_PARTS_INL_H
#endif

#include "renderer/cpu/facts-inl.h" // names the target: before the formulas
#include "renderer/cpu/style-inl.h"

#include "core/optics/layers.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// Share of a sample's length that a cut leaves, by the plane that leaves least.
template <typename Field>
HWY_NOINLINE Floats keptByCut(const KernelCut& cut, const KernelScene& scene, const Facts<Field>& facts) {
    const Floats lengthMm = hn::Mul(facts.part, splat(static_cast<float>(scene.stepMm)));
    Floats kept = splat(1);
    for (int i = 0; i < cut.count; ++i) {
        const KernelCut::Plane& plane = cut.planes[i];
        const Vec3 normal = {splat(plane.normalEye[0]), splat(plane.normalEye[1]), splat(plane.normalEye[2])};
        const Floats reach = hn::Mul(hn::Abs(dot(normal, facts.view)), lengthMm);
        kept = hn::Min(kept, optics::keptByPlane(Lanes{facts.linear(plane.insideFromCell)}, Lanes{reach}).v);
    }
    return kept;
}

template <typename Field>
class LayerParts {
  public:
    HWY_INLINE LayerParts(const KernelLayer& layer, const Facts<Field>& facts)
        : layer_(layer), parts_(layer.parts), facts_(facts) {}

    /// Changes colours, and gives the opacity of the reference length with the parts.
    HWY_NOINLINE Floats apply(Floats opacity, LaneColours& out) const {
        layFaces(out);
        if (!parts_.any) {
            return opacity;
        }
        if (parts_.tone != nullptr) {
            const EntryLanes at(entryOf(optics::tonePlace(Lanes{toLight()}, Lanes{facts_.trusted}).v));
            each(out, [&](Quad c, std::size_t lane) HWY_ATTR { return hn::Mul(c, colourAt(parts_.tone, at, lane)); });
        }
        LaneColours tint;
        Floats fade = splat(1);
        if (parts_.position != nullptr) {
            fade = tintOfPosition(tint);
        }
        const Floats lineMap = curve(parts_.lineOpacity);
        const Floats shading = hn::Min(hn::Mul(hn::Mul(opacity, curve(parts_.gradientOpacity)), fade), splat(1));
        Floats all = shading;
        if (parts_.silhouetteOpacity > 0) {
            all = drawLine(shading, hn::Mul(hn::Mul(opacity, lineMap), fade), out);
        }
        if (parts_.specularStrength > 0) {
            const LaneFloats gloss(hn::Mul(lineMap, highlight()));
            each(out, [&](Quad c, std::size_t lane) HWY_ATTR { return hn::Add(c, hn::Set(kQuad, gloss.at[lane])); });
        }
        if (parts_.position != nullptr) {
            each(out,
                 [&](Quad c, std::size_t lane) HWY_ATTR { return hn::Mul(c, hn::Load(kQuad, tint.rgba + 4 * lane)); });
        }
        each(out, [](Quad c, std::size_t) HWY_ATTR { return hn::Min(c, hn::Set(kQuad, 1.0F)); });
        return all;
    }

  private:
    template <typename Change>
    static HWY_INLINE void each(LaneColours& out, const Change& change) {
        for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
            hn::Store(change(hn::Load(kQuad, out.rgba + 4 * lane), lane), kQuad, out.rgba + 4 * lane);
        }
    }

    HWY_INLINE Floats entryOf(Floats place) const {
        const Floats inside = hn::Min(hn::Max(place, splat(0)), splat(1));
        return hn::Mul(inside, splat(parts_.lastEntry));
    }

    static HWY_INLINE Quad colourAt(const float* table, const EntryLanes& at, std::size_t lane) {
        return entryColour(table, at.entry.at[lane], at.fraction.at[lane]);
    }

    HWY_INLINE void layFaces(LaneColours& out) const {
        for (int i = 0; i < facts_.faceCount; ++i) {
            const FaceLanes& face = facts_.faces[i];
            LaneColours rgb;
            hn::StoreInterleaved4(face.r, face.g, face.b, splat(1), kF, rgb.rgba);
            const LaneFloats share(face.share);
            each(out, [&](Quad c, std::size_t lane) HWY_ATTR {
                const Quad flat = hn::Load(kQuad, rgb.rgba + 4 * lane);
                return hn::MulAdd(hn::Sub(flat, c), hn::Set(kQuad, share.at[lane]), c);
            });
        }
    }

    /// Turned to the viewer where both sides are drawn alike.
    HWY_INLINE Floats towards(Floats v) const {
        return layer_.twoSided ? hn::IfThenElse(hn::Lt(facts_.normal.facing, splat(0)), hn::Neg(v), v) : v;
    }

    HWY_INLINE Floats toLight() const {
        return towards(
            dot(facts_.normal.eye, {splat(parts_.light[0]), splat(parts_.light[1]), splat(parts_.light[2])}));
    }

    HWY_INLINE Floats curve(const float* table) const {
        return table != nullptr ? TablePlace(entryOf(facts_.unitMagnitude())).read(table) : splat(1);
    }

    /// Colours of the place, and their opacity factors.
    HWY_INLINE Floats tintOfPosition(LaneColours& tint) const {
        const EntryLanes at(entryOf(facts_.linear(parts_.placeFromCell)));
        for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
            hn::Store(colourAt(parts_.position, at, lane), kQuad, tint.rgba + 4 * lane);
        }
        Floats r, g, b, a;
        hn::LoadInterleaved4(kF, tint.rgba, r, g, b, a);
        return a;
    }

    HWY_INLINE Floats drawLine(Floats shading, Floats opacity, LaneColours& out) const {
        const Lanes outline = optics::silhouetteShare(Lanes{facts_.normal.facing}, Lanes{parts_.silhouetteFull},
                                                      Lanes{parts_.silhouetteNone}, Lanes{facts_.trusted});
        const Floats line = hn::Min(hn::Mul(hn::Mul(opacity, splat(parts_.silhouetteOpacity)), outline.v), splat(1));
        const LaneFloats share(optics::lineShare(Lanes{shading}, Lanes{line}).v);
        const Quad ink = hn::LoadU(kQuad, parts_.silhouetteRgb);
        each(out, [&](Quad c, std::size_t lane)
                      HWY_ATTR { return hn::MulAdd(hn::Sub(ink, c), hn::Set(kQuad, share.at[lane]), c); });
        return optics::withLine(Lanes{shading}, Lanes{line}).v;
    }

    HWY_INLINE Floats highlight() const {
        const Vec3& v = facts_.view;
        Floats normalToLight = hn::Abs(facts_.normal.facing);
        Floats lightToViewer = splat(1);
        if (parts_.ownLight) {
            normalToLight = toLight();
            lightToViewer = dot(v, {splat(parts_.light[0]), splat(parts_.light[1]), splat(parts_.light[2])});
        } else if (!layer_.twoSided) {
            normalToLight = facts_.normal.facing;
        }
        const Lanes half =
            optics::halfway(Lanes{normalToLight}, Lanes{towards(facts_.normal.facing)}, Lanes{lightToViewer});
        const Floats shine = optics::powc(half, Lanes{parts_.specularExponent}).v;
        return hn::Mul(hn::Mul(shine, facts_.trusted), splat(parts_.specularStrength));
    }

    const KernelLayer& layer_;
    const KernelParts& parts_;
    const Facts<Field>& facts_;
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
