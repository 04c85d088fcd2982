#include "core/base/user_folder.h"

#include <cstdlib>

#include <pwd.h>
#include <unistd.h>

namespace limner {

std::filesystem::path userFolder(const char* variable, const std::string& name) {
    namespace fs = std::filesystem;
    const auto named = [](const char* of) -> fs::path {
        const char* value = std::getenv(of);
        return value != nullptr ? value : "";
    };
    if (const fs::path own = named(variable); !own.empty()) {
        return own;
    }
    // Its standard says that a relative path is to be ignored.
    if (const fs::path data = named("XDG_DATA_HOME"); data.is_absolute()) {
        return data / "limner" / name;
    }
    fs::path home = named("HOME");
    if (home.empty()) {
        const passwd* user = ::getpwuid(::getuid());
        home = user == nullptr ? "." : user->pw_dir;
    }
    return home / ".local" / "share" / "limner" / name;
}

} // namespace limner
