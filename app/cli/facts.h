#pragma once

#include <string>
#include <vector>

namespace limner::cli {

class Console;

/// One object on standard output, text as it stands.
void printFactText(Console& console, const std::string& text);

/// The same of a JSON library's object. Text that is not UTF-8 is mended, numbers that are not finite are null.
template <typename Json>
void printFacts(Console& console, const Json& facts) {
    printFactText(console, facts.dump(2, ' ', false, Json::error_handler_t::replace));
}

/// `label: text`, labels padded to one column; an empty label: a line that goes on with the one above.
std::string factLine(const std::string& label, const std::string& text);

/// Rows as lines, columns as wide as their longest text.
std::string textTable(const std::vector<std::vector<std::string>>& rows);

/// A number with as many digits as it needs, at most six.
std::string numberText(double value);

} // namespace limner::cli
