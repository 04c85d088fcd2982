#include "widgets/style_gallery.h"

#include "core/figure/layer_edits.h"
#include "core/figure/shape_edits.h"
#include "core/figure/style_edits.h"
#include "core/figure/transfer_edits.h"
#include "core/style/transfer_function.h"
#include "renderer/style_target.h"
#include "widgets/form_parts.h"
#include "widgets/style_details.h"
#include "widgets/style_image.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace limner {
namespace {

constexpr int kRestMs = 180; ///< a pointer that passes over styles stays on none of them that long

/// A ball of that many pixels in the text's colour: the sign of a ball size.
QIcon sizeIcon(int diameter, const QColor& ink, double ratio) {
    constexpr int kSide = 18;
    QPixmap pixmap(QSize(kSide, kSide) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawEllipse(QRectF((kSide - diameter) / 2.0, (kSide - diameter) / 2.0, diameter, diameter));
    return QIcon(pixmap);
}

} // namespace

StyleGallery::StyleGallery(QWidget* parent)
    : QWidget(parent), target_(new QLabel), search_(new QLineEdit),
      favourites_(
          textButton(tr("★"), tr("Show favourites only. A click on a style's star, or Control D, makes it one"))),
      tags_(textButton(tr("Tags"), tr("Show only styles that have these tags"))), tagMenu_(new QMenu(this)),
      sizes_(new QButtonGroup(this)),
      detailsButton_(textButton(tr("Card"), tr("Show the chosen style's card: a larger ball, how the scan looks in it, "
                                               "its name, tags, credit and licence"))),
      list_(new GalleryList), nothing_(new QLabel), details_(new StyleDetails),
      import_(
          textButton(tr("Import picture…"), tr("Add a picture of a shaded ball (a lit sphere, a matcap) to your own "
                                               "styles"))),
      extract_(textButton(tr("From artwork…"), tr("Take a style from a scanned drawing or painting"))) {
    target_->setWordWrap(true);
    search_->setPlaceholderText(tr("Search styles"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(tr("Search styles"));
    search_->setToolTip(tr("Words of a style's name or tags: bone, ink, glass …"));
    favourites_->setCheckable(true);
    favourites_->setAccessibleName(tr("Favourites only"));
    tags_->setMenu(tagMenu_);
    tags_->setPopupMode(QToolButton::InstantPopup);
    detailsButton_->setCheckable(true);
    detailsButton_->setChecked(true);
    nothing_->setAlignment(Qt::AlignCenter);
    nothing_->setWordWrap(true);
    nothing_->setVisible(false);
    rest_.setSingleShot(true);
    rest_.setInterval(kRestMs);
    layOut();
    connectParts();
    showItems();
    showTarget();
}

QWidget* StyleGallery::sizeButtons() {
    struct Look {
        BallSize size;
        QString name;
    };
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    for (const Look& look : {Look{BallSize::small, tr("Small balls")}, Look{BallSize::medium, tr("Medium balls")},
                             Look{BallSize::large, tr("Large balls")}}) {
        auto* button = new QToolButton;
        button->setCheckable(true);
        button->setToolTip(look.name);
        button->setAccessibleName(look.name);
        sizes_->addButton(button, static_cast<int>(look.size));
        row->addWidget(button);
    }
    sizes_->button(static_cast<int>(list_->ballSize()))->setChecked(true);
    return holder;
}

void StyleGallery::layOut() {
    auto* tools = new QHBoxLayout;
    tools->setSpacing(4);
    tools->addWidget(sizeButtons());
    tools->addStretch(1);
    for (QToolButton* button : {favourites_, tags_, detailsButton_})
        tools->addWidget(button);
    auto* sources = new QHBoxLayout;
    sources->setSpacing(6);
    for (QToolButton* button : {import_, extract_}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        sources->addWidget(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(target_);
    layout->addWidget(search_);
    layout->addLayout(tools);
    layout->addWidget(nothing_);
    layout->addWidget(list_, 1);
    layout->addLayout(sources);
    layout->addWidget(details_);
    QEvent palette(QEvent::PaletteChange);
    changeEvent(&palette);
}

std::vector<QWidget*> StyleGallery::tabOrder() const {
    std::vector<QWidget*> order{search_};
    const auto sizes = sizes_->buttons();
    order.insert(order.end(), sizes.begin(), sizes.end());
    order.insert(order.end(), {favourites_, tags_, detailsButton_, list_, import_, extract_, details_->onScan(),
                               details_->name(), details_->tags(), details_->credit(), details_->licence(),
                               details_->duplicate(), details_->remove()});
    return order;
}

void StyleGallery::connectParts() {
    connect(search_, &QLineEdit::textChanged, this, &StyleGallery::applyFilter);
    connect(favourites_, &QToolButton::toggled, this, &StyleGallery::applyFilter);
    connect(sizes_, &QButtonGroup::idClicked, this, [this](int id) {
        list_->setBallSize(static_cast<BallSize>(id));
        Q_EMIT lookChanged();
    });
    connect(detailsButton_, &QToolButton::toggled, this, [this](bool shown) {
        details_->setVisible(shown);
        wantPreview();
        Q_EMIT lookChanged();
    });
    connect(details_->onScan(), &QToolButton::toggled, this, [this] {
        wantPreview();
        Q_EMIT lookChanged();
    });
    connect(list_, &GalleryList::useWanted, this, &StyleGallery::use);
    connect(list_, &GalleryList::favouriteWanted, this, &StyleGallery::toggleFavourite);
    connect(list_, &GalleryList::removeWanted, this, &StyleGallery::remove);
    connect(list_, &GalleryList::renameWanted, this, &StyleGallery::rename);
    connect(list_, &GalleryList::menuWanted, this, &StyleGallery::openMenu);
    connect(list_, &QListWidget::currentItemChanged, this, [this] { showDetails(); });
    connect(list_, &GalleryList::hovered, this, [this](const QString& key) {
        hovered_ = key.toStdString();
        wantPreview();
    });
    connect(details_, &StyleDetails::cardChanged, this, &StyleGallery::cardChanged);
    const auto current = [this] { return QString::fromStdString(list_->currentKey()); };
    connect(details_, &StyleDetails::duplicateWanted, this, [this, current] { Q_EMIT duplicateWanted(current()); });
    connect(details_, &StyleDetails::removeWanted, this, [this, current] { remove(current()); });
    connect(import_, &QToolButton::clicked, this, &StyleGallery::importWanted);
    connect(extract_, &QToolButton::clicked, this, &StyleGallery::extractRequested);
    connect(&rest_, &QTimer::timeout, this, [this] { Q_EMIT previewWanted(QString::fromStdString(preview_)); });
}

void StyleGallery::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && sizes_) {
        const QColor ink = palette().color(QPalette::ButtonText);
        for (const auto& [size, diameter] :
             {std::pair(BallSize::small, 6), {BallSize::medium, 10}, {BallSize::large, 15}})
            if (QAbstractButton* button = sizes_->button(static_cast<int>(size)))
                button->setIcon(sizeIcon(diameter, ink, devicePixelRatioF()));
    }
    QWidget::changeEvent(event);
}

void StyleGallery::setItems(std::vector<GalleryItem> items) {
    items_ = std::move(items);
    entries_.clear(); // which of the figure's are the project's alone may be another matter now
    project_.clear();
    project_ = projectItems();
    showItems();
    showTarget();
}

std::vector<GalleryItem> StyleGallery::projectItems() {
    std::vector<GalleryItem> made;
    if (!figure_)
        return made;
    const auto known = [this](const std::string& file) {
        return file.starts_with("bundled:") || std::any_of(items_.begin(), items_.end(), [&](const GalleryItem& item) {
                   return !item.file.empty() && item.file == file;
               });
    };
    std::vector<StyleEntry> entries;
    for (const StyleEntry& entry : figure_->styles)
        if (entry.sphere && !known(entry.file))
            entries.push_back(entry);
    if (entries == entries_)
        return project_;
    entries_ = entries;
    for (const Style& style : projectStyles(*figure_)) {
        if (known(style.file))
            continue;
        GalleryItem item;
        item.home = StyleHome::project;
        item.card = style.card;
        item.file = style.file;
        item.ball = styleBall(*style.sphere, kGalleryBallPixels);
        made.push_back(std::move(item));
    }
    return made;
}

void StyleGallery::showItems() {
    std::vector<GalleryItem> all = items_;
    all.insert(all.end(), project_.begin(), project_.end());
    list_->setItems(std::move(all));
    if (!list_->find(hovered_)) // it was removed under the pointer
        hovered_.clear();
    showTags();
    applyFilter();
    showDetails();
}

void StyleGallery::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer, std::optional<std::size_t> node) {
    figure_ = std::move(figure);
    layer_ = layer;
    node_ = node;
    const std::vector<StyleEntry> before = entries_;
    project_ = projectItems();
    if (project_.empty())
        entries_.clear();
    if (entries_ != before)
        showItems();
    showTarget();
    wantPreview();
}

std::optional<std::size_t> StyleGallery::usedNode() const {
    return node_ && *node_ < styleNodes(figure_->layers[layer_].transfer) ? node_ : std::nullopt;
}

std::string StyleGallery::shownStyle() const {
    const Transfer& transfer = figure_->layers[layer_].transfer;
    const std::size_t node = usedNode().value_or(0);
    const StyleEntry* entry = nullptr;
    if (transfer.grid && secondAxis(transfer))
        entry = figure_->findStyle(nodeOfCell(*transfer.grid, node).style);
    else if (node < transfer.nodes.size())
        entry = figure_->findStyle(transfer.nodes[node].style);
    if (!entry)
        return {};
    for (const GalleryItem& item : list_->items())
        if (item.home == StyleHome::project ? item.card.id == entry->id : item.file == entry->file)
            return item.key();
    return {};
}

void StyleGallery::showTarget() {
    if (!figure_ || layer_ >= figure_->layers.size()) {
        target_->setText(tr("Open a scan to use styles."));
        return;
    }
    const Layer& layer = figure_->layers[layer_];
    const QString name = QString::fromStdString(layer.name).toHtmlEscaped();
    target_->setText(layer.locked ? tr("<b>%1</b> is locked.").arg(name)
                     : usedNode() ? tr("A click replaces the selected style of <b>%1</b>.").arg(name)
                                  : tr("A click styles all of <b>%1</b>.").arg(name));
    const std::string shown = shownStyle();
    if (shown == shown_)
        return; // what the user goes through stays
    shown_ = shown;
    list_->setCurrentKey(shown);
}

void StyleGallery::show(const std::string& key) {
    if (const QListWidgetItem* row = list_->rowOf(key); row && row->isHidden()) {
        search_->clear();
        favourites_->setChecked(false);
        chosenTags_.clear();
        showTags();
        applyFilter();
    }
    list_->setCurrentKey(key);
}

void StyleGallery::showDetails() {
    const GalleryItem* item = list_->find(list_->currentKey());
    details_->setItem(item ? std::optional(*item) : std::nullopt);
    wantPreview();
}

std::optional<StyleGallery::Place> StyleGallery::place() const {
    if (!figure_ || !mayChange(*figure_, layer_))
        return std::nullopt;
    return Place{figure_, layer_, usedNode()};
}

void StyleGallery::use(const QString& key) {
    const auto where = place();
    const std::shared_ptr<const Style> style = where && source_ ? source_(key.toStdString()) : nullptr;
    if (style)
        Q_EMIT edited({withStyle(*where->figure, where->layer, where->node, *style),
                       tr("Replace style").toStdString(),
                       {},
                       false});
}

void StyleGallery::toggleFavourite(const QString& key) {
    if (const GalleryItem* item = list_->find(key.toStdString()); item && item->home != StyleHome::project)
        Q_EMIT favouriteWanted(key, !item->favourite);
}

void StyleGallery::rename(const QString& key) {
    if (!livesIn(key.toStdString(), StyleHome::mine))
        return;
    detailsButton_->setChecked(true);
    details_->name()->setFocus(Qt::OtherFocusReason);
    details_->name()->selectAll();
}

void StyleGallery::remove(const QString& key) {
    if (livesIn(key.toStdString(), StyleHome::mine))
        Q_EMIT removeWanted(key);
}

void StyleGallery::openMenu(const QString& key, const QPoint& globalPosition) {
    const GalleryItem* item = list_->find(key.toStdString());
    if (!item)
        return;
    const bool own = item->home == StyleHome::mine;
    QMenu menu(this);
    QAction* useIt = menu.addAction(tr("Put onto the layer"), this, [this, key] { use(key); });
    useIt->setEnabled(place().has_value());
    if (item->home != StyleHome::project)
        menu.addAction(item->favourite ? tr("No favourite any more") : tr("Make it a favourite"), this,
                       [this, key] { toggleFavourite(key); });
    if (own)
        menu.addAction(tr("Rename"), this, [this, key] { rename(key); });
    menu.addAction(own ? tr("Duplicate") : tr("Duplicate to mine"), this, [this, key] { Q_EMIT duplicateWanted(key); });
    if (own)
        menu.addAction(tr("Delete"), this, [this, key] { remove(key); });
    menu.exec(globalPosition);
}

void StyleGallery::setBallSize(BallSize size) {
    sizes_->button(static_cast<int>(size))->setChecked(true);
    list_->setBallSize(size);
}

void StyleGallery::showTags() {
    std::map<std::string, int> counts;
    for (const GalleryItem& item : list_->items())
        for (const std::string& tag : item.card.tags)
            ++counts[tag];
    std::erase_if(chosenTags_, [&](const std::string& tag) { return !counts.contains(tag); });
    tagMenu_->clear();
    QAction* all = tagMenu_->addAction(tr("All styles"), this, [this] {
        chosenTags_.clear();
        showTags();
        applyFilter();
    });
    all->setEnabled(!chosenTags_.empty());
    tagMenu_->addSeparator();
    for (const auto& [tag, count] : counts) {
        QAction* action = tagMenu_->addAction(tr("%1 (%2)").arg(QString::fromStdString(tag)).arg(count));
        action->setObjectName("tag." + QString::fromStdString(tag));
        action->setCheckable(true);
        action->setChecked(chosenTags_.contains(tag));
        connect(action, &QAction::triggered, this, [this, tag = tag](bool chosen) {
            if (chosen)
                chosenTags_.insert(tag);
            else
                chosenTags_.erase(tag);
            showTags();
            applyFilter();
        });
    }
    tags_->setEnabled(!counts.empty());
    tags_->setText(chosenTags_.empty() ? tr("Tags") : tr("Tags: %1").arg(chosenTags_.size()));
    tags_->setToolTip(chosenTags_.empty()
                          ? tr("Show only styles that have these tags")
                          : tr("Only styles with: %1").arg(tagLine({chosenTags_.begin(), chosenTags_.end()})));
}

void StyleGallery::applyFilter() {
    const QStringList words = search_->text().toLower().split(' ', Qt::SkipEmptyParts);
    list_->setFilter({words, chosenTags_, favourites_->isChecked()});
    const bool none = list_->fitting() == 0 && !list_->items().empty();
    const bool onlyFavourites = favourites_->isChecked() && words.empty() && chosenTags_.empty();
    nothing_->setText(onlyFavourites ? tr("No favourites yet. Click a style's star to make it one.")
                                     : tr("No style has these words and tags."));
    nothing_->setVisible(none && (onlyFavourites || !words.empty() || !chosenTags_.empty()));
}

void StyleGallery::wantPreview() {
    const bool may = details_->onScan()->isChecked() && details_->isVisibleTo(this) && place() && figure_->volume &&
                     figure_->volume->data;
    const std::string key = !may ? std::string() : !hovered_.empty() ? hovered_ : list_->currentKey();
    if (key.empty()) {
        details_->setScanPicture({}, {});
        details_->setScanNote(!details_->onScan()->isChecked() ? QString()
                              : may                            ? tr("Point at a style to see it on the scan.")
                              : figure_                        ? tr("This layer cannot be changed.")
                                                               : tr("Open a scan first."));
        rest_.stop();
        if (!preview_.empty()) {
            preview_.clear();
            Q_EMIT previewWanted({});
        }
        return;
    }
    preview_ = key;
    rest_.start();
}

void StyleGallery::setPreview(const std::string& key, const QImage& picture) {
    if (key != preview_)
        return;
    const GalleryItem* item = list_->find(key);
    details_->setScanPicture(picture, item ? QString::fromStdString(item->card.name) : QString());
    if (picture.isNull())
        details_->setScanNote(tr("No picture"));
}

bool StyleGallery::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && removalOffered_ &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Undo)) {
        event->accept(); // the window's own undo waits
        return true;
    }
    return QWidget::event(event);
}

void StyleGallery::keyPressEvent(QKeyEvent* event) {
    if (removalOffered_ && event->matches(QKeySequence::Undo))
        Q_EMIT restoreWanted();
    else
        QWidget::keyPressEvent(event);
}

} // namespace limner
