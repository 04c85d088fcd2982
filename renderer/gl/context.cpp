#include "renderer/gl/context.h"

#include "core/base/error.h"
#include "renderer/gl/functions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace limner::gl {

namespace {

std::string text(const Functions& gl, GLenum what) {
    const auto* found = reinterpret_cast<const char*>(gl.GetString(what));
    return found != nullptr ? found : "";
}

int limit(const Functions& gl, GLenum what) {
    GLint value = 0;
    gl.GetIntegerv(what, &value);
    return value;
}

std::unique_ptr<Context> openAny() {
    std::string why;
    for (const auto& open : {openEgl, openOsmesa}) {
        try {
            return open();
        } catch (const Error& error) {
            why += (why.empty() ? "" : "; ") + error.text().why;
        }
    }
    throw Error(ErrorKind::noOpenGl, {"OpenGL cannot be used", "", why, "render with the backend cpu"});
}

} // namespace

bool isSoftware(const std::string& renderer) {
    std::string name = renderer;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    constexpr std::array kPrograms = {"llvmpipe", "softpipe", "swrast", "software rasterizer", "swiftshader"};
    return std::any_of(kPrograms.begin(), kPrograms.end(),
                       [&](const char* program) { return name.find(program) != std::string::npos; });
}

ContextFacts factsOf(const Context& context, const Functions& gl) {
    ContextFacts facts;
    facts.library = context.library();
    facts.vendor = text(gl, GL_VENDOR);
    facts.renderer = text(gl, GL_RENDERER);
    facts.version = text(gl, GL_VERSION);
    facts.glsl = text(gl, GL_SHADING_LANGUAGE_VERSION);
    facts.largest3d = limit(gl, GL_MAX_3D_TEXTURE_SIZE);
    facts.largest2d = limit(gl, GL_MAX_TEXTURE_SIZE);
    facts.largestTable = limit(gl, GL_MAX_TEXTURE_BUFFER_SIZE);
    facts.textureUnits = limit(gl, GL_MAX_TEXTURE_IMAGE_UNITS);
    GLint points[2] = {};
    gl.GetIntegerv(GL_POINT_SIZE_RANGE, points);
    facts.largestPoint = points[1];
    facts.software = isSoftware(facts.renderer);
    return facts;
}

const std::vector<std::string>& contextLibraries() {
    static const std::vector<std::string> names{"auto", "egl", "osmesa"};
    return names;
}

bool hasGraphicsDevice() {
#ifdef __linux__
    std::error_code none;
    const std::filesystem::directory_iterator dri("/dev/dri", none);
    const bool card = std::any_of(
        begin(dri), end(dri), [](const auto& entry) { return entry.path().filename().string().starts_with("render"); });
    // NVIDIA's own driver, and that of a Linux inside Windows, have devices of other names.
    return card || std::filesystem::exists("/dev/nvidiactl", none) || std::filesystem::exists("/dev/dxg", none);
#else
    return true;
#endif
}

ContextFacts probe(const ContextFactory& contexts) {
    const std::unique_ptr<Context> context = contexts();
    const Functions gl = loadFunctions([&](const char* name) { return context->find(name); });
    const ContextFacts facts = factsOf(*context, gl);
    context->release();
    return facts;
}

const std::vector<std::string>& openLibraries() {
    static const std::vector<std::string> open = [] {
        std::vector<std::string> names;
        for (const std::string& name : contextLibraries()) {
            try {
                if (name != "auto") {
                    probe(contextFactory(name));
                    names.push_back(name);
                }
            } catch (const Error&) {
                // The library is not here or too old: `limner doctor` says so.
            }
        }
        return names;
    }();
    return open;
}

ContextFactory contextFactory(const std::string& library) {
    if (library == "auto") {
        return openAny;
    }
    if (library == "egl") {
        return openEgl;
    }
    if (library == "osmesa") {
        return openOsmesa;
    }
    throw Error(ErrorKind::usage, {"there is no such OpenGL library", library, "", "use auto, egl or osmesa"});
}

} // namespace limner::gl
