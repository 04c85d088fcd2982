#pragma once

#include "core/figure/figure.h"
#include "widgets/style_image.h"

#include <QPixmap>

#include <map>
#include <tuple>

namespace limner {

/// Keeps the balls that a widget paints; a ball of 60 pixels takes about a millisecond to make.
class StyleBallCache {
  public:
    /// A ball of `size` logical pixels.
    QPixmap ball(const Figure& figure, const TransferNode& node, int size, double pixelRatio) {
        const StyleEntry* entry = node.rgb ? nullptr : figure.findStyle(node.style);
        const std::shared_ptr<const LitSphere> sphere = entry ? entry->sphere : nullptr;
        const int pixels = std::max(1, static_cast<int>(size * pixelRatio));
        const Key key{sphere.get(), nodeColour(figure, node).rgb(), pixels};
        if (balls_.size() > kMost)
            balls_.clear();
        Kept& kept = balls_[key];
        if (kept.pixmap.isNull()) {
            kept.pixmap = QPixmap::fromImage(nodeBall(figure, node, pixels));
            kept.sphere = sphere;
        }
        kept.pixmap.setDevicePixelRatio(pixelRatio);
        return kept.pixmap;
    }

  private:
    static constexpr std::size_t kMost = 256; // far more than one figure shows
    using Key = std::tuple<const LitSphere*, QRgb, int>;
    struct Kept {
        QPixmap pixmap;
        std::shared_ptr<const LitSphere> sphere; ///< held, so that its address is not used again
    };
    std::map<Key, Kept> balls_;
};

} // namespace limner
