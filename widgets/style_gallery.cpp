#include "widgets/style_gallery.h"

#include "core/figure/layer_edits.h"
#include "core/figure/transfer_edits.h"
#include "widgets/style_image.h"
#include "widgets/style_mime.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {
namespace {

constexpr int kPreview = 56;
constexpr QSize kCell(96, 94); // one line of name; long ones are elided, the tip has them whole

/// A list whose items travel as style ids.
class StyleList : public QListWidget {
  protected:
    [[nodiscard]] QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override {
        auto* mime = new QMimeData;
        if (!items.isEmpty())
            mime->setData(kStyleMime, items.front()->data(Qt::UserRole).toString().toUtf8());
        return mime;
    }
    [[nodiscard]] QStringList mimeTypes() const override { return {kStyleMime}; }
};

} // namespace

StyleGallery::StyleGallery(QWidget* parent)
    : QWidget(parent), target_(new QLabel), search_(new QLineEdit), list_(new StyleList),
      nothing_(new QLabel(tr("No style has these words."))) {
    target_->setWordWrap(true);
    search_->setPlaceholderText(tr("Search styles"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(tr("Search styles"));
    search_->setToolTip(tr("Words of a style's name or tags: bone, ink, glass …"));
    list_->setViewMode(QListView::IconMode);
    list_->setIconSize({kPreview, kPreview});
    list_->setGridSize(kCell);
    list_->setResizeMode(QListView::Adjust);
    list_->setMovement(QListView::Static);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setDragEnabled(true);
    list_->setDragDropMode(QAbstractItemView::DragOnly);
    list_->setSelectionMode(QAbstractItemView::SingleSelection);
    list_->setAccessibleName(tr("Styles"));
    nothing_->setAlignment(Qt::AlignCenter);
    nothing_->setVisible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(target_);
    layout->addWidget(search_);
    layout->addWidget(nothing_);
    layout->addWidget(list_, 1);
    setFocusProxy(search_);
    connect(search_, &QLineEdit::textChanged, this, &StyleGallery::filter);
    connect(list_, &QListWidget::itemClicked, this, &StyleGallery::use);
    connect(list_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        if (list_->hasFocus()) // Enter; a click has done it already
            use(item);
    });
    showTarget();
}

void StyleGallery::setStyles(const std::vector<Style>& styles) {
    styles_ = styles;
    list_->clear();
    painted_ = 0;
    QPixmap blank(kPreview, kPreview);
    blank.fill(Qt::transparent);
    for (const Style& style : styles_) {
        auto* item = new QListWidgetItem(QString::fromStdString(style.card.name), list_);
        item->setData(Qt::UserRole, QString::fromStdString(style.card.id));
        item->setIcon(QIcon(blank)); // room for the ball
        item->setSizeHint(kCell);
        QStringList tags;
        for (const std::string& tag : style.card.tags)
            tags << QString::fromStdString(tag);
        item->setToolTip(tr("%1\n%2\nClick, or drag onto the transfer function").arg(item->text(), tags.join(", ")));
        item->setData(Qt::UserRole + 1, (item->text() + " " + tags.join(' ')).toLower());
        item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
    }
    QTimer::singleShot(0, this, &StyleGallery::paintSome);
}

void StyleGallery::paintSome() {
    constexpr std::size_t kAtOnce = 4; // some milliseconds
    const auto pixels = static_cast<int>(kPreview * devicePixelRatioF());
    for (std::size_t i = 0; i < kAtOnce && painted_ < styles_.size(); ++i, ++painted_) {
        if (!styles_[painted_].sphere)
            continue;
        QPixmap ball = QPixmap::fromImage(styleBall(*styles_[painted_].sphere, pixels));
        ball.setDevicePixelRatio(devicePixelRatioF());
        QIcon icon(ball);
        icon.addPixmap(ball, QIcon::Selected); // a selection must not colour the style
        list_->item(static_cast<int>(painted_))->setIcon(icon);
    }
    if (painted_ < styles_.size())
        QTimer::singleShot(0, this, &StyleGallery::paintSome);
}

void StyleGallery::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer, std::optional<std::size_t> node) {
    figure_ = std::move(figure);
    layer_ = layer;
    node_ = node;
    showTarget();
}

void StyleGallery::showTarget() {
    const bool any = figure_ && layer_ < figure_->layers.size();
    list_->setEnabled(any && mayChange(*figure_, layer_));
    if (!any) {
        target_->setText(tr("Open a scan to use styles."));
        return;
    }
    const Layer& layer = figure_->layers[layer_];
    const QString name = QString::fromStdString(layer.name).toHtmlEscaped();
    if (layer.locked) {
        target_->setText(tr("<b>%1</b> is locked.").arg(name));
        return;
    }
    const bool node = node_ && *node_ < layer.transfer.nodes.size();
    target_->setText(node ? tr("A click replaces the selected style of <b>%1</b>.").arg(name)
                          : tr("A click styles all of <b>%1</b>.").arg(name));
    const auto& nodes = layer.transfer.nodes;
    const std::string shown = nodes.empty() ? std::string() : nodes[node ? *node_ : 0].style;
    const StyleEntry* entry = figure_->findStyle(shown);
    const QString file = entry ? QString::fromStdString(entry->file) : QString();
    const QString id = file.startsWith("bundled:") ? file.mid(8) : QString::fromStdString(shown);
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->data(Qt::UserRole).toString() == id) {
            list_->setCurrentRow(i);
            return;
        }
    list_->setCurrentItem(nullptr);
}

void StyleGallery::use(const QListWidgetItem* item) {
    if (!item || !figure_ || !mayChange(*figure_, layer_))
        return;
    const std::string id = item->data(Qt::UserRole).toString().toStdString();
    const auto style = std::find_if(styles_.begin(), styles_.end(), [&](const Style& s) { return s.card.id == id; });
    if (style == styles_.end())
        return;
    const std::size_t count = figure_->layers[layer_].transfer.nodes.size();
    const auto node = node_ && *node_ < count ? node_ : std::nullopt;
    Q_EMIT edited({withStyle(*figure_, layer_, node, *style), tr("Replace style").toStdString(), {}, false});
}

void StyleGallery::filter(const QString& words) {
    const QStringList wanted = words.toLower().split(' ', Qt::SkipEmptyParts);
    int shown = 0;
    for (int i = 0; i < list_->count(); ++i) {
        const QString text = list_->item(i)->data(Qt::UserRole + 1).toString();
        const bool fits = std::all_of(wanted.begin(), wanted.end(), [&](const QString& w) { return text.contains(w); });
        list_->item(i)->setHidden(!fits);
        shown += fits ? 1 : 0;
    }
    nothing_->setVisible(shown == 0 && list_->count() > 0);
}

} // namespace limner
