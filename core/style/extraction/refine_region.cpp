#include "core/style/extraction/find.h"

#include "core/base/task.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr int kWorkSide = 320;      ///< of the lasso's surroundings: GrabCut is slow, outlines are smooth
constexpr int kRounds = 3;          ///< of GrabCut: the outline hardly moves after that
constexpr double kLeastForm = 0.05; ///< of the lasso's area: less is not what it meant

/// The lasso in pixels of the cut.
std::vector<cv::Point> polygonOf(const ArtCut& cut, const ArtPath& lasso) {
    std::vector<cv::Point> polygon;
    for (const glm::dvec2& p : lasso) {
        const glm::dvec2 q = glm::dvec2(cut.toCut(p));
        // Far beyond the picture is as good as just beyond.
        const auto place = [](double value, int size) {
            return static_cast<int>(std::clamp(std::isnan(value) ? 0.0 : value, -1.0 * size, 2.0 * size));
        };
        polygon.emplace_back(place(q.x, cut.picture.width), place(q.y, cut.picture.height));
    }
    return polygon;
}

/// The pictures within the lasso's surroundings, reduced.
struct Work {
    cv::Rect area;   ///< of the cut
    cv::Mat colours; ///< CV_8UC3
    cv::Mat lasso;   ///< CV_8U, 255 inside
};

Work workOf(const ArtCut& cut, const std::vector<cv::Point>& polygon) {
    Work work;
    const cv::Rect box = cv::boundingRect(polygon);
    const int margin = 4 + std::max(box.width, box.height) / 8;
    work.area = cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
                cv::Rect(0, 0, cut.picture.width, cut.picture.height);
    if (work.area.empty()) {
        return work;
    }
    const double scale = std::min(1.0, static_cast<double>(kWorkSide) / std::max(work.area.width, work.area.height));
    const cv::Size size(std::max(1, static_cast<int>(work.area.width * scale)),
                        std::max(1, static_cast<int>(work.area.height * scale)));
    const cv::Mat whole(cut.picture.height, cut.picture.width, CV_32FC4, const_cast<Rgba*>(cut.picture.pixels.data()));
    cv::Mat small;
    cv::resize(whole(work.area), small, size, 0, 0, cv::INTER_AREA);
    small.convertTo(small, CV_8UC4, 255);
    cv::cvtColor(small, work.colours, cv::COLOR_RGBA2RGB);
    cv::Mat lasso = cv::Mat::zeros(cut.picture.height, cut.picture.width, CV_8U);
    cv::fillPoly(lasso, std::vector<std::vector<cv::Point>>{polygon}, cv::Scalar(255));
    cv::resize(lasso(work.area), work.lasso, size, 0, 0, cv::INTER_AREA);
    return work;
}

/// GrabCut's classes: what lies within a little of the lasso may be ground, its middle is form, all outside is ground.
cv::Mat classesOf(const cv::Mat& lasso) {
    cv::Mat inside = lasso >= 128;
    cv::Mat depth;
    cv::distanceTransform(inside, depth, cv::DIST_L2, 3);
    double deepest = 0;
    cv::minMaxLoc(depth, nullptr, &deepest);
    cv::Mat near;
    cv::dilate(inside, near, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    cv::Mat classes(lasso.size(), CV_8U, cv::Scalar(cv::GC_BGD));
    classes.setTo(cv::GC_PR_BGD, near);
    classes.setTo(cv::GC_PR_FGD, inside);
    classes.setTo(cv::GC_FGD, depth > 0.7 * deepest);
    return classes;
}

/// The largest connected part, its holes closed.
cv::Mat largestPart(const cv::Mat& form) {
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(form, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    cv::Mat part = cv::Mat::zeros(form.size(), CV_8U);
    const auto largest = std::max_element(outlines.begin(), outlines.end(), [](const auto& a, const auto& b) {
        return cv::contourArea(a) < cv::contourArea(b);
    });
    if (largest != outlines.end()) {
        cv::drawContours(part, outlines, static_cast<int>(largest - outlines.begin()), cv::Scalar(255), cv::FILLED);
    }
    return part;
}

} // namespace

Mask refineRegion(const ArtCut& cut, const ArtPath& lasso, Task& task) {
    Mask mask{cut.picture.width, cut.picture.height, std::vector<std::uint8_t>(cut.picture.pixels.size(), 0)};
    const std::vector<cv::Point> polygon = polygonOf(cut, lasso);
    if (polygon.size() < 3 || cut.picture.empty()) {
        return {};
    }
    const Work work = workOf(cut, polygon);
    const int meant = work.area.empty() ? 0 : cv::countNonZero(work.lasso >= 128);
    if (meant < 16) {
        return {};
    }
    cv::Mat classes = classesOf(work.lasso);
    // Where the lasso fills the picture there is no ground to tell the form from.
    if (cv::countNonZero(classes == cv::GC_BGD) + cv::countNonZero(classes == cv::GC_PR_BGD) >= 16) {
        cv::Mat ground;
        cv::Mat form;
        cv::theRNG().state = 1; // its clusters start at random: the same lasso gives the same form
        for (int round = 0; round < kRounds; ++round) {
            task.throwIfCancelled();
            cv::grabCut(work.colours, classes, {}, ground, form, 1, round == 0 ? cv::GC_INIT_WITH_MASK : cv::GC_EVAL);
        }
    }
    cv::Mat found = (classes == cv::GC_FGD) | (classes == cv::GC_PR_FGD);
    cv::medianBlur(found, found, 5);
    found = largestPart(found);
    if (cv::countNonZero(found) < kLeastForm * meant) {
        return {};
    }
    cv::Mat soft;
    cv::GaussianBlur(found, soft, {5, 5}, 1);
    cv::Mat whole(mask.height, mask.width, CV_8U, mask.values.data());
    cv::Mat part;
    cv::resize(soft, part, work.area.size(), 0, 0, cv::INTER_LINEAR);
    part.copyTo(whole(work.area));
    return mask;
}

} // namespace limner
