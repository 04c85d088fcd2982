#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <glm/vec2.hpp>

namespace limner {

/// Which part of an artwork a widget shows: pure geometry, in logical pixels of the widget.
class ArtworkView {
  public:
    /// Sizes of the widget and of the artwork. A view that fitted goes on fitting.
    void setSizes(QSizeF widget, QSizeF artwork);

    /// Logical pixels of the widget per artwork pixel.
    [[nodiscard]] double scale() const { return scale_; }
    [[nodiscard]] bool fits() const { return fits_; }
    [[nodiscard]] QPointF toWidget(glm::dvec2 onArtwork) const;
    [[nodiscard]] glm::dvec2 toArtwork(QPointF inWidget) const;
    /// Where the whole artwork lies in the widget.
    [[nodiscard]] QRectF sheet() const;

    /// The whole artwork with a margin.
    void fit();
    /// What is under `held` stays there.
    void zoomTo(double scale, QPointF held);
    void zoomBy(double factor, QPointF held) { zoomTo(scale_ * factor, held); }
    void panBy(QPointF pixels);

  private:
    void hold();

    QSizeF widget_{1, 1};
    QSizeF artwork_{1, 1};
    glm::dvec2 centre_{0.5, 0.5}; ///< artwork place in the widget's middle
    double scale_ = 1;
    bool fits_ = true;
};

} // namespace limner
