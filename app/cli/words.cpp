#include "app/cli/words.h"

#include "core/base/error.h"
#include "core/figure/description.h"

#include <algorithm>

namespace limner::cli {

void checkKnown(const std::vector<std::string>& known, const std::string& word, const std::string& option) {
    if (std::find(known.begin(), known.end(), word) != known.end()) {
        return;
    }
    std::string remedy;
    constexpr std::size_t kFew = 8; // as many are read at a glance
    const std::string nearest = known.size() > kFew ? description::nearestWord(word, known) : "";
    if (!nearest.empty()) {
        remedy = "did you mean " + nearest + "?";
    } else {
        for (const std::string& name : known) {
            remedy += (remedy.empty() ? "use " : ", ") + name;
        }
    }
    throw Error(ErrorKind::usage, {"unknown value", option, "\"" + word.substr(0, 60) + "\"", remedy});
}

} // namespace limner::cli
