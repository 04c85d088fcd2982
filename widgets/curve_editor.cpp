#include "widgets/curve_editor.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <utility>

namespace limner {
namespace {

constexpr double kMargin = 8;
constexpr double kWords = 16; // height of the line below
constexpr double kPointRadius = 4.5;
constexpr double kGrab = 9;

} // namespace

CurveEditor::CurveEditor(QString axis, QWidget* parent) : QWidget(parent), axis_(std::move(axis)) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Curve over the %1").arg(axis_));
    setToolTip(tr("Drag a point to move it, double click for a new one; the right button or Delete removes a point"));
}

void CurveEditor::setPoints(const OpacityPoints& points) {
    if (points_ == points)
        return;
    points_ = points;
    if (selected_ && *selected_ >= points_.size())
        selected_.reset();
    dragging_ = dragging_ && selected_;
    update();
}

void CurveEditor::select(std::optional<std::size_t> point) {
    selected_ = point && *point < points_.size() ? point : std::nullopt;
    update();
}

QRectF CurveEditor::plot() const {
    return {kMargin, kMargin, std::max(10.0, width() - 2 * kMargin), std::max(10.0, height() - 2 * kMargin - kWords)};
}

QPointF CurveEditor::positionOf(glm::dvec2 point) const {
    return {plot().left() + point.x * plot().width(), plot().bottom() - point.y * plot().height()};
}

glm::dvec2 CurveEditor::placeOf(QPointF position) const {
    return {std::clamp((position.x() - plot().left()) / plot().width(), 0.0, 1.0),
            std::clamp((plot().bottom() - position.y()) / plot().height(), 0.0, 1.0)};
}

std::optional<std::size_t> CurveEditor::pointAt(QPointF position) const {
    std::optional<std::size_t> best;
    double nearest = kGrab * kGrab;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const QPointF d = positionOf(points_[i]) - position;
        const double distance = QPointF::dotProduct(d, d);
        if (distance < nearest || (distance == nearest && best)) { // of equal ones the last, which can go right
            best = i;
            nearest = distance;
        }
    }
    return best;
}

void CurveEditor::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = plot();
    painter.fillRect(area, palette().color(QPalette::Base));
    painter.setPen(QPen(palette().color(QPalette::Mid), 1, Qt::DotLine));
    for (const double share : {0.25, 0.5, 0.75}) {
        painter.drawLine(positionOf({share, 0}), positionOf({share, 1}));
        painter.drawLine(positionOf({0, share}), positionOf({1, share}));
    }
    painter.setPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Mid));
    painter.drawRect(area.adjusted(-0.5, -0.5, 0.5, 0.5));
    paintWords(painter);
    if (points_.empty())
        return;
    QPolygonF line;
    line << positionOf({0, points_.front().y});
    for (const glm::dvec2& point : points_)
        line << positionOf(point);
    line << positionOf({1, points_.back().y});
    QColor fill = palette().color(QPalette::Text);
    fill.setAlpha(28);
    QPolygonF below = line;
    below << positionOf({1, 0}) << positionOf({0, 0});
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(below);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.6));
    painter.drawPolyline(line);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const bool chosen = selected_ == i;
        painter.setBrush(palette().color(chosen ? QPalette::Highlight : QPalette::Base));
        painter.drawEllipse(positionOf(points_[i]), kPointRadius, kPointRadius);
    }
}

void CurveEditor::paintWords(QPainter& painter) const {
    painter.save();
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.88);
    painter.setFont(small);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const QRectF below(plot().left(), plot().bottom() + 5, plot().width(), kWords + kMargin - 5);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, tr("0"));
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignTop, axis_);
    painter.drawText(below, Qt::AlignRight | Qt::AlignTop, tr("1"));
    painter.restore();
}

void CurveEditor::mousePressEvent(QMouseEvent* event) {
    const auto point = pointAt(event->position());
    select(point);
    if (point && event->button() == Qt::RightButton) {
        removeSelected();
    } else if (point && event->button() == Qt::LeftButton) {
        dragging_ = true;
        moved_ = false;
        grabOffset_ = event->position() - positionOf(points_[*point]);
        gesture_.begin("curve/move");
    }
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging_ || !selected_)
        return;
    moved_ = true;
    moveSelected(placeOf(event->position() - grabOffset_), true);
}

void CurveEditor::mouseReleaseEvent(QMouseEvent*) {
    if (std::exchange(dragging_, false) && std::exchange(moved_, false) && selected_)
        moveSelected(points_[*selected_], false);
}

void CurveEditor::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || pointAt(event->position()))
        return;
    const AddedPoint added = withPointAdded(points_, placeOf(event->position()));
    Q_EMIT changed(added.points, tr("Add point"), {}, false);
    select(added.index);
}

void CurveEditor::keyPressEvent(QKeyEvent* event) {
    const int x = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    const int y = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (x != 0 && event->modifiers().testFlag(Qt::ControlModifier)) {
        if (!selected_)
            select(0);
        else if (x > 0 ? *selected_ + 1 < points_.size() : *selected_ > 0)
            select(*selected_ + static_cast<std::size_t>(x));
    } else if ((x != 0 || y != 0) && selected_) {
        const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.1 : 0.01;
        moveSelected(points_[*selected_] + glm::dvec2(x, y) * step, false);
    } else if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) {
        removeSelected();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void CurveEditor::moveSelected(glm::dvec2 to, bool ongoing) {
    to.x = std::clamp(to.x, 0.0, 1.0);
    Q_EMIT changed(withPointMoved(points_, *selected_, to), tr("Move point"), gesture_.again("curve/move"), ongoing);
}

void CurveEditor::removeSelected() {
    if (selected_ && points_.size() > 1)
        Q_EMIT changed(withPointRemoved(points_, *selected_), tr("Remove point"), {}, false);
}

} // namespace limner
