#pragma once

#include "widgets/transfer_canvas_2d.h"

#include <QWidget>

class QButtonGroup;
class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace limner {

/// The two-dimensional transfer function editor: tools for shapes and masks, the canvas, the numbers of what is
/// selected, and the grid of styles.
class TransferEditor2d : public QWidget {
    Q_OBJECT

  public:
    explicit TransferEditor2d(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer);
    /// Why there is no histogram; empty: there is one, or it is being counted.
    void setNote(const QString& note);
    [[nodiscard]] TransferCanvas2d* canvas() const { return canvas_; }
    [[nodiscard]] QToolButton* button(PlaneTool tool) const;
    [[nodiscard]] QDoubleSpinBox* opacity() const { return opacity_; }
    [[nodiscard]] QDoubleSpinBox* softness() const { return softness_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void selectionChanged();

  private:
    QWidget* toolRow();
    QWidget* brushRow();
    QWidget* numberRow();
    QWidget* gridRow();
    void connectNumbers();
    void showSelection();

    TransferCanvas2d* canvas_;
    QButtonGroup* tools_;
    QToolButton* duplicate_;
    QToolButton* remove_;
    QWidget* brush_;
    QSlider* brushSize_;
    QSlider* brushSoftness_;
    QLabel* note_;
    QDoubleSpinBox* x_;
    QDoubleSpinBox* y_;
    QDoubleSpinBox* opacity_;
    QDoubleSpinBox* softness_;
    QToolButton* addColumn_;
    QToolButton* addRow_;
    QToolButton* removeColumn_;
    QToolButton* removeRow_;
    bool locked_ = false; ///< the layer must stay as it is
};

} // namespace limner
