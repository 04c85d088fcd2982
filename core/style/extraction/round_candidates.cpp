#include "core/style/extraction/round_candidates.h"

#include "core/base/task.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace limner {
namespace {

/// Radii in shares of the longer side.
constexpr double kSmallest = 0.012;
constexpr double kLargest = 0.5;

struct Candidate {
    Oval oval;
    double rank = 0; ///< how likely; only to choose which are looked at
};

/// Lightness and chromas in 8 bits, as OpenCV's finders want them; clear parts come out mid grey.
std::array<cv::Mat, 3> planesOf(const Tones& tones) {
    std::array<cv::Mat, 3> planes;
    for (cv::Mat& plane : planes) {
        plane.create(tones.height, tones.width, CV_8U);
    }
    for (int y = 0; y < tones.height; ++y) {
        for (int x = 0; x < tones.width; ++x) {
            const glm::vec4& tone = tones.at(x, y);
            const float values[3] = {tone.x + 0.5F * (1 - tone.w), 0.5F + tone.y, 0.5F + tone.z};
            for (std::size_t c = 0; c < 3; ++c) {
                planes[c].at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(255 * values[c]);
            }
        }
    }
    return planes;
}

/// The ellipse with a patch's area and second moments, and how far its outline strays from it.
std::optional<Candidate> candidateOf(const std::vector<cv::Point>& outline, double smallest, double largest) {
    if (outline.size() < 12) {
        return std::nullopt;
    }
    const cv::Moments m = cv::moments(outline);
    const double area = std::abs(m.m00);
    if (area < CV_PI * smallest * smallest || area > CV_PI * largest * largest) {
        return std::nullopt;
    }
    // Of an ellipse the matrix of second moments is a quarter of the square of its own matrix.
    const double a = m.mu20 / m.m00;
    const double b = m.mu11 / m.m00;
    const double c = m.mu02 / m.m00;
    const double root = std::sqrt(std::max(0.0, a * c - b * b));
    const double length = std::sqrt(a + c + 2 * root);
    if (!(root > 0)) {
        return std::nullopt;
    }
    Oval oval;
    oval.centre = {m.m10 / m.m00 + 0.5, m.m01 / m.m00 + 0.5};
    oval.xx = 2 * (a + root) / length;
    oval.xy = 2 * b / length;
    oval.yy = 2 * (c + root) / length;
    const glm::dvec2 axes = oval.semiAxes();
    if (axes.y < 0.4 * axes.x) {
        return std::nullopt;
    }
    double strayed = 0;
    for (const cv::Point& p : outline) {
        const glm::dvec2 onDisk = oval.toDisk({p.x + 0.5, p.y + 0.5});
        strayed += std::abs(std::hypot(onDisk.x, onDisk.y) - 1);
    }
    strayed /= static_cast<double>(outline.size());
    constexpr double kMostStrayed = 0.16;
    if (strayed > kMostStrayed) {
        return std::nullopt;
    }
    return Candidate{oval, (1 - strayed / kMostStrayed) * std::sqrt(oval.radius())};
}

class Collector {
  public:
    explicit Collector(const Tones& tones)
        : side_(std::max(tones.width, tones.height)), smallest_(std::max(4.0, kSmallest * side_)),
          largest_(kLargest * side_) {}

    void addOutlines(const cv::Mat& patches) {
        std::vector<std::vector<cv::Point>> outlines;
        cv::findContours(patches, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
        for (const auto& outline : outlines) {
            if (const auto candidate = candidateOf(outline, smallest_, largest_)) {
                all_.push_back(*candidate);
            }
        }
    }

    void addCircles(const cv::Mat& plane, double scale) {
        std::vector<cv::Vec4f> circles;
        cv::HoughCircles(plane, circles, cv::HOUGH_GRADIENT_ALT, 1.5, 8, 250, 0.7, static_cast<int>(smallest_ / scale),
                         static_cast<int>(largest_ / scale));
        for (const cv::Vec4f& circle : circles) {
            Oval oval;
            oval.centre = glm::dvec2(circle[0] + 0.5, circle[1] + 0.5) * scale;
            oval.xx = oval.yy = circle[2] * scale;
            all_.push_back({oval, std::sqrt(oval.radius())});
        }
    }

    /// Light patches on dark ground and dark ones on light, of every size, where a plane's Laplacian of a Gaussian of
    /// that size is largest: bulges without an edge.
    void addBulges(const cv::Mat& plane, double scale) {
        std::vector<cv::Mat> responses;
        std::vector<double> sigmas;
        cv::Mat floats;
        plane.convertTo(floats, CV_32F, 1 / 255.0);
        for (double sigma = smallest_ / scale / 1.4; 1.4 * sigma * scale < 0.6 * largest_; sigma *= 1.25) {
            cv::Mat near;
            cv::Mat wide;
            cv::GaussianBlur(floats, near, {}, sigma);
            cv::GaussianBlur(floats, wide, {}, 1.25 * sigma);
            responses.push_back(near - wide);
            sigmas.push_back(sigma);
        }
        for (std::size_t i = 1; i + 1 < responses.size(); ++i) {
            for (int y = 1; y + 1 < plane.rows; ++y) {
                for (int x = 1; x + 1 < plane.cols; ++x) {
                    const float here = responses[i].at<float>(y, x);
                    if (std::abs(here) < 0.012F || !largest(responses, i, x, y)) {
                        continue;
                    }
                    Oval oval;
                    oval.centre = glm::dvec2(x + 0.5, y + 0.5) * scale;
                    for (const double times : {1.4, 1.9}) {
                        oval.xx = oval.yy = times * sigmas[i] * scale;
                        all_.push_back({oval, 8 * std::abs(here) * std::sqrt(oval.radius())});
                    }
                }
            }
        }
    }

    /// The likeliest; of those that are almost the same, one.
    std::vector<Oval> best(std::size_t most) {
        std::stable_sort(all_.begin(), all_.end(), [](const auto& a, const auto& b) { return a.rank > b.rank; });
        std::vector<Oval> ovals;
        for (const Candidate& candidate : all_) {
            const bool known = std::any_of(ovals.begin(), ovals.end(), [&](const Oval& oval) {
                const double radius = oval.radius();
                const glm::dvec2 apart = oval.centre - candidate.oval.centre;
                return std::hypot(apart.x, apart.y) < 0.1 * radius &&
                       std::abs(oval.xx - candidate.oval.xx) < 0.12 * radius &&
                       std::abs(oval.yy - candidate.oval.yy) < 0.12 * radius &&
                       std::abs(oval.xy - candidate.oval.xy) < 0.12 * radius;
            });
            if (!known) {
                ovals.push_back(candidate.oval);
            }
            if (ovals.size() == most) {
                break;
            }
        }
        return ovals;
    }

  private:
    /// Of its neighbours in place and size, or of the smallest.
    static bool largest(const std::vector<cv::Mat>& responses, std::size_t i, int x, int y) {
        const float here = responses[i].at<float>(y, x);
        for (std::size_t k = i - 1; k <= i + 1; ++k) {
            for (int dy = -1; dy <= 1; ++dy) {
                const auto* row = responses[k].ptr<float>(y + dy);
                for (int dx = -1; dx <= 1; ++dx) {
                    if (here > 0 ? row[x + dx] > here : row[x + dx] < here) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    double side_;
    double smallest_;
    double largest_;
    std::vector<Candidate> all_;
};

/// Patches above each of some levels between a plane's darkest and lightest parts.
void addLevels(Collector& collector, const cv::Mat& plane, int levels) {
    std::array<int, 256> counts{};
    for (int y = 0; y < plane.rows; ++y) {
        const auto* row = plane.ptr<std::uint8_t>(y);
        for (int x = 0; x < plane.cols; ++x) {
            ++counts[row[x]];
        }
    }
    const auto total = static_cast<double>(plane.total());
    const auto quantile = [&](double share) {
        double sum = 0;
        for (int level = 0; level < 256; ++level) {
            sum += counts[static_cast<std::size_t>(level)];
            if (sum > share * total) {
                return level;
            }
        }
        return 255;
    };
    const int low = quantile(0.02);
    const int high = quantile(0.98);
    if (high - low < 8) {
        return;
    }
    cv::Mat patches;
    for (int i = 1; i <= levels; ++i) {
        const double level = low + (high - low) * i / (levels + 1.0);
        cv::threshold(plane, patches, level, 255, cv::THRESH_BINARY);
        collector.addOutlines(patches);
    }
}

/// Patches of like colour.
void addColours(Collector& collector, const std::array<cv::Mat, 3>& planes) {
    constexpr int kColours = 7;
    constexpr int kSide = 160;
    cv::Mat lab;
    cv::merge(planes.data(), 3, lab);
    const double scale = std::max(1.0, std::max(lab.rows, lab.cols) / static_cast<double>(kSide));
    cv::Mat small;
    cv::resize(lab, small, {}, 1 / scale, 1 / scale, cv::INTER_AREA);
    if (small.total() < kColours) {
        return;
    }
    cv::Mat samples;
    small.convertTo(samples, CV_32F);
    samples = samples.reshape(1, static_cast<int>(small.total()));
    cv::theRNG().state = 1; // the same picture gives the same patches
    cv::Mat labels;
    cv::Mat centres;
    cv::kmeans(samples, kColours, labels, cv::TermCriteria(cv::TermCriteria::MAX_ITER, 8, 1), 1, cv::KMEANS_PP_CENTERS,
               centres);
    cv::Mat nearest(lab.size(), CV_8U);
    for (int y = 0; y < lab.rows; ++y) {
        for (int x = 0; x < lab.cols; ++x) {
            const auto& p = lab.at<cv::Vec3b>(y, x);
            float least = 1e9F;
            for (int k = 0; k < kColours; ++k) {
                const auto* c = centres.ptr<float>(k);
                const float d[3] = {static_cast<float>(p[0]) - c[0], static_cast<float>(p[1]) - c[1],
                                    static_cast<float>(p[2]) - c[2]};
                const float away = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
                if (away < least) {
                    least = away;
                    nearest.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(k);
                }
            }
        }
    }
    const cv::Mat kernel = cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5});
    for (int k = 0; k < kColours; ++k) {
        cv::Mat patches = nearest == k;
        collector.addOutlines(patches);
        cv::morphologyEx(patches, patches, cv::MORPH_CLOSE, kernel);
        cv::morphologyEx(patches, patches, cv::MORPH_OPEN, kernel);
        collector.addOutlines(patches);
    }
}

} // namespace

std::vector<Oval> roundCandidates(const Tones& tones, const Task& task, std::size_t most) {
    Collector collector(tones);
    std::array<cv::Mat, 3> planes = planesOf(tones);
    for (cv::Mat& plane : planes) {
        cv::medianBlur(plane, plane, 5);
    }
    for (std::size_t c = 0; c < 3; ++c) {
        task.throwIfCancelled();
        addLevels(collector, planes[c], c == 0 ? 12 : 8);
        // Strokes and grain melt away, forms stay.
        cv::Mat broad;
        cv::GaussianBlur(planes[c], broad, {}, 0.008 * std::max(tones.width, tones.height));
        addLevels(collector, broad, c == 0 ? 10 : 6);
    }
    task.throwIfCancelled();
    addColours(collector, planes);
    task.throwIfCancelled();
    constexpr double kBulgeSide = 200;
    const double coarse = std::max(1.0, std::max(tones.width, tones.height) / kBulgeSide);
    cv::Mat small;
    cv::resize(planes[0], small, {}, 1 / coarse, 1 / coarse, cv::INTER_AREA);
    collector.addBulges(small, coarse);
    task.throwIfCancelled();
    cv::Mat plane = planes[0];
    for (double scale = 2; scale < 5; scale *= 2) {
        cv::pyrDown(plane, plane);
        collector.addCircles(plane, scale);
    }
    return collector.best(most);
}

} // namespace limner
