#pragma once

#include "widgets/tool_overlay.h"

#include <optional>
#include <vector>

namespace limner {

/// Scissors over the picture: an outline drawn with the mouse, by one free-hand stroke that closes when it is let go,
/// or by corners that are clicked and closed by Enter or a double click. What it encloses is cut away along the view
/// as a clean-up step; I changes to what is outside. Backspace takes the last corner back, Escape lays the scissors
/// down. A turn of the view gives the outline up.
class ScissorsOverlay : public ToolOverlay {
    Q_OBJECT

  public:
    explicit ScissorsOverlay(Viewport* viewport);

    void setFigure(std::shared_ptr<const Figure> figure) override;
    void setSide(ScissorsSide side);
    [[nodiscard]] ScissorsSide side() const { return side_; }
    /// In figure coordinates.
    [[nodiscard]] const std::vector<glm::dvec2>& outline() const { return outline_; }

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void reset() override;
    [[nodiscard]] bool begun() const override { return !outline_.empty(); }
    void paintTool(QPainter& painter) override;
    [[nodiscard]] QString hint() const override;

  private:
    /// Cuts and lays the scissors down; an outline that encloses nothing is given up.
    void cut();
    void addPoint(QPointF position);

    ScissorsSide side_ = ScissorsSide::inside;
    std::vector<glm::dvec2> outline_;
    std::size_t strokeStart_ = 0; ///< points before the stroke under way
    bool drawing_ = false;        ///< the button is down
    std::optional<QPointF> pointer_;
};

} // namespace limner
