#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace limner::cli {

/// Throws Error(usage) for a word that is not among the known ones, with the nearest or all of them.
void checkKnown(const std::vector<std::string>& known, const std::string& word, const std::string& option);

/// The entry of a table, by its member `name`. Throws as `checkKnown`.
template <typename Entry, std::size_t kCount>
const Entry& chosen(const Entry (&table)[kCount], const std::string& word, const std::string& option) {
    std::vector<std::string> known;
    for (const Entry& entry : table) {
        if (word == entry.name) {
            return entry;
        }
        known.emplace_back(entry.name);
    }
    checkKnown(known, word, option); // throws
    return table[0];
}

} // namespace limner::cli
