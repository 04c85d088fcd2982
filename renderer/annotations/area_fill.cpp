#include "renderer/annotations/area_fill.h"

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

/// Signed areas to the right of edges, as differences along each row: a running sum gives each pixel's share.
class Accumulator {
  public:
    explicit Accumulator(Coverage& out) : out_(out), width_(static_cast<std::size_t>(out.size.x) + 2) {
        sums_.resize(width_ * static_cast<std::size_t>(out.size.y));
    }

    void edge(const glm::dvec2& from, const glm::dvec2& to) {
        if (from.y == to.y) {
            return;
        }
        const double sign = from.y < to.y ? 1 : -1;
        const glm::dvec2& top = sign > 0 ? from : to;
        const glm::dvec2& bottom = sign > 0 ? to : from;
        const double slope = (bottom.x - top.x) / (bottom.y - top.y);
        const int first = std::max(out_.origin.y, static_cast<int>(std::floor(top.y)));
        const int last = std::min(out_.origin.y + out_.size.y - 1, static_cast<int>(std::floor(bottom.y)));
        for (int row = first; row <= last; ++row) {
            const double high = std::max(top.y, static_cast<double>(row));
            const double low = std::min(bottom.y, static_cast<double>(row) + 1);
            if (low > high) {
                const double a = top.x + (high - top.y) * slope;
                const double b = top.x + (low - top.y) * slope;
                span(row, std::minmax(a, b), sign * (low - high));
            }
        }
    }

    void finish() {
        out_.shares.resize(static_cast<std::size_t>(out_.size.x) * static_cast<std::size_t>(out_.size.y));
        for (int row = 0; row < out_.size.y; ++row) {
            double sum = 0;
            const double* in = sums_.data() + static_cast<std::size_t>(row) * width_;
            float* share = out_.shares.data() + static_cast<std::ptrdiff_t>(row) * out_.size.x;
            for (int x = 0; x < out_.size.x; ++x) {
                sum += in[x];
                share[x] = static_cast<float>(std::min(std::abs(sum), 1.0));
            }
        }
    }

  private:
    /// A piece of an edge within a row, of that height, from x = ends.first to ends.second.
    void span(int row, std::pair<double, double> ends, double height) {
        double* sums = sums_.data() + static_cast<std::size_t>(row - out_.origin.y) * width_;
        const double left = ends.first - out_.origin.x;
        const double right = ends.second - out_.origin.x;
        const auto first =
            static_cast<std::size_t>(std::clamp(std::floor(left), 0.0, static_cast<double>(out_.size.x)));
        const auto last =
            static_cast<std::size_t>(std::clamp(std::floor(right), 0.0, static_cast<double>(out_.size.x)));
        if (first == last) {
            const double beyond = static_cast<double>(first) + 1 - 0.5 * (left + right); // mean share of the pixel
            sums[first] += height * beyond;
            sums[first + 1] += height * (1 - beyond);
            return;
        }
        const double perPixel = height / (right - left);
        double before = 0; // area of the pixels so far
        double reached = 0;
        for (std::size_t x = first; x <= last; ++x) {
            const double a = std::max(left, static_cast<double>(x));
            const double b = std::min(right, static_cast<double>(x) + 1);
            const double here = (b - a) * perPixel;
            const double area = reached + here * (static_cast<double>(x) + 1 - 0.5 * (a + b));
            sums[x] += area - before;
            before = area;
            reached += here;
        }
        sums[last + 1] += height - before;
    }

    Coverage& out_;
    std::size_t width_;
    std::vector<double> sums_;
};

} // namespace

Coverage fillArea(std::span<const glm::dvec2> points, std::span<const std::size_t> counts, int firstRow, int endRow) {
    Coverage out;
    if (points.empty()) {
        return out;
    }
    glm::dvec2 low = points.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    constexpr double kFarPixels = 1e8; // integers hold these; no picture is as large
    if (!(low.x > -kFarPixels && low.y > -kFarPixels && high.x < kFarPixels && high.y < kFarPixels)) {
        return out;
    }
    const int top = std::max(firstRow, static_cast<int>(std::floor(low.y)));
    const int end = std::min(endRow, static_cast<int>(std::floor(high.y)) + 1);
    if (top >= end) {
        return out;
    }
    out.origin = {static_cast<int>(std::floor(low.x)), top};
    out.size = {static_cast<int>(std::floor(high.x)) + 1 - out.origin.x, end - top};
    Accumulator areas(out);
    std::size_t start = 0;
    for (const std::size_t count : counts) {
        for (std::size_t i = 0; i < count; ++i) {
            areas.edge(points[start + i], points[start + (i + 1) % count]);
        }
        start += count;
    }
    areas.finish();
    return out;
}

} // namespace limner
