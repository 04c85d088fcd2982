#pragma once

#include "widgets/artwork_tool.h"

#include <optional>

namespace limner {

/// Tells a form's normal at a place: a press sets a mark, dragging its needle turns and tilts it. Ctrl moves a mark.
class NormalTool : public ArtworkTool {
    Q_DECLARE_TR_FUNCTIONS(limner::NormalTool)

  public:
    using ArtworkTool::ArtworkTool;

    void press(const ToolPointer& pointer) override;
    void drag(const ToolPointer& pointer) override;
    void release(const ToolPointer& pointer) override;
    void cancel() override;
    bool nudge(glm::dvec2 by) override;
    void remove() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] std::optional<std::size_t> selected() const;

  private:
    [[nodiscard]] bool canMark() const { return draft().region != nullptr; }
    [[nodiscard]] ExtractionDraft with(const NormalMark& mark) const;
    [[nodiscard]] NormalMark changedBy(const ToolPointer& pointer) const;

    enum class Way { none, turning, moving };
    Way way_ = Way::none;
    std::optional<std::size_t> selected_;
    NormalMark start_;
    bool moved_ = false;
    bool fresh_ = false;
};

/// Draws ridges and valleys: clicks set corners, Enter or a double click ends; the handle across it tilts the sides.
class CreaseTool : public ArtworkTool {
    Q_DECLARE_TR_FUNCTIONS(limner::CreaseTool)

  public:
    using ArtworkTool::ArtworkTool;

    void press(const ToolPointer& pointer) override;
    void drag(const ToolPointer& pointer) override;
    void release(const ToolPointer& pointer) override;
    void hover(const ToolPointer& pointer) override;
    void finish() override;
    void cancel() override;
    bool nudge(glm::dvec2 by) override;
    void remove() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] std::optional<std::size_t> selected() const;
    /// Where the chosen crease's handle is, in the canvas.
    [[nodiscard]] std::optional<QPointF> handle() const;

  private:
    [[nodiscard]] ExtractionDraft with(const Crease& crease) const;
    [[nodiscard]] std::optional<std::size_t> creaseAt(const ToolPointer& pointer) const;
    [[nodiscard]] bool takeHold(const ToolPointer& pointer);

    enum class Way { none, tilting, moving };
    Way way_ = Way::none;
    ArtPath begun_;
    ToolPointer last_;
    std::optional<std::size_t> selected_;
    std::size_t corner_ = 0;
    bool moved_ = false;
};

/// Draws along parts of a form's outline where the form goes on, hidden or cut off.
class OpenOutlineTool : public ArtworkTool {
    Q_DECLARE_TR_FUNCTIONS(limner::OpenOutlineTool)

  public:
    using ArtworkTool::ArtworkTool;

    void press(const ToolPointer& pointer) override;
    void drag(const ToolPointer& pointer) override;
    void release(const ToolPointer& pointer) override;
    void cancel() override;
    void remove() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QString hint() const override;

  private:
    ArtPath begun_;
    std::optional<std::size_t> selected_;
};

} // namespace limner
