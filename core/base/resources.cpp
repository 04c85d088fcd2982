#include "core/base/resources.h"

#include "core/base/error.h"

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

namespace limner {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> candidateFolders() {
    std::vector<fs::path> folders;
    if (const char* named = std::getenv("LIMNER_RESOURCES"); named != nullptr && *named != '\0') {
        // A folder that was asked for by name and is missing must be told, not papered over by another one.
        return {fs::path(named)};
    }
    std::error_code unknown;
    if (const fs::path executable = fs::read_symlink("/proc/self/exe", unknown); !unknown) {
        const fs::path base = executable.parent_path().parent_path();
        folders.push_back(base / "resources");
        folders.push_back(base / "share" / "limner");
    }
#ifdef LIMNER_INSTALL_RESOURCES
    folders.emplace_back(LIMNER_INSTALL_RESOURCES);
#endif
    return folders;
}

fs::path findFolder() {
    std::string looked;
    for (const fs::path& folder : candidateFolders()) {
        std::error_code missing;
        if (fs::is_directory(folder, missing)) {
            return folder;
        }
        looked += (looked.empty() ? "" : ", ") + folder.string();
    }
    throw Error(ErrorKind::badInput, {"cannot find Limner's resources folder", looked, "no such folder",
                                      "set LIMNER_RESOURCES to the folder that holds `styles` and `presets`"});
}

} // namespace

const fs::path& resourcesFolder() {
    static const fs::path folder = findFolder();
    return folder;
}

} // namespace limner
