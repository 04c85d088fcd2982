#pragma once

#include "widgets/artwork_tool.h"
#include "widgets/draft_edits.h"

#include <optional>

namespace limner {

/// Draws a ball's outline, as a circle or an ellipse, and holds the one that there is by its handles. A click takes the
/// proposal under it. Alt draws the other way (edge to edge, or from the centre), Shift draws a circle.
class EllipseTool : public ArtworkTool {
    Q_DECLARE_TR_FUNCTIONS(limner::EllipseTool)

  public:
    EllipseTool(ToolHost& host, bool circle) : ArtworkTool(host), circle_(circle) {}

    void press(const ToolPointer& pointer) override;
    void drag(const ToolPointer& pointer) override;
    void release(const ToolPointer& pointer) override;
    void hover(const ToolPointer& pointer) override;
    void cancel() override;
    bool nudge(glm::dvec2 by) override;
    void remove() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] Qt::CursorShape cursor() const override;
    [[nodiscard]] QString hint() const override;

    /// The smallest proposal around a place.
    [[nodiscard]] std::optional<std::size_t> proposalAt(glm::dvec2 place) const;

  private:
    [[nodiscard]] const Ellipse* shown() const;
    [[nodiscard]] std::optional<EllipseHandle> handleAt(const ToolPointer& pointer) const;
    [[nodiscard]] glm::dvec2 placeOf(EllipseHandle handle) const;
    [[nodiscard]] ExtractionDraft with(const Ellipse& ellipse) const;
    [[nodiscard]] Ellipse drawnTo(const ToolPointer& pointer) const;

    enum class Way { none, pressed, drawing, holding };

    bool circle_;
    Way way_ = Way::none;
    bool moved_ = false;
    EllipseHandle held_ = EllipseHandle::centre;
    Ellipse start_;      ///< as it was when it was taken hold of
    glm::dvec2 grab_{0}; ///< from the pointer to the handle
    ToolPointer from_;
    std::optional<std::size_t> hovered_;
    std::optional<EllipseHandle> hoveredHandle_;
};

} // namespace limner
