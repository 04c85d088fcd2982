#pragma once

#include "core/project/history.h"
#include "widgets/gallery_list.h"
#include "widgets/style_source.h"

#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <set>

class QAction;
class QButtonGroup;
class QLabel;
class QLineEdit;
class QMenu;
class QToolButton;

namespace limner {

class StyleDetails;

/// The styles there are, as balls: the user's own, the project's and those that come with Limner; to be searched,
/// marked as favourites, looked at on the scan and put onto the figure. A click, Enter or a drop puts one onto the
/// selected node, or onto the whole layer where no node is selected. What changes styles themselves goes out as a
/// request. Ctrl+Z takes back a removal while `setRemovalOffered`.
class StyleGallery : public QWidget {
    Q_OBJECT

  public:
    explicit StyleGallery(QWidget* parent = nullptr);

    void setSource(StyleSource source) { source_ = std::move(source); }
    /// The user's own and the bundled ones, in the order in which they are to be listed. The project's are the
    /// figure's.
    void setItems(std::vector<GalleryItem> items);
    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer, std::optional<std::size_t> node);
    /// The answer to `previewWanted`; a null picture: it cannot be made.
    void setPreview(const std::string& key, const QImage& picture);
    /// Whether Ctrl+Z in the gallery brings back a removed style.
    void setRemovalOffered(bool offered) { removalOffered_ = offered; }
    /// Goes to a style and shows its card; a filter that hides it is taken away.
    void show(const std::string& key);

    void setBallSize(BallSize size);
    /// What the tab key goes through, in that order.
    [[nodiscard]] std::vector<QWidget*> tabOrder() const;
    /// Where a click puts a style; nothing where it would change nothing.
    struct Place {
        std::shared_ptr<const Figure> figure;
        std::size_t layer = 0;
        std::optional<std::size_t> node; ///< absent: all of the layer
    };
    [[nodiscard]] std::optional<Place> place() const;

    [[nodiscard]] GalleryList* list() const { return list_; }
    [[nodiscard]] QLineEdit* search() const { return search_; }
    [[nodiscard]] StyleDetails* details() const { return details_; }
    [[nodiscard]] QToolButton* favourites() const { return favourites_; }
    [[nodiscard]] QMenu* tagMenu() const { return tagMenu_; }
    [[nodiscard]] QToolButton* importButton() const { return import_; }
    [[nodiscard]] QToolButton* extractButton() const { return extract_; }
    [[nodiscard]] QToolButton* detailsButton() const { return detailsButton_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void favouriteWanted(const QString& key, bool favourite);
    void cardChanged(const limner::StyleCard& card); ///< of one of the user's own
    void removeWanted(const QString& key);
    void restoreWanted();
    void duplicateWanted(const QString& key);
    void importWanted();
    void extractRequested();
    /// A style's picture on the scan is to be seen, put onto `place()`; empty: none any more.
    void previewWanted(const QString& key);
    /// Ball size, details or pictures on the scan were switched.
    void lookChanged();

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void layOut();
    void connectParts();
    QWidget* sizeButtons();
    void showItems();
    void showTarget();
    void showDetails();
    void showTags();
    void applyFilter();
    void use(const QString& key);
    void toggleFavourite(const QString& key);
    void rename(const QString& key);
    void remove(const QString& key);
    void openMenu(const QString& key, const QPoint& globalPosition);
    void wantPreview();
    [[nodiscard]] std::optional<std::size_t> usedNode() const;
    /// Key of the style that a click would replace; empty: none that is listed.
    [[nodiscard]] std::string shownStyle() const;
    [[nodiscard]] std::vector<GalleryItem> projectItems();

    StyleSource source_;
    std::vector<GalleryItem> items_; ///< of disk and program
    std::vector<GalleryItem> project_;
    std::vector<StyleEntry> entries_; ///< of the figure, that `project_` was made of
    std::shared_ptr<const Figure> figure_;
    std::size_t layer_ = 0;
    std::optional<std::size_t> node_;
    std::string shown_; ///< what `shownStyle` gave last
    std::string hovered_;
    std::string preview_; ///< key of the picture that was asked for
    std::set<std::string> chosenTags_;
    bool removalOffered_ = false;
    QTimer rest_;

    QLabel* target_;
    QLineEdit* search_;
    QToolButton* favourites_;
    QToolButton* tags_;
    QMenu* tagMenu_;
    QButtonGroup* sizes_;
    QToolButton* detailsButton_;
    GalleryList* list_;
    QLabel* nothing_;
    StyleDetails* details_;
    QToolButton* import_;
    QToolButton* extract_;
};

} // namespace limner
