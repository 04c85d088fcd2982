#include "core/figure/label_places.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace limner::label_places {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

bool inside(const LabelSheet& sheet, const SheetBox& box) {
    return box.lowMm.x >= 0 && box.lowMm.y >= 0 && box.highMm.x <= sheet.sizeMm.x && box.highMm.y <= sheet.sizeMm.y;
}

/// Labels on an ellipse around the sheet's middle. A label's place is an angle; boxes lie outside of it.
class Ring {
  public:
    Ring(const Scene& scene, std::span<const std::size_t> free) : scene_(scene), members_(free.begin(), free.end()) {
        glm::dvec2 largest(0);
        for (const std::size_t i : members_) {
            largest = glm::max(largest, scene.labels[i].sizeMm);
        }
        glm::dvec2 low(scene.sheet.marginMm);
        glm::dvec2 high = scene.sheet.sizeMm - scene.sheet.marginMm;
        for (const SheetBox& box : scene.sheet.taken) { // strips at the top and the bottom; corners are left aside
            const double middle = (box.lowMm.y + box.highMm.y) / 2;
            if (box.lowMm.x > scene.sheet.sizeMm.x / 2 || box.highMm.x < scene.sheet.sizeMm.x / 2) {
                continue;
            }
            if (middle < scene.sheet.sizeMm.y / 4) {
                low.y = std::max(low.y, box.highMm.y + scene.sheet.gapMm);
            } else if (middle > scene.sheet.sizeMm.y * 3 / 4) {
                high.y = std::min(high.y, box.lowMm.y - scene.sheet.gapMm);
            }
        }
        centre_ = (low + high) / 2.0;
        radius_ = (high - low) / 2.0 - largest;
        angles_.resize(scene.labels.size());
    }

    [[nodiscard]] bool any() const { return radius_.x > 0 && radius_.y > 0; }

    void start() {
        for (const std::size_t i : members_) {
            const glm::dvec2 from = (scene_.labels[i].anchorMm - centre_) / radius_;
            angles_[i] = from == glm::dvec2(0) ? 0 : std::atan2(from.y, from.x);
        }
        sort();
    }

    void place(std::vector<PlacedLabel>& placed) const {
        for (const std::size_t i : members_) {
            const LabelBox& label = scene_.labels[i];
            const glm::dvec2 out(std::cos(angles_[i]), std::sin(angles_[i]));
            const glm::dvec2 port = centre_ + radius_ * out;
            // The box lies beyond the port; its side lies there where the ring is steep, its edge where it is flat.
            const glm::dvec2 middle = port + label.sizeMm / 2.0 * glm::clamp(out * std::numbers::sqrt2, -1.0, 1.0);
            placed[i] = {{middle - label.sizeMm / 2.0, middle + label.sizeMm / 2.0}, port};
        }
    }

    /// Pushes neighbours apart that overlap. Returns whether any did.
    bool spread(const std::vector<PlacedLabel>& placed) {
        constexpr double kStep = 0.01; // radians: a millimetre or so of a page's ring
        bool moved = false;
        for (std::size_t k = 0; k < members_.size() && members_.size() > 1; ++k) {
            const std::size_t a = members_[k];
            const std::size_t b = members_[(k + 1) % members_.size()];
            const glm::dvec2 gap(scene_.sheet.gapMm);
            if (SheetBox{placed[a].box.lowMm - gap, placed[a].box.highMm + gap}.overlaps(placed[b].box)) {
                angles_[a] -= kStep;
                angles_[b] += kStep;
                moved = true;
            }
        }
        for (const std::size_t i : members_) { // away from what stands in the corners
            for (const SheetBox& box : scene_.sheet.taken) {
                const glm::dvec2 gap(scene_.sheet.gapMm);
                if (SheetBox{box.lowMm - gap, box.highMm + gap}.overlaps(placed[i].box)) {
                    const glm::dvec2 from = (box.lowMm + box.highMm) / 2.0 - centre_;
                    const glm::dvec2 to = (placed[i].box.lowMm + placed[i].box.highMm) / 2.0 - centre_;
                    angles_[i] += from.x * to.y - from.y * to.x < 0 ? -kStep : kStep;
                    moved = true;
                }
            }
        }
        return moved;
    }

    /// Exchanges the places of two whose leaders cross, which makes both together shorter. Returns whether any did.
    bool uncross(const std::vector<PlacedLabel>& placed) {
        for (std::size_t k = 0; k < members_.size(); ++k) {
            for (std::size_t m = k + 1; m < members_.size(); ++m) {
                const std::size_t a = members_[k];
                const std::size_t b = members_[m];
                if (leadersCross(placed[a].portMm, scene_.labels[a].anchorMm, placed[b].portMm,
                                 scene_.labels[b].anchorMm)) {
                    std::swap(angles_[a], angles_[b]);
                    std::swap(members_[k], members_[m]);
                    return true;
                }
            }
        }
        return false;
    }

    void sort() {
        std::stable_sort(members_.begin(), members_.end(),
                         [&](std::size_t a, std::size_t b) { return angles_[a] < angles_[b]; });
    }

  private:
    const Scene& scene_;
    std::vector<std::size_t> members_; ///< around the ring
    std::vector<double> angles_;       ///< by label
    glm::dvec2 centre_{0};
    glm::dvec2 radius_{0};
};

std::vector<std::size_t> allOf(const Scene& scene) {
    std::vector<std::size_t> all(scene.labels.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

bool sound(const Scene& scene, std::span<const std::size_t> free, const std::vector<PlacedLabel>& placed) {
    const std::vector<std::size_t> all = allOf(scene);
    return std::all_of(free.begin(), free.end(), [&](std::size_t i) {
        return inside(scene.sheet, placed[i].box) && !disturbs(scene, i, all, placed);
    });
}

} // namespace

bool layRing(const Scene& scene, std::span<const std::size_t> free, std::vector<PlacedLabel>& placed) {
    Ring ring(scene, free);
    if (!ring.any()) {
        return false;
    }
    ring.start();
    constexpr int kMostMoves = 2000; // some milliseconds; a ring that is not done by then is too full
    for (int moves = 0; moves < kMostMoves; ++moves) {
        ring.place(placed);
        if (!ring.spread(placed) && !ring.uncross(placed)) {
            break;
        }
    }
    ring.place(placed);
    return sound(scene, free, placed);
}

bool layFree(const Scene& scene, std::span<const std::size_t> free, std::vector<PlacedLabel>& placed) {
    // Right and left first, as one writes; steeper places where those are taken.
    constexpr std::array<double, 8> kDegrees{-30, 210, 30, 150, -60, 240, 60, 120};
    std::vector<std::size_t> settled;
    for (std::size_t i = 0; i < scene.labels.size(); ++i) {
        if (scene.labels[i].atMm) {
            settled.push_back(i);
        }
    }
    const auto find = [&](std::size_t i) {
        const LabelBox& label = scene.labels[i];
        constexpr double kNearest = 8; // mm: a leader that is seen as one
        const double farthest = glm::length(scene.sheet.sizeMm);
        for (double distance = kNearest; distance < farthest; distance *= 1.25) {
            for (const double degrees : kDegrees) {
                const double angle = degrees * kTurn / 360;
                const glm::dvec2 port = label.anchorMm + distance * glm::dvec2(std::cos(angle), std::sin(angle));
                const bool toTheLeft = port.x < label.anchorMm.x;
                if ((label.side == LabelSide::left) != toTheLeft && label.side != LabelSide::automatic) {
                    continue;
                }
                placed[i] = besidePort(label, port, toTheLeft);
                if (inside(scene.sheet, placed[i].box) && !disturbs(scene, i, settled, placed)) {
                    return true;
                }
            }
        }
        return false;
    };
    for (const std::size_t i : free) {
        if (!find(i)) {
            return false;
        }
        settled.push_back(i);
    }
    return true;
}

} // namespace limner::label_places
