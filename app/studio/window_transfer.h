#pragma once

#include "app/studio/workplace.h"
#include "core/figure/figure.h"
#include "core/volume/joint_histogram.h"

#include <QObject>
#include <QPointF>

#include <memory>
#include <optional>

namespace limner {

class NewestJob;
class TransferEditor;
class WidenOverlay;
struct Pick;

/// The window's transfer function panel beyond one axis: the editor that fits the layer, counts of the voxels over two
/// axes, the mark of what lies under the pointer in the picture, and the tool that widens a range over the picture.
class WindowTransfer : public QObject {
    Q_OBJECT

  public:
    explicit WindowTransfer(const Workplace& place);
    ~WindowTransfer() override;

    [[nodiscard]] TransferEditor& editor() { return *editor_; }
    [[nodiscard]] WidenOverlay& widen() { return *widen_; }
    /// Something is counted or read from the picture.
    [[nodiscard]] bool busy() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void putIntoDock();
    void connectWiden();
    void showFigure();
    void count(const std::shared_ptr<const Figure>& figure, const Transfer& transfer);
    void pickAt(QPointF position);
    void mark(const std::optional<Pick>& pick);

    /// What counts depend on.
    struct Counted {
        std::shared_ptr<const Volume> volume, labels, second;
        std::vector<std::string> axes;
        std::optional<DistanceOrigin> distance;
        friend bool operator==(const Counted&, const Counted&) = default;
    };

    Workplace place_;
    TransferEditor* editor_;
    WidenOverlay* widen_;
    NewestJob* counting_;
    NewestJob* picking_;
    std::optional<Counted> counted_; ///< what `histogram_` is of, or will be
    std::shared_ptr<const JointHistogram> histogram_;
};

} // namespace limner
