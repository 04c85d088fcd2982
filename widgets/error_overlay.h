#pragma once

#include "renderer/picture.h"

#include <QImage>
#include <QWidget>

namespace limner {

class Viewport;

/// The error of every pixel over the viewport's picture, with a scale. The mouse does not meet it.
class ErrorOverlay : public QWidget {
    Q_OBJECT

  public:
    explicit ErrorOverlay(Viewport* viewport);
    /// `map`: as accuracy::errorMap gives it, of the whole sheet; `worst`: the CIEDE2000 that is black in it.
    void showMap(const Picture& map, double worst);
    void clear();
    [[nodiscard]] bool shown() const { return !isHidden(); }
    [[nodiscard]] const QImage& map() const { return map_; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    Viewport* viewport_;
    QImage map_; ///< null: nothing is shown
    double worst_ = 0;
};

} // namespace limner
