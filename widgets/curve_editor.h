#pragma once

#include "core/figure/transfer_edits.h"
#include "widgets/gesture_key.h"

#include <QWidget>

#include <optional>

namespace limner {

/// A small curve over 0..1 both ways: drag a point, double click for a new one, the right button or Delete removes;
/// arrow keys nudge, Ctrl with arrows goes to the next point. Two points at one place are a step. What it asks for goes
/// out, nothing is kept.
class CurveEditor : public QWidget {
    Q_OBJECT

  public:
    /// `axis`: what runs along the bottom.
    explicit CurveEditor(QString axis, QWidget* parent = nullptr);

    void setPoints(const OpacityPoints& points);
    [[nodiscard]] const OpacityPoints& points() const { return points_; }
    [[nodiscard]] std::optional<std::size_t> selected() const { return selected_; }
    void select(std::optional<std::size_t> point);
    [[nodiscard]] QPointF positionOf(glm::dvec2 point) const;

    [[nodiscard]] QSize sizeHint() const override { return {220, 96}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 96}; }

  Q_SIGNALS:
    /// `key`: merges the steps of one drag, and one run of key presses; the last of a drag is not ongoing.
    void changed(const limner::OpacityPoints& points, const QString& what, const std::string& key, bool ongoing);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] glm::dvec2 placeOf(QPointF position) const;
    [[nodiscard]] std::optional<std::size_t> pointAt(QPointF position) const;
    void moveSelected(glm::dvec2 to, bool ongoing);
    void removeSelected();
    void paintWords(QPainter& painter) const;

    QString axis_;
    OpacityPoints points_;
    std::optional<std::size_t> selected_;
    bool dragging_ = false;
    bool moved_ = false;
    QPointF grabOffset_; ///< from the point to the pointer, so that a press alone moves nothing
    GestureKey gesture_;
};

} // namespace limner
