#include "widgets/style_details.h"

#include "widgets/form_parts.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {
namespace {

constexpr int kBall = 72;
constexpr int kScan = 148; // beside the ball and its button in a dock of usual width

QString homeLine(const GalleryItem& item) {
    const QString origin = QString::fromStdString(item.card.origin);
    switch (item.home) {
    case StyleHome::mine: return origin.isEmpty() ? StyleDetails::tr("One of your own") : origin;
    case StyleHome::project: return StyleDetails::tr("Kept in this project only");
    case StyleHome::bundled: break;
    }
    return StyleDetails::tr("Comes with Limner; duplicate it to change its card");
}

/// A ball of that many pixels on a white disk, as on paper; null for a null one.
QPixmap onPaper(const QImage& ball, int size, double ratio) {
    if (ball.isNull())
        return {};
    const int pixels = static_cast<int>(size * ratio);
    QPixmap pixmap(pixels, pixels);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawEllipse(QRectF(pixmap.rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    painter.drawImage(0, 0, ball.scaled(pixels, pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    painter.end();
    pixmap.setDevicePixelRatio(ratio);
    return pixmap;
}

QWidget* row(std::initializer_list<QWidget*> widgets) {
    auto* holder = new QWidget;
    auto* layout = new QHBoxLayout(holder);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    for (QWidget* widget : widgets)
        layout->addWidget(widget);
    layout->addStretch(1);
    return holder;
}

} // namespace

StyleDetails::StyleDetails(QWidget* parent)
    : QWidget(parent), ball_(new QLabel), scan_(new QLabel),
      onScan_(
          textButton(tr("On the scan"), tr("Show how the scan would look in the style that is pointed at or chosen, "
                                           "put where a click would put it"))),
      home_(new QLabel), duplicate_(textButton(tr("Duplicate to mine"),
                                               tr("Make a copy among your own styles, whose card you can change"))),
      remove_(textButton(tr("Delete"), tr("Remove the style from your own (Delete). It can be brought back"))) {
    ball_->setFixedSize(kBall, kBall);
    ball_->setAccessibleName(tr("The style as a ball"));
    scan_->setFixedSize(kScan, kScan);
    scan_->setAlignment(Qt::AlignCenter);
    scan_->setWordWrap(true);
    scan_->setAccessibleName(tr("The scan in this style"));
    onScan_->setCheckable(true);
    home_->setWordWrap(true);
    home_->setMinimumWidth(kScan); // the panel keeps its width when the picture comes
    auto* beside = new QVBoxLayout;
    beside->setSpacing(6);
    beside->addWidget(ball_, 0, Qt::AlignHCenter);
    beside->addWidget(onScan_, 0, Qt::AlignHCenter);
    beside->addStretch(1);
    auto* pictures = new QHBoxLayout;
    pictures->setSpacing(6);
    pictures->addLayout(beside);
    pictures->addWidget(scan_);
    pictures->addWidget(home_, 1, Qt::AlignVCenter);
    QFormLayout* form = formLayout();
    name_ = addLine(form, tr("&Name"), tr("What the style is called"));
    tags_ = addLine(form, tr("&Tags"), tr("Words to find it by, with commas between them: bone, ink, warm"));
    credit_ = addLine(form, tr("&Credit"), tr("Who made the artwork that it was taken from; figures name it"));
    licence_ =
        addLine(form, tr("L&icence"), tr("On what terms it may be used, such as “CC BY 4.0” or “public domain”"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addLayout(pictures);
    layout->addLayout(form);
    QWidget* buttons = row({duplicate_, remove_});
    buttons->setMinimumHeight(duplicate_->sizeHint().height()); // also while it shows none of them
    layout->addWidget(buttons);
    const auto switchPicture = [this](bool on) { // the picture needs the line's room
        scan_->setVisible(on);
        home_->setVisible(!on);
    };
    connect(onScan_, &QToolButton::toggled, this, switchPicture);
    switchPicture(false);
    connect(duplicate_, &QToolButton::clicked, this, &StyleDetails::duplicateWanted);
    connect(remove_, &QToolButton::clicked, this, &StyleDetails::removeWanted);
    setScanPicture({}, {});
    setItem(std::nullopt);
}

QLineEdit* StyleDetails::addLine(QFormLayout* form, const QString& label, const QString& tip) {
    auto* line = new QLineEdit;
    line->setToolTip(tip);
    line->setAccessibleDescription(tip);
    form->addRow(label, line);
    connect(line, &QLineEdit::editingFinished, this, &StyleDetails::emitCard);
    return line;
}

void StyleDetails::setItem(const std::optional<GalleryItem>& item) {
    const bool same = item && item_ && item->key() == item_->key();
    if (!same)
        emitCard(); // what was typed and not finished yet
    item_ = item;
    showItem();
}

void StyleDetails::showItem() {
    const bool any = item_.has_value();
    const bool own = any && item_->home == StyleHome::mine;
    const StyleCard card = any ? item_->card : StyleCard{};
    for (const auto& [line, text] : {std::pair(name_, QString::fromStdString(card.name)),
                                     {tags_, tagLine(card.tags)},
                                     {credit_, QString::fromStdString(card.credit)},
                                     {licence_, QString::fromStdString(card.licence)}}) {
        line->setReadOnly(!own);
        line->setEnabled(any);
        line->setPlaceholderText(own ? QString() : any ? tr("none given") : QString());
        if (!line->hasFocus() || !line->isModified() || !any)
            line->setText(text);
        if (!own)
            line->setCursorPosition(0);
    }
    home_->setText(any ? homeLine(*item_) : tr("Choose a style to see more of it."));
    ball_->setToolTip(any ? home_->text() : QString());
    duplicate_->setVisible(any && !own);
    remove_->setVisible(own);
    ball_->setPixmap(any ? onPaper(item_->ball, kBall, devicePixelRatioF()) : QPixmap());
}

StyleCard StyleDetails::typed() const {
    StyleCard card = item_->card;
    const QString name = name_->text().simplified();
    if (!name.isEmpty()) // a style without a name could not be found again
        card.name = name.toStdString();
    if (tags_->text() != tagLine(card.tags))
        card.tags = tagsOfLine(tags_->text());
    card.credit = credit_->text().trimmed().toStdString();
    card.licence = licence_->text().trimmed().toStdString();
    return card;
}

void StyleDetails::emitCard() {
    if (!item_ || item_->home != StyleHome::mine)
        return;
    const StyleCard card = typed();
    for (QLineEdit* line : {name_, tags_, credit_, licence_})
        line->setModified(false);
    if (name_->text().simplified().isEmpty())
        name_->setText(QString::fromStdString(card.name));
    const StyleCard& before = item_->card;
    if (card.name == before.name && card.tags == before.tags && card.credit == before.credit &&
        card.licence == before.licence)
        return;
    item_->card = card; // it is said once
    Q_EMIT cardChanged(card);
}

int StyleDetails::scanPixels() const { return static_cast<int>(kScan * devicePixelRatioF()); }

void StyleDetails::setScanPicture(const QImage& picture, const QString& of) {
    if (picture.isNull()) {
        scan_->setPixmap({});
        scan_->setToolTip({});
        return;
    }
    QPixmap pixmap = QPixmap::fromImage(picture);
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    scan_->setPixmap(pixmap);
    scan_->setToolTip(tr("The scan with %1").arg(of));
    scan_->setAccessibleDescription(scan_->toolTip());
}

void StyleDetails::setScanNote(const QString& note) {
    if (scan_->text() != note || !scan_->pixmap().isNull())
        scan_->setText(note); // takes a picture away
    scan_->setAccessibleDescription(note);
}

} // namespace limner
