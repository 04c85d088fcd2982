#include "renderer/gl/context.h"

#include "core/base/error.h"
#include "renderer/gl/functions.h"

#include <algorithm>
#include <array>
#include <cctype>

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
    facts.software = isSoftware(facts.renderer);
    return facts;
}

const std::vector<std::string>& contextLibraries() {
    static const std::vector<std::string> names{"auto", "egl", "osmesa"};
    return names;
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
