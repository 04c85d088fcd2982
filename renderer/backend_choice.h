#pragma once

#include "renderer/backend.h"

#include <memory>
#include <string>
#include <vector>

namespace limner {

/// Names that `makeBackend` knows, "auto" first.
const std::vector<std::string>& backendNames();
/// Names of OpenGL libraries that it knows, "auto" first.
const std::vector<std::string>& glLibraryNames();

/// What draws on this machine, and why.
struct BackendChoice {
    std::string name;   ///< "cpu" or "gl"
    std::string reason; ///< "no graphics device", "NVIDIA H100"
};

/// What `auto` stands for: gl on a graphics card, cpu where OpenGL is drawn by the processor or does not work. Looked
/// up once for a program and a library; thread-safe.
const BackendChoice& automaticBackend(const std::string& glLibrary = "auto");

/// `auto` draws what the card cannot with the processor, and warns. Throws Error(noOpenGl) for "gl" where no context
/// opens, and Error(usage) for an unknown name.
std::unique_ptr<Backend> makeBackend(const std::string& name, const std::string& glLibrary = "auto");

/// What draws with a backend: "AVX2" for cpu, a card's name for gl; may be empty.
std::string backendDetail(const Backend& backend);

} // namespace limner
