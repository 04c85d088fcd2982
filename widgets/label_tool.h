#pragma once

#include "widgets/tool_overlay.h"

namespace limner {

/// Add label: a click on what is to be named makes a label that points there, and the tool stays in the hand for the
/// next one: a figure is lettered by the dozen. Reads the picture that is shown.
class LabelTool : public ToolOverlay {
    Q_OBJECT

  public:
    explicit LabelTool(Viewport* viewport);

  Q_SIGNALS:
    /// The label is the figure's last annotation now: it wants its words.
    void labelled();

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void reset() override { missed_ = labelled_ = false; }
    [[nodiscard]] QString hint() const override;

  private:
    bool missed_ = false;   ///< the last click met no matter
    bool labelled_ = false; ///< it has made a label since it was taken
};

} // namespace limner
