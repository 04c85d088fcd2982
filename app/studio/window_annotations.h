#pragma once

#include "app/studio/workplace.h"

#include <QObject>

namespace limner {

class AnnotationForm;
class AnnotationOverlay;
class LabelTool;

/// What is written over the figure: its panel, its handles in the picture, and the tool that adds labels.
class WindowAnnotations : public QObject {
    Q_OBJECT

  public:
    explicit WindowAnnotations(const Workplace& place);
    [[nodiscard]] AnnotationForm& form() { return *form_; }
    [[nodiscard]] AnnotationOverlay& overlay() { return *overlay_; }
    [[nodiscard]] LabelTool& tool() { return *tool_; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void connectTool();
    void showFigure();
    void showPanel();
    void showPlaces();

    Workplace place_;
    AnnotationForm* form_;
    AnnotationOverlay* overlay_;
    LabelTool* tool_;
    QDockWidget* panel_;
    qint64 shown_ = 0; ///< the picture whose places the list has
};

} // namespace limner
