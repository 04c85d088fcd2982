#include "core/figure/plane_view.h"
#include "core/style/transfer_function.h"
#include "widgets/style_image.h"
#include "widgets/transfer_canvas_2d.h"
#include "widgets/transfer_parts.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace limner {
namespace {

constexpr double kLeft = 56;  // room for the second ruler's numbers
constexpr double kRight = 16; // a ball at the end stays whole
constexpr double kTop = 14;
constexpr double kHandle = 4; // half of a handle

/// Colours of the grid's nodes, to be mixed at places.
class GridColours {
  public:
    GridColours(const TransferGrid* grid, std::vector<QColor> cells) : grid_(grid), cells_(std::move(cells)) {}

    [[nodiscard]] std::array<double, 3> at(const Transfer& transfer, const glm::dvec2& place) const {
        if (!grid_ || cells_.empty())
            return {128, 128, 128};
        const double x = gridIndexAt(grid_->x, place.x, firstAxis(transfer) == TransferAxis::label);
        const double y = gridIndexAt(grid_->y, place.y, secondAxis(transfer) == TransferAxis::label);
        const auto x0 = static_cast<std::size_t>(std::max(0.0, x));
        const auto y0 = static_cast<std::size_t>(std::max(0.0, y));
        const std::size_t x1 = std::min(x0 + 1, grid_->x.size() - 1);
        const std::size_t y1 = std::min(y0 + 1, grid_->y.size() - 1);
        const double wx = std::max(0.0, x) - static_cast<double>(x0);
        const double wy = std::max(0.0, y) - static_cast<double>(y0);
        std::array<double, 3> mixed{};
        const auto add = [&](std::size_t column, std::size_t row, double weight) {
            const QColor& colour = cells_[row * grid_->x.size() + column];
            mixed[0] += weight * colour.red();
            mixed[1] += weight * colour.green();
            mixed[2] += weight * colour.blue();
        };
        add(x0, y0, (1 - wx) * (1 - wy));
        add(x1, y0, wx * (1 - wy));
        add(x0, y1, (1 - wx) * wy);
        add(x1, y1, wx * wy);
        return mixed;
    }

  private:
    const TransferGrid* grid_;
    std::vector<QColor> cells_;
};

} // namespace

QRectF TransferCanvas2d::plot() const {
    return {kLeft, kTop, std::max(10.0, width() - kLeft - kRight),
            std::max(10.0, height() - kTop - kRuler - hintHeight() - 4)};
}

QString TransferCanvas2d::secondUnit() const {
    switch (transfer() ? *secondAxis(*transfer()) : TransferAxis::gradient) {
    case TransferAxis::value: return volume() ? QString::fromStdString(volume()->contents().unit) : QString();
    case TransferAxis::distance: return tr("mm");
    case TransferAxis::curvature: return tr("1/mm");
    default: return {};
    }
}

void TransferCanvas2d::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(plot(), palette().color(QPalette::Base));
    if (!transfer()) {
        paintNote(painter, tr("Select a layer to shape its opacity."));
        return;
    }
    painter.save();
    painter.setClipRect(plot());
    paintCounts(painter);
    paintOpacity(painter);
    for (std::size_t i = 0; i < transfer()->opacity2d.size(); ++i)
        paintOutline(painter, transfer()->opacity2d[i], selectedShape() == i);
    painter.restore();
    paintRuler(painter, plot().bottom() + 2);
    paintSecondRuler(painter);
    paintGrid(painter);
    paintHandles(painter);
    paintMark(painter, plot().bottom());
    paintCross(painter);
    if (paints() && plot().contains(pointer_)) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.2));
        painter.drawEllipse(pointer_, brush_.radius, brush_.radius);
    }
    paintFocus(painter);
}

void TransferCanvas2d::paintCounts(QPainter& painter) {
    if (!histogram_ || histogram_->counts.empty())
        return;
    QImage& image = counts_;
    const QRgb ink = palette().color(QPalette::Text).rgb();
    if (image.isNull()) {
        const double most = std::log1p(static_cast<double>(histogram_->greatest()));
        image = QImage(histogram_->columns, histogram_->rows, QImage::Format_ARGB32);
        for (int row = 0; row < histogram_->rows; ++row)
            for (int column = 0; column < histogram_->columns; ++column) {
                const double share = most > 0 ? std::log1p(static_cast<double>(histogram_->at(column, row))) / most : 0;
                constexpr double kDarkest = 190; // shapes and balls stand out before it
                image.setPixel(column, histogram_->rows - 1 - row,
                               qRgba(qRed(ink), qGreen(ink), qBlue(ink), static_cast<int>(kDarkest * share)));
            }
    }
    const QRectF place(QPointF(xOf(histogram_->x.low), yOf(histogram_->y.high)),
                       QPointF(xOf(histogram_->x.high), yOf(histogram_->y.low)));
    painter.setRenderHint(QPainter::SmoothPixmapTransform, place.width() < 4.0 * histogram_->columns);
    painter.drawImage(place, image);
}

void TransferCanvas2d::paintOpacity(QPainter& painter) {
    constexpr double kCoarse = 2; // pixels a cell: shapes are smooth, and a drag is to be fluent
    const QSize pixels(std::max(1, static_cast<int>(plot().width() / kCoarse)),
                       std::max(1, static_cast<int>(plot().height() / kCoarse)));
    const Transfer& t = *transfer();
    if (const Drawn wanted{t, shown(), pixels}; drawn_ != wanted) {
        std::vector<QColor> cells;
        for (std::size_t i = 0; t.grid && i < t.grid->x.size() * t.grid->y.size(); ++i)
            cells.push_back(nodeColour(*figure_, nodeOf(i)));
        const GridColours colours(t.grid ? &*t.grid : nullptr, std::move(cells));
        const std::vector<float> opacity = planeOpacity(t, shown(), {pixels.width(), pixels.height()});
        opacity_ = QImage(pixels, QImage::Format_ARGB32);
        for (int row = 0; row < pixels.height(); ++row) {
            auto* line = reinterpret_cast<QRgb*>(opacity_.scanLine(row));
            for (int column = 0; column < pixels.width(); ++column) {
                const float a = opacity[static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels.width()) +
                                        static_cast<std::size_t>(column)];
                constexpr float kStrongest = 125; // the counts below are still seen
                const glm::dvec2 place(x_.valueOf((column + 0.5) / pixels.width()),
                                       y_.valueOf(1 - (row + 0.5) / pixels.height()));
                const std::array<double, 3> rgb = a > 0 ? colours.at(t, place) : std::array<double, 3>{};
                line[column] = qRgba(static_cast<int>(rgb[0]), static_cast<int>(rgb[1]), static_cast<int>(rgb[2]),
                                     static_cast<int>(kStrongest * std::min(1.0F, a)));
            }
        }
        drawn_ = wanted;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform, true);
    painter.drawImage(plot(), opacity_);
}

void TransferCanvas2d::paintOutline(QPainter& painter, const OpacityShape& shape, bool chosen) const {
    const PlaneBox box = boxOf(shape);
    const QRectF rect = QRectF(positionAt({box.low.x, box.high.y}), positionAt({box.high.x, box.low.y}));
    QPainterPath path;
    if (shape.shape == "ellipse") {
        path.addEllipse(rect);
    } else if (shape.shape == "polygon") {
        QPolygonF polygon;
        for (std::size_t i = 0; i < std::min(shape.x.size(), shape.y.size()); ++i)
            polygon << positionAt({shape.x[i], shape.y[i]});
        path.addPolygon(polygon);
        path.closeSubpath();
    } else {
        path.addRect(rect);
        if (shape.shape == "trapezoid" && shape.x.size() == 4 && shape.y.size() == 4)
            path.addRect(QRectF(positionAt({shape.x[1], shape.y[2]}), positionAt({shape.x[2], shape.y[1]})));
    }
    painter.setBrush(Qt::NoBrush);
    QColor light = palette().color(QPalette::Base);
    light.setAlpha(200);
    painter.setPen(QPen(light, chosen ? 4 : 2.6)); // a halo, to be seen on dark counts and bright styles alike
    painter.drawPath(path);
    painter.setPen(QPen(palette().color(chosen ? QPalette::Highlight : QPalette::Text), chosen ? 1.8 : 1,
                        shape.shape == "mask" ? Qt::DashLine : Qt::SolidLine));
    painter.drawPath(path);
}

void TransferCanvas2d::paintHandles(QPainter& painter) const {
    const auto shape = selectedShape();
    if (!shape)
        return;
    const auto handles = handlesOf(transfer()->opacity2d[*shape]);
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const QPointF at = positionAt(handles[i].at);
        if (!plot().adjusted(-kHandle, -kHandle, kHandle, kHandle).contains(at))
            continue;
        const bool chosen = selected_ == Handle{HandleKind::corner, *shape, i};
        painter.setBrush(palette().color(chosen ? QPalette::Highlight : QPalette::Base));
        painter.setPen(QPen(palette().color(QPalette::Text), 1.2));
        painter.drawRect(QRectF(at - QPointF(kHandle, kHandle), QSizeF(2 * kHandle, 2 * kHandle)));
    }
}

void TransferCanvas2d::paintGrid(QPainter& painter) {
    const Transfer& t = *transfer();
    if (!t.grid)
        return;
    QColor line = palette().color(QPalette::Text);
    line.setAlpha(60);
    painter.setPen(QPen(line, 1, Qt::DotLine));
    for (const double x : t.grid->x)
        if (x >= x_.low() && x <= x_.high() && t.grid->x.size() * t.grid->y.size() > 1)
            painter.drawLine(QPointF(xOf(x), plot().top()), QPointF(xOf(x), plot().bottom()));
    for (const double y : t.grid->y)
        if (y >= y_.low() && y <= y_.high() && t.grid->x.size() * t.grid->y.size() > 1)
            painter.drawLine(QPointF(plot().left(), yOf(y)), QPointF(plot().right(), yOf(y)));
    for (std::size_t i = 0; i < t.grid->x.size() * t.grid->y.size(); ++i) {
        const Handle handle{HandleKind::node, i, 0};
        paintBall(painter, nodeOf(i), *positionOf(handle), selected_ == handle || dropNode_ == handle);
    }
}

void TransferCanvas2d::paintSecondRuler(QPainter& painter) const {
    const QFontMetricsF metrics(painter.font());
    const QColor ink = palette().color(QPalette::Text);
    QColor faint = ink;
    faint.setAlpha(90);
    const double step = niceStep(y_.width() * (metrics.height() * 2) / plot().height());
    for (double tick = std::ceil(y_.low() / step) * step; tick <= y_.high(); tick += step) {
        painter.setPen(faint);
        painter.drawLine(QPointF(plot().left() - 4, yOf(tick)), QPointF(plot().left(), yOf(tick)));
        painter.setPen(ink);
        painter.drawText(QRectF(14, yOf(tick) - 10, plot().left() - 20, 20), Qt::AlignRight | Qt::AlignVCenter,
                         valueText(tick, step));
    }
    painter.save();
    painter.translate(10, plot().center().y());
    painter.rotate(-90);
    const QString unitText = secondUnit().isEmpty() ? QString() : " (" + secondUnit() + ")";
    painter.drawText(QRectF(-plot().height() / 2, -9, plot().height(), 18), Qt::AlignCenter,
                     axisName(transfer()->axes[1]) + unitText);
    painter.restore();
}

void TransferCanvas2d::paintCross(QPainter& painter) const {
    if (!mark() || !mark()->y || *mark()->y < y_.low() || *mark()->y > y_.high())
        return;
    const QPointF at = positionAt({mark()->x, *mark()->y});
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5, Qt::DashLine));
    painter.drawLine(QPointF(plot().left(), at.y()), QPointF(plot().right(), at.y()));
    if (!plot().contains(at))
        return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Base), 4));
    painter.drawEllipse(at, 5, 5);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawEllipse(at, 5, 5);
}

} // namespace limner
