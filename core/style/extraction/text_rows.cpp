#include "core/style/extraction/text_rows.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace limner {
namespace {

/// Of a letter with what is beside it.
constexpr double kLeastContrast = 0.24;
constexpr double kLeastStrictContrast = 0.38;
constexpr double kLeastFilled = 0.16; ///< of a letter's hull, by its ink
constexpr double kLeastHeight = 7;
/// Of a row's letters, in shares of the plane's longer side.
constexpr double kLargestHeight = 0.06;
constexpr double kLongestMark = 7;   ///< letters that have run together, in heights
constexpr double kWidestGap = 1.5;   ///< between neighbours, in heights
constexpr double kMostBent = 0.82;   ///< cosine of the angle between steps from letter to letter
constexpr double kLeastShared = 0.5; ///< of two neighbours' heights, side by side

/// Whether a mark may be a letter, looked at alone.
bool letterLike(const InkMark& mark, double contrast, double side) {
    const double length = std::max(mark.extent(mark.axis), mark.extent({-mark.axis.y, mark.axis.x}));
    return mark.contrast() >= contrast && length >= kLeastHeight && length <= 4 * kLargestHeight * side &&
           mark.stroke < 0.45 * length && mark.stroke > 0.04 * length && mark.area > kLeastFilled * mark.hullArea;
}

/// A letter that more than a stroke went into.
bool shaped(const InkMark& mark) { return mark.roundness > 0.3; }

/// Marks by place, to find those near a place without looking at all.
class Neighbourhood {
  public:
    Neighbourhood(const std::vector<InkMark>& marks, std::vector<std::size_t> which, double cell)
        : marks_(marks), cell_(cell) {
        for (const std::size_t i : which) {
            cells_[keyOf(marks[i].centre)].push_back(i);
        }
    }

    template <typename Take>
    void near(glm::dvec2 place, double distance, const Take& take) const {
        const auto low = keyOf(place - glm::dvec2(distance));
        const auto high = keyOf(place + glm::dvec2(distance));
        for (int y = low.second; y <= high.second; ++y) {
            for (int x = low.first; x <= high.first; ++x) {
                const auto cell = cells_.find({x, y});
                if (cell == cells_.end()) {
                    continue;
                }
                for (const std::size_t i : cell->second) {
                    if (glm::distance(marks_[i].centre, place) <= distance) {
                        take(i);
                    }
                }
            }
        }
    }

  private:
    [[nodiscard]] std::pair<int, int> keyOf(glm::dvec2 place) const {
        return {static_cast<int>(std::floor(place.x / cell_)), static_cast<int>(std::floor(place.y / cell_))};
    }

    const std::vector<InkMark>& marks_;
    double cell_;
    std::map<std::pair<int, int>, std::vector<std::size_t>> cells_;
};

/// How two marks stand to each other when read along a direction.
struct Step {
    glm::dvec2 direction{1, 0};
    double gap = 0;    ///< between them, in heights
    double shared = 0; ///< of their heights, as a share of the smaller
    double ratio = 1;  ///< of the larger height to the smaller
    double height = 0; ///< mean
};

Step stepBetween(const InkMark& a, const InkMark& b, glm::dvec2 direction) {
    Step step;
    step.direction = direction;
    const glm::dvec2 up(-direction.y, direction.x);
    const glm::dvec2 tallA = a.reach(up);
    const glm::dvec2 tallB = b.reach(up);
    const double heightA = tallA.y - tallA.x;
    const double heightB = tallB.y - tallB.x;
    step.height = (heightA + heightB) / 2;
    step.ratio = std::max(heightA, heightB) / std::max(1.0, std::min(heightA, heightB));
    step.shared = (std::min(tallA.y, tallB.y) - std::max(tallA.x, tallB.x)) / std::max(1.0, std::min(heightA, heightB));
    step.gap = (b.reach(direction).x - a.reach(direction).y) / std::max(1.0, step.height);
    return step;
}

bool likeInk(const InkMark& a, const InkMark& b) {
    const double strokes = std::max(a.stroke, b.stroke) / std::max(0.1, std::min(a.stroke, b.stroke));
    return strokes < 1.9 && std::abs(a.ink - b.ink) < 0.22;
}

bool mayFollow(const InkMark& a, const InkMark& b, const Step& step, double tallest) {
    return step.gap > -0.35 && step.gap < kWidestGap && step.shared > kLeastShared && step.ratio < 2.1 &&
           step.height >= kLeastHeight && step.height <= tallest && likeInk(a, b) &&
           std::max(a.extent(step.direction), b.extent(step.direction)) < kLongestMark * step.height;
}

/// Smoothly from 0 at `none` to 1 at `all`, either of which may be the larger.
double rising(double value, double none, double all) {
    const double t = std::clamp((value - none) / (all - none), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

struct Spread {
    double mean = 0;
    double deviation = 0;
};

Spread spreadOf(const std::vector<double>& values) {
    Spread spread;
    const auto count = static_cast<double>(std::max<std::size_t>(1, values.size()));
    for (const double value : values) {
        spread.mean += value / count;
    }
    for (const double value : values) {
        spread.deviation += (value - spread.mean) * (value - spread.mean) / count;
    }
    spread.deviation = std::sqrt(spread.deviation);
    return spread;
}

class RowFinder {
  public:
    /// `contrast`: of a letter, at least.
    RowFinder(const InkMarks& marks, double contrast)
        : marks_(marks.marks), contrast_(contrast), tallest_(kLargestHeight * std::max(marks.width, marks.height)),
          letters_(lettersOf(marks)), near_(marks_, letters_, 24), used_(marks_.size(), false) {}

    /// Rows that are sure by `least` or more and as clear as that, of marks that are in none yet; the clearest marks
    /// choose first.
    std::vector<TextRow> rows(double least, double contrast) {
        std::stable_sort(letters_.begin(), letters_.end(),
                         [&](std::size_t a, std::size_t b) { return marks_[a].contrast() > marks_[b].contrast(); });
        std::vector<TextRow> all;
        for (const std::size_t i : letters_) {
            if (used_[i] || !shaped(marks_[i])) {
                continue;
            }
            if (auto row = bestFrom(i); row && row->sure >= least && row->contrast >= contrast) {
                for (const std::size_t k : row->letters) {
                    used_[k] = true;
                }
                all.push_back(std::move(*row));
            }
        }
        return all;
    }

  private:
    using Chain = std::vector<std::size_t>;

    [[nodiscard]] std::vector<std::size_t> lettersOf(const InkMarks& marks) const {
        const double side = std::max(marks.width, marks.height);
        std::vector<std::size_t> letters;
        for (std::size_t i = 0; i < marks_.size(); ++i) {
            if (letterLike(marks_[i], contrast_, side)) {
                letters.push_back(i);
            }
        }
        return letters;
    }

    std::optional<TextRow> bestFrom(std::size_t first) const {
        const InkMark& mark = marks_[first];
        const double reach = (kWidestGap + 2.5) * std::max(mark.extent({1, 0}), mark.extent({0, 1}));
        std::optional<TextRow> best;
        near_.near(mark.centre, reach, [&](std::size_t second) {
            if (second == first || used_[second] || !likeInk(mark, marks_[second])) {
                return;
            }
            const glm::dvec2 direction = glm::normalize(marks_[second].centre - mark.centre);
            if (!mayFollow(mark, marks_[second], stepBetween(mark, marks_[second], direction), tallest_)) {
                return;
            }
            Chain chain{first, second};
            extend(chain);
            std::reverse(chain.begin(), chain.end());
            extend(chain);
            trim(chain);
            std::reverse(chain.begin(), chain.end());
            trim(chain);
            if (chain.size() < 3) {
                return;
            }
            TextRow row = judged(std::move(chain));
            const double worth = row.sure * static_cast<double>(row.letters.size());
            if (row.sure > 0 && (!best || worth > best->sure * static_cast<double>(best->letters.size()))) {
                best = std::move(row);
            }
        });
        return best;
    }

    /// Where the row goes on from its last mark: as its last few marks did.
    [[nodiscard]] glm::dvec2 courseOf(const Chain& chain) const {
        const std::size_t back = std::min<std::size_t>(chain.size() - 1, 3);
        return glm::normalize(marks_[chain.back()].centre - marks_[chain[chain.size() - 1 - back]].centre);
    }

    void extend(Chain& chain) const {
        constexpr std::size_t kLongest = 60;
        const glm::dvec2 first = courseOf(chain);
        const double usual = stepBetween(marks_[chain[0]], marks_[chain[1]], first).height;
        while (chain.size() < kLongest) {
            const InkMark& last = marks_[chain.back()];
            const glm::dvec2 course = courseOf(chain);
            std::optional<std::size_t> best;
            double least = 1e9;
            const double height = last.extent({-course.y, course.x});
            const double reach = (kWidestGap + 1.2) * height + 1.5 * last.extent(course);
            near_.near(last.centre, reach, [&](std::size_t i) {
                const glm::dvec2 way = marks_[i].centre - last.centre;
                const double length = glm::length(way);
                if (used_[i] || length <= 0 || glm::dot(way, course) < kMostBent * length ||
                    !likeInk(last, marks_[i]) || std::find(chain.begin(), chain.end(), i) != chain.end()) {
                    return;
                }
                const Step step = stepBetween(last, marks_[i], course);
                const double tall = marks_[i].extent({-course.y, course.x}) / usual;
                if (mayFollow(last, marks_[i], step, tallest_) && step.gap < least && tall > 0.45 && tall < 1.9) {
                    least = step.gap;
                    best = i;
                }
            });
            if (!best) {
                return;
            }
            chain.push_back(*best);
        }
    }

    /// A row runs on into hatching beside it: strokes at its end that are fainter than the rest are let go.
    void trim(Chain& chain) const {
        std::vector<double> contrasts;
        for (const std::size_t i : chain) {
            contrasts.push_back(marks_[i].contrast());
        }
        const double mean = spreadOf(contrasts).mean;
        while (chain.size() > 2 && (!shaped(marks_[chain.back()]) || marks_[chain.back()].contrast() < 0.75 * mean) &&
               marks_[chain.back()].contrast() < 0.95 * mean) {
            chain.pop_back();
        }
    }

    /// How far the marks' middles stray from a gently bent line, in heights.
    [[nodiscard]] double strayOf(const Chain& chain, double height) const {
        double stray = 0;
        int count = 0;
        for (std::size_t k = 1; k + 1 < chain.size(); ++k) {
            const glm::dvec2 before = marks_[chain[k - 1]].centre;
            const glm::dvec2 after = marks_[chain[k + 1]].centre;
            const glm::dvec2 along = glm::normalize(after - before);
            const glm::dvec2 from = marks_[chain[k]].centre - before;
            const double across = from.y * along.x - from.x * along.y;
            stray += across * across;
            ++count;
        }
        return count > 0 ? std::sqrt(stray / count) / height : 0;
    }

    [[nodiscard]] TextRow judged(Chain chain) const {
        TextRow row;
        std::vector<double> heights;
        std::vector<double> gaps;
        std::vector<double> contrasts;
        std::size_t shapes = 0;
        double thickness = 0;
        const auto count = static_cast<double>(chain.size());
        for (std::size_t k = 0; k < chain.size(); ++k) {
            const InkMark& mark = marks_[chain[k]];
            const std::size_t next = std::min(k + 1, chain.size() - 1);
            const glm::dvec2 direction =
                glm::normalize(marks_[chain[next]].centre - marks_[chain[k == 0 ? 0 : k - 1]].centre);
            heights.push_back(mark.extent({-direction.y, direction.x}));
            contrasts.push_back(mark.contrast());
            shapes += shaped(mark) ? 1 : 0;
            row.stroke += mark.stroke / count;
            row.ink += mark.ink / count;
            thickness += mark.thickest / mark.stroke / count; // a letter is a stroke everywhere, a gap or a dot is not
            if (next > k) {
                gaps.push_back(stepBetween(mark, marks_[chain[next]], direction).gap);
            }
        }
        const Spread height = spreadOf(heights);
        row.height = height.mean;
        row.contrast = spreadOf(contrasts).mean;
        row.sure = rising(count, 1.5, 7) * rising(row.contrast, 0.26, 0.46) *
                   rising(static_cast<double>(shapes) / count, 0.3, 0.7) *
                   rising(height.deviation / height.mean, 0.5, 0.2) * rising(spreadOf(gaps).deviation, 0.6, 0.2) *
                   rising(strayOf(chain, height.mean), 0.35, 0.12) * rising(row.stroke / row.height, 0.36, 0.26) *
                   rising(thickness, 2, 1.6);
        row.letters = std::move(chain);
        return row;
    }

    const std::vector<InkMark>& marks_;
    double contrast_;
    double tallest_;
    std::vector<std::size_t> letters_;
    Neighbourhood near_;
    std::vector<bool> used_;
};

/// Whether two rows may be of one hand.
bool alike(const TextRow& a, const TextRow& b) {
    const auto ratio = [](double x, double y) { return std::max(x, y) / std::max(1e-3, std::min(x, y)); };
    return ratio(a.height, b.height) < 1.5 && ratio(a.stroke, b.stroke) < 1.45 && std::abs(a.ink - b.ink) < 0.2;
}

/// Whether sure rows make a doubtful one text: enough letters of the same hand; a very short one must stand by them or
/// have more than the usual contrast.
bool vouched(const InkMarks& marks, const TextRow& row, const std::vector<TextRow>& sure, double usual) {
    constexpr std::size_t kEnough = 5;
    constexpr double kBy = 6; // heights
    std::size_t letters = 0;
    bool by = row.letters.size() > 3 || row.contrast > usual;
    for (const TextRow& one : sure) {
        if (!alike(one, row)) {
            continue;
        }
        letters += one.letters.size();
        by = by || std::any_of(one.letters.begin(), one.letters.end(), [&](std::size_t i) {
                 return glm::distance(marks.marks[i].centre, marks.marks[row.letters[1]].centre) < kBy * one.height;
             });
    }
    return by && letters >= kEnough;
}

} // namespace

std::vector<TextRow> textRowsOf(const InkMarks& marks, bool strict) {
    constexpr double kSure = 0.62;
    constexpr double kLikely = 0.1;
    constexpr double kStrictly = 0.5; // of contrast
    RowFinder finder(marks, strict ? kLeastStrictContrast : kLeastContrast);
    std::vector<TextRow> rows = finder.rows(kSure, strict ? kStrictly : 0);
    if (rows.empty()) {
        return rows;
    }
    // Accidental rows are fainter than any text.
    std::vector<double> contrasts;
    for (const TextRow& row : rows) {
        contrasts.push_back(row.contrast);
    }
    std::nth_element(contrasts.begin(), contrasts.begin() + static_cast<std::ptrdiff_t>(contrasts.size() / 2),
                     contrasts.end());
    const double usual = contrasts[contrasts.size() / 2];
    const double least = std::max(strict ? kStrictly : 0.37, 0.72 * usual);
    const std::vector<TextRow> doubtful = finder.rows(kLikely, least);
    std::copy_if(doubtful.begin(), doubtful.end(), std::back_inserter(rows),
                 [&, sure = rows](const TextRow& row) { return vouched(marks, row, sure, usual); });
    return rows;
}

} // namespace limner
