#pragma once

#include "widgets/gesture_key.h"

#include <QWidget>

namespace limner {

/// A grip over the picture that is dragged with the mouse or nudged with the arrow keys (Shift: finely). It is a widget
/// of its own, so that what lies beside it is still the picture's.
class PictureHandle : public QWidget {
    Q_OBJECT

  public:
    enum class Look { round, square };

    PictureHandle(QWidget* over, Look look, const QString& name);
    /// Its middle, in the coordinates of what it lies over.
    void moveMiddle(QPointF middle);
    [[nodiscard]] QPointF middle() const { return QRectF(geometry()).center(); }
    [[nodiscard]] bool dragging() const { return dragging_; }

  Q_SIGNALS:
    void pressed();
    /// By how much the pointer is away from where it was pressed; the last of a drag is not ongoing.
    void dragged(QPointF by, const std::string& key, bool ongoing);
    /// Arrow keys: right and up are positive; 1 a press, a tenth with Shift.
    void nudged(double steps, const std::string& key);
    void removeWanted(); ///< Delete

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    Look look_;
    bool dragging_ = false;
    bool moved_ = false;
    QPointF press_; ///< in global coordinates: the handle moves under the pointer
    GestureKey gesture_;
};

} // namespace limner
