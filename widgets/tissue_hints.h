#pragma once

#include "widgets/axis_view.h"

#include <QRectF>
#include <QString>

#include <optional>
#include <span>

class QPainter;
class QPalette;

namespace limner {

/// Where tissues lie on the scale of computed tomography (Hounsfield units), to find one's way on the ruler.
struct TissueHint {
    const char* name; ///< to be translated: `tissueName`
    ValueRange range;
    unsigned rgb; ///< a quiet colour that people expect of it
};

std::span<const TissueHint> tissueHints();
QString tissueName(const TissueHint& hint);
/// "Bone: 300 to 1900 HU"; open ends in words.
QString tissueWords(const TissueHint& hint);
/// What to show of the axis for a tissue: its range with room around it.
ValueRange tissueView(const TissueHint& hint);

/// A strip under a ruler: a bar for each tissue, its name where there is room.
void paintTissues(QPainter& painter, const QPalette& palette, const QRectF& strip, const AxisView& axis);
/// The tissue under a place of the strip; narrow ones are a little wider to the hand than to the eye.
const TissueHint* tissueAt(const QRectF& strip, const AxisView& axis, QPointF position);

} // namespace limner
