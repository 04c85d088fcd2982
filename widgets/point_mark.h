#pragma once

#include "core/figure/figure.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace limner {

class Viewport;

/// A cross over the viewport's picture where a point of the scan lies. The mouse does not meet it.
class PointMark : public QWidget {
    Q_OBJECT

  public:
    explicit PointMark(Viewport* viewport);
    /// Hidden without a figure or a point.
    void setPoint(std::shared_ptr<const Figure> figure, std::optional<glm::dvec3> pointMm);
    /// In the viewport's coordinates; null where it is not before the eye.
    [[nodiscard]] std::optional<QPointF> place() const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    Viewport* viewport_;
    std::shared_ptr<const Figure> figure_;
    std::optional<glm::dvec3> pointMm_;
};

} // namespace limner
