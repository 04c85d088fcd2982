#pragma once

#include "core/volume/joint_histogram.h"
#include "widgets/transfer_editor_1d.h"
#include "widgets/transfer_editor_2d.h"

class QComboBox;
class QLabel;
class QStackedWidget;

namespace limner {

/// A layer's transfer function, over one axis or two: the axes to choose from, and the editor that fits. Without a
/// second axis the function is a line, with one a plane; going from one to the other keeps what can be kept, as an edit
/// that can be undone.
class TransferEditor : public QWidget {
    Q_OBJECT

  public:
    /// `line` becomes a part of this one; its figure and edits stay its owner's affair.
    explicit TransferEditor(TransferEditor1d* line, QWidget* parent = nullptr);

    /// To the plane and the axes; the line gets its figure from its owner.
    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer);
    [[nodiscard]] TransferEditor1d* line() const { return line_; }
    [[nodiscard]] TransferEditor2d* plane() const { return plane_; }
    [[nodiscard]] QComboBox* firstAxisBox() const { return first_; }
    [[nodiscard]] QComboBox* secondAxisBox() const { return second_; }
    [[nodiscard]] bool showsPlane() const;
    /// What is missing, in a sentence; empty where nothing is.
    [[nodiscard]] QString note() const;
    void setMark(const std::optional<TransferPlane::Mark>& mark);

  Q_SIGNALS:
    void edited(const limner::Edit& edit);

  private:
    [[nodiscard]] const Transfer* transfer() const;
    void fillBoxes();
    void takeFirst(const std::string& axis);
    void takeSecond(const std::string& axis); ///< empty: none
    void emitTransfer(const Transfer& changed, const QString& label);

    std::shared_ptr<const Figure> figure_;
    std::size_t layer_ = 0;
    TransferEditor1d* line_;
    TransferEditor2d* plane_;
    QStackedWidget* stack_;
    QComboBox* first_;
    QComboBox* second_;
    QLabel* note_;
};

} // namespace limner
