#pragma once

#include "core/style/extraction/extract.h"

#include <QColor>
#include <QString>

#include <vector>

class QPalette;

namespace limner {

/// How good an extraction is, in words that an illustrator can act on.

enum class Grade { good, fair, poor };

struct GradedFigure {
    QString label;  ///< "Coverage"
    QString number; ///< "83 %"
    QString tip;    ///< what it is
    QString advice; ///< what to do about it; empty where it is good
    Grade grade = Grade::good;
};

/// Coverage, residual, largest hole; and, where it was found, how much a likely mistake in the form would cost.
/// `outlined`: the form is a region, not a ball.
std::vector<GradedFigure> gradedFigures(const ExtractionFigures& figures, bool outlined);
QString gradeWord(Grade grade);
/// Green, amber, red: readable on the palette's window, 4.5:1 and more.
QColor gradeColour(Grade grade, const QPalette& palette);

} // namespace limner
