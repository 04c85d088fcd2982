#pragma once

#include "widgets/artwork_tool.h"
#include "widgets/artwork_view.h"
#include "widgets/extraction_draft.h"

#include <QImage>
#include <QLineF>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace limner {

/// A draft's artwork with what is marked on it, under one tool at a time. The wheel zooms about the pointer; the middle
/// button, or the left one with Space held, moves the artwork. It is given a draft and asks for changes of it; what it
/// keeps is the view, the tool and what the tool has begun.
class ArtworkCanvas : public QWidget, private ToolHost {
    Q_OBJECT

  public:
    explicit ArtworkCanvas(QWidget* parent = nullptr);
    ~ArtworkCanvas() override;

    void setDraft(const ExtractionDraft& draft);
    /// Proposals on the shown plate, drawn faintly for the ball tools.
    void setRoundThings(std::vector<RoundThing> things);
    /// A sharper picture of a part of the plate, as `sharperWanted` asked for; of another plate, it is let go.
    void setSharper(const PlatePtr& plate, const ArtCut& cut, const QImage& picture);
    void setTool(ToolKind kind);
    [[nodiscard]] ToolKind tool() const { return kind_; }
    void setOptions(const ToolOptions& options);
    [[nodiscard]] const ToolOptions& options() const override { return options_; }

    [[nodiscard]] const ArtworkView& view() const override { return view_; }
    void fit();
    /// One artwork pixel is one pixel of the screen.
    void showPixels();
    void zoomBy(double factor);
    void removeChosen();
    [[nodiscard]] QString hint() const;

    [[nodiscard]] QSize sizeHint() const override { return {720, 620}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

  Q_SIGNALS:
    void edited(const limner::DraftEdit& edit);
    void optionsChanged(const limner::ToolOptions& options);
    void outlineDrawn(const limner::ArtPath& outline, limner::OutlineMode mode);
    /// The screen has more pixels than the reduced copy under `part`; `longest` of them on its longer side.
    void sharperWanted(const limner::ArtRect& part, int longest);
    void zoomChanged();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    [[nodiscard]] const ExtractionDraft& draft() const override { return draft_; }
    [[nodiscard]] const std::vector<RoundThing>& roundThings() const override { return things_; }
    [[nodiscard]] const QPalette& colours() const override { return palette(); }
    void ask(const DraftEdit& edit) override { Q_EMIT edited(edit); }
    void changeOptions(const ToolOptions& options) override;
    void refine(const ArtPath& outline, OutlineMode mode) override { Q_EMIT outlineDrawn(outline, mode); }
    void refresh() override { update(); }

    [[nodiscard]] ToolPointer pointerOf(const QMouseEvent& event) const;
    [[nodiscard]] bool movesArrow(int key, bool far);
    void viewChanged();
    void askForSharper();
    void showCursor();
    void paintArtwork(QPainter& painter) const;
    void paintMask(QPainter& painter, const Mask& mask, const QVector<QRgb>& colours) const;
    void paintForm(QPainter& painter);
    void paintMarks(QPainter& painter) const;

    struct Sharper {
        PlatePtr plate;
        QRectF part; ///< on the artwork
        QImage picture;
    };

    ExtractionDraft draft_;
    std::vector<RoundThing> things_;
    ArtworkView view_;
    ToolKind kind_ = ToolKind::circle;
    std::unique_ptr<ArtworkTool> tool_;
    ToolOptions options_;
    Sharper sharper_;
    std::optional<QVector<QLineF>> regionBorder_; ///< in the mask's pixels; found when it is painted
    QTimer rest_;
    bool space_ = false;
    bool panning_ = false;
    bool toolDown_ = false;
    QPointF panFrom_;
};

/// The border of what a mask marks, along its pixels' sides.
QVector<QLineF> borderOf(const Mask& mask);

} // namespace limner
