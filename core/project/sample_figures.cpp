#include "core/project/sample_figures.h"

#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/figure/figure_json.h"
#include "core/project/figure_text.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace limner {
namespace {

namespace fs = std::filesystem;

SampleFigure cardOf(const fs::path& file) {
    const Figure figure = readFigure(readFigureText(file), file.string());
    SampleFigure card{file.stem().string(), figure.title, "", "", file};
    card.scan = figure.volume ? figure.volume->path : "";
    card.labels = figure.labels ? figure.labels->path : "";
    return card;
}

std::vector<SampleFigure> loadCards() {
    const fs::path folder = resourcesFolder() / "figures";
    std::vector<SampleFigure> cards;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder, missing)) {
        if (entry.path().extension() == ".json") {
            cards.push_back(cardOf(entry.path()));
        }
    }
    if (cards.empty()) {
        throw Error(ErrorKind::badInput,
                    {"cannot read the sample figures", folder.string(),
                     missing ? missing.message() : "no figure in this folder", "install Limner anew"});
    }
    std::sort(cards.begin(), cards.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    return cards;
}

} // namespace

const std::vector<SampleFigure>& sampleFigures() {
    static const std::vector<SampleFigure> cards = loadCards();
    return cards;
}

const SampleFigure& findSampleFigure(const std::string& id) {
    const auto& cards = sampleFigures();
    const auto found = std::find_if(cards.begin(), cards.end(), [&](const auto& card) { return card.id == id; });
    if (found == cards.end()) {
        throw Error(ErrorKind::usage,
                    {"there is no such sample figure", id, "", "`limner figure list` shows those that are there"});
    }
    return *found;
}

fs::path findSampleScan(const SampleFigure& figure) {
    const char* own = std::getenv("LIMNER_SAMPLES");
    std::string folders = own != nullptr ? own : "";
    folders += ":/usr/share/doc/invesalius-examples/examples";
    for (std::size_t at = 0; at < folders.size();) {
        const std::size_t end = std::min(folders.find(':', at), folders.size());
        const fs::path file = fs::path(folders.substr(at, end - at)) / figure.scan;
        std::error_code missing;
        if (end > at && fs::is_regular_file(file, missing)) {
            return file;
        }
        at = end + 1;
    }
    return {};
}

} // namespace limner
