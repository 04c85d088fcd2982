#pragma once

#include "core/volume/histogram.h"
#include "widgets/transfer_plane.h"

namespace limner {

/// How counts become heights.
enum class CountScale { logarithmic, root, linear };

/// The drawing surface of the one-dimensional transfer function editor: the volume's histogram with the opacity curve
/// over it, a rail with the styles as balls at their values, and a ruler in the volume's unit. Drag points and balls;
/// double click adds a point; Delete or the right button removes; the wheel zooms the ruler, the middle button moves
/// it; arrow keys nudge, Ctrl with arrows goes to the next handle. Edits go out, nothing is kept.
class TransferCanvas : public TransferPlane {
    Q_OBJECT

  public:
    enum class HandleKind { point, node };
    struct Handle {
        HandleKind kind = HandleKind::point;
        std::size_t index = 0;
        friend bool operator==(const Handle&, const Handle&) = default;
    };

    explicit TransferCanvas(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) override;
    void setHistogram(std::shared_ptr<const Histogram> histogram);
    void setCountScale(CountScale scale);
    [[nodiscard]] CountScale countScale() const { return countScale_; }
    [[nodiscard]] const std::optional<Handle>& selected() const { return selected_; }
    void select(std::optional<Handle> handle);
    void showAll() override;

    using TransferPlane::positionOf;
    /// Where a handle is drawn; null for one that does not exist.
    [[nodiscard]] std::optional<QPointF> positionOf(const Handle& handle) const;
    [[nodiscard]] const Transfer* transfer() const override;
    /// Emits the edit that moves the selected handle, held within what is legal.
    void moveSelected(double value, std::optional<double> opacity, bool ongoing = false);
    void addPointAfterSelected();
    void makeStepAtSelected();
    void removeSelected();
    void setCurve(OpacityCurve curve);

    [[nodiscard]] QSize sizeHint() const override { return {420, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {260, 170}; }

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

  private:
    [[nodiscard]] double railY() const;
    [[nodiscard]] double yOf(double opacity) const;
    [[nodiscard]] double opacityOf(double y) const;
    [[nodiscard]] std::optional<Handle> handleAt(QPointF position) const;
    [[nodiscard]] std::optional<std::size_t> segmentAt(QPointF position) const;
    [[nodiscard]] QString describe(const Handle& handle) const;

    void paintHistogram(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintRail(QPainter& painter);
    void paintFilling(QPainter& painter) const;
    void paintOpacities(QPainter& painter) const;

    void dragTo(QPointF position, Qt::KeyboardModifiers modifiers);
    void nudge(QKeyEvent* event);
    void stepSelection(int by);
    void keepSelectionLegal();

    std::shared_ptr<const Histogram> histogram_;
    CountScale countScale_ = CountScale::logarithmic;
    std::optional<Handle> selected_;

    enum class Drag { none, handle, segment };
    Drag drag_ = Drag::none;
    QPointF dragStart_;
    Transfer dragTransfer_; ///< at the press
    std::size_t dragSegment_ = 0;
    bool dragMoved_ = false;
    std::optional<double> dropValue_; ///< where a dragged style would land
};

} // namespace limner
