#include "core/base/task.h"
#include "core/style/extraction/find.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace limner {
namespace {

/// Longer side of what is looked at.
constexpr int kSide = 400;
/// Around the lasso, in shares of its longer side: what the ground looks like.
constexpr double kAround = 0.15;
/// How far the form may reach beyond the lasso, in shares of the latter's longer side.
constexpr double kBeyond = 0.03;
constexpr int kRounds = 5;
constexpr double kMelting = 0.005;

/// What is looked at: a box of the cut, reduced.
struct Field {
    cv::Rect box;
    cv::Size size;
    cv::Mat colours; ///< 8 bits, as GrabCut wants them
    cv::Mat lasso;   ///< 255 within it
    double lassoSide = 0;
};

std::optional<Field> fieldOf(const ArtCut& cut, const ArtPath& lasso) {
    const ArtPicture& picture = cut.picture;
    glm::dvec2 low(1e18);
    glm::dvec2 high(-1e18);
    for (const glm::dvec2& place : lasso) {
        const glm::dvec2 at = cut.toCut(place);
        if (!std::isfinite(at.x + at.y)) {
            return std::nullopt;
        }
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    if (lasso.size() < 3 || picture.empty()) {
        return std::nullopt;
    }
    const double margin = kAround * std::max(high.x - low.x, high.y - low.y) + 2;
    const auto pixel = [](double place, int most) { return static_cast<int>(std::clamp<double>(place, 0, most)); };
    Field field;
    field.box = {
        cv::Point(pixel(std::floor(low.x - margin), picture.width), pixel(std::floor(low.y - margin), picture.height)),
        cv::Point(pixel(std::ceil(high.x + margin), picture.width), pixel(std::ceil(high.y + margin), picture.height))};
    constexpr int kLeastSide = 8;
    if (field.box.width < kLeastSide || field.box.height < kLeastSide) {
        return std::nullopt;
    }
    const double scale = std::min(1.0, kSide / static_cast<double>(std::max(field.box.width, field.box.height)));
    field.size = {std::max(kLeastSide, static_cast<int>(std::lround(field.box.width * scale))),
                  std::max(kLeastSide, static_cast<int>(std::lround(field.box.height * scale)))};
    // Clear parts count as mid grey. OpenCV has no constant matrices; it is only read.
    const cv::Mat whole(picture.height, picture.width, CV_32FC4, const_cast<Rgba*>(picture.pixels.data()));
    cv::Mat small;
    cv::resize(whole(field.box), small, field.size, 0, 0, scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
    field.colours.create(field.size, CV_8UC3);
    for (int y = 0; y < small.rows; ++y) {
        for (int x = 0; x < small.cols; ++x) {
            const auto& p = small.at<cv::Vec4f>(y, x);
            for (int c = 0; c < 3; ++c) {
                field.colours.at<cv::Vec3b>(y, x)[c] =
                    cv::saturate_cast<std::uint8_t>(255 * (0.5F + (p[c] - 0.5F) * p[3]));
            }
        }
    }
    // Hatching and grain are no ground: they melt.
    cv::GaussianBlur(field.colours, field.colours, {}, kMelting * std::max(field.size.width, field.size.height));
    std::vector<cv::Point> outline;
    for (const glm::dvec2& place : lasso) {
        const glm::dvec2 at = cut.toCut(place) - glm::dvec2(field.box.x, field.box.y);
        outline.emplace_back(static_cast<int>(std::lround(at.x * field.size.width / field.box.width - 0.5)),
                             static_cast<int>(std::lround(at.y * field.size.height / field.box.height - 0.5)));
    }
    field.lasso = cv::Mat(field.size, CV_8U, cv::Scalar(0));
    cv::fillPoly(field.lasso, std::vector<std::vector<cv::Point>>{outline}, cv::Scalar(255));
    field.lassoSide = std::max(high.x - low.x, high.y - low.y) * field.size.width / field.box.width;
    return field;
}

cv::Mat disk(double radius) {
    const int r = std::max(1, static_cast<int>(std::lround(radius)));
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * r + 1, 2 * r + 1});
}

/// What is ground for certain, what may be, and what is likely the form.
cv::Mat firstGuess(const Field& field) {
    cv::Mat beyond;
    cv::dilate(field.lasso, beyond, disk(kBeyond * field.lassoSide));
    cv::Mat guess(field.size, CV_8U, cv::Scalar(cv::GC_BGD));
    guess.setTo(cv::GC_PR_BGD, beyond);
    // A lasso is drawn around a thing: along its inside there is more ground than thing.
    // So there is along the picture's edge.
    cv::Mat bordered;
    cv::copyMakeBorder(field.lasso, bordered, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::Mat depth;
    cv::distanceTransform(bordered, depth, cv::DIST_L2, 3);
    depth = depth(cv::Rect({1, 1}, field.size));
    double deepest = 0;
    cv::minMaxLoc(depth, nullptr, &deepest);
    guess.setTo(cv::GC_PR_FGD, depth > 0.12 * deepest);
    return guess;
}

/// Whether there is anything broad to see at all: on an empty ground GrabCut would cut the noise, and take long for it.
bool showsAnything(const Field& field) {
    constexpr double kBroad = 0.03;
    constexpr double kFaintest = 1.2; // CIE L*a*b*
    cv::Mat lab;
    field.colours.convertTo(lab, CV_32F, 1 / 255.0);
    cv::GaussianBlur(lab, lab, {}, kBroad * std::max(field.size.width, field.size.height));
    cv::cvtColor(lab, lab, cv::COLOR_RGB2Lab);
    cv::Scalar mean;
    cv::Scalar spread;
    cv::meanStdDev(lab, mean, spread);
    return cv::norm(spread) > kFaintest;
}

/// The largest connected piece, without holes.
cv::Mat largestPiece(const cv::Mat& form) {
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(form, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    cv::Mat piece(form.size(), CV_8U, cv::Scalar(0));
    const auto largest = std::max_element(outlines.begin(), outlines.end(), [](const auto& a, const auto& b) {
        return cv::contourArea(a) < cv::contourArea(b);
    });
    if (largest != outlines.end()) {
        cv::drawContours(piece, outlines, static_cast<int>(largest - outlines.begin()), cv::Scalar(255), cv::FILLED);
    }
    return piece;
}

/// Mean colour distance across the outline, and as much of it as the same stretch shows a little inside and outside.
bool standsOut(const Field& field, const cv::Mat& form) {
    cv::Mat lab;
    cv::Mat floats;
    field.colours.convertTo(floats, CV_32F, 1 / 255.0);
    cv::cvtColor(floats, lab, cv::COLOR_RGB2Lab);
    const double band = std::max(2.0, 0.03 * field.lassoSide);
    const auto ring = [&](double from, double to) { // pixels outside the outline; negative: inside
        cv::Mat inner = form;
        cv::Mat outer = form;
        const auto grown = [&](double by) {
            cv::Mat mask;
            if (by > 0) {
                cv::dilate(form, mask, disk(by));
            } else {
                cv::erode(form, mask, disk(-by), {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
            }
            return mask;
        };
        inner = grown(from);
        outer = grown(to);
        return cv::Mat(outer & ~inner);
    };
    const cv::Scalar inside = cv::mean(lab, ring(-2 * band, -0.5 * band));
    const cv::Scalar outside = cv::mean(lab, ring(0.5 * band, 2 * band));
    constexpr double kLeastDistance = 4; // CIE L*a*b*: seen side by side without looking for it
    return cv::norm(inside - outside) > kLeastDistance;
}

} // namespace

Mask refineRegion(const ArtCut& cut, const ArtPath& lasso, Task& task) {
    const auto field = fieldOf(cut, lasso);
    const int lassoed = field ? cv::countNonZero(field->lasso) : 0;
    constexpr int kLeastPixels = 30;
    if (lassoed < kLeastPixels || !showsAnything(*field)) {
        return {};
    }
    cv::Mat guess = firstGuess(*field);
    cv::Mat ground;
    cv::Mat thing;
    cv::theRNG().state = 1; // the same lasso gives the same form
    for (int round = 0; round < kRounds; ++round) {
        task.throwIfCancelled();
        const bool both = cv::countNonZero((guess == cv::GC_PR_FGD) | (guess == cv::GC_FGD)) > 0 &&
                          cv::countNonZero((guess == cv::GC_PR_BGD) | (guess == cv::GC_BGD)) > 0;
        if (!both) {
            return {};
        }
        cv::grabCut(field->colours, guess, {}, ground, thing, 1, round == 0 ? cv::GC_INIT_WITH_MASK : cv::GC_EVAL);
    }
    cv::Mat form = (guess == cv::GC_PR_FGD) | (guess == cv::GC_FGD);
    // Parted by a line, or hanging on one.
    cv::morphologyEx(form, form, cv::MORPH_CLOSE, disk(0.012 * field->lassoSide));
    cv::morphologyEx(form, form, cv::MORPH_OPEN, disk(0.012 * field->lassoSide));
    form = largestPiece(form);
    constexpr double kLeastShare = 0.04; // of the lasso
    if (cv::countNonZero(form) < kLeastShare * lassoed || !standsOut(*field, form)) {
        return {};
    }
    cv::GaussianBlur(form, form, {}, std::max(1.0, 0.006 * field->lassoSide));
    Mask mask{cut.picture.width, cut.picture.height, {}};
    mask.values.assign(cut.picture.pixels.size(), 0);
    cv::Mat whole(mask.height, mask.width, CV_8U, mask.values.data());
    cv::resize(form, whole(field->box), field->box.size(), 0, 0, cv::INTER_LINEAR);
    return mask;
}

} // namespace limner
