#pragma once

#include "core/figure/ramp_edits.h"
#include "widgets/gesture_key.h"

#include <QWidget>

namespace limner {

/// A colour ramp over 0..1 with its keys below: drag a key, double click it for another colour, double click the ramp
/// for a new key; Delete or the right button removes; arrow keys nudge, Ctrl with arrows goes to the next key. Two keys
/// at one place are a step. What it asks for goes out, nothing is kept.
class RampCanvas : public QWidget {
    Q_OBJECT

  public:
    explicit RampCanvas(QWidget* parent = nullptr);

    void setKeys(const RampKeys& keys);
    [[nodiscard]] const RampKeys& keys() const { return keys_; }
    /// Index of a key; 0 where there is none.
    [[nodiscard]] std::size_t selected() const { return selected_; }
    void select(std::size_t key);
    /// Middle of a key's handle.
    [[nodiscard]] QPointF positionOf(std::size_t key) const;
    void addKeyAt(double at);
    void removeSelected();

    [[nodiscard]] QSize sizeHint() const override { return {220, 44}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 44}; }

  Q_SIGNALS:
    /// `key`: merges the steps of one drag, and one run of key presses; the last of a drag is not ongoing.
    void changed(const limner::RampKeys& keys, const QString& what, const std::string& key, bool ongoing);
    void selectionChanged();
    void colourWanted();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    [[nodiscard]] QRectF bar() const;
    [[nodiscard]] double xOf(double at) const;
    [[nodiscard]] double placeOf(double x) const;
    /// The nearest key under a position; of keys at one place, the one that can follow the way the pointer goes.
    [[nodiscard]] std::optional<std::size_t> keyAt(QPointF position) const;
    void moveSelected(double at, bool ongoing);
    void paintKey(QPainter& painter, std::size_t key) const;

    RampKeys keys_;
    std::size_t selected_ = 0;
    bool dragging_ = false;
    bool moved_ = false;
    double grabOffset_ = 0; ///< from the key to the pointer, so that a press alone moves nothing
    GestureKey gesture_;
};

} // namespace limner
