// What a layer makes of a sample: its transfer function, contours, transparency and colour; compiled once for every
// instruction set.
#if defined(LIMNER_LAYER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_LAYER_INL_H
#undef LIMNER_LAYER_INL_H
#else
#define LIMNER_LAYER_INL_H
#endif

#include "renderer/cpu/facts-inl.h" // names the target: before the formulas
#include "renderer/cpu/measures-inl.h"
#include "renderer/cpu/parts-inl.h"
#include "renderer/cpu/style-inl.h"
#include "renderer/cpu/texture-inl.h"

#include "core/optics/contour.h"
#include "core/optics/mip.h"
#include "core/optics/shading.h"
#include "core/optics/transparency.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// Opacity of a length from that of the reference length. Sums of parts, such as labels have, make 1 but for rounding.
HWY_NOINLINE inline Floats opacityOfLength(Floats opacity, Floats ratio) {
    const Floats almost = splat(1.0F - 1e-7F);
    const Floats depth = hn::Mul(ratio, hn::Log1p(kF, hn::Neg(hn::Min(opacity, almost))));
    return hn::IfThenElse(hn::Ge(opacity, almost), splat(1), hn::Neg(hn::Expm1(kF, depth)));
}

/// A layer's opacity by the value.
struct StepOpacity {
    const float* ofStep;
    const float* ofReferenceLength;
    float stepRatio;

    /// Of a step, or of the part of it that a sample stands for. A whole step bit for bit, whoever else is in the
    /// vector; a part by the reference length: a long step's opacity is 1 but for rounding, and tells no depth.
    HWY_INLINE Floats read(const TablePlace& at, Floats part) const {
        const Floats opacity = at.read(ofStep);
        const Mask whole = hn::Ge(part, splat(1));
        return hn::AllTrue(kF, whole) ? opacity : hn::IfThenElse(whole, opacity, readPart(at, part));
    }

  private:
    HWY_NOINLINE Floats readPart(const TablePlace& at, Floats part) const {
        const Floats opacity = at.read(ofReferenceLength);
        const Floats almost = splat(1.0F - 0x1p-24F); // the last number below 1
        const Floats depth = hn::Mul(hn::Mul(splat(stepRatio), part), hn::Log1p(kF, hn::Neg(hn::Min(opacity, almost))));
        const Floats corrected = hn::IfThenElse(hn::Ge(opacity, splat(1)), splat(1), hn::Neg(hn::Expm1(kF, depth)));
        return hn::IfThenElseZero(hn::Gt(part, splat(0)), corrected);
    }
};

/// x^n for x in [0, 1], n > 0; whole exponents by repeated squaring, others by exp and log.
HWY_NOINLINE inline Floats power(Floats x, float n) {
    const auto whole = static_cast<unsigned>(n);
    if (static_cast<float>(whole) != n || whole > 1024) {  // beyond, squaring costs as much as exp and log
        const Floats positive = hn::Max(x, splat(1e-30F)); // log of 0 is not wanted; 1e-30^n is as good as 0
        return hn::IfThenZeroElse(hn::Le(x, splat(0)), hn::Exp(kF, hn::Mul(splat(n), hn::Log(kF, positive))));
    }
    Floats result = splat(1);
    Floats square = x;
    for (unsigned bits = whole; bits != 0; bits >>= 1U) {
        if ((bits & 1U) != 0) {
            result = hn::Mul(result, square);
        }
        square = hn::Mul(square, square);
    }
    return result;
}

/// Evaluates one layer. Choices that hold for a whole figure are plain branches.
template <typename Field>
class LayerEvaluation {
  public:
    LayerEvaluation(const KernelScene& scene, const KernelLayer& layer) : scene_(scene), layer_(layer) {}

    /// Whether the layer's surface is not the field's own.
    [[nodiscard]] HWY_INLINE bool moves() const {
        return layer_.focusStrength > 0 || (layer_.cut != nullptr && layer_.cut->faces);
    }

    /// What such a layer finds at a sample.
    HWY_NOINLINE Facts<Field> moved(const Facts<Field>& facts) const {
        Facts<Field> own = facts;
        if (layer_.focusStrength > 0) {
            own.blur(layer_);
            if (scene_.faces != nullptr) { // blurred is what is inside
                own.faceCount = 0;
                own.layOntoFace(*scene_.faces);
            }
        }
        if (layer_.cut != nullptr && layer_.cut->faces) {
            own.layOntoFace(*layer_.cut);
        }
        return own;
    }

    /// Colour of every lane, and what the sample covers of what is behind; `out`'s alpha is of no use afterwards.
    /// `facts`: the layer's own where it moves.
    HWY_INLINE Floats evaluate(const Facts<Field>& facts, LaneColours& out) const {
        const Floats width = contourWidth(facts);
        if (layer_.opacityByValue) {
            const Floats entry = entryOf(facts.tableEntry);
            const Floats opacity = stepOpacity().read(TablePlace(entry), facts.part);
            if (!hn::AllFalse(kF, hn::Gt(opacity, splat(0)))) {
                colour(facts, width, nodesOfLine(entry), out);
                tint(facts, out);
            }
            return opacity;
        }
        Floats opacity = layer_.rowOfSlot != nullptr ? byLabels(facts, width, out) : row(facts, width, splat(0), out);
        if (layer_.rowOfSlot == nullptr && layer_.shownSlots != nullptr) {
            opacity = hn::Mul(opacity, shownShare(facts));
        }
        if ((layer_.parts.any || facts.faceCount > 0) && !hn::AllFalse(kF, hn::Gt(opacity, splat(0)))) {
            opacity = LayerParts<Field>(layer_, facts).apply(opacity, out);
        }
        return ofStep(opacity, partOf(facts));
    }

    /// Share of a step that a sample stands for in this layer.
    HWY_INLINE Floats partOf(const Facts<Field>& facts) const {
        return layer_.cut != nullptr ? hn::Mul(facts.part, keptByCut(*layer_.cut, scene_, facts)) : facts.part;
    }

    /// Opacity of a sample by its value alone; `entry`: of the scene's table.
    HWY_INLINE Floats opacityByValue(Floats entry, Floats part) const {
        return stepOpacity().read(TablePlace(entryOf(entry)), part);
    }

    /// The colour alone, where the sample's opacity is known already.
    HWY_INLINE void colourByValue(const Facts<Field>& facts, LaneColours& out) const {
        const Floats width = contourWidth(facts);
        if (layer_.shading != Shading::style && layer_.rows == 0 && !layer_.oneColour) {
            shadePlain(facts, width, PlainEntries(layer_.colours, entryOf(facts.tableEntry)), out);
        } else {
            NodeBlend nodes;
            if ((layer_.singleSlot < 0 && !layer_.oneColour) || layer_.textures != nullptr) {
                nodes = nodesOfLine(entryOf(facts.tableEntry));
            }
            colour(facts, width, nodes, out);
        }
        tint(facts, out);
    }

  private:
    [[nodiscard]] HWY_INLINE StepOpacity stepOpacity() const {
        return {layer_.stepOpacity, layer_.opacity, scene_.stepRatio};
    }

    /// Of the layer's table over the value.
    HWY_INLINE Floats entryOf(Floats sceneEntry) const {
        return hn::MulAdd(sceneEntry, splat(layer_.x.scale), splat(layer_.x.bias));
    }

    HWY_INLINE void tint(const Facts<Field>& facts, LaneColours& out) const {
        if (layer_.parts.any || facts.faceCount > 0) {
            LayerParts<Field>(layer_, facts).apply(splat(1), out);
        }
    }

    HWY_INLINE Floats ofStep(Floats opacity, Floats part) const {
        const Floats whole = opacityOfLength(opacity, hn::Mul(splat(scene_.stepRatio), part));
        return layer_.cut == nullptr ? whole : hn::IfThenElseZero(hn::Gt(part, splat(0)), whole);
    }

    /// Where contours end, |n.v|; 0: there are none.
    HWY_INLINE Floats contourWidth(const Facts<Field>& facts) const {
        const KernelContours& contours = layer_.contours;
        if (!contours.on) {
            return splat(0);
        }
        if (!contours.controlled) {
            return hn::Mul(splat(contours.fixedWidth), facts.trusted);
        }
        const Floats curvature = contours.normals ? facts.turn(splat(contours.probeMm)) : facts.bend;
        const Floats thickness = hn::Mul(splat(contours.thicknessMm), facts.depth());
        return optics::contourWidth(Lanes{hn::Mul(thickness, curvature)}).v;
    }

    /// In entries of the layer's table.
    HWY_INLINE Floats axisEntry(const KernelAxis& axis, const Facts<Field>& facts) const {
        Floats raw = facts.tableEntry;
        switch (axis.axis) {
        case TransferAxis::gradient: raw = facts.unitMagnitude(); break;
        case TransferAxis::curvature: raw = facts.bend; break;
        case TransferAxis::distance:
            raw = axis.bricks != nullptr ? facts.other(axis.bricks) : distance(axis, facts.q);
            break;
        case TransferAxis::second: raw = facts.other(axis.bricks); break;
        case TransferAxis::importance:
            raw = ImportanceMeasures<Field>(scene_.axisImportance, facts).sum(splat(0));
            break;
        case TransferAxis::value:
        case TransferAxis::label: break;
        }
        const Floats entry = hn::MulAdd(raw, splat(axis.scale), splat(axis.bias));
        return hn::Min(hn::Max(entry, splat(0)), splat(axis.last));
    }

    static HWY_INLINE Floats distance(const KernelAxis& axis, const Vec3& q) {
        const Vec3 d = {hn::Sub(q.x, splat(axis.from[0])), hn::Sub(q.y, splat(axis.from[1])),
                        hn::Sub(q.z, splat(axis.from[2]))};
        const auto mm = [&](const float* m) HWY_ATTR { return dot({splat(m[0]), splat(m[1]), splat(m[2])}, d); };
        const Vec3 v = {mm(axis.mmFromCell[0]), mm(axis.mmFromCell[1]), mm(axis.mmFromCell[2])};
        return hn::Sqrt(dot(v, v));
    }

    /// Around an entry of the table; along X.
    HWY_INLINE NodePlace columnOf(Floats entry) const {
        return layer_.x.nodes.count > 0 ? nodePlace(layer_.x.nodes, entry)
                                        : nodePlaceOf(TablePlace(entry).read(layer_.index));
    }

    /// The two nodes of a line around an entry of the table.
    HWY_INLINE NodeBlend nodesOfLine(Floats entry) const {
        const NodePlace at = columnOf(entry);
        NodeBlend nodes;
        nodes.node[0] = at.node;
        nodes.node[1] = hn::Min(hn::Add(at.node, splatInt(1)), splatInt(layer_.lastColumn));
        nodes.weight[1] = at.beyond;
        nodes.weight[0] = hn::Sub(splat(1), at.beyond);
        nodes.count = 2;
        return nodes;
    }

    /// The four nodes of a grid.
    HWY_INLINE NodeBlend nodesOfGrid(const NodePlace& column, const NodePlace& row) const {
        const auto along = [](const NodePlace& at, std::int32_t last, std::int32_t stride, Ints* node,
                              Floats* weight) HWY_ATTR {
            node[0] = hn::Mul(at.node, splatInt(stride));
            node[1] = hn::Mul(hn::Min(hn::Add(at.node, splatInt(1)), splatInt(last)), splatInt(stride));
            weight[1] = at.beyond;
            weight[0] = hn::Sub(splat(1), at.beyond);
        };
        Ints x[2], y[2];
        Floats wx[2], wy[2];
        along(column, layer_.lastColumn, layer_.columnStride, x, wx);
        along(row, layer_.lastRow, layer_.nodeRowStride, y, wy);
        NodeBlend nodes;
        nodes.count = 4;
        for (int i = 0; i < 4; ++i) {
            nodes.node[i] = hn::Add(x[i & 1], y[i >> 1]);
            nodes.weight[i] = hn::Mul(wx[i & 1], wy[i >> 1]);
        }
        return nodes;
    }

    /// Opacity of the reference length at a place whose row is given (label axes) or found; colours into `out`.
    HWY_NOINLINE Floats row(const Facts<Field>& facts, Floats width, Floats rowEntry, LaneColours& out) const {
        const Floats entry = axisEntry(layer_.x, facts);
        const TablePlace x(entry);
        if (layer_.rows == 0) {
            const Floats opacity = x.read(layer_.opacity);
            if (hn::AllFalse(kF, hn::Gt(opacity, splat(0)))) {
                return opacity;
            }
            colour(facts, width, nodesOfLine(entry), out);
            return transparency(facts, width, opacity, out);
        }
        const Floats y = layer_.rowOfSlot != nullptr ? rowEntry : axisEntry(layer_.y, facts);
        const Ints low = truncate(y);
        const Ints high = hn::Min(hn::Add(low, splatInt(1)), splatInt(layer_.rows - 1));
        const Floats fraction = hn::Sub(y, toFloat(low));
        const auto at = [&](Ints tableRow) HWY_ATTR {
            return x.readAt(layer_.opacity2d, hn::Mul(tableRow, splatInt(layer_.rowStride)));
        };
        const Floats opacity = lerp(at(low), at(high), fraction);
        if (hn::AllFalse(kF, hn::Gt(opacity, splat(0)))) {
            return opacity;
        }
        NodePlace rowAt;
        if (layer_.y.nodes.count > 0) {
            rowAt = nodePlace(layer_.y.nodes, y);
        } else {
            const Floats index =
                lerp(gatherFloats(layer_.rowIndex, low), gatherFloats(layer_.rowIndex, high), fraction);
            rowAt = nodePlaceOf(hn::Max(index, splat(0)));
        }
        colour(facts, width, nodesOfGrid(columnOf(entry), rowAt), out);
        return transparency(facts, width, opacity, out);
    }

    /// Each label around the sample is a row of the table; their parts add up by opacity, so that an invisible
    /// neighbour's colour does not bleed.
    HWY_NOINLINE Floats byLabels(const Facts<Field>& facts, Floats width, LaneColours& out) const {
        alignas(64) float sum[kMaxLanes * 4] = {};
        Floats total = splat(0);
        for (int k = 0; k < facts.members.most; ++k) {
            LaneFloats rowOf;
            LaneFloats weight;
            for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
                const int slot = facts.members.slot[k][lane];
                const bool shown = layer_.shownSlots == nullptr || layer_.shownSlots[slot] != 0;
                const std::int16_t tableRow = layer_.rowOfSlot[slot];
                rowOf.at[lane] = static_cast<float>(tableRow < 0 ? 0 : tableRow);
                weight.at[lane] = shown && tableRow >= 0 ? facts.members.weight[k][lane] : 0.0F;
            }
            LaneColours part;
            const Floats opacity = hn::Mul(row(facts, width, hn::Load(kF, rowOf.at), part), hn::Load(kF, weight.at));
            if (hn::AllFalse(kF, hn::Gt(opacity, splat(0)))) {
                continue;
            }
            total = hn::Add(total, opacity);
            const LaneFloats share(opacity);
            for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
                if (share.at[lane] > 0) {
                    const Quad before = hn::Load(kQuad, sum + 4 * lane);
                    hn::Store(hn::MulAdd(hn::Set(kQuad, share.at[lane]), hn::Load(kQuad, part.rgba + 4 * lane), before),
                              kQuad, sum + 4 * lane);
                }
            }
        }
        const LaneFloats inverse(hn::Div(splat(1), hn::Max(total, splat(1e-30F))));
        for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
            hn::Store(hn::Mul(hn::Load(kQuad, sum + 4 * lane), hn::Set(kQuad, inverse.at[lane])), kQuad,
                      out.rgba + 4 * lane);
        }
        return hn::Min(total, splat(1));
    }

    HWY_INLINE Floats shownShare(const Facts<Field>& facts) const {
        LaneFloats share(splat(0));
        for (int k = 0; k < facts.members.most; ++k) {
            for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
                share.at[lane] +=
                    layer_.shownSlots[facts.members.slot[k][lane]] != 0 ? facts.members.weight[k][lane] : 0.0F;
            }
        }
        return hn::Load(kF, share.at);
    }

    HWY_INLINE Floats transparency(const Facts<Field>& facts, Floats width, Floats opacity,
                                   const LaneColours& out) const {
        Floats directional = splat(1);
        if (layer_.directionalOpacity) {
            Floats r, g, b;
            hn::LoadInterleaved4(kF, out.rgba, r, g, b, directional);
        }
        if (!layer_.illustrative) {
            return hn::Mul(directional, opacity);
        }
        const Lanes facing{hn::Min(hn::Abs(facts.normal.facing), splat(1))};
        return optics::illustrativeOpacity(Lanes{directional}, Lanes{opacity}, facing, Lanes{width},
                                           Lanes{facts.unitMagnitude()})
            .v;
    }

    HWY_INLINE void colour(const Facts<Field>& facts, Floats width, const NodeBlend& nodes, LaneColours& out) const {
        if (layer_.oneColour) {
            shadePlain(facts, width, PlainColour(layer_.nodeColours), out);
            return;
        }
        if (layer_.shading != Shading::style) {
            const PlainNodes plain(layer_.nodeColours, nodes);
            shadePlain(facts, width, plain, out);
            return;
        }
        const SphereQuery query = sphereQuery(facts, width);
        if (layer_.singleSlot >= 0) {
            NodeBlend slot;
            slot.node[0] = splatInt(layer_.singleSlot);
            slot.weight[0] = splat(1);
            sphereColours(scene_.atlas, query, slot, out);
        } else {
            sphereColours(scene_.atlas, query, slotsOf(layer_, nodes), out);
        }
        if (layer_.textures != nullptr) {
            layTextures(TexturePlace(scene_, facts.q, facts.normal.eye, facts.trusted), layer_.textures, nodes, out);
        }
    }

    /// Where the normal, seen along the ray, looks on the sphere's picture.
    HWY_INLINE SphereQuery sphereQuery(const Facts<Field>& facts, Floats width) const {
        Floats x = facts.normal.eye.x;
        Floats y = facts.normal.eye.y;
        if (scene_.perspective) { // the normal in the frame of the ray (spec style-transfer-functions 1)
            const Floats k = hn::Div(hn::Add(facts.normal.facing, facts.normal.eye.z), hn::Add(splat(1), facts.view.z));
            x = hn::NegMulAdd(facts.view.x, k, x);
            y = hn::NegMulAdd(facts.view.y, k, y);
        }
        Floats stretch = splat(1);
        if (layer_.contours.on) {
            const Floats radius = hn::Min(hn::Sqrt(hn::MulAdd(x, x, hn::Mul(y, y))), splat(1));
            const Floats facing = hn::Min(hn::Abs(facts.normal.facing), splat(1));
            const Floats pushed = optics::contourPush(Lanes{radius}, Lanes{facing}, Lanes{width}).v;
            stretch =
                hn::IfThenElse(hn::Gt(radius, splat(0)), hn::Div(pushed, hn::Max(radius, splat(1e-20F))), stretch);
        }
        if (layer_.twoSided) {
            stretch = hn::CopySign(stretch, facts.normal.facing);
        }
        return {hn::Mul(x, stretch), hn::Mul(y, stretch), mipLevel(facts, width), facts.trusted};
    }

    /// Of the layer's spheres; 0 where the atlas has no other.
    HWY_INLINE Floats mipLevel(const Facts<Field>& facts, Floats width) const {
        const KernelAtlas& atlas = scene_.atlas;
        if (atlas.levelStart == nullptr) {
            return splat(0);
        }
        const Lanes footprint{hn::Mul(splat(atlas.footprintVoxels), facts.depth())};
        Floats curvature = splat(0);
        if (layer_.curvedLevels) { // contours read the rim, however the surface turns
            curvature = hn::Mul(hn::Mul(splat(atlas.voxelMm), facts.bend), uninked(facts, width));
        }
        const Floats level = optics::mipLevel(Lanes{atlas.radiusTexels}, footprint, Lanes{curvature}).v;
        return hn::Min(level, splat(static_cast<float>(atlas.lastLevel)));
    }

    /// Phong's light and the contours' ink over plain colours, `plain.colour(lane)`.
    template <typename Plain>
    HWY_INLINE void shadePlain(const Facts<Field>& facts, Floats width, const Plain& plain, LaneColours& out) const {
        const auto each = [&](const auto& shade) HWY_ATTR {
            for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
                hn::Store(shade(plain.colour(lane), lane), kQuad, out.rgba + 4 * lane);
            }
        };
        if (layer_.shading == Shading::phong) {
            const Floats lit = litPart(facts);
            const LaneFloats factor(hn::MulAdd(lit, splat(layer_.diffuse), splat(layer_.ambient)));
            const LaneFloats gloss(hn::Mul(splat(layer_.specularStrength), power(lit, layer_.specularExponent)));
            each([&](Quad c, std::size_t lane) HWY_ATTR {
                const Quad shaded = hn::MulAdd(c, hn::Set(kQuad, factor.at[lane]), hn::Set(kQuad, gloss.at[lane]));
                return hn::Min(shaded, hn::Set(kQuad, 1.0F));
            });
        } else {
            each([](Quad c, std::size_t) HWY_ATTR { return c; });
        }
        if (layer_.contours.on) {
            const LaneFloats paper(uninked(facts, width));
            for (std::size_t lane = 0; lane < hn::Lanes(kF); ++lane) {
                hn::Store(hn::Mul(hn::Load(kQuad, out.rgba + 4 * lane), hn::Set(kQuad, paper.at[lane])), kQuad,
                          out.rgba + 4 * lane);
            }
        }
    }

    HWY_INLINE Floats litPart(const Facts<Field>& facts) const {
        const Floats facing = facts.normal.facing;
        return hn::Min(layer_.twoSided ? hn::Abs(facing) : hn::Max(facing, splat(0)), splat(1));
    }

    /// What a contour's ink leaves of a plain colour.
    HWY_INLINE Floats uninked(const Facts<Field>& facts, Floats width) const {
        const Lanes facing{hn::Abs(facts.normal.facing)};
        return hn::Sub(splat(1), optics::contourCoverage(facing, Lanes{width}).v);
    }

    const KernelScene& scene_;
    const KernelLayer& layer_;
};

/// Opacity of all layers at a sample, one behind the other, where each goes by the value alone; `share(i, opacity)`
/// gets what layer i has of it.
template <typename Field, typename Share>
HWY_INLINE Floats opacityOfLayers(const KernelScene& scene, Floats entry, Floats part, const Share& share) {
    Floats through = splat(1);
    Floats total = splat(0);
    for (int i = 0; i < scene.layerCount; ++i) {
        const LayerEvaluation<Field> layer(scene, scene.layers[i]);
        const Floats opacity = hn::Mul(through, layer.opacityByValue(entry, part));
        share(i, opacity);
        total = hn::Add(total, opacity);
        through = hn::Sub(through, opacity);
    }
    return total;
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
