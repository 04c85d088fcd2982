#pragma once

#include "app/studio/workplace.h"

#include <QObject>

namespace limner {

class StippleForm;

/// The window's stipple panel, and the action that draws the figure with ink.
class WindowStipple : public QObject {
    Q_OBJECT

  public:
    explicit WindowStipple(const Workplace& place);
    [[nodiscard]] StippleForm& form() { return *form_; }

  private:
    void showFigure();

    Workplace place_;
    StippleForm* form_;
    QDockWidget* panel_;
};

} // namespace limner
