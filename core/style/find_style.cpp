#include "core/style/find_style.h"

#include "core/style/style_files.h"
#include "core/style/style_library.h"

#include <algorithm>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBundledPrefix = "bundled:";

std::optional<Style> bundledStyle(const std::string& id) {
    const Style* style = findBundledStyle(id);
    return style == nullptr ? std::nullopt : std::optional(*style);
}

} // namespace

std::optional<Style> findStyle(const std::string& word, const StyleLibrary& mine) {
    if (word.starts_with(kBundledPrefix)) {
        return bundledStyle(word.substr(std::string(kBundledPrefix).size()));
    }
    std::error_code unknown;
    const bool inFolder = word.find('/') != std::string::npos;
    if (!inFolder && fs::is_regular_file(mine.folder() / (word + ".png"), unknown)) {
        return mine.load(word);
    }
    const bool isPath = inFolder || fs::path(word).has_extension(); // ids have neither
    if (isPath && fs::is_regular_file(word, unknown)) {
        return loadWholeStyle(word);
    }
    return bundledStyle(word);
}

std::vector<std::string> knownStyleIds(const StyleLibrary& mine) {
    std::vector<std::string> ids;
    for (const StyleCard& card : mine.list().cards) {
        ids.push_back(card.id);
    }
    for (const StyleCard& card : bundledStyleCards()) {
        ids.push_back(card.id);
    }
    return ids;
}

} // namespace limner
