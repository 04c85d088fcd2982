#pragma once

#include "core/project/history.h"
#include "renderer/style_target.h"
#include "widgets/style_source.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <map>
#include <memory>
#include <optional>

class QDragMoveEvent;
class QDropEvent;

namespace limner {

class Job;
class StylePictures;
class Viewport;

/// Lets styles be dropped onto the picture. The ray under the pointer decides which layer is meant and which of its
/// nodes; that is said in a word beside the pointer and shown as a veil over the picture before the drop. Shift means
/// the whole layer. A hand that rests asks for the figure as it would be. Rays and veils are found on threads of their
/// own; a drop waits for its ray.
class StyleDrop : public QWidget {
    Q_OBJECT

  public:
    explicit StyleDrop(Viewport* viewport);
    ~StyleDrop() override;

    void setSource(StyleSource source) { source_ = std::move(source); }
    /// The figure that a drop changes.
    void setFigure(std::shared_ptr<const Figure> figure);

    /// What a drop would change now; nothing: the pointer is on paper, or no style is dragged.
    [[nodiscard]] const std::optional<StyleTarget>& target() const { return target_; }
    [[nodiscard]] QString words() const; ///< beside the pointer
    [[nodiscard]] const QImage& veil() const { return veil_; }
    /// Waits until ray and veil are found; for tests.
    void waitIdle();

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    /// The figure as it would be is to be seen; null: the figure itself again.
    void previewWanted(std::shared_ptr<const Figure> figure);

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool enter(QDragMoveEvent* event);
    void move(const QDragMoveEvent& event);
    void drop(QDropEvent* event);
    void leave();
    void decide();
    /// Veil and preview follow what is meant by now.
    void follow();
    void findVeil();
    void takePreviewBack();
    [[nodiscard]] std::optional<glm::dvec2> pixelAt(QPointF position) const;
    [[nodiscard]] bool isMeant(const StyleTarget& target) const; ///< the figure still has it, and it is not locked
    [[nodiscard]] std::optional<StyleTarget> meant() const;      ///< the target, Shift counted
    [[nodiscard]] std::shared_ptr<const Figure> dropped() const;

    Viewport* viewport_;
    StyleSource source_;
    std::shared_ptr<const Figure> figure_;
    std::shared_ptr<const RenderPlan> plan_; ///< of the picture that the drag goes over
    std::shared_ptr<StylePictures> pictures_;
    std::shared_ptr<const Style> style_; ///< in hand; null: none
    QPointF at_;
    bool whole_ = false; ///< Shift: the whole layer
    std::optional<StyleTarget> target_;
    std::optional<QPointF> decided_; ///< where `target_` was found
    QImage veil_;
    using Part = std::pair<std::size_t, std::optional<std::size_t>>; ///< layer and node
    std::optional<Part> part_;                                       ///< that veil and preview are of
    std::map<Part, QImage> veils_;                                   ///< of `plan_`
    std::shared_ptr<const Figure> previewed_;
    QPointer<Job> ray_, veilJob_;
    QTimer rest_;
};

/// "Bone · around 420 HU" for a node of several, "Bone · Mandible" for a label's cell, "Bone" for a whole layer.
QString targetWords(const Figure& figure, const StyleTarget& target);

} // namespace limner
