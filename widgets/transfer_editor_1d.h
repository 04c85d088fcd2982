#pragma once

#include "widgets/transfer_canvas.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace limner {

/// The one-dimensional transfer function editor: the canvas, the selected handle's numbers in fields, the course of the
/// curve, and how the histogram is shown.
class TransferEditor1d : public QWidget {
    Q_OBJECT

  public:
    explicit TransferEditor1d(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer);
    void setHistogram(std::shared_ptr<const Histogram> histogram) { canvas_->setHistogram(std::move(histogram)); }
    /// How counts are shown; a choice of the view, not of the figure.
    [[nodiscard]] QComboBox* counts() const { return counts_; }
    [[nodiscard]] QComboBox* curve() const { return curve_; }
    void setStyleSource(StyleSource source) { canvas_->setStyleSource(std::move(source)); }
    [[nodiscard]] TransferCanvas* canvas() const { return canvas_; }
    /// The selected style node, if one is selected.
    [[nodiscard]] std::optional<std::size_t> selectedNode() const;

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void selectionChanged();

  private:
    void layOut();
    void connectParts();
    void showSelection();

    TransferCanvas* canvas_;
    QLabel* what_;
    QDoubleSpinBox* value_;
    QDoubleSpinBox* opacity_;
    QToolButton* add_;
    QToolButton* step_;
    QToolButton* remove_;
    QComboBox* curve_;
    QComboBox* counts_;
    bool locked_ = false; ///< the layer must stay as it is
};

} // namespace limner
