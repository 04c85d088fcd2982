#include "widgets/error_overlay.h"

#include "widgets/accuracy_words.h"
#include "widgets/viewport.h"

#include <QEvent>
#include <QLinearGradient>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

QImage imageOf(const Picture& picture) {
    QImage image(picture.size().x, picture.size().y, QImage::Format_RGBA8888_Premultiplied);
    for (int y = 0; y < image.height(); ++y) {
        const float* from = picture.pixel(0, y);
        uchar* to = image.scanLine(y);
        std::transform(from, from + 4L * image.width(), to, [](float channel) {
            return static_cast<uchar>(std::lround(255 * std::clamp(channel, 0.0F, 1.0F)));
        });
    }
    return image;
}

} // namespace

ErrorOverlay::ErrorOverlay(Viewport* viewport) : QWidget(viewport), viewport_(viewport) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Error of every pixel"));
    viewport->installEventFilter(this);
    setGeometry(viewport->rect());
    hide();
}

void ErrorOverlay::showMap(const Picture& map, double worst) {
    map_ = imageOf(map);
    worst_ = worst;
    setVisible(!map_.isNull());
    update();
}

void ErrorOverlay::clear() {
    map_ = {};
    hide();
}

void ErrorOverlay::paintEvent(QPaintEvent*) {
    constexpr double kInset = 8, kPad = 6, kLong = 120, kHigh = 10;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRectF sheet = viewport_->sheet();
    painter.drawImage(sheet, map_);
    const double line = QFontMetricsF(font()).height();
    const QSizeF size(kLong + 2 * kPad, 2 * line + kHigh + 2 * kPad);
    const QRectF plate(sheet.bottomRight() - QPointF(size.width() + kInset, size.height() + kInset), size);
    painter.setPen(QColor(0x80, 0x80, 0x80));
    painter.setBrush(QColor(255, 255, 255, 235));
    painter.drawRoundedRect(plate, 4, 4);
    const QRectF inside = plate.adjusted(kPad, kPad, -kPad, -kPad);
    const QRectF ramp(inside.left(), inside.top() + line, inside.width(), kHigh);
    QLinearGradient colours(ramp.topLeft(), ramp.topRight()); // as errorMap has them
    colours.setColorAt(0, QColor(255, 255, 0, 0));
    colours.setColorAt(0.25, QColor(255, 255, 0, 128));
    colours.setColorAt(0.5, QColor(255, 0, 0));
    colours.setColorAt(2.0 / 3, QColor(255, 0, 0));
    colours.setColorAt(1, Qt::black);
    painter.setBrush(colours);
    painter.drawRect(ramp);
    painter.setPen(Qt::black);
    painter.drawText(inside, Qt::AlignHCenter | Qt::AlignTop, tr("Error of the picture"));
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignBottom, errorWords(0, ErrorMetric::ciede2000));
    painter.drawText(inside, Qt::AlignRight | Qt::AlignBottom, errorWords(worst_, ErrorMetric::ciede2000));
}

bool ErrorOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == viewport_ && event->type() == QEvent::Resize)
        setGeometry(viewport_->rect());
    return QWidget::eventFilter(watched, event);
}

} // namespace limner
