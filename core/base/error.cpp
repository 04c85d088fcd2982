#include "core/base/error.h"

#include <algorithm>
#include <utility>

namespace limner {

std::string oneLine(const ErrorText& text) {
    std::string line = text.what;
    if (!text.where.empty()) {
        line += ": " + text.where;
    }
    if (!text.why.empty()) {
        line += ": " + text.why;
    }
    if (!text.remedy.empty()) {
        line += "; " + text.remedy;
    }
    // Messages of libraries often carry line breaks; a message of ours is one line.
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return line;
}

Error::Error(ErrorKind kind, ErrorText text) : std::runtime_error(oneLine(text)), kind_(kind), text_(std::move(text)) {}

} // namespace limner
