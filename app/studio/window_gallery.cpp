#include "app/studio/window_gallery.h"

#include "app/studio/action_table.h"
#include "app/studio/studio_document.h"
#include "app/studio/style_import.h"
#include "core/figure/style_edits.h"
#include "core/figure/transfer_edits.h"
#include "renderer/style_target.h"
#include "widgets/layer_list.h"
#include "widgets/layer_rows.h"
#include "widgets/notice_bar.h"
#include "widgets/style_details.h"
#include "widgets/style_drop.h"
#include "widgets/style_gallery.h"
#include "widgets/style_pictures.h"
#include "widgets/transfer_editor_1d.h"
#include "widgets/viewport.h"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QSettings>
#include <QToolButton>

#include <utility>

namespace limner {

WindowGallery::WindowGallery(const Parts& parts, std::filesystem::path folder, QObject* parent)
    : QObject(parent), parts_(parts), shelf_(new StyleShelf(std::move(folder), this)),
      drop_(new StyleDrop(parts.viewport)), pictures_(std::make_shared<StylePictures>()) {
    const StyleSource source = [this](const std::string& key) { return style(key); };
    parts_.gallery->setSource(source);
    parts_.transfer->setStyleSource(source);
    drop_->setSource(source);
    readLook();
    connectShelf();
    connectGallery();
    connectActions();
    connect(drop_, &StyleDrop::edited, this, &WindowGallery::edited);
    connect(drop_, &StyleDrop::previewWanted, this, &WindowGallery::showInstead);
    connect(parts_.viewport, &Viewport::clicked, this, &WindowGallery::pickAt);
    connect(parts_.document, &StudioDocument::changed, this, [this] {
        const bool same = parts_.document->generation() == generationOfRemoval_ &&
                          parts_.document->history().stateId() == stateOfRemoval_;
        if (!same) // the figure's own undo is the nearer one now
            parts_.gallery->setRemovalOffered(false);
    });
    shelf_->reload();
}

WindowGallery::~WindowGallery() {
    delete previewJob_;
    delete pickJob_;
}

void WindowGallery::connectShelf() {
    connect(shelf_, &StyleShelf::changed, this, [this] { parts_.gallery->setItems(shelf_->items()); });
    connect(shelf_, &StyleShelf::failed, this, &WindowGallery::failed);
    connect(shelf_, &StyleShelf::problemsFound, this,
            [this](const QStringList& lines) { parts_.notices->setNotices(lines, NoticeBar::Kind::problem); });
    connect(shelf_, &StyleShelf::added, this, [this](const QString& key) {
        parts_.gallery->show(key.toStdString());
        const GalleryItem* item = parts_.gallery->list()->find(key.toStdString());
        Q_EMIT told(tr("Added “%1” to your styles").arg(item ? QString::fromStdString(item->card.name) : QString()));
    });
    connect(shelf_, &StyleShelf::removed, this, [this](const QString& name) {
        stateOfRemoval_ = parts_.document->history().stateId();
        generationOfRemoval_ = parts_.document->generation();
        parts_.gallery->setRemovalOffered(true);
        parts_.notices->offer(tr("Removed “%1” from your styles").arg(name), tr("Undo"), [this] { restore(); });
    });
}

void WindowGallery::connectGallery() {
    StyleGallery* gallery = parts_.gallery;
    connect(gallery, &StyleGallery::edited, this, &WindowGallery::edited);
    connect(gallery, &StyleGallery::favouriteWanted, this,
            [this](const QString& key, bool favourite) { shelf_->setFavourite(key.toStdString(), favourite); });
    connect(gallery, &StyleGallery::cardChanged, shelf_, &StyleShelf::change);
    connect(gallery, &StyleGallery::removeWanted, this,
            [this](const QString& key) { shelf_->remove(styleIdOf(key.toStdString())); });
    connect(gallery, &StyleGallery::restoreWanted, this, &WindowGallery::restore);
    connect(gallery, &StyleGallery::duplicateWanted, this, &WindowGallery::duplicate);
    connect(gallery, &StyleGallery::importWanted, parts_.actions->at("styles.import"), &QAction::trigger);
    connect(gallery, &StyleGallery::extractRequested, parts_.actions->at("styles.extract"), &QAction::trigger);
    connect(gallery, &StyleGallery::previewWanted, this, &WindowGallery::preview);
    connect(gallery, &StyleGallery::lookChanged, this, &WindowGallery::keepLook);
}

void WindowGallery::connectActions() {
    connect(parts_.actions->at("styles.find"), &QAction::triggered, this, &WindowGallery::findStyle);
    connect(parts_.actions->at("styles.import"), &QAction::triggered, this, &WindowGallery::chooseAndImport);
}

void WindowGallery::readLook() {
    const QSettings settings;
    const int size = settings.value("gallery/ballSize", static_cast<int>(BallSize::medium)).toInt();
    const bool known = size >= static_cast<int>(BallSize::small) && size <= static_cast<int>(BallSize::large);
    parts_.gallery->setBallSize(known ? static_cast<BallSize>(size) : BallSize::medium);
    parts_.gallery->detailsButton()->setChecked(settings.value("gallery/card", true).toBool());
    parts_.gallery->details()->onScan()->setChecked(settings.value("gallery/onScan", false).toBool());
}

void WindowGallery::keepLook() const {
    QSettings settings;
    settings.setValue("gallery/ballSize", static_cast<int>(parts_.gallery->list()->ballSize()));
    settings.setValue("gallery/card", parts_.gallery->detailsButton()->isChecked());
    settings.setValue("gallery/onScan", parts_.gallery->details()->onScan()->isChecked());
}

void WindowGallery::showFigure() {
    const std::shared_ptr<const Figure> figure = parts_.document->figure();
    parts_.gallery->setFigure(figure, parts_.layers->selectedLayer(), parts_.transfer->selectedNode());
    drop_->setFigure(figure);
}

std::shared_ptr<const Style> WindowGallery::projectStyle(const std::string& id) const {
    const auto figure = parts_.document->figure();
    for (const Style& style : figure ? projectStyles(*figure) : std::vector<Style>())
        if (style.card.id == id)
            return std::make_shared<const Style>(style);
    return nullptr;
}

std::shared_ptr<const Style> WindowGallery::style(const std::string& key) {
    return livesIn(key, StyleHome::project) ? projectStyle(styleIdOf(key)) : shelf_->style(key);
}

void WindowGallery::findStyle() {
    for (QWidget* at = parts_.gallery; at; at = at->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(at)) {
            dock->show();
            dock->raise();
            break;
        }
    parts_.gallery->search()->setFocus(Qt::ShortcutFocusReason);
    parts_.gallery->search()->selectAll();
}

void WindowGallery::chooseAndImport() {
    const QStringList paths = QFileDialog::getOpenFileNames(
        parts_.window, tr("Import pictures of shaded balls"), {},
        tr("Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.psd *.tga *.bmp *.webp);;Everything (*)"));
    for (const QString& path : paths)
        importPath(path.toStdString());
}

void WindowGallery::importPath(const std::filesystem::path& path) {
    const QString file = QString::fromStdString(path.filename().string());
    shelf_->add(tr("Importing %1").arg(file), [path](Task& task) { return importedStyle(path, task); });
}

void WindowGallery::duplicate(const QString& key) {
    const std::shared_ptr<const Style> original = style(key.toStdString());
    if (!original)
        return;
    const QString name = QString::fromStdString(original->card.name);
    shelf_->add(tr("Duplicating %1").arg(name), [original](Task&) { return *original; });
}

void WindowGallery::restore() {
    shelf_->restore();
    if (!parts_.notices->action()->isHidden()) // the offer is taken
        parts_.notices->setNotices({}, NoticeBar::Kind::information);
    parts_.gallery->setRemovalOffered(shelf_->canRestore());
}

void WindowGallery::preview(const QString& key) {
    if (previewJob_) { // the newest is what is wanted; one that is under way is of no use any more
        nextPreview_ = key;
        previewJob_->cancel();
        return;
    }
    const auto place = parts_.gallery->place();
    const auto& picture = parts_.viewport->picture();
    if (key.isEmpty() || !place || !place->figure->volume || !picture)
        return;
    if (pictured_ != place->figure->volume->data) { // what is kept is of another scan
        pictured_ = place->figure->volume->data;
        pictures_ = std::make_shared<StylePictures>();
    }
    struct Made {
        std::shared_ptr<const Style> style;
        QImage picture;
    };
    auto made = std::make_shared<Made>();
    const std::string id = key.toStdString();
    const auto read =
        livesIn(id, StyleHome::project) ? [style = projectStyle(styleIdOf(id))] { return style; } : shelf_->reader(id);
    previewJob_ = new Job(
        tr("Drawing the scan in a style"),
        [made, read, place, shown = picture->plan, pictures = pictures_,
         pixels = parts_.gallery->details()->scanPixels()](Task& task) {
            made->style = read();
            if (!made->style)
                return;
            const Figure figure = withStyle(*place->figure, place->layer, place->node, *made->style);
            made->picture = pictures->figure(*shown, figure, pixels, task);
        },
        this);
    const auto end = [this, made, id, job = previewJob_.data()] {
        previewJob_.clear();
        job->deleteLater();
        shelf_->keep(id, made->style); // a click will want it
        if (const QString next = std::exchange(nextPreview_, QString()); !next.isEmpty())
            preview(next);
        else
            parts_.gallery->setPreview(id, made->picture);
    };
    connect(previewJob_, &Job::finished, this, end);
    connect(previewJob_, &Job::cancelled, this, end);
    connect(previewJob_, &Job::failed, this, end); // the style's own use says what is wrong
    previewJob_->start();
}

void WindowGallery::pickAt(QPointF position) {
    const auto& picture = parts_.viewport->picture();
    if (!picture || pickJob_)
        return;
    const glm::dvec2 pixel = parts_.viewport->onFigure(position) * glm::dvec2(picture->plan->size);
    auto found = std::make_shared<std::optional<StyleTarget>>();
    pickJob_ = new Job(
        tr("Looking at the picture"),
        [found, pixel, plan = picture->plan](Task&) { *found = styleTarget(*plan, pixel); }, this);
    connect(pickJob_, &Job::finished, this, [this, found, plan = picture->plan, job = pickJob_.data()] {
        pickJob_.clear();
        job->deleteLater();
        const auto figure = parts_.document->figure();
        if (*found && figure && (*found)->layer < figure->layers.size() &&
            figure->layers[(*found)->layer].name == plan->figure->layers[(*found)->layer].name)
            selectTarget(**found);
    });
    pickJob_->start();
}

void WindowGallery::selectTarget(const StyleTarget& target) {
    const auto figure = parts_.document->figure();
    parts_.layers->list()->setCurrentRow(static_cast<int>(target.layer));
    const Transfer& transfer = figure->layers[target.layer].transfer;
    if (transfer.kind == TransferKind::oneDimensional && target.node && transfer.nodes.size() > 1)
        parts_.transfer->canvas()->select(TransferCanvas::Handle{TransferCanvas::HandleKind::node, *target.node});
    else
        parts_.transfer->canvas()->select(std::nullopt); // all of the layer
    Q_EMIT told(tr("Selected %1").arg(targetWords(*figure, target)));
}

} // namespace limner
