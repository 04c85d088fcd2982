#include "core/figure/label_places.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limner::label_places {
namespace {

/// Whether a leader from the column at the left to `a` passes above `b`: then `b` can be reached from below it.
bool above(const glm::dvec2& port, const glm::dvec2& a, const glm::dvec2& b) {
    return (a.x - port.x) * (b.y - port.y) - (a.y - port.y) * (b.x - port.x) > 0;
}

/// One column. Seen from the right one, x is mirrored, so that leaders always go to the right.
class Column {
  public:
    Column(const Scene& scene, bool left, double portX) : scene_(scene), left_(left), portX_(portX) {
        const double reach = portX_ - scene.sheet.marginMm;
        for (const SheetBox& box : scene.sheet.taken) {
            block(box, reach);
        }
    }

    void block(const SheetBox& box, double reach) {
        const double low = left_ ? box.lowMm.x : scene_.sheet.sizeMm.x - box.highMm.x;
        const double high = left_ ? box.highMm.x : scene_.sheet.sizeMm.x - box.lowMm.x;
        if (high > scene_.sheet.marginMm && low < scene_.sheet.marginMm + reach) {
            blocked_.emplace_back(box.lowMm.y - scene_.sheet.gapMm, box.highMm.y + scene_.sheet.gapMm);
        }
    }

    /// Places `members` from top to bottom: at every place the anchor above whose leader no other lies, so that none
    /// of the later leaders, which begin below, can cross it.
    void lay(std::vector<std::size_t> members, std::vector<PlacedLabel>& placed) {
        std::sort(blocked_.begin(), blocked_.end());
        double top = scene_.sheet.marginMm;
        while (!members.empty()) {
            const double latest = latestTop(members);
            double y = std::max(top, 0.0);
            auto chosen = choose(members, y);
            for (std::size_t tries = members.size() + 1; tries > 0; --tries) { // towards the chosen one's own height
                const double wished = anchor(*chosen).y - scene_.labels[*chosen].portDownMm;
                const double next = std::clamp(wished, y, std::max(latest, y));
                if (!(next > y)) {
                    break;
                }
                y = next;
                chosen = choose(members, y);
            }
            y = clearOfPoints(members, std::max(top, 0.0), y, latest);
            y = freeFrom(y, scene_.labels[*choose(members, y)].sizeMm.y);
            chosen = choose(members, y);
            y = freeFrom(y, scene_.labels[*chosen].sizeMm.y);
            const LabelBox& label = scene_.labels[*chosen];
            const double x = left_ ? portX_ : scene_.sheet.sizeMm.x - portX_;
            placed[*chosen] = besidePort(label, {x, y + label.portDownMm}, left_);
            top = y + label.sizeMm.y + scene_.sheet.gapMm;
            members.erase(chosen);
        }
    }

    /// The height that so many labels take, and what there is.
    [[nodiscard]] double needed(std::span<const std::size_t> members) const {
        return std::accumulate(members.begin(), members.end(), 0.0, [&](double sum, std::size_t i) {
            return sum + scene_.labels[i].sizeMm.y + scene_.sheet.gapMm;
        });
    }
    [[nodiscard]] double room() const {
        double room = scene_.sheet.sizeMm.y - 2 * scene_.sheet.marginMm;
        for (const auto& [low, high] : blocked_) {
            room -= std::max(0.0, std::min(high, scene_.sheet.sizeMm.y - scene_.sheet.marginMm) -
                                      std::max(low, scene_.sheet.marginMm));
        }
        return room;
    }

  private:
    [[nodiscard]] glm::dvec2 anchor(std::size_t label) const {
        const glm::dvec2 at = scene_.labels[label].anchorMm;
        return {left_ ? at.x : scene_.sheet.sizeMm.x - at.x, at.y};
    }

    std::vector<std::size_t>::iterator choose(std::vector<std::size_t>& members, double y) const {
        auto best = members.begin();
        for (auto it = members.begin() + 1; it != members.end(); ++it) {
            // The leader's height is the same for all whose first lines are alike; else each is asked at its own.
            const glm::dvec2 port(portX_, y + scene_.labels[*it].portDownMm);
            if (!above(port, anchor(*best), anchor(*it))) {
                best = it;
            }
        }
        return best;
    }

    /// The place nearest to `y` from which the leader does not touch another label's point; `y` where there is none.
    double clearOfPoints(std::vector<std::size_t>& members, double top, double y, double latest) const {
        constexpr double kStep = 0.5;  // mm
        constexpr int kMostSteps = 12; // two lines: farther away a label would belong to something else
        for (int step = 0; step <= kMostSteps; ++step) {
            for (const double sign : {1.0, -1.0}) {
                const double tried = y + sign * kStep * step;
                if (tried >= top && (tried <= latest || step == 0) && !touches(*choose(members, tried), tried)) {
                    return tried;
                }
            }
        }
        return y;
    }

    [[nodiscard]] bool touches(std::size_t label, double y) const {
        constexpr double kClear = 1; // mm between a leader and a foreign point
        const glm::dvec2 port(portX_, y + scene_.labels[label].portDownMm);
        const glm::dvec2 way = anchor(label) - port;
        for (std::size_t other = 0; other < scene_.labels.size(); ++other) {
            const glm::dvec2 to = anchor(other) - port;
            const double along = glm::dot(to, way) / std::max(glm::dot(way, way), 1e-12);
            if (other != label && along > 0 && along < 1 && glm::distance(to, along * way) < kClear &&
                anchor(other) != anchor(label)) {
                return true;
            }
        }
        return false;
    }

    /// The lowest top at which all of the rest still fits above the bottom margin.
    [[nodiscard]] double latestTop(std::span<const std::size_t> rest) const {
        double bottom = scene_.sheet.sizeMm.y - scene_.sheet.marginMm;
        double tallest = 0;
        for (const std::size_t i : rest) {
            tallest = std::max(tallest, scene_.labels[i].sizeMm.y + scene_.sheet.gapMm);
        }
        double y = bottom - needed(rest) + scene_.sheet.gapMm;
        for (auto it = blocked_.rbegin(); it != blocked_.rend(); ++it) {
            if (it->second > y && it->first < bottom) { // before an obstacle, up to a box's height may be lost
                const bool atTheEnd = it->second >= bottom;
                y -= std::min(it->second, bottom) - it->first + (atTheEnd ? 0 : tallest);
            }
        }
        return y;
    }

    /// The first top from `y` on where nothing is taken.
    [[nodiscard]] double freeFrom(double y, double height) const {
        for (const auto& [low, high] : blocked_) {
            constexpr double kRounding = 1e-9; // mm: a box that ends where an obstacle begins
            if (y < high && y + height > low + kRounding) {
                y = high;
            }
        }
        return y;
    }

    const Scene& scene_;
    bool left_;
    double portX_; ///< from the column's own edge
    std::vector<std::pair<double, double>> blocked_;
};

double widest(const Scene& scene, std::span<const std::size_t> members) {
    double width = 0;
    for (const std::size_t i : members) {
        width = std::max(width, scene.labels[i].sizeMm.x);
    }
    return width;
}

struct Sides {
    std::vector<std::size_t> left, right;
};

/// How the labels without a side of their own, sorted by x, fall apart.
struct Parting {
    std::size_t count = 0; ///< of those that go to the left
    double left = 0;       ///< heights of the columns
    double right = 0;

    void toTheLeft(double height) {
        ++count;
        left += height;
        right -= height;
    }
    void toTheRight(double height) {
        --count;
        left -= height;
        right += height;
    }
};

/// By x, so that no leader to the left crosses one to the right; as near to the sheet's middle as the columns' room
/// allows. What the user gave a side keeps it.
Sides split(const Scene& scene, std::span<const std::size_t> free, double leftRoom, double rightRoom) {
    Sides sides;
    std::vector<std::size_t> open;
    Parting parting;
    const double middleX = scene.sheet.sizeMm.x / 2;
    const auto height = [&](std::size_t i) { return scene.labels[i].sizeMm.y + scene.sheet.gapMm; };
    const auto x = [&](std::size_t i) { return scene.labels[i].anchorMm.x; };
    for (const std::size_t i : free) {
        const LabelSide side = scene.labels[i].side;
        const bool left = side == LabelSide::left || (side == LabelSide::automatic && x(i) < middleX);
        (left ? parting.left : parting.right) += height(i);
        if (side == LabelSide::automatic) {
            open.push_back(i);
            parting.count += left ? 1 : 0;
        } else {
            (left ? sides.left : sides.right).push_back(i);
        }
    }
    std::stable_sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) { return x(a) < x(b); });
    const auto next = [&] { return height(open[parting.count]); };
    const auto last = [&] { return height(open[parting.count - 1]); };
    // Points near the middle may as well go to the emptier side.
    const auto nearMiddle = [&](std::size_t i) { return std::abs(x(i) - middleX) < scene.sheet.sizeMm.x / 16; };
    while (parting.count < open.size() && nearMiddle(open[parting.count]) && parting.left + next() <= parting.right) {
        parting.toTheLeft(next());
    }
    while (parting.count > 0 && nearMiddle(open[parting.count - 1]) && parting.right + last() <= parting.left) {
        parting.toTheRight(last());
    }
    const auto over = [](double needed, double room) { return std::max(0.0, needed - room); };
    while (parting.count > 0 && over(parting.left, leftRoom) > over(parting.right + last(), rightRoom)) {
        parting.toTheRight(last());
    }
    while (parting.count < open.size() && over(parting.right, rightRoom) > over(parting.left + next(), leftRoom)) {
        parting.toTheLeft(next());
    }
    const auto middle = open.begin() + static_cast<std::ptrdiff_t>(parting.count);
    sides.left.insert(sides.left.end(), open.begin(), middle);
    sides.right.insert(sides.right.end(), middle, open.end());
    return sides;
}

std::vector<std::size_t> fixedOnes(const Scene& scene) {
    std::vector<std::size_t> fixed;
    for (std::size_t i = 0; i < scene.labels.size(); ++i) {
        if (scene.labels[i].atMm) {
            fixed.push_back(i);
        }
    }
    return fixed;
}

void laySides(const Scene& scene, const Sides& sides, std::span<const std::size_t> fixed,
              std::vector<PlacedLabel>& placed) {
    for (const bool left : {true, false}) {
        const auto& members = left ? sides.left : sides.right;
        const double portX = scene.sheet.marginMm + widest(scene, members);
        Column column(scene, left, portX);
        for (const std::size_t i : fixed) {
            column.block(placed[i].box, portX - scene.sheet.marginMm);
        }
        column.lay(members, placed);
    }
}

std::size_t disturbed(const Scene& scene, std::span<const std::size_t> free, std::span<const std::size_t> all,
                      const std::vector<PlacedLabel>& placed) {
    return static_cast<std::size_t>(
        std::count_if(free.begin(), free.end(), [&](std::size_t i) { return disturbs(scene, i, all, placed); }));
}

/// Moves boxes outwards whose points lie under their own column, as far as the sheet allows: else their leaders would
/// go back through the words.
void moveOutwards(const Scene& scene, std::span<const std::size_t> free, std::span<const std::size_t> all,
                  std::vector<PlacedLabel>& placed) {
    constexpr double kLeader = 3; // mm: long enough to be seen as one
    for (const std::size_t i : free) {
        const PlacedLabel before = placed[i];
        const LabelBox& label = scene.labels[i];
        const bool left = before.portMm.x >= before.box.highMm.x;
        const double wished = label.anchorMm.x + (left ? -kLeader : kLeader);
        const double limit = left ? label.sizeMm.x : scene.sheet.sizeMm.x - label.sizeMm.x;
        const bool back = left ? wished < before.portMm.x : wished > before.portMm.x;
        const bool fits = left ? wished >= limit : wished <= limit;
        if (back && fits) {
            placed[i] = besidePort(label, {wished, before.portMm.y}, left);
            if (disturbs(scene, i, all, placed)) {
                placed[i] = before;
            }
        }
    }
}

} // namespace

void layColumns(const Scene& scene, std::span<const std::size_t> free, std::vector<PlacedLabel>& placed) {
    if (free.empty()) {
        return;
    }
    const double wide = scene.sheet.marginMm + widest(scene, free);
    Sides sides = split(scene, free, Column(scene, true, wide).room(), Column(scene, false, wide).room());
    const std::vector<std::size_t> fixed = fixedOnes(scene);
    laySides(scene, sides, fixed, placed);

    // What crosses a leader of the user's, or lies under the other labels' column, may fare better on the other side.
    std::vector<std::size_t> all(scene.labels.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::size_t worst = disturbed(scene, free, all, placed);
    for (std::size_t k = 0; k < free.size() && worst > 0; ++k) {
        const std::size_t i = free[k];
        if (scene.labels[i].side != LabelSide::automatic || !disturbs(scene, i, all, placed)) {
            continue;
        }
        Sides other = sides;
        auto& from = std::count(other.left.begin(), other.left.end(), i) > 0 ? other.left : other.right;
        auto& to = &from == &other.left ? other.right : other.left;
        std::erase(from, i);
        to.push_back(i);
        std::vector<PlacedLabel> tried = placed;
        laySides(scene, other, fixed, tried);
        const std::size_t now = disturbed(scene, free, all, tried);
        if (now < worst) {
            worst = now;
            sides = other;
            placed = tried;
        }
    }
    moveOutwards(scene, free, all, placed);
}

} // namespace limner::label_places
