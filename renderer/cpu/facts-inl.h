// What layers read at a sample: normal, curvature, labels; compiled once for every instruction set.
#if defined(LIMNER_FACTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_FACTS_INL_H
#undef LIMNER_FACTS_INL_H
#else
#define LIMNER_FACTS_INL_H
#endif

#include "renderer/cpu/field-inl.h"
#include "renderer/cpu/optics_lanes-inl.h"

#include "core/optics/contour.h"
#include "core/optics/layers.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// The unit normal in eye space, out of dense matter, and how far it can be trusted.
struct Normal {
    Vec3 eye;
    Floats facing;    ///< normal . view
    Floats magnitude; ///< of the gradient, stored units per mm
};

HWY_INLINE Vec3 turned(const float (&rows)[3][3], const Vec3& v) {
    const auto component = [&](const float* row) HWY_ATTR {
        return hn::MulAdd(v.x, splat(row[0]), hn::MulAdd(v.y, splat(row[1]), hn::Mul(v.z, splat(row[2]))));
    };
    return {component(rows[0]), component(rows[1]), component(rows[2])};
}

/// v times the rows: the transposed matrix.
HWY_INLINE Vec3 turnedBack(const float (&rows)[3][3], const Vec3& v) {
    const auto component = [&](int column) HWY_ATTR {
        return hn::MulAdd(v.x, splat(rows[0][column]),
                          hn::MulAdd(v.y, splat(rows[1][column]), hn::Mul(v.z, splat(rows[2][column]))));
    };
    return {component(0), component(1), component(2)};
}

/// Of a gradient in eye space.
HWY_INLINE Normal normalOf(const Vec3& eye, const Vec3& view) {
    Normal normal;
    normal.magnitude = hn::Sqrt(dot(eye, eye));
    // Where the gradient is zero the normal is too; 1e-18 only keeps the division defined.
    const Floats inverse = hn::Div(splat(-1.0F), hn::Max(normal.magnitude, splat(1e-18F)));
    normal.eye = {hn::Mul(eye.x, inverse), hn::Mul(eye.y, inverse), hn::Mul(eye.z, inverse)};
    normal.facing = dot(normal.eye, view);
    return normal;
}

template <typename Field>
HWY_INLINE Normal normalAt(const Field& field, const typename Field::Place& place, const Vec3& q, const Vec3& view) {
    return normalOf(turned(field.scene.eyeFromGradient, field.gradient(place, q)), view);
}

/// How far a normal is trusted: 0 at the gradient floor, 1 from twice of it on (numerics 2a).
HWY_INLINE Floats trust(const KernelScene& scene, Floats magnitude) {
    const Floats floor = splat(scene.gradientFloor);
    const Floats t =
        hn::Min(hn::Max(hn::Div(hn::Sub(magnitude, floor), hn::Max(floor, splat(1e-30F))), splat(0)), splat(1));
    return hn::Mul(hn::Mul(t, t), hn::NegMulAdd(splat(2), t, splat(3)));
}

/// Label slots around a sample, merged, with their trilinear weights.
struct Members {
    static constexpr int kMost = 8;
    int most = 0; ///< of any lane
    float weight[kMost][kMaxLanes];
    std::uint8_t slot[kMost][kMaxLanes];
};

template <typename Offset>
HWY_NOINLINE void findMembers(const std::uint8_t* labels, const CellPlace<Offset>& place, Offsets<Offset> at,
                              Members& members) {
    alignas(64) float f[3][kMaxLanes];
    hn::Store(place.fx, kF, f[0]);
    hn::Store(place.fy, kF, f[1]);
    hn::Store(place.fz, kF, f[2]);
    std::memset(members.weight, 0, sizeof(members.weight));
    std::memset(members.slot, 0, sizeof(members.slot));
    members.most = 1;
    for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
        int count = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const int step[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
            const std::uint8_t slot = labels[static_cast<std::int64_t>(at.at[lane]) + step[0] +
                                             step[1] * BrickLayout::kRow + step[2] * BrickLayout::kSlice];
            float weight = 1;
            for (int axis = 0; axis < 3; ++axis) {
                weight *= step[axis] == 1 ? f[axis][lane] : 1 - f[axis][lane];
            }
            int k = 0;
            while (k < count && members.slot[k][lane] != slot) {
                ++k;
            }
            count = k == count ? count + 1 : count;
            members.slot[k][lane] = slot;
            members.weight[k][lane] += weight;
        }
        members.most = count > members.most ? count : members.most;
    }
}

/// Lanes in the face of a cut: how far, and the colour of the face.
struct FaceLanes {
    Floats share, r, g, b;
};

template <typename VoxelField>
struct Facts {
    using Place = typename VoxelField::Place;

    const VoxelField& field;
    const Place& place;
    Members& members; ///< room for what `measure` finds
    Vec3 q;           ///< position, in cells
    Vec3 view;        ///< unit, eye space, towards the viewer
    Floats tableEntry;
    Floats part;            ///< share of a step that the sample stands for
    Normal normal;          ///< where some layer reads it; so are all that follow
    Floats trusted;         ///< 0: the normal means nothing, 1: it is sound
    Floats bend;            ///< curvature along the view by the Hessian, 1/mm
    bool moved = false;     ///< the surface is a cut's or blurred, no longer the field's own
    Floats flat = splat(0); ///< share of a cut's face
    int faceCount = 0;
    FaceLanes faces[2]; ///< of the figure's cuts and the layer's, where they have a colour

    /// What `measure` does not fill in stays as it is: clearing half a thousand bytes for every vector of samples costs
    /// a picture 6 % of its time.
    HWY_INLINE Facts(const VoxelField& voxels, const Place& at, Members& room, const Vec3& position, const Vec3& viewer,
                     Floats entry, Floats share)
        : field(voxels), place(at), members(room), q(position), view(viewer), tableEntry(entry), part(share) {}

    /// Measures what the scene's layers read, and nothing else.
    HWY_INLINE void measure() {
        const KernelScene& scene = field.scene;
        if (scene.readsNormal) {
            normal = normalAt(field, place, q, view);
        }
        if (scene.readsGradientScale) {
            trusted = trust(scene, normal.magnitude);
            if (scene.readsBend) {
                bend = gated(trusted, bendAlongView());
            }
        }
        if (scene.labels != nullptr) {
            findMembers(scene.labels, place, place.template offsetsIn<1, VoxelField::kBytes>(), members);
        }
        if (scene.faces != nullptr) {
            layOntoFace(*scene.faces);
        }
    }

    /// Where lanes lie in the face of a cut, their surface is the cut's.
    HWY_NOINLINE void layOntoFace(const KernelCut& cut) {
        Floats inside = splat(1e30F);
        Vec3 plane = {splat(0), splat(0), splat(0)};
        FaceLanes face = {splat(0), splat(0), splat(0), splat(0)};
        for (int i = 0; i < cut.count; ++i) {
            const KernelCut::Plane& p = cut.planes[i];
            const Floats here = linear(p.insideFromCell);
            const Mask nearer = hn::Lt(here, inside);
            inside = hn::Min(here, inside);
            const auto pick = [&](Floats& v, float other) HWY_ATTR { v = hn::IfThenElse(nearer, splat(other), v); };
            pick(plane.x, p.normalEye[0]);
            pick(plane.y, p.normalEye[1]);
            pick(plane.z, p.normalEye[2]);
            pick(face.r, p.rgb[0]);
            pick(face.g, p.rgb[1]);
            pick(face.b, p.rgb[2]);
        }
        face.share = optics::cutFaceShare(Lanes{hn::Mul(inside, splat(cut.perVoxel))}).v;
        if (hn::AllFalse(kF, hn::Gt(face.share, splat(0)))) {
            return;
        }
        if (field.scene.readsNormal) {
            turnTo(plane, face.share);
        }
        if (cut.coloured) {
            faces[faceCount++] = face;
        }
    }

    /// Moves value and surface to the blur of the layer's depth of field.
    HWY_NOINLINE void blur(const KernelLayer& layer) {
        const KernelScene& scene = field.scene;
        const Floats depthPlace = hn::Min(hn::Max(linear(layer.depthFromCell), splat(0)), splat(1));
        const Floats level = optics::blurLevel(Lanes{depthPlace}, Lanes{layer.focus}, Lanes{layer.focusStrength}).v;
        const auto weightOf = [&](int k) HWY_ATTR {
            return hn::Max(hn::Sub(splat(1), hn::Abs(hn::Sub(level, splat(static_cast<float>(k))))), splat(0));
        };
        const Floats sharp = weightOf(0);
        Floats entry = hn::Mul(sharp, tableEntry);
        const Normal sharpNormal = moved ? normalAt(field, place, q, view) : normal; // not a cut's
        const Floats own = hn::Neg(hn::Mul(sharp, sharpNormal.magnitude));
        Vec3 g = {hn::Mul(own, sharpNormal.eye.x), hn::Mul(own, sharpNormal.eye.y), hn::Mul(own, sharpNormal.eye.z)};
        for (int k = 1; k <= optics::kBlurLevels; ++k) {
            const KernelBlur& copy = scene.blurs[k - 1];
            const Floats weight = weightOf(k);
            Vec3 slope;
            const Floats value = cellOf(copy.bricks, slope);
            entry = hn::MulAdd(weight, hn::MulAdd(value, splat(copy.entryScale), splat(copy.entryBias)), entry);
            const auto sound = [](Floats s) HWY_ATTR { return optics::slopeOfCopy(Lanes{s}).v; };
            const Vec3 eye = turned(copy.eyeFromSlope, {sound(slope.x), sound(slope.y), sound(slope.z)});
            g = {hn::MulAdd(weight, eye.x, g.x), hn::MulAdd(weight, eye.y, g.y), hn::MulAdd(weight, eye.z, g.z)};
        }
        tableEntry = hn::Min(hn::Max(entry, splat(0)), splat(scene.lastEntry));
        if (scene.readsNormal) {
            moved = true;
            normal = normalOf(g, view);
            trusted = trust(scene, normal.magnitude);
        }
    }

    /// Of the gradient, over the one that counts as 1.
    HWY_INLINE Floats unitMagnitude() const {
        return hn::Min(hn::Mul(normal.magnitude, splat(field.scene.perGradientMax)), splat(1));
    }

    /// Distance along the view over the target's.
    HWY_INLINE Floats depth() const { return linear(field.scene.depthFromCell); }

    /// A number that is linear in the position.
    HWY_INLINE Floats linear(const float (&fromCell)[4]) const {
        return hn::Add(dot(q, {splat(fromCell[0]), splat(fromCell[1]), splat(fromCell[2])}), splat(fromCell[3]));
    }

    /// Curvature along the view by two normals on the ray, `probe` mm apart, 1/mm; 0 where one of them means nothing.
    HWY_NOINLINE Floats turn(Floats probe) const {
        const KernelScene& scene = field.scene;
        const Vec3 step = turned(scene.cellFromEye, view);
        const auto ahead = [&](Floats from, Floats by, int axis) HWY_ATTR {
            const Floats to = hn::MulAdd(by, probe, from);
            return hn::Min(hn::Max(to, splat(0)), splat(scene.lastCell[axis]));
        };
        const Vec3 before = {ahead(q.x, step.x, 0), ahead(q.y, step.y, 1), ahead(q.z, step.z, 2)};
        const Place there = field.locate(before, hn::FirstN(kF, hn::Lanes(kF)));
        const Normal other = normalAt(field, there, before, view);
        const Normal here = moved ? normalAt(field, place, q, view) : normal;
        const Floats sound = moved ? trust(scene, here.magnitude) : trusted;
        const auto lanes = [](const Vec3& v) HWY_ATTR {
            return optics::Vector3<Lanes>{Lanes{v.x}, Lanes{v.y}, Lanes{v.z}};
        };
        const Lanes curvature = optics::curvatureOfNormals(lanes(other.eye), lanes(here.eye), Lanes{probe});
        const Floats both = hn::Mul(sound, trust(scene, other.magnitude));
        return hn::Mul(gated(both, curvature.v), hn::Sub(splat(1), flat));
    }

    /// Trilinear number of an int16 store laid out as the voxels, as it is kept.
    HWY_NOINLINE Floats other(const std::uint8_t* bricks) const {
        const auto offsets = place.template offsetsIn<2, VoxelField::kBytes>();
        const Ints weight = pairWeights(place.fx);
        const auto row = [&](int y, int z) HWY_ATTR {
            const int shift = (y * BrickLayout::kRow + z * BrickLayout::kSlice) * 2;
            return toFloat(VoxelField::blend(gatherWords(bricks + shift, offsets), weight));
        };
        const Floats low = lerp(row(0, 0), row(1, 0), place.fy);
        const Floats high = lerp(row(0, 1), row(1, 1), place.fy);
        return hn::Mul(lerp(low, high, place.fz), splat(1.0F / 32767.0F));
    }

  private:
    /// Turns the normal towards a cut's.
    HWY_INLINE void turnTo(const Vec3& plane, Floats share) {
        const Floats own = hn::Mul(trusted, hn::Sub(splat(1), share));
        const auto mixed = [&](Floats n, Floats p) HWY_ATTR { return hn::MulAdd(own, n, hn::Mul(share, p)); };
        const Vec3 n = {mixed(normal.eye.x, plane.x), mixed(normal.eye.y, plane.y), mixed(normal.eye.z, plane.z)};
        const Floats length = hn::Sqrt(dot(n, n));
        const Mask usable = hn::Gt(length, splat(1e-6F));
        const Floats inverse = hn::Div(splat(1), hn::IfThenElse(usable, length, splat(1)));
        const Mask on = hn::Gt(share, splat(0));
        const auto turn = [&](Floats before, Floats v, Floats p) HWY_ATTR {
            return hn::IfThenElse(on, hn::IfThenElse(usable, hn::Mul(v, inverse), p), before);
        };
        normal.eye = {turn(normal.eye.x, n.x, plane.x), turn(normal.eye.y, n.y, plane.y),
                      turn(normal.eye.z, n.z, plane.z)};
        normal.facing = dot(normal.eye, view);
        trusted = lerp(trusted, splat(1), share);
        if (field.scene.readsBend) {
            bend = hn::Mul(bend, hn::Sub(splat(1), share));
        }
        flat = hn::Max(flat, share);
        moved = true;
    }

    /// Trilinear number of an int16 store laid out as the voxels, and its slope per cell; as they are kept.
    HWY_INLINE Floats cellOf(const std::uint8_t* bricks, Vec3& slope) const {
        const auto offsets = place.template offsetsIn<2, VoxelField::kBytes>();
        Floats low[4], high[4]; // ends of the four edges along x, y fastest
        for (int i = 0; i < 4; ++i) {
            const int shift = ((i & 1) * BrickLayout::kRow + (i >> 1) * BrickLayout::kSlice) * 2;
            const Ints words = gatherWords(bricks + shift, offsets);
            low[i] = toFloat(hn::ShiftRight<16>(hn::ShiftLeft<16>(words)));
            high[i] = toFloat(hn::ShiftRight<16>(words));
        }
        const auto across = [&](const Floats(&v)[4]) HWY_ATTR {
            return lerp(lerp(v[0], v[1], place.fy), lerp(v[2], v[3], place.fy), place.fz);
        };
        const Floats a = across(low);
        const Floats b = across(high);
        slope.x = hn::Sub(b, a);
        Floats edge[4];
        for (int i = 0; i < 4; ++i) {
            edge[i] = lerp(low[i], high[i], place.fx);
        }
        slope.y = lerp(hn::Sub(edge[1], edge[0]), hn::Sub(edge[3], edge[2]), place.fz);
        slope.z = lerp(hn::Sub(edge[2], edge[0]), hn::Sub(edge[3], edge[1]), place.fy);
        return lerp(a, b, place.fx);
    }

    /// What is not trusted is 0, whatever it is.
    static HWY_INLINE Floats gated(Floats trust, Floats v) {
        return hn::IfThenElseZero(hn::Gt(trust, splat(0)), hn::Mul(trust, v));
    }

    /// core/optics/contour.h, curvatureAlongView; gradient and tangent plane of the bend field itself.
    HWY_NOINLINE Floats bendAlongView() const {
        const KernelScene& scene = field.scene;
        const BendSums h = field.bends(place);
        const Vec3 g = turned(scene.eyeFromBend, {h.x, h.y, h.z});
        const Floats squared = dot(g, g);
        const Floats along = hn::Div(dot(g, view), hn::Max(squared, splat(1e-36F)));
        const Vec3 tangent = {hn::NegMulAdd(along, g.x, view.x), hn::NegMulAdd(along, g.y, view.y),
                              hn::NegMulAdd(along, g.z, view.z)};
        const Vec3 u = turnedBack(scene.eyeFromBend, tangent);
        const optics::Hessian<Lanes> hessian = {Lanes{h.xx}, Lanes{h.yy}, Lanes{h.zz},
                                                Lanes{h.xy}, Lanes{h.xz}, Lanes{h.yz}};
        const Lanes second = optics::quadraticForm(hessian, optics::Vector3<Lanes>{Lanes{u.x}, Lanes{u.y}, Lanes{u.z}});
        return optics::curvatureAlongView(second, Lanes{dot(tangent, tangent)}, Lanes{hn::Sqrt(squared)}).v;
    }
};

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
