#include "renderer/marks/dot_pattern.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <numbers>
#include <numeric>

namespace limner {

namespace {

constexpr int kChoice = 3; ///< random points that each kept one is chosen from

/// A mixing of 64 bits (the finaliser of MurmurHash3): random numbers that need no state.
double unitHash(std::uint64_t x) {
    x ^= x >> 33;
    x *= 0xff51afd7ed558ccdULL;
    x ^= x >> 33;
    x *= 0xc4ceb9fe1a85ec53ULL;
    x ^= x >> 33;
    return static_cast<double>(x >> 11) * 0x1p-53;
}

double wrapped(double difference) {
    constexpr double half = DotPattern::kSize / 2.0;
    return difference > half    ? difference - DotPattern::kSize
           : difference < -half ? difference + DotPattern::kSize
                                : difference;
}

/// Points on the torus, the most crowded of which can be taken away again and again.
class Elimination {
  public:
    explicit Elimination(const std::vector<glm::dvec2>& points) : points_(points) {}

    /// Takes points away until `wanted` are left; returns those taken, in their order.
    std::vector<std::uint32_t> run(std::vector<std::uint32_t>& alive, std::size_t wanted) {
        const double area = static_cast<double>(DotPattern::kSize) * DotPattern::kSize;
        // Largest possible distance of so many points, all spread alike; and the part of it below which closer is no
        // worse, so that close pairs do not crowd out all else (the paper's beta and gamma, gamma = 3/2).
        radius_ = std::sqrt(area / (2 * std::sqrt(3.0) * static_cast<double>(wanted)));
        const double kept = static_cast<double>(wanted) / static_cast<double>(alive.size());
        closest_ = 2 * radius_ * (1 - kept * std::sqrt(kept)) * 0.65;
        sortIntoCells(alive);
        weights_.assign(points_.size(), 0);
        tbb::parallel_for(std::size_t{0}, alive.size(), [&](std::size_t i) {
            double sum = 0;
            forNeighbours(alive[i], [&](std::uint32_t, double weight) { sum += weight; });
            weights_[alive[i]] = sum;
        });
        heap_ = alive;
        place_.assign(points_.size(), kNone);
        for (std::size_t i = 0; i < heap_.size(); ++i) {
            place_[heap_[i]] = static_cast<std::uint32_t>(i);
        }
        for (std::size_t i = heap_.size() / 2; i-- > 0;) {
            sink(i);
        }
        std::vector<std::uint32_t> taken;
        while (heap_.size() > wanted) {
            taken.push_back(takeHeaviest());
        }
        alive = heap_;
        std::sort(alive.begin(), alive.end());
        return taken;
    }

  private:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    void sortIntoCells(const std::vector<std::uint32_t>& alive) {
        cells_ = std::max(1, static_cast<int>(DotPattern::kSize / (2 * radius_)));
        start_.assign(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_) + 1, 0);
        for (const std::uint32_t i : alive) {
            ++start_[cellOf(points_[i]) + 1];
        }
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        members_.resize(alive.size());
        std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
        for (const std::uint32_t i : alive) {
            members_[next[cellOf(points_[i])]++] = i;
        }
    }

    [[nodiscard]] std::size_t cellOf(const glm::dvec2& p) const {
        const auto along = [&](double x) {
            return std::min(static_cast<int>(x / DotPattern::kSize * cells_), cells_ - 1);
        };
        return static_cast<std::size_t>(along(p.y)) * static_cast<std::size_t>(cells_) +
               static_cast<std::size_t>(along(p.x));
    }

    template <typename Use>
    void forNeighbours(std::uint32_t i, const Use& use) const {
        const glm::dvec2 p = points_[i];
        const auto home = static_cast<int>(cellOf(p));
        const int reach = cells_ < 3 ? 0 : 1; // a few cells: the whole torus is near
        const int across = cells_ < 3 ? cells_ : 3;
        for (int dy = 0; dy < across; ++dy) {
            const int y = (home / cells_ + dy - reach + cells_) % cells_;
            for (int dx = 0; dx < across; ++dx) {
                const int x = (home % cells_ + dx - reach + cells_) % cells_;
                const auto cell = static_cast<std::size_t>(y * cells_ + x);
                for (std::uint32_t m = start_[cell]; m < start_[cell + 1]; ++m) {
                    const std::uint32_t j = members_[m];
                    const glm::dvec2 d(wrapped(points_[j].x - p.x), wrapped(points_[j].y - p.y));
                    const double squared = d.x * d.x + d.y * d.y;
                    if (j != i && squared < 4 * radius_ * radius_) {
                        const double free = 1 - std::max(std::sqrt(squared), closest_) / (2 * radius_);
                        const double four = free * free * free * free;
                        use(j, four * four);
                    }
                }
            }
        }
    }

    /// Heavier first; among equals the lower number, so that the order is one.
    [[nodiscard]] bool before(std::uint32_t a, std::uint32_t b) const {
        return weights_[a] != weights_[b] ? weights_[a] > weights_[b] : a < b;
    }

    void put(std::size_t at, std::uint32_t point) {
        heap_[at] = point;
        place_[point] = static_cast<std::uint32_t>(at);
    }

    void sink(std::size_t at) {
        const std::uint32_t point = heap_[at];
        for (std::size_t child = 2 * at + 1; child < heap_.size(); child = 2 * at + 1) {
            if (child + 1 < heap_.size() && before(heap_[child + 1], heap_[child])) {
                ++child;
            }
            if (!before(heap_[child], point)) {
                break;
            }
            put(at, heap_[child]);
            at = child;
        }
        put(at, point);
    }

    std::uint32_t takeHeaviest() {
        const std::uint32_t point = heap_.front();
        place_[point] = kNone;
        const std::uint32_t last = heap_.back();
        heap_.pop_back();
        if (!heap_.empty()) {
            put(0, last);
            sink(0);
        }
        forNeighbours(point, [&](std::uint32_t j, double weight) {
            if (place_[j] != kNone) {
                weights_[j] -= weight;
                sink(place_[j]);
            }
        });
        return point;
    }

    const std::vector<glm::dvec2>& points_;
    double radius_ = 1;
    double closest_ = 0;
    int cells_ = 1;
    std::vector<std::uint32_t> start_;
    std::vector<std::uint32_t> members_;
    std::vector<double> weights_;
    std::vector<std::uint32_t> heap_;
    std::vector<std::uint32_t> place_; ///< in the heap, by point
};

/// Numbers of the points in their order: halves, each spread as well as can be, from the last to the first.
std::vector<std::uint32_t> progressiveOrder(const std::vector<glm::dvec2>& points) {
    Elimination elimination(points);
    std::vector<std::uint32_t> alive(points.size());
    std::iota(alive.begin(), alive.end(), 0U);
    elimination.run(alive, DotPattern::kCount);
    std::vector<std::uint32_t> backwards;
    while (alive.size() > 1) {
        const std::vector<std::uint32_t> taken = elimination.run(alive, alive.size() / 2);
        backwards.insert(backwards.end(), taken.begin(), taken.end());
    }
    backwards.push_back(alive.front());
    return {backwards.rbegin(), backwards.rend()};
}

} // namespace

DotPattern::DotPattern() {
    std::vector<glm::dvec2> random(static_cast<std::size_t>(kCount) * kChoice);
    for (std::size_t i = 0; i < random.size(); ++i) {
        random[i] = {unitHash(2 * i + 1) * kSize, unitHash(2 * i + 2) * kSize};
    }
    const std::vector<std::uint32_t> order = progressiveOrder(random);
    std::vector<glm::dvec2> inOrder(order.size());
    std::transform(order.begin(), order.end(), inOrder.begin(), [&](std::uint32_t i) { return random[i]; });
    for (std::size_t i = 0; i < std::size(kEdges); ++i) {
        squares_[i] = inSquares(kEdges[i], inOrder);
    }
    measureCoverage();
}

DotPattern::Squares DotPattern::inSquares(int edge, const std::vector<glm::dvec2>& inOrder) {
    const int perRow = kSize / edge;
    const auto along = [&](double x) { return std::min(static_cast<int>(x / edge), perRow - 1); };
    const auto squareOf = [&](const glm::dvec2& p) {
        return static_cast<std::size_t>(along(p.y) * perRow + along(p.x));
    };
    Squares squares;
    squares.edge = edge;
    squares.start.assign(static_cast<std::size_t>(perRow) * static_cast<std::size_t>(perRow) + 1, 0);
    for (const glm::dvec2& p : inOrder) {
        ++squares.start[squareOf(p) + 1];
    }
    std::partial_sum(squares.start.begin(), squares.start.end(), squares.start.begin());
    squares.points.resize(inOrder.size());
    std::vector<std::uint32_t> next(squares.start.begin(), squares.start.end() - 1);
    for (std::size_t rank = 0; rank < inOrder.size(); ++rank) {
        const glm::dvec2 p = inOrder[rank];
        squares.points[next[squareOf(p)]++] = {static_cast<float>(p.x - along(p.x) * edge),
                                               static_cast<float>(p.y - along(p.y) * edge),
                                               static_cast<float>(rank) / static_cast<float>(kCount),
                                               static_cast<std::uint32_t>(unitHash(~rank) * 0x1p32)};
    }
    return squares;
}

void DotPattern::measureCoverage() {
    // Every beginning is like every other: one part of the points tells for all. A place is covered by dots of a radius
    // when its nearest point is closer than that.
    constexpr float part = 0.25F;
    constexpr int entries = 1024;
    constexpr int perEdge = 512;
    constexpr double step = static_cast<double>(kSize) / perEdge;
    constexpr double reach = 4; // further than the largest void of that part
    std::vector<std::vector<std::uint32_t>> counts(perEdge, std::vector<std::uint32_t>(entries + 1, 0));
    tbb::parallel_for(0, perEdge, [&](int row) {
        for (int column = 0; column < perEdge; ++column) {
            const glm::dvec2 here((column + 0.5) * step, (row + 0.5) * step);
            double nearest = reach * reach;
            forEachIn(here - reach, here + reach, part, [&](const glm::vec2& p, float, std::uint32_t) {
                const glm::dvec2 d = glm::dvec2(p) - reach;
                nearest = std::min(nearest, d.x * d.x + d.y * d.y);
            });
            const double density = part * std::numbers::pi * nearest; // of dots that just reach here
            ++counts[static_cast<std::size_t>(row)][static_cast<std::size_t>(
                std::min(density / kMostDensity * entries, static_cast<double>(entries)))];
        }
    });
    coverage_.assign(entries + 1, 0);
    std::uint64_t covered = 0;
    for (std::size_t i = 0; i < entries; ++i) {
        for (const auto& row : counts) {
            covered += row[i];
        }
        coverage_[i + 1] = static_cast<float>(covered) / static_cast<float>(perEdge * perEdge);
    }
}

double DotPattern::coverage(double density) const {
    const double place = std::clamp(density / kMostDensity, 0.0, 1.0) * static_cast<double>(coverage_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), coverage_.size() - 2);
    return coverage_[i] + (place - static_cast<double>(i)) * (coverage_[i + 1] - coverage_[i]);
}

double DotPattern::densityFor(double coverage) const {
    const auto after = std::upper_bound(coverage_.begin(), coverage_.end(), static_cast<float>(coverage));
    if (after == coverage_.end() || after == coverage_.begin()) {
        return after == coverage_.begin() ? 0 : kMostDensity;
    }
    const auto i = static_cast<double>(after - coverage_.begin() - 1);
    const double part = (coverage - *(after - 1)) / (*after - *(after - 1));
    return (i + part) / static_cast<double>(coverage_.size() - 1) * kMostDensity;
}

const DotPattern& dotPattern() {
    // Isolated: while it waits, the thread that makes it must not take up a task that asks for it.
    static const auto pattern = tbb::this_task_arena::isolate([] { return std::make_unique<const DotPattern>(); });
    return *pattern;
}

} // namespace limner
