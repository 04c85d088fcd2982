#pragma once

#include "widgets/extraction_draft.h"
#include "widgets/extraction_view.h"

#include <QWidget>

#include <memory>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;

namespace limner {

class CurveEditor;
class SliderRow;

/// The extraction dialog's right side but for the figure: what was extracted, how good it is in words, and what can be
/// done to it.
class ExtractionForm : public QWidget {
    Q_OBJECT

  public:
    explicit ExtractionForm(QWidget* parent = nullptr);

    void setDraft(const ExtractionDraft& draft);
    /// Null: nothing is extracted; `words` say why.
    void setPictures(std::shared_ptr<const ExtractionPictures> pictures, const QString& words);
    [[nodiscard]] ExtractionView* view() const { return view_; }
    [[nodiscard]] SliderRow* depth() const { return depth_; }
    [[nodiscard]] SliderRow* smoothing() const { return smoothing_; }
    [[nodiscard]] SliderRow* turn() const { return turn_; }
    [[nodiscard]] QCheckBox* symmetric() const { return symmetric_; }
    [[nodiscard]] QCheckBox* paperCast() const { return paperCast_; }
    [[nodiscard]] QCheckBox* lettering() const { return lettering_; }
    [[nodiscard]] QCheckBox* texture() const { return texture_; }
    [[nodiscard]] QComboBox* size() const { return size_; }
    [[nodiscard]] CurveEditor* opacity() const { return opacity_; }
    /// The widgets that stand above the controls: a dialog puts the figure's picture beside the view.
    [[nodiscard]] QGridLayout* pictures() const { return pictureRow_; }

  Q_SIGNALS:
    void edited(const limner::DraftEdit& edit);

  private:
    QWidget* buildSwitch();
    QWidget* buildFigures();
    QWidget* buildControls();
    void buildBoxes();
    void connectControls();
    void showFigures();
    void changeEdits(const QString& label, const std::string& key, bool ongoing, const SphereEdits& edits);
    void once(ExtractionDraft changed, const QString& label);
    void changeEvent(QEvent* event) override;

    struct FigureRow {
        QLabel* label;
        QLabel* number;
        QLabel* word;
    };

    ExtractionDraft draft_;
    std::shared_ptr<const ExtractionPictures> pictures_;
    QGridLayout* pictureRow_;
    ExtractionView* view_;
    QButtonGroup* shows_ = nullptr;
    QCheckBox* filled_;
    std::vector<FigureRow> figures_;
    QLabel* advice_; ///< what to do about the worst figure, or why there are none
    SliderRow* depth_;
    QLabel* depthLabel_ = nullptr;
    SliderRow* smoothing_;
    SliderRow* turn_;
    QCheckBox* symmetric_;
    QCheckBox* paperCast_;
    QCheckBox* lettering_;
    QCheckBox* texture_;
    QLabel* tile_;
    QComboBox* size_;
    QCheckBox* byAngle_;
    CurveEditor* opacity_;
};

} // namespace limner
