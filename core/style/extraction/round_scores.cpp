#include "core/style/extraction/round_scores.h"

#include <glm/geometric.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace limner {
namespace {

constexpr double kTurn = 6.28318530717958647692;
/// Of an oval whose inside is looked at, in pixels of the level that is looked at: strokes and grain have melted there.
constexpr double kLookedRadius = 9;

/// Smoothly from 0 at `none` to 1 at `all`.
double rising(double value, double none, double all) {
    const double t = std::clamp((value - none) / (all - none), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Places on the unit disk in rings, each standing for about the same area.
std::vector<glm::dvec2> diskPlaces(int rings, double most) {
    std::vector<glm::dvec2> places;
    for (int ring = 0; ring < rings; ++ring) {
        const double radius = most * (ring + 0.5) / rings;
        const int around = 6 * ring + 4;
        for (int i = 0; i < around; ++i) {
            const double angle = kTurn * (i + 0.5 * (ring % 2)) / around;
            places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
    }
    return places;
}

float distance(const glm::vec4& a, const glm::vec4& b) { return glm::length(a - b); }

} // namespace

RoundScores::RoundScores(const Tones& tones) {
    levels_.push_back(tones);
    while (std::min(levels_.back().width, levels_.back().height) >= 24) {
        levels_.push_back(halved(levels_.back()));
    }
    findPaper();
}

void RoundScores::findPaper() {
    const Tones& tones = levels_.front();
    std::vector<glm::vec4> border;
    for (int x = 0; x < tones.width; ++x) {
        border.push_back(tones.at(x, 0));
        border.push_back(tones.at(x, tones.height - 1));
    }
    for (int y = 0; y < tones.height; ++y) {
        border.push_back(tones.at(0, y));
        border.push_back(tones.at(tones.width - 1, y));
    }
    // The tone that most of the border is near to, of a few dozen of its own.
    constexpr float kNear = 0.07F;
    glm::vec4 ground(0);
    std::size_t most = 0;
    for (std::size_t i = 0; i < border.size(); i += border.size() / 40 + 1) {
        const auto like = static_cast<std::size_t>(std::count_if(
            border.begin(), border.end(), [&](const glm::vec4& tone) { return distance(tone, border[i]) < kNear; }));
        if (like > most) {
            most = like;
            ground = border[i];
        }
    }
    if (most * 5 < border.size() * 2) {
        return;
    }
    cv::Mat like(tones.height, tones.width, CV_8U);
    for (int y = 0; y < tones.height; ++y) {
        for (int x = 0; x < tones.width; ++x) {
            like.at<std::uint8_t>(y, x) = distance(tones.at(x, y), ground) < 1.6F * kNear ? 255 : 0;
        }
    }
    // Only what hangs together with the border: a form's highlight may be bare paper too.
    cv::Mat labels;
    const int count = cv::connectedComponents(like, labels, 4);
    std::vector<bool> outer(static_cast<std::size_t>(count), false);
    for (int x = 0; x < tones.width; ++x) {
        outer[static_cast<std::size_t>(labels.at<int>(0, x))] = true;
        outer[static_cast<std::size_t>(labels.at<int>(tones.height - 1, x))] = true;
    }
    for (int y = 0; y < tones.height; ++y) {
        outer[static_cast<std::size_t>(labels.at<int>(y, 0))] = true;
        outer[static_cast<std::size_t>(labels.at<int>(y, tones.width - 1))] = true;
    }
    paper_.resize(tones.pixels.size());
    for (std::size_t i = 0; i < paper_.size(); ++i) {
        const auto at = static_cast<std::size_t>(labels.ptr<int>()[i]);
        paper_[i] = like.ptr<std::uint8_t>()[i] != 0 && outer[at] ? 255 : 0;
    }
}

double RoundScores::paperWithin(const Oval& oval) const {
    if (paper_.empty()) {
        return 0;
    }
    static const std::vector<glm::dvec2> places = diskPlaces(7, 0.94);
    const Tones& tones = levels_.front();
    int paper = 0;
    for (const glm::dvec2& place : places) {
        const glm::dvec2 at = oval.at(place);
        if (tones.holds(at)) {
            const auto row = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(tones.width);
            paper += paper_[row + static_cast<std::size_t>(at.x)] != 0 ? 1 : 0;
        }
    }
    return paper / static_cast<double>(places.size());
}

double RoundScores::beyond(const Oval& oval) const {
    constexpr int kPlaces = 48;
    int out = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const double angle = kTurn * i / kPlaces;
        out += levels_.front().holds(oval.at({std::cos(angle), std::sin(angle)})) ? 0 : 1;
    }
    return out / static_cast<double>(kPlaces);
}

InnerCourse RoundScores::courseOf(const Oval& oval) const {
    std::size_t level = 0;
    Oval on = oval;
    while (level + 1 < levels_.size() && on.semiAxes().y >= 2 * kLookedRadius) {
        ++level;
        on = Oval{on.centre / 2.0, on.xx / 2, on.xy / 2, on.yy / 2};
    }
    const Tones& tones = levels_[level];
    static const std::vector<glm::dvec2> places = diskPlaces(8, 0.9);
    std::vector<std::array<double, 6>> rows;
    std::vector<std::array<double, 3>> values;
    for (const glm::dvec2& p : places) {
        const glm::dvec2 at = on.at(p);
        if (tones.holds(at)) {
            const glm::vec4 tone = tones.between(at);
            rows.push_back({1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y});
            values.push_back({tone.x, tone.y, tone.z});
        }
    }
    InnerCourse course;
    if (rows.size() < places.size() / 2) {
        return course;
    }
    const cv::Mat a(static_cast<int>(rows.size()), 6, CV_64F, rows.data());
    const cv::Mat b(static_cast<int>(values.size()), 3, CV_64F, values.data());
    cv::Mat x;
    cv::solve(a, b, x, cv::DECOMP_NORMAL | cv::DECOMP_CHOLESKY);
    const cv::Mat fitted = a * x;
    double whole = 0;
    for (int c = 0; c < 3; ++c) {
        cv::Scalar mean;
        cv::Scalar spread;
        cv::meanStdDev(b.col(c), mean, spread);
        whole += spread[0] * spread[0];
    }
    const double count = static_cast<double>(values.size());
    const double off = cv::norm(b, fitted, cv::NORM_L2SQR) / count;
    double low = 0;
    double high = 0;
    cv::minMaxLoc(fitted.col(0), &low, &high);
    course.range = high - low;
    course.spread = std::sqrt(whole);
    course.bulging = -(x.at<double>(3, 0) + x.at<double>(5, 0)) / 2 / std::max(course.range, 1e-3);
    course.smooth = whole > 1e-8 ? std::clamp(1 - off / whole, 0.0, 1.0) : 0;
    // Over a sixth of the radius a ball's tones change by a third of their range at most, but at its very rim.
    const double jump = 0.36 * course.range + 0.04;
    int broken = 0;
    for (const glm::dvec2& p : places) {
        const glm::dvec2 at = p * 0.88;
        const glm::vec4 across =
            tones.between(on.at(at + glm::dvec2(0.085, 0))) - tones.between(on.at(at - glm::dvec2(0.085, 0)));
        const glm::vec4 down =
            tones.between(on.at(at + glm::dvec2(0, 0.085))) - tones.between(on.at(at - glm::dvec2(0, 0.085)));
        broken += std::sqrt(glm::dot(across, across) + glm::dot(down, down)) > jump ? 1 : 0;
    }
    course.broken = broken / static_cast<double>(places.size());
    return course;
}

double RoundScores::formOf(const Oval& oval) const {
    const glm::dvec2 axes = oval.semiAxes();
    const double plump = 0.5 + 0.5 * rising(axes.y / axes.x, 0.4, 0.75);
    return plump * (1 - rising(beyond(oval), 0, 0.25)) * (1 - rising(paperWithin(oval), 0.02, 0.15));
}

double RoundScores::guess(const Oval& oval) const {
    const Tones& tones = levels_.front();
    constexpr int kPlaces = 40;
    constexpr float kEdge = 0.06F;
    // Steps across the rim, and as long ones within: those of a texture do not make an edge.
    std::vector<float> across;
    std::vector<float> within;
    std::ptrdiff_t lighter = 0;
    std::ptrdiff_t darker = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const double angle = kTurn * i / kPlaces;
        const glm::dvec2 p(std::cos(angle), std::sin(angle));
        const auto tone = [&](double radius) { return tones.between(oval.at(p * radius)); };
        across.push_back(std::max(distance(tone(1), tone(0.88)), distance(tone(1.12), tone(1))));
        within.push_back(distance(tone(0.72), tone(0.6)));
        const float brighter = tone(0.9).x - tone(1.1).x;
        lighter += brighter > kEdge ? 1 : 0;
        darker += brighter < -kEdge ? 1 : 0;
    }
    std::nth_element(within.begin(), within.begin() + kPlaces / 2, within.end());
    const float edge = std::max(kEdge, 1.4F * within[kPlaces / 2]);
    const auto edged = std::count_if(across.begin(), across.end(), [&](float step) { return step > edge; });
    // All of it lighter or all of it darker than what is around: an edge, whatever is within.
    const std::ptrdiff_t alike = std::max(lighter, darker);
    Rim rim{oval};
    rim.support = static_cast<double>(alike * 5 > kPlaces * 4 ? std::max(edged, alike) : edged) / kPlaces;
    rim.contrast = 0.1;
    return of(rim);
}

double RoundScores::of(const Rim& rim) const {
    const InnerCourse course = courseOf(rim.oval);
    const double whole = 1 - rising(course.broken, 0.07, 0.38);
    // Without an edge only a lighter middle makes a bulge; with one, the light may come from the side.
    const double lit = rising(course.bulging, -0.1, 0.35);
    const double trust = 0.4 * rising(rim.support, 0.2, 0.5);
    const double shaded =
        rising(course.range, 0.08, 0.4) * rising(course.smooth, 0.3, 0.85) * whole * (trust + (1 - trust) * lit);
    // Where the inside does not hang together, only an edge all around says that it is one thing.
    const double edged = rising(rim.support, 0.55 - 0.25 * shaded, 0.95 - 0.1 * shaded) *
                         (0.4 + 0.6 * rising(rim.contrast, 0.02, 0.15)) * (1 - 0.6 * rising(rim.wobble, 0.006, 0.03));
    // A flat disk is a hole or a coin: nothing to take a style from.
    const double flat = 1 - rising(course.spread, 0.03, 0.1);
    // Of a small form there is little to take; a small one that is certain is better than a guess.
    const Tones& tones = levels_.front();
    const double share = rim.oval.radius() / std::max(tones.width, tones.height);
    const double sized = std::max(0.25 + 0.75 * rising(share, 0.01, 0.1), 0.6 * edged);
    return (0.5 * edged + 0.5 * shaded) * (1 - 0.75 * flat) * sized * formOf(rim.oval);
}

} // namespace limner
