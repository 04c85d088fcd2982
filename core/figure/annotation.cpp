#include "core/figure/annotation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace limner {

double sizePtOf(const Annotation& annotation) {
    constexpr double kTitlePt = 14;
    constexpr double kOtherPt = 8; // what plates are lettered with
    return annotation.sizePt.value_or(annotation.kind == "title" ? kTitlePt : kOtherPt);
}

double roundBarMm(double millimetresPerSheet) {
    const double wished = std::max(millimetresPerSheet / 5, 1e-6);
    const double power = std::pow(10.0, std::floor(std::log10(wished)));
    const double digits = wished / power; // 1 to 10
    return power * (digits >= 5 ? 5 : (digits >= 2 ? 2 : 1));
}

std::string lengthText(double lengthMm) {
    const bool fine = lengthMm < 1;
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", fine ? lengthMm * 1000 : lengthMm);
    return text + std::string(fine ? "\u00A0µm" : "\u00A0mm"); // a number and its unit stay on one line
}

} // namespace limner
