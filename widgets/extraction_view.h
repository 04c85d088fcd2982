#pragma once

#include "core/style/extraction/extract.h"
#include "widgets/gesture_key.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>
#include <string>

namespace limner {

/// An extraction with its pictures for the screen; made off the interface's thread.
struct ExtractionPictures {
    std::shared_ptr<const Extraction> extraction; ///< null: a sphere of swatches
    SpherePtr sphere;                             ///< with all edits
    QImage reshaded;                              ///< null where there is no extraction
    QImage difference;
    QImage filled; ///< of the ball: tinted where nothing was seen
    QImage tile;   ///< null: no texture
};

/// `sphere` with its edits; `extraction` may be null.
ExtractionPictures picturesOf(std::shared_ptr<const Extraction> extraction, SpherePtr sphere);

/// Shows what was extracted: the ball, the region shaded again, or how that differs from the artwork. Of a sphere made
/// of swatches, dragging on the ball turns the light.
class ExtractionView : public QWidget {
    Q_OBJECT

  public:
    enum class Shows { ball, reshaded, difference };

    explicit ExtractionView(QWidget* parent = nullptr);

    /// Null: nothing is there; `waiting` says so in words.
    void setPictures(std::shared_ptr<const ExtractionPictures> pictures);
    void setWords(const QString& whileEmpty);
    void setShows(Shows shows);
    [[nodiscard]] Shows shows() const { return shows_; }
    void setShowsFilled(bool on);
    /// Where the light comes from, to be dragged; none: it cannot be.
    void setLight(std::optional<glm::dvec2> towardsLight);
    [[nodiscard]] const std::shared_ptr<const ExtractionPictures>& pictures() const { return pictures_; }
    /// The ball's place in the widget.
    [[nodiscard]] QRectF ballRect() const;

    [[nodiscard]] QSize sizeHint() const override { return {232, 232}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 120}; }

  Q_SIGNALS:
    void lightTurned(const glm::dvec2& towardsLight, const std::string& key, bool ongoing);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void turnLight(QPointF to, bool ongoing);
    void paintBall(QPainter& painter);

    std::shared_ptr<const ExtractionPictures> pictures_;
    QString words_;
    Shows shows_ = Shows::ball;
    bool showsFilled_ = false;
    std::optional<glm::dvec2> light_;
    GestureKey key_;
    bool turning_ = false;
    QImage ball_; ///< of the shown sphere, at the shown size
    const LitSphere* ballOf_ = nullptr;
};

} // namespace limner
