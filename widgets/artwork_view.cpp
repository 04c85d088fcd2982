#include "widgets/artwork_view.h"

#include <glm/common.hpp>

#include <algorithm>

namespace limner {
namespace {

constexpr double kMargin = 16;        // around a fitted artwork
constexpr double kLargestScale = 40;  // one artwork pixel is a tile then
constexpr double kSmallestFit = 0.25; // of the fitting scale

double fittingScale(QSizeF widget, QSizeF artwork) {
    return std::max(1e-6, std::min(std::max(1.0, widget.width() - 2 * kMargin) / artwork.width(),
                                   std::max(1.0, widget.height() - 2 * kMargin) / artwork.height()));
}

} // namespace

void ArtworkView::setSizes(QSizeF widget, QSizeF artwork) {
    const bool other = artwork != artwork_;
    widget_ = widget.expandedTo({1, 1});
    artwork_ = artwork.expandedTo({1, 1});
    if (fits_ || other)
        fit();
    hold();
}

QPointF ArtworkView::toWidget(glm::dvec2 onArtwork) const {
    const glm::dvec2 from = (onArtwork - centre_) * scale_;
    return {widget_.width() / 2 + from.x, widget_.height() / 2 + from.y};
}

glm::dvec2 ArtworkView::toArtwork(QPointF inWidget) const {
    return centre_ + glm::dvec2(inWidget.x() - widget_.width() / 2, inWidget.y() - widget_.height() / 2) / scale_;
}

QRectF ArtworkView::sheet() const { return {toWidget({0, 0}), toWidget({artwork_.width(), artwork_.height()})}; }

void ArtworkView::fit() {
    scale_ = fittingScale(widget_, artwork_);
    centre_ = {artwork_.width() / 2, artwork_.height() / 2};
    fits_ = true;
}

void ArtworkView::zoomTo(double scale, QPointF held) {
    const glm::dvec2 place = toArtwork(held);
    const double least = std::min(1.0, fittingScale(widget_, artwork_) * kSmallestFit);
    scale_ = std::clamp(scale, least, kLargestScale);
    centre_ = place - glm::dvec2(held.x() - widget_.width() / 2, held.y() - widget_.height() / 2) / scale_;
    fits_ = false;
    hold();
}

void ArtworkView::panBy(QPointF pixels) {
    centre_ -= glm::dvec2(pixels.x(), pixels.y()) / scale_;
    fits_ = false;
    hold();
}

/// Some of the artwork always stays in the middle: what has been pushed out of sight is hard to find.
void ArtworkView::hold() {
    centre_ = glm::clamp(centre_, glm::dvec2(0), glm::dvec2(artwork_.width(), artwork_.height()));
}

} // namespace limner
