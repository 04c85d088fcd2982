#include "app/cli/visibility_table.h"

#include "renderer/plan/planner.h"
#include "renderer/visibility.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace limner::cli {

namespace {

constexpr int kLongerSide = 64;                  ///< pixels: shares to a percent or so
constexpr double kFactors[] = {0, 0.5, 1, 2, 4}; ///< of the figure's global weight

glm::ivec2 smallSize(const Figure& figure) {
    const glm::dvec2 size(figure.output.sizePixels());
    const double scale = kLongerSide / std::max(size.x, size.y);
    return {std::max(1, static_cast<int>(std::lround(size.x * scale))),
            std::max(1, static_cast<int>(std::lround(size.y * scale)))};
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// Adds to the last column of a table.
void add(VisibilityTable& table, const std::string& kind, const std::string& name, double share) {
    auto found = std::find_if(table.rows.begin(), table.rows.end(),
                              [&](const auto& row) { return row.kind == kind && row.name == name; });
    if (found == table.rows.end()) {
        found = table.rows.insert(table.rows.end(), {kind, name, {}});
    }
    found->shares.resize(table.globalWeights.size() - 1, 0.0); // not seen at the weights before
    found->shares.push_back(share);
}

std::string labelName(const Figure& figure, int label) {
    const std::string number = std::to_string(label);
    const auto named = figure.labels->names.find(number);
    return label == 0 ? "no label" : named == figure.labels->names.end() ? number : number + " " + named->second;
}

} // namespace

VisibilityTable visibilityTable(const Figure& figure, Task& task) {
    Planner planner;
    PlanRequest request;
    request.size = smallSize(figure);
    VisibilityTable table;
    table.pixels = request.size;
    for (const double factor : kFactors) {
        if (!figure.importance && factor != 1) {
            continue;
        }
        Figure changed = figure;
        if (changed.importance) {
            changed.importance->global *= factor;
        }
        const VisibilityShares shares = measureVisibility(*planner.plan(changed, request, task), task);
        table.globalWeights.push_back(changed.importance ? changed.importance->global : 0);
        for (const auto& [name, share] : shares.layers) {
            add(table, "layer", name, share);
        }
        for (const auto& [label, share] : shares.labels) {
            add(table, "label", labelName(figure, label), share);
        }
        for (const VisibilityShares::Range& range : shares.ranges) {
            add(table, "values", number(range.low) + " to " + number(range.high), range.share);
        }
        add(table, "paper", "paper", shares.paper);
    }
    for (VisibilityTable::Row& row : table.rows) {
        row.shares.resize(table.globalWeights.size(), 0.0);
    }
    return table;
}

std::string visibilityText(const VisibilityTable& table) {
    std::string text = "Share of the picture by importance, at global weights of\n";
    char cell[64];
    text += std::string(34, ' ');
    for (const double weight : table.globalWeights) {
        std::snprintf(cell, sizeof cell, "%9s", number(weight).c_str());
        text += cell;
    }
    text += '\n';
    for (const VisibilityTable::Row& row : table.rows) {
        const std::string name = row.kind == "paper" ? row.name : row.kind + " " + row.name;
        std::snprintf(cell, sizeof cell, "  %-32.32s", name.c_str());
        text += cell;
        for (const double share : row.shares) {
            std::snprintf(cell, sizeof cell, "%7.1f %%", 100 * share);
            text += cell;
        }
        text += '\n';
    }
    return text;
}

} // namespace limner::cli
