#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace limner::cli {

class Console;

/// Facts in the order they are written.
using Facts = nlohmann::ordered_json;

/// One object on standard output. Text that is not UTF-8 is mended, numbers that are not finite are null.
void printFacts(Console& console, const Facts& facts);

/// `label: text`, labels padded to one column.
std::string factLine(const std::string& label, const std::string& text);

/// A number with as many digits as it needs, at most six.
std::string numberText(double value);

} // namespace limner::cli
