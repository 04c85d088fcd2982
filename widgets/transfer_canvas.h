#pragma once

#include "core/project/history.h"
#include "core/volume/histogram.h"
#include "widgets/gesture_key.h"
#include "widgets/style_ball_cache.h"
#include "widgets/style_source.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace limner {

/// The drawing surface of the one-dimensional transfer function editor: the volume's histogram (logarithmic) with the
/// opacity curve over it, a rail with the styles as balls at their values, and a ruler in the volume's unit. Drag
/// points and balls; double click adds a point; Delete or the right button removes; the wheel zooms the ruler, the
/// middle button moves it; arrow keys nudge, Ctrl with arrows goes to the next handle. Edits go out, nothing is kept.
class TransferCanvas : public QWidget {
    Q_OBJECT

  public:
    enum class HandleKind { point, node };
    struct Handle {
        HandleKind kind = HandleKind::point;
        std::size_t index = 0;
        friend bool operator==(const Handle&, const Handle&) = default;
    };

    explicit TransferCanvas(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer);
    void setHistogram(std::shared_ptr<const Histogram> histogram);
    /// Where a dropped style comes from; without one nothing can be dropped.
    void setStyleSource(StyleSource source) { styles_ = std::move(source); }
    [[nodiscard]] const std::optional<Handle>& selected() const { return selected_; }
    void select(std::optional<Handle> handle);
    /// The part of the value axis that shows all that matters.
    void showAll();

    /// Where a handle is drawn; null for one that does not exist.
    [[nodiscard]] std::optional<QPointF> positionOf(const Handle& handle) const;
    [[nodiscard]] const Transfer* transfer() const;
    [[nodiscard]] QString unit() const;
    /// Emits the edit that moves the selected handle, held within what is legal.
    void moveSelected(double value, std::optional<double> opacity, bool ongoing = false);
    void addPointAfterSelected();
    void makeStepAtSelected();
    void removeSelected();

    [[nodiscard]] QSize sizeHint() const override { return {420, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {260, 170}; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void selectionChanged();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;

  private:
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] double railY() const;
    [[nodiscard]] double xOf(double value) const;
    [[nodiscard]] double valueOf(double x) const;
    [[nodiscard]] double yOf(double opacity) const;
    [[nodiscard]] double opacityOf(double y) const;
    [[nodiscard]] std::optional<Handle> handleAt(QPointF position) const;
    [[nodiscard]] std::optional<std::size_t> segmentAt(QPointF position) const;
    [[nodiscard]] QString describe(const Handle& handle) const;

    void paintHistogram(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintRail(QPainter& painter);
    void paintRuler(QPainter& painter) const;
    void paintNote(QPainter& painter, const QString& text) const;

    void emitTransfer(const Transfer& transfer, const QString& label, const std::string& key, bool ongoing);
    void dragTo(QPointF position, Qt::KeyboardModifiers modifiers);
    void nudge(QKeyEvent* event);
    void stepSelection(int by);
    void keepSelectionLegal();

    std::shared_ptr<const Figure> figure_;
    std::size_t layer_ = 0;
    std::shared_ptr<const Histogram> histogram_;
    double low_ = 0; ///< shown part of the value axis
    double high_ = 1;
    std::optional<Handle> selected_;

    enum class Drag { none, handle, segment, axis };
    Drag drag_ = Drag::none;
    QPointF dragStart_;
    Transfer dragTransfer_; ///< at the press
    std::size_t dragSegment_ = 0;
    double dragLow_ = 0, dragHigh_ = 1;
    bool dragMoved_ = false;
    std::optional<double> dropValue_; ///< where a dragged style would land
    GestureKey key_;
    StyleBallCache balls_;
    StyleSource styles_;
};

/// "1 250" or "0.125": as many digits as the step between neighbouring pixels needs.
QString valueText(double value, double resolution);

} // namespace limner
