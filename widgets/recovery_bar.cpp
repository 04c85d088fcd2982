#include "widgets/recovery_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace limner {

RecoveryBar::RecoveryBar(QWidget* parent) : QFrame(parent), list_(new QVBoxLayout) {
    setObjectName("recovery");
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    setBackgroundRole(QPalette::Base); // it stands out from the grey around the sheet
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 8, 8, 8);
    layout->setSpacing(6);
    auto* title = new QLabel(tr("Limner ended without saving this. Do you want it back?"));
    QFont bold = font();
    bold.setBold(true);
    title->setFont(bold);
    auto* later = new QToolButton;
    later->setText(tr("Later"));
    later->setToolTip(tr("Hide this; it is offered again at the next start"));
    later->setAutoRaise(true);
    auto* head = new QHBoxLayout;
    head->addWidget(title, 1);
    head->addWidget(later);
    layout->addLayout(head);
    layout->addLayout(list_);
    connect(later, &QToolButton::clicked, this, &QWidget::hide);
    setVisible(false);
}

void RecoveryBar::setRows(const std::vector<Row>& rows) {
    while (QLayoutItem* item = list_->takeAt(0)) {
        if (item->widget())
            item->widget()->deleteLater(); // it may be the one whose button was pressed
        delete item;
    }
    count_ = static_cast<int>(rows.size());
    for (int i = 0; i < count_; ++i)
        list_->addWidget(makeRow(rows[static_cast<std::size_t>(i)], i));
    setVisible(count_ > 0);
}

QWidget* RecoveryBar::makeRow(const Row& row, int place) {
    constexpr int kThumbnail = 48;
    auto* widget = new QWidget;
    auto* layout = new QHBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    auto* picture = new QLabel;
    picture->setFixedSize(kThumbnail, kThumbnail);
    if (!row.thumbnail.isNull()) {
        const qreal ratio = devicePixelRatioF();
        QPixmap pixmap = QPixmap::fromImage(
            row.thumbnail.scaled(QSize(kThumbnail, kThumbnail) * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation));
        pixmap.setDevicePixelRatio(ratio);
        picture->setPixmap(pixmap);
        picture->setAlignment(Qt::AlignCenter);
    }
    auto* text = new QLabel(tr("<b>%1</b>, changed %2<br>%3")
                                .arg(row.name.toHtmlEscaped(), row.when.toHtmlEscaped(),
                                     row.place.isEmpty() ? tr("never saved") : row.place.toHtmlEscaped()));
    text->setMinimumWidth(1); // a long path must not widen the window
    auto* restore = new QPushButton(tr("Restore"));
    restore->setToolTip(tr("Open it as it was; it counts as changed until you save it"));
    restore->setAccessibleName(tr("Restore %1").arg(row.name));
    auto* discard = new QPushButton(tr("Discard"));
    discard->setToolTip(tr("Delete it for good"));
    discard->setAccessibleName(tr("Discard %1").arg(row.name));
    layout->addWidget(picture);
    layout->addWidget(text, 1);
    layout->addWidget(restore);
    layout->addWidget(discard);
    connect(restore, &QPushButton::clicked, this, [this, place] { Q_EMIT restoreWanted(place); });
    connect(discard, &QPushButton::clicked, this, [this, place] { Q_EMIT discardWanted(place); });
    return widget;
}

} // namespace limner
