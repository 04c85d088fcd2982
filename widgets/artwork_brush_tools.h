#pragma once

#include "widgets/artwork_tool.h"

namespace limner {

/// Outlines a form by a lasso: a new one, Shift adds to the one that there is, Alt takes away. With the option the
/// outline is fitted to the picture's edges, which is asked of the canvas.
class OutlineTool : public ArtworkTool {
    Q_DECLARE_TR_FUNCTIONS(limner::OutlineTool)

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
    ArtPath path_; ///< empty: nothing is begun
    OutlineMode mode_ = OutlineMode::replace;
};

/// The draft with an outlined form; a new form has no marks yet.
ExtractionDraft withOutline(const ExtractionDraft& draft, const ArtPath& outline, OutlineMode mode);
ExtractionDraft withRegion(const ExtractionDraft& draft, MaskPtr region, OutlineMode mode);

/// Paints the form, or what is to be ignored; Alt erases.
class BrushTool : public ArtworkTool {
    Q_DECLARE_TR_FUNCTIONS(limner::BrushTool)

  public:
    enum class On { region, ignored };
    BrushTool(ToolHost& host, On on) : ArtworkTool(host), on_(on) {}

    void press(const ToolPointer& pointer) override;
    void drag(const ToolPointer& pointer) override;
    void release(const ToolPointer& pointer) override;
    void hover(const ToolPointer& pointer) override;
    void cancel() override { painting_ = false; }
    void remove() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::BlankCursor; } // its circle is painted
    [[nodiscard]] QString hint() const override;

  private:
    [[nodiscard]] const MaskPtr& mask() const;
    void strokeTo(const ToolPointer& pointer, bool ongoing);
    [[nodiscard]] QString label() const;

    On on_;
    bool painting_ = false;
    bool erases_ = false;
    ToolPointer last_;
    bool over_ = false;
};

} // namespace limner
