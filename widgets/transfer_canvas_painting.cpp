#include "core/style/transfer_function.h"
#include "widgets/transfer_canvas.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr int kBall = 24;     // diameter of a style on the rail
constexpr double kRail = 34;  // height of the rail
constexpr double kRuler = 24; // height of the ruler
constexpr double kLeft = 48;  // room for "100 %"
constexpr double kRight = 14; // a handle at the end stays whole
constexpr double kTop = 10;
constexpr double kPointRadius = 5;

/// A step of 1, 2 or 5 times a power of ten, at least `least`.
double niceStep(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (power * factor >= least)
            return power * factor;
    return power * 10;
}

} // namespace

QString valueText(double value, double resolution) {
    const int decimals =
        resolution > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(resolution) - 1e-9)), 0, 9) : 0;
    const double zero = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value; // no "-0"
    return QLocale().toString(zero, 'f', decimals);
}

QRectF TransferCanvas::plot() const {
    return {kLeft, kTop, std::max(10.0, width() - kLeft - kRight), std::max(10.0, height() - kTop - kRail - kRuler)};
}

double TransferCanvas::railY() const { return plot().bottom() + kRail / 2 + 1; }

double TransferCanvas::xOf(double value) const {
    return plot().left() + (value - low_) / (high_ - low_) * plot().width();
}

double TransferCanvas::valueOf(double x) const { return low_ + (x - plot().left()) / plot().width() * (high_ - low_); }

double TransferCanvas::yOf(double opacity) const { return plot().bottom() - opacity * plot().height(); }

double TransferCanvas::opacityOf(double y) const { return (plot().bottom() - y) / plot().height(); }

std::optional<QPointF> TransferCanvas::positionOf(const Handle& handle) const {
    const Transfer* t = transfer();
    if (!t)
        return std::nullopt;
    if (handle.kind == HandleKind::point) {
        if (handle.index >= t->opacity.size())
            return std::nullopt;
        return QPointF(xOf(t->opacity[handle.index].x), yOf(t->opacity[handle.index].y));
    }
    if (handle.index >= t->nodes.size())
        return std::nullopt;
    return QPointF(xOf(t->nodes[handle.index].at), railY());
}

void TransferCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(plot(), palette().color(QPalette::Base));
    if (!figure_ || layer_ >= figure_->layers.size()) {
        paintNote(painter, tr("Select a layer to shape its opacity."));
        return;
    }
    paintHistogram(painter);
    paintRuler(painter);
    if (!transfer()) {
        paintNote(painter, tr("This layer's transfer function has two dimensions. It is kept as it is."));
        return;
    }
    painter.save();
    painter.setClipRect(plot().adjusted(-kPointRadius - 2, -kPointRadius - 2, kPointRadius + 2, kPointRadius + 2));
    paintCurve(painter);
    painter.restore();
    paintRail(painter);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(plot().adjusted(-0.5, -0.5, 0.5, 0.5));
    }
}

void TransferCanvas::paintNote(QPainter& painter, const QString& text) const {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(plot().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void TransferCanvas::paintHistogram(QPainter& painter) const {
    if (!histogram_ || histogram_->counts.empty())
        return;
    const auto& counts = histogram_->counts;
    std::uint64_t most = 1;
    for (const std::uint64_t count : counts)
        most = std::max(most, count);
    const double scale = plot().height() * 0.92 / std::log1p(static_cast<double>(most));
    const double bins = static_cast<double>(counts.size());
    const ValueRange range = histogram_->range;
    const double perValue = bins / std::max(range.high - range.low, 1e-300);
    QPainterPath path(QPointF(plot().left(), plot().bottom()));
    const int columns = static_cast<int>(plot().width());
    for (int column = 0; column <= columns; ++column) {
        const double from = (valueOf(plot().left() + column) - range.low) * perValue;
        const double to = (valueOf(plot().left() + column + 1) - range.low) * perValue;
        std::uint64_t highest = 0; // of the bins under this pixel
        for (double bin = std::floor(std::max(from, 0.0)); bin <= std::min(to, bins - 1); ++bin)
            highest = std::max(highest, counts[static_cast<std::size_t>(bin)]);
        path.lineTo(plot().left() + column, plot().bottom() - scale * std::log1p(static_cast<double>(highest)));
    }
    path.lineTo(plot().right(), plot().bottom());
    path.closeSubpath();
    QColor grey = palette().color(QPalette::Text);
    grey.setAlpha(46);
    painter.fillPath(path, grey);
}

void TransferCanvas::paintCurve(QPainter& painter) const {
    const Transfer& t = *transfer();
    if (t.opacity.empty()) {
        paintNote(painter, tr("Nothing shows yet. Double click to add an opacity point."));
        return;
    }
    // What is drawn, in the colours it is drawn in.
    const int columns = static_cast<int>(plot().width());
    for (int column = 0; column < columns && !t.nodes.empty(); ++column) {
        const double value = valueOf(plot().left() + column + 0.5);
        const double opacity = opacityAt(t.opacity, value);
        if (opacity <= 0)
            continue;
        const double index = nodeIndexAt(t.nodes, value);
        const auto first = static_cast<std::size_t>(index);
        const std::size_t second = std::min(first + 1, t.nodes.size() - 1);
        const QColor a = nodeColour(*figure_, t.nodes[first]);
        const QColor b = nodeColour(*figure_, t.nodes[second]);
        const double w = index - static_cast<double>(first);
        const auto mixed = [w](int x, int y) { return static_cast<int>(std::lround(x * (1 - w) + y * w)); };
        const QColor colour(mixed(a.red(), b.red()), mixed(a.green(), b.green()), mixed(a.blue(), b.blue()), 120);
        painter.fillRect(QRectF(plot().left() + column, yOf(opacity), 1, plot().bottom() - yOf(opacity)), colour);
    }
    QPolygonF line;
    line << QPointF(plot().left(), yOf(t.opacity.front().y));
    for (const glm::dvec2& point : t.opacity)
        line << QPointF(xOf(point.x), yOf(point.y));
    line << QPointF(plot().right(), yOf(t.opacity.back().y));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.6));
    painter.drawPolyline(line);
    for (std::size_t i = 0; i < t.opacity.size(); ++i) {
        const bool chosen = selected_ == Handle{HandleKind::point, i};
        painter.setBrush(palette().color(chosen ? QPalette::Highlight : QPalette::Base));
        painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
        const double radius = chosen ? kPointRadius + 1 : kPointRadius;
        painter.drawEllipse(QPointF(xOf(t.opacity[i].x), yOf(t.opacity[i].y)), radius, radius);
    }
}

void TransferCanvas::paintRail(QPainter& painter) {
    const Transfer& t = *transfer();
    painter.setPen(QPen(palette().color(QPalette::Mid), 2));
    painter.drawLine(QPointF(plot().left(), railY()), QPointF(plot().right(), railY()));
    painter.save();
    painter.setClipRect(QRectF(plot().left() - kBall, plot().bottom(), plot().width() + 2 * kBall, kRail + 4));
    for (std::size_t i = 0; i < t.nodes.size(); ++i) {
        const QPointF centre(xOf(t.nodes[i].at), railY());
        painter.drawPixmap(QRectF(centre - QPointF(kBall / 2.0, kBall / 2.0), QSizeF(kBall, kBall)),
                           balls_.ball(*figure_, t.nodes[i], kBall, devicePixelRatioF()),
                           QRectF(QPointF(), QSizeF(kBall, kBall) * devicePixelRatioF()));
        const bool chosen = selected_ == Handle{HandleKind::node, i};
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(chosen ? QPalette::Highlight : QPalette::Dark), chosen ? 2.5 : 1));
        painter.drawEllipse(centre, kBall / 2.0 + (chosen ? 1 : 0), kBall / 2.0 + (chosen ? 1 : 0));
    }
    painter.restore();
    if (dropValue_) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2, Qt::DashLine));
        painter.drawLine(QPointF(xOf(*dropValue_), plot().top()), QPointF(xOf(*dropValue_), railY()));
    }
}

void TransferCanvas::paintRuler(QPainter& painter) const {
    const QFontMetricsF metrics(painter.font());
    const QColor ink = palette().color(QPalette::Text);
    QColor faint = ink;
    faint.setAlpha(90);
    const double top = plot().bottom() + kRail;
    painter.setPen(faint);
    for (const double opacity : {0.0, 0.5, 1.0}) {
        painter.drawLine(QPointF(plot().left() - 4, yOf(opacity)), QPointF(plot().left(), yOf(opacity)));
        painter.setPen(ink);
        painter.drawText(QRectF(0, yOf(opacity) - 10, plot().left() - 6, 20), Qt::AlignRight | Qt::AlignVCenter,
                         opacity == 1 ? tr("100 %") : QString::number(opacity * 100));
        painter.setPen(faint);
    }
    painter.drawLine(QPointF(plot().left(), top), QPointF(plot().right(), top));
    const double room = metrics.horizontalAdvance(QStringLiteral("-00 000")) + 10;
    const double step = niceStep((high_ - low_) * room / plot().width());
    const double unitWidth = unit().isEmpty() ? 0 : metrics.horizontalAdvance(unit()) + 8;
    for (double tick = std::ceil(low_ / step) * step; tick <= high_; tick += step) {
        painter.setPen(faint);
        painter.drawLine(QPointF(xOf(tick), top), QPointF(xOf(tick), top + 4));
        const QString text = valueText(tick, step);
        const double half = metrics.horizontalAdvance(text) / 2;
        painter.setPen(ink);
        if (xOf(tick) + half < width() - unitWidth)
            painter.drawText(QRectF(xOf(tick) - half - 1, top + 4, 2 * half + 2, kRuler - 4), Qt::AlignCenter, text);
    }
    painter.drawText(QRectF(0, top + 4, width() - 4, kRuler - 4), Qt::AlignRight | Qt::AlignVCenter, unit());
}

} // namespace limner
