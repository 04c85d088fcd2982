#pragma once

#include "core/figure/figure.h"
#include "core/volume/slice.h"
#include "widgets/newest_job.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>

namespace limner {

/// How slices are shown: values from black to white, with what the figure's layers show laid over in their colours.
struct SliceLook {
    ValueRange window;       ///< black and white, in the data's unit
    std::vector<QRgb> tints; ///< over `tinted` in equal steps, not premultiplied; empty: none
    ValueRange tinted;
    friend bool operator==(const SliceLook&, const SliceLook&) = default;
};

/// What a figure's layers show of values, for slices: layers over another axis than the value are left out.
SliceLook sliceLook(const Figure& figure, const ValueRange& window);

/// One flat picture through the scan with cross hairs at the point that all slices share. Click or drag: the point goes
/// there; wheel and Page keys: to the next slice; Ctrl and wheel: closer; arrow keys: by one voxel; Shift and drag:
/// measures. Pictures are made off the interface's thread.
class SliceCanvas : public QWidget {
    Q_OBJECT

  public:
    explicit SliceCanvas(SlicePlane plane, QWidget* parent = nullptr);

    void setVolume(std::shared_ptr<const Volume> volume);
    void setLook(const SliceLook& look);
    void setPoint(const glm::dvec3& pointMm);
    [[nodiscard]] const QImage& picture() const { return picture_; }
    [[nodiscard]] std::optional<double> measuredMm() const;
    /// Where a point of this slice is drawn, and what is drawn at a place.
    [[nodiscard]] QPointF onScreen(const glm::dvec3& pointMm) const;
    [[nodiscard]] glm::dvec3 pointAt(QPointF position) const;

    [[nodiscard]] QSize sizeHint() const override { return {240, 220}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 100}; }

  Q_SIGNALS:
    void pointMoved(const glm::dvec3& pointMm);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void wantPicture();
    void fit();
    void zoomAt(QPointF position, double factor);
    void paintCross(QPainter& painter) const;
    void paintWords(QPainter& painter) const;
    void paintMeasure(QPainter& painter) const;
    void step(const glm::dvec3& direction, double voxels);

    SlicePlane plane_;
    SliceAxes axes_;
    std::shared_ptr<const Volume> volume_;
    SliceLook look_;
    glm::dvec3 pointMm_{0};
    glm::dvec3 middleMm_{0}; ///< in the middle of the widget; its part through the slice is the point's
    double mmPerPixel_ = 1;  ///< of the widget's pixels
    bool fitted_ = false;
    QImage picture_;
    glm::dvec3 pictureMiddleMm_{0}; ///< the picture may be of a moment ago
    double pictureMmPerPixel_ = 1;
    std::optional<glm::dvec3> measureFrom_, measureTo_;
    NewestJob* job_;
};

} // namespace limner
