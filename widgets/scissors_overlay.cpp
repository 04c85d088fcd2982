#include "widgets/scissors_overlay.h"

#include "widgets/viewport.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr double kPointPixels = 3;   // from one point of a stroke to the next
constexpr double kStrokePixels = 30; // a hand that clicks shakes less, one that draws goes farther
constexpr double kLeastPixels2 = 25; // an outline that encloses less is a slip of the hand
constexpr int kMostPoints = 10000;   // of a lasso: far above any hand's patience

double areaOf(const QPolygonF& polygon) {
    double twice = 0;
    for (qsizetype i = 0; i < polygon.size(); ++i) {
        const QPointF a = polygon[i];
        const QPointF b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice) / 2;
}

double lengthOf(const QPolygonF& line) {
    double length = 0;
    for (qsizetype i = 1; i < line.size(); ++i)
        length += QLineF(line[i - 1], line[i]).length();
    return length;
}

} // namespace

ScissorsOverlay::ScissorsOverlay(Viewport* viewport) : ToolOverlay(viewport, tr("Scissors")) {}

void ScissorsOverlay::setFigure(std::shared_ptr<const Figure> figure) {
    const bool turned = this->figure() && figure && this->figure()->camera != figure->camera;
    if (turned) // the outline was about another picture
        reset();
    ToolOverlay::setFigure(std::move(figure));
}

void ScissorsOverlay::setSide(ScissorsSide side) {
    side_ = side;
    update();
}

void ScissorsOverlay::reset() {
    outline_.clear();
    strokeStart_ = 0;
    drawing_ = false;
    pointer_.reset();
    update();
}

QString ScissorsOverlay::hint() const {
    const QString side = side_ == ScissorsSide::inside ? tr("I: cut what is outside") : tr("I: cut what is inside");
    if (outline_.empty())
        return tr("Scissors: draw around what goes, or click corners · %1 · Esc: leave").arg(side);
    return tr("Enter or double click: cut · Backspace: one corner back · %1 · Esc: leave").arg(side);
}

void ScissorsOverlay::addPoint(QPointF position) {
    if (outline_.size() < kMostPoints)
        outline_.push_back(onFigure(position));
    update();
}

void ScissorsOverlay::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->setAccepted(begun()); // the middle button moves the view before there is an outline
        return;
    }
    drawing_ = true;
    strokeStart_ = outline_.size();
    addPoint(event->position());
}

void ScissorsOverlay::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->position();
    if (drawing_ && !outline_.empty() && QLineF(onScreen(outline_.back()), *pointer_).length() >= kPointPixels)
        addPoint(*pointer_);
    event->setAccepted(drawing_ || begun());
    update();
}

void ScissorsOverlay::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !std::exchange(drawing_, false))
        return;
    QPolygonF stroke;
    for (std::size_t i = strokeStart_; i < outline_.size(); ++i)
        stroke << onScreen(outline_[i]);
    if (lengthOf(stroke) < kStrokePixels)
        outline_.resize(strokeStart_ + 1); // a click: one corner, however the hand shook
    else if (strokeStart_ == 0)
        cut();
    update();
}

void ScissorsOverlay::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        cut();
}

void ScissorsOverlay::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter: cut(); break;
    case Qt::Key_Backspace:
        if (!drawing_ && !outline_.empty())
            outline_.pop_back();
        update();
        break;
    case Qt::Key_I: setSide(side_ == ScissorsSide::inside ? ScissorsSide::outside : ScissorsSide::inside); break;
    default:
        if (begun() && event->key() != Qt::Key_Escape)
            return; // the view must not turn under an outline
        ToolOverlay::keyPressEvent(event);
    }
}

void ScissorsOverlay::cut() {
    QPolygonF shown;
    for (const glm::dvec2& place : outline_)
        shown << onScreen(place);
    if (outline_.size() < 3 || areaOf(shown) < kLeastPixels2) {
        reset();
        return;
    }
    Edit edit{*figure(), tr("Cut with scissors").toStdString(), {}, false};
    CleanupStep& step = edit.figure.cleanup.emplace_back();
    step.kind = CleanupKind::scissors;
    step.polygon = outline_;
    step.camera = figure()->camera;
    step.aspect = figure()->output.aspect();
    step.side = side_;
    layDown();
    Q_EMIT edited(edit);
}

void ScissorsOverlay::paintTool(QPainter& painter) {
    if (outline_.empty())
        return;
    QPolygonF line;
    for (const glm::dvec2& place : outline_)
        line << onScreen(place);
    if (!drawing_ && pointer_)
        line << *pointer_;
    QPainterPath goes;
    goes.setFillRule(Qt::OddEvenFill); // as the cut counts an outline that crosses itself
    goes.addPolygon(line);
    if (side_ == ScissorsSide::outside)
        goes.addRect(viewport().sheet());
    painter.fillPath(goes, QColor(190, 40, 40, 60));
    const QColor light(255, 255, 255, 220); // a light line around a dark one is seen on any picture
    const QColor dark(0x1d, 0x2b, 0x45);
    painter.setPen(QPen(light, 3.5));
    painter.drawPolyline(line);
    painter.setPen(QPen(dark, 1.5));
    painter.drawPolyline(line);
    painter.setPen(QPen(dark, 1, Qt::DashLine)); // what will close it
    painter.drawLine(line.back(), line.front());
}

} // namespace limner
