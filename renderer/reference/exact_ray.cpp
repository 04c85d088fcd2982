#include "renderer/reference/exact_ray.h"

#include "core/base/error.h"
#include "core/optics/opacity.h"
#include "renderer/reference/field.h"
#include "renderer/reference/gauss.h"
#include "renderer/reference/layer_optics.h"
#include "renderer/reference/ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace limner::reference {

namespace {

/// A piece may move by no more than this between two subdivisions (spec accuracy.md 1.4).
constexpr double kTolerance = 1e-12;
constexpr int kMostParts = 4096; ///< where doubling stops; only a logarithmic pole (opacity -> 1) gets that far
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The cubic of the field over one cell's stretch of the ray, in u = 0..1 along it.
class CellCubic {
  public:
    /// Values at u = 0, 1/3, 2/3, 1.
    explicit CellCubic(const std::array<double, 4>& v)
        : a_(v[0]), b_((-11 * v[0] + 18 * v[1] - 9 * v[2] + 2 * v[3]) / 2),
          c_((18 * v[0] - 45 * v[1] + 36 * v[2] - 9 * v[3]) / 2),
          d_((-9 * v[0] + 27 * v[1] - 27 * v[2] + 9 * v[3]) / 2) {}

    [[nodiscard]] double at(double u) const { return a_ + u * (b_ + u * (c_ + u * d_)); }

    /// 0, the turning points inside (0, 1), 1: monotone in between.
    [[nodiscard]] std::vector<double> monotoneCuts() const {
        std::vector<double> cuts{0};
        const double p = c_ / 3;
        const double discriminant = p * p - d_ * b_ / 3;
        if (discriminant > 0) {
            const double q = -(p + std::copysign(std::sqrt(discriminant), p)); // both roots without cancellation
            for (const double u : {q != 0 ? b_ / (3 * q) : 0.0, d_ != 0 ? q / d_ : 0.0}) {
                if (u > 0 && u < 1) {
                    cuts.push_back(u);
                }
            }
        }
        cuts.push_back(1);
        std::sort(cuts.begin(), cuts.end());
        return cuts;
    }

    /// Where a monotone stretch takes a value between those at its ends.
    [[nodiscard]] double rootBetween(double u0, double u1, double value) const {
        const bool rising = at(u1) > at(u0);
        for (int halving = 0; halving < 60; ++halving) { // to the last bit of a double
            const double middle = (u0 + u1) / 2;
            ((at(middle) < value) == rising ? u0 : u1) = middle;
        }
        return (u0 + u1) / 2;
    }

  private:
    double a_, b_, c_, d_;
};

/// All that an unshaded layer reads.
SampleFacts factsOf(double value) {
    SampleFacts facts;
    facts.value = value;
    return facts;
}

/// Extinction and emission of all layers at a data value.
struct Medium {
    double extinction = 0; ///< per mm
    glm::dvec3 emission{0};
};

class Integrator {
  public:
    explicit Integrator(const RenderPlan& plan) : plan_(plan) {
        for (const PlanLayer& layer : plan.layers) {
            if (readsNormal(layer) || !opacityByValue(layer) || plan.interpolation != Interpolation::linear) {
                throw Error(ErrorKind::usage,
                            {"no exact integral", layer.name, "it is not one colour and opacity for each value",
                             "use steps of decreasing size"});
            }
            for (const glm::dvec2& point : layer.source->transfer.opacity) {
                knots_.push_back(point.x);
            }
            for (const TransferNode& node : layer.source->transfer.nodes) {
                knots_.push_back(node.at);
            }
        }
        std::sort(knots_.begin(), knots_.end());
        knots_.erase(std::unique(knots_.begin(), knots_.end()), knots_.end());
    }

    ExactRay run(const Ray& ray) {
        const std::vector<double> faces = cellFaces(ray);
        for (std::size_t i = 1; i < faces.size() && transmittance_ > 0; ++i) {
            cell(ray, {faces[i - 1], faces[i]});
        }
        result_.rgba.a = 1 - transmittance_;
        return result_;
    }

  private:
    struct PieceSum {
        glm::dvec3 rgb{0};
        double depth = 0;
    };

    static std::vector<double> cellFaces(const Ray& ray);
    void cell(const Ray& ray, const Stretch& stretch);
    void piece(const CellCubic& field, double u0, double u1, double lengthMm);
    [[nodiscard]] Medium mediumAt(double value) const;
    [[nodiscard]] glm::dvec3 surfaceColour(double value) const;
    [[nodiscard]] PieceSum integrate(const CellCubic& field, double u0, double u1, double cellMm, int parts) const;

    const RenderPlan& plan_;
    std::vector<double> knots_;
    ExactRay result_;
    double transmittance_ = 1;
};

std::vector<double> Integrator::cellFaces(const Ray& ray) {
    std::vector<double> faces{ray.visible.inMm, ray.visible.outMm};
    for (int axis = 0; axis < 3; ++axis) {
        const double from = ray.positionVoxel(ray.visible.inMm)[axis];
        const double to = ray.positionVoxel(ray.visible.outMm)[axis];
        for (double face = std::ceil(std::min(from, to)); face <= std::max(from, to); ++face) {
            const double mm = (face - ray.originVoxel[axis]) / ray.directionVoxel[axis];
            if (mm > ray.visible.inMm && mm < ray.visible.outMm) { // NaN and infinity of parallel rays fail here
                faces.push_back(mm);
            }
        }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

void Integrator::cell(const Ray& ray, const Stretch& stretch) {
    // Shorter than this, two faces of different axes meet in one point: no matter in between.
    if (!(stretch.lengthMm() > 1e-13 * std::abs(stretch.outMm))) {
        return;
    }
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < 4; ++i) {
        const double mm = stretch.inMm + stretch.lengthMm() * static_cast<double>(i) / 3;
        values[i] = valueAt(plan_, ray.positionVoxel(mm));
    }
    const CellCubic field(values);
    const std::vector<double> monotone = field.monotoneCuts();
    std::vector<double> cuts = monotone;
    for (std::size_t i = 1; i < monotone.size(); ++i) {
        const double start = field.at(monotone[i - 1]);
        const double end = field.at(monotone[i]);
        const double low = std::min(start, end);
        const double high = std::max(start, end);
        for (auto knot = std::upper_bound(knots_.begin(), knots_.end(), low); knot != knots_.end() && *knot < high;
             ++knot) {
            cuts.push_back(field.rootBetween(monotone[i - 1], monotone[i], *knot));
        }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size() && transmittance_ > 0; ++i) {
        if (cuts[i] > cuts[i - 1]) {
            piece(field, cuts[i - 1], cuts[i], stretch.lengthMm());
        }
    }
}

Medium Integrator::mediumAt(double value) const {
    Medium medium;
    for (const PlanLayer& layer : plan_.layers) {
        const double opacity = opacityOf(layer, value);
        if (opacity > 0) {
            const LayerSample sample = shadeLayer(plan_, layer, factsOf(value));
            const double extinction = optics::opticalDepth(sample.opacity) / plan_.referenceLengthMm;
            medium.extinction += extinction;
            medium.emission += extinction * glm::dvec3(sample.colour.r, sample.colour.g, sample.colour.b);
        }
    }
    return medium;
}

/// Colour of the first layer, in drawing order, that is a true surface at this value.
glm::dvec3 Integrator::surfaceColour(double value) const {
    for (const PlanLayer& layer : plan_.layers) {
        if (opacityOf(layer, value) >= 1) {
            const LayerSample sample = shadeLayer(plan_, layer, factsOf(value));
            return {sample.colour.r, sample.colour.g, sample.colour.b};
        }
    }
    return glm::dvec3(0);
}

Integrator::PieceSum Integrator::integrate(const CellCubic& field, double u0, double u1, double cellMm,
                                           int parts) const {
    PieceSum sum;
    const GaussRule& rule = gaussRule();
    const double width = (u1 - u0) / parts;
    for (int part = 0; part < parts; ++part) {
        const double start = u0 + width * part;
        double partDepth = 0;
        for (std::size_t i = 0; i < rule.point.size(); ++i) {
            const double u = start + width * rule.point[i];
            double depth = 0; // from the part's start to u
            for (std::size_t j = 0; j < rule.point.size(); ++j) {
                depth += rule.weight[j] * mediumAt(field.at(start + (u - start) * rule.point[j])).extinction;
            }
            depth *= (u - start) * cellMm;
            const Medium medium = mediumAt(field.at(u));
            const double share = rule.weight[i] * width * cellMm;
            sum.rgb += share * std::exp(-(sum.depth + depth)) * medium.emission;
            partDepth += share * medium.extinction;
        }
        sum.depth += partDepth;
    }
    return sum;
}

void Integrator::piece(const CellCubic& field, double u0, double u1, double cellMm) {
    const double middle = field.at((u0 + u1) / 2);
    const Medium medium = mediumAt(middle);
    if (!(medium.extinction > 0)) {
        return; // linear between knots: zero in the middle is zero throughout
    }
    if (medium.extinction == kInfinity) {                // likewise: a true surface
        const double justInside = u0 + (u1 - u0) * 1e-9; // on this side of a colour step at the piece's start
        result_.rgba += glm::dvec4(transmittance_ * surfaceColour(field.at(justInside)), 0);
        transmittance_ = 0;
        return;
    }
    PieceSum last = integrate(field, u0, u1, cellMm, 1);
    double change = kInfinity;
    for (int parts = 2; parts <= kMostParts && change > kTolerance; parts *= 2) {
        const PieceSum finer = integrate(field, u0, u1, cellMm, parts);
        change = std::abs(std::exp(-finer.depth) - std::exp(-last.depth));
        for (int channel = 0; channel < 3; ++channel) {
            change = std::max(change, std::abs(finer.rgb[channel] - last.rgb[channel]));
        }
        last = finer;
    }
    result_.converged = result_.converged && change <= kTolerance;
    result_.errorBar += transmittance_ * change;
    result_.rgba += glm::dvec4(transmittance_ * last.rgb, 0);
    transmittance_ *= std::exp(-last.depth);
}

} // namespace

ExactRay integrateExactly(const RenderPlan& plan, const glm::dvec2& positionPixel) {
    const auto ray = rayThrough(plan, positionPixel);
    Integrator integrator(plan);
    return ray ? integrator.run(*ray) : ExactRay{};
}

} // namespace limner::reference
