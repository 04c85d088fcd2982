#pragma once

#include "widgets/style_source.h"

#include <QWidget>

#include <optional>

class QFormLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace limner {

/// What the gallery shows of the chosen style: a large ball, a small picture of the figure in a style, and the card's
/// lines, to be changed where the style is the user's own. Says what is asked for, changes nothing.
class StyleDetails : public QWidget {
    Q_OBJECT

  public:
    explicit StyleDetails(QWidget* parent = nullptr);

    /// Nothing: no style is chosen. A line that is being typed stays while the same style is shown.
    void setItem(const std::optional<GalleryItem>& item);
    [[nodiscard]] const std::optional<GalleryItem>& item() const { return item_; }

    /// The figure as it would be; `of` names the style. A null picture: it is still to come.
    void setScanPicture(const QImage& picture, const QString& of);
    /// What stands in the picture's place while there is none; empty: nothing.
    void setScanNote(const QString& note);
    /// Device pixels of the longer side of a picture that fits.
    [[nodiscard]] int scanPixels() const;
    [[nodiscard]] QToolButton* onScan() const { return onScan_; } ///< checked: such pictures are wanted

    [[nodiscard]] QLineEdit* name() const { return name_; }
    [[nodiscard]] QLineEdit* tags() const { return tags_; }
    [[nodiscard]] QLineEdit* credit() const { return credit_; }
    [[nodiscard]] QLineEdit* licence() const { return licence_; }
    [[nodiscard]] QToolButton* duplicate() const { return duplicate_; }
    [[nodiscard]] QToolButton* remove() const { return remove_; }
    [[nodiscard]] QLabel* scanPicture() const { return scan_; }

  Q_SIGNALS:
    /// The card as it was typed, of the style that is shown.
    void cardChanged(const limner::StyleCard& card);
    void duplicateWanted();
    void removeWanted();

  private:
    QLineEdit* addLine(QFormLayout* form, const QString& label, const QString& tip);
    void showItem();
    void emitCard();
    [[nodiscard]] StyleCard typed() const;

    std::optional<GalleryItem> item_;
    QLabel* ball_;
    QLabel* scan_;
    QToolButton* onScan_;
    QLabel* home_;
    QLineEdit* name_;
    QLineEdit* tags_;
    QLineEdit* credit_;
    QLineEdit* licence_;
    QToolButton* duplicate_;
    QToolButton* remove_;
};

} // namespace limner
