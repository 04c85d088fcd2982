#pragma once

#include "core/figure/camera_moves.h"
#include "core/figure/presets.h"
#include "core/project/history.h"
#include "renderer/pick.h"
#include "widgets/gesture_key.h"
#include "widgets/picture_feed.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

class QNativeGestureEvent;
class QPinchGesture;

namespace limner {

/// Shows the newest picture as a sheet of the figure's format on a grey desk, with what lies towards its edges (R/L,
/// A/P, S/I) and whether it is a draft. No OpenGL here. Mouse, wheel, touchpad and keys move the camera; the result
/// goes out as edits. The letters are those of the picture that is shown, not of the one that is still to come.
class Viewport : public QWidget {
    Q_OBJECT

  public:
    explicit Viewport(QWidget* parent = nullptr);

    /// The figure to edit. Null: nothing is shown.
    void setFigure(std::shared_ptr<const Figure> figure);
    void setPicture(const ScreenPicture& picture);
    void setTurnMode(TurnMode mode) { turnMode_ = mode; }
    [[nodiscard]] TurnMode turnMode() const { return turnMode_; }

    /// Device pixels of the sheet: what a picture for this window should have.
    [[nodiscard]] QSize picturePixels() const;
    [[nodiscard]] const std::optional<ScreenPicture>& picture() const { return picture_; }
    /// Letters at the edges of the shown picture, of the figure's camera before there is one.
    [[nodiscard]] EdgeLetters letters() const;
    /// The sheet in the widget's coordinates.
    [[nodiscard]] QRectF sheet() const;
    /// Figure coordinates, (0, 0) the sheet's top left corner and (1, 1) its bottom right, of a place of the widget;
    /// and back.
    [[nodiscard]] glm::dvec2 onFigure(QPointF position) const;
    [[nodiscard]] QPointF onScreen(const glm::dvec2& place) const;
    /// Where a point of the scan lies as a figure's camera sees it (tools may be ahead of the viewport); nothing behind
    /// the eye.
    [[nodiscard]] std::optional<QPointF> onScreen(const Figure& figure, const glm::dvec3& pointMm) const;
    /// What one sees at a place of the shown picture; nothing where that is paper, or nothing is shown. Some tenths of
    /// a millisecond.
    [[nodiscard]] std::optional<Pick> pickAt(QPointF position) const;

    [[nodiscard]] QSize sizeHint() const override { return {760, 760}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 240}; }

  public Q_SLOTS:
    void fit();
    void showSide(limner::StandardView side);
    void zoomBy(double factor);
    /// Degrees to the right and downwards.
    void turnBy(double sideways, double down);

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    /// A click that moved nothing, in the widget's coordinates.
    void clicked(QPointF position);
    /// The sheet has another number of pixels now.
    void picturePixelsChanged();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    enum class Drag { none, turn, pan };

    void paintSheet(QPainter& painter, const QRectF& sheet) const;
    void paintLetters(QPainter& painter, const QRectF& sheet) const;
    void paintBadge(QPainter& painter, const QRectF& sheet) const;
    bool nativeGesture(QNativeGestureEvent* event);
    bool pinch(QPinchGesture* gesture);
    /// Heights of the sheet from its middle, y down.
    [[nodiscard]] glm::dvec2 onSheet(QPointF position) const;
    [[nodiscard]] bool editable() const { return figure_ && figure_->volume && figure_->volume->data; }
    void emitCamera(const Camera& camera, const QString& label, const std::string& key, bool ongoing);
    /// For gestures without an end of their own (wheel, keys): more may follow; settles after a moment.
    void emitPassing(const Camera& camera, const QString& label, const std::string& name);
    void settle();

    std::shared_ptr<const Figure> figure_;
    std::optional<ScreenPicture> picture_;
    TurnMode turnMode_ = TurnMode::turntable;
    Drag drag_ = Drag::none;
    Camera dragCamera_; ///< at the press
    QPointF dragStart_;
    bool dragMoved_ = false;
    GestureKey key_;
    std::string passingKey_;
    QString passingLabel_;
    QTimer settle_;
};

} // namespace limner
