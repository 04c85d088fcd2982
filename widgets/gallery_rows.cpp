#include "widgets/gallery_rows.h"

#include "widgets/gallery_list.h"

#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limner {
namespace {

constexpr int kStar = 18;    // a side of its square
constexpr int kMargin = 4;   // around a ball
constexpr int kHeading = 26; // height
constexpr int kNoteInset = 10;

struct Cell {
    int ball;   ///< diameter
    int narrow; ///< no column is narrower
    bool named;
};

Cell cellOf(BallSize size) {
    switch (size) {
    case BallSize::small: return {36, 46, false}; // a name would be cut to a few letters
    case BallSize::large: return {84, 96, true};
    case BallSize::medium: break;
    }
    return {52, 68, true};
}

QPainterPath star(const QPointF& middle, double radius) {
    QPainterPath path;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::numbers::pi * (i / 5.0 - 0.5);
        const double r = i % 2 == 0 ? radius : radius * 0.45;
        const QPointF at = middle + r * QPointF(std::cos(angle), std::sin(angle));
        i == 0 ? path.moveTo(at) : path.lineTo(at);
    }
    path.closeSubpath();
    return path;
}

void paintStar(QPainter& painter, const QRectF& area, bool on) {
    // Light and dark rims, so that it is seen on any ball.
    painter.setPen(QPen(QColor(255, 255, 255, 230), 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    const QPainterPath path = star(area.center(), 6.5);
    painter.drawPath(path);
    painter.setPen(QPen(QColor(0x5a, 0x42, 0x00), 1));
    painter.setBrush(on ? QBrush(QColor(0xf0, 0xb4, 0x00)) : QBrush(QColor(255, 255, 255, 150)));
    painter.drawPath(path);
}

/// In at most two lines, the second one cut where the name is longer.
void paintName(QPainter& painter, const QRectF& area, const QString& name) {
    QTextOption centred(Qt::AlignHCenter | Qt::AlignTop);
    centred.setWrapMode(QTextOption::WordWrap);
    QTextLayout layout(name, painter.font());
    layout.setTextOption(centred);
    layout.beginLayout();
    QTextLine first = layout.createLine();
    first.setLineWidth(area.width());
    layout.endLayout();
    const QFontMetricsF metrics(painter.font());
    const QString rest = name.mid(first.textLength()).trimmed();
    const auto line = [&](const QString& text, double y) {
        painter.drawText(QRectF(area.left(), y, area.width(), metrics.height()), Qt::AlignHCenter | Qt::AlignTop,
                         metrics.elidedText(text, Qt::ElideRight, area.width()));
    };
    line(name.left(first.textLength()).trimmed(), area.top());
    line(rest, area.top() + metrics.lineSpacing());
}

void paintHeading(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) {
    const QRectF area = option.rect;
    const bool folded = index.data(GalleryRows::kFoldedRole).toBool();
    const QColor ink = option.palette.color(QPalette::Text);
    QColor line = ink;
    line.setAlpha(60);
    painter.setPen(line);
    painter.drawLine(QPointF(area.left() + 4, area.bottom() - 2.5), QPointF(area.right() - 4, area.bottom() - 2.5));
    const QPointF middle(area.left() + 10, area.center().y());
    QPainterPath arrow;
    if (folded)
        arrow.addPolygon(QPolygonF{middle + QPointF(-2, -4), middle + QPointF(3, 0), middle + QPointF(-2, 4)});
    else
        arrow.addPolygon(QPolygonF{middle + QPointF(-4, -2), middle + QPointF(4, -2), middle + QPointF(0, 3)});
    painter.fillPath(arrow, ink);
    QFont bold = option.font;
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(ink);
    painter.drawText(area.adjusted(20, 0, -4, -2), Qt::AlignLeft | Qt::AlignVCenter, index.data().toString());
    if (option.state & QStyle::State_HasFocus) {
        painter.setPen(QPen(option.palette.color(QPalette::Highlight), 1.5));
        painter.drawRoundedRect(area.adjusted(1, 1, -1, -3), 3, 3);
    }
}

void paintNote(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) {
    painter.setPen(option.palette.color(QPalette::PlaceholderText));
    painter.drawText(QRectF(option.rect).adjusted(kNoteInset, 0, -kNoteInset, 0),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, index.data().toString());
}

} // namespace

GalleryRows::GalleryRows(GalleryList* list) : QStyledItemDelegate(list), list_(list) {}

QRect GalleryRows::starIn(const QRect& row) { return {row.right() - kStar, row.top() + 1, kStar, kStar}; }

QSize GalleryRows::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int width = std::max(48, list_->viewport()->width() - 2); // a row that fills all would be wrapped
    const auto kind = static_cast<GalleryList::Row>(index.data(GalleryList::kRowRole).toInt());
    if (kind == GalleryList::Row::heading)
        return {width, kHeading};
    if (kind == GalleryList::Row::note) {
        const QRect text = option.fontMetrics.boundingRect(QRect(0, 0, width - 2 * kNoteInset, 1000), Qt::TextWordWrap,
                                                           index.data().toString());
        return {width, text.height() + 12};
    }
    const Cell cell = cellOf(list_->ballSize());
    const int columns = std::max(1, width / cell.narrow);
    const int name = cell.named ? 2 * option.fontMetrics.lineSpacing() + 3 : 0; // many names have two words
    return {width / columns, cell.ball + 2 * kMargin + name};
}

void GalleryRows::paintStyle(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    const bool under = option.state.testFlag(QStyle::State_MouseOver);
    const QRectF box = QRectF(option.rect).adjusted(1, 1, -1, -1);
    const QColor accent = option.palette.color(QPalette::Highlight);
    if (chosen || under) { // colours are judged beside the background that the others have
        QColor back = accent;
        back.setAlpha(chosen ? 60 : 30);
        painter.setPen(chosen ? QPen(accent, 2) : QPen(Qt::NoPen));
        painter.setBrush(back);
        painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
    const Cell cell = cellOf(list_->ballSize());
    const std::string key = index.data(GalleryList::kKeyRole).toString().toStdString();
    const QPixmap ball = list_->ball(key, cell.ball);
    const QRectF place(option.rect.center().x() - cell.ball / 2.0 + 0.5, option.rect.top() + kMargin, cell.ball,
                       cell.ball);
    if (ball.isNull()) {
        painter.setPen(QPen(option.palette.color(QPalette::Mid), 1, Qt::DotLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(place.adjusted(2, 2, -2, -2));
    } else {
        painter.setPen(Qt::NoPen);
        painter.setBrush(Qt::white); // clear styles are seen as on paper
        painter.drawEllipse(place.adjusted(0.5, 0.5, -0.5, -0.5));
        painter.drawPixmap(place.topLeft(), ball);
    }
    if (cell.named) {
        painter.setPen(option.palette.color(QPalette::Text));
        paintName(painter,
                  QRectF(option.rect.left() + 2, place.bottom() + 1, option.rect.width() - 4,
                         2.0 * option.fontMetrics.lineSpacing()),
                  index.data().toString());
    }
    const bool favourite = index.data(GalleryList::kFavouriteRole).toBool();
    if (favourite || under)
        paintStar(painter, starIn(option.rect), favourite);
    if (option.state.testFlag(QStyle::State_HasFocus)) {
        painter.setPen(QPen(option.palette.color(QPalette::Text), 1, Qt::DotLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box.adjusted(2.5, 2.5, -2.5, -2.5), 3, 3);
    }
}

void GalleryRows::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    painter->setFont(option.font);
    switch (static_cast<GalleryList::Row>(index.data(GalleryList::kRowRole).toInt())) {
    case GalleryList::Row::heading: paintHeading(*painter, option, index); break;
    case GalleryList::Row::note: paintNote(*painter, option, index); break;
    case GalleryList::Row::style: paintStyle(*painter, option, index); break;
    }
    painter->restore();
}

} // namespace limner
