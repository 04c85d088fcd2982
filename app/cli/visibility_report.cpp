#include "app/cli/visibility_report.h"

#include "renderer/plan/planner.h"
#include "renderer/reference/visibility.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

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

/// The shares of all parts, a column for each weight.
class Shares {
  public:
    void beginColumn() { ++columns_; }
    void add(const std::string& kind, const std::string& name, double share) {
        auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const Row& row) { return row.kind == kind && row.name == name; });
        if (found == rows_.end()) {
            found = rows_.insert(rows_.end(), {kind, name, {}});
        }
        found->shares.resize(columns_ - 1, 0.0); // not seen at the weights before
        found->shares.push_back(share);
    }
    [[nodiscard]] Facts facts() const {
        Facts list = Facts::array();
        for (Row row : rows_) {
            row.shares.resize(columns_, 0.0);
            list.push_back({{"kind", row.kind}, {"name", row.name}, {"shares", row.shares}});
        }
        return list;
    }

  private:
    struct Row {
        std::string kind;
        std::string name;
        std::vector<double> shares;
    };
    std::vector<Row> rows_;
    std::size_t columns_ = 0;
};

std::string labelName(const Figure& figure, int label) {
    const std::string number = std::to_string(label);
    const auto named = figure.labels->names.find(number);
    return label == 0 ? "no label" : named == figure.labels->names.end() ? number : number + " " + named->second;
}

} // namespace

Facts visibilityFacts(const Figure& figure, Task& task) {
    Planner planner;
    PlanRequest request;
    request.size = smallSize(figure);
    Shares parts;
    Facts weights = Facts::array();
    for (const double factor : kFactors) {
        if (!figure.importance && factor != 1) {
            continue;
        }
        Figure changed = figure;
        if (changed.importance) {
            changed.importance->global *= factor;
        }
        const VisibilityShares shares = measureVisibility(*planner.plan(changed, request, task), task);
        weights.push_back(changed.importance ? changed.importance->global : 0);
        parts.beginColumn();
        for (const auto& [name, share] : shares.layers) {
            parts.add("layer", name, share);
        }
        for (const auto& [label, share] : shares.labels) {
            parts.add("label", labelName(figure, label), share);
        }
        for (const VisibilityShares::Range& range : shares.ranges) {
            parts.add("values", number(range.low) + " to " + number(range.high), range.share);
        }
        parts.add("paper", "paper", shares.paper);
    }
    return {{"pixels", {request.size.x, request.size.y}}, {"global_weights", weights}, {"parts", parts.facts()}};
}

std::string visibilityText(const Facts& facts) {
    std::string text = "Share of the picture by importance, at global weights of\n";
    char cell[64];
    text += std::string(34, ' ');
    for (const auto& weight : facts["global_weights"]) {
        std::snprintf(cell, sizeof cell, "%9s", number(weight.get<double>()).c_str());
        text += cell;
    }
    text += '\n';
    for (const auto& part : facts["parts"]) {
        const std::string name = part["kind"].get<std::string>() + " " + part["name"].get<std::string>();
        std::snprintf(cell, sizeof cell, "  %-32.32s", part["kind"] == "paper" ? "paper" : name.c_str());
        text += cell;
        for (const auto& share : part["shares"]) {
            std::snprintf(cell, sizeof cell, "%7.1f %%", 100 * share.get<double>());
            text += cell;
        }
        text += '\n';
    }
    return text;
}

} // namespace limner::cli
