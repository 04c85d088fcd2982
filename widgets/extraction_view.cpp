#include "widgets/extraction_view.h"

#include "widgets/artwork_painting.h"
#include "widgets/artwork_plate.h"
#include "widgets/sheet_painting.h"
#include "widgets/style_image.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr double kMargin = 10;
constexpr double kFarthestLight = 0.95; // a light from beyond the rim would show no light
constexpr int kTilePixels = 256;        // a tile is looked at, not measured

/// A tint over the parts of the sphere's picture that had no votes.
QImage filledPartsOf(const Mask& covered) {
    QImage image(covered.width, covered.height, QImage::Format_ARGB32);
    for (int y = 0; y < covered.height; ++y)
        for (int x = 0; x < covered.width; ++x) {
            const double u = (x + 0.5) / covered.width * 2 - 1;
            const double v = (y + 0.5) / covered.height * 2 - 1;
            const bool stripe = ((x + y) * 24 / std::max(1, covered.width)) % 2 == 0; // seen without colour, too
            const bool filled = u * u + v * v <= 1 && !covered.has(x, y);
            image.setPixel(x, y, filled ? qRgba(214, 40, 90, stripe ? 150 : 70) : qRgba(0, 0, 0, 0));
        }
    return image;
}

QImage tileImage(const TextureTile& tile) {
    QImage image(tile.size(), tile.size(), QImage::Format_RGB32);
    const auto byte = [](float factor) {
        return static_cast<int>(std::lround(std::clamp(factor / 2, 0.0F, 1.0F) * 255));
    };
    for (int y = 0; y < tile.size(); ++y)
        for (int x = 0; x < tile.size(); ++x) {
            const Rgba& f = tile.pixels()[static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.size()) +
                                          static_cast<std::size_t>(x)];
            image.setPixel(x, y, qRgb(byte(f.r), byte(f.g), byte(f.b)));
        }
    return tile.size() > kTilePixels
               ? image.scaled(kTilePixels, kTilePixels, Qt::KeepAspectRatio, Qt::SmoothTransformation)
               : image;
}

} // namespace

ExtractionPictures picturesOf(std::shared_ptr<const Extraction> extraction, SpherePtr sphere) {
    ExtractionPictures pictures;
    pictures.sphere = std::move(sphere);
    if (extraction) {
        pictures.reshaded = imageOf(extraction->reshaded);
        pictures.difference = imageOf(extraction->difference);
        if (!extraction->covered.empty())
            pictures.filled = filledPartsOf(extraction->covered);
        if (extraction->texture)
            pictures.tile = tileImage(*extraction->texture);
    }
    pictures.extraction = std::move(extraction);
    return pictures;
}

ExtractionView::ExtractionView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Extracted style"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ExtractionView::setPictures(std::shared_ptr<const ExtractionPictures> pictures) {
    pictures_ = std::move(pictures);
    update();
}

void ExtractionView::setWords(const QString& whileEmpty) {
    words_ = whileEmpty;
    setAccessibleDescription(whileEmpty);
    update();
}

void ExtractionView::setShows(Shows shows) {
    shows_ = shows;
    update();
}

void ExtractionView::setShowsFilled(bool on) {
    showsFilled_ = on;
    update();
}

void ExtractionView::setLight(std::optional<glm::dvec2> towardsLight) {
    light_ = towardsLight;
    turning_ = turning_ && light_;
    setFocusPolicy(light_ ? Qt::StrongFocus : Qt::NoFocus);
    setCursor(light_ ? Qt::CrossCursor : Qt::ArrowCursor);
    setToolTip(light_ ? tr("Drag, or use the arrow keys, to turn the light") : QString());
    update();
}

QRectF ExtractionView::ballRect() const {
    const double side = std::max(8.0, std::min(width(), height()) - 2 * kMargin);
    return {(width() - side) / 2, (height() - side) / 2, side, side};
}

void ExtractionView::paintBall(QPainter& painter) {
    const QRectF where = ballRect();
    const int pixels = static_cast<int>(where.width() * devicePixelRatioF());
    if (ballOf_ != pictures_->sphere.get() || ball_.width() != pixels) {
        ball_ = styleBall(*pictures_->sphere, pixels);
        ballOf_ = pictures_->sphere.get();
    }
    if (pictures_->sphere->hasDirectionalOpacity()) {
        QPainterPath disk;
        disk.addEllipse(where);
        painter.save();
        painter.setClipPath(disk);
        paintChecks(painter, where);
        painter.restore();
    }
    painter.drawImage(where, ball_);
    if (showsFilled_ && !pictures_->filled.isNull())
        painter.drawImage(where, pictures_->filled);
    if (light_) {
        const QPointF at = where.center() + QPointF(light_->x, -light_->y) * (where.width() / 2);
        drawRoundHandle(painter, at, palette().color(QPalette::Highlight));
    }
}

void ExtractionView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.fillRect(rect(), deskColour(palette()));
    const QImage* picture = !pictures_                    ? nullptr
                            : shows_ == Shows::reshaded   ? &pictures_->reshaded
                            : shows_ == Shows::difference ? &pictures_->difference
                                                          : nullptr;
    if (pictures_ && shows_ == Shows::ball) {
        paintBall(painter);
    } else if (picture && !picture->isNull()) {
        const QSizeF room = QSizeF(size()) - QSizeF(2 * kMargin, 2 * kMargin);
        const QSizeF fitted = QSizeF(picture->size()).scaled(room, Qt::KeepAspectRatio);
        painter.drawImage(QRectF(QPointF((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted),
                          *picture);
    } else {
        painter.setPen(palette().color(QPalette::Window).lightness() > 127 ? QColor(0x30, 0x34, 0x3a)
                                                                           : QColor(0xe2, 0xe4, 0xe8));
        painter.drawText(QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         pictures_ ? tr("Picked colours have no region to compare with.") : words_);
    }
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void ExtractionView::turnLight(QPointF to, bool ongoing) {
    const QRectF ball = ballRect();
    const QPointF out = (to - ball.center()) / (ball.width() / 2);
    glm::dvec2 towards(out.x(), -out.y());
    const double length = glm::length(towards);
    if (length > kFarthestLight)
        towards *= kFarthestLight / length;
    Q_EMIT lightTurned(towards, key_.during("light"), ongoing);
}

void ExtractionView::mousePressEvent(QMouseEvent* event) {
    if (!light_ || shows_ != Shows::ball || event->button() != Qt::LeftButton)
        return;
    turning_ = true;
    key_.begin("light");
    turnLight(event->position(), true);
}

void ExtractionView::mouseMoveEvent(QMouseEvent* event) {
    if (turning_)
        turnLight(event->position(), true);
}

void ExtractionView::mouseReleaseEvent(QMouseEvent* event) {
    if (std::exchange(turning_, false))
        turnLight(event->position(), false);
}

void ExtractionView::keyPressEvent(QKeyEvent* event) {
    const double x = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    const double y = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (!light_ || (x == 0 && y == 0)) {
        QWidget::keyPressEvent(event);
        return;
    }
    constexpr double kStep = 0.05;
    glm::dvec2 towards = *light_ + glm::dvec2(x, y) * kStep;
    const double length = glm::length(towards);
    if (length > kFarthestLight)
        towards *= kFarthestLight / length;
    Q_EMIT lightTurned(towards, key_.again("light"), false);
}

} // namespace limner
