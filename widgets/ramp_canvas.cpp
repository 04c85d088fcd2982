#include "widgets/ramp_canvas.h"

#include "widgets/colour_button.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr double kMargin = 8; // a key at an end stays whole
constexpr double kBarHeight = 22;
constexpr double kKeyWidth = 12;
constexpr double kKeyHeight = 16;
constexpr double kCheck = 5; // squares behind what is clear

QColor withOpacity(const glm::dvec4& rgba) {
    QColor colour = colourOf(glm::dvec3(rgba));
    colour.setAlphaF(static_cast<float>(std::clamp(rgba.a, 0.0, 1.0)));
    return colour;
}

} // namespace

RampCanvas::RampCanvas(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Colour ramp"));
    setToolTip(tr("Drag a key to move it, double click it for another colour, double click the ramp for a new key; the "
                  "right button or Delete removes a key"));
}

void RampCanvas::setKeys(const RampKeys& keys) {
    if (keys_ == keys)
        return;
    keys_ = keys;
    if (selected_ >= keys_.size())
        selected_ = keys_.empty() ? 0 : keys_.size() - 1;
    dragging_ = dragging_ && !keys_.empty();
    update();
}

void RampCanvas::select(std::size_t key) {
    if (key >= keys_.size())
        return;
    selected_ = key;
    update();
    Q_EMIT selectionChanged();
}

QRectF RampCanvas::bar() const { return {kMargin, 2, std::max(10.0, width() - 2 * kMargin), kBarHeight}; }

double RampCanvas::xOf(double at) const { return bar().left() + at * bar().width(); }

double RampCanvas::placeOf(double x) const { return std::clamp((x - bar().left()) / bar().width(), 0.0, 1.0); }

QPointF RampCanvas::positionOf(std::size_t key) const {
    return {xOf(keys_.at(key).at), bar().bottom() + 2 + kKeyHeight * 0.6};
}

std::optional<std::size_t> RampCanvas::keyAt(QPointF position) const {
    std::optional<std::size_t> best;
    double nearest = kKeyWidth * 0.75;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const double distance = std::abs(xOf(keys_[i].at) - position.x());
        if (position.y() < bar().bottom() - 2 || distance > nearest)
            continue;
        const bool same = best && keys_[*best].at == keys_[i].at;
        if (same && (*best == selected_ || position.x() < xOf(keys_[i].at)))
            continue; // left of a step its first key, right of it its last; a chosen one stays chosen
        best = i;
        nearest = distance;
    }
    return best;
}

void RampCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = bar();
    painter.save();
    painter.setClipRect(area);
    painter.fillRect(area, Qt::white);
    for (int row = 0; row * kCheck < area.height(); ++row)
        for (int column = row % 2; column * kCheck < area.width(); column += 2)
            painter.fillRect(QRectF(area.left() + column * kCheck, area.top() + row * kCheck, kCheck, kCheck),
                             QColor(0xd4, 0xd6, 0xd9));
    for (double x = 0; x < area.width(); ++x)
        painter.fillRect(QRectF(area.left() + x, area.top(), 1, area.height()),
                         withOpacity(rampAt(keys_, (x + 0.5) / area.width())));
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Dark));
    painter.drawRect(area.adjusted(-0.5, -0.5, 0.5, 0.5));
    for (std::size_t i = 0; i < keys_.size(); ++i)
        if (i != selected_)
            paintKey(painter, i);
    if (selected_ < keys_.size())
        paintKey(painter, selected_); // over its neighbours
    if (!isEnabled()) {
        QColor veil = palette().color(QPalette::Window);
        veil.setAlpha(150);
        painter.fillRect(rect(), veil);
    }
}

void RampCanvas::paintKey(QPainter& painter, std::size_t key) const {
    const double x = xOf(keys_[key].at);
    const double top = bar().bottom() + 2;
    const double half = kKeyWidth / 2;
    QPainterPath house(QPointF(x, top));
    house.lineTo(x + half, top + half);
    house.lineTo(x + half, top + kKeyHeight);
    house.lineTo(x - half, top + kKeyHeight);
    house.lineTo(x - half, top + half);
    house.closeSubpath();
    const bool chosen = key == selected_;
    painter.setBrush(colourOf(glm::dvec3(keys_[key].rgba)));
    painter.setPen(QPen(palette().color(chosen ? QPalette::Highlight : QPalette::Dark), chosen ? 2.2 : 1));
    painter.drawPath(house);
}

void RampCanvas::mousePressEvent(QMouseEvent* event) {
    const auto key = keyAt(event->position());
    if (key)
        select(*key);
    if (key && event->button() == Qt::RightButton) {
        removeSelected();
    } else if (key && event->button() == Qt::LeftButton) {
        dragging_ = true;
        moved_ = false;
        grabOffset_ = event->position().x() - xOf(keys_[*key].at);
        gesture_.begin("ramp/move");
    }
}

void RampCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging_ || selected_ >= keys_.size())
        return;
    moved_ = true;
    moveSelected(placeOf(event->position().x() - grabOffset_), true);
}

void RampCanvas::mouseReleaseEvent(QMouseEvent*) {
    if (std::exchange(dragging_, false) && std::exchange(moved_, false) && selected_ < keys_.size())
        moveSelected(keys_[selected_].at, false);
}

void RampCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto key = keyAt(event->position())) {
        select(*key);
        Q_EMIT colourWanted();
    } else {
        addKeyAt(placeOf(event->position().x()));
    }
}

void RampCanvas::keyPressEvent(QKeyEvent* event) {
    const bool arrow = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
    const int by = event->key() == Qt::Key_Left ? -1 : 1;
    if (arrow && event->modifiers().testFlag(Qt::ControlModifier)) {
        if (by > 0 || selected_ > 0)
            select(selected_ + static_cast<std::size_t>(by)); // past the last: stays
    } else if (arrow && selected_ < keys_.size()) {
        const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.1 : 0.01;
        moveSelected(keys_[selected_].at + by * step, false);
    } else if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) {
        removeSelected();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        Q_EMIT colourWanted();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void RampCanvas::moveSelected(double at, bool ongoing) {
    Q_EMIT changed(withKeyMoved(keys_, selected_, at), tr("Move key"), gesture_.again("ramp/move"), ongoing);
}

void RampCanvas::addKeyAt(double at) {
    const AddedKey added = withKeyAdded(keys_, at);
    Q_EMIT changed(added.keys, tr("Add key"), {}, false);
    select(added.index);
}

void RampCanvas::removeSelected() {
    if (keys_.size() > 1 && selected_ < keys_.size())
        Q_EMIT changed(withKeyRemoved(keys_, selected_), tr("Remove key"), {}, false);
}

} // namespace limner
