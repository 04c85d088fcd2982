#pragma once

#include "core/project/history.h"
#include "core/style/lit_sphere.h"

#include <QWidget>

#include <memory>
#include <optional>

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace limner {

/// The bundled styles as balls with their names, searchable. A click, Enter or a drop onto the transfer function puts
/// one onto the selected node, or onto the whole layer where no node is selected.
class StyleGallery : public QWidget {
    Q_OBJECT

  public:
    explicit StyleGallery(QWidget* parent = nullptr);

    /// Fills the gallery; pictures are made when the event loop has time for them.
    void setStyles(const std::vector<Style>& styles);
    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer, std::optional<std::size_t> node);
    [[nodiscard]] QListWidget* list() const { return list_; }
    [[nodiscard]] QLineEdit* search() const { return search_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);

  private:
    void use(const QListWidgetItem* item);
    void filter(const QString& words);
    void showTarget();
    void paintSome();

    QLabel* target_;
    QLineEdit* search_;
    QListWidget* list_;
    QLabel* nothing_;
    std::vector<Style> styles_;
    std::size_t painted_ = 0;
    std::shared_ptr<const Figure> figure_;
    std::size_t layer_ = 0;
    std::optional<std::size_t> node_;
};

} // namespace limner
