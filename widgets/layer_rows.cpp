#include "widgets/layer_rows.h"

#include <QDrag>
#include <QDropEvent>
#include <QHelpEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyledItemDelegate>
#include <QToolTip>

#include <algorithm>

namespace limner {
namespace {

constexpr int kSwitch = 22; // width of a switch
constexpr int kSwitches = 2 * kSwitch + 2;
constexpr int kRowHeight = 28;

QRect soloIn(const QRect& row) {
    return {row.right() - kSwitches + 1, row.top() + (row.height() - kSwitch) / 2, kSwitch, kSwitch};
}

QRect lockIn(const QRect& row) { return soloIn(row).translated(kSwitch, 0); }

void paintSolo(QPainter& painter, const QRectF& area, const QColor& ink, const QColor& paper, bool on) {
    const QRectF box = QRectF(0, 0, 14, 14).translated(area.center() - QPointF(7, 7));
    painter.setPen(QPen(ink, 1.2));
    painter.setBrush(on ? QBrush(ink) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(box, 3, 3);
    QFont letter = painter.font();
    letter.setPixelSize(10);
    letter.setBold(true);
    painter.setFont(letter);
    painter.setPen(on ? paper : ink);
    painter.drawText(box, Qt::AlignCenter, LayerRows::tr("S", "solo"));
}

/// A padlock, its shackle lifted where it is open.
void paintLock(QPainter& painter, const QRectF& area, const QColor& ink, bool on) {
    const QPointF middle = area.center();
    const double lift = on ? 0 : 2;
    const double side = on ? 0 : 4;
    QPainterPath shackle(middle + QPointF(-3 + side, 0));
    shackle.lineTo(middle + QPointF(-3 + side, -2 - lift));
    shackle.arcTo(QRectF(middle.x() - 3 + side, middle.y() - 5.5 - lift, 6, 7), 180, -180);
    if (on)
        shackle.lineTo(middle + QPointF(3, 0));
    painter.setPen(QPen(ink, 1.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shackle);
    painter.setBrush(on ? QBrush(ink) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(QRectF(middle.x() - 5, middle.y() - 0.5, 10, 7), 1.5, 1.5);
}

class RowDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyleOptionViewItem whole = option;
        initStyleOption(&whole, index);
        const QStyle* style = whole.widget->style();
        style->drawPrimitive(QStyle::PE_PanelItemViewItem, &whole, painter, whole.widget); // under the switches too
        QStyleOptionViewItem left = option;
        left.rect.setRight(option.rect.right() - kSwitches);
        QStyledItemDelegate::paint(painter, left, index);
        const bool chosen = option.state.testFlag(QStyle::State_Selected);
        const QColor full = option.palette.color(chosen ? QPalette::HighlightedText : QPalette::Text);
        QColor faint = full;
        faint.setAlpha(95);
        const QColor paper = option.palette.color(chosen ? QPalette::Highlight : QPalette::Base);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const bool solo = index.data(LayerRows::kSoloRole).toBool();
        const bool lock = index.data(LayerRows::kLockRole).toBool();
        paintSolo(*painter, soloIn(option.rect), solo ? full : faint, paper, solo);
        paintLock(*painter, lockIn(option.rect), lock ? full : faint, lock);
        painter->restore();
    }

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        return QStyledItemDelegate::sizeHint(option, index).expandedTo({0, kRowHeight});
    }

    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override {
        QStyleOptionViewItem left = option;
        left.rect.setRight(option.rect.right() - kSwitches);
        QStyledItemDelegate::updateEditorGeometry(editor, left, index);
    }
};

} // namespace

LayerRows::LayerRows(QWidget* parent) : QListWidget(parent) {
    setItemDelegate(new RowDelegate(this));
    setDragEnabled(true);
    setAcceptDrops(true);
    setDragDropMode(QAbstractItemView::DragDrop);
    setDragDropOverwriteMode(false);
    setDropIndicatorShown(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTextElideMode(Qt::ElideRight);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
}

QRect LayerRows::soloRect(int row) const { return soloIn(visualItemRect(item(row))); }

QRect LayerRows::lockRect(int row) const { return lockIn(visualItemRect(item(row))); }

bool LayerRows::pressSwitch(const QPoint& position) {
    const QListWidgetItem* under = itemAt(position);
    if (!under)
        return false;
    const int at = row(under);
    if (soloRect(at).contains(position))
        Q_EMIT soloClicked(at);
    else if (lockRect(at).contains(position))
        Q_EMIT lockClicked(at);
    else
        return false;
    return true;
}

void LayerRows::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !pressSwitch(event->position().toPoint()))
        QListWidget::mousePressEvent(event);
}

void LayerRows::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!pressSwitch(event->position().toPoint())) // two quick clicks are two clicks
        QListWidget::mouseDoubleClickEvent(event);
}

QMimeData* LayerRows::mimeData(const QList<QListWidgetItem*>& items) const {
    auto* mime = new QMimeData;
    if (!items.isEmpty())
        mime->setData(kMime, QByteArray::number(row(items.front())));
    return mime;
}

void LayerRows::startDrag(Qt::DropActions) {
    QListWidgetItem* dragged = currentItem();
    if (!dragged || !dragged->flags().testFlag(Qt::ItemIsDragEnabled))
        return;
    auto* drag = new QDrag(this);
    drag->setMimeData(mimeData({dragged}));
    drag->setPixmap(viewport()->grab(visualItemRect(dragged)));
    drag->exec(Qt::MoveAction); // the row itself stays: the figure says what the list shows
}

void LayerRows::dropEvent(QDropEvent* event) {
    setState(QAbstractItemView::NoState);
    viewport()->update();
    if (!event->mimeData()->hasFormat(kMime))
        return;
    const int from = event->mimeData()->data(kMime).toInt();
    const QListWidgetItem* under = itemAt(event->position().toPoint());
    int before = count(); // the row that the dragged one shall stand before
    if (under)
        before = row(under) + (event->position().y() > visualItemRect(under).center().y() ? 1 : 0);
    const int to = before > from ? before - 1 : before;
    event->acceptProposedAction();
    if (from >= 0 && from < count() && to != from)
        Q_EMIT moveWanted(from, to);
}

bool LayerRows::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        if (const QListWidgetItem* under = itemAt(help->pos())) {
            const int at = row(under);
            const bool locked = under->data(kLockRole).toBool();
            const QString text =
                soloRect(at).contains(help->pos()) ? tr("Solo: draw only this layer, and others that are solo")
                : lockRect(at).contains(help->pos())
                    ? (locked ? tr("Unlock the layer") : tr("Lock: keep the layer from being changed"))
                    : tr("The check mark shows or hides the layer; a double click renames it; drag to reorder");
            QToolTip::showText(help->globalPos(), text, this);
            return true;
        }
    }
    return QListWidget::viewportEvent(event);
}

} // namespace limner
