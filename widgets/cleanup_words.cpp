#include "widgets/cleanup_words.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace limner {
namespace {

/// The context of the words below.
struct CleanupWords {
    Q_DECLARE_TR_FUNCTIONS(CleanupWords)
};

QString number(double value) {
    constexpr int kDigits = 5; // what a scan's values have
    return QLocale().toString(value, 'g', kDigits);
}

QString withUnit(const Figure& figure, double value) {
    const bool known = figure.volume && figure.volume->data && !figure.volume->data->contents().unit.empty();
    const QString text = number(value);
    return known ? text + " " + QString::fromStdString(figure.volume->data->contents().unit) : text;
}

QString labelWords(const Figure& figure, int label) {
    if (figure.labels) {
        const auto name = figure.labels->names.find(std::to_string(label));
        if (name != figure.labels->names.end() && !name->second.empty())
            return CleanupWords::tr("Erase %1 (label %2)").arg(QString::fromStdString(name->second)).arg(label);
    }
    return CleanupWords::tr("Erase label %1").arg(label);
}

} // namespace

QString cleanupKindWords(CleanupKind kind) {
    switch (kind) {
    case CleanupKind::keepLargest: return CleanupWords::tr("Keep the largest island");
    case CleanupKind::keepAt: return CleanupWords::tr("Keep the island at a point");
    case CleanupKind::removeIslands: return CleanupWords::tr("Remove small islands");
    case CleanupKind::scissors: return CleanupWords::tr("Scissors");
    case CleanupKind::eraseLabel: return CleanupWords::tr("Erase a label");
    }
    return {};
}

QString cleanupWords(const CleanupStep& step, const Figure& figure) {
    const QString above = withUnit(figure, step.above);
    switch (step.kind) {
    case CleanupKind::keepLargest:
        if (step.openingMm > 0)
            return CleanupWords::tr("Keep the largest island above %1, parted where thinner than %2 mm")
                .arg(above, number(2 * step.openingMm));
        return CleanupWords::tr("Keep the largest island above %1").arg(above);
    case CleanupKind::keepAt: {
        const glm::dvec3 at = step.atMm.value_or(glm::dvec3(0));
        const auto whole = [](double mm) { return QLocale().toString(std::lround(mm)); };
        return CleanupWords::tr("Keep the island above %1 at %2, %3, %4 mm")
            .arg(above, whole(at.x), whole(at.y), whole(at.z));
    }
    case CleanupKind::removeIslands:
        return CleanupWords::tr("Remove islands above %1 that are smaller than %2 mm³")
            .arg(above, number(step.belowMm3));
    case CleanupKind::scissors:
        return CleanupWords::tr("Scissors: %1 points, %2") // never one or two: that is no outline
            .arg(step.polygon.size())
            .arg(step.side == ScissorsSide::inside ? CleanupWords::tr("inside") : CleanupWords::tr("outside"));
    case CleanupKind::eraseLabel: return labelWords(figure, step.label);
    }
    return {};
}

} // namespace limner
