#include "renderer/accuracy/formula_vectors.h"

#include <array>
#include <cmath>
#include <limits>

namespace limner {

namespace {

using enum Formula;

constexpr double kNotPrinted = std::numeric_limits<double>::quiet_NaN();

/// Half a unit of the last printed digit.
constexpr double digits(int count) { return count == 0 ? 0.5 : digits(count - 1) / 10; }

void addContours(std::vector<FormulaVector>& all) {
    const std::string source = "numerics.md 2a";
    // Thickness times curvature; the literal form ends at 1, falls back to 0 at 2, and is no number beyond.
    for (const auto& [x, width, rounding] : std::initializer_list<std::array<double, 3>>{
             {0, 0, 0},
             {1e-6, 0.00141421321, digits(11)},
             {0.02, 0.198997487, digits(9)},
             {0.5, 0.866025404, digits(9)},
             {1, 1, 0},
             {1.5, 1, 0},
             {2, 1, 0},
             {2.5, 1, 0},
             {-0.1, 0, 0},
         }) {
        all.push_back({contourWidth, {x}, {width}, source, rounding});
    }
    // Radius, |n.v|, width.
    all.push_back({contourPush, {0.6, 0.8, 0.9}, {0.675}, source});
    all.push_back({contourPush, {0.9682458, 0.25, 0.5}, {1}, source});
    all.push_back({contourPush, {0.3, 0.95, 0.5}, {0.3}, source});
    all.push_back({contourPush, {0.2, 0.3, 0.6}, {0.4}, source});
    all.push_back({contourPush, {1, 0, 0}, {1}, source});
    all.push_back({contourPush, {0, 1, 0}, {0}, source});
}

void addTransparency(std::vector<FormulaVector>& all) {
    const std::string source = "numerics.md 2b";
    // Directional opacity, opacity, |n.v|, width, gradient.
    all.push_back({transparency, {0.8, 0.25, 0.9, 0.4, 0.2}, {0.229739671}, source, digits(9)});
    all.push_back({transparency, {0.8, 0, 0.9, 0.4, 0.2}, {0}, source});
    all.push_back({transparency, {0.8, 0, 0.9, 0.4, 1}, {0}, source});
    all.push_back({transparency, {0.8, 1, 0.9, 0.4, 0.2}, {0.8}, source});
    all.push_back({transparency, {0.8, 0.25, 0.9, 0.4, 1.5}, {0.4}, source});
    all.push_back({transparency, {0.5, 0.01, 1, 0, 0}, {0.0005}, source});
    all.push_back({transparency, {0.8, 0.25, 0.2, 0.4, 0}, {0.4}, source});
    // Opacity, length over the reference length.
    all.push_back({opacityPerLength, {1, 1e-6}, {1}, source});
    all.push_back({opacityPerLength, {1, 4}, {1}, source});
    all.push_back({opacityPerLength, {1, 0}, {0}, source});
    all.push_back({opacityPerLength, {1 - std::ldexp(1, -24), 0.1}, {0.810535}, source, digits(6)});
}

void addMeasures(std::vector<FormulaVector>& all) {
    const std::string source = "numerics.md 2d";
    all.push_back({extinctionImportance, {0}, {0}, source});
    all.push_back({extinctionImportance, {1e-9}, {1e-9}, source, digits(18)});
    all.push_back({extinctionImportance, {1}, {0.693147}, source, digits(6)});
    all.push_back({extinctionImportance, {1e3}, {6.908755}, source, digits(6)});
    all.push_back({extinctionImportance, {1e6}, {13.815511}, source, 2 * digits(6)}); // printed without rounding up
    // n.h, n.l, gradient.
    all.push_back({lightingImportance, {-1, -0.5, 1}, {3}, source});
    all.push_back({lightingImportance, {-0.9, -0.5, 0.5}, {2.999999999}, source, digits(9)});
    all.push_back({lightingImportance, {0.98, 0.9, 0.95}, {2.0453403199}, source, digits(10)});
    all.push_back({lightingImportance, {1, 1, 0}, {0}, source});
    all.push_back({lightingImportance, {0, 0, 1}, {3}, source});
}

void addStippling(std::vector<FormulaVector>& all) {
    const std::string source = "numerics.md 2e";
    all.push_back({stippleBoundary, {0.5, 0.25, 0.2, 1, 0.5}, {0.35}, source});
    all.push_back({stippleBoundary, {0.8, 0.5, 0.39, 0.51, 1}, {0.516}, source});
    all.push_back({stippleSilhouette, {0.5, 0.6, 0.1, 0.9, 2}, {0.122}, source});
    all.push_back({stippleSilhouette, {0.8, 0.3, 0.279, 0.45, 1.11}, {0.465504}, source, digits(6)});
    // Nearest distance, distance, reference distance, exponent.
    all.push_back({stippleResolution, {1, 3, 1, 0.5}, {0.7071067812}, source, digits(10)});
    all.push_back({stippleResolution, {1, 0, 1, 0.5}, {1}, source});
    all.push_back({stippleResolution, {1, -1, 1, 0.5}, {1}, source});
    all.push_back({stippleResolution, {1, -2, 1, 0.5}, {1}, source});
    // Depth, half the depth, exponent.
    all.push_back({stippleDistance, {-0.25, 1, 0.5}, {0.25}, source});
    all.push_back({stippleDistance, {0.25, 1, 0.5}, {0.75}, source});
    all.push_back({stippleDistance, {-0.25, 1, 2}, {0.46875}, source});
    all.push_back({stippleDistance, {-1, 1, 1}, {0}, source});
    all.push_back({stippleDistance, {0.25, 1, -1}, {0.375}, source});
    all.push_back({stippleDistance, {0, 0, 1}, {1}, source});
    all.push_back({stippleInterior, {0.25, 0.5}, {0.5}, source});
    all.push_back({stippleLighting, {0.6, 2}, {0.64}, source});
    all.push_back({stippleLighting, {-0.5, 0.5}, {1}, source});
}

void addComposition(std::vector<FormulaVector>& all) {
    const std::string source = "numerics.md 2c";
    // Colour, opacity, importance of every sample -> colour, opacity, importance.
    all.push_back({importanceRay, {1, 0.5, 1, 0, 0.5, 2}, {0.3015410860, 0.75, kNotPrinted}, source, digits(10)});
    for (const double importance : {20.0, 1000.0}) { // without opacity nothing happens
        all.push_back({importanceRay, {1, 0.9, 0, 0, 0, importance}, {0.9, 0.9, 0}, source});
    }
    all.push_back({importanceRay, {1, 0.9, 100, 0, 0.5, 11}, {0.9, 0.95, 99.894639}, source, digits(6)});
    all.push_back(
        {importanceRay, {1, 0.99, 0, 0.25, 1e-7, 20}, {0.262495, kNotPrinted, kNotPrinted}, source, digits(6)});
    all.push_back({importanceRay, {1, 1, 0, 0.25, 0.5, 3}, {0.321139, 1, kNotPrinted}, source, digits(6)});
}

void addImportancePairs(std::vector<FormulaVector>& all) {
    /// A slab of opacity a0 before one of depth tau that is more important by D: what either colour weighs, and a.
    struct Pair {
        double a0, importance, depth;
        double front, back, opacity;
        int frontDigits, backDigits;
    };
    for (const Pair& p : std::initializer_list<Pair>{
             {0.99, 2, 0.5, 0.2828581768, 0.7110765167, 0.9939346934, 10, 10},
             {0.99, 20, 0.5, 5.206637157e-9, 0.9939346882, 0.9939346934, 18, 10},
             {0.99, 20, 1e-7, 0.0199933287, 0.9700066723, 0.9900000010, 10, 10},
             {0.99, 20, std::exp(-20.0), 0.4950000008, 0.4949999992, 0.9900000000, 10, 10},
             {1, std::log(1000.0), 1, 0.001581056569, 0.9984189434, 1, 12, 10},
             {0.5, 0.3, 2, 0.5, 0.4323323584, 0.9323323584, 10, 10},
             {0.99, 0, 1, 0.99, 0.006321205588, 0.9963212056, 10, 12},
         }) {
        const double back = -std::expm1(-p.depth);
        const auto add = [&](double c0, double cs, double weight, int count) {
            all.push_back({importanceRay,
                           {c0, p.a0, 0, cs, back, p.importance},
                           {weight, kNotPrinted, kNotPrinted},
                           "accuracy.md A5",
                           digits(count)});
        };
        add(1, 0, p.front, p.frontDigits);
        add(0, 1, p.back, p.backDigits);
        all.push_back({importanceRay,
                       {1, p.a0, 0, 1, back, p.importance},
                       {p.opacity, p.opacity, kNotPrinted},
                       "accuracy.md A5",
                       digits(10)});
    }
}

} // namespace

std::vector<FormulaVector> publishedFormulaValues() {
    std::vector<FormulaVector> all;
    addTransparency(all);
    addContours(all);
    addMeasures(all);
    addStippling(all);
    addComposition(all);
    addImportancePairs(all);
    return all;
}

} // namespace limner
