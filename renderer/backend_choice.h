#pragma once

#include "renderer/backend.h"

#include <memory>
#include <string>
#include <vector>

namespace limner {

/// Names that `makeBackend` knows, "auto" first.
const std::vector<std::string>& backendNames();

/// `auto` takes the fastest of this machine. Throws Error(noOpenGl) for "gl", which this version has not, and
/// Error(usage) for an unknown name.
std::unique_ptr<Backend> makeBackend(const std::string& name);

} // namespace limner
