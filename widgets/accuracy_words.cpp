#include "widgets/accuracy_words.h"

#include "widgets/core_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace limner {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(AccuracyWords)
};

constexpr double kSame = 1e-6; // of a tolerance: it may have gone through a file

QString number(double value) { return QLocale().toString(value, 'g', 3); }

/// In the order of `namedTolerances`.
QString nameAt(std::size_t place) {
    const QString names[] = {Words::tr("Draft"), Words::tr("Screen"), Words::tr("Print"), Words::tr("Reference")};
    return place < std::size(names) ? names[place] : QString();
}

QString knobName(accuracy::Knob knob) {
    using accuracy::Knob;
    switch (knob) {
    case Knob::step: return Words::tr("the step along the rays");
    case Knob::preintegration: return Words::tr("pre-integration");
    case Knob::termination: return Words::tr("the early end of the rays");
    case Knob::tableEntries: return Words::tr("the size of the tables");
    case Knob::precision: return Words::tr("the precision of the voxels");
    case Knob::interpolation: return Words::tr("the interpolation");
    case Knob::gradient: return Words::tr("the gradient");
    case Knob::samplesPerPixel: break;
    }
    return Words::tr("the number of rays per pixel");
}

/// A level of a knob: a number, or one of the engine's words.
QString levelWords(const std::string& level) {
    bool isNumber = false;
    const double value = QString::fromStdString(level).toDouble(&isNumber);
    if (isNumber)
        return number(value);
    const std::pair<const char*, QString> words[] = {{"on", Words::tr("on")},
                                                     {"off", Words::tr("off")},
                                                     {"full", Words::tr("full")},
                                                     {"all it needs", Words::tr("all it needs")},
                                                     {"tricubic", Words::tr("tricubic")},
                                                     {"smooth", Words::tr("smooth")},
                                                     {"fourth-order", Words::tr("of fourth order")},
                                                     {"b-spline", Words::tr("of a B-spline")}};
    const auto found = std::ranges::find(words, level, [](const auto& pair) { return pair.first; });
    return found == std::end(words) ? QString::fromStdString(level) : found->second; // names like Sobel
}

QString interpolationWords(Interpolation interpolation) {
    switch (interpolation) {
    case Interpolation::tricubic: return Words::tr("tricubic");
    case Interpolation::smooth: return Words::tr("smooth");
    case Interpolation::linear: return Words::tr("linear");
    case Interpolation::automatic: break;
    }
    return {};
}

} // namespace

QString metricName(ErrorMetric metric) {
    switch (metric) {
    case ErrorMetric::largest: return Words::tr("Largest difference");
    case ErrorMetric::rootMeanSquare: return Words::tr("Root mean square");
    case ErrorMetric::ciede2000: break;
    }
    return Words::tr("Colour difference (CIEDE2000)");
}

QString errorWords(double error, ErrorMetric metric) {
    return metric == ErrorMetric::ciede2000 ? Words::tr("ΔE %1").arg(number(error)) : number(error);
}

QString secondsWords(double seconds) {
    constexpr double kMilli = 1e-3;
    return seconds < 0.1 ? Words::tr("%1 ms").arg(number(seconds / kMilli)) : Words::tr("%1 s").arg(number(seconds));
}

std::size_t placeOfTolerance(const accuracy::Tolerance& tolerance) {
    const auto& named = accuracy::namedTolerances();
    const auto found = std::ranges::find_if(named, [&](const accuracy::NamedTolerance& n) {
        return n.tolerance.metric == tolerance.metric &&
               std::abs(n.tolerance.value - tolerance.value) <= kSame * n.tolerance.value;
    });
    return static_cast<std::size_t>(found - named.begin());
}

QString toleranceName(const accuracy::Tolerance& tolerance) { return nameAt(placeOfTolerance(tolerance)); }

double deliveredError(const accuracy::ToleranceChoice& choice) {
    return choice.reached ? choice.heldOutError : std::max(choice.searchedError, choice.heldOutError) + choice.errorBar;
}

QString settingsWords(const Quality& quality) {
    QStringList words{Words::tr("step %1 voxel").arg(number(quality.stepVoxels))};
    if (quality.preintegration)
        words << Words::tr("pre-integrated");
    words << (quality.earlyTermination > 0 ? Words::tr("rays end at %1").arg(number(quality.earlyTermination))
                                           : Words::tr("rays go on to their end"));
    if (const QString way = interpolationWords(quality.interpolation); quality.interpolation != Interpolation::linear)
        words << way;
    if (quality.samplesPerPixel > 1)
        words << Words::tr("%1 rays per pixel").arg(quality.samplesPerPixel);
    words.removeAll(QString());
    return words.join(", ");
}

QString limitWords(const accuracy::Limiting& limits, ErrorMetric metric) {
    if (!limits.knob)
        return Words::tr("Nothing that can be set makes the error smaller.");
    return Words::tr("What limits the error is %1: at its best (%2), %3 would be left.")
        .arg(knobName(*limits.knob), levelWords(limits.best), errorWords(limits.rest, metric));
}

QString methodWords(const std::string& method) {
    return method == "pre-integration" ? Words::tr("Pre-integration") : Words::tr("Point samples");
}

QString savingsWords(const accuracy::Savings& savings) {
    if (savings.rules.empty())
        return Words::tr("Nothing is left out of this picture: it needs all that there is.");
    const auto saved = [](double ms, std::int64_t bytes) {
        QStringList parts{secondsWords(std::max(ms, 0.0) / 1000)};
        if (bytes > (1 << 20) / 20)
            parts << QLocale().formattedDataSize(bytes, 1);
        return parts.join(", ");
    };
    QStringList lines;
    for (const accuracy::Saving& saving : savings.rules)
        lines << Words::tr("%1: %2").arg(coreWord(ruleOf(saving.leftOut.rule).name), saved(saving.ms, saving.bytes));
    lines << Words::tr("All together: %1. The picture, %2 × %3 pixels, takes %4.")
                 .arg(saved(savings.keptMs - savings.ms,
                            static_cast<std::int64_t>(savings.keptBytes) - static_cast<std::int64_t>(savings.bytes)))
                 .arg(savings.pixels.x)
                 .arg(savings.pixels.y)
                 .arg(secondsWords(savings.ms / 1000));
    return lines.join("\n");
}

QString choiceWords(const std::string& name) {
    const auto& named = accuracy::namedTolerances();
    for (std::size_t i = 0; i < named.size(); ++i)
        if (name == std::string("for ") + named[i].name)
            return nameAt(i);
    return Words::tr("As asked");
}

} // namespace limner
