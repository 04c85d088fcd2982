#pragma once

#include "app/studio/workplace.h"

#include <QObject>

namespace limner {

class MeasureOverlay;
class PointMark;
class SlicesPanel;

/// Finding things: slices through the scan, linked with the picture both ways, and measuring on the picture.
class WindowSlices : public QObject {
    Q_OBJECT

  public:
    explicit WindowSlices(const Workplace& place);
    [[nodiscard]] SlicesPanel& panel() { return *panel_; }
    [[nodiscard]] PointMark& mark() { return *mark_; }
    [[nodiscard]] MeasureOverlay& measure() { return *measure_; }

  private:
    void showFigure();
    void showMark();
    /// A click on the picture brings the slices to what is seen there.
    void pickAt(QPointF position);

    Workplace place_;
    SlicesPanel* panel_;
    PointMark* mark_;
    MeasureOverlay* measure_;
    bool seen_ = false;
};

} // namespace limner
