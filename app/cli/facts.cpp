#include "app/cli/facts.h"

#include "app/cli/console.h"

#include <algorithm>
#include <cstdio>

namespace limner::cli {

void printFactText(Console& console, const std::string& text) { console.print(text + "\n"); }

std::string factLine(const std::string& label, const std::string& text) {
    constexpr std::size_t kColumn = 16; // the longest label of any command
    std::string line = label.empty() ? "" : label + ":";
    line.resize(std::max(line.size() + 1, kColumn), ' ');
    return line + text + "\n";
}

std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

} // namespace limner::cli
