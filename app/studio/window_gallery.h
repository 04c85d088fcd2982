#pragma once

#include "app/studio/style_shelf.h"
#include "core/project/history.h"

#include <QObject>
#include <QPointer>

#include <filesystem>
#include <memory>

class QWidget;

namespace limner {

class Actions;
class LayerList;
class NoticeBar;
class StudioDocument;
class StyleDrop;
class StyleGallery;
class StylePictures;
class TransferEditor1d;
class Viewport;
struct StyleTarget;

/// What the window does with its gallery: styles come from and go to the disk, are looked at on the scan, and are
/// dropped onto the transfer function and the picture. A click into the picture selects what lies there.
class WindowGallery : public QObject {
    Q_OBJECT

  public:
    /// The window's parts that it works with; they outlive it.
    struct Parts {
        QWidget* window;
        StudioDocument* document;
        Actions* actions;
        StyleGallery* gallery;
        Viewport* viewport;
        TransferEditor1d* transfer;
        LayerList* layers;
        NoticeBar* notices;
    };

    WindowGallery(const Parts& parts, std::filesystem::path folder, QObject* parent);
    ~WindowGallery() override;

    [[nodiscard]] StyleShelf& shelf() { return *shelf_; }
    [[nodiscard]] StyleDrop& drop() { return *drop_; }
    /// Adds a picture of a shaded ball to the user's own styles.
    void importPath(const std::filesystem::path& path);
    /// Brings the document's figure to the gallery and to what drops onto it.
    void showFigure();

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void failed(const limner::Error& error);
    void told(const QString& message);
    /// The picture is to show this instead of the document's figure; null: the figure itself again.
    void showInstead(std::shared_ptr<const Figure> figure);

  private:
    void connectShelf();
    void connectGallery();
    void connectActions();
    void chooseAndImport();
    void duplicate(const QString& key);
    void restore();
    void preview(const QString& key);
    void pickAt(QPointF position);
    void selectTarget(const StyleTarget& target);
    void findStyle();
    void readLook();
    void keepLook() const;
    [[nodiscard]] std::shared_ptr<const Style> style(const std::string& key);
    [[nodiscard]] std::shared_ptr<const Style> projectStyle(const std::string& id) const;

    Parts parts_;
    StyleShelf* shelf_;
    StyleDrop* drop_;
    std::shared_ptr<StylePictures> pictures_;
    std::shared_ptr<const Volume> pictured_; ///< scan that `pictures_` keeps things of
    QPointer<Job> previewJob_, pickJob_;
    QString nextPreview_;                 ///< asked for while another is made
    History::StateId stateOfRemoval_ = 0; ///< the document's, when a style was removed last
    unsigned generationOfRemoval_ = 0;
};

} // namespace limner
