#pragma once

#include "widgets/tool_overlay.h"

namespace limner {

/// Keep the island here: a click on the picture keeps the connected matter that is seen there and takes all other
/// away, as a clean-up step. Reads the picture that is shown, not one that is still to come.
class IslandOverlay : public ToolOverlay {
    Q_OBJECT

  public:
    explicit IslandOverlay(Viewport* viewport);

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void reset() override { missed_ = false; }
    [[nodiscard]] QString hint() const override;

  private:
    bool missed_ = false; ///< the last click met no matter
};

} // namespace limner
