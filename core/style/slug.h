#pragma once

#include <functional>
#include <string>

namespace limner {

/// An id from a name in any script: lower-case letters a to z, digits and single hyphens, 1 to 60 bytes, safe as a file
/// name. Letters with marks lose them ("Dürer's ochre" -> "durer-s-ochre"); a name with no such letter gives "style".
std::string slugOf(const std::string& name);

/// The word itself, or with the first number from 2 on for which `taken` is false: "ivory", "ivory-2". `gap` stands
/// before the number.
std::string numbered(const std::string& word, const char* gap, const std::function<bool(const std::string&)>& taken);

/// A name as a card keeps it: one line without control characters or spaces at its ends, at most 200 bytes, whole
/// characters.
std::string tidyName(const std::string& name);

} // namespace limner
