#pragma once

#include "core/figure/figure.h"
#include "core/figure/parameters.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limner {

/// A problem of a document, with its place and the mend.
struct Problem {
    std::string pointer; ///< JSON pointer
    std::string why;
    std::string mend;
    bool fatal = true; ///< false: drawn all the same (an unknown key, an unused style)
};

/// Text of figure.json (version 1) from a figure, indented, keys in document order, unknown members put back.
std::string writeFigure(const Figure& figure);

/// Reads figure.json of any version up to 1 (older ones are migrated in memory). Values are checked against the
/// parameter table; unknown keys are kept in `Figure::unknown` and reported as non-fatal problems. Volumes and styles
/// are not loaded. Throws Error(badInput) naming the first fatal problem with its JSON pointer, or for a newer major
/// version.
Figure readFigure(const std::string& text, const std::string& where, std::vector<Problem>* notes = nullptr);

/// `--set`: `pointer=value`, value is JSON or else a string; objects and array elements on the way are made, "-"
/// appends. `null` removes an optional part. Throws Error(usage) naming the pointer, what is legal there and, for an
/// unknown key, the nearest known one.
Figure withSetting(const Figure& figure, const std::string& assignment);

/// Sense check beyond types and ranges: node order, styles that exist, degenerate cameras.
std::vector<Problem> validateFigure(const Figure& figure);

/// Every problem of a document's text, types and ranges included; never throws for a bad document.
std::vector<Problem> validateText(const std::string& text);

/// What going from one figure to the other costs.
ChangeCost diff(const Figure& before, const Figure& after);

} // namespace limner
