#include "widgets/transfer_plane.h"

#include "core/figure/layer_edits.h"
#include "core/style/transfer_function.h"
#include "widgets/style_mime.h"
#include "widgets/tissue_hints.h"

#include <QDropEvent>
#include <QFontMetricsF>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>

namespace limner {
namespace {

constexpr double kHints = 20; // height of the strip of hints

} // namespace

TransferPlane::TransferPlane(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAcceptDrops(true);
}

void TransferPlane::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) {
    figure_ = std::move(figure);
    layer_ = layer;
    update();
}

const Volume* TransferPlane::volume() const {
    return figure_ && figure_->volume ? figure_->volume->data.get() : nullptr;
}

const Transfer* TransferPlane::anyTransfer() const {
    return figure_ && layer_ < figure_->layers.size() ? &figure_->layers[layer_].transfer : nullptr;
}

QString TransferPlane::unit() const {
    const Transfer* t = anyTransfer();
    switch (t ? firstAxis(*t) : TransferAxis::value) {
    case TransferAxis::value: return volume() ? QString::fromStdString(volume()->contents().unit) : QString();
    case TransferAxis::distance: return tr("mm");
    case TransferAxis::curvature: return tr("1/mm");
    default: return {};
    }
}

bool TransferPlane::isHounsfield() const {
    const Transfer* t = anyTransfer();
    return t && firstAxis(*t) == TransferAxis::value && volume() && volume()->contents().unit == "HU";
}

double TransferPlane::hintHeight() const { return isHounsfield() ? kHints : 0; }

QRectF TransferPlane::hintStrip() const {
    return {plot().left(), height() - hintHeight(), plot().width(), hintHeight() - 2};
}

const TissueHint* TransferPlane::hintAt(QPointF position) const {
    return isHounsfield() ? tissueAt(hintStrip(), x_, position) : nullptr;
}

std::optional<QPointF> TransferPlane::positionOf(const TissueHint& hint) const {
    const double low = std::max(hint.range.low, x_.low());
    const double high = std::min(hint.range.high, x_.high());
    if (!isHounsfield() || low > high)
        return std::nullopt;
    return QPointF(xOf((low + high) / 2), hintStrip().center().y());
}

void TransferPlane::setMark(std::optional<Mark> mark) {
    if (mark == mark_)
        return;
    mark_ = mark;
    update();
}

void TransferPlane::showWhole() {
    if (!volume() || !anyTransfer() || firstAxis(*anyTransfer()) != TransferAxis::value) {
        showAll();
        return;
    }
    showValues(volume()->range());
}

void TransferPlane::showValues(ValueRange range) {
    constexpr double kMargin = 0.03;
    x_ = AxisView(range).widened(kMargin);
    update();
    Q_EMIT shownChanged();
}

void TransferPlane::zoomBy(double factor) { zoomAt(plot().center(), factor); }

void TransferPlane::zoomAt(QPointF position, double factor) {
    const bool values = anyTransfer() && firstAxis(*anyTransfer()) == TransferAxis::value && volume();
    const double whole = values ? volume()->range().high - volume()->range().low : x_.width();
    x_.zoom(valueOf(position.x()), factor, whole);
    update();
    Q_EMIT shownChanged();
}

void TransferPlane::wheelEvent(QWheelEvent* event) {
    if (!transfer())
        return;
    constexpr double kPerClick = 0.85;
    zoomAt(event->position(), std::pow(kPerClick, event->angleDelta().y() / 120.0));
    event->accept();
}

void TransferPlane::beginShift(QPointF position) {
    shiftFrom_ = position;
    shiftedX_ = x_;
}

void TransferPlane::shiftTo(QPointF position) {
    x_ = shiftedX_;
    x_.shift((shiftFrom_->x() - position.x()) / plot().width() * x_.width());
    update();
    Q_EMIT shownChanged();
}

bool TransferPlane::zoomKey(const QKeyEvent& event) {
    constexpr double kStep = 0.7;
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomBy(kStep); return true;
    case Qt::Key_Minus: zoomBy(1 / kStep); return true;
    case Qt::Key_Home: showAll(); return true;
    default: return false;
    }
}

bool TransferPlane::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QString text = handleTip(help->pos());
    if (const TissueHint* hint = hintAt(help->pos()); hint && text.isEmpty())
        text = tr("%1. A click shows it.").arg(tissueWords(*hint));
    QToolTip::showText(help->globalPos(), text.isEmpty() && transfer() ? advice() : text, this);
    return true;
}

std::shared_ptr<const Style> TransferPlane::droppedStyle(const QDropEvent& event) const {
    const std::string key = event.mimeData()->data(kStyleMime).toStdString();
    const bool may = styles_ && transfer() && mayChange(*figure_, layer_);
    return may ? styles_(key) : nullptr;
}

void TransferPlane::emitTransfer(const Transfer& changed, const QString& label, const std::string& key, bool ongoing) {
    if (!mayChange(*figure_, layer_))
        return;
    Edit edit{*figure_, label.toStdString(), key, ongoing};
    edit.figure.layers[layer_].transfer = changed;
    Q_EMIT edited(edit);
}

void TransferPlane::paintNote(QPainter& painter, const QString& text) const {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(plot().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void TransferPlane::paintFocus(QPainter& painter) const {
    if (!hasFocus())
        return;
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(plot().adjusted(-0.5, -0.5, 0.5, 0.5));
}

void TransferPlane::paintRuler(QPainter& painter, double top) const {
    const QFontMetricsF metrics(painter.font());
    const QColor ink = palette().color(QPalette::Text);
    QColor faint = ink;
    faint.setAlpha(90);
    painter.setPen(faint);
    painter.drawLine(QPointF(plot().left(), top), QPointF(plot().right(), top));
    const double room = metrics.horizontalAdvance(QStringLiteral("-00 000")) + 10;
    const double step = niceStep(x_.width() * room / plot().width());
    const double unitWidth = unit().isEmpty() ? 0 : metrics.horizontalAdvance(unit()) + 8;
    for (double tick = std::ceil(x_.low() / step) * step; tick <= x_.high(); tick += step) {
        painter.setPen(faint);
        painter.drawLine(QPointF(xOf(tick), top), QPointF(xOf(tick), top + 4));
        const QString text = valueText(tick, step);
        const double half = metrics.horizontalAdvance(text) / 2;
        painter.setPen(ink);
        if (xOf(tick) + half < width() - unitWidth)
            painter.drawText(QRectF(xOf(tick) - half - 1, top + 4, 2 * half + 2, kRuler - 4), Qt::AlignCenter, text);
    }
    painter.drawText(QRectF(0, top + 4, width() - 4, kRuler - 4), Qt::AlignRight | Qt::AlignVCenter, unit());
    if (isHounsfield())
        paintTissues(painter, palette(), hintStrip(), x_);
}

void TransferPlane::paintMark(QPainter& painter, double bottom) const {
    if (!mark_ || mark_->x < x_.low() || mark_->x > x_.high())
        return;
    const QColor ink = palette().color(QPalette::Highlight);
    const double x = xOf(mark_->x);
    painter.setPen(QPen(ink, 1.5, Qt::DashLine));
    painter.drawLine(QPointF(x, plot().top()), QPointF(x, bottom));
    const QString text =
        valueText(mark_->x, x_.width() / std::max(1.0, plot().width())) + (unit().isEmpty() ? QString() : " " + unit());
    const QFontMetricsF metrics(painter.font());
    QRectF tag(0, plot().top() + 2, metrics.horizontalAdvance(text) + 8, metrics.height() + 2);
    tag.moveLeft(std::clamp(x + 4, plot().left(), plot().right() - tag.width()));
    if (x + 4 + tag.width() > plot().right())
        tag.moveRight(x - 4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawRoundedRect(tag, 3, 3);
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(tag, Qt::AlignCenter, text);
}

void TransferPlane::paintBall(QPainter& painter, const TransferNode& node, QPointF centre, bool chosen) {
    painter.drawPixmap(QRectF(centre - QPointF(kBall / 2.0, kBall / 2.0), QSizeF(kBall, kBall)),
                       balls_.ball(*figure_, node, kBall, devicePixelRatioF()),
                       QRectF(QPointF(), QSizeF(kBall, kBall) * devicePixelRatioF()));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(chosen ? QPalette::Highlight : QPalette::Dark), chosen ? 2.5 : 1));
    painter.drawEllipse(centre, kBall / 2.0 + (chosen ? 1 : 0), kBall / 2.0 + (chosen ? 1 : 0));
}

} // namespace limner
