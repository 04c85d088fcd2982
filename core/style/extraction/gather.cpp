#include "core/style/extraction/gather.h"

#include "core/base/task.h"

#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace limner {
namespace {

constexpr double kKernel = 0.8;      ///< sigma of a level's kernel, in its texels: a plane needs votes on all sides
constexpr double kLeastVotes = 3;    ///< that a plane can be laid through
constexpr double kGoodError = 0.01;  ///< of a texel's mean: a level is fine enough to count where votes give that
constexpr double kReach = 0.02;      ///< of the disk's width: votes further away say nothing
constexpr int kRounds = 3;           ///< of leaving out outliers; the weights stand still after two
constexpr double kLeastScale = 0.01; ///< two steps of an 8-bit colour and some compression: never an outlier

/// Sums of votes around the texels of a square picture, in one plane each: w, w x, w y, w xx, w xy, w yy, then for each
/// colour w c, w c x, w c y, and at last w ww / w (for the effective number of votes).
constexpr int kPlanes = 16;
using Moments = std::array<cv::Mat, kPlanes>;

Moments emptyMoments(int side) {
    Moments m;
    for (cv::Mat& plane : m) {
        plane = cv::Mat::zeros(side, side, CV_64F);
    }
    return m;
}

double texel(float normal, int side) { return (0.5 + 0.5 * static_cast<double>(normal)) * side; }

int inside(double place, int side) { return std::clamp(static_cast<int>(place), 0, side - 1); }

/// The sums at the texels that the votes fall in; places count from the picture's centre, which keeps products small.
Moments momentsOf(const std::vector<Vote>& votes, const std::vector<float>& trust, int side, int half) {
    Moments m = emptyMoments(side);
    std::array<double*, kPlanes> plane{};
    for (std::size_t k = 0; k < kPlanes; ++k) {
        plane[k] = m[k].ptr<double>();
    }
    for (std::size_t i = 0; i < votes.size(); ++i) {
        const Vote& v = votes[i];
        const double w = static_cast<double>(v.weight) * trust[i];
        if (w <= 0 || (half >= 0 && v.half != half)) {
            continue;
        }
        const double px = texel(v.x, side);
        const double py = texel(-v.y, side);
        const auto at = static_cast<std::size_t>(inside(py, side)) * static_cast<std::size_t>(side) +
                        static_cast<std::size_t>(inside(px, side));
        const double x = px - side / 2.0;
        const double y = py - side / 2.0;
        const std::array<double, kPlanes> values{1,       x,   y,       x * x,   x * y, y * y,   v.r,     v.r * x,
                                                 v.r * y, v.g, v.g * x, v.g * y, v.b,   v.b * x, v.b * y, w};
        for (std::size_t k = 0; k < kPlanes; ++k) {
            plane[k][at] += w * values[k];
        }
    }
    return m;
}

/// Texels in fours; places are counted in the coarser texels from then on.
Moments halved(const Moments& fine) {
    // Powers of the place in each plane: each turns into half its number.
    constexpr std::array<double, kPlanes> kScale{1, .5, .5, .25, .25, .25, 1, .5, .5, 1, .5, .5, 1, .5, .5, 1};
    Moments m;
    for (std::size_t k = 0; k < kPlanes; ++k) {
        cv::resize(fine[k], m[k], {fine[k].cols / 2, fine[k].rows / 2}, 0, 0, cv::INTER_AREA);
        m[k] *= 4 * kScale[k]; // INTER_AREA gives means
    }
    return m;
}

/// A level's planes: the colour at each texel's centre, how many votes stand behind it, how far apart they are.
struct Level {
    cv::Mat colour;   ///< CV_32FC3
    cv::Mat votes;    ///< CV_32F
    bool near = true; ///< votes that its kernel reaches are near enough to speak for a texel
};

/// The value at a texel's centre of the plane through the votes.
cv::Vec3f planeAt(const std::array<double, kPlanes>& s, double cx, double cy) {
    const double w = s[0];
    const double mx = s[1] / w;
    const double my = s[2] / w;
    // A plane is hardly tilted where the votes lie on a line or a point.
    constexpr double kStiff = 0.02;
    const double xx = s[3] / w - mx * mx + kStiff;
    const double xy = s[4] / w - mx * my;
    const double yy = s[5] / w - my * my + kStiff;
    const double determinant = std::max(xx * yy - xy * xy, 1e-9);
    const double dx = cx - mx;
    const double dy = cy - my;
    cv::Vec3f colour;
    for (int c = 0; c < 3; ++c) {
        const auto k = static_cast<std::size_t>(6 + 3 * c);
        const double mean = s[k] / w;
        const double cX = s[k + 1] / w - mean * mx;
        const double cY = s[k + 2] / w - mean * my;
        const double slopeX = (cX * yy - cY * xy) / determinant;
        const double slopeY = (cY * xx - cX * xy) / determinant;
        colour[c] = static_cast<float>(std::clamp(mean + slopeX * dx + slopeY * dy, 0.0, 1.0));
    }
    return colour;
}

Level levelOf(const Moments& moments) {
    const int side = moments[0].rows;
    Moments blurred;
    tbb::parallel_for(0, kPlanes, [&](int k) {
        cv::GaussianBlur(moments[static_cast<std::size_t>(k)], blurred[static_cast<std::size_t>(k)], {5, 5}, kKernel,
                         kKernel, cv::BORDER_CONSTANT);
    });
    Level level{cv::Mat::zeros(side, side, CV_32FC3), cv::Mat::zeros(side, side, CV_32F)};
    tbb::parallel_for(0, side, [&](int y) {
        for (int x = 0; x < side; ++x) {
            std::array<double, kPlanes> s{};
            for (std::size_t k = 0; k < kPlanes; ++k) {
                s[k] = blurred[k].at<double>(y, x);
            }
            if (s[0] < 1e-9) {
                continue;
            }
            level.colour.at<cv::Vec3f>(y, x) = planeAt(s, x + 0.5 - side / 2.0, y + 0.5 - side / 2.0);
            // A Gaussian of weights w stands for (sum w)^2 / sum w^2 votes; the kernel itself for 4 pi sigma^2 texels'.
            const double each = s[15] / s[0]; // mean trust of those that count
            level.votes.at<float>(y, x) =
                static_cast<float>(s[0] / std::max(each, 0.1) * 4 * 3.14159 * kKernel * kKernel);
        }
    });
    return level;
}

/// The levels put together: `needed` votes for each texel of the finest; a texel that none has votes enough for, is 0.
struct Composed {
    cv::Mat colour;  ///< CV_32FC3
    cv::Mat known;   ///< CV_32F, 0 or 1: some level has a colour
    cv::Mat covered; ///< CV_32F, 0 or 1: and votes are near enough
};

Composed compose(const std::vector<Level>& levels, const cv::Mat& needed) {
    Composed result;
    for (std::size_t l = levels.size(); l-- > 0;) {
        const Level& level = levels[l];
        const cv::Size size = level.votes.size();
        Composed before{cv::Mat::zeros(size, CV_32FC3), cv::Mat::zeros(size, CV_32F), cv::Mat::zeros(size, CV_32F)};
        cv::Mat wanted;
        cv::resize(needed, wanted, size, 0, 0, cv::INTER_AREA);
        if (!result.colour.empty()) {
            cv::resize(result.colour, before.colour, size, 0, 0, cv::INTER_LINEAR);
            cv::resize(result.known, before.known, size, 0, 0, cv::INTER_NEAREST);
            cv::resize(result.covered, before.covered, size, 0, 0, cv::INTER_NEAREST);
        }
        result = before;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const float votes = level.votes.at<float>(y, x);
                if (votes < kLeastVotes) {
                    continue;
                }
                // From the coarser value to this one as the votes come to what is needed, so that no seam shows.
                const bool older = before.known.at<float>(y, x) > 0;
                const float share = older ? std::clamp(2 * votes / wanted.at<float>(y, x) - 1, 0.0F, 1.0F) : 1;
                cv::Vec3f& colour = result.colour.at<cv::Vec3f>(y, x);
                colour += share * (level.colour.at<cv::Vec3f>(y, x) - colour);
                result.known.at<float>(y, x) = 1;
                result.covered.at<float>(y, x) = level.near ? 1 : result.covered.at<float>(y, x);
            }
        }
    }
    return result;
}

/// Bilinear between texel centres; those not covered do not count.
cv::Vec3f sample(const Composed& composed, float nx, float ny) {
    const int side = composed.colour.rows;
    const double u = texel(nx, side) - 0.5;
    const double v = texel(-ny, side) - 0.5;
    const int x0 = static_cast<int>(std::floor(u));
    const int y0 = static_cast<int>(std::floor(v));
    cv::Vec3f sum;
    float weight = 0;
    for (int k = 0; k < 4; ++k) {
        const int x = std::clamp(x0 + k % 2, 0, side - 1);
        const int y = std::clamp(y0 + k / 2, 0, side - 1);
        const auto w = static_cast<float>(std::max(1e-6, 1 - std::abs(u - (x0 + k % 2))) *
                                          std::max(1e-6, 1 - std::abs(v - (y0 + k / 2))));
        if (composed.covered.at<float>(y, x) > 0) {
            sum += w * composed.colour.at<cv::Vec3f>(y, x);
            weight += w;
        }
    }
    return weight > 0 ? sum / weight : cv::Vec3f(-1, -1, -1);
}

float distance(const Vote& vote, const cv::Vec3f& colour) {
    const float r = vote.r - colour[0];
    const float g = vote.g - colour[1];
    const float b = vote.b - colour[2];
    return std::sqrt(r * r + g * g + b * b);
}

/// Votes by coarse patches of the disk, for statistics of their order.
class Patches {
  public:
    static constexpr int kSide = 48;

    explicit Patches(const std::vector<Vote>& votes) : members_(static_cast<std::size_t>(kSide) * kSide) {
        for (std::size_t i = 0; i < votes.size(); ++i) {
            members_[patchOf(votes[i])].push_back(static_cast<std::uint32_t>(i));
        }
    }
    static std::size_t patchOf(const Vote& v) {
        return static_cast<std::size_t>(inside(texel(-v.y, kSide), kSide)) * kSide +
               static_cast<std::size_t>(inside(texel(v.x, kSide), kSide));
    }
    [[nodiscard]] std::size_t count() const { return members_.size(); }
    [[nodiscard]] const std::vector<std::uint32_t>& members(std::size_t patch) const { return members_[patch]; }

  private:
    std::vector<std::vector<std::uint32_t>> members_;
};

/// The value that a share of the values lies below.
float quantile(std::vector<float>& values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

/// Each vote's distance from its patch's median: where a first guess must come from, as a mean would follow outliers.
std::vector<float> distancesFromMedians(const std::vector<Vote>& votes, const Patches& patches) {
    std::vector<float> distances(votes.size(), 0);
    tbb::parallel_for(std::size_t{0}, patches.count(), [&](std::size_t p) {
        const auto& members = patches.members(p);
        if (members.empty()) {
            return;
        }
        cv::Vec3f median;
        std::vector<float> values(members.size());
        for (int c = 0; c < 3; ++c) {
            for (std::size_t i = 0; i < members.size(); ++i) {
                const Vote& v = votes[members[i]];
                values[i] = c == 0 ? v.r : (c == 1 ? v.g : v.b);
            }
            median[c] = quantile(values, 0.5);
        }
        for (const std::uint32_t i : members) {
            distances[i] = distance(votes[i], median);
        }
    });
    return distances;
}

/// Tukey's biweight by the distance that three quarters of a patch's votes lie within: what a few of them say against
/// the rest is an outlier, what more say is texture.
void trustBy(const std::vector<float>& distances, const Patches& patches, std::vector<float>& trust) {
    constexpr double kMost = 0.75;
    constexpr float kCut = 2.6F; // of that distance: three sigmas of a normal spread
    tbb::parallel_for(std::size_t{0}, patches.count(), [&](std::size_t p) {
        const auto& members = patches.members(p);
        if (members.empty()) {
            return;
        }
        std::vector<float> values(members.size());
        std::transform(members.begin(), members.end(), values.begin(), [&](std::uint32_t i) { return distances[i]; });
        const float cut = kCut * std::max(static_cast<float>(kLeastScale), quantile(values, kMost));
        for (const std::uint32_t i : members) {
            const float t = distances[i] / cut;
            trust[i] = t < 1 ? (1 - t * t) * (1 - t * t) : 0;
        }
    });
}

/// Votes needed at each texel: their spread there, squared, over the square of a good error; at least a plane's.
cv::Mat neededVotes(const std::vector<Vote>& votes, const std::vector<float>& distances,
                    const std::vector<float>& trust, int side) {
    constexpr double kMostNeeded = 400; // an error of 0.01 in a spread of 0.2: more blur would cost form
    std::vector<double> sum(static_cast<std::size_t>(Patches::kSide) * Patches::kSide, 0);
    std::vector<double> weight(sum.size(), 0);
    for (std::size_t i = 0; i < votes.size(); ++i) {
        const std::size_t p = Patches::patchOf(votes[i]);
        sum[p] += static_cast<double>(trust[i]) * distances[i] * distances[i];
        weight[p] += trust[i];
    }
    cv::Mat needed(Patches::kSide, Patches::kSide, CV_32F);
    for (std::size_t p = 0; p < sum.size(); ++p) {
        const double spread = weight[p] > 0 ? sum[p] / weight[p] / 3 : 0; // of one channel
        // Patches without votes say nothing.
        needed.ptr<float>()[p] = static_cast<float>(
            weight[p] > 0 ? std::clamp(spread / (kGoodError * kGoodError), 2 * kLeastVotes, kMostNeeded) : kMostNeeded);
    }
    // Grain is everywhere; where votes disagree in one place only, they show an edge, which must not be blurred.
    cv::Mat fine;
    cv::erode(needed, needed, cv::getStructuringElement(cv::MORPH_ELLIPSE, {7, 7}));
    cv::GaussianBlur(needed, needed, {3, 3}, 0.8);
    cv::resize(needed, fine, {side, side}, 0, 0, cv::INTER_LINEAR);
    return fine;
}

/// Levels until a kernel reaches as far as noise may ask for.
std::vector<Level> levelsOf(Moments moments, Task& task) {
    constexpr double kWidest = 0.06; // of the disk's width: beyond, form is lost
    std::vector<Level> levels;
    const int finest = moments[0].rows;
    for (double reach = 2 * kKernel;; reach *= 2) {
        task.throwIfCancelled();
        levels.push_back(levelOf(moments));
        levels.back().near = levels.size() == 1 || reach <= kReach * finest;
        if (2 * reach > kWidest * finest || moments[0].rows < 16) {
            return levels;
        }
        moments = halved(moments);
    }
}

std::vector<float> distancesFrom(const std::vector<Vote>& votes, const Composed& composed, int half) {
    std::vector<float> distances(votes.size(), 0);
    tbb::parallel_for(std::size_t{0}, (votes.size() + 4095) / 4096, [&](std::size_t chunk) {
        for (std::size_t i = chunk * 4096; i < std::min(votes.size(), (chunk + 1) * 4096); ++i) {
            if (half >= 0 && votes[i].half != half) {
                continue;
            }
            const cv::Vec3f colour = sample(composed, votes[i].x, votes[i].y);
            distances[i] = colour[0] < 0 ? -1 : distance(votes[i], colour);
        }
    });
    return distances;
}

/// RMS over the channels of all votes, each by the other half's sphere; outliers too, or it would flatter.
double heldOutRmse(const std::vector<Vote>& votes, const std::vector<float>& trust, const cv::Mat& needed, Task& task) {
    double sum = 0;
    double weight = 0;
    for (int half = 0; half < 2; ++half) {
        const Composed other = compose(levelsOf(momentsOf(votes, trust, needed.rows, 1 - half), task), needed);
        const std::vector<float> distances = distancesFrom(votes, other, half);
        for (std::size_t i = 0; i < votes.size(); ++i) {
            if (votes[i].half == half && distances[i] >= 0) {
                sum += static_cast<double>(votes[i].weight) * distances[i] * distances[i] / 3;
                weight += votes[i].weight;
            }
        }
    }
    return weight > 0 ? std::sqrt(sum / weight) : 0;
}

} // namespace

int gatheredSide(std::size_t votes) {
    // Two thirds of a vote a texel: a kernel then holds five of them, and edges stay as sharp as the scan.
    const double side = std::sqrt(static_cast<double>(votes) / (0.65 * 0.7854));
    int power = 32;
    while (power * 2 <= side && power < 512) {
        power *= 2;
    }
    return power;
}

Gathered gatherVotes(std::vector<Vote> votes, HeldOut heldOut, Task& task) {
    const int side = gatheredSide(votes.size());
    const Patches patches(votes);
    std::vector<float> trust(votes.size(), 1);
    std::vector<float> distances = distancesFromMedians(votes, patches);
    cv::Mat needed;
    Composed composed;
    for (int round = 0; round < kRounds; ++round) {
        trustBy(distances, patches, trust);
        needed = neededVotes(votes, distances, trust, side);
        composed = compose(levelsOf(momentsOf(votes, trust, side, -1), task), needed);
        distances = distancesFrom(votes, composed, -1);
        for (float& d : distances) {
            d = std::max(d, 0.0F);
        }
    }
    Gathered gathered;
    if (heldOut == HeldOut::measured) {
        gathered.heldOutRmse = heldOutRmse(votes, trust, needed, task);
    }
    gathered.picture = {side, side, std::vector<Rgba>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side))};
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const cv::Vec3f c = composed.colour.at<cv::Vec3f>(y, x);
            gathered.picture.at(x, y) = {c[0], c[1], c[2], composed.covered.at<float>(y, x)};
        }
    }
    return gathered;
}

} // namespace limner
