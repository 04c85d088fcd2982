#include "widgets/figure_preview.h"

#include "core/figure/figure.h"
#include "widgets/picture_feed.h"
#include "widgets/sheet_painting.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr double kMargin = 8;

} // namespace

FigurePreview::FigurePreview(PictureFeed* feed, QWidget* parent) : QWidget(parent), feed_(feed) {
    feed_->setParent(this);
    setAccessibleName(tr("The figure in this style"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(feed_, &PictureFeed::arrived, this, [this](const ScreenPicture& arrived) {
        if (!figure_)
            return;
        picture_ = arrived.image;
        upToDate_ = arrived.plan->figure->styles == figure_->styles && arrived.plan->figure->layers == figure_->layers;
        update();
    });
    connect(feed_, &PictureFeed::failed, this, [this](const Error& error) {
        picture_ = {};
        setWords(QString::fromUtf8(error.what()));
    });
}

void FigurePreview::setFigure(std::shared_ptr<const Figure> figure, bool draftsOnly) {
    figure_ = std::move(figure);
    draftsOnly_ = draftsOnly;
    upToDate_ = false;
    want();
}

void FigurePreview::setWords(const QString& whileEmpty) {
    words_ = whileEmpty;
    setAccessibleDescription(whileEmpty);
    update();
}

void FigurePreview::want() {
    if (!figure_) {
        feed_->clear();
        picture_ = {};
        update();
        return;
    }
    const double aspect = std::clamp(figure_->output.widthMm / std::max(figure_->output.heightMm, 1e-6), 0.1, 10.0);
    const QSizeF room = QSizeF(size()) - QSizeF(2 * kMargin, 2 * kMargin);
    const QSizeF fitted = QSizeF(aspect, 1).scaled(room.expandedTo({8, 8}), Qt::KeepAspectRatio);
    feed_->want(figure_, (fitted * devicePixelRatioF()).toSize().expandedTo({4, 4}), draftsOnly_);
}

void FigurePreview::resizeEvent(QResizeEvent*) {
    if (figure_)
        want();
}

void FigurePreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.fillRect(rect(), deskColour(palette()));
    if (picture_.isNull()) {
        painter.setPen(palette().color(QPalette::Window).lightness() > 127 ? QColor(0x30, 0x34, 0x3a)
                                                                           : QColor(0xe2, 0xe4, 0xe8));
        painter.drawText(QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin),
                         Qt::AlignCenter | Qt::TextWordWrap, words_);
        return;
    }
    const QSizeF room = QSizeF(size()) - QSizeF(2 * kMargin, 2 * kMargin);
    const QSizeF fitted = QSizeF(picture_.size()).scaled(room, Qt::KeepAspectRatio);
    const QRectF sheet(QPointF((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted);
    paintShadow(painter, sheet);
    if (picture_.hasAlphaChannel())
        paintChecks(painter, sheet);
    painter.drawImage(sheet, picture_);
}

} // namespace limner
