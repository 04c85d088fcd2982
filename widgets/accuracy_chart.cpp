#include "widgets/accuracy_chart.h"

#include "widgets/accuracy_words.h"

#include <QHelpEvent>
#include <QLineF>
#include <QLocale>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr double kDot = 2.5; // radius, pixels
constexpr double kNear = 7;  // of a dot: the pointer means it
constexpr double kGap = 4;
constexpr int kMostLabels = 6; // powers of ten along the times: more would touch each other

/// Apart from each other for every kind of colour vision, on light and on dark paper.
QColor seriesColour(std::size_t index, bool dark) {
    const std::array<QColor, 2> onLight{QColor(0x1b6ca8), QColor(0xb5482f)};
    const std::array<QColor, 2> onDark{QColor(0x6cb4ee), QColor(0xf09a7c)};
    return (dark ? onDark : onLight).at(index % onLight.size());
}

QColor blended(const QColor& a, const QColor& b, double share) {
    const auto mix = [share](int x, int y) { return static_cast<int>(std::lround(x + (y - x) * share)); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

QString powerOfTen(int exponent) { return QLocale().toString(std::pow(10.0, exponent), 'g', 6); }

} // namespace

double AccuracyChart::Axis::at(double value) const {
    const double place = std::log10(std::max(value, std::pow(10.0, low)));
    return from + (std::min(place, high) - low) / (high - low) * (to - from);
}

AccuracyChart::AccuracyChart(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Error against run time, chart"));
    setMouseTracking(true);
}

void AccuracyChart::setStudy(std::shared_ptr<const accuracy::Study> study) {
    study_ = std::move(study);
    setAccessibleDescription(study_ ? limitWords(study_->limits, study_->metric) : QString());
    update();
}

double AccuracyChart::errorOf(std::size_t row) const { return study_->rows[row].measured.error.of(study_->metric); }

QRectF AccuracyChart::field() const {
    const QFontMetrics metrics(font());
    const double left = metrics.horizontalAdvance("0.0001") + 3.0 * kGap + metrics.height();
    const double bottom = 2.0 * metrics.height() + 3 * kGap;
    return QRectF(rect()).adjusted(left, kGap, -2 * kGap, -bottom);
}

AccuracyChart::Axis AccuracyChart::times() const {
    Axis axis{9, -9, field().left(), field().right()};
    for (const accuracy::StudyRow& row : study_->rows)
        if (row.pictureSeconds > 0) {
            axis.low = std::min(axis.low, std::floor(std::log10(row.pictureSeconds)));
            axis.high = std::max(axis.high, std::ceil(std::log10(row.pictureSeconds)));
        }
    axis.high = std::max(axis.high, axis.low + 1);
    return axis;
}

AccuracyChart::Axis AccuracyChart::errors() const {
    Axis axis{9, -9, field().bottom(), field().top()};
    const auto widen = [&](double error) {
        if (error > 0) {
            axis.low = std::min(axis.low, std::floor(std::log10(error)));
            axis.high = std::max(axis.high, std::ceil(std::log10(error)));
        }
    };
    for (std::size_t i = 0; i < study_->rows.size(); ++i)
        widen(errorOf(i));
    widen(study_->errorBar);
    axis.high = std::max(axis.high, axis.low + 1);
    return axis;
}

QPointF AccuracyChart::placeOf(std::size_t row) const {
    return {times().at(study_->rows[row].pictureSeconds), errors().at(errorOf(row))};
}

std::optional<std::size_t> AccuracyChart::rowAt(QPointF place) const {
    std::optional<std::size_t> nearest;
    double least = kNear;
    for (std::size_t i = 0; study_ && i < study_->rows.size(); ++i)
        if (const double away = QLineF(place, placeOf(i)).length(); away < least) {
            least = away;
            nearest = i;
        }
    return nearest;
}

void AccuracyChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    if (!study_ || study_->rows.empty())
        return;
    const Axis x = times();
    const Axis y = errors();
    const QColor paper = palette().color(QPalette::Base);
    const QColor ink = palette().color(QPalette::Text);
    const QRectF area = field();
    const double bar = y.at(study_->errorBar);
    painter.fillRect(QRectF(area.left(), bar, area.width(), area.bottom() - bar), blended(paper, ink, 0.12));
    paintGrid(painter, x, y);
    paintTolerances(painter, y);
    painter.setPen(QPen(ink, 1, Qt::DashLine));
    paintLine(painter, study_->pareto);
    painter.setPen(Qt::NoPen);
    painter.setBrush(blended(paper, ink, 0.5));
    for (std::size_t i = 0; i < study_->rows.size(); ++i)
        painter.drawEllipse(placeOf(i), kDot, kDot);
    paintSeries(painter);
    paintPresent(painter);
}

void AccuracyChart::paintGrid(QPainter& painter, const Axis& x, const Axis& y) const {
    const QRectF area = field();
    const QColor ink = palette().color(QPalette::Text);
    const QColor faint = blended(palette().color(QPalette::Base), ink, 0.2);
    const double line = QFontMetricsF(font()).height();
    const int step = std::max(1, static_cast<int>(std::ceil((x.high - x.low) / kMostLabels)));
    for (int e = static_cast<int>(x.low); e <= static_cast<int>(x.high); ++e) {
        const double at = x.at(std::pow(10.0, e));
        painter.setPen(faint);
        painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
        painter.setPen(ink);
        const double room = 2 * line + 30;
        const double from = std::min(at - room / 2, width() - room);
        if ((e - static_cast<int>(x.low)) % step == 0)
            painter.drawText(QRectF(from, area.bottom() + kGap, room, line), Qt::AlignCenter, powerOfTen(e));
    }
    for (int e = static_cast<int>(y.low); e <= static_cast<int>(y.high); ++e) {
        const double at = y.at(std::pow(10.0, e));
        painter.setPen(faint);
        painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
        painter.setPen(ink);
        const double top = std::clamp(at - line / 2, 0.0, area.bottom() - line / 2);
        painter.drawText(QRectF(0, top, area.left() - kGap, line), Qt::AlignRight | Qt::AlignVCenter, powerOfTen(e));
    }
    painter.drawText(QRectF(0, height() - line - kGap, area.right(), line), Qt::AlignRight,
                     tr("Time of the whole picture, s"));
    painter.save();
    painter.translate(0, area.bottom());
    painter.rotate(-90);
    painter.drawText(QRectF(0, kGap / 2, area.height(), line), Qt::AlignRight, metricName(study_->metric));
    painter.restore();
}

void AccuracyChart::paintTolerances(QPainter& painter, const Axis& y) const {
    const bool dark = palette().color(QPalette::Base).lightness() < 128;
    const QColor gold = dark ? QColor(0xe0bd4a) : QColor(0x8a6d00);
    const QRectF area = field();
    const double line = QFontMetricsF(font()).height();
    double lastTop = -line;
    for (const accuracy::NamedTolerance& named : accuracy::namedTolerances()) {
        const double logarithm = std::log10(named.tolerance.value);
        if (named.tolerance.metric != study_->metric || logarithm > y.high || logarithm < y.low)
            continue;
        const double at = y.at(named.tolerance.value);
        painter.setPen(QPen(gold, 1, Qt::DotLine));
        painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
        painter.setPen(gold);
        const double top = std::max(at - line, lastTop + line); // names do not lie on each other
        painter.drawText(QRectF(area.left() + kGap, top, area.width(), line), Qt::AlignLeft | Qt::AlignBottom,
                         toleranceName(named.tolerance));
        lastTop = top;
    }
}

void AccuracyChart::paintLine(QPainter& painter, const std::vector<std::size_t>& rows) const {
    QPolygonF places;
    for (const std::size_t row : rows)
        places << placeOf(row);
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(places);
}

void AccuracyChart::paintSeries(QPainter& painter) const {
    constexpr double kKey = 18; // length of a line in the legend
    const bool dark = palette().color(QPalette::Base).lightness() < 128;
    const QRectF area = field();
    const QFontMetricsF metrics(font());
    double top = area.top() + kGap;
    for (std::size_t i = 0; i < study_->series.size(); ++i, top += metrics.height()) {
        const accuracy::StudySeries& series = study_->series[i];
        const QColor colour = seriesColour(i, dark);
        painter.setPen(QPen(colour, 2));
        paintLine(painter, series.rows);
        const QString words =
            series.ordered
                ? tr("%1, order %2").arg(methodWords(series.method), QLocale().toString(series.order, 'f', 1))
                : methodWords(series.method);
        const double left = area.right() - kGap - metrics.horizontalAdvance(words);
        painter.drawLine(QPointF(left - kGap - kKey, top + metrics.height() / 2),
                         QPointF(left - kGap, top + metrics.height() / 2));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QPointF(left, top + metrics.ascent()), words);
    }
}

void AccuracyChart::paintPresent(QPainter& painter) const {
    constexpr double kRing = 5.5;
    const QPointF place = placeOf(study_->present);
    const bool dark = palette().color(QPalette::Base).lightness() < 128;
    const QColor red = dark ? QColor(0xff8080) : QColor(0xc00000);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(red, 2));
    painter.drawEllipse(place, kRing, kRing);
    const QString words = tr("As it is");
    const double wide = QFontMetricsF(font()).horizontalAdvance(words);
    const double right = place.x() + kRing + kGap;
    const double left = right + wide > field().right() ? place.x() - kRing - kGap - wide : right;
    painter.drawText(QPointF(left, place.y() - kGap), words);
}

bool AccuracyChart::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const auto row = rowAt(help->pos())) {
        const accuracy::StudyRow& at = study_->rows[*row];
        QToolTip::showText(help->globalPos(),
                           tr("%1: %2 in %3")
                               .arg(settingsWords(at.measured.quality), errorWords(errorOf(*row), study_->metric),
                                    secondsWords(at.pictureSeconds)));
    } else {
        QToolTip::hideText();
    }
    return true;
}

} // namespace limner
