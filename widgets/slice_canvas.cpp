#include "widgets/slice_canvas.h"

#include "core/figure/camera_moves.h"
#include "core/style/transfer_function.h"
#include "widgets/sheet_painting.h"
#include "widgets/style_image.h"

#include <glm/geometric.hpp>

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr int kTints = 1024;          // finer than the greys of a screen
constexpr double kTintStrength = 0.6; // the scan stays readable under what the layers show
constexpr double kFitMargin = 1.06;
constexpr double kZoomPerClick = 0.85;
constexpr double kLeastMmPerPixel = 1e-6;
constexpr double kMostMmPerPixel = 1e4;
constexpr int kWheelClick = 120; // Qt's unit

QImage imageOf(const std::vector<float>& values, const SliceRequest& request, const SliceLook& look) {
    QImage image(request.pixels.x, request.pixels.y, QImage::Format_RGB32);
    const double width = std::max(look.window.high - look.window.low, 1e-300);
    const double tintWidth = std::max(look.tinted.high - look.tinted.low, 1e-300);
    const auto mixed = [](int below, int above, double share) {
        return static_cast<int>(std::lround(below + (above - below) * share));
    };
    for (int y = 0; y < request.pixels.y; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const float* row = values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(request.pixels.x);
        for (int x = 0; x < request.pixels.x; ++x) {
            if (std::isnan(row[x])) {
                line[x] = qRgb(0, 0, 0);
                continue;
            }
            const int grey =
                static_cast<int>(std::lround(255 * std::clamp((row[x] - look.window.low) / width, 0., 1.)));
            line[x] = qRgb(grey, grey, grey);
            if (look.tints.empty())
                continue;
            const double at = std::clamp((row[x] - look.tinted.low) / tintWidth, 0., 1.) * (kTints - 1);
            const QRgb tint = look.tints[static_cast<std::size_t>(std::lround(at))];
            const double share = kTintStrength * qAlpha(tint) / 255;
            line[x] =
                qRgb(mixed(grey, qRed(tint), share), mixed(grey, qGreen(tint), share), mixed(grey, qBlue(tint), share));
        }
    }
    return image;
}

/// A layer's colour with its opacity at a value; clear where it shows nothing.
QColor layerAt(const Figure& figure, const Layer& layer, double value) {
    const Transfer& t = layer.transfer;
    const double opacity = layer.opacity * opacityAt(t.opacity, value);
    if (opacity <= 0 || t.nodes.empty())
        return Qt::transparent;
    const auto node = static_cast<std::size_t>(std::lround(nodeIndexAt(t.nodes, value)));
    QColor colour = nodeColour(figure, t.nodes[std::min(node, t.nodes.size() - 1)]);
    colour.setAlphaF(static_cast<float>(std::clamp(opacity, 0., 1.)));
    return colour;
}

} // namespace

SliceLook sliceLook(const Figure& figure, const ValueRange& window) {
    SliceLook look{window, {}, {}};
    if (!figure.volume || !figure.volume->data)
        return look;
    look.tinted = figure.volume->data->range();
    look.tints.assign(kTints, 0);
    for (const Layer& layer : figure.layers) {
        if (!figure.draws(layer) || layer.transfer.kind != TransferKind::oneDimensional ||
            layer.transfer.axis != "value")
            continue;
        for (int i = 0; i < kTints; ++i) {
            const double value = look.tinted.low + (look.tinted.high - look.tinted.low) * i / (kTints - 1);
            const QColor colour = layerAt(figure, layer, value);
            QRgb& tint = look.tints[static_cast<std::size_t>(i)];
            if (colour.alpha() > qAlpha(tint)) // what is seen most of
                tint = colour.rgba();
        }
    }
    return look;
}

SliceCanvas::SliceCanvas(SlicePlane plane, QWidget* parent)
    : QWidget(parent), plane_(plane), axes_(sliceAxes(plane)), job_(new NewestJob(tr("Slice"), this)) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::CrossCursor);
    setAccessibleName(plane == SlicePlane::axial     ? tr("Axial slice")
                      : plane == SlicePlane::coronal ? tr("Coronal slice")
                                                     : tr("Sagittal slice"));
    setAccessibleDescription(tr("Arrow keys move the cross hairs by a voxel, Page Up and Page Down go to the next "
                                "slices, plus and minus zoom, Home fits."));
    setToolTip(tr("%1: click to go there, wheel for the next slice, Ctrl and wheel to zoom, Shift and drag to measure")
                   .arg(accessibleName()));
}

void SliceCanvas::setVolume(std::shared_ptr<const Volume> volume) {
    if (volume_ == volume)
        return;
    volume_ = std::move(volume);
    measureFrom_.reset();
    measureTo_.reset();
    picture_ = {};
    fitted_ = false;
    if (volume_)
        pointMm_ = volume_->grid().centreMm();
    wantPicture();
    update();
}

void SliceCanvas::setLook(const SliceLook& look) {
    if (look_ == look)
        return;
    look_ = look;
    wantPicture();
}

void SliceCanvas::setPoint(const glm::dvec3& pointMm) {
    if (pointMm_ == pointMm)
        return;
    const bool other = glm::dot(pointMm - pointMm_, axes_.through) != 0;
    pointMm_ = pointMm;
    if (other)
        wantPicture();
    update();
}

void SliceCanvas::fit() {
    if (!volume_)
        return;
    const Grid& grid = volume_->grid();
    middleMm_ = grid.centreMm();
    glm::dvec2 extent(0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 from = grid.mmFromVoxel(share * glm::dvec3(grid.dims) - 0.5) - middleMm_;
        extent = glm::max(extent, glm::abs(glm::dvec2(glm::dot(from, axes_.right), glm::dot(from, axes_.down))));
    }
    mmPerPixel_ = kFitMargin * 2 * std::max(extent.x / std::max(width(), 1), extent.y / std::max(height(), 1));
    mmPerPixel_ = std::clamp(mmPerPixel_, kLeastMmPerPixel, kMostMmPerPixel);
    fitted_ = true;
}

void SliceCanvas::wantPicture() {
    if (!volume_ || !isVisible())
        return;
    if (!fitted_)
        fit();
    const double scale = devicePixelRatioF();
    SliceRequest request;
    request.plane = plane_;
    request.middleMm = middleMm_ + axes_.through * glm::dot(pointMm_ - middleMm_, axes_.through);
    request.mmPerPixel = mmPerPixel_ / scale;
    request.pixels = {std::max(1, static_cast<int>(width() * scale)), std::max(1, static_cast<int>(height() * scale))};
    auto image = std::make_shared<QImage>();
    job_->want([image, request, volume = volume_,
                look = look_](Task& task) { *image = imageOf(sliceThrough(*volume, request, task), request, look); },
               [this, image, request, scale] {
                   picture_ = *image;
                   picture_.setDevicePixelRatio(scale);
                   pictureMiddleMm_ = request.middleMm;
                   pictureMmPerPixel_ = request.mmPerPixel * scale;
                   update();
               },
               NewestJob::Running::complete);
}

QPointF SliceCanvas::onScreen(const glm::dvec3& pointMm) const {
    const glm::dvec3 from = (pointMm - middleMm_) / mmPerPixel_;
    return QPointF(width() / 2.0 + glm::dot(from, axes_.right), height() / 2.0 + glm::dot(from, axes_.down));
}

glm::dvec3 SliceCanvas::pointAt(QPointF position) const {
    const glm::dvec3 middle = middleMm_ + axes_.through * glm::dot(pointMm_ - middleMm_, axes_.through);
    return middle +
           (axes_.right * (position.x() - width() / 2.0) + axes_.down * (position.y() - height() / 2.0)) * mmPerPixel_;
}

std::optional<double> SliceCanvas::measuredMm() const {
    if (!measureFrom_ || !measureTo_)
        return std::nullopt;
    return glm::length(*measureTo_ - *measureFrom_);
}

void SliceCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!volume_)
        return;
    if (!picture_.isNull()) { // of a moment ago, it is moved and scaled to where it belongs
        const double scale = pictureMmPerPixel_ / mmPerPixel_;
        const QSizeF size = QSizeF(picture_.size()) / picture_.devicePixelRatio() * scale;
        const QPointF middle = onScreen(pictureMiddleMm_);
        painter.setRenderHint(QPainter::SmoothPixmapTransform, scale != 1);
        painter.drawImage(QRectF(middle - QPointF(size.width(), size.height()) / 2, size), picture_);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    paintCross(painter);
    paintMeasure(painter);
    paintWords(painter);
}

void SliceCanvas::paintCross(QPainter& painter) const {
    constexpr double kGap = 7; // what lies at the point itself stays seen
    const QPointF at = onScreen(pointMm_);
    painter.setPen(QPen(QColor(255, 208, 64, 210), 1));
    painter.drawLine(QPointF(0, at.y()), QPointF(at.x() - kGap, at.y()));
    painter.drawLine(QPointF(at.x() + kGap, at.y()), QPointF(width(), at.y()));
    painter.drawLine(QPointF(at.x(), 0), QPointF(at.x(), at.y() - kGap));
    painter.drawLine(QPointF(at.x(), at.y() + kGap), QPointF(at.x(), height()));
}

void SliceCanvas::paintMeasure(QPainter& painter) const {
    const auto mm = measuredMm();
    if (!mm)
        return;
    const QPointF a = onScreen(*measureFrom_);
    const QPointF b = onScreen(*measureTo_);
    painter.setPen(QPen(QColor(96, 220, 255), 1.5));
    painter.drawLine(a, b);
    drawHaloText(painter, QRectF((a + b) / 2 - QPointF(60, 24), QSizeF(120, 20)), Qt::AlignCenter,
                 tr("%1 mm").arg(QLocale().toString(*mm, 'f', 1)));
}

void SliceCanvas::paintWords(QPainter& painter) const {
    const QRectF inside = QRectF(rect()).adjusted(5, 3, -5, -3);
    painter.setPen(QColor(235, 235, 235));
    const auto letter = [&](const glm::dvec3& direction, int where) {
        painter.drawText(inside, where, QString::fromStdString(directionLetters(direction)));
    };
    letter(-axes_.right, Qt::AlignLeft | Qt::AlignVCenter);
    letter(axes_.right, Qt::AlignRight | Qt::AlignVCenter);
    letter(-axes_.down, Qt::AlignTop | Qt::AlignHCenter);
    letter(axes_.down, Qt::AlignBottom | Qt::AlignHCenter);
    painter.setPen(QColor(200, 200, 200));
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignBottom,
                     tr("%1 mm").arg(QLocale().toString(glm::dot(pointMm_, axes_.through), 'f', 1)));
}

void SliceCanvas::resizeEvent(QResizeEvent*) {
    fitted_ = false;
    wantPicture();
}

void SliceCanvas::showEvent(QShowEvent*) { wantPicture(); }

void SliceCanvas::mousePressEvent(QMouseEvent* event) {
    if (!volume_ || event->button() != Qt::LeftButton)
        return;
    if (event->modifiers() & Qt::ShiftModifier) {
        measureFrom_ = measureTo_ = pointAt(event->position());
    } else {
        measureFrom_.reset();
        measureTo_.reset();
        Q_EMIT pointMoved(pointAt(event->position()));
    }
    update();
}

void SliceCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (!volume_ || !(event->buttons() & Qt::LeftButton))
        return;
    if (measureFrom_)
        measureTo_ = pointAt(event->position());
    else
        Q_EMIT pointMoved(pointAt(event->position()));
    update();
}

void SliceCanvas::step(const glm::dvec3& direction, double voxels) {
    if (!volume_)
        return;
    const double mm = voxels / std::max(glm::length(volume_->grid().mmToVoxelMatrix() * direction), 1e-12);
    Q_EMIT pointMoved(pointMm_ + direction * mm);
}

void SliceCanvas::zoomAt(QPointF position, double factor) {
    const glm::dvec3 held = pointAt(position);
    mmPerPixel_ = std::clamp(mmPerPixel_ * factor, kLeastMmPerPixel, kMostMmPerPixel);
    middleMm_ += held - pointAt(position);
    wantPicture();
    update();
}

void SliceCanvas::wheelEvent(QWheelEvent* event) {
    const double clicks = static_cast<double>(event->angleDelta().y()) / kWheelClick;
    if (!volume_ || clicks == 0)
        return;
    event->accept();
    if (event->modifiers() & Qt::ControlModifier)
        zoomAt(event->position(), std::pow(kZoomPerClick, clicks));
    else
        step(axes_.through, clicks);
}

void SliceCanvas::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left: step(axes_.right, -1); break;
    case Qt::Key_Right: step(axes_.right, 1); break;
    case Qt::Key_Up: step(axes_.down, -1); break;
    case Qt::Key_Down: step(axes_.down, 1); break;
    case Qt::Key_PageUp: step(axes_.through, 1); break;
    case Qt::Key_PageDown: step(axes_.through, -1); break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomAt(onScreen(pointMm_), kZoomPerClick); break;
    case Qt::Key_Minus: zoomAt(onScreen(pointMm_), 1 / kZoomPerClick); break;
    case Qt::Key_Home:
        fit();
        wantPicture();
        update();
        break;
    default: QWidget::keyPressEvent(event);
    }
}

} // namespace limner
