#pragma once

#include "core/figure/shape_edits.h"
#include "core/volume/joint_histogram.h"
#include "widgets/transfer_plane.h"

#include <QImage>

namespace limner {

/// What the pointer does on the plane.
enum class PlaneTool { select, rectangle, trapezoid, ellipse, polygon, paint, erase };

/// The drawing surface of the two-dimensional transfer function editor: how the scan's voxels lie in the plane of two
/// axes (logarithmic), the opacity shapes over it in the colours of their styles, and the styles as balls at the nodes
/// of their grid. Shapes are drawn with a tool, moved, and resized by the handles of the selected one; a double click
/// on a polygon adds a point. A ball moves its column and its row. Zoom as in `TransferPlane`, over both axes. With the
/// keyboard: Control with arrows goes from handle to handle, arrows move (Shift: ten times as far), Insert adds a shape
/// of the tool's kind, Control+D duplicates, Delete removes. Edits go out, nothing is kept.
class TransferCanvas2d : public TransferPlane {
    Q_OBJECT

  public:
    enum class HandleKind {
        shape,  ///< all of it
        corner, ///< `part`: of `handlesOf`
        node,   ///< `index`: counted row by row
    };
    struct Handle {
        HandleKind kind = HandleKind::shape;
        std::size_t index = 0;
        std::size_t part = 0;
        friend bool operator==(const Handle&, const Handle&) = default;
    };
    struct Brush {
        double radius = 14; ///< pixels
        double softness = 0.5;
    };

    explicit TransferCanvas2d(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) override;
    /// Over the transfer's axes; null: none is shown.
    void setHistogram(std::shared_ptr<const JointHistogram> histogram);
    void setTool(PlaneTool tool);
    [[nodiscard]] PlaneTool tool() const { return tool_; }
    void setBrush(const Brush& brush);
    [[nodiscard]] const Brush& brush() const { return brush_; }

    [[nodiscard]] const std::optional<Handle>& selected() const { return selected_; }
    void select(std::optional<Handle> handle);
    /// The shape that is selected, or a corner of it.
    [[nodiscard]] std::optional<std::size_t> selectedShape() const;
    [[nodiscard]] std::optional<std::size_t> selectedNode() const;
    /// Null where it does not exist, or a shape has no area on the screen.
    [[nodiscard]] std::optional<QPointF> positionOf(const Handle& handle) const;
    using TransferPlane::positionOf;
    /// In the axes' units.
    [[nodiscard]] std::optional<glm::dvec2> placeOf(const Handle& handle) const;
    [[nodiscard]] const Transfer* transfer() const override;
    [[nodiscard]] glm::dvec2 placeAt(QPointF position) const;
    [[nodiscard]] QPointF positionAt(const glm::dvec2& place) const;

    void showAll() override;
    void showWhole() override { showAll(); }

    void moveSelected(const glm::dvec2& to, bool ongoing = false);
    void setOpacity(double opacity);
    void setSoftness(double softness);
    /// A shape of the tool's kind (rectangle: of none) in the middle of what is shown.
    void addShape();
    void duplicateSelected();
    void removeSelected();
    /// Beside the selected node, or in the middle of what is shown.
    void addColumn();
    void addRow();
    void removeColumn();
    void removeRow();

    [[nodiscard]] QSize sizeHint() const override { return {420, 300}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {260, 190}; }

  Q_SIGNALS:
    void toolChanged(limner::PlaneTool tool); ///< by the canvas itself: a shape is drawn, the pointer selects again

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;
    [[nodiscard]] QString handleTip(QPointF position) const override;
    [[nodiscard]] QString advice() const override;

    [[nodiscard]] QRectF plot() const override;
    void zoomAt(QPointF position, double factor) override;
    void beginShift(QPointF position) override;
    void shiftTo(QPointF position) override;

  private:
    enum class Drag { none, handle, draw, brush };

    [[nodiscard]] double yOf(double value) const { return plot().bottom() - y_.shareOf(value) * plot().height(); }
    [[nodiscard]] double secondOf(double y) const { return y_.valueOf((plot().bottom() - y) / plot().height()); }
    [[nodiscard]] PlaneBox shown() const { return {{x_.low(), y_.low()}, {x_.high(), y_.high()}}; }
    [[nodiscard]] static std::optional<glm::dvec2> placeIn(const Transfer& transfer, const Handle& handle);
    [[nodiscard]] bool isLegal(const Handle& handle) const;
    [[nodiscard]] std::vector<Handle> allHandles() const;
    [[nodiscard]] std::optional<Handle> handleAt(QPointF position) const;
    /// Every place of the plane is some ball's.
    [[nodiscard]] std::optional<Handle> nearestNode(QPointF position) const;
    [[nodiscard]] TransferNode nodeOf(std::size_t cell) const;
    [[nodiscard]] QString describe(const Handle& handle) const;
    [[nodiscard]] QString secondUnit() const;
    [[nodiscard]] bool paints() const { return tool_ == PlaneTool::paint || tool_ == PlaneTool::erase; }

    [[nodiscard]] Transfer moved(const Transfer& from, const Handle& handle, const glm::dvec2& to) const;
    void emitShape(const OpacityShape& shape, const QString& label);
    void emitGrid(const TransferGrid& grid, const QString& label);
    void beginDrawing(QPointF position);
    void drawTo(QPointF position, bool ongoing);
    void brushTo(QPointF position);
    void dragTo(QPointF position, Qt::KeyboardModifiers modifiers);
    void stepSelection(int by);
    void nudge(const QKeyEvent& event);
    [[nodiscard]] glm::dvec2 snapped(glm::dvec2 place) const; ///< labels are whole numbers

    void paintCounts(QPainter& painter);
    void paintOpacity(QPainter& painter);
    void paintOutline(QPainter& painter, const OpacityShape& shape, bool chosen) const;
    void paintHandles(QPainter& painter) const;
    void paintGrid(QPainter& painter);
    void paintSecondRuler(QPainter& painter) const;
    void paintCross(QPainter& painter) const;

    std::shared_ptr<const JointHistogram> histogram_;
    QImage counts_; ///< the histogram, a pixel a bin
    AxisView y_;
    AxisView shiftedY_; ///< at the press
    PlaneTool tool_ = PlaneTool::select;
    Brush brush_;
    std::optional<Handle> selected_;
    Drag drag_ = Drag::none;
    QPointF dragStart_;
    QPointF dragLast_;
    Transfer dragTransfer_; ///< at the press; a brush: painted so far
    bool dragMoved_ = false;
    QPointF pointer_; ///< where the brush is shown
    std::optional<Handle> dropNode_;

    struct Drawn { ///< what `opacity_` is a picture of
        Transfer transfer;
        PlaneBox part;
        QSize pixels;
        friend bool operator==(const Drawn&, const Drawn&) = default;
    };
    std::optional<Drawn> drawn_;
    QImage opacity_;
};

} // namespace limner
