#include "core/style/extraction/leader_lines.h"

#include <glm/geometric.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace limner {
namespace {

/// Of what is searched for segments.
constexpr double kSearchedSide = 800;
/// In shares of the plane's longer side.
constexpr double kLeastLength = 0.015;
constexpr double kLeastAlone = 0.05; ///< without a letter beside it
/// Half of a line's width at most, and how far beside it to look, in pixels.
constexpr double kHalfWidth = 3;
constexpr double kBeside = 6;

/// What lies across a line at one of its places.
struct Crossing {
    double offset = 0; ///< of the darkest from the middle
    double ink = 1;
    double left = 1; ///< what lies beside, on either side
    double right = 1;
    double width = 0; ///< of what is darker than half way between
};

Crossing crossingAt(const InkPlane& plane, glm::dvec2 place, glm::dvec2 across) {
    constexpr double kStep = 0.5;
    Crossing crossing;
    const auto value = [&](double offset) { return static_cast<double>(plane.between(place + across * offset)); };
    for (double offset = -kHalfWidth; offset <= kHalfWidth; offset += kStep) {
        if (const double here = value(offset); here < crossing.ink) {
            crossing.ink = here;
            crossing.offset = offset;
        }
    }
    const auto beside = [&](double side) {
        double sum = 0;
        for (const double away : {kBeside - 2, kBeside - 1, kBeside, kBeside + 1}) {
            sum += value(crossing.offset + side * away) / 4;
        }
        return sum;
    };
    crossing.left = beside(-1);
    crossing.right = beside(1);
    const double half = (crossing.ink + std::min(crossing.left, crossing.right)) / 2;
    for (double offset = -kHalfWidth; offset <= kHalfWidth; offset += kStep) {
        crossing.width += value(crossing.offset + offset) < half ? kStep : 0;
    }
    return crossing;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(std::max<std::size_t>(1, values.size()));
}

/// How far values stray from their course, where that is slow.
double roughness(const std::vector<double>& values) {
    double sum = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        sum += std::abs(values[i] - values[i - 1]);
    }
    return sum / static_cast<double>(std::max<std::size_t>(2, values.size()) - 1);
}

struct Seed {
    LeaderLine line;
    bool clean = false; ///< there is nothing but it on either side
};

/// Whether there are more strokes a little further away on either side, as in hatching.
bool hasCompany(const InkPlane& plane, glm::dvec2 place, glm::dvec2 across, const Crossing& crossing) {
    constexpr double kFrom = 4;
    const double far = 0.02 * std::max(plane.width, plane.height);
    const double ground = std::min(crossing.left, crossing.right);
    const double dark = ground - 0.4 * (ground - crossing.ink);
    for (double away = kFrom; away <= far; away += 1) {
        for (const double side : {-1.0, 1.0}) {
            if (plane.between(place + across * (crossing.offset + side * away)) < dark) {
                return true;
            }
        }
    }
    return false;
}

/// A segment that is a line of ink alone on its ground, moved onto the middle of its ink.
std::optional<Seed> aloneOn(const InkPlane& plane, glm::dvec2 from, glm::dvec2 to, double paper) {
    constexpr double kContrast = 0.2;
    constexpr double kMostWidth = 4.5;
    const double length = glm::distance(from, to);
    const glm::dvec2 along = (to - from) / length;
    const glm::dvec2 across(-along.y, along.x);
    std::vector<double> offsets;
    std::vector<double> widths;
    std::vector<double> left;
    std::vector<double> right;
    int all = 0;
    int accompanied = 0;
    for (double at = 0.5; at < length; at += 2) {
        const Crossing crossing = crossingAt(plane, from + along * at, across);
        ++all;
        if (std::min(crossing.left, crossing.right) - crossing.ink > kContrast && crossing.width <= kMostWidth) {
            offsets.push_back(crossing.offset);
            widths.push_back(crossing.width);
            left.push_back(crossing.left);
            right.push_back(crossing.right);
            accompanied += hasCompany(plane, from + along * at, across, crossing) ? 1 : 0;
        }
    }
    constexpr double kMostOfIt = 0.85;
    if (all == 0 || static_cast<double>(offsets.size()) < kMostOfIt * all) {
        return std::nullopt;
    }
    const double offset = median(offsets);
    const auto straight =
        std::count_if(offsets.begin(), offsets.end(), [&](double one) { return std::abs(one - offset) <= 1.5; });
    if (static_cast<double>(straight) < kMostOfIt * static_cast<double>(offsets.size())) {
        return std::nullopt;
    }
    Seed seed{{from + across * offset, to + across * offset, median(widths)}};
    constexpr double kAlike = 0.07;
    constexpr double kCalm = 0.022;
    seed.clean = std::abs(meanOf(left) - meanOf(right)) < kAlike &&
                 std::max(roughness(left), roughness(right)) < kCalm && accompanied < 0.3 * all;
    const bool onPaper = std::min(meanOf(left), meanOf(right)) > 0.85 * paper;
    return seed.clean || onPaper ? std::optional<Seed>(seed) : std::nullopt;
}

/// Where a line ends when it is followed on from one of its ends: over dashes, and over a form that it crosses.
glm::dvec2 followed(const InkPlane& plane, glm::dvec2 end, glm::dvec2 along) {
    constexpr int kRemembered = 24;
    constexpr double kGoesOn = 0.62;
    constexpr double kContrast = 0.12;
    const glm::dvec2 across(-along.y, along.x);
    const double most = 0.7 * std::max(plane.width, plane.height);
    std::vector<bool> hits(kRemembered, true);
    int count = kRemembered;
    double reached = 0;
    glm::dvec2 place = end;
    for (int step = 1; step < most; ++step) {
        place += along;
        if (place.x < 1 || place.y < 1 || place.x > plane.width - 1 || place.y > plane.height - 1) {
            break;
        }
        const Crossing crossing = crossingAt(plane, place, across);
        const bool hit = std::abs(crossing.offset) <= 1.5 && crossing.width <= 5 &&
                         std::min(crossing.left, crossing.right) - crossing.ink > kContrast;
        const auto at = static_cast<std::size_t>(step % kRemembered);
        count += (hit ? 1 : 0) - (hits[at] ? 1 : 0);
        hits[at] = hit;
        if (count < kGoesOn * kRemembered) {
            break;
        }
        if (hit) {
            reached = step;
            place += across * (0.1 * crossing.offset); // a long line is never drawn quite straight
        }
    }
    return end + along * reached;
}

/// Whether a line may begin there: beside a letter, or where the picture is cut off.
bool begins(const InkPlane& plane, const std::vector<glm::dvec2>& letters, glm::dvec2 place) {
    constexpr double kBorder = 6;
    constexpr double kBesideLetter = 0.028;
    const double near = kBesideLetter * std::max(plane.width, plane.height);
    return std::min({place.x, place.y, plane.width - place.x, plane.height - place.y}) < kBorder ||
           std::any_of(letters.begin(), letters.end(), [&](glm::dvec2 at) { return glm::distance(at, place) < near; });
}

/// What the lightest parts have.
double paperOf(const InkPlane& plane) {
    std::vector<double> some;
    for (std::size_t i = 0; i < plane.values.size(); i += plane.values.size() / 20000 + 1) {
        some.push_back(plane.values[i]);
    }
    const auto light = some.begin() + static_cast<std::ptrdiff_t>(some.size() * 9 / 10);
    std::nth_element(some.begin(), light, some.end());
    return *light;
}

/// Straight edges, the longest first.
std::vector<std::pair<glm::dvec2, glm::dvec2>> segmentsOf(const InkPlane& plane) {
    const cv::Mat values(plane.height, plane.width, CV_32F, const_cast<float*>(plane.values.data())); // only read
    const double side = std::max(plane.width, plane.height);
    const double scale = std::min(1.0, kSearchedSide / side);
    cv::Mat searched;
    cv::resize(values, searched, {}, scale, scale, cv::INTER_AREA);
    searched.convertTo(searched, CV_8U, 255);
    std::vector<cv::Vec4f> found;
    cv::createLineSegmentDetector(cv::LSD_REFINE_STD, 1.0)->detect(searched, found);
    std::vector<std::pair<glm::dvec2, glm::dvec2>> segments;
    for (const cv::Vec4f& s : found) {
        const glm::dvec2 from = (glm::dvec2(s[0], s[1]) + 0.5) / scale;
        const glm::dvec2 to = (glm::dvec2(s[2], s[3]) + 0.5) / scale;
        if (glm::distance(from, to) >= kLeastLength * side) {
            segments.emplace_back(from, to);
        }
    }
    std::stable_sort(segments.begin(), segments.end(), [](const auto& a, const auto& b) {
        return glm::distance(a.first, a.second) > glm::distance(b.first, b.second);
    });
    return segments;
}

double distanceTo(const LeaderLine& line, glm::dvec2 place) {
    const glm::dvec2 whole = line.to - line.from;
    const double share = std::clamp(glm::dot(place - line.from, whole) / glm::dot(whole, whole), 0.0, 1.0);
    return glm::distance(place, line.from + whole * share);
}

} // namespace

std::vector<LeaderLine> leaderLinesOf(const InkPlane& plane, const std::vector<glm::dvec2>& letters) {
    const double side = std::max(plane.width, plane.height);
    const double paper = paperOf(plane);
    std::vector<LeaderLine> lines;
    for (const auto& [from, to] : segmentsOf(plane)) {
        const bool known = std::any_of(lines.begin(), lines.end(), [&, a = from, b = to](const LeaderLine& line) {
            return distanceTo(line, a) < 4 && distanceTo(line, b) < 4;
        });
        const auto seed = known ? std::nullopt : aloneOn(plane, from, to, paper); // known: the stroke's other side
        if (!seed) {
            continue;
        }
        LeaderLine line = seed->line;
        const glm::dvec2 along = glm::normalize(line.to - line.from);
        line.to = followed(plane, line.to, along);
        line.from = followed(plane, line.from, -along);
        const bool labelled = begins(plane, letters, line.from) || begins(plane, letters, line.to);
        const double length = glm::distance(line.from, line.to);
        if (labelled || (seed->clean && length > kLeastAlone * side)) {
            lines.push_back(line);
        }
    }
    return lines;
}

} // namespace limner
