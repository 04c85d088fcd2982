#include "widgets/light_form.h"

#include "core/figure/light_frame.h"
#include "widgets/form_parts.h"

#include <glm/geometric.hpp>

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QRadialGradient>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace limner {
namespace {

constexpr double kRim = 8; // room around the ball for a light from behind
constexpr double kMark = 4;

} // namespace

LightBall::LightBall(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Direction of the light"));
    setToolTip(tr("Drag over the ball to move the light; outside its rim the light comes from behind"));
}

void LightBall::setDirection(const glm::dvec3& seen) {
    seen_ = seen;
    update();
}

double LightBall::radius() const { return std::min(width(), height()) / 2.0 - kRim; }

QPointF LightBall::positionOf(const glm::dvec3& seen) const {
    const double flat = std::hypot(seen.x, seen.y);
    // From the middle (the viewer's eye) to the rim (the side), and on over the border as it goes behind.
    const double angle = std::atan2(flat, seen.z) / (std::numbers::pi / 2);
    const double away = angle <= 1 ? std::sin(angle * std::numbers::pi / 2) * radius() : radius() + (angle - 1) * kRim;
    const double share = flat > 0 ? away / flat : 0;
    return {width() / 2.0 + seen.x * share, height() / 2.0 - seen.y * share};
}

glm::dvec3 LightBall::directionAt(QPointF position) const {
    const glm::dvec2 flat(position.x() - width() / 2.0, height() / 2.0 - position.y());
    const double away = glm::length(flat);
    if (away <= 0)
        return {0, 0, 1};
    const double quarter = std::numbers::pi / 2;
    const double angle =
        away <= radius() ? std::asin(away / radius()) : quarter * (1 + std::min(1.0, (away - radius()) / kRim));
    const glm::dvec2 side = flat / away * std::sin(angle);
    return {side.x, side.y, std::cos(angle)};
}

void LightBall::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle(width() / 2.0, height() / 2.0);
    const bool behind = seen_.z < 0;
    QRadialGradient shade(middle, radius() * 1.9, behind ? middle : positionOf(seen_));
    shade.setColorAt(0, behind ? QColor(0x62, 0x66, 0x6c) : QColor(0xfa, 0xf8, 0xf2));
    shade.setColorAt(0.5, behind ? QColor(0x58, 0x5c, 0x62) : QColor(0xb6, 0xb8, 0xbb));
    shade.setColorAt(1, QColor(0x50, 0x54, 0x5a));
    painter.setOpacity(isEnabled() ? 1 : 0.5);
    painter.setPen(QPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Dark), hasFocus() ? 1.6 : 1));
    painter.setBrush(shade);
    painter.drawEllipse(middle, radius(), radius());
    painter.setPen(QPen(palette().color(QPalette::Text), 1.2));
    painter.setBrush(behind ? QBrush(palette().color(QPalette::Window)) : QBrush(QColor(0xff, 0xdd, 0x66)));
    painter.drawEllipse(positionOf(seen_), kMark, kMark);
}

void LightBall::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    dragging_ = true;
    Q_EMIT moved(directionAt(event->position()), gesture_.begin("light/direction"), true);
}

void LightBall::mouseMoveEvent(QMouseEvent* event) {
    if (dragging_)
        Q_EMIT moved(directionAt(event->position()), gesture_.during("light/direction"), true);
}

void LightBall::mouseReleaseEvent(QMouseEvent* event) {
    if (std::exchange(dragging_, false))
        Q_EMIT moved(directionAt(event->position()), gesture_.again("light/direction"), false);
}

void LightBall::keyPressEvent(QKeyEvent* event) {
    constexpr double kNudge = 2; // pixels
    const double x = event->key() == Qt::Key_Right ? kNudge : event->key() == Qt::Key_Left ? -kNudge : 0;
    const double y = event->key() == Qt::Key_Down ? kNudge : event->key() == Qt::Key_Up ? -kNudge : 0;
    if (x == 0 && y == 0)
        QWidget::keyPressEvent(event);
    else
        Q_EMIT moved(directionAt(positionOf(seen_) + QPointF(x, y)), gesture_.again("light/direction"), false);
}

LightForm::LightForm(const std::string& pointer, QWidget* parent)
    : QWidget(parent), kind_(new QComboBox), ball_(new LightBall) {
    kind_->addItem(tr("With the viewer"), "head");
    kind_->addItem(tr("Fixed to the scan"), "object");
    kind_->setAccessibleName(labelOfSetting(pointer + "/kind"));
    kind_->setToolTip(helpOfSetting(pointer + "/kind"));
    leaveWheelToPanel(kind_);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(kind_, 1, Qt::AlignVCenter);
    row->addWidget(ball_);
    setFocusProxy(kind_);
    connect(kind_, &QComboBox::activated, this, [this](int index) {
        const std::string kind = kind_->itemData(index).toString().toStdString();
        Q_EMIT changed(lightToBeSeen(kind, lightSeen(light_, camera_), camera_), {}, false);
    });
    connect(ball_, &LightBall::moved, this, [this](const glm::dvec3& seen, const std::string& key, bool ongoing) {
        Q_EMIT changed(lightToBeSeen(light_.kind, seen, camera_), key, ongoing);
    });
}

void LightForm::setLight(const Light& light, const Camera& camera) {
    light_ = light;
    camera_ = camera;
    kind_->setCurrentIndex(kind_->findData(QString::fromStdString(light.kind)));
    ball_->setDirection(lightSeen(light, camera));
}

} // namespace limner
