#pragma once

#include "core/project/history.h"
#include "widgets/gesture_key.h"

#include <QWidget>

#include <cstddef>
#include <memory>
#include <optional>

namespace limner {

class Viewport;
struct AnnotationPlace;

/// Handles on what is written over the viewport's picture, while the panel of annotations is seen: lettering is dragged
/// by itself, a label's point by its dot, which stays on matter. The chosen one has a frame. What is not on a handle
/// goes to the viewport. Delete removes the chosen one while the viewport has the focus. Edits go out, nothing is kept.
class AnnotationOverlay : public QWidget {
    Q_OBJECT

  public:
    explicit AnnotationOverlay(Viewport* viewport);

    void setFigure(std::shared_ptr<const Figure> figure);
    void setActive(bool active);
    void select(std::optional<std::size_t> index);
    [[nodiscard]] std::optional<std::size_t> selected() const { return selected_; }
    /// The middle of an annotation's box, and a label's dot, in the viewport's coordinates; nothing where it is not
    /// drawn.
    [[nodiscard]] std::optional<QPointF> middleOf(std::size_t index) const;
    [[nodiscard]] std::optional<QPointF> pointOf(std::size_t index) const;

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void chosen(std::size_t index);
    /// A double click on lettering: it wants other words.
    void wordsWanted(std::size_t index);
    void removeWanted();

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    enum class Part { none, words, point };
    struct Hit {
        Part part = Part::none;
        std::size_t index = 0;
    };

    /// Null where the picture shows other annotations than the figure has, or does not draw it.
    [[nodiscard]] const AnnotationPlace* placeOf(std::size_t index) const;
    [[nodiscard]] QPointF toWidget(const glm::dvec2& mm) const;
    [[nodiscard]] glm::dvec2 toFigure(QPointF position) const;
    [[nodiscard]] Hit hitAt(QPointF position) const;
    bool press(QPointF position);
    void drag(QPointF position, bool ongoing);
    void movePoint(Figure& figure, QPointF position) const;

    Viewport* viewport_;
    std::shared_ptr<const Figure> figure_;
    std::optional<std::size_t> selected_;
    bool active_ = false;
    Hit dragged_;
    bool moved_ = false;
    QPointF pressed_;
    glm::dvec2 grab_{0}; ///< from the pointer to the place at the press, in figure coordinates
    GestureKey key_;
};

} // namespace limner
