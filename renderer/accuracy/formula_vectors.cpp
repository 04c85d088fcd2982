#include "renderer/accuracy/formula_vectors.h"

#include "renderer/accuracy/formula_calls.h"
#include "renderer/cpu/formulas.h"
#include "renderer/cpu/kernel.h"
#include "renderer/gl/formulas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limner {

namespace {

constexpr double kDoubleBound = 1e-12; // relative
constexpr double kSingleBound = 2e-6;  // of the natural range

/// Where double may differ by more than the usual bound: by so much of the natural range besides.
struct IllConditioned {
    Formula formula;
    std::size_t result;
    double ofRange;
    const char* reason;
};

constexpr IllConditioned kIllConditioned[] = {
    {Formula::importanceRay, 2, 1e-12,
     "importance so far, Iref + ln e, cancels where little opacity has risen far: to 1e-12 of the greatest importance"},
};

/// Chooses the SIMD backend's instruction set as long as it lives.
class TargetChoice {
  public:
    explicit TargetChoice(const std::string& target) { restrictKernelTarget(target); }
    ~TargetChoice() { restrictKernelTarget(""); }
    TargetChoice(const TargetChoice&) = delete;
    TargetChoice& operator=(const TargetChoice&) = delete;
};

std::vector<double> inDouble(const FormulaVector& vector) {
    std::vector<double> out(kindOf(vector.formula).results);
    const auto argument = [&](std::size_t k) { return vector.in[k]; };
    optics::evaluateFormula(vector.formula, argument, vector.in.size(), out.data());
    return out;
}

/// Up to FormulaBlock::kWidth vectors of one formula, side by side.
std::vector<std::vector<double>> inLanes(const FormulaVector* first, std::size_t count) {
    const FormulaKind& kind = kindOf(first->formula);
    std::size_t arguments = 0;
    for (std::size_t i = 0; i < count; ++i) {
        arguments = std::max(arguments, first[i].in.size());
    }
    constexpr std::size_t width = FormulaBlock::kWidth;
    std::vector<float> in(arguments * width, 0); // shorter rays end with samples of opacity 0
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < first[i].in.size(); ++k) {
            in[k * width + i] = static_cast<float>(first[i].in[k]);
        }
    }
    std::vector<float> out(kind.results * width);
    evaluateBlock({kind.formula, arguments, in.data()}, out.data());
    std::vector<std::vector<double>> results(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < kind.results; ++k) {
            results[i].push_back(out[k * width + i]);
        }
    }
    return results;
}

/// All vectors, each formula's at once: to make a shader takes longer than to run it.
std::vector<std::vector<double>> inGlsl(const gl::ContextFactory& contexts, const std::vector<FormulaVector>& vectors) {
    std::vector<std::vector<double>> results(vectors.size());
    for (const FormulaKind& kind : kFormulas) {
        std::vector<std::size_t> own;
        std::size_t arguments = 0;
        for (std::size_t i = 0; i < vectors.size(); ++i) {
            if (vectors[i].formula == kind.formula) {
                own.push_back(i);
                arguments = std::max(arguments, vectors[i].in.size());
            }
        }
        if (own.empty()) {
            continue;
        }
        std::vector<float> in(arguments * own.size(), 0); // shorter rays end with samples of opacity 0
        for (std::size_t k = 0; k < own.size(); ++k) {
            std::transform(vectors[own[k]].in.begin(), vectors[own[k]].in.end(), &in[k * arguments],
                           [](double v) { return static_cast<float>(v); });
        }
        const std::vector<float> out = gl::evaluateFormula(contexts, kind.formula, arguments, in);
        for (std::size_t k = 0; k < own.size(); ++k) {
            results[own[k]].assign(&out[k * kind.results], &out[k * kind.results] + kind.results);
        }
    }
    return results;
}

const IllConditioned* illConditioned(Formula formula, std::size_t result) {
    const auto* const end = std::end(kIllConditioned);
    const auto* const found = std::find_if(std::begin(kIllConditioned), end, [&](const IllConditioned& entry) {
        return entry.formula == formula && entry.result == result;
    });
    return found == end ? nullptr : found;
}

/// How large a result can be for such arguments.
double naturalRange(const FormulaVector& vector, std::size_t result) {
    switch (vector.formula) {
    case Formula::curvature: return std::numbers::pi / vector.in[6];
    case Formula::lightingImportance: return 3;
    case Formula::extinctionImportance: return std::log1p(optics::kGreatestExtinction);
    case Formula::gaussianLens: return vector.in[0];
    case Formula::importanceRay: {
        double greatest = 1;
        for (std::size_t k = 2; result == 2 && k < vector.in.size(); k += 3) {
            greatest = std::max(greatest, vector.in[k]);
        }
        return greatest;
    }
    default: return 1;
    }
}

double allowedDifference(const FormulaVector& vector, std::size_t result, bool inDouble) {
    const double range = naturalRange(vector, result);
    if (!inDouble) {
        return vector.rounding + kSingleBound * range;
    }
    const IllConditioned* const special = illConditioned(vector.formula, result);
    return vector.rounding + kDoubleBound * std::abs(vector.out[result]) +
           (special != nullptr ? special->ofRange * range : 0);
}

std::string boundText(Formula formula, bool inDouble) {
    if (!inDouble) {
        return "2e-6 of the natural range";
    }
    for (std::size_t result = 0; result < kindOf(formula).results; ++result) {
        if (const IllConditioned* const special = illConditioned(formula, result)) {
            return std::string("1e-12 relative; ") + special->reason;
        }
    }
    return "1e-12 relative";
}

/// Gathers a report vector by vector.
class Judge {
  public:
    Judge(const FormulaKind& kind, bool inDouble) : inDouble_(inDouble) {
        report.formula = kind.name;
        report.bound = boundText(kind.formula, inDouble);
    }

    void take(const FormulaVector& vector, const std::vector<double>& actual) {
        ++report.count;
        for (std::size_t k = 0; k < actual.size(); ++k) {
            if (std::isfinite(vector.out[k])) {
                compare(vector, k, actual[k]);
            }
        }
    }

    FormulaReport report;

  private:
    void compare(const FormulaVector& vector, std::size_t result, double actual) {
        const double expected = vector.out[result];
        const double difference =
            std::isnan(actual) ? std::numeric_limits<double>::infinity() : std::abs(actual - expected);
        const double allowed = allowedDifference(vector, result, inDouble_);
        report.passed = report.passed && difference <= allowed;
        report.largestAbsolute = std::max(report.largestAbsolute, difference);
        if (expected != 0) {
            report.largestRelative = std::max(report.largestRelative, difference / std::abs(expected));
        }
        const double share = difference > 0 ? difference / allowed : 0; // infinite where nothing is allowed
        if (report.worst.empty() || share > nearest_) {
            nearest_ = share;
            report.worst = vector.source;
        }
    }

    bool inDouble_;
    double nearest_ = 0;
};

} // namespace

std::vector<FormulaEngine> formulaEngines(const std::string& backend) {
    std::vector<FormulaEngine> engines = {{"reference", "double"}};
    for (const std::string& target : kernelTargets()) {
        engines.push_back({"cpu", target});
    }
    for (const std::string& library : gl::openLibraries()) {
        engines.push_back({"gl", library});
    }
    if (!backend.empty()) {
        std::erase_if(engines, [&](const FormulaEngine& engine) { return engine.backend != backend; });
    }
    return engines;
}

std::vector<std::vector<double>> evaluateFormulas(const FormulaEngine& engine,
                                                  const std::vector<FormulaVector>& vectors) {
    std::vector<std::vector<double>> results;
    if (engine.backend == "reference") {
        for (const FormulaVector& vector : vectors) {
            results.push_back(inDouble(vector));
        }
        return results;
    }
    if (engine.backend == "gl") {
        return inGlsl(gl::contextFactory(engine.target), vectors);
    }
    const TargetChoice choice(engine.target);
    for (std::size_t first = 0; first < vectors.size(); first = results.size()) {
        std::size_t count = 1;
        while (count < FormulaBlock::kWidth && first + count < vectors.size() &&
               vectors[first + count].formula == vectors[first].formula) {
            ++count;
        }
        for (auto& result : inLanes(&vectors[first], count)) {
            results.push_back(std::move(result));
        }
    }
    return results;
}

std::vector<FormulaReport> checkFormulas(const std::vector<FormulaVector>& vectors, const FormulaEngine& engine) {
    const std::vector<std::vector<double>> results = evaluateFormulas(engine, vectors);
    const bool inDouble = engine.backend == "reference";
    std::vector<FormulaReport> reports;
    for (const FormulaKind& kind : kFormulas) {
        Judge judge(kind, inDouble);
        for (std::size_t i = 0; i < vectors.size(); ++i) {
            if (vectors[i].formula == kind.formula) {
                judge.take(vectors[i], results[i]);
            }
        }
        if (judge.report.count > 0) {
            reports.push_back(judge.report);
        }
    }
    return reports;
}

} // namespace limner
