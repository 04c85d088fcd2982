#include "widgets/gallery_list.h"

#include "widgets/core_words.h"
#include "widgets/gallery_rows.h"
#include "widgets/style_mime.h"

#include <QContextMenuEvent>
#include <QDrag>
#include <QMimeData>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSignalBlocker>

#include <algorithm>

namespace limner {
namespace {

constexpr StyleHome kHomes[] = {StyleHome::mine, StyleHome::project, StyleHome::bundled};

QString titleOf(StyleHome home) {
    switch (home) {
    case StyleHome::mine: return GalleryList::tr("Mine");
    case StyleHome::project: return GalleryList::tr("This project");
    case StyleHome::bundled: break;
    }
    return GalleryList::tr("Bundled");
}

QStringList tagsOf(const GalleryItem& item) {
    QStringList tags;
    for (const std::string& tag : item.card.tags)
        tags << QString::fromStdString(tag);
    return tags;
}

QString tipOf(const GalleryItem& item) {
    QStringList lines{QString::fromStdString(item.card.name)};
    if (!item.card.tags.empty())
        lines << tagsOf(item).join(", ");
    lines << GalleryList::tr("Click to use it, or drag it onto the transfer function or the picture");
    return lines.join('\n');
}

/// But for the ball.
bool listedAlike(const GalleryItem& a, const GalleryItem& b) {
    return a.home == b.home && a.card.id == b.card.id && a.card.name == b.card.name && a.card.tags == b.card.tags &&
           a.card.origin == b.card.origin && a.card.credit == b.card.credit && a.card.licence == b.card.licence &&
           a.file == b.file && a.favourite == b.favourite;
}

} // namespace

GalleryList::GalleryList(QWidget* parent) : QListWidget(parent) {
    setViewMode(QListView::IconMode);
    setResizeMode(QListView::Adjust);
    setMovement(QListView::Static);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // cells share the width, which must not hang on their rows
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalScrollBar()->setSingleStep(24);
    setSpacing(0);
    setDragEnabled(true);
    setDragDropMode(QAbstractItemView::DragOnly);
    setMouseTracking(true);
    setItemDelegate(new GalleryRows(this));
    setAccessibleName(tr("Styles"));
    setAccessibleDescription(tr("Enter puts the style onto the layer, Control D makes it a favourite, F2 renames it, "
                                "Delete removes one of your own."));
}

const GalleryItem* GalleryList::find(const std::string& key) const {
    const auto place = places_.find(key);
    return place == places_.end() ? nullptr : &items_[place->second];
}

void GalleryList::setItems(std::vector<GalleryItem> items) {
    if (std::equal(items.begin(), items.end(), items_.begin(), items_.end(), listedAlike)) {
        items_ = std::move(items);
        viewport()->update(); // balls alone have come: a click that is under way goes on
        return;
    }
    const std::string current = currentKey();
    const int place = currentRow();
    const int scrolled = verticalScrollBar()->value();
    items_ = std::move(items);
    places_.clear();
    for (std::size_t i = 0; i < items_.size(); ++i)
        places_[items_[i].key()] = i;
    std::erase_if(balls_, [&](const auto& kept) { return !places_.contains(kept.first.first); });
    pressed_ = nullptr;
    const QSignalBlocker quiet(this);
    fill();
    QListWidgetItem* row = rowOf(current);
    setCurrentItem(row || current.empty() ? row : styleFrom(place)); // what was removed gives way to its neighbour
    doItemsLayout();
    verticalScrollBar()->setValue(scrolled);
}

void GalleryList::fill() {
    clear();
    for (const StyleHome home : kHomes)
        addSection(home);
    showFitting();
}

void GalleryList::addSection(StyleHome home) {
    const auto here = [home](const GalleryItem& item) { return item.home == home; };
    const bool empty = std::none_of(items_.begin(), items_.end(), here);
    if (empty && home != StyleHome::mine)
        return;
    auto* heading = new QListWidgetItem(titleOf(home), this);
    heading->setData(kRowRole, static_cast<int>(Row::heading));
    heading->setData(kHomeRole, static_cast<int>(home));
    heading->setFlags(Qt::ItemIsEnabled);
    for (const GalleryItem& item : items_)
        if (here(item))
            addStyle(item);
    if (empty)
        addNote(tr("No styles of your own yet. Take one from an artwork, or import a picture."), home);
}

void GalleryList::addStyle(const GalleryItem& item) {
    auto* row = new QListWidgetItem(QString::fromStdString(item.card.name), this);
    row->setData(kRowRole, static_cast<int>(Row::style));
    row->setData(kKeyRole, QString::fromStdString(item.key()));
    row->setData(kHomeRole, static_cast<int>(item.home));
    row->setData(kFavouriteRole, item.favourite);
    row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
    row->setToolTip(tipOf(item));
    row->setData(Qt::AccessibleTextRole,
                 item.favourite ? tr("%1, a favourite, %2").arg(row->text(), inSentence(titleOf(item.home)))
                                : tr("%1, %2").arg(row->text(), inSentence(titleOf(item.home))));
}

void GalleryList::addNote(const QString& text, StyleHome home) {
    auto* note = new QListWidgetItem(text, this);
    note->setData(kRowRole, static_cast<int>(Row::note));
    note->setData(kHomeRole, static_cast<int>(home));
    note->setFlags(Qt::NoItemFlags);
}

bool GalleryList::fits(const GalleryItem& item) const {
    if (filter_.favourites && !item.favourite)
        return false;
    const auto& tags = item.card.tags;
    const bool tagged = std::all_of(filter_.tags.begin(), filter_.tags.end(), [&](const std::string& tag) {
        return std::find(tags.begin(), tags.end(), tag) != tags.end();
    });
    const QString text = (QString::fromStdString(item.card.name) + ' ' + tagsOf(item).join(' ')).toLower();
    return tagged && std::all_of(filter_.words.begin(), filter_.words.end(),
                                 [&](const QString& word) { return text.contains(word); });
}

void GalleryList::showFitting() {
    std::map<StyleHome, int> counts;
    fitting_ = 0;
    for (int i = 0; i < count(); ++i) {
        QListWidgetItem* row = item(i);
        if (!isStyle(row))
            continue;
        const auto home = static_cast<StyleHome>(row->data(kHomeRole).toInt());
        const bool shown = fits(*find(row->data(kKeyRole).toString().toStdString()));
        counts[home] += shown ? 1 : 0;
        fitting_ += shown ? 1 : 0;
        row->setHidden(!shown || folded_.contains(home));
    }
    for (int i = 0; i < count(); ++i) {
        QListWidgetItem* row = item(i);
        const auto home = static_cast<StyleHome>(row->data(kHomeRole).toInt());
        const bool folded = folded_.contains(home);
        if (row->data(kRowRole).toInt() == static_cast<int>(Row::note))
            row->setHidden(filter_.any() || folded);
        if (row->data(kRowRole).toInt() != static_cast<int>(Row::heading))
            continue;
        const int shown = counts[home];
        row->setHidden(filter_.any() && shown == 0);
        row->setText(shown > 0 ? tr("%1 (%2)").arg(titleOf(home)).arg(shown) : titleOf(home));
        row->setData(GalleryRows::kFoldedRole, folded);
        row->setToolTip(folded ? tr("Show these styles") : tr("Fold these styles away"));
        row->setData(Qt::AccessibleTextRole,
                     folded ? tr("%1, folded").arg(row->text()) : tr("%1, heading").arg(row->text()));
    }
}

void GalleryList::setFilter(Filter filter) {
    if (filter == filter_)
        return;
    filter_ = std::move(filter);
    showFitting();
}

void GalleryList::setFolded(StyleHome home, bool folded) {
    if (folded)
        folded_.insert(home);
    else
        folded_.erase(home);
    showFitting();
}

void GalleryList::setBallSize(BallSize size) {
    size_ = size;
    scheduleDelayedItemsLayout();
    if (QListWidgetItem* row = currentItem())
        scrollToItem(row);
}

bool GalleryList::isStyle(const QListWidgetItem* row) const {
    return row && row->data(kRowRole).toInt() == static_cast<int>(Row::style);
}

std::string GalleryList::currentKey() const {
    return isStyle(currentItem()) ? currentItem()->data(kKeyRole).toString().toStdString() : std::string();
}

QListWidgetItem* GalleryList::rowOf(const std::string& key) const {
    for (int i = 0; i < count(); ++i)
        if (isStyle(item(i)) && item(i)->data(kKeyRole).toString().toStdString() == key)
            return item(i);
    return nullptr;
}

QListWidgetItem* GalleryList::styleFrom(int place) const {
    const auto usable = [this](int i) { return i >= 0 && i < count() && isStyle(item(i)) && !item(i)->isHidden(); };
    for (int away = 0; away <= count(); ++away)
        for (const int i : {place + away, place - away})
            if (usable(i))
                return item(i);
    return nullptr;
}

void GalleryList::setCurrentKey(const std::string& key) {
    QListWidgetItem* row = rowOf(key);
    setCurrentItem(row); // null clears
    if (row && !row->isHidden())
        scrollToItem(row);
}

QRect GalleryList::starRect(const QListWidgetItem* row) const { return GalleryRows::starIn(visualItemRect(row)); }

QPixmap GalleryList::ball(const std::string& key, int size) {
    const GalleryItem* item = find(key);
    if (!item || item->ball.isNull())
        return {};
    Ball& kept = balls_[{key, size}];
    if (kept.pixmap.isNull() || kept.image != item->ball.cacheKey()) {
        const int pixels = std::max(1, static_cast<int>(size * devicePixelRatioF()));
        kept.image = item->ball.cacheKey();
        kept.pixmap =
            QPixmap::fromImage(item->ball.scaled(pixels, pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation));
        kept.pixmap.setDevicePixelRatio(devicePixelRatioF());
    }
    return kept.pixmap;
}

QMimeData* GalleryList::mimeData(const QList<QListWidgetItem*>& items) const {
    auto* mime = new QMimeData;
    if (!items.isEmpty())
        mime->setData(kStyleMime, items.front()->data(kKeyRole).toString().toUtf8());
    return mime;
}

QStringList GalleryList::mimeTypes() const { return {kStyleMime}; }

void GalleryList::startDrag(Qt::DropActions) {
    QListWidgetItem* dragged = currentItem();
    if (!isStyle(dragged))
        return;
    pressed_ = nullptr; // the release is the drop's
    auto* drag = new QDrag(this);
    drag->setMimeData(mimeData({dragged}));
    constexpr int kInHand = 36;
    const QPixmap picture = ball(currentKey(), kInHand);
    drag->setPixmap(picture);
    drag->setHotSpot({kInHand / 2, kInHand + 6}); // above the pointer: what lies under it must be seen
    drag->exec(Qt::CopyAction);
}

void GalleryList::mousePressEvent(QMouseEvent* event) {
    QListWidgetItem* under = itemAt(event->position().toPoint());
    pressed_ = nullptr;
    if (event->button() == Qt::LeftButton && under) {
        const QPoint at = event->position().toPoint();
        if (under->data(kRowRole).toInt() == static_cast<int>(Row::heading)) {
            const auto home = static_cast<StyleHome>(under->data(kHomeRole).toInt());
            setFolded(home, !folded_.contains(home));
            return;
        }
        if (isStyle(under) && starRect(under).contains(at)) {
            Q_EMIT favouriteWanted(under->data(kKeyRole).toString());
            return;
        }
        pressed_ = isStyle(under) ? under : nullptr;
    }
    QListWidget::mousePressEvent(event);
}

void GalleryList::mouseReleaseEvent(QMouseEvent* event) {
    QListWidgetItem* under = itemAt(event->position().toPoint());
    const bool clicked = event->button() == Qt::LeftButton && pressed_ && under == pressed_;
    pressed_ = nullptr;
    QListWidget::mouseReleaseEvent(event);
    if (clicked)
        Q_EMIT useWanted(under->data(kKeyRole).toString());
}

void GalleryList::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event); // two quick clicks are two clicks
}

void GalleryList::keyPressEvent(QKeyEvent* event) {
    QListWidgetItem* row = currentItem();
    const bool heading = row && row->data(kRowRole).toInt() == static_cast<int>(Row::heading);
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (heading && (enter || event->key() == Qt::Key_Space)) {
        const auto home = static_cast<StyleHome>(row->data(kHomeRole).toInt());
        setFolded(home, !folded_.contains(home));
        return;
    }
    if (!isStyle(row)) {
        QListWidget::keyPressEvent(event);
        return;
    }
    const QString key = row->data(kKeyRole).toString();
    if (enter)
        Q_EMIT useWanted(key);
    else if (event->key() == Qt::Key_Delete)
        Q_EMIT removeWanted(key);
    else if (event->key() == Qt::Key_F2)
        Q_EMIT renameWanted(key);
    else if (event->key() == Qt::Key_D && event->modifiers() == Qt::ControlModifier)
        Q_EMIT favouriteWanted(key);
    else
        QListWidget::keyPressEvent(event);
}

void GalleryList::contextMenuEvent(QContextMenuEvent* event) {
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    QListWidgetItem* row = byKey ? currentItem() : itemAt(event->pos());
    if (!isStyle(row))
        return;
    const QPoint at = byKey ? viewport()->mapToGlobal(visualItemRect(row).center()) : event->globalPos();
    setCurrentItem(row);
    Q_EMIT menuWanted(row->data(kKeyRole).toString(), at);
}

void GalleryList::resizeEvent(QResizeEvent* event) {
    QListWidget::resizeEvent(event);
    scheduleDelayedItemsLayout(); // cells share the width
}

bool GalleryList::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::MouseMove || event->type() == QEvent::HoverMove || event->type() == QEvent::Leave ||
        event->type() == QEvent::Wheel) {
        const bool gone = event->type() == QEvent::Leave;
        const QListWidgetItem* under = gone ? nullptr : itemAt(viewport()->mapFromGlobal(QCursor::pos()));
        if (event->type() == QEvent::MouseMove)
            under = itemAt(static_cast<QMouseEvent*>(event)->position().toPoint());
        const std::string key = isStyle(under) ? under->data(kKeyRole).toString().toStdString() : std::string();
        if (key != hovered_) {
            hovered_ = key;
            Q_EMIT hovered(QString::fromStdString(key));
        }
    }
    return QListWidget::viewportEvent(event);
}

} // namespace limner
