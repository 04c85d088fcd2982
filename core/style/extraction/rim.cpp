#include "core/style/extraction/rim.h"

#include <opencv2/core.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace limner {
namespace {

constexpr double kTurn = 6.28318530717958647692;
/// A step below that is no edge, however calm its surroundings: a few steps of 8 bits.
constexpr float kFaintest = 0.012F;
/// An edge stands out from what else the rays cross by this factor.
constexpr float kStandsOut = 2.2F;
/// Less of the oval than that does not say where the rest is.
constexpr double kLeastSupport = 0.35;

/// Samples of the tones along one ray, and the steps between both sides of each of its places.
struct Ray {
    glm::dvec2 onCircle{0, 0};
    glm::dvec2 foot{0, 0};
    glm::dvec2 normal{0, 0};
    std::vector<float> steps;
    int found = 0;     ///< which of them is on the ring
    double offset = 0; ///< of the edge from the foot, pixels
    float strength = 0;
    double clear = 1;  ///< 0: the tones beside the edge change as much as across it, so that it seems displaced
    bool seen = false; ///< within the picture
};

/// How finely a round looks, in pixels.
struct Grain {
    double step = 1; ///< between places on a ray
    int window = 2;  ///< places to either side whose means are compared
    int reach = 10;  ///< places looked at inward and outward
};

Grain grainOf(double radius, double reach) {
    Grain grain;
    const double length = std::max(2.0, reach * radius);
    grain.step = std::clamp(length / 24, 0.5, 4.0);
    grain.reach = static_cast<int>(std::ceil(length / grain.step));
    // Wide windows calm noise; narrow ones are not drawn inward by a shading that changes fast at the rim.
    grain.window =
        std::max(2, static_cast<int>(std::lround(std::clamp(length / 8, 1.5, 0.04 * radius + 1.5) / grain.step)));
    return grain;
}

void castRay(const Tones& tones, const Grain& grain, Ray& ray) {
    const int reach = grain.reach + grain.window;
    std::vector<glm::vec4> sums(static_cast<std::size_t>(2 * reach + 1), glm::vec4(0));
    ray.seen = tones.holds(ray.foot);
    for (int i = -reach; i < reach; ++i) {
        const glm::dvec2 place = ray.foot + ray.normal * ((i + 0.5) * grain.step);
        const auto at = static_cast<std::size_t>(i + reach);
        sums[at + 1] = sums[at] + tones.between(place);
    }
    ray.steps.assign(static_cast<std::size_t>(2 * grain.reach + 1), 0);
    const auto window = static_cast<std::size_t>(grain.window);
    for (std::size_t i = 0; i < ray.steps.size(); ++i) {
        const std::size_t here = i + window;
        const glm::vec4 inside = sums[here] - sums[here - window];
        const glm::vec4 outside = sums[here + window] - sums[here];
        const glm::dvec2 place = ray.foot + ray.normal * ((static_cast<double>(i) - grain.reach) * grain.step);
        // Beyond the picture there is nothing to see, least of all an edge.
        ray.steps[i] = tones.holds(place) ? glm::length(outside - inside) / static_cast<float>(grain.window) : 0;
    }
}

std::vector<Ray> castRays(const Tones& tones, const Oval& oval, const Grain& grain, int count) {
    std::vector<Ray> rays(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        Ray& ray = rays[static_cast<std::size_t>(i)];
        const double angle = kTurn * i / count;
        ray.onCircle = {std::cos(angle), std::sin(angle)};
        ray.foot = oval.at(ray.onCircle);
        ray.normal = oval.normal(ray.onCircle);
        castRay(tones, grain, ray);
    }
    return rays;
}

float medianOf(std::vector<float> values) {
    if (values.empty()) {
        return 0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// What a step must have to be an edge.
float thresholdOf(const std::vector<Ray>& rays) {
    std::vector<float> all;
    for (const Ray& ray : rays) {
        if (ray.seen) {
            all.insert(all.end(), ray.steps.begin(), ray.steps.end());
        }
    }
    return std::max(kFaintest, kStandsOut * medianOf(std::move(all)));
}

/// The closed ring over all rays that gathers most, not jumping from one to the next. Goes round twice, so that its
/// ends have met by the middle.
void findRing(std::vector<Ray>& rays, float threshold) {
    constexpr int kJump = 2;
    constexpr float kJumpCost = 0.15F;
    const int places = static_cast<int>(rays.front().steps.size());
    const std::size_t count = rays.size();
    std::vector<std::vector<std::int8_t>> from(2 * count, std::vector<std::int8_t>(static_cast<std::size_t>(places)));
    std::vector<float> best(static_cast<std::size_t>(places), 0);
    std::vector<float> next(best.size());
    for (std::size_t i = 0; i < 2 * count; ++i) {
        const Ray& ray = rays[i % count];
        for (int p = 0; p < places; ++p) {
            float most = -1e9F;
            for (int jump = -kJump; jump <= kJump; ++jump) {
                const int before = p + jump;
                if (before < 0 || before >= places) {
                    continue;
                }
                const float gain =
                    best[static_cast<std::size_t>(before)] - kJumpCost * static_cast<float>(std::abs(jump));
                if (gain > most) {
                    most = gain;
                    from[i][static_cast<std::size_t>(p)] = static_cast<std::int8_t>(jump);
                }
            }
            const float step = ray.steps[static_cast<std::size_t>(p)];
            next[static_cast<std::size_t>(p)] = most + step / (step + threshold);
        }
        std::swap(best, next);
    }
    int place = static_cast<int>(std::max_element(best.begin(), best.end()) - best.begin());
    for (std::size_t i = 2 * count; i-- > 0;) {
        if (i < count + count / 2) {
            rays[i % count].found = place;
        }
        if (i == count / 2) {
            break;
        }
        place += from[i][static_cast<std::size_t>(place)];
    }
}

/// Between places, by the parabola through the step and its neighbours.
void refinePlaces(std::vector<Ray>& rays, const Grain& grain) {
    for (Ray& ray : rays) {
        const auto& s = ray.steps;
        auto at = static_cast<std::size_t>(ray.found);
        // The ring is smooth; the edge itself is where the step is largest next to it.
        for (int i = 0; i < 2; ++i) {
            if (at + 1 < s.size() && s[at + 1] > s[at]) {
                ++at;
            } else if (at > 0 && s[at - 1] > s[at]) {
                --at;
            }
        }
        double shift = 0;
        if (at > 0 && at + 1 < s.size()) {
            const double bend = s[at - 1] - 2.0 * s[at] + s[at + 1];
            shift = bend < 0 ? std::clamp(0.5 * (s[at - 1] - s[at + 1]) / bend, -0.5, 0.5) : 0.0;
        }
        ray.strength = ray.seen ? s[at] : 0;
        const auto beside = static_cast<std::size_t>(grain.window);
        const float inner = at >= beside ? s[at - beside] : s.front();
        const float outer = at + beside < s.size() ? s[at + beside] : s.back();
        ray.clear = std::clamp(1 - std::max(inner, outer) / static_cast<double>(std::max(s[at], 1e-6F)), 0.0, 1.0);
        ray.offset = (static_cast<double>(at) + shift - grain.reach) * grain.step;
    }
}

/// Least squares for what moves the oval onto the places found; weights fall to nothing at `scale` pixels off.
class Fit {
  public:
    Fit(const std::vector<Ray>& rays, bool circle) : rays_(rays), circle_(circle) {}

    /// The centre's way and the change of the three numbers of the matrix.
    std::array<double, 5> solve(const std::vector<double>& weights) const {
        cv::Matx<double, 5, 5> a = cv::Matx<double, 5, 5>::zeros();
        cv::Matx<double, 5, 1> b = cv::Matx<double, 5, 1>::zeros();
        double total = 0;
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            const auto slope = slopes(rays_[i]);
            for (int r = 0; r < 5; ++r) {
                for (int c = 0; c < 5; ++c) {
                    a(r, c) += weights[i] * slope[static_cast<std::size_t>(r)] * slope[static_cast<std::size_t>(c)];
                }
                b(r, 0) += weights[i] * slope[static_cast<std::size_t>(r)] * rays_[i].offset;
            }
            total += weights[i];
        }
        for (int r = 0; r < 5; ++r) {
            a(r, r) += 1e-3 * total + 1e-12; // where no edge says anything, the rough oval does
        }
        cv::Matx<double, 5, 1> x;
        std::array<double, 5> change{};
        if (cv::solve(a, b, x, cv::DECOMP_CHOLESKY)) {
            std::copy(x.val, x.val + 5, change.begin());
        }
        return change;
    }

    double residual(std::size_t i, const std::array<double, 5>& change) const {
        const auto slope = slopes(rays_[i]);
        double moved = 0;
        for (std::size_t k = 0; k < 5; ++k) {
            moved += slope[k] * change[k];
        }
        return rays_[i].offset - moved;
    }

  private:
    /// How far each change moves the oval along the ray.
    [[nodiscard]] std::array<double, 5> slopes(const Ray& ray) const {
        const glm::dvec2 n = ray.normal;
        const glm::dvec2 u = ray.onCircle;
        if (circle_) {
            return {n.x, n.y, n.x * u.x + n.y * u.y, 0, 0};
        }
        return {n.x, n.y, n.x * u.x, n.x * u.y + n.y * u.x, n.y * u.y};
    }

    const std::vector<Ray>& rays_;
    bool circle_;
};

Oval moved(const Oval& oval, const std::array<double, 5>& change, bool circle) {
    Oval to = oval;
    to.centre += glm::dvec2(change[0], change[1]);
    to.xx += change[2];
    to.xy += circle ? 0 : change[3];
    to.yy += circle ? change[2] : change[4];
    return to;
}

double tukey(double residual, double scale) {
    const double t = residual / scale;
    return std::abs(t) < 1 ? (1 - t * t) * (1 - t * t) : 0;
}

/// One round: the rim as the rays from `oval` see it. `threshold`: of an edge; 0: to be found here.
Rim lookAround(const Tones& tones, const Oval& oval, double reach, const RimSearch& search, float& threshold) {
    const Grain grain = grainOf(oval.radius(), reach);
    std::vector<Ray> rays = castRays(tones, oval, grain, search.rays);
    if (threshold <= 0) {
        threshold = thresholdOf(rays);
    }
    findRing(rays, threshold);
    refinePlaces(rays, grain);
    const Fit fit(rays, search.circle);
    const double radius = oval.radius();
    std::vector<double> plain(rays.size());
    std::transform(rays.begin(), rays.end(), plain.begin(), [&](const Ray& ray) {
        const double square = static_cast<double>(ray.strength) * ray.strength;
        return square / (square + static_cast<double>(threshold) * threshold) * (0.05 + ray.clear * ray.clear);
    });
    std::vector<double> weights = plain;
    std::array<double, 5> change{};
    for (int i = 0; i < 6; ++i) {
        change = fit.solve(weights);
        std::vector<float> off;
        for (std::size_t k = 0; k < rays.size(); ++k) {
            off.push_back(static_cast<float>(std::abs(fit.residual(k, change))));
        }
        const double scale = std::max(4.685 * 1.48 * medianOf(off), std::max(1.0, 0.01 * radius));
        for (std::size_t k = 0; k < rays.size(); ++k) {
            weights[k] = plain[k] * tukey(fit.residual(k, change), scale);
        }
    }
    Rim rim;
    rim.oval = moved(oval, change, search.circle);
    const double close = std::max(1.5, 0.03 * radius);
    std::vector<float> strengths;
    double squares = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const double residual = fit.residual(k, change);
        if (rays[k].strength >= threshold && std::abs(residual) < close) {
            strengths.push_back(rays[k].strength);
            squares += residual * residual;
        }
    }
    rim.support = static_cast<double>(strengths.size()) / static_cast<double>(rays.size());
    rim.wobble = strengths.empty() ? 1 : std::sqrt(squares / static_cast<double>(strengths.size())) / radius;
    rim.contrast = medianOf(std::move(strengths));
    return rim;
}

bool sound(const Oval& oval, const Oval& rough) {
    const glm::dvec2 axes = oval.semiAxes();
    const double radius = rough.radius();
    const double way = std::hypot(oval.centre.x - rough.centre.x, oval.centre.y - rough.centre.y);
    constexpr double kFarthest = 0.45; // reach, and what a centre may move with a size that changes
    return axes.y > 1 && axes.y > 0.2 * axes.x && way < kFarthest * radius &&
           std::abs(std::log(oval.radius() / radius)) < kFarthest;
}

} // namespace

std::optional<Rim> followRim(const Tones& tones, const Oval& rough, const RimSearch& search) {
    constexpr double kLeastRadius = 3;
    if (tones.pixels.empty() || !std::isfinite(rough.centre.x + rough.centre.y + rough.xx + rough.xy + rough.yy) ||
        rough.semiAxes().y < kLeastRadius || rough.semiAxes().x > 2.0 * std::max(tones.width, tones.height)) {
        return std::nullopt;
    }
    Rim rim{rough};
    float threshold = 0; // of the first round: later ones see little but the edge itself
    for (const double reach : search.reaches) {
        rim = lookAround(tones, rim.oval, reach, search, threshold);
        if (!sound(rim.oval, rough)) {
            return std::nullopt;
        }
    }
    return rim.support >= kLeastSupport ? std::optional<Rim>(rim) : std::nullopt;
}

} // namespace limner
