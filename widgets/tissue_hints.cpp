#include "widgets/tissue_hints.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPalette>

#include <cmath>

namespace limner {
namespace {

constexpr double kLeastWidth = 4; // of a bar, pixels: water is ten units of four thousand
constexpr double kGrab = 3;

// Usual figures of textbooks (Hounsfield 1980 and after): they overlap in patients, hints is all that they are.
constexpr TissueHint kHints[] = {
    {QT_TRANSLATE_NOOP("Tissues", "Air"), {-1024, -950}, 0x8fb4d6},
    {QT_TRANSLATE_NOOP("Tissues", "Lung"), {-900, -500}, 0x9fa6c9},
    {QT_TRANSLATE_NOOP("Tissues", "Fat"), {-120, -60}, 0xe0c25a},
    {QT_TRANSLATE_NOOP("Tissues", "Water"), {-10, 10}, 0x4f9fd8},
    {QT_TRANSLATE_NOOP("Tissues", "Muscle"), {20, 70}, 0xc8665a},
    {QT_TRANSLATE_NOOP("Tissues", "Bone"), {300, 1900}, 0xc9b48a},
    {QT_TRANSLATE_NOOP("Tissues", "Metal"), {3000, 30000}, 0x8c939c},
};

QRectF barOf(const TissueHint& hint, const QRectF& strip, const AxisView& axis) {
    const double from = strip.left() + axis.shareOf(hint.range.low) * strip.width();
    const double to = strip.left() + axis.shareOf(hint.range.high) * strip.width();
    const double middle = (from + to) / 2;
    const double half = std::max(kLeastWidth, to - from) / 2;
    return QRectF(middle - half, strip.top(), 2 * half, strip.height()) & strip;
}

} // namespace

std::span<const TissueHint> tissueHints() { return kHints; }

QString tissueName(const TissueHint& hint) { return QCoreApplication::translate("Tissues", hint.name); }

QString tissueWords(const TissueHint& hint) {
    const QLocale locale;
    const auto text = [&](double value) { return locale.toString(value, 'f', 0); };
    const QString name = tissueName(hint);
    const double last = std::end(kHints)[-1].range.low;
    if (hint.range.low == last)
        return QCoreApplication::translate("Tissues", "%1: above %2 HU").arg(name, text(hint.range.low));
    if (hint.range.low == kHints[0].range.low)
        return QCoreApplication::translate("Tissues", "%1: about %2 HU").arg(name, text(-1000));
    return QCoreApplication::translate("Tissues", "%1: %2 to %3 HU")
        .arg(name, text(hint.range.low), text(hint.range.high));
}

ValueRange tissueView(const TissueHint& hint) {
    constexpr double kMost = 2500; // metal has no upper end: it starts, and what is beyond is the same
    const double width = std::min(hint.range.high - hint.range.low, kMost);
    return {hint.range.low - width / 2, hint.range.low + width * 1.5};
}

void paintTissues(QPainter& painter, const QPalette& palette, const QRectF& strip, const AxisView& axis) {
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.82);
    const QFontMetricsF metrics(font);
    painter.save();
    painter.setFont(font);
    painter.setClipRect(strip.adjusted(-1, -1, 1, 1));
    double free = strip.left(); // where the next name may begin
    for (std::size_t i = 0; i < std::size(kHints); ++i) {
        const QRectF bar = barOf(kHints[i], strip, axis);
        if (bar.isEmpty())
            continue;
        constexpr double kBar = 4; // height of the colour
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(kHints[i].rgb));
        painter.drawRoundedRect(QRectF(bar.left(), bar.top(), bar.width(), kBar), 1.5, 1.5);
        const QString name = tissueName(kHints[i]);
        const double width = metrics.horizontalAdvance(name);
        double end = strip.right() + 1;
        for (std::size_t k = i + 1; k < std::size(kHints); ++k)
            if (const QRectF next = barOf(kHints[k], strip, axis); !next.isEmpty()) {
                end = next.left();
                break;
            }
        const double left = std::clamp(bar.center().x() - width / 2, std::max(free, strip.left()),
                                       std::max(free, strip.right() - width));
        // Names stand over their bar, or lean into the free room beside it.
        const bool fits =
            left <= bar.right() && left + width <= std::max(bar.right(), end) + 1 && left + width >= bar.left();
        if (!fits)
            continue;
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QRectF(left, bar.top() + kBar, width + 1, strip.height() - kBar), Qt::AlignCenter, name);
        free = left + width + 6;
    }
    painter.restore();
}

const TissueHint* tissueAt(const QRectF& strip, const AxisView& axis, QPointF position) {
    if (!strip.contains(position))
        return nullptr;
    const TissueHint* best = nullptr;
    double nearest = kGrab;
    for (const TissueHint& hint : kHints) {
        const QRectF bar = barOf(hint, strip, axis);
        if (bar.isEmpty())
            continue;
        const double off = std::max({0.0, bar.left() - position.x(), position.x() - bar.right()});
        if (off < nearest) {
            nearest = off;
            best = &hint;
        }
    }
    return best;
}

} // namespace limner
