#pragma once

#include "app/studio/workplace.h"

#include <QObject>

namespace limner {

class ClipOverlay;
class ViewForm;

/// The panel of the view and what is cut away, with grips over the picture while the panel is seen.
class WindowView : public QObject {
    Q_OBJECT

  public:
    explicit WindowView(const Workplace& place);
    [[nodiscard]] ViewForm& form() { return *form_; }
    [[nodiscard]] ClipOverlay& overlay() { return *overlay_; }

  private:
    void showFigure();

    Workplace place_;
    ViewForm* form_;
    ClipOverlay* overlay_;
    bool seen_ = false;
};

} // namespace limner
