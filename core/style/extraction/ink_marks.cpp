#include "core/style/extraction/ink_marks.h"

#include <glm/geometric.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace limner {
namespace {

/// Longer sides of a plane: below, strokes are too thin to be told apart; above, nothing is gained.
constexpr double kLeastSide = 1600;
constexpr double kMostSide = 2048;
constexpr double kMostEnlarged = 3;
/// How much darker ink is than the mean around it, and how wide around is, in pixels.
constexpr double kDarker = 0.11;
constexpr int kAround = 31;
constexpr int kLeastLength = 6;
constexpr int kLeastArea = 14;

/// What is gathered about a piece of ink while its rows go by.
struct Gathered {
    double x = 0;
    double y = 0;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    double around = 0;
    double beside = 0;
    double rim = 0;
    std::vector<float> values;
    std::vector<cv::Point> corners; ///< of its rows' ends
};

/// Goes over the plane once, however many pieces there are.
class Gatherer {
  public:
    Gatherer(const InkPlane& plane, const InkMarks& marks, int labels)
        : plane_(plane), labels_(marks.labels), which_(static_cast<std::size_t>(labels), -1),
          gathered_(marks.marks.size()) {
        for (std::size_t i = 0; i < marks.marks.size(); ++i) {
            which_[static_cast<std::size_t>(marks.marks[i].label)] = static_cast<int>(i);
            gathered_[i].values.reserve(static_cast<std::size_t>(marks.marks[i].area));
        }
    }

    std::vector<Gathered> gather() {
        for (int y = 0; y < plane_.height; ++y) {
            for (int x = 0; x < plane_.width; ++x) {
                if (labelAt(x, y) > 0) {
                    addPixel(x, y);
                }
                addCorner(x, y);
            }
        }
        return std::move(gathered_);
    }

  private:
    /// 0 beyond the plane.
    [[nodiscard]] std::int32_t labelAt(int x, int y) const {
        return x < 0 || y < 0 || x >= plane_.width || y >= plane_.height
                   ? 0
                   : labels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(plane_.width) +
                             static_cast<std::size_t>(x)];
    }

    [[nodiscard]] Gathered* of(std::int32_t label) {
        const int i = which_[static_cast<std::size_t>(label)];
        return label > 0 && i >= 0 ? &gathered_[static_cast<std::size_t>(i)] : nullptr;
    }

    void addPixel(int x, int y) {
        const std::int32_t label = labelAt(x, y);
        Gathered* piece = of(label);
        if (piece == nullptr) {
            return;
        }
        piece->values.push_back(plane_.at(x, y));
        piece->x += x;
        piece->y += y;
        piece->xx += static_cast<double>(x) * x;
        piece->xy += static_cast<double>(x) * y;
        piece->yy += static_cast<double>(y) * y;
        for (const int side : {0, 1}) {
            if (labelAt(x + 2 * side - 1, y) != label) {
                piece->corners.emplace_back(x + side, y);
                piece->corners.emplace_back(x + side, y + 1);
            }
        }
        // Beyond the soft edge of the stroke, in eight directions.
        constexpr int kFar = 3;
        for (const cv::Point& way : {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1),
                                     cv::Point(1, 1), cv::Point(-1, 1), cv::Point(1, -1), cv::Point(-1, -1)}) {
            const int distance = way.x != 0 && way.y != 0 ? kFar - 1 : kFar;
            const int atX = x + distance * way.x;
            const int atY = y + distance * way.y;
            if (labelAt(x + way.x, y + way.y) != label && atX >= 0 && atY >= 0 && atX < plane_.width &&
                atY < plane_.height && labelAt(atX, atY) != label) {
                piece->around += plane_.at(atX, atY);
                piece->beside += 1;
            }
        }
    }

    /// Where four pixels meet: how much of a piece's rim lies there (Duda's rule).
    void addCorner(int x, int y) {
        const std::array<std::int32_t, 4> four{labelAt(x - 1, y - 1), labelAt(x, y - 1), labelAt(x - 1, y),
                                               labelAt(x, y)};
        if (four[0] == four[1] && four[0] == four[2] && four[0] == four[3]) {
            return;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            if (four[i] == 0 || std::find(four.begin(), four.begin() + static_cast<std::ptrdiff_t>(i), four[i]) !=
                                    four.begin() + static_cast<std::ptrdiff_t>(i)) {
                continue;
            }
            const auto count = std::count(four.begin(), four.end(), four[i]);
            if (Gathered* piece = of(four[i])) {
                const bool diagonal = count == 2 && four[i] == four[3 - i];
                piece->rim += diagonal ? std::sqrt(2.0) : (count == 2 ? 1 : std::sqrt(0.5));
            }
        }
    }

    const InkPlane& plane_;
    const std::vector<std::int32_t>& labels_;
    std::vector<int> which_; ///< by label: of the marks; -1: none
    std::vector<Gathered> gathered_;
};

void measure(InkMark& mark, Gathered& piece) {
    const double x = piece.x / mark.area;
    const double y = piece.y / mark.area;
    mark.centre = {x + 0.5, y + 0.5};
    const double xx = piece.xx / mark.area - x * x;
    const double xy = piece.xy / mark.area - x * y;
    const double yy = piece.yy / mark.area - y * y;
    const double apart = std::hypot(xx - yy, 2 * xy);
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    mark.axis = {std::cos(angle), std::sin(angle)};
    mark.roundness = std::sqrt(std::max(0.0, (xx + yy - apart) / std::max(1e-9, xx + yy + apart)));
    const auto middle = piece.values.begin() + static_cast<std::ptrdiff_t>(piece.values.size() / 2);
    std::nth_element(piece.values.begin(), middle, piece.values.end());
    mark.ink = *middle;
    mark.around = piece.beside > 0 ? piece.around / piece.beside : mark.ink;
    mark.stroke = 2 * mark.area / std::max(1.0, piece.rim);
    std::vector<cv::Point> hull;
    cv::convexHull(piece.corners, hull);
    mark.hullArea = cv::contourArea(hull);
    for (const cv::Point& p : hull) {
        mark.hull.emplace_back(p.x, p.y);
    }
}

} // namespace

float InkPlane::between(glm::dvec2 place) const {
    const double x = std::clamp(place.x - 0.5, 0.0, width - 1.0);
    const double y = std::clamp(place.y - 0.5, 0.0, height - 1.0);
    const int x0 = static_cast<int>(x);
    const int y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, width - 1);
    const int y1 = std::min(y0 + 1, height - 1);
    const auto across = static_cast<float>(x - x0);
    const float top = at(x0, y0) + (at(x1, y0) - at(x0, y0)) * across;
    const float bottom = at(x0, y1) + (at(x1, y1) - at(x0, y1)) * across;
    return top + (bottom - top) * static_cast<float>(y - y0);
}

InkPlane inkPlaneOf(const ArtPicture& picture, bool light) {
    cv::Mat values(picture.height, picture.width, CV_32F);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const Rgba& p = picture.at(x, y);
            const float value = light ? 1 - std::min({p.r, p.g, p.b}) : std::max({p.r, p.g, p.b});
            values.at<float>(y, x) = 1 + (value - 1) * p.a; // what is clear shows no ink
        }
    }
    InkPlane plane;
    const double side = std::max(picture.width, picture.height);
    plane.scale =
        side > kMostSide ? kMostSide / side : (side < kLeastSide ? std::min(kMostEnlarged, kLeastSide / side) : 1);
    if (plane.scale != 1) {
        const cv::Size size(std::max(1, static_cast<int>(std::lround(picture.width * plane.scale))),
                            std::max(1, static_cast<int>(std::lround(picture.height * plane.scale))));
        cv::resize(cv::Mat(values), values, size, 0, 0, plane.scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    }
    plane.width = values.cols;
    plane.height = values.rows;
    plane.values.assign(values.ptr<float>(), values.ptr<float>() + values.total());
    return plane;
}

glm::dvec2 InkMark::reach(glm::dvec2 direction) const {
    glm::dvec2 ends(std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest());
    for (const glm::vec2& p : hull) {
        const double along = glm::dot(glm::dvec2(p), direction);
        ends = {std::min(ends.x, along), std::max(ends.y, along)};
    }
    return ends;
}

InkMarks inkMarksOf(const InkPlane& plane) {
    InkMarks marks;
    marks.width = plane.width;
    marks.height = plane.height;
    const cv::Mat values(plane.height, plane.width, CV_32F, const_cast<float*>(plane.values.data())); // only read
    cv::Mat mean;
    cv::boxFilter(values, mean, -1, {kAround, kAround}, {-1, -1}, true, cv::BORDER_REPLICATE);
    const cv::Mat ink = values < mean - kDarker;
    cv::Mat labels;
    cv::Mat boxes;
    cv::Mat centres;
    const int count = cv::connectedComponentsWithStats(ink, labels, boxes, centres, 8);
    marks.labels.assign(labels.ptr<std::int32_t>(), labels.ptr<std::int32_t>() + labels.total());
    cv::Mat depths;
    cv::distanceTransform(ink, depths, cv::DIST_L2, 3, CV_32F);
    std::vector<float> deepest(static_cast<std::size_t>(count), 0);
    for (std::size_t i = 0; i < marks.labels.size(); ++i) {
        float& depth = deepest[static_cast<std::size_t>(marks.labels[i])];
        depth = std::max(depth, depths.ptr<float>()[i]);
    }
    const double largest = 0.02 * plane.width * plane.height;
    for (int label = 1; label < count; ++label) {
        const int* box = boxes.ptr<int>(label);
        const int area = box[cv::CC_STAT_AREA];
        // What fills much of the picture is a form's outline and all that hangs on it.
        if (std::max(box[cv::CC_STAT_WIDTH], box[cv::CC_STAT_HEIGHT]) >= kLeastLength && area >= kLeastArea &&
            area <= largest) {
            InkMark mark;
            mark.label = label;
            mark.area = area;
            mark.thickest = 2.0 * deepest[static_cast<std::size_t>(label)] - 1;
            marks.marks.push_back(std::move(mark));
        }
    }
    std::vector<Gathered> gathered = Gatherer(plane, marks, count).gather();
    for (std::size_t i = 0; i < gathered.size(); ++i) {
        measure(marks.marks[i], gathered[i]);
    }
    return marks;
}

} // namespace limner
