#pragma once

#include "widgets/style_source.h"

#include <QListWidget>
#include <QPixmap>

#include <map>
#include <set>
#include <vector>

namespace limner {

/// How large the balls are.
enum class BallSize { small, medium, large };

/// The gallery's list: headings with the styles of each home under them, as balls with their names. A heading folds
/// its section away. Styles are dragged out by their key; a star marks favourites. Says what is asked for, changes
/// nothing.
class GalleryList : public QListWidget {
    Q_OBJECT

  public:
    enum class Row { style, heading, note };
    static constexpr int kKeyRole = Qt::UserRole; ///< of styles: their key, as QString
    static constexpr int kRowRole = Qt::UserRole + 1;
    static constexpr int kHomeRole = Qt::UserRole + 2;
    static constexpr int kFavouriteRole = Qt::UserRole + 3;

    /// What of the items is shown; all of it must fit.
    struct Filter {
        QStringList words;          ///< lower case, of names and tags
        std::set<std::string> tags; ///< the style has all of these
        bool favourites = false;
        [[nodiscard]] bool any() const { return !words.isEmpty() || !tags.empty() || favourites; }
        friend bool operator==(const Filter&, const Filter&) = default;
    };

    explicit GalleryList(QWidget* parent = nullptr);

    /// Keeps what is current and how far it is scrolled where it can.
    void setItems(std::vector<GalleryItem> items);
    [[nodiscard]] const std::vector<GalleryItem>& items() const { return items_; }
    /// Null where there is none of that key.
    [[nodiscard]] const GalleryItem* find(const std::string& key) const;
    void setFilter(Filter filter);
    /// Shown styles, folded ones counted.
    [[nodiscard]] int fitting() const { return fitting_; }
    void setBallSize(BallSize size);
    [[nodiscard]] BallSize ballSize() const { return size_; }

    /// Key of the current style; empty: none.
    [[nodiscard]] std::string currentKey() const;
    /// Makes it current without asking for anything; clears where there is none of that key.
    void setCurrentKey(const std::string& key);
    /// The row of a style; null: it is not listed.
    [[nodiscard]] QListWidgetItem* rowOf(const std::string& key) const;
    /// Where the star of a row is, in the viewport's coordinates.
    [[nodiscard]] QRect starRect(const QListWidgetItem* row) const;
    [[nodiscard]] QPixmap ball(const std::string& key, int size);

  Q_SIGNALS:
    void useWanted(const QString& key);
    void favouriteWanted(const QString& key);
    void removeWanted(const QString& key);
    void renameWanted(const QString& key);
    void menuWanted(const QString& key, const QPoint& globalPosition);
    /// The pointer rests on a style; empty: on none.
    void hovered(const QString& key);

  protected:
    [[nodiscard]] QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
    [[nodiscard]] QStringList mimeTypes() const override;
    void startDrag(Qt::DropActions actions) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool viewportEvent(QEvent* event) override;

  private:
    void fill();
    void addSection(StyleHome home);
    void addStyle(const GalleryItem& item);
    void addNote(const QString& text, StyleHome home);
    void showFitting();
    void setFolded(StyleHome home, bool folded);
    [[nodiscard]] bool fits(const GalleryItem& item) const;
    /// The shown style nearest to a row; null: none is shown.
    [[nodiscard]] QListWidgetItem* styleFrom(int place) const;
    [[nodiscard]] bool isStyle(const QListWidgetItem* row) const;

    std::vector<GalleryItem> items_;
    std::map<std::string, std::size_t> places_; ///< in `items_`, by key
    Filter filter_;
    std::set<StyleHome> folded_;
    BallSize size_ = BallSize::medium;
    int fitting_ = 0;
    QListWidgetItem* pressed_ = nullptr; ///< a style that a click began on
    std::string hovered_;
    struct Ball {
        qint64 image = 0; ///< its cache key
        QPixmap pixmap;
    };
    std::map<std::pair<std::string, int>, Ball> balls_;
};

} // namespace limner
