#include "renderer/plan/slab_table.h"

#include "core/optics/preintegration.h"

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

using Integrals = optics::SlabIntegrals<double>;

/// Extinctions at both ends of an entry's interval. Towards opacity 1 the extinction rises without end, but its
/// integral stays that of -ln(1 - a): 1 more than at the lower end.
std::pair<double, double> intervalOf(double opacity, double next) {
    const double low = optics::extinctionOfOpacity(opacity);
    const double high = optics::extinctionOfOpacity(next);
    if ((opacity >= 1) != (next >= 1)) {
        const double mean = std::min(low, high) + 1;
        return {mean, mean};
    }
    return {low, high};
}

/// Splits sums into a multiple of a quantum, of which single precision holds all, and a rest.
class Splitter {
  public:
    explicit Splitter(double greatest) {
        int exponent = 0;
        std::frexp(greatest, &exponent);
        quantum_ = std::ldexp(1.0, exponent - 23);
    }
    void put(double sum, float* row) const {
        const double whole = std::round(sum / quantum_) * quantum_;
        row[0] = static_cast<float>(whole);
        row[1] = static_cast<float>(sum - whole);
    }

  private:
    double quantum_ = 1;
};

} // namespace

std::vector<float> slabTable(const std::vector<float>& opacity) {
    std::vector<Integrals> sums(opacity.size(), Integrals{0, 0, 0});
    std::vector<float> rows(opacity.size() * kSlabFloats);
    for (std::size_t k = 0; k < opacity.size(); ++k) {
        const auto [low, high] = intervalOf(opacity[k], opacity[std::min(k + 1, opacity.size() - 1)]);
        rows[k * kSlabFloats + static_cast<std::size_t>(SlabColumn::low)] = static_cast<float>(low);
        rows[k * kSlabFloats + static_cast<std::size_t>(SlabColumn::high)] = static_cast<float>(high);
        if (k + 1 < opacity.size()) {
            const Integrals own = optics::countedFrom(optics::integralsInside(low, high, 1.0), static_cast<double>(k));
            sums[k + 1] = {sums[k].depth + own.depth, sums[k].first + own.first, sums[k].second + own.second};
        }
    }
    const Splitter depth(sums.back().depth);
    const Splitter first(sums.back().first);
    const Splitter second(sums.back().second);
    for (std::size_t k = 0; k < sums.size(); ++k) {
        float* row = rows.data() + k * kSlabFloats;
        depth.put(sums[k].depth, row + static_cast<int>(SlabColumn::depth));
        first.put(sums[k].first, row + static_cast<int>(SlabColumn::first));
        second.put(sums[k].second, row + static_cast<int>(SlabColumn::second));
    }
    return rows;
}

std::string whyNoSlabs(const RenderPlan& plan) {
    if (!plan.figure->quality.preintegration) {
        return "the quality does not ask for it";
    }
    if (plan.importance) {
        return "importance weighs single samples";
    }
    if (plan.layers.empty()) {
        return "no layer shows";
    }
    if (!std::all_of(plan.layers.begin(), plan.layers.end(), opacityByValue)) {
        return "a layer's opacity depends on more than the value";
    }
    return "";
}

void planSlabs(RenderPlan& plan) {
    plan.preintegrated = whyNoSlabs(plan).empty();
    for (PlanLayer& layer : plan.layers) {
        if (plan.preintegrated) {
            layer.slabs = slabTable(layer.table.opacity);
        }
    }
}

} // namespace limner
