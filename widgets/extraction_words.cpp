#include "widgets/extraction_words.h"

#include <QCoreApplication>
#include <QPalette>

namespace limner {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ExtractionWords)
};

/// Good below the first bound, fair below the second. Poor is what `verdictOf` has an advice on; there are the reasons.
struct Bounds {
    double good = 0;
    double fair = 0;
};
Grade gradeOf(double value, const Bounds& bounds) {
    return value < bounds.good ? Grade::good : value < bounds.fair ? Grade::fair : Grade::poor;
}

GradedFigure coverageWords(double coverage) {
    // A ball seen whole covers all but its outermost rim.
    const Grade grade = gradeOf(-coverage, {-0.85, -0.5 + 1e-9});
    const QString tip =
        Words::tr("How much of the ball was seen in the artwork; the rest is filled in from around it.");
    const QString advice =
        grade == Grade::good ? QString()
                             : Words::tr("Take a form that shows more sides, erase less, or leave fewer letters out.");
    return {Words::tr("Coverage"), Words::tr("%1 %").arg(coverage * 100, 0, 'f', 0), tip, advice, grade};
}

GradedFigure residualWords(double residual) {
    const Grade grade = gradeOf(residual, {0.03, 0.08});
    const QString tip =
        Words::tr("How far the form, shaded again with this style, is from the artwork (root mean square of "
                  "the colours, 0 to 1).");
    const QString advice =
        grade == Grade::good
            ? QString()
            : Words::tr("Look at “Difference”: where it is not grey, mark normals and creases, ignore letters, "
                        "or choose a form of one material.");
    return {Words::tr("Residual"), QString::number(residual, 'f', 3), tip, advice, grade};
}

GradedFigure holeWords(double degrees) {
    // Across 20 degrees a smooth fill is hardly told from paint.
    const Grade grade = gradeOf(degrees, {20, 40});
    QString tip =
        Words::tr("The widest gap between directions that were seen; it is filled smoothly, without guessing.");
    const QString advice =
        grade == Grade::good
            ? QString()
            : Words::tr("Take in the part of the form that faces that way, or make the style symmetric.");
    return {Words::tr("Largest hole"), Words::tr("%1°").arg(degrees, 0, 'f', 0), tip, advice, grade};
}

GradedFigure placementWords(double rmse) {
    const Grade grade = gradeOf(rmse, {0.01, 0.03});
    const QString tip = Words::tr("How much the style would change if the outline were snapped to the picture's edge.");
    const QString advice = grade == Grade::good
                               ? QString()
                               : Words::tr("Press “Snap to edge”, or drag the outline's handles onto the edge.");
    return {Words::tr("Placement"), QString::number(rmse, 'f', 3), tip, advice, grade};
}

GradedFigure depthWords(double rmse) {
    const Grade grade = gradeOf(rmse, {0.03, 0.05});
    QString tip =
        Words::tr("How much the style would change if the form were deeper by a quarter: no picture tells its "
                  "depth.");
    const QString advice = grade == Grade::good
                               ? QString()
                               : Words::tr("Set “Depth” to what you know of the form, or mark some normals inside it.");
    return {Words::tr("Depth"), QString::number(rmse, 'f', 3), tip, advice, grade};
}

} // namespace

std::vector<GradedFigure> gradedFigures(const ExtractionFigures& figures, bool outlined) {
    std::vector<GradedFigure> graded{coverageWords(figures.coverage), residualWords(figures.residualRmse),
                                     holeWords(figures.largestHoleDegrees)};
    if (figures.formRmse)
        graded.push_back(outlined ? depthWords(*figures.formRmse) : placementWords(*figures.formRmse));
    return graded;
}

QString gradeWord(Grade grade) {
    switch (grade) {
    case Grade::good: return Words::tr("good");
    case Grade::fair: return Words::tr("fair");
    case Grade::poor: return Words::tr("poor");
    }
    return {};
}

QColor gradeColour(Grade grade, const QPalette& palette) {
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    switch (grade) {
    case Grade::good: return dark ? QColor(0x7c, 0xd0, 0x8e) : QColor(0x1d, 0x6b, 0x33);
    case Grade::fair: return dark ? QColor(0xea, 0xbd, 0x5c) : QColor(0x84, 0x55, 0x00);
    case Grade::poor: return dark ? QColor(0xff, 0x96, 0x88) : QColor(0xa8, 0x25, 0x18);
    }
    return palette.color(QPalette::WindowText);
}

} // namespace limner
