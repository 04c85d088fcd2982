#pragma once

#include <filesystem>
#include <string>

namespace limner {

/// A folder of the user's for what Limner keeps: the one that the environment's `variable` names, else
/// $XDG_DATA_HOME/limner/NAME, else ~/.local/share/limner/NAME. It need not exist.
std::filesystem::path userFolder(const char* variable, const std::string& name);

} // namespace limner
