#pragma once

#include "core/figure/camera.h"
#include "core/figure/layer.h"
#include "widgets/gesture_key.h"

#include <QWidget>

class QComboBox;

namespace limner {

/// A ball under a light: drag over it to move the light. Outside the rim the light comes from behind, as far as it is
/// dragged out. Arrow keys nudge. Directions as `lightSeen` gives them.
class LightBall : public QWidget {
    Q_OBJECT

  public:
    explicit LightBall(QWidget* parent = nullptr);
    void setDirection(const glm::dvec3& seen);
    [[nodiscard]] const glm::dvec3& direction() const { return seen_; }
    /// Where the light's mark is drawn.
    [[nodiscard]] QPointF positionOf(const glm::dvec3& seen) const;
    [[nodiscard]] QSize sizeHint() const override { return {60, 60}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

  Q_SIGNALS:
    void moved(const glm::dvec3& seen, const std::string& key, bool ongoing);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    [[nodiscard]] double radius() const;
    [[nodiscard]] glm::dvec3 directionAt(QPointF position) const;

    glm::dvec3 seen_{0, 0, 1};
    bool dragging_ = false;
    GestureKey gesture_;
};

/// A light: whether it moves with the viewer or with the scan, and where it stands.
class LightForm : public QWidget {
    Q_OBJECT

  public:
    /// `pointer`: of the light in the parameter table ("/layers/*/tone/light").
    explicit LightForm(const std::string& pointer, QWidget* parent = nullptr);
    void setLight(const Light& light, const Camera& camera);
    [[nodiscard]] QComboBox* kind() const { return kind_; }
    [[nodiscard]] LightBall* ball() const { return ball_; }

  Q_SIGNALS:
    void changed(const limner::Light& light, const std::string& key, bool ongoing);

  private:
    QComboBox* kind_;
    LightBall* ball_;
    Light light_;
    Camera camera_;
};

} // namespace limner
