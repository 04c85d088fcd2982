#pragma once

#include "core/project/history.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace limner {

class PictureHandle;
class Viewport;

/// The figure's crop box and clip planes over the viewport's picture: edges as lines, a square grip on each side of the
/// box and a round one on each plane, which move along their own normals. Grips whose normal points at the viewer have
/// nowhere to go on the screen and are left out. Edits go out, a drag is one step.
class ClipOverlay : public QWidget {
    Q_OBJECT

  public:
    explicit ClipOverlay(Viewport* viewport);

    /// Hidden without a figure.
    void setFigure(std::shared_ptr<const Figure> figure);
    /// Of side 0..5 of the box (low x, high x, low y, ...) or of a plane; null where there is none to be seen.
    [[nodiscard]] PictureHandle* boxGrip(std::size_t side) const;
    [[nodiscard]] PictureHandle* planeGrip(std::size_t plane) const;

  Q_SIGNALS:
    void edited(const limner::Edit& edit);

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// Something that moves along a direction: a side of the box or a plane.
    struct Grip {
        std::size_t index = 0; ///< 0..5: sides of the box; from 6 on: planes
        PictureHandle* handle = nullptr;
    };

    void placeGrips();
    void makeGrip(std::size_t index);
    [[nodiscard]] std::size_t gripCount() const;
    [[nodiscard]] std::optional<glm::dvec3> anchor(std::size_t index, const Clip& clip) const;
    [[nodiscard]] static glm::dvec3 outward(std::size_t index, const Clip& clip);
    /// Pixels that a millimetre along the grip's direction takes on the screen.
    [[nodiscard]] QPointF pixelsPerMm(std::size_t index, const Clip& clip) const;
    [[nodiscard]] std::optional<QPointF> onScreen(const glm::dvec3& pointMm) const;
    void moveBy(std::size_t index, double mm, const std::string& key, bool ongoing);

    Viewport* viewport_;
    std::shared_ptr<const Figure> figure_;
    Clip pressed_; ///< at the press of a grip
    std::vector<Grip> grips_;
};

} // namespace limner
