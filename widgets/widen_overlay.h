#pragma once

#include "renderer/pick.h"
#include "widgets/gesture_key.h"
#include "widgets/tool_overlay.h"

#include <QPolygonF>

#include <cstddef>
#include <vector>

namespace limner {

class NewestJob;

/// Widen range: a hand that goes over a structure in the picture makes the chosen layer show the values under it, live,
/// as one step. Over one axis the flank of the nearest bump of opacity moves out, over two the nearest shape grows.
/// Values are read on a thread of their own, from the picture that was shown when the drag began.
class WidenOverlay : public ToolOverlay {
    Q_OBJECT

  public:
    explicit WidenOverlay(Viewport* viewport);
    ~WidenOverlay() override;

    /// The layer whose function is widened.
    void setLayer(std::size_t layer);
    [[nodiscard]] bool busy() const;

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintTool(QPainter& painter) override;
    void reset() override;
    [[nodiscard]] bool begun() const override { return dragging_; }
    [[nodiscard]] QString hint() const override;

  private:
    void follow(QPointF position);
    void readMore();
    void widen(const std::vector<Pick>& picks);
    void finish();
    [[nodiscard]] bool mayWiden() const;

    std::size_t layer_ = 0;
    bool dragging_ = false;
    bool released_ = false; ///< the hand has gone; what it went over is still being read
    bool missed_ = false;   ///< the last drag met nothing
    bool changed_ = false;
    QPolygonF path_;
    std::vector<glm::dvec2> waiting_; ///< pixels of the plan that are to be read
    std::shared_ptr<const RenderPlan> plan_;
    std::shared_ptr<PickTrail> trail_;
    NewestJob* job_;
    GestureKey key_;
};

/// Values of a one-dimensional function that show by now, within `range`: from the first with some opacity to the last.
ValueRange valuesThatShow(const Transfer& transfer, ValueRange range);

} // namespace limner
