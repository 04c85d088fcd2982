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

std::string textTable(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], row[i].size());
        }
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            line += row[i];
            if (i + 1 < row.size()) {
                line.append(widths[i] - row[i].size() + 2, ' ');
            }
        }
        text += line + "\n";
    }
    return text;
}

std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

} // namespace limner::cli
