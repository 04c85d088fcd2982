#include "widgets/annotation_overlay.h"

#include "core/figure/annotation_edits.h"
#include "renderer/annotations.h"
#include "widgets/viewport.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>

#include <utility>

namespace limner {
namespace {

constexpr double kGrab = 8;        // pixels around a label's dot
constexpr double kHandle = 4.5;    // radius, pixels
constexpr double kStillAClick = 3; // pixels

} // namespace

AnnotationOverlay::AnnotationOverlay(Viewport* viewport) : QWidget(viewport), viewport_(viewport) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus); // the panel's list is the way for the keyboard
    viewport->installEventFilter(this);
    viewport->setMouseTracking(true); // for the pointer's shape over handles
    setGeometry(viewport->rect());
    hide();
}

void AnnotationOverlay::setFigure(std::shared_ptr<const Figure> figure) {
    figure_ = std::move(figure);
    if (selected_ && (!figure_ || *selected_ >= figure_->annotations.size()))
        selected_.reset();
    setVisible(active_ && figure_);
    update();
}

void AnnotationOverlay::setActive(bool active) {
    active_ = active;
    dragged_ = {};
    viewport_->unsetCursor();
    setVisible(active_ && figure_);
}

void AnnotationOverlay::select(std::optional<std::size_t> index) {
    selected_ = index;
    update();
}

const AnnotationPlace* AnnotationOverlay::placeOf(std::size_t index) const {
    const auto& picture = viewport_->picture();
    if (!figure_ || !picture || picture->annotations.size() != figure_->annotations.size() ||
        index >= picture->annotations.size() || !picture->annotations[index].drawn)
        return nullptr;
    return &picture->annotations[index];
}

QPointF AnnotationOverlay::toWidget(const glm::dvec2& mm) const {
    const Output& output = viewport_->picture()->plan->figure->output;
    return viewport_->onScreen(mm / glm::dvec2(output.widthMm, output.heightMm));
}

glm::dvec2 AnnotationOverlay::toFigure(QPointF position) const { return viewport_->onFigure(position); }

std::optional<QPointF> AnnotationOverlay::middleOf(std::size_t index) const {
    const AnnotationPlace* place = placeOf(index);
    if (!place)
        return std::nullopt;
    return toWidget((place->box.lowMm + place->box.highMm) / 2.0);
}

std::optional<QPointF> AnnotationOverlay::pointOf(std::size_t index) const {
    const AnnotationPlace* place = placeOf(index);
    if (!place || !place->anchorMm)
        return std::nullopt;
    return toWidget(*place->anchorMm);
}

AnnotationOverlay::Hit AnnotationOverlay::hitAt(QPointF position) const {
    if (!active_ || !figure_)
        return {};
    const std::size_t count = figure_->annotations.size();
    for (std::size_t i = count; i-- > 0;)
        if (const auto point = pointOf(i); point && QLineF(*point, position).length() <= kGrab)
            return {Part::point, i};
    for (std::size_t i = count; i-- > 0;) {
        const AnnotationPlace* place = placeOf(i);
        if (place && QRectF(toWidget(place->box.lowMm), toWidget(place->box.highMm)).contains(position))
            return {Part::words, i};
    }
    return {};
}

bool AnnotationOverlay::press(QPointF position) {
    dragged_ = hitAt(position);
    if (dragged_.part == Part::none)
        return false;
    viewport_->setFocus(Qt::MouseFocusReason);
    moved_ = false;
    pressed_ = position;
    const AnnotationPlace* place = placeOf(dragged_.index);
    grab_ = place->at - toFigure(position);
    key_.begin(dragged_.part == Part::words ? "annotation/place" : "annotation/point");
    select(dragged_.index);
    Q_EMIT chosen(dragged_.index);
    return true;
}

void AnnotationOverlay::movePoint(Figure& figure, QPointF position) const {
    if (const auto pick = viewport_->pickAt(position))
        figure.annotations[dragged_.index].anchorMm = pick->pointMm;
}

void AnnotationOverlay::drag(QPointF position, bool ongoing) {
    if (!figure_ || dragged_.index >= figure_->annotations.size() || !viewport_->picture())
        return;
    if (!moved_ && QLineF(pressed_, position).length() < kStillAClick)
        return;
    moved_ = true;
    const bool words = dragged_.part == Part::words;
    Edit edit{*figure_, (words ? tr("Move lettering") : tr("Move label's point")).toStdString(),
              key_.during(words ? "annotation/place" : "annotation/point"), ongoing};
    if (words)
        placeAnnotation(edit.figure, dragged_.index, toFigure(position) + grab_);
    else
        movePoint(edit.figure, position);
    Q_EMIT edited(edit);
}

bool AnnotationOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched != viewport_)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::Resize)
        setGeometry(viewport_->rect());
    if (!active_ || !figure_)
        return QWidget::eventFilter(watched, event);
    auto* mouse = static_cast<QMouseEvent*>(event);
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        return mouse->button() == Qt::LeftButton && mouse->modifiers() == Qt::NoModifier && press(mouse->position());
    case QEvent::MouseMove:
        if (dragged_.part != Part::none) {
            drag(mouse->position(), true);
            return true;
        }
        if (mouse->buttons() == Qt::NoButton)
            viewport_->setCursor(hitAt(mouse->position()).part == Part::none ? Qt::OpenHandCursor : Qt::SizeAllCursor);
        return false;
    case QEvent::MouseButtonRelease:
        if (dragged_.part == Part::none || mouse->button() != Qt::LeftButton)
            return false;
        drag(mouse->position(), false);
        dragged_ = {};
        return true;
    case QEvent::MouseButtonDblClick: {
        const Hit hit = hitAt(mouse->position());
        if (hit.part == Part::none)
            return false;
        dragged_ = {};
        Q_EMIT wordsWanted(hit.index);
        return true;
    }
    case QEvent::KeyPress:
        if (selected_ && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
            Q_EMIT removeWanted();
            return true;
        }
        return false;
    default: return QWidget::eventFilter(watched, event);
    }
}

void AnnotationOverlay::paintEvent(QPaintEvent*) {
    const AnnotationPlace* place = selected_ ? placeOf(*selected_) : nullptr;
    if (!place)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr double kAround = 3;
    const QRectF box =
        QRectF(toWidget(place->box.lowMm), toWidget(place->box.highMm)).adjusted(-kAround, -kAround, kAround, kAround);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    painter.drawRoundedRect(box, kAround, kAround);
    if (place->anchorMm) {
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawEllipse(toWidget(*place->anchorMm), kHandle, kHandle);
    }
}

} // namespace limner
