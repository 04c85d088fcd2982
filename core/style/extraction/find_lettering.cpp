#include "core/style/extraction/find.h"
#include "core/style/extraction/ink_marks.h"
#include "core/style/extraction/leader_lines.h"
#include "core/style/extraction/text_rows.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

/// Text on a plane, pixel by pixel.
class Lettering {
  public:
    explicit Lettering(const InkMarks& marks, const std::vector<TextRow>& rows)
        : marks_(marks), rows_(rows), letter_(lettersOf(marks, rows)) {}

    /// The ink of letters, and of what lies between two of them in a row, where some have run together.
    [[nodiscard]] cv::Mat ink() const {
        cv::Mat band(marks_.height, marks_.width, CV_8U, cv::Scalar(0));
        for (const TextRow& row : rows_) {
            for (std::size_t k = 1; k < row.letters.size(); ++k) {
                std::vector<cv::Point> corners;
                for (const std::size_t i : {row.letters[k - 1], row.letters[k]}) {
                    for (const glm::vec2& corner : marks_.marks[i].hull) {
                        corners.emplace_back(static_cast<int>(corner.x), static_cast<int>(corner.y));
                    }
                }
                std::vector<cv::Point> hull;
                cv::convexHull(corners, hull);
                cv::fillConvexPoly(band, hull, cv::Scalar(255));
            }
        }
        cv::Mat ink(marks_.height, marks_.width, CV_8U, cv::Scalar(0));
        for (std::size_t i = 0; i < marks_.labels.size(); ++i) {
            const std::int32_t label = marks_.labels[i];
            ink.data[i] = label > 0 && (band.data[i] != 0 || isLetter(label)) ? 255 : 0;
        }
        return ink;
    }

    /// Letters of rows that stand on bare paper: labels'. To those over a form no lines lead.
    [[nodiscard]] std::vector<glm::dvec2> labels() const {
        constexpr double kBare = 0.05; // of what lies around, by other ink
        std::vector<glm::dvec2> places;
        for (const TextRow& row : rows_) {
            double inked = 0;
            for (const std::size_t i : row.letters) {
                inked += inkedAround(marks_.marks[i].centre, static_cast<int>(1.6 * row.height));
            }
            if (inked < kBare * static_cast<double>(row.letters.size())) {
                for (const std::size_t i : row.letters) {
                    places.push_back(marks_.marks[i].centre);
                }
            }
        }
        return places;
    }

  private:
    static std::vector<bool> lettersOf(const InkMarks& marks, const std::vector<TextRow>& rows) {
        std::vector<bool> letter(1, false);
        for (const TextRow& row : rows) {
            for (const std::size_t i : row.letters) {
                const auto label = static_cast<std::size_t>(marks.marks[i].label);
                letter.resize(std::max(letter.size(), label + 1), false);
                letter[label] = true;
            }
        }
        return letter;
    }

    [[nodiscard]] bool isLetter(std::int32_t label) const {
        return static_cast<std::size_t>(label) < letter_.size() && letter_[static_cast<std::size_t>(label)];
    }

    /// Share of a square around a place that has ink which is no letter's.
    [[nodiscard]] double inkedAround(glm::dvec2 place, int reach) const {
        int inked = 0;
        int all = 0;
        const auto x0 = static_cast<int>(place.x);
        const auto y0 = static_cast<int>(place.y);
        for (int y = std::max(0, y0 - reach); y < std::min(marks_.height, y0 + reach); y += 2) {
            const std::int32_t* row = marks_.labels.data() + static_cast<std::ptrdiff_t>(y) * marks_.width;
            for (int x = std::max(0, x0 - reach); x < std::min(marks_.width, x0 + reach); x += 2) {
                inked += row[x] != 0 && !isLetter(row[x]) ? 1 : 0;
                ++all;
            }
        }
        return inked / static_cast<double>(std::max(1, all));
    }

    const InkMarks& marks_;
    const std::vector<TextRow>& rows_;
    std::vector<bool> letter_; ///< by label
};

void addLines(const std::vector<LeaderLine>& lines, cv::Mat& ink) {
    constexpr int kBits = 4; // of a pixel's fraction
    const auto fixed = [](glm::dvec2 place) {
        return cv::Point(static_cast<int>(std::lround((place.x - 0.5) * (1 << kBits))),
                         static_cast<int>(std::lround((place.y - 0.5) * (1 << kBits))));
    };
    for (const LeaderLine& line : lines) {
        cv::line(ink, fixed(line.from), fixed(line.to), cv::Scalar(255),
                 std::max(1, static_cast<int>(std::lround(line.width))), cv::LINE_8, kBits);
    }
}

/// Letters and lines of dark ink, or of light, over the picture's own pixels.
cv::Mat letteringOf(const ArtPicture& picture, bool light) {
    const InkPlane plane = inkPlaneOf(picture, light);
    const InkMarks marks = inkMarksOf(plane);
    const std::vector<TextRow> rows = textRowsOf(marks, light);
    const Lettering lettering(marks, rows);
    cv::Mat ink = lettering.ink();
    if (!light) {
        addLines(leaderLinesOf(plane, lettering.labels()), ink);
    }
    // The soft edge of a stroke belongs to it.
    cv::dilate(ink, ink, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    cv::Mat over;
    cv::resize(ink, over, {picture.width, picture.height}, 0, 0, cv::INTER_AREA);
    return over;
}

} // namespace

Mask findLettering(const ArtCut& cut) {
    const ArtPicture& picture = cut.picture;
    Mask mask{picture.width, picture.height, {}};
    mask.values.assign(picture.pixels.size(), 0);
    constexpr int kLeastSide = 12;
    if (std::min(picture.width, picture.height) < kLeastSide) {
        return mask;
    }
    cv::Mat dark;
    cv::Mat light;
    tbb::parallel_invoke([&] { dark = letteringOf(picture, false); }, [&] { light = letteringOf(picture, true); });
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        mask.values[i] = std::max(dark.data[i], light.data[i]);
    }
    return mask;
}

} // namespace limner
