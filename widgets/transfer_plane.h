#pragma once

#include "core/project/history.h"
#include "widgets/axis_view.h"
#include "widgets/gesture_key.h"
#include "widgets/style_ball_cache.h"
#include "widgets/style_source.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace limner {

struct TissueHint;

/// What the canvases of transfer functions share: a plot over a value axis with its ruler, zoom and shift of it (wheel,
/// middle button, plus and minus, Home), hints of tissues where the values are Hounsfield units, the mark of what lies
/// under the pointer in the picture, and edits of a layer's transfer function.
class TransferPlane : public QWidget {
    Q_OBJECT

  public:
    explicit TransferPlane(QWidget* parent = nullptr);

    virtual void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer);
    /// Where a dropped style comes from; without one nothing can be dropped.
    void setStyleSource(StyleSource source) { styles_ = std::move(source); }
    [[nodiscard]] const StyleSource& styleSource() const { return styles_; }
    /// The layer's transfer function; null where there is none of the canvas's number of axes.
    [[nodiscard]] virtual const Transfer* transfer() const = 0;
    [[nodiscard]] QString unit() const; ///< of the first axis

    /// The part of the axes that shows all that matters.
    virtual void showAll() = 0;
    /// All values of the scan, however few voxels have them.
    virtual void showWhole();
    /// `factor` below 1 shows less; about the middle.
    void zoomBy(double factor);
    void showValues(ValueRange range);
    [[nodiscard]] ValueRange shownValues() const { return {x_.low(), x_.high()}; }
    /// Where a tissue's hint is drawn; null where it is not.
    [[nodiscard]] std::optional<QPointF> positionOf(const TissueHint& hint) const;

    /// What the picture shows under the pointer, in the axes' units.
    struct Mark {
        double x = 0;
        std::optional<double> y = {};
        friend bool operator==(const Mark&, const Mark&) = default;
    };
    void setMark(std::optional<Mark> mark);
    [[nodiscard]] const std::optional<Mark>& mark() const { return mark_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void selectionChanged();
    void shownChanged(); ///< another part of the axes is seen

  protected:
    void wheelEvent(QWheelEvent* event) override;
    /// Shows the tips.
    bool event(QEvent* event) override;
    /// What is said of the handle at a place; empty: there is none.
    [[nodiscard]] virtual QString handleTip(QPointF position) const = 0;
    /// What can be done here, where nothing else is to be said.
    [[nodiscard]] virtual QString advice() const = 0;

    [[nodiscard]] virtual QRectF plot() const = 0;
    /// Zooms about a place of the widget.
    virtual void zoomAt(QPointF position, double factor);
    /// The middle button: begins, follows and ends a shift of the axes.
    virtual void beginShift(QPointF position);
    virtual void shiftTo(QPointF position);
    void endShift() { shiftFrom_.reset(); }
    [[nodiscard]] bool shifting() const { return shiftFrom_.has_value(); }
    [[nodiscard]] QPointF shiftFrom() const { return shiftFrom_.value_or(QPointF()); }
    /// Plus, minus and Home; whether it was one of them.
    bool zoomKey(const QKeyEvent& event);

    [[nodiscard]] double xOf(double value) const { return plot().left() + x_.shareOf(value) * plot().width(); }
    [[nodiscard]] double valueOf(double x) const { return x_.valueOf((x - plot().left()) / plot().width()); }
    [[nodiscard]] const Volume* volume() const;
    /// Of the layer, whatever its number of axes.
    [[nodiscard]] const Transfer* anyTransfer() const;
    [[nodiscard]] bool isHounsfield() const; ///< the first axis is
    [[nodiscard]] double hintHeight() const; ///< 0 where there are no hints
    /// The strip of hints; empty where there are none.
    [[nodiscard]] QRectF hintStrip() const;
    [[nodiscard]] const TissueHint* hintAt(QPointF position) const;

    /// The ruler's line lies at `top`.
    void paintRuler(QPainter& painter, double top) const;
    void paintNote(QPainter& painter, const QString& text) const;
    void paintMark(QPainter& painter, double bottom) const;
    void paintFocus(QPainter& painter) const;
    void paintBall(QPainter& painter, const TransferNode& node, QPointF centre, bool chosen);

    /// The style that is dropped; null where there is none, or the layer may not change.
    [[nodiscard]] std::shared_ptr<const Style> droppedStyle(const QDropEvent& event) const;
    /// Refused where the layer is locked.
    void emitTransfer(const Transfer& transfer, const QString& label, const std::string& key, bool ongoing);

    static constexpr int kBall = 24;     ///< diameter of a style
    static constexpr double kRuler = 24; ///< height of the ruler
    static constexpr double kGrab = 10;  ///< how far from a handle a press still takes it
    static constexpr double kGrabBall = 14;
    static constexpr double kStillAClick = 2; ///< pixels

    std::shared_ptr<const Figure> figure_;
    std::size_t layer_ = 0;
    AxisView x_;
    GestureKey key_;
    StyleSource styles_;

  private:
    std::optional<QPointF> shiftFrom_;
    AxisView shiftedX_; ///< at the press
    std::optional<Mark> mark_;
    StyleBallCache balls_;
};

} // namespace limner
