#include "renderer/backend_choice.h"

#include "core/base/error.h"
#include "renderer/gl/gl_backend.h"

namespace limner {

const std::vector<std::string>& backendNames() {
    static const std::vector<std::string> names{"auto", "cpu", "gl", "reference"};
    return names;
}

std::unique_ptr<Backend> makeBackend(const std::string& name) {
    if (name == "auto" || name == "cpu") {
        return makeCpuBackend();
    }
    if (name == "reference") {
        return makeReferenceBackend();
    }
    if (name == "gl") {
        return makeGlBackend(gl::contextFactory("auto"));
    }
    throw Error(ErrorKind::usage, {"there is no such backend", name, "", "use auto, cpu, gl or reference"});
}

} // namespace limner
