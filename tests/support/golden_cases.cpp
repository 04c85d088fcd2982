#include "support/golden_cases.h"

#include "core/figure/figure_json.h"
#include "core/project/project.h"
#include "core/project/sample_figures.h"
#include "core/volume/phantom.h"
#include "support/test_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace limner::testing {

namespace {

namespace fs = std::filesystem;

constexpr int kVoxels = 128;

std::string textOf(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// The figure of a case: its own, or the bundled sample figure of its name.
fs::path figureOf(const fs::path& folder) {
    const fs::path own = folder / "figure.json";
    return fs::exists(own) ? own : findSampleFigure(folder.filename().string()).file;
}

/// Where a scan or label file that a figure names lies; nothing, and a counted word about it, where it is absent.
std::optional<fs::path> scanNamed(const std::string& name) {
    const fs::path sample = fs::path("/usr/share/doc/invesalius-examples/examples") / name; // Debian's sample CT
    return fs::exists(sample) ? sample : testData("volumes/" + name);
}

} // namespace

std::vector<std::string> goldenCases() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(LIMNER_SOURCE_DIR) / "tests/golden")) {
        if (fs::exists(entry.path() / "tolerance.json")) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

fs::path goldenFolder(const std::string& name) { return fs::path(LIMNER_SOURCE_DIR) / "tests/golden" / name; }

std::optional<Figure> loadGolden(const std::string& name) {
    const fs::path folder = goldenFolder(name);
    const fs::path file = figureOf(folder);
    Document document{readFigure(textOf(file), file.string()), {}, {}, {}};
    Figure& figure = document.figure;
    if (figure.volume->path == "builtin:head") {
        static const auto head = makeHeadPhantom(kVoxels);
        figure.volume->data = head;
    } else if (const auto scan = scanNamed(figure.volume->path)) {
        figure.volume->path = scan->string();
    } else {
        return std::nullopt;
    }
    if (figure.labels) {
        const auto labels = scanNamed(figure.labels->path);
        if (!labels) {
            return std::nullopt;
        }
        figure.labels->path = labels->string();
    }
    Task task;
    resolveFigure(document, file.parent_path(), {}, task);
    for (const std::string& note : document.notes) {
        ADD_FAILURE() << note;
    }
    for (const Problem& problem : validateFigure(figure)) {
        EXPECT_FALSE(problem.fatal) << problem.pointer << ": " << problem.why;
    }
    return figure;
}

} // namespace limner::testing
