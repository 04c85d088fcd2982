#pragma once

#include "core/project/history.h"

#include <QWidget>

#include <memory>

class QPainter;

namespace limner {

class Viewport;

/// A tool over the viewport's picture, hidden until it is taken up: it has the mouse and the keyboard then. Escape
/// lays it down. The wheel stays the viewport's while the tool has nothing begun. Edits go out.
class ToolOverlay : public QWidget {
    Q_OBJECT

  public:
    ToolOverlay(Viewport* viewport, const QString& name);

    /// Null, or a figure without its volume: the tool is laid down.
    virtual void setFigure(std::shared_ptr<const Figure> figure);
    /// Takes the tool up; does nothing without a figure.
    void take();
    void layDown();
    [[nodiscard]] bool taken() const { return !isHidden(); }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void takenChanged(bool taken);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

    /// Forgets what was begun.
    virtual void reset() {}
    [[nodiscard]] virtual bool begun() const { return false; }
    virtual void paintTool(QPainter&) {}
    /// What to do next, one line at the picture's foot.
    [[nodiscard]] virtual QString hint() const = 0;

    [[nodiscard]] Viewport& viewport() const { return *viewport_; }
    [[nodiscard]] const std::shared_ptr<const Figure>& figure() const { return figure_; }
    /// Figure coordinates: (0, 0) the sheet's top left corner, (1, 1) its bottom right.
    [[nodiscard]] glm::dvec2 onFigure(QPointF position) const;
    [[nodiscard]] QPointF onScreen(const glm::dvec2& place) const;

  private:
    Viewport* viewport_;
    std::shared_ptr<const Figure> figure_;
};

} // namespace limner
