#pragma once

#include "core/project/history.h"
#include "widgets/slice_canvas.h"

#include <QWidget>

#include <array>

class QLabel;
class QPushButton;

namespace limner {

/// The three flat pictures through one point of the scan, to find things: what is clicked in one is shown in all.
class SlicesPanel : public QWidget {
    Q_OBJECT

  public:
    explicit SlicesPanel(QWidget* parent = nullptr);

    /// `window`: the values shown from black to white.
    void setFigure(std::shared_ptr<const Figure> figure, const ValueRange& window);
    void setPoint(const glm::dvec3& pointMm);
    [[nodiscard]] const glm::dvec3& point() const { return pointMm_; }
    [[nodiscard]] SliceCanvas* canvas(SlicePlane plane) const { return canvases_[static_cast<std::size_t>(plane)]; }
    [[nodiscard]] QPushButton* lookHere() const { return lookHere_; }
    [[nodiscard]] QLabel* words() const { return words_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void pointMoved(const glm::dvec3& pointMm);

  private:
    void showPoint();

    std::shared_ptr<const Figure> figure_;
    glm::dvec3 pointMm_{0};
    std::array<SliceCanvas*, 3> canvases_{};
    QLabel* words_;
    QPushButton* lookHere_;
};

} // namespace limner
