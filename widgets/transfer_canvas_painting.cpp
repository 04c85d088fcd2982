#include "core/style/transfer_function.h"
#include "widgets/transfer_canvas.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr double kRail = 34;  // height of the rail
constexpr double kLeft = 48;  // room for "100 %"
constexpr double kRight = 14; // a handle at the end stays whole
constexpr double kTop = 10;
constexpr double kPointRadius = 5;

double heightOf(std::uint64_t count, CountScale scale) {
    const auto voxels = static_cast<double>(count);
    switch (scale) {
    case CountScale::logarithmic: return std::log1p(voxels);
    case CountScale::root: return std::sqrt(voxels);
    case CountScale::linear: break;
    }
    return voxels;
}

/// What the tallest column stands for. The voxels of one value (air, padding) may be half of a scan: beside them, on a
/// linear scale, nothing else would be seen, so the very tallest columns are cut off there.
std::uint64_t tallest(std::vector<std::uint64_t> counts, CountScale scale) {
    if (scale == CountScale::logarithmic)
        return std::max<std::uint64_t>(1, *std::max_element(counts.begin(), counts.end()));
    const auto kept = counts.end() - std::max<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(counts.size()) / 100);
    std::nth_element(counts.begin(), kept, counts.end());
    return std::max<std::uint64_t>(1, *kept);
}

} // namespace

QRectF TransferCanvas::plot() const {
    return {kLeft, kTop, std::max(10.0, width() - kLeft - kRight),
            std::max(10.0, height() - kTop - kRail - kRuler - hintHeight())};
}

double TransferCanvas::railY() const { return plot().bottom() + kRail / 2 + 1; }

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
    paintRuler(painter, plot().bottom() + kRail);
    if (!transfer()) {
        paintNote(painter, tr("This layer's transfer function has two axes."));
        return;
    }
    painter.save();
    painter.setClipRect(plot().adjusted(-kPointRadius - 2, -kPointRadius - 2, kPointRadius + 2, kPointRadius + 2));
    paintCurve(painter);
    painter.restore();
    paintOpacities(painter);
    paintRail(painter);
    paintMark(painter, railY());
    paintFocus(painter);
}

void TransferCanvas::paintHistogram(QPainter& painter) const {
    if (!histogram_ || histogram_->counts.empty() || firstAxis(*anyTransfer()) != TransferAxis::value)
        return;
    const auto& counts = histogram_->counts;
    constexpr double kRoom = 0.92; // of the plot
    const double scale = plot().height() * kRoom / heightOf(tallest(counts, countScale_), countScale_);
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
        const double height = std::min(plot().height(), scale * heightOf(highest, countScale_));
        path.lineTo(plot().left() + column, plot().bottom() - height);
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
    paintFilling(painter);
    QPolygonF line;
    line << QPointF(plot().left(), yOf(t.opacity.front().y));
    for (std::size_t i = 0; i < t.opacity.size(); ++i) {
        const glm::dvec2& point = t.opacity[i];
        if (t.curve == OpacityCurve::step && i > 0)
            line << QPointF(xOf(point.x), yOf(t.opacity[i - 1].y));
        line << QPointF(xOf(point.x), yOf(point.y));
        if (t.curve != OpacityCurve::smooth || i + 1 == t.opacity.size())
            continue;
        const double end = std::min(xOf(t.opacity[i + 1].x), plot().right());
        for (double x = std::max(plot().left(), std::floor(xOf(point.x)) + 1); x < end; ++x)
            line << QPointF(x, yOf(curveOpacityAt(t, valueOf(x))));
    }
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

void TransferCanvas::paintFilling(QPainter& painter) const {
    const Transfer& t = *transfer();
    // What is drawn, in the colours it is drawn in.
    const int columns = static_cast<int>(plot().width());
    for (int column = 0; column < columns && !t.nodes.empty(); ++column) {
        const double value = valueOf(plot().left() + column + 0.5);
        const double opacity = curveOpacityAt(t, value);
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
}

void TransferCanvas::paintOpacities(QPainter& painter) const {
    const QColor ink = palette().color(QPalette::Text);
    QColor faint = ink;
    faint.setAlpha(90);
    for (const double opacity : {0.0, 0.5, 1.0}) {
        painter.setPen(faint);
        painter.drawLine(QPointF(plot().left() - 4, yOf(opacity)), QPointF(plot().left(), yOf(opacity)));
        painter.setPen(ink);
        painter.drawText(QRectF(0, yOf(opacity) - 10, plot().left() - 6, 20), Qt::AlignRight | Qt::AlignVCenter,
                         opacity == 1 ? tr("100 %") : QString::number(opacity * 100));
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
        paintBall(painter, t.nodes[i], centre, selected_ == Handle{HandleKind::node, i});
    }
    painter.restore();
    if (dropValue_) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2, Qt::DashLine));
        painter.drawLine(QPointF(xOf(*dropValue_), plot().top()), QPointF(xOf(*dropValue_), railY()));
    }
}

} // namespace limner
