#pragma once

#include "core/project/history.h"
#include "widgets/gesture_key.h"

#include <QWidget>

#include <cstddef>
#include <memory>
#include <optional>

namespace limner {

class Viewport;

/// The chosen lens over the viewport's picture: its outline, a handle in the middle that moves it and one on the edge
/// that resizes it. With the keyboard: arrow keys move (Shift: finely), plus and minus resize, Delete removes, Escape
/// leaves. What is not on a handle goes to the viewport. Edits go out, nothing is kept.
class LensOverlay : public QWidget {
    Q_OBJECT

  public:
    explicit LensOverlay(Viewport* viewport);

    /// Hidden without a lens.
    void setFigure(std::shared_ptr<const Figure> figure, std::optional<std::size_t> lens);
    /// Where the handles are drawn; null where the lens is not seen.
    [[nodiscard]] std::optional<QPointF> middle() const;
    [[nodiscard]] std::optional<QPointF> edge() const;

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void left();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    enum class Drag { none, middle, edge };

    [[nodiscard]] const Lens* lens() const;
    /// Of its middle, in heights of the figure from the top left corner.
    [[nodiscard]] std::optional<glm::dvec2> place() const;
    [[nodiscard]] QPointF toWidget(const glm::dvec2& onSheet) const;
    [[nodiscard]] glm::dvec2 toSheet(QPointF position) const;
    [[nodiscard]] Drag handleAt(QPointF position) const;
    void moveTo(const glm::dvec2& to, const std::string& key, bool ongoing);
    void resizeTo(double radius, const std::string& key, bool ongoing);
    void removeLens();
    void emitLens(const Lens& changed, const QString& label, const std::string& key, bool ongoing);

    Viewport* viewport_;
    std::shared_ptr<const Figure> figure_;
    std::optional<std::size_t> lens_;
    Drag drag_ = Drag::none;
    QPointF grab_; ///< from the pointer to the handle at the press
    bool dragMoved_ = false;
    GestureKey key_;
};

} // namespace limner
