#pragma once

#include "renderer/accuracy/study.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace limner {

/// Error against run time as a study measured them, both logarithmic: a line for each way of sampling with the step as
/// parameter, a dot for each measurement, dashed what no other one beats, the named tolerances, the figure as it is,
/// and in grey what lies in the reference's own error. A tool tip says what a dot is.
class AccuracyChart : public QWidget {
    Q_OBJECT

  public:
    explicit AccuracyChart(QWidget* parent = nullptr);

    /// Null: empty paper.
    void setStudy(std::shared_ptr<const accuracy::Study> study);
    /// Where a row of the study is drawn, in the widget's coordinates.
    [[nodiscard]] QPointF placeOf(std::size_t row) const;
    /// The row within a few pixels of a place.
    [[nodiscard]] std::optional<std::size_t> rowAt(QPointF place) const;

    [[nodiscard]] QSize sizeHint() const override { return {360, 260}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 220}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

  private:
    /// Powers of ten, and the pixels they lie at.
    struct Axis {
        double low = 0;
        double high = 1;
        double from = 0;
        double to = 1;
        [[nodiscard]] double at(double value) const;
    };
    [[nodiscard]] Axis times() const;
    [[nodiscard]] Axis errors() const;
    [[nodiscard]] QRectF field() const;
    [[nodiscard]] double errorOf(std::size_t row) const;
    void paintGrid(QPainter& painter, const Axis& x, const Axis& y) const;
    void paintTolerances(QPainter& painter, const Axis& y) const;
    void paintLine(QPainter& painter, const std::vector<std::size_t>& rows) const;
    void paintSeries(QPainter& painter) const;
    void paintPresent(QPainter& painter) const;

    std::shared_ptr<const accuracy::Study> study_;
};

} // namespace limner
