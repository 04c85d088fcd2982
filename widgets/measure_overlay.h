#pragma once

#include "widgets/tool_overlay.h"

#include <optional>
#include <vector>

namespace limner {

/// Measuring on the figure: two clicks on what is seen give the straight distance between these places of the scan, a
/// third the angle at the second. The marks stay on the matter when the figure turns. Nothing of it is kept.
class MeasureOverlay : public ToolOverlay {
    Q_OBJECT

  public:
    explicit MeasureOverlay(Viewport* viewport);

    [[nodiscard]] const std::vector<glm::dvec3>& points() const { return pointsMm_; }
    [[nodiscard]] std::optional<double> distanceMm() const;
    [[nodiscard]] std::optional<double> angleDeg() const;

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void reset() override;
    [[nodiscard]] QString hint() const override;
    void paintTool(QPainter& painter) override;

  private:
    [[nodiscard]] std::optional<QPointF> onPicture(const glm::dvec3& pointMm) const;

    std::vector<glm::dvec3> pointsMm_; ///< at most three
    QPointF pointer_;
    bool missed_ = false; ///< the last click met no matter
};

} // namespace limner
