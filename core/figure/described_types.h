#pragma once

#include "core/figure/description.h"

#include <span>

namespace limner::description {

/// The fields of a described type, in document order. Specialised in parameters.cpp for every value type.
template <class T>
std::span<const Field> fieldsOf();
template <>
std::span<const Field> fieldsOf<VolumeReference>();
template <>
std::span<const Field> fieldsOf<LabelReference>();
template <>
std::span<const Field> fieldsOf<Camera>();
template <>
std::span<const Field> fieldsOf<ClipPlane>();
template <>
std::span<const Field> fieldsOf<Clip>();
template <>
std::span<const Field> fieldsOf<CutFace>();
template <>
std::span<const Field> fieldsOf<CleanupStep>();
template <>
std::span<const Field> fieldsOf<StyleEntry>();
template <>
std::span<const Field> fieldsOf<TransferNode>();
template <>
std::span<const Field> fieldsOf<TransferGrid>();
template <>
std::span<const Field> fieldsOf<OpacityShape>();
template <>
std::span<const Field> fieldsOf<Transfer>();
template <>
std::span<const Field> fieldsOf<Contours>();
template <>
std::span<const Field> fieldsOf<Light>();
template <>
std::span<const Field> fieldsOf<ColourKey>();
template <>
std::span<const Field> fieldsOf<Tone>();
template <>
std::span<const Field> fieldsOf<Silhouette>();
template <>
std::span<const Field> fieldsOf<Specular>();
template <>
std::span<const Field> fieldsOf<PhongLight>();
template <>
std::span<const Field> fieldsOf<RampKey>();
template <>
std::span<const Field> fieldsOf<PositionRamp>();
template <>
std::span<const Field> fieldsOf<DepthOfField>();
template <>
std::span<const Field> fieldsOf<Layer>();
template <>
std::span<const Field> fieldsOf<ImportanceWeights>();
template <>
std::span<const Field> fieldsOf<Lens>();
template <>
std::span<const Field> fieldsOf<SilhouetteMeasure>();
template <>
std::span<const Field> fieldsOf<LightingMeasure>();
template <>
std::span<const Field> fieldsOf<ObjectImportance>();
template <>
std::span<const Field> fieldsOf<Importance>();
template <>
std::span<const Field> fieldsOf<AmbientOcclusion>();
template <>
std::span<const Field> fieldsOf<ContactShadow>();
template <>
std::span<const Field> fieldsOf<Halo>();
template <>
std::span<const Field> fieldsOf<DepthCues>();
template <>
std::span<const Field> fieldsOf<StippleBoundary>();
template <>
std::span<const Field> fieldsOf<StippleSilhouette>();
template <>
std::span<const Field> fieldsOf<StippleResolution>();
template <>
std::span<const Field> fieldsOf<StippleDistance>();
template <>
std::span<const Field> fieldsOf<StippleInterior>();
template <>
std::span<const Field> fieldsOf<StippleLighting>();
template <>
std::span<const Field> fieldsOf<StippleCurves>();
template <>
std::span<const Field> fieldsOf<StippleInnerLines>();
template <>
std::span<const Field> fieldsOf<StippleHatching>();
template <>
std::span<const Field> fieldsOf<Stipple>();
template <>
std::span<const Field> fieldsOf<Background>();
template <>
std::span<const Field> fieldsOf<Annotation>();
template <>
std::span<const Field> fieldsOf<Output>();
template <>
std::span<const Field> fieldsOf<Quality>();
template <>
std::span<const Field> fieldsOf<Figure>();

} // namespace limner::description
