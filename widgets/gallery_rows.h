#pragma once

#include <QStyledItemDelegate>

namespace limner {

class GalleryList;

/// Paints the rows of a gallery's list and says how large they are: styles share the list's width in even columns,
/// headings and notes have it whole.
class GalleryRows : public QStyledItemDelegate {
    Q_OBJECT

  public:
    static constexpr int kFoldedRole = Qt::UserRole + 10; ///< of headings

    explicit GalleryRows(GalleryList* list);

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// Where the star is in a style's row.
    static QRect starIn(const QRect& row);

  private:
    void paintStyle(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;

    GalleryList* list_;
};

} // namespace limner
