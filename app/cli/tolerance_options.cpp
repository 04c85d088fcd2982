#include "app/cli/tolerance_options.h"

#include "app/cli/facts.h"
#include "app/cli/words.h"
#include "core/base/error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace limner::cli {

namespace {

const accuracy::NamedTolerance* named(const std::string& word) {
    const auto& all = accuracy::namedTolerances();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& t) { return word == t.name; });
    return found == all.end() ? nullptr : &*found;
}

std::optional<double> numberOf(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return end != text.c_str() && *end == '\0' && std::isfinite(value) && value > 0 ? std::optional(value)
                                                                                    : std::nullopt;
}

} // namespace

void ToleranceOptions::declare(CLI::App& app, const std::string& what) {
    app.add_option("--tolerance", tolerance_,
                   what + ": draft, screen, print (CIEDE2000 3, 1.5 and 0.7 for 95 % of the pixels), reference (no "
                          "channel off by more than 1/510), or a number of the metric")
        ->option_text("NAME-or-NUMBER");
    app.add_option(
           "--metric", metric_,
           "What a tolerance's number bounds: ciede2000 (of 95 % of the pixels), max or rmse (of channels, full "
           "range 1) [ciede2000]")
        ->option_text("NAME");
}

void ToleranceOptions::check() const {
    if (!metric_.empty()) {
        checkKnown({"ciede2000", "max", "rmse"}, metric_, "--metric");
    }
    if (!tolerance_.empty() && named(tolerance_) == nullptr && !numberOf(tolerance_)) {
        throw Error(ErrorKind::usage,
                    {"wrong usage", "--tolerance", "\"" + tolerance_.substr(0, 60) + "\" is no tolerance",
                     "write draft, screen, print, reference or a number above 0"});
    }
}

ErrorMetric ToleranceOptions::metric(const Quality& figure) const {
    for (const ErrorMetric metric : {ErrorMetric::ciede2000, ErrorMetric::largest, ErrorMetric::rootMeanSquare}) {
        if (metric_ == accuracy::nameOf(metric)) {
            return metric;
        }
    }
    const auto* name = named(tolerance_);
    return name != nullptr                          ? name->tolerance.metric
           : tolerance_.empty() && figure.tolerance ? figure.toleranceMetric
                                                    : ErrorMetric::ciede2000;
}

std::optional<accuracy::Tolerance> ToleranceOptions::asked(const Quality& figure) const {
    check();
    if (const auto* name = named(tolerance_)) {
        return name->tolerance;
    }
    if (const auto number = numberOf(tolerance_)) {
        return accuracy::Tolerance{metric(figure), *number};
    }
    if (figure.tolerance) {
        return accuracy::Tolerance{figure.toleranceMetric, *figure.tolerance};
    }
    return std::nullopt;
}

std::string toleranceText(ErrorMetric metric, double value) {
    const char* name = metric == ErrorMetric::ciede2000 ? "CIEDE2000 "
                       : metric == ErrorMetric::largest ? "largest error "
                                                        : "root mean square error ";
    return name + numberText(value);
}

} // namespace limner::cli
