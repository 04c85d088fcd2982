#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limner {

enum class ParameterType { boolean, integer, number, text, choice, vector, curve, list, object };

/// What changing a parameter costs, cheapest first; `diff` takes the dearest of all that changed.
enum class ChangeCost {
    none,      ///< titles, names, where the picture goes
    redraw,    ///< camera, lattice, background, annotations
    newTables, ///< transfer functions, styles
    newPlan,   ///< parts that come or go
    newFields, ///< clean-up, gradient choice, labels
    newVolume, ///< another scan
};

/// The one declaration of a setting. JSON, validation, `--set`, forms, tool tips and documentation read it.
/// Array elements in pointers are written `*`: "/layers/*/contours/thickness_mm".
struct Parameter {
    std::string pointer;
    ParameterType type = ParameterType::number;
    std::string unit;          ///< "mm", "deg", "HU or the volume's unit", "" where none
    std::optional<double> low; ///< smallest legal value (of each component)
    std::optional<double> high;
    bool lowExcluded = false;         ///< the value must be greater than `low`
    std::vector<std::string> choices; ///< legal words of a choice
    std::string defaultJson;          ///< the default as JSON text
    std::string label;                ///< short, for forms: "Contour thickness"
    std::string help;                 ///< one sentence, for tool tips and --help
    ChangeCost cost = ChangeCost::redraw;
};

/// Every setting of a figure, in document order. Built once from the value types' descriptions.
std::span<const Parameter> parameterTable();

/// The declaration behind a concrete pointer ("/layers/0/contours/thickness_mm"), or null.
const Parameter* findParameter(std::string_view pointer);

} // namespace limner
