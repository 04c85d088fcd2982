#include "widgets/colour_button.h"

#include <QColorDialog>
#include <QPainter>

#include <algorithm>

namespace limner {
namespace {

constexpr QSize kSwatch(36, 14);

} // namespace

QColor colourOf(const glm::dvec3& rgb) {
    const auto channel = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
    return QColor::fromRgbF(channel(rgb.r), channel(rgb.g), channel(rgb.b));
}

glm::dvec3 rgbOf(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

ColourButton::ColourButton(const QString& what, QWidget* parent) : QToolButton(parent) {
    setAccessibleName(what);
    setIconSize(kSwatch);
    setFocusPolicy(Qt::StrongFocus);
    setColour(rgb_);
    connect(this, &QToolButton::clicked, this, &ColourButton::ask);
}

void ColourButton::setColour(const glm::dvec3& rgb) {
    if (rgb_ == rgb && !icon().isNull())
        return;
    rgb_ = rgb;
    QPixmap swatch(kSwatch * devicePixelRatioF());
    swatch.setDevicePixelRatio(devicePixelRatioF());
    swatch.fill(colourOf(rgb));
    QPainter painter(&swatch);
    painter.setPen(palette().color(QPalette::Dark));
    painter.drawRect(QRectF(QPointF(0.5, 0.5), QSizeF(kSwatch) - QSizeF(1, 1)));
    painter.end();
    setIcon(swatch);
}

void ColourButton::ask() {
    const QColor colour = QColorDialog::getColor(colourOf(rgb_), this, accessibleName());
    if (colour.isValid())
        choose(colour);
}

void ColourButton::choose(const QColor& colour) { Q_EMIT chosen(rgbOf(colour)); }

} // namespace limner
